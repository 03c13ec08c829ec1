//! Says errors, notices and kinds of things in the player's language. Rare errors have a sentence in that language and
//! details in English. Logs and the command line are English throughout.

use std::path::Path;

use antipode_geometry::{Geometry, HyperbolicMap};
use antipode_language::{Texts, Value};
use antipode_render::RenderError;
use antipode_room_scene::RoomHint;
use antipode_rooms::{RoomError, RoomSummary};
use antipode_scene::notice::Unfit;
use antipode_scene::sighting::Sighting;
use antipode_scene::{Hint, Item, Kind, Line, NotUndone, Notice, SceneError};
use antipode_settings::{Action, Profiles};
use antipode_storage::{NameError, StorageError, WorldSummary};
use antipode_streaming::{Cause, StreamingError};
use antipode_ui::{legible, legible_name};

use crate::failure::Failure;
use crate::hud_brush;
use crate::rooms::OpenRoom;
use crate::trouble::Trouble;

/// What can end an action, as sentences; `worlds` are those that are known, to tell by its folder one whose name cannot
/// be shown.
pub fn failure(texts: &Texts, failure: &Failure, worlds: &[WorldSummary]) -> String {
    match failure {
        Failure::Storage(error) | Failure::Room(RoomError::Storage(error)) => {
            storage(texts, error, worlds)
        }
        Failure::Scene(error) => scene(texts, error, worlds),
        Failure::Streaming(error) => streaming(texts, error),
        Failure::Render(error) => render(texts, error),
        Failure::NoWindow(_)
        | Failure::Script(_)
        | Failure::Usage(_)
        | Failure::Stopped(_)
        | Failure::Crashed { .. }
        | Failure::Room(_)
        | Failure::Rays(_)
        | Failure::Runtime(_) => other(texts, &failure.to_string()),
    }
}

/// The name of a world as far as it can be shown, with its folder beside it where that is needed and known.
fn world_name(world: &str, worlds: &[WorldSummary]) -> String {
    let known = worlds.iter().find(|known| known.name() == world);
    let folder = known.map_or("", |known| known.slug.as_str());
    legible_name(world, folder).into_owned()
}

/// Why a save could not be read or written; `worlds` as for [`failure`].
pub fn storage(texts: &Texts, error: &StorageError, worlds: &[WorldSummary]) -> String {
    let of_world = |key, world| texts.say_with(key, &[("world", world_name(world, worlds).into())]);
    let at = |key, path: &Path| texts.say_with(key, &[("path", path.display().to_string().into())]);
    match error {
        StorageError::InUse { world } => of_world("save-in-use", world),
        StorageError::Busy { dir } => at("saves-busy", dir),
        StorageError::Newer { world, .. } => of_world("save-newer", world),
        StorageError::Damaged { .. } => texts.say("save-part-damaged"),
        StorageError::Unreadable { path, .. } => at("save-unreadable", path),
        StorageError::NoStore { path, .. } => at("save-file-missing", path),
        StorageError::Vanished { path } => at("save-vanished", path),
        StorageError::NotADirectory { path } => at("saves-not-a-folder", path),
        StorageError::NotFound { world, .. } => of_world("save-not-found", world),
        StorageError::Name(error) => name(texts, error, worlds),
        StorageError::Exists { path } => at("file-exists", path),
        StorageError::DiskFull { what } => {
            texts.say_with("disk-full", &[("path", legible(what).into())])
        }
        StorageError::NotWritable { path } => at("not-writable", path),
        StorageError::NotReadable { path } => at("not-readable", path),
        StorageError::Archive { path, .. } => at("archive-refused", path),
        _ => other(texts, &error.to_string()),
    }
}

/// What is wrong with a world in the list, if anything.
pub fn world_problem(texts: &Texts, world: &WorldSummary) -> Option<String> {
    match (&world.error, &world.problem) {
        (Some(error), _) => Some(storage(texts, error.get(), std::slice::from_ref(world))),
        (None, Some(_)) => Some(texts.say("save-part-damaged")),
        (None, None) => None,
    }
}

