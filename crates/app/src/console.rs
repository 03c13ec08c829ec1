//! Help for the console's commands, and the completion of its lines.

use std::fs;
use std::path::Path;

use antipode_geometry::Geometry;
use antipode_language::Texts;
use antipode_rooms::words::KINDS;
use antipode_scene::Item;
use antipode_settings::{Kind, field, fields};
use antipode_ui::Completion;

use crate::names::key_names;
use crate::script::{Argument, COMMANDS, CommandInfo, ROOM_ACTS, SETTINGS, Spawned, command_named};

/// Longest line that is taken over from a file, in characters.
const LONGEST_ENTRY: usize = 400;

/// The command that tells of the others; a script has no use for it.
pub const HELP: CommandInfo = CommandInfo {
    name: "help",
    usage: "[COMMAND]",
    arguments: &[Argument::Command],
};

/// What there is to say of one command, or of all; a sentence where there is no such command.
///
/// # Errors
/// The sentence.
pub fn help(texts: &Texts, name: Option<&str>) -> Result<String, String> {
    let Some(name) = name else {
        let names = COMMANDS.iter().map(|command| command.name);
        let names: Vec<_> = names.chain([HELP.name]).collect();
        let values = [("commands", names.join(" ").into())];
        return Ok(texts.say_with("console-help", &values));
    };
    let found = command_named(name).or_else(|| (name == HELP.name).then_some(&HELP));
    let Some(command) = found else {
        let values = [("name", crate::text::shortened(name, 60).into())];
        return Err(texts.say_with("console-no-command", &values));
    };
    let about = texts.say(&format!("console-help-{}", command.name));
    let mut lines = vec![
        format!("{} {}", command.name, command.usage)
            .trim()
            .to_owned(),
        about,
    ];
    let words = words_of(command);
    if !words.is_empty() {
        lines.push(words.join("  "));
    }
    Ok(lines.join("\n"))
}

/// What was entered in earlier runs, the oldest first; nothing where there is no such file. What is no text, or too
/// long for a line, is left out.
pub fn read_history(file: &Path) -> Vec<String> {
    let Ok(bytes) = fs::read(file) else {
        return Vec::new();
    };
    let text = String::from_utf8_lossy(&bytes);
    let fits = |line: &&str| !line.trim().is_empty() && line.chars().count() <= LONGEST_ENTRY;
    text.lines().filter(fits).map(str::to_owned).collect()
}

/// Keeps what was entered for later runs.
pub fn write_history(file: &Path, entries: &[String]) {
    let mut text = entries.join("\n");
    text.push('\n');
    let made = file.parent().map_or(Ok(()), fs::create_dir_all);
    if let Err(error) = made.and_then(|()| fs::write(file, text)) {
        tracing::info!("the console's history was not kept: {error}");
    }
}

/// The words that a command's first argument is chosen from, where they are few enough to be told.
fn words_of(command: &CommandInfo) -> Vec<String> {
    match command.arguments.first() {
        Some(Argument::Key | Argument::KeyOrButton | Argument::World | Argument::Command)
        | None => Vec::new(),
        Some(argument) => choices(*argument, &[], &[]),
    }
}

/// How a line goes on; `worlds` are the names of those that are saved.
pub fn complete(line: &str, worlds: &[String]) -> Completion {
    let typed = split(line);
    let Some((last, before)) = typed.split_last() else {
        return Completion::default();
    };
    let choices = next_words(before, worlds);
    let fits = |choice: &String| starts_with(choice, last);
    let found: Vec<String> = choices.into_iter().filter(fits).collect();
    let begin = &line[..line.len() - last.len()];
    let (word, ended) = match found.as_slice() {
        [] => (last.clone(), false),
        [only] => (quoted(only), !only.ends_with('=')),
        several => (common(several, last), false),
    };
    let line = format!("{begin}{word}{}", if ended { " " } else { "" });
    let options = if found.len() > 1 { found } else { Vec::new() };
    Completion { line, options }
}

