//! Parses a script into orders. All of them are checked before the first one runs.

use std::fmt::Display;
use std::str::FromStr;

use antipode_geometry::{ChartId, Geometry};
use antipode_scene::{Generator, Item, Kind, Mode, NpcMode};
use antipode_storage::SavesDir;
use thiserror::Error;

pub use room::{ROOM_ACTS, RoomOrder};
pub use setting::Setting;

use super::commands::command_named;
use crate::bindings::{Input, MouseButton};
use crate::names::key_named;
use crate::session::{Beginning, NewWorld};
use crate::text::shortened;
use setting::setting;

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
    /// Give cubic metres of a kind of ground, in a world where it is gathered.
    GiveGround(Kind, f64),
    /// Make an item of ground.
    Make(Item),
    /// Give the flag nearest to the player a name.
    NameFlag(String),
    /// Move the player's feet.
    Teleport([f64; 3], ChartId),
    /// Put something into the world.
    Spawn(Spawned, [f64; 3], ChartId),
    /// Measure over some seconds.
    Perf(f64),
    /// Do something with rooms.
    Room(RoomOrder),
    /// Change the open room: the words of the command, its name first.
    Edit(Vec<String>),
}

/// Something `spawn` can put into the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spawned {
    /// A figure that does no harm.
    Bot,
    /// A figure that fights the player.
    Hostile,
    /// A car.
    Car,
    /// What can be put down.
    Standing(Item),
}

impl Spawned {
    /// Those that are no items, by the words for them.
    const OTHERS: [(&str, Self); 3] = [
        ("bot", Self::Bot),
        ("hostile", Self::Hostile),
        ("car", Self::Car),
    ];

    /// Every word for one.
    pub fn words() -> impl Iterator<Item = &'static str> {
        let others = Self::OTHERS.map(|(word, _)| word);
        let standing = Item::ALL.into_iter().filter(|item| item.stands().is_some());
        others.into_iter().chain(standing.map(Item::id))
    }

    /// What a word means, if anything.
    fn named(word: &str) -> Option<Self> {
        let mut others = Self::OTHERS.into_iter();
        let other = others.find_map(|(known, it)| (known == word).then_some(it));
        let item = || Item::from_id(word).filter(|item| item.stands().is_some());
        other.or_else(|| item().map(Self::Standing))
    }
}

impl Order {
    /// Whether a world in which it was used is marked: it gives the player what play would not have given.
    pub fn cheats(&self) -> bool {
        match self {
            Self::Give(..) | Self::GiveGround(..) | Self::Teleport(..) | Self::Spawn(..) => true,
            Self::Set(setting) => match setting {
                Setting::Time(_) | Setting::Health(_) => true,
                Setting::Fly(on) => *on,
                Setting::Curvature(_)
                | Setting::Map(_)
                | Setting::Bend(_)
                | Setting::Quality(_)
                | Setting::ViewDistance(_)
                | Setting::Brush(_)
                | Setting::Ground(_)
                | Setting::Own(..) => false,
                // A script that sends them away has it easier.
                Setting::Npcs(mode) => *mode != NpcMode::On,
            },
            Self::New(_)
            | Self::Load(_)
            | Self::Save
            | Self::Delete(_)
            | Self::List
            | Self::Quit
            | Self::Hold(..)
            | Self::Press(..)
            | Self::Tap(_)
            | Self::Look(..)
            | Self::Aim(..)
            | Self::Scroll(_)
            | Self::Wait(_)
            | Self::Settle(_)
            | Self::Probe
            | Self::Make(_)
            | Self::Shot(_)
            | Self::NameFlag(_)
            | Self::Perf(_)
            | Self::Room(_)
            | Self::Edit(_) => false,
        }
    }
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
        match parse_line(line) {
            Ok(Some(order)) => lines.push(Line { number, order }),
            Ok(None) => {}
            Err(what) => return Err(Mistake { line: number, what }),
        }
    }
    Ok(lines)
}

/// Reads one line; none where nothing stands on it.
///
/// # Errors
/// What is wrong with it, in words.
pub fn parse_line(line: &str) -> Result<Option<Order>, String> {
    words(line).and_then(|words| order(&words))
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
        ("down", [key]) => Order::Press(code(key)?, true),
        ("up", [key]) => Order::Press(code(key)?, false),
        ("tap", [key]) => Order::Tap(code(key)?),
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
        ("give", [what, count]) => items::give(what, count)?,
        ("make", [item]) => items::make(item)?,
        ("teleport", [x, y, z, side @ ..]) if side.len() <= 1 => teleport([x, y, z], side)?,
        ("spawn", [what, x, y, z, side @ ..]) if side.len() <= 1 => spawn(what, [x, y, z], side)?,
        ("name-flag", [name]) => Order::NameFlag((*name).to_owned()),
        ("perf", [time]) => Order::Perf(number(time, 1.0 / 60.0, 600.0)?),
        ("room", ["set", _, ..])
        | ("add" | "change" | "group" | "carry" | "array", [_, _, ..])
        | ("remove" | "ungroup" | "duplicate", [_, ..])
        | ("undo" | "redo", [] | [_]) => Order::Edit(words.to_vec()),
        ("room", [_, ..]) => Order::Room(room::room(&args)?),
        (known, _) if command_named(known).is_some() => {
            return Err(format!(
                "\"{known}\" has too few, too many or unknown arguments"
            ));
        }
        (unknown, _) => return Err(format!("there is no command {}", quoted(unknown))),
    };
    Ok(Some(order))
}

