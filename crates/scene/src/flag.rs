//! Flags: planted to find a place again, with a name that map and compass show.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use glam::DVec3;

use crate::actors::ActorId;
use crate::fixture::{Fixture, Foot, Refusals, Target};
use crate::notice::Hint;
use crate::outbox::Outbox;

/// Flags in a world at once.
pub const MOST_FLAGS: usize = 64;
/// Characters of a name at most.
pub const LONGEST_NAME: usize = 24;
/// Height of a flag, metres.
const HEIGHT_M: f64 = 1.7;
/// Ground with less than this upright in its unit normal is too steep for one.
const LEVEL_UP: f64 = 0.5;

/// A flag that was planted.
#[derive(Clone, Debug, PartialEq)]
pub struct Flag {
    /// Where it stands.
    pub foot: Foot,
    /// Where its cloth points from the pole, radians of its chart.
    pub yaw_rad: f64,
    /// Its name, as of [`tidy_name`]; may be empty.
    pub name: String,
}

impl Flag {
    /// A flag that stands, of that name as far as it can be one.
    pub fn standing(point: ChartPoint, yaw_rad: f64, name: &str) -> Self {
        Self {
            foot: Foot::standing(point),
            yaw_rad,
            name: tidy_name(name),
        }
    }
}

/// Whether it is not seen but changes how others are: directions, joiners, marks of the byte order.
fn is_unseen(c: char) -> bool {
    let ranges = [
        '\u{200b}'..='\u{200f}',
        '\u{202a}'..='\u{202e}',
        '\u{2060}'..='\u{2069}',
    ];
    c == '\u{feff}' || ranges.iter().any(|range| range.contains(&c))
}

/// What of a text can be a flag's name: one line that can be seen, its ends trimmed, of [`LONGEST_NAME`] characters at most.
pub fn tidy_name(text: &str) -> String {
    let seen: String = text.chars().filter(|c| !is_unseen(*c)).collect();
    let line = seen.split(char::is_control).map(str::trim);
    let words: Vec<&str> = line.filter(|part| !part.is_empty()).collect();
    let short: String = words.join(" ").chars().take(LONGEST_NAME).collect();
    short.trim_end().to_owned()
}

impl Fixture for Flag {
    const ITEM: Item = Item::Flag;
    const MOST: usize = MOST_FLAGS;
    const TARGET: Target = Target {
        heights_m: [0.0, HEIGHT_M],
        radius_m: 0.25,
    };
    const MIDDLE_M: f64 = 0.35;
    const MARKER_M: f64 = 0.12;
    const REFUSALS: Refusals = Refusals {
        no_place: Hint::NoPlaceForFlag,
        none_there: Hint::NoFlagThere,
        too_many: Hint::TooManyFlags,
    };

    /// Its cloth flies to the right of the one who planted it.
    fn put(foot: Foot, yaw: f64) -> Self {
        Self {
            foot,
            yaw_rad: yaw + FRAC_PI_2,
            name: String::new(),
        }
    }

    fn foot(&self) -> &Foot {
        &self.foot
    }

    fn foot_mut(&mut self) -> &mut Foot {
        &mut self.foot
    }

    fn foot_on(spot: ChartPoint, normal: DVec3) -> Option<ChartPoint> {
        (normal.y >= LEVEL_UP).then_some(spot)
    }

    /// Asks for its name.
    fn touch(id: ActorId, outbox: &mut Outbox) -> bool {
        outbox.names_flag = Some(id);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_short_line() {
        for (text, name) in [
            ("Home", "Home"),
            ("  at the\nriver\t ", "at the river"),
            ("\u{7}\n", ""),
            ("\u{200b}\u{202e}", ""),
            ("a\u{202e}b", "ab"),
            ("Überlingen 湖", "Überlingen 湖"),
        ] {
            assert_eq!(tidy_name(text), name);
        }
        let long = tidy_name(&"ä ".repeat(40));
        assert_eq!(long.chars().count(), LONGEST_NAME - 1);
        assert_eq!(tidy_name(&long), long);
    }
}
