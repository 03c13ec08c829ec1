//! The soft dark on the ground right under wheels and things: light from all around does not come there. Bodies have a shade
//! of their own, which the land draws.

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use glam::DVec3;

use crate::frame::{Figure, GroundMark, MarkShape};
use crate::moment::Who;
use crate::world::World;

/// Contacts in a picture.
const MOST_CONTACTS: usize = 64;
/// Those farther from the eye than this are left out, metres of the chart.
const SEEN_M: f64 = 40.0;
/// The ground is looked for from so far above a thing's origin to so far below it, metres.
const ABOVE_M: f64 = 0.3;
const BELOW_M: f64 = 0.9;
/// Contacts lie so high over the ground, metres.
const LIFT_M: f64 = 0.015;
/// Half of a contact's sides under a wheel, along and across it, and under other things, metres.
const WHEEL_M: (f64, f64) = (0.42, 0.26);
const THING_M: f64 = 0.34;
/// Radius of a wheel, metres: its origin is its hub.
const HUB_M: f64 = 0.36;
/// Which share of the light a contact takes at the most.
const DARKEST: f64 = 0.62;

/// Adds the contacts of what a picture shows, seen from a place.
pub(crate) fn add(
    world: &World,
    eye: ChartPoint,
    figures: &[(Who, Figure)],
    marks: &mut Vec<GroundMark>,
) {
    let near = figures.iter().filter(|(_, figure)| {
        figure.point.chart == eye.chart && figure.point.pos.distance(eye.pos) < SEEN_M
    });
    let contacts = near.filter_map(|(who, figure)| {
        let (half_m, hub_m) = match who {
            Who::Wheel(..) => (WHEEL_M, HUB_M),
            Who::Drop(_) => ((THING_M, THING_M), 0.0),
            Who::Fixture(item, _) if *item != Item::Door => ((THING_M, THING_M), 0.0),
            _ => return None,
        };
        under(world, figure, half_m, hub_m)
    });
    marks.extend(contacts.take(MOST_CONTACTS));
}

/// The dark under a figure whose lowest point is so far below its origin.
fn under(
    world: &World,
    figure: &Figure,
    (long_m, wide_m): (f64, f64),
    hub_m: f64,
) -> Option<GroundMark> {
    let chart = figure.point.chart;
    let from = figure.point.pos + DVec3::Y * ABOVE_M;
    let ground = world.physics.chart(chart);
    let hit = ground.cast_ray(from, DVec3::NEG_Y, ABOVE_M + BELOW_M + hub_m)?;
    let height_m = (hit.distance_m - ABOVE_M - hub_m).max(0.0);
    let strength = DARKEST * (1.0 - height_m / BELOW_M).clamp(0.0, 1.0).powi(2);
    let across = figure.turn * DVec3::Z;
    let across = (across - hit.normal * across.dot(hit.normal)).normalize_or(DVec3::Z);
    let along = hit.normal.cross(across).normalize_or(DVec3::X);
    let (wide_m, long_m) = (
        wide_m * (1.0 + height_m / BELOW_M),
        long_m * (1.0 + height_m / BELOW_M),
    );
    let corner = |side: f64, end: f64| {
        hit.point + hit.normal * LIFT_M + across * (side * wide_m) + along * (end * long_m)
    };
    Some(GroundMark {
        chart,
        corners: [
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(-1.0, 1.0),
            corner(1.0, 1.0),
        ],
        shape: MarkShape::Contact,
        strength: [strength as f32; 2],
        along_m: [0.0; 2],
    })
}
