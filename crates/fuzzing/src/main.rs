//! `antipode-fuzzing`: long campaigns, single inputs, and the corpus made anew.

use std::path::Path;
use std::process::ExitCode;

use antipode_fuzzing::attacks::attack;
use antipode_fuzzing::forge::bases;
use antipode_fuzzing::{TARGETS, campaign};

const USAGE: &str = "\
antipode-fuzzing run NAME COUNT [SEED]            a campaign against a target or by an attack; status 1 with a find
antipode-fuzzing input NAME SEED NUMBER FILE      writes one input of a campaign
antipode-fuzzing replay NAME FILE...              tries inputs
antipode-fuzzing corpus DIR                       writes what every target begins with
antipode-fuzzing bases DIR                        writes the stores anew that forging begins with";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match obey(&words) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(sentence) => {
            eprintln!("antipode-fuzzing: {sentence}");
            ExitCode::from(2)
        }
    }
}

fn obey(words: &[&str]) -> Result<bool, String> {
    let named = |name: &str| attack(name).ok_or_else(|| format!("there is no target {name}"));
    let number = |word: &str| {
        word.parse::<u64>()
            .map_err(|_| format!("{word} is not a number"))
    };
    match words {
        ["run", name, count, seed @ ..] if seed.len() <= 1 => {
            let program = std::env::current_exe().map_err(|error| error.to_string())?;
            let seed = seed.first().map_or(Ok(1), |seed| number(seed))?;
            let report = campaign::run(&program, named(name)?, number(count)?, seed)?;
            println!("{name}: {report}");
            Ok(report.finds.is_empty())
        }
        ["child", name, seed, from, to, progress] => {
            campaign::child(
                named(name)?,
                number(seed)?,
                number(from)?..number(to)?,
                Path::new(progress),
            )?;
            Ok(true)
        }
        ["input", name, seed, at, file] => {
            let target = named(name)?;
            let bytes = campaign::input(target, &(target.seeds)(), number(seed)?, number(at)?);
            std::fs::write(file, bytes).map_err(|error| error.to_string())?;
            Ok(true)
        }
        ["replay", name, files @ ..] => {
            let target = named(name)?;
            let mut all = true;
            for file in files {
                let bytes = std::fs::read(file).map_err(|error| error.to_string())?;
                println!("{file}");
                let seen = (target.run)(&bytes);
                println!("  {seen:?}");
                all &= seen.is_ok();
            }
            Ok(all)
        }
        ["corpus", into] => {
            for target in TARGETS {
                let dir = Path::new(into).join(target.name);
                std::fs::create_dir_all(&dir).map_err(|error| error.to_string())?;
                for (name, bytes) in (target.seeds)() {
                    std::fs::write(dir.join(name), bytes).map_err(|error| error.to_string())?;
                }
            }
            Ok(true)
        }
        ["bases", into] => bases::write(Path::new(into))
            .map(|()| true)
            .map_err(|error| error.to_string()),
        _ => Err(format!("these are the commands:\n\n{USAGE}")),
    }
}
