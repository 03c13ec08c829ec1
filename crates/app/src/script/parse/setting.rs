//! Parses the arguments of `set`.

use antipode_geometry::HyperbolicMap;
use antipode_scene::frame::Quality;
use antipode_scene::{BrushShape, NpcMode};
use antipode_settings::{Settings, Value};
use antipode_terrain::Kind;

use super::{number, quoted, whole};

/// Something `set` can change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// Time of day in seconds.
    Time(f64),
    /// The dial of a hyperbolic world.
    Curvature(f64),
    /// The map of a hyperbolic world.
    Map(HyperbolicMap),
    /// The bend of a flat world's picture.
    Bend(f64),
    /// How much exactness pictures trade for speed.
    Quality(Quality),
    /// View distance in chunks, 0 for what scripts usually have.
    ViewDistance(u32),
    /// The player's health.
    Health(f64),
    /// Spectator's flight.
    Fly(bool),
    /// Whether other figures come, and whether they have a mind.
    Npcs(NpcMode),
    /// The shape of the brush.
    Brush(BrushShape),
    /// What is built of; nothing for what is found there.
    Ground(Option<Kind>),
    /// One of the player's own settings: its id, and a value that it takes.
    Own(&'static str, Value),
}

/// Reads one.
pub(super) fn setting(what: &str, value: &str) -> Result<Setting, String> {
    Ok(match what {
        "time" => Setting::Time(number(value, 0.0, 600.0)?),
        "curvature" => Setting::Curvature(number(value, 0.0, 20.0)?),
        "map" => Setting::Map(
            value
                .parse()
                .map_err(|_| format!("there is no map {}", quoted(value)))?,
        ),
        "bend" => Setting::Bend(number(value, -20.0, 20.0)?),
        "quality" => Setting::Quality(
            value
                .parse()
                .map_err(|_| format!("there is no quality {}", quoted(value)))?,
        ),
        "view-distance" => Setting::ViewDistance(whole(value, 0, 16)?),
        "health" => Setting::Health(number(value, 0.0, 20.0)?),
        "fly" => match value {
            "on" => Setting::Fly(true),
            "off" => Setting::Fly(false),
            _ => return Err(format!("{} is neither on nor off", quoted(value))),
        },
        "npcs" => Setting::Npcs(match value {
            "on" => NpcMode::On,
            "off" => NpcMode::Off,
            "still" => NpcMode::Still,
            _ => return Err(format!("{} is none of on, off and still", quoted(value))),
        }),
        "brush" => Setting::Brush(
            BrushShape::of_name(value)
                .ok_or_else(|| format!("there is no brush {}", quoted(value)))?,
        ),
        "ground" => Setting::Ground(match value {
            "found" => None,
            _ => Some(
                Kind::of_name(value)
                    .ok_or_else(|| format!("there is no kind of ground {}", quoted(value)))?,
            ),
        }),
        _ => return own_setting(what, value),
    })
}

/// One of the player's own settings, as the settings screen has them.
fn own_setting(what: &str, value: &str) -> Result<Setting, String> {
    let Some(field) = antipode_settings::field(what) else {
        return Err(format!("there is no setting {}", quoted(what)));
    };
    let mut settings = Settings::default();
    let taken = settings.set_word(field.id, value);
    taken.map_err(|error| error.to_string())?;
    Ok(Setting::Own(field.id, settings.get(field)))
}
