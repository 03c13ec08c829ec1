//! The table of commands, for scripts and console alike: what each is called and which words follow it. Help and
//! completion go by it.

/// What a word after a command can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// A space: `euclidean`, `hyperbolic`, `spherical`, `hyperbolic-world`.
    Geometry,
    /// `seed=`, `name=`, `radius=`, `generator=` or `mode=`.
    Option,
    /// The name of a saved world.
    World,
    /// A key by its name.
    Key,
    /// A key, or a button of the mouse.
    KeyOrButton,
    /// `LEFT` or `RIGHT`.
    Button,
    /// A setting of a world.
    Setting,
    /// What that setting takes.
    Value,
    /// An item by its id.
    Item,
    /// What can be put into the world: `bot`, `hostile`, `car`, `lamp`, `flag` or `door`.
    Spawned,
    /// `A` or `B`.
    ChartId,
    /// `new`, `load`, `save`, `delete` or `list`.
    RoomAct,
    /// What can be put into a room.
    RoomKind,
    /// A number, a file: nothing that could be guessed.
    Free,
    /// Another command.
    Command,
}

/// One command.
#[derive(Clone, Copy, Debug)]
pub struct CommandInfo {
    /// What it is called.
    pub name: &'static str,
    /// How it is written, without its name.
    pub usage: &'static str,
    /// What its words are, in order; the last stands for all that follow.
    pub arguments: &'static [Argument],
}

/// Settings that `set` knows, each with the words it takes; none where it takes a number.
pub const SETTINGS: [(&str, &[&str]); 11] = [
    ("time", &[]),
    ("curvature", &[]),
    ("map", &["raised", "horizon"]),
    ("bend", &[]),
    ("quality", &["fast", "balanced", "exact"]),
    ("view-distance", &[]),
    ("health", &[]),
    ("fly", &["on", "off"]),
    ("npcs", &["on", "off", "still"]),
    ("brush", &["ball", "box", "cylinder", "flatten", "smooth"]),
    (
        "ground",
        &[
            "found", "grass", "soil", "sand", "gravel", "rock", "ash", "snow", "moss", "clay",
            "basalt", "slate", "coal", "copper", "crystal",
        ],
    ),
];

const fn command(
    name: &'static str,
    usage: &'static str,
    arguments: &'static [Argument],
) -> CommandInfo {
    CommandInfo {
        name,
        usage,
        arguments,
    }
}

/// Every command.
pub static COMMANDS: [CommandInfo; 38] = {
    use Argument::{
        Button, ChartId, Free, Geometry, Item, Key, KeyOrButton, Option, RoomAct, RoomKind,
        Setting, Spawned, Value, World,
    };
    [
        command(
            "new",
            "GEOMETRY [seed=N] [name=NAME] [radius=M] [generator=N] [mode=creative|gathering]",
            &[Geometry, Option],
        ),
        command("load", "NAME", &[World]),
        command("save", "", &[]),
        command("delete", "NAME", &[World]),
        command("list", "", &[]),
        command("quit", "", &[]),
        command("hold", "KEY SECONDS", &[KeyOrButton, Free]),
        command("down", "KEY", &[Key]),
        command("up", "KEY", &[Key]),
        command("tap", "KEY", &[Key]),
        command("click", "LEFT|RIGHT", &[Button]),
        command("press", "LEFT|RIGHT", &[Button]),
        command("release", "LEFT|RIGHT", &[Button]),
        command("look", "DX DY", &[Free]),
        command("aim", "YAW PITCH", &[Free]),
        command("scroll", "NOTCHES", &[Free]),
        command("wait", "SECONDS", &[Free]),
        command("settle", "[MAX_SECONDS]", &[Free]),
        command("probe", "", &[]),
        command("shot", "FILE.png", &[Free]),
        command("set", "SETTING VALUE", &[Setting, Value]),
        command("give", "ITEM|GROUND N", &[Item, Free]),
        command("make", "ITEM", &[Item]),
        command("teleport", "X Y Z [A|B]", &[Free, Free, Free, ChartId]),
        command(
            "spawn",
            "bot|hostile|car|lamp|flag|door X Y Z [A|B]",
            &[Spawned, Free, Free, Free, ChartId],
        ),
        command("name-flag", "NAME", &[Free]),
        command("perf", "SECONDS", &[Free]),
        command(
            "room",
            "new|load|save|delete|list|versions|older|set [name=NAME] [gravity=X,Y,Z] [KEY=VALUE ...]",
            &[RoomAct, Free],
        ),
        command("add", "KIND name=NAME KEY=VALUE ...", &[RoomKind, Free]),
        command("change", "NAME KEY=VALUE ...", &[Free]),
        command("remove", "NAME ...", &[Free]),
        command("group", "NAME MEMBER ... [at=X,Y,Z]", &[Free]),
        command("carry", "GROUP|none MEMBER ...", &[Free]),
        command("ungroup", "NAME ...", &[Free]),
        command("duplicate", "NAME ... [by=X,Y,Z]", &[Free]),
        command(
            "array",
            "NAME ... count=N [step=X,Y,Z] [turn=YAW] [about=X,Y,Z]",
            &[Free],
        ),
        command("undo", "[N]", &[Free]),
        command("redo", "[N]", &[Free]),
    ]
};

/// The command of that name.
pub fn command_named(name: &str) -> Option<&'static CommandInfo> {
    COMMANDS.iter().find(|command| command.name == name)
}

#[cfg(test)]
mod tests {
    use super::super::parse::parse;
    use super::*;

    #[test]
    fn every_command_of_the_table_is_one_and_says_whether_it_needs_words() {
        for command in &COMMANDS {
            let needs = !command.usage.is_empty() && !command.usage.starts_with('[');
            let mistake = parse(command.name).err().map(|mistake| mistake.what);
            match mistake {
                None => assert!(!needs, "{} stands alone", command.name),
                Some(what) => assert!(needs && what.contains("few"), "{what}"),
            }
        }
        assert!(command_named("jump").is_none());
    }

    #[test]
    fn every_setting_of_the_table_takes_its_words() {
        for (setting, words) in SETTINGS {
            let number: &[&str] = &["1"];
            let taken = if words.is_empty() { number } else { words };
            for word in taken {
                assert!(
                    parse(&format!("set {setting} {word}")).is_ok(),
                    "{setting} {word}"
                );
            }
        }
    }

    #[test]
    fn the_readme_says_which_words_the_buttons_take_and_how_exported_worlds_end() {
        let readme = include_str!("../../../../README.md");
        for command in COMMANDS
            .iter()
            .filter(|command| command.arguments == [Argument::Button])
        {
            let row = format!("`{} {}`", command.name, command.usage.replace('|', "\\|"));
            assert!(readme.contains(&row), "{row}");
        }
        let examples = readme.lines().filter(|line| {
            line.starts_with("antipode saves export ") || line.starts_with("antipode saves import ")
        });
        let examples: Vec<_> = examples.collect();
        assert_eq!(examples.len(), 2);
        for example in examples {
            let ending = format!(".{}", antipode_storage::ARCHIVE_EXTENSION);
            assert!(example.ends_with(&ending), "{example}");
        }
    }
}
