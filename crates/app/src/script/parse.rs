//! From the text of a script to orders, all checked before the first one runs.

use antipode_geometry::{Geometry, Hemisphere};
use antipode_scene::Item;
use antipode_storage::SavesDir;
use thiserror::Error;
use winit::keyboard::KeyCode;

use crate::bindings::Input;
use crate::cli::shortened;
use crate::names::key_named;
use crate::session::NewWorld;

/// Longest time an order may take, in simulated seconds.
const LONGEST_S: f64 = 86_400.0;
/// Farthest coordinate a script may name, in metres.
const FARTHEST_M: f64 = 1e8;
/// Most characters of the script's own words that a message repeats.
const LONGEST_ECHO: usize = 60;

/// One order and the line it stands on, counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Number of the line.
    pub number: usize,
    /// What to do.
    pub order: Order,
}

/// Something a script can ask for.
#[derive(Clone, Debug, PartialEq)]
pub enum Order {
    /// Make a world and enter it.
    New(NewWorld),
    /// Enter a saved world.
    Load(String),
    /// Commit the open world.
    Save,
    /// Delete a saved world.
    Delete(String),
    /// Print the saved worlds.
    List,
    /// End the script.
    Quit,
    /// Hold an input for some seconds.
    Hold(Input, f64),
    /// Press an input, or let it go.
    Press(Input, bool),
    /// Press and let go within a step.
    Tap(Input),
    /// Mouse motion in pixels.
    Look(f64, f64),
    /// Point the view, in degrees.
    Aim(f64, f64),
    /// Turn the wheel.
    Scroll(f64),
    /// Let time pass, in seconds.
    Wait(f64),
    /// Wait until no chunk work is pending, at most this many seconds.
    Settle(f64),
    /// Print the state.
    Probe,
    /// Take a picture.
    Shot(String),
    /// Change a setting.
    Set(Setting),
    /// Put items into the hotbar.
    Give(Item, u32),
    /// Move the player's feet.
    Teleport([f64; 3], Hemisphere),
    /// Measure over some seconds.
    Perf(f64),
}

/// Something `set` can change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// Time of day in seconds.
    Time(f64),
    /// The curvature dial.
    Curvature(f64),
    /// View distance in chunks.
    ViewDistance(u32),
    /// The player's health.
    Health(f64),
    /// Spectator's flight.
    Fly(bool),
}

/// A mistake in a script.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("line {line}: {what}")]
pub struct Mistake {
    /// The line it stands on, counted from 1.
    pub line: usize,
    /// What is wrong, in words.
    pub what: String,
}

/// Reads a whole script.
///
/// # Errors
/// The first mistake, with its line.
pub fn parse(text: &str) -> Result<Vec<Line>, Mistake> {
    let mut lines = Vec::new();
    // Some editors begin a file with a byte order mark.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    for (number, line) in (1..).zip(text.lines()) {
        let read = words(line).and_then(|words| order(&words));
        match read {
            Ok(Some(order)) => lines.push(Line { number, order }),
            Ok(None) => {}
            Err(what) => return Err(Mistake { line: number, what }),
        }
    }
    Ok(lines)
}

/// Splits a line into words; quotes hold a word together, `#` outside them begins a comment.
fn words(line: &str) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    let mut word: Option<String> = None;
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => {
                quoted = !quoted;
                word.get_or_insert_default();
            }
            '#' if !quoted => break,
            c if c.is_whitespace() && !quoted => found.extend(word.take()),
            c => word.get_or_insert_default().push(c),
        }
    }
    if quoted {
        return Err("a quotation mark is never closed".to_owned());
    }
    found.extend(word);
    Ok(found)
}

fn order(words: &[String]) -> Result<Option<Order>, String> {
    let Some((name, rest)) = words.split_first() else {
        return Ok(None);
    };
    let args: Vec<&str> = rest.iter().map(String::as_str).collect();
    let order = match (name.as_str(), args.as_slice()) {
        ("new", [geometry, options @ ..]) => Order::New(new_world(geometry, options)?),
        ("load", [world]) => Order::Load(saved_name(world)?),
        ("save", []) => Order::Save,
        ("delete", [world]) => Order::Delete(saved_name(world)?),
        ("list", []) => Order::List,
        ("quit", []) => Order::Quit,
        ("hold", [key, time]) => Order::Hold(input(key)?, seconds(time)?),
        ("down", [key]) => Order::Press(Input::Key(code(key)?), true),
        ("up", [key]) => Order::Press(Input::Key(code(key)?), false),
        ("tap", [key]) => Order::Tap(Input::Key(code(key)?)),
        ("click", [side]) => Order::Tap(button(side)?),
        ("press", [side]) => Order::Press(button(side)?, true),
        ("release", [side]) => Order::Press(button(side)?, false),
        ("look", [dx, dy]) => Order::Look(number(dx, -1e5, 1e5)?, number(dy, -1e5, 1e5)?),
        ("aim", [yaw, pitch]) => {
            Order::Aim(number(yaw, -3600.0, 3600.0)?, number(pitch, -90.0, 90.0)?)
        }
        ("scroll", [notches]) => Order::Scroll(number(notches, -1000.0, 1000.0)?),
        ("wait", [time]) => Order::Wait(seconds(time)?),
        ("settle", []) => Order::Settle(60.0),
        ("settle", [time]) => Order::Settle(seconds(time)?),
        ("probe", []) => Order::Probe,
        ("shot", [file]) => Order::Shot(picture(file)?),
        ("set", [what, value]) => Order::Set(setting(what, value)?),
        ("give", [item, count]) => give(item, count)?,
        ("teleport", [x, y, z, side @ ..]) if side.len() <= 1 => teleport([x, y, z], side)?,
        ("perf", [time]) => Order::Perf(number(time, 1.0 / 60.0, 600.0)?),
        (known, _) if KNOWN.contains(&known) => {
            return Err(format!(
                "\"{known}\" has too few, too many or unknown arguments"
            ));
        }
        (unknown, _) => return Err(format!("there is no command {}", quoted(unknown))),
    };
    Ok(Some(order))
}