/// The words of a line as they are typed; the last may be empty. Within quotes blanks are letters.
fn split(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quotes = false;
    for letter in line.chars() {
        quotes ^= letter == '"';
        if letter.is_whitespace() && !quotes {
            if words.last().is_some_and(|word| !word.is_empty()) {
                words.push(String::new());
            }
        } else if let Some(word) = words.last_mut() {
            word.push(letter);
        }
    }
    words
}

/// What may follow the words that stand there already.
fn next_words(before: &[String], worlds: &[String]) -> Vec<String> {
    let Some((name, arguments)) = before.split_first() else {
        let names = COMMANDS.iter().map(|command| command.name);
        return names.chain([HELP.name]).map(str::to_owned).collect();
    };
    let found = command_named(name).or_else(|| (name == HELP.name).then_some(&HELP));
    let Some(command) = found else {
        return Vec::new();
    };
    let kinds = command.arguments;
    let several = kinds.last() == Some(&Argument::Option);
    let kind = match kinds.get(arguments.len()) {
        Some(kind) => *kind,
        None if several => Argument::Option,
        None => return Vec::new(),
    };
    choices(kind, arguments, worlds)
}

fn choices(kind: Argument, before: &[String], worlds: &[String]) -> Vec<String> {
    let own = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
    match kind {
        Argument::Geometry => Geometry::ALL.iter().map(ToString::to_string).collect(),
        Argument::Option => own(&["seed=", "name=", "radius=", "generator=", "mode="]),
        Argument::World => worlds.to_vec(),
        Argument::Key => key_names(),
        Argument::KeyOrButton => [own(&["LEFT", "RIGHT"]), key_names()].concat(),
        Argument::Button => own(&["LEFT", "RIGHT"]),
        Argument::Setting => setting_names(),
        Argument::Value => before
            .first()
            .map_or_else(Vec::new, |name| own(words_for(name))),
        Argument::Item => Item::ALL.iter().map(|item| item.id().to_owned()).collect(),
        Argument::Spawned => Spawned::words().map(str::to_owned).collect(),
        Argument::ChartId => own(&["A", "B"]),
        Argument::RoomAct => own(&ROOM_ACTS),
        Argument::RoomKind => own(&KINDS),
        Argument::Free => Vec::new(),
        Argument::Command => next_words(&[], worlds),
    }
}

/// What `set` can change: of the world, and of the player's own settings.
fn setting_names() -> Vec<String> {
    let of_world = SETTINGS.iter().map(|(name, _)| *name);
    let is_new = |id: &&str| SETTINGS.iter().all(|(name, _)| name != id);
    let own = fields().iter().map(|field| field.id).filter(is_new);
    of_world.chain(own).map(str::to_owned).collect()
}

/// The words that a setting takes; none where it takes a number.
fn words_for(name: &str) -> &'static [&'static str] {
    if let Some((_, words)) = SETTINGS.iter().find(|(known, _)| *known == name) {
        return words;
    }
    match field(name).map(|field| field.kind) {
        Some(Kind::Toggle) => &["on", "off"],
        Some(Kind::Choice { options }) => options,
        _ => &[],
    }
}

/// Whether a word can become the choice; capitals do not matter, nor a quotation mark that is not closed yet.
fn starts_with(choice: &str, typed: &str) -> bool {
    let typed = typed.trim_matches('"').to_lowercase();
    choice.to_lowercase().starts_with(&typed)
}

/// A word as it must be typed.
fn quoted(word: &str) -> String {
    if word.contains(char::is_whitespace) {
        format!("\"{word}\"")
    } else {
        word.to_owned()
    }
}