/// Why a world cannot be called that; `worlds` as for [`failure`].
pub fn name(texts: &Texts, error: &NameError, worlds: &[WorldSummary]) -> String {
    match error {
        NameError::Empty => texts.say("name-empty"),
        NameError::Blank => texts.say("name-blank"),
        NameError::TooLong { chars } => {
            let most = antipode_storage::MAX_NAME_CHARS;
            let values = [("chars", (*chars).into()), ("most", most.into())];
            texts.say_with("name-too-long", &values)
        }
        NameError::Unprintable(letter) => {
            let code = letter.escape_unicode().to_string();
            texts.say_with("name-unprintable", &[("code", code.into())])
        }
        NameError::Taken { existing } => texts.say_with(
            "name-taken",
            &[("name", world_name(existing, worlds).into())],
        ),
    }
}

/// What a room is called where it is shown, and what is strange in it.
#[derive(Clone, Debug, PartialEq)]
pub struct RoomWords {
    /// Its name.
    pub name: String,
    /// One sentence; may be empty.
    pub sentence: String,
}

/// The words for a room in a list; what the game has written is in the player's language, in copies of its rooms, too.
pub fn room(texts: &Texts, room: &RoomSummary) -> RoomWords {
    let own = |what: &str, is_games: bool, otherwise: &str| {
        let key = room.says.as_ref().map(|id| format!("room-{id}-{what}"));
        key.filter(|key| is_games && texts.has(key))
            .map_or_else(|| otherwise.to_owned(), |key| texts.say(&key))
    };
    let name = own("name", room.shipped, &room.name);
    RoomWords {
        name: legible_name(&name, &room.slug).into_owned(),
        sentence: own("sentence", true, &room.sentence),
    }
}

/// A short answer to what one does in a room.
pub fn room_hint(texts: &Texts, hint: RoomHint) -> String {
    texts.say(match hint {
        RoomHint::NoPlaceForLamp => "room-hint-no-place-for-lamp",
        RoomHint::TooManyLamps => "room-hint-too-many-lamps",
        RoomHint::NothingToLift => "room-hint-nothing-to-lift",
        RoomHint::TooHeavy => "room-hint-too-heavy",
        RoomHint::FellOut => "room-hint-fell-out",
    })
}

/// The words for an open room, which comes from there if it is kept.
pub fn open_room(texts: &Texts, open: &OpenRoom) -> RoomWords {
    match &open.kept {
        Some(kept) if kept.shipped => room(texts, kept),
        kept => {
            let it = open.scene.room();
            let kept = kept.as_ref().filter(|kept| kept.sentence == it.sentence);
            RoomWords {
                name: legible_name(&it.name, "").into_owned(),
                sentence: kept
                    .map_or_else(|| it.sentence.clone(), |kept| room(texts, kept).sentence),
            }
        }
    }
}

/// What a scene has to tell.
pub fn notice(texts: &Texts, notice: &Notice) -> String {
    match notice {
        Notice::PlayerDamaged => texts.say("player-damaged"),
        Notice::UnknownItem(item) => texts.say_with("unknown-item", &[("item", item.into())]),
        Notice::UnknownRecords(count) => {
            texts.say_with("unknown-records", &[("count", (*count).into())])
        }
        Notice::UnknownMap(map) => texts.say_with("unknown-map", &[("map", map.into())]),
        Notice::NotSaved(why) => {
            let first = texts.say("not-saved-yet");
            format!("{first} {}", cause(texts, why))
        }
        Notice::MoreDamaged(count) => texts.say_with("more-damaged", &[("count", (*count).into())]),
        Notice::Damaged(details) => damaged(texts, details),
        Notice::Land(details) => texts.say_with("land-trouble", &[("details", details.into())]),
    }
}

