//! Sightings between flags: who stands at one and looks at a second is told the angles of the triangle with a third.

use antipode_geometry::{ChartPoint, Strategy};
use antipode_items::Item;
use glam::DVec2;

use crate::bearings::{Locator, map_eye};
use crate::fixture::map_of;
use crate::situation::Situation;

/// Who is so near a flag stands at it, metres.
const AT_IT_M: f64 = 3.0;
/// One looks at the flag that is no farther from straight ahead than this, radians.
const AHEAD_RAD: f64 = 0.12;

/// A triangle of flags, by the geodesics of the ground sheet between their feet: of the flag where one stands, of the one that
/// one looks at, and of the third.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sighting {
    /// The angles at them, as sighted from each to the two others, radians.
    pub angles_rad: [f64; 3],
    /// The lengths of the sides opposite to them, metres.
    pub sides_m: [f64; 3],
}

/// The triangle of the flag where the player stands, the one that he looks at, and of the others the one that is nearest to the
/// first.
pub(crate) fn sighting(now: Situation<'_>) -> Option<Sighting> {
    let flags = map_of(now.actors, Item::Flag, |_, it| it.foot.point);
    if flags.len() < 3 {
        return None;
    }
    let strategy = &*now.world.strategy;
    let ways = ways_from(strategy, now.feet(), &flags);
    let here = (0..flags.len()).min_by(|a, b| ways[*a].length().total_cmp(&ways[*b].length()))?;
    if ways[here].length() > AT_IT_M {
        return None;
    }
    let ahead = DVec2::from_angle(now.head().yaw);
    let off = |place: usize| ahead.angle_to(ways[place]).abs();
    let others = || (0..flags.len()).filter(|place| *place != here);
    let seen = others().min_by(|a, b| off(*a).total_cmp(&off(*b)))?;
    if off(seen) > AHEAD_RAD {
        return None;
    }
    let third = others().filter(|place| *place != seen);
    let third = third.min_by(|a, b| ways[*a].length().total_cmp(&ways[*b].length()))?;
    triangle(strategy, [here, seen, third].map(|place| flags[place]))
}

/// None where two of them stand on one spot.
fn triangle(strategy: &dyn Strategy, corners: [ChartPoint; 3]) -> Option<Sighting> {
    let mut found = Sighting {
        angles_rad: [0.0; 3],
        sides_m: [0.0; 3],
    };
    for corner in 0..3 {
        let [next, last] = [1, 2].map(|by| (corner + by) % 3);
        let ways = ways_from(strategy, corners[corner], &[corners[next], corners[last]]);
        found.angles_rad[corner] = ways[0].angle_to(ways[1]).abs();
        found.sides_m[last] = ways[0].length();
    }
    let is_one = found.angles_rad.iter().all(|angle| angle.is_finite());
    let is_apart = found.sides_m.iter().all(|side| *side > 0.0);
    (is_one && is_apart).then_some(found)
}

/// The ways from a place to others along the ground sheet, metres along +x and +z of the place's chart.
fn ways_from(strategy: &dyn Strategy, from: ChartPoint, to: &[ChartPoint]) -> Vec<DVec2> {
    let eye = map_eye(from);
    let locator = Locator::new(strategy, &eye);
    to.iter().map(|point| locator.at(*point)).collect()
}