/// How far all choices agree; what was typed where that is less.
fn common(choices: &[String], typed: &str) -> String {
    let Some((first, rest)) = choices.split_first() else {
        return typed.to_owned();
    };
    let agree = |letters: usize| {
        let head = |word: &str| word.chars().take(letters).collect::<String>();
        rest.iter().all(|other| head(other) == head(first))
    };
    let letters = (0..=first.chars().count())
        .rev()
        .find(|letters| agree(*letters));
    let word: String = first.chars().take(letters.unwrap_or(0)).collect();
    if word.chars().count() < typed.trim_matches('"').chars().count() {
        return typed.to_owned();
    }
    if word.contains(char::is_whitespace) || typed.starts_with('"') {
        format!("\"{word}")
    } else {
        word
    }
}

#[cfg(test)]
mod tests {
    use antipode_language::Language;

    use super::*;

    fn completed(line: &str) -> String {
        let worlds = ["My world", "My home", "Foo"].map(str::to_owned);
        complete(line, &worlds).line
    }

    #[test]
    fn a_certain_word_is_finished_and_an_uncertain_one_as_far_as_it_goes() {
        for (typed, line) in [
            ("tele", "teleport "),
            ("give pickaxe-i", "give pickaxe-iron "),
            ("give p", "give pickaxe-"),
            ("new H", "new hyperbolic"),
            ("new hyperbolic-", "new hyperbolic-world "),
            ("new spherical r", "new spherical radius="),
            (
                "new spherical radius=20 se",
                "new spherical radius=20 seed=",
            ),
            ("hold keyw", "hold KeyW "),
            ("hold LE", "hold LEFT "),
            ("tap Shift", "tap Shift"),
            ("set map h", "set map horizon "),
            ("set q", "set quality "),
            ("set quality ", "set quality "),
            ("teleport 1 2 3 b", "teleport 1 2 3 B "),
            ("load f", "load Foo "),
            ("load my", "load \"My "),
            ("load \"My h", "load \"My home\" "),
            ("help sc", "help scroll "),
            ("he", "help "),
            ("jump", "jump"),
            ("jump o", "jump o"),
            ("wait ", "wait "),
        ] {
            assert_eq!(completed(typed), line, "{typed}");
        }
    }

    #[test]
    fn what_was_entered_is_kept_for_later_runs_and_a_damaged_file_does_no_harm() {
        let file = std::env::temp_dir().join(format!("antipode-history-{}", std::process::id()));
        assert!(read_history(&file).is_empty());
        let entries = ["set time 3", "load \"My world\""].map(str::to_owned);
        write_history(&file, &entries);
        assert_eq!(read_history(&file), entries);
        assert!(fs::write(&file, b"one\n\xff\xfe\n\n\ntwo").is_ok());
        let read = read_history(&file);
        assert_eq!(
            (read.len(), read[0].as_str(), read[2].as_str()),
            (3, "one", "two")
        );
        let _ = fs::remove_file(&file);
    }

    #[test]
    fn several_ways_on_are_shown() {
        let completion = complete("s", &[]);
        assert_eq!(completion.line, "s");
        for name in ["save", "set", "settle", "shot"] {
            assert!(
                completion.options.iter().any(|option| option == name),
                "{name}"
            );
        }
        assert!(complete("teleport 1 ", &[]).options.is_empty());
    }

    #[test]
    fn every_command_has_its_help_in_every_language() {
        for language in Language::ALL {
            let texts = Texts::new(language);
            let all = help(&texts, None).unwrap_or_default();
            for command in COMMANDS.iter().chain([&HELP]) {
                assert!(all.contains(command.name));
                let about = help(&texts, Some(command.name)).unwrap_or_default();
                assert!(
                    about.starts_with(command.name) && about.lines().count() >= 2,
                    "{about}"
                );
                assert!(texts.has_own(&format!("console-help-{}", command.name)));
            }
        }
        let texts = Texts::default();
        let refused = help(&texts, Some("jump")).err().unwrap_or_default();
        assert!(
            refused.contains("jump") && refused.ends_with('.'),
            "{refused}"
        );
        assert!(help(&texts, Some("set")).is_ok_and(|said| said.contains("view-distance")));
    }
}