/// The answer to what the player did.
pub fn hint(texts: &Texts, profiles: &Profiles, hint: Hint) -> String {
    let input = |action| antipode_ui::first_input_label(texts, profiles, action);
    match hint {
        Hint::NoOtherMap => texts.say("hint-no-other-map"),
        Hint::Map(HyperbolicMap::Raised) => texts.say("hint-map-raised"),
        Hint::Map(HyperbolicMap::Horizon) => texts.say("hint-map-horizon"),
        Hint::Bent => bent(texts, profiles),
        Hint::Unbent => texts.say("hint-unbent"),
        Hint::NoBullets => texts.say("hint-no-bullets"),
        Hint::NoPlaceFor(item) => texts.say(&format!("hint-no-place-for-{}", item.id())),
        Hint::Unfit(why) => texts.say(match why {
            Unfit::Steep => "hint-door-steep",
            Unfit::Walled => "hint-door-walled",
            Unfit::Crowded => "hint-door-crowded",
        }),
        Hint::NoneThere(item) => texts.say(&format!("hint-none-there-{}", item.id())),
        Hint::MovedOldest(item) => texts.say(&format!("hint-moved-{}", item.id())),
        Hint::TooMany(item) => texts.say(&format!("hint-too-many-{}", item.id())),
        Hint::NoRoom => texts.say("hint-no-room"),
        Hint::TooManyDrops => texts.say("hint-too-many-drops"),
        Hint::DiedOfFall => texts.say("hint-died-of-fall"),
        Hint::DiedOfShot => texts.say("hint-died-of-shot"),
        Hint::DiedOfCrash => texts.say("hint-died-of-crash"),
        Hint::DiedOfCar => texts.say("hint-died-of-car"),
        Hint::DiedOfTree => texts.say("hint-died-of-tree"),
        Hint::AtTheWheel => {
            let values = [
                ("brake", input(Action::Jump).into()),
                ("camera", input(Action::Camera).into()),
                ("horn", input(Action::Horn).into()),
                ("leave", input(Action::LeaveCar).into()),
            ];
            texts.say_with("hint-at-the-wheel", &values)
        }
        Hint::FallenOver => {
            let values = [("flip", input(Action::FlipCar).into())];
            texts.say_with("hint-fallen-over", &values)
        }
        Hint::NoCarNear => texts.say("hint-no-car-near"),
        Hint::LookAtCar => texts.say("hint-look-at-car"),
        Hint::CarTooFar => texts.say("hint-car-too-far"),
        Hint::NoWayOut => texts.say("hint-no-way-out"),
        Hint::BackAgain => texts.say("hint-back-again"),
        Hint::NobodyToTalkTo => texts.say("hint-nobody-to-talk-to"),
        Hint::TooFarToTalk => texts.say("hint-too-far-to-talk"),
        Hint::WaitsToTalk => texts.say("hint-waits-to-talk"),
        Hint::InTheWay => texts.say("hint-in-the-way"),
        Hint::OutOfReach => texts.say("hint-out-of-reach"),
        Hint::TooHard(kind) => of_ground(texts, "hint-too-hard", kind),
        Hint::LastLaid(item) => texts.say(&format!("hint-last-{}", item.id())),
        Hint::UsedUp(None) => texts.say("hint-nothing-to-build"),
        Hint::UsedUp(Some(kind)) => of_ground(texts, "hint-used-up", kind),
        Hint::NoCoalYet => texts.say("hint-no-coal-yet"),
        Hint::Made(item, count) => made(texts, item, count),
        Hint::Undone => texts.say("hint-undone"),
        Hint::NotUndone(why) => not_undone(texts, why),
        Hint::Said { greets, line } => said(texts, greets, line),
        Hint::Entered(name) => land(texts, name),
        Hint::BeenRound(metres) => texts.say_with("hint-been-round", &[("metres", metres.into())]),
    }
}

fn bent(texts: &Texts, profiles: &Profiles) -> String {
    let input = |action| antipode_ui::first_input_label(texts, profiles, action);
    let values = [
        ("up", input(Action::DialUp).into()),
        ("down", input(Action::DialDown).into()),
    ];
    texts.say_with("hint-bent", &values)
}

fn made(texts: &Texts, item: Item, count: u32) -> String {
    let item = texts.say(&format!("item-{}", item.id()));
    let item = if count == 1 {
        item
    } else {
        let values = [("item", item.into()), ("count", count.into())];
        texts.say_with("backpack-item", &values)
    };
    texts.say_with("hint-made", &[("item", item.into())])
}

fn of_ground(texts: &Texts, key: &str, kind: Kind) -> String {
    texts.say_with(key, &[("kind", hud_brush::kind_word(texts, kind).into())])
}