/// Every command, to tell a wrong argument from a wrong command.
const KNOWN: [&str; 24] = [
    "new", "load", "save", "delete", "list", "quit", "hold", "down", "up", "tap", "click", "press",
    "release", "look", "aim", "scroll", "wait", "settle", "probe", "shot", "set", "give",
    "teleport", "perf",
];

fn new_world(geometry: &str, options: &[&str]) -> Result<NewWorld, String> {
    let geometry = geometry
        .parse::<Geometry>()
        .map_err(|_| format!("there is no space {}", quoted(geometry)))?;
    let mut wanted = NewWorld {
        geometry,
        name: None,
        seed: None,
        radius_m: None,
    };
    for option in options {
        match option.split_once('=') {
            Some(("seed", value)) => {
                wanted.seed = Some(
                    value
                        .parse()
                        .map_err(|_| format!("{} is not a seed", quoted(value)))?,
                );
            }
            Some(("name", value)) => wanted.name = Some(new_name(value)?),
            Some(("radius", value)) => wanted.radius_m = Some(number(value, 0.0, 1e6)?),
            _ => {
                return Err(format!(
                    "{} is none of seed=, name=, radius=",
                    quoted(option)
                ));
            }
        }
    }
    Ok(wanted)
}

/// A name a new world may bear; whether it is taken is seen when the world is made.
fn new_name(name: &str) -> Result<String, String> {
    match SavesDir::check_name_among(name, []) {
        Ok(()) => Ok(name.to_owned()),
        Err(error) => Err(format!("name={} will not do: {error}", quoted(name))),
    }
}

/// The name or directory of a saved world; the longest that a file system has is well below the limit.
fn saved_name(name: &str) -> Result<String, String> {
    if name.len() > 1000 {
        return Err(format!("no world is called {}", quoted(name)));
    }
    Ok(name.to_owned())
}

/// A word of the script for a message, cut where it is long.
fn quoted(word: &str) -> String {
    format!("\"{}\"", shortened(word, LONGEST_ECHO))
}

fn number(text: &str, least: f64, most: f64) -> Result<f64, String> {
    let value: f64 = text
        .parse()
        .map_err(|_| format!("{} is not a number", quoted(text)))?;
    if (least..=most).contains(&value) {
        Ok(value)
    } else {
        Err(format!(
            "{} is out of range ({least} to {most})",
            shortened(text, LONGEST_ECHO)
        ))
    }
}

fn whole(text: &str, least: u32, most: u32) -> Result<u32, String> {
    let value: u32 = text
        .parse()
        .map_err(|_| format!("{} is not a whole number", quoted(text)))?;
    if (least..=most).contains(&value) {
        Ok(value)
    } else {
        Err(format!(
            "{} is out of range ({least} to {most})",
            shortened(text, LONGEST_ECHO)
        ))
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    number(text, 0.0, LONGEST_S)
}

fn code(name: &str) -> Result<KeyCode, String> {
    key_named(name).ok_or_else(|| {
        format!(
            "there is no key {}; keys are named like KeyW, Space, ShiftLeft, Digit3",
            quoted(name)
        )
    })
}

fn button(side: &str) -> Result<Input, String> {
    match side {
        "LEFT" => Ok(Input::MouseLeft),
        "RIGHT" => Ok(Input::MouseRight),
        _ => Err(format!("{} is neither LEFT nor RIGHT", quoted(side))),
    }
}

fn input(name: &str) -> Result<Input, String> {
    button(name).or_else(|_| code(name).map(Input::Key))
}

fn picture(file: &str) -> Result<String, String> {
    let png = std::path::Path::new(file)
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("png"));
    if png {
        Ok(file.to_owned())
    } else {
        Err(format!("{} is not a .png file", quoted(file)))
    }
}