fn new_world(geometry: &str, options: &[&str]) -> Result<NewWorld, String> {
    let geometry = geometry.parse::<Geometry>().map_err(|_| {
        let names = Geometry::ALL.map(Geometry::name);
        let (last, others) = names.split_last().unwrap_or((&"none", &[]));
        let others = others.join(", ");
        format!(
            "there is no space {}; there are {others} and {last}",
            quoted(geometry)
        )
    })?;
    let mut wanted = NewWorld {
        geometry,
        name: None,
        seed: None,
        radius_m: None,
        generator: None,
        mode: Mode::default(),
        start: Beginning::Middle,
    };
    for option in options {
        match option.split_once('=') {
            Some(("seed", value)) => {
                let seed = value.parse().ok();
                wanted.seed = Some(seed.ok_or_else(|| format!("{} is not a seed", quoted(value)))?);
            }
            Some(("generator", value)) => {
                let number = value.parse().ok().and_then(Generator::of_number);
                wanted.generator =
                    Some(number.ok_or_else(|| format!("{} is no generator", quoted(value)))?);
            }
            Some(("mode", value)) => {
                wanted.mode = value.parse()?;
            }
            Some(("name", value)) => wanted.name = Some(new_name(value)?),
            Some(("radius", value)) => wanted.radius_m = Some(number(value, 0.0, 1e6)?),
            _ => {
                return Err(format!(
                    "{} is none of seed=, name=, radius=, generator=, mode=",
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
    within(text, "a number", least, most)
}

fn whole(text: &str, least: u32, most: u32) -> Result<u32, String> {
    within(text, "a whole number", least, most)
}

fn within<N: Copy + FromStr + PartialOrd + Display>(
    text: &str,
    kind: &str,
    least: N,
    most: N,
) -> Result<N, String> {
    let value = text
        .parse()
        .map_err(|_| format!("{} is not {kind}", quoted(text)))?;
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

fn code(name: &str) -> Result<Input, String> {
    key_named(name).ok_or_else(|| {
        format!(
            "there is no key {}; keys are named like KeyW, Space, ShiftLeft, Digit3",
            quoted(name)
        )
    })
}

fn button(side: &str) -> Result<Input, String> {
    match side {
        "LEFT" => Ok(Input::Mouse(MouseButton::Left)),
        "RIGHT" => Ok(Input::Mouse(MouseButton::Right)),
        _ => Err(format!("{} is neither LEFT nor RIGHT", quoted(side))),
    }
}

fn input(name: &str) -> Result<Input, String> {
    button(name).or_else(|_| code(name))
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

fn spawn(what: &str, at: [&str; 3], side: &[&str]) -> Result<Order, String> {
    let spawned = Spawned::named(what).ok_or_else(|| {
        let mut words: Vec<_> = Spawned::words().collect();
        let last = words.pop().unwrap_or_default();
        format!(
            "{} is neither {} nor {last}",
            quoted(what),
            words.join(", ")
        )
    })?;
    let (at, chart) = place(at, side)?;
    Ok(Order::Spawn(spawned, at, chart))
}

fn teleport(at: [&str; 3], side: &[&str]) -> Result<Order, String> {
    let (at, chart) = place(at, side)?;
    Ok(Order::Teleport(at, chart))
}

/// What the player is told who names a chart that cannot be.
const NO_CHART: &str = "a hemisphere is A or B, and a square a hexadecimal number such as 0x1f";

fn place(at: [&str; 3], side: &[&str]) -> Result<([f64; 3], ChartId), String> {
    let chart = match side {
        [] => ChartId::FIRST,
        [name] => name.parse().map_err(|_| NO_CHART.to_owned())?,
        _ => return Err(NO_CHART.to_owned()),
    };
    let [x, y, z] = at.map(|text| number(text, -FARTHEST_M, FARTHEST_M));
    Ok(([x?, y?, z?], chart))
}

mod items;
mod room;
mod setting;
#[cfg(test)]
mod tests;