fn not_undone(texts: &Texts, why: NotUndone) -> String {
    texts.say(match why {
        NotUndone::NoneLeft => "hint-undo-none-left",
        NotUndone::Away => "hint-undo-away",
        NotUndone::Changed => "hint-undo-changed",
        NotUndone::Spent => "hint-undo-spent",
        NotUndone::Unreadable => "hint-undo-unreadable",
    })
}

/// What is against a place, in a few words for the middle of the screen.
pub fn unfit_here(texts: &Texts, why: Unfit) -> String {
    texts.say(match why {
        Unfit::Steep => "against-door-steep",
        Unfit::Walled => "against-door-walled",
        Unfit::Crowded => "against-door-crowded",
    })
}

/// What somebody says about the space.
pub fn said(texts: &Texts, greets: bool, line: Line) -> String {
    let words = line_words(texts, line);
    if greets {
        texts.say_with("talk-hello", &[("words", words.into())])
    } else {
        words
    }
}

fn line_words(texts: &Texts, line: Line) -> String {
    let tenths = |tenths: i32| Value::decimals(f64::from(tenths) / 10.0, 1);
    match line {
        Line::Triangle {
            side_m,
            sum_decidegrees,
            pictured,
        } => {
            let key = if pictured {
                "talk-triangle-pictured"
            } else if sum_decidegrees > 1800 {
                "talk-triangle-more"
            } else if sum_decidegrees < 1800 {
                "talk-triangle-less"
            } else {
                "talk-triangle-flat"
            };
            let values = [("side", side_m.into()), ("sum", tenths(sum_decidegrees))];
            texts.say_with(key, &values)
        }
        Line::Horizon {
            away_m,
            lower_decidegrees,
        } => {
            let key = match lower_decidegrees.signum() {
                1 => "talk-horizon-lower",
                -1 => "talk-horizon-higher",
                _ => "talk-horizon-flat",
            };
            let angle = tenths(lower_decidegrees.abs());
            texts.say_with(key, &[("away", away_m.into()), ("angle", angle)])
        }
        Line::Home {
            there_m,
            round_m,
            squares,
        } => {
            let there = ("there", there_m.into());
            match (round_m, squares) {
                (Some(round_m), _) => {
                    texts.say_with("talk-home-round", &[there, ("round", round_m.into())])
                }
                (None, Some(squares)) => {
                    texts.say_with("talk-home-squares", &[there, ("squares", squares.into())])
                }
                (None, None) => texts.say_with("talk-home-straight", &[there]),
            }
        }
        Line::Land { within_m, tenths } => {
            let times = Value::decimals(f64::from(tenths) / 10.0, 1);
            texts.say_with(
                "talk-land",
                &[("within", within_m.into()), ("times", times)],
            )
        }
        Line::Square {
            side_m,
            gap_decimetres,
        } => {
            let gap = Value::decimals(f64::from(gap_decimetres) / 10.0, 1);
            texts.say_with("talk-square", &[("side", side_m.into()), ("gap", gap)])
        }
    }
}

/// What who sights a triangle of flags is told of it.
pub fn sighting(texts: &Texts, it: &Sighting) -> String {
    let tenth = |degrees: f64| (10.0 * degrees).round() / 10.0;
    let [here, seen, third] = it.angles_rad.map(f64::to_degrees);
    // What is shown adds up.
    let sum = tenth(here + seen + third);
    let (here, seen) = (tenth(here), tenth(seen));
    let third = sum - here - seen;
    // The side to the flag that one looks at first.
    let [across, to_third, to_seen] = it.sides_m;
    let values = [
        ("here", Value::decimals(here, 1)),
        ("seen", Value::decimals(seen, 1)),
        ("third", Value::decimals(third, 1)),
        ("sum", Value::decimals(sum, 1)),
        ("a", Value::decimals(to_seen, 0)),
        ("b", Value::decimals(across, 0)),
        ("c", Value::decimals(to_third, 0)),
    ];
    texts.say_with("display-sighting", &values)
}

/// What an item is called.
pub fn item(texts: &Texts, item: Item) -> String {
    texts.say(&format!("item-{}", item.id()))
}