fn setting(what: &str, value: &str) -> Result<Setting, String> {
    Ok(match what {
        "time" => Setting::Time(number(value, 0.0, 600.0)?),
        "curvature" => Setting::Curvature(number(value, 0.0, 20.0)?),
        "view-distance" => Setting::ViewDistance(whole(value, 1, 16)?),
        "health" => Setting::Health(number(value, 0.0, 20.0)?),
        "fly" => match value {
            "on" => Setting::Fly(true),
            "off" => Setting::Fly(false),
            _ => return Err(format!("{} is neither on nor off", quoted(value))),
        },
        _ => return Err(format!("there is no setting {}", quoted(what))),
    })
}

fn give(item: &str, count: &str) -> Result<Order, String> {
    let kind = Item::from_id(item).ok_or_else(|| format!("there is no item {}", quoted(item)))?;
    Ok(Order::Give(kind, whole(count, 1, 9999)?))
}

fn teleport(place: [&str; 3], side: &[&str]) -> Result<Order, String> {
    let hemisphere = match side {
        [] | ["A"] => Hemisphere::A,
        ["B"] => Hemisphere::B,
        _ => return Err("a hemisphere is A or B".to_owned()),
    };
    let [x, y, z] = place.map(|text| number(text, -FARTHEST_M, FARTHEST_M));
    Ok(Order::Teleport([x?, y?, z?], hemisphere))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(line: &str) -> Result<Order, Mistake> {
        parse(line).map(|mut lines| lines.remove(0).order)
    }

    #[test]
    fn comments_blank_lines_and_quotes_are_read() {
        let lines =
            parse("# a comment\n\n  new hyperbolic seed=7 name=\"My # world\" # trailing\nprobe")
                .unwrap_or_default();
        assert_eq!(lines.len(), 2);
        assert_eq!(lines[0].number, 3);
        let Order::New(world) = &lines[0].order else {
            unreachable!("a new world was asked for")
        };
        assert_eq!(
            (world.name.as_deref(), world.seed),
            (Some("My # world"), Some(7))
        );
    }

    #[test]
    fn mistakes_name_their_line() {
        for (text, line) in [
            ("jump", 1),
            ("probe\nwait -1", 2),
            ("wait NaN", 1),
            ("wait inf", 1),
            ("hold KeyÄ 1", 1),
            ("hold KeyW", 1),
            ("new toroidal", 1),
            ("new euclidean colour=red", 1),
            ("new euclidean seed=-1", 1),
            ("new euclidean name=\"\"", 1),
            ("new euclidean name=\" \"", 1),
            ("set curvature 21", 1),
            ("set gravity 1", 1),
            ("teleport 0 0 NaN", 1),
            ("teleport 0 0 0 C", 1),
            ("shot picture.jpg", 1),
            ("give gold 1", 1),
            ("give pickaxe-iron 0", 1),
            ("click MIDDLE", 1),
            ("load \"open", 1),
            ("perf 0", 1),
            ("probe now", 1),
        ] {
            let mistake = parse(text).err();
            assert_eq!(mistake.map(|m| m.line), Some(line), "{text} passed");
        }
    }

    #[test]
    fn a_byte_order_mark_is_skipped_and_long_words_are_cut() {
        assert_eq!(one("\u{feff}probe"), Ok(Order::Probe));
        let long = "x".repeat(100_000);
        for line in [
            long.clone(),
            format!("load {long}"),
            format!("wait {long}"),
            format!("new euclidean name={long}"),
        ] {
            let said = parse(&line).err().map(|mistake| mistake.to_string());
            assert!(
                said.is_some_and(|words| words.len() < 200),
                "{}",
                &line[..20]
            );
        }
    }

    #[test]
    fn orders_carry_their_numbers() {
        assert_eq!(
            one("hold KeyW 1.5"),
            Ok(Order::Hold(Input::Key(KeyCode::KeyW), 1.5))
        );
        assert_eq!(one("hold LEFT 2"), Ok(Order::Hold(Input::MouseLeft, 2.0)));
        assert_eq!(one("aim -90 10.5"), Ok(Order::Aim(-90.0, 10.5)));
        assert_eq!(
            one("teleport 1 2 3 B"),
            Ok(Order::Teleport([1.0, 2.0, 3.0], Hemisphere::B))
        );
        assert_eq!(one("set fly on"), Ok(Order::Set(Setting::Fly(true))));
        assert_eq!(one("settle"), Ok(Order::Settle(60.0)));
    }

    #[test]
    fn no_text_makes_the_reader_panic() {
        for text in [
            "\"",
            "#",
            "\u{0}\u{0}",
            "new =",
            "new euclidean =",
            "set set set set",
            "🦀 🦀",
            "hold \"\" \"\"",
        ] {
            let _ = parse(text);
        }
    }
}