/// A space in a word, within a sentence or beside other words.
pub fn geometry(texts: &Texts, geometry: Geometry) -> String {
    texts.say(&format!("space-{geometry}"))
}

/// What land is called, by the name of a biome or `cave`.
pub fn land(texts: &Texts, name: &str) -> String {
    texts.say(&format!("biome-{name}"))
}

/// Why the chunk workers or the saver failed.
pub fn streaming(texts: &Texts, error: &StreamingError) -> String {
    match error {
        StreamingError::NotSaved(why) => {
            let first = texts.say("not-saved");
            format!("{first} {}", cause(texts, why))
        }
        StreamingError::Unfinished => texts.say("save-unfinished"),
        StreamingError::Store(why) => match why.downcast_ref() {
            Some(error) => storage(texts, error, &[]),
            None => other(texts, &why.to_string()),
        },
        StreamingError::Threads(_) => other(texts, &error.to_string()),
    }
}

fn cause(texts: &Texts, why: &Cause) -> String {
    match why.downcast_ref() {
        Some(error) => storage(texts, error, &[]),
        None => other(texts, &why.to_string()),
    }
}

fn scene(texts: &Texts, error: &SceneError, worlds: &[WorldSummary]) -> String {
    match error {
        SceneError::Storage(error) => storage(texts, error, worlds),
        SceneError::Streaming(error) => streaming(texts, error),
        SceneError::UnknownGeometry { name, .. } => texts.say_with(
            "unknown-space",
            &[("world", world_name(name, worlds).into())],
        ),
        SceneError::UnknownGenerator { name, .. } => texts.say_with(
            "unknown-generator",
            &[("world", world_name(name, worlds).into())],
        ),
        SceneError::ImpossibleRadius { name, radius_m } => texts.say_with(
            "impossible-radius",
            &[
                ("world", world_name(name, worlds).into()),
                ("radius", texts.marked(&radius_m.to_string()).into()),
            ],
        ),
    }
}

fn render(texts: &Texts, error: &RenderError) -> String {
    match error {
        RenderError::NoAdapter { found, .. } => {
            texts.say_with("no-adapter", &[("found", found.into())])
        }
        RenderError::Lost(_) => texts.say("adapter-lost"),
        RenderError::Shader(details) => refused_shader(texts, details),
        _ => other(texts, &error.to_string()),
    }
}

fn refused_shader(texts: &Texts, details: &str) -> String {
    texts.say_with("adapter-refuses", &[("details", details.into())])
}

/// Why the graphics of the game before failed for good.
pub fn trouble(texts: &Texts, trouble: &Trouble) -> String {
    match trouble {
        Trouble::Lost => texts.say("graphics-lost"),
        Trouble::Shader(details) => refused_shader(texts, details),
        Trouble::Other(details) => other(texts, details),
    }
}

fn damaged(texts: &Texts, details: &str) -> String {
    texts.say_with("save-damaged", &[("details", details.into())])
}

fn other(texts: &Texts, details: &str) -> String {
    texts.say_with("other-trouble", &[("details", details.into())])
}

/// What was not as it should be in the file of the settings.
pub fn settings_notice(texts: &Texts, notice: &antipode_settings::Notice) -> String {
    let mut values = notice.text_arguments();
    for (name, value) in &mut values {
        if *name == "name" {
            *value = settings_name(texts, value);
        }
    }
    texts_with(texts, notice.text_key(), values)
}

/// What the player calls a setting or an action; its id where it has no name.
fn settings_name(texts: &Texts, id: &str) -> String {
    if antipode_settings::field(id).is_some() {
        return texts.say(&format!("setting-{id}"));
    }
    match Action::named(id) {
        Some(action) => antipode_ui::action_label(texts, action),
        None => id.to_owned(),
    }
}

/// A text with words in it.
pub fn texts_with(texts: &Texts, key: &str, values: Vec<(&'static str, String)>) -> String {
    let values: Vec<_> = values
        .into_iter()
        .map(|(name, value)| (name, value.into()))
        .collect();
    texts.say_with(key, &values)
}

#[cfg(test)]
mod tests;
