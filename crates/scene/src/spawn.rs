//! Chooses where a new player stands: on the surface, never in it, and on the gentlest ground nearby.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{ChartId, ChartPoint, Eye, Map};
use antipode_terrain::Field;
use glam::DVec3;

/// Heading of a new player: along -z, towards the sunrise.
pub const FIRST_YAW_RAD: f64 = -FRAC_PI_2;

/// Elevation of a new player's view, where ground in reach is under the crosshair then: level, the marker would hang in
/// the sky. Where the land falls away, as all land does in hyperbolic space, it is lowered in steps.
const FIRST_PITCH_RAD: f64 = -8.0 * std::f64::consts::PI / 180.0;
const LOWER_BY_RAD: f64 = 2.0 * std::f64::consts::PI / 180.0;
const MOST_STEPS: u32 = 16;
/// Points of the view's geodesic at which the ground is asked for, in metres: apart, and the farthest.
const LOOK_M: (f64, f64) = (0.5, 20.0);

/// Columns considered around the world's centre: a spiral of rings, in metres.
const RINGS_M: [f64; 4] = [0.0, 4.0, 8.0, 12.0];
/// Gap left below the feet so that the capsule never begins inside a facet.
const CLEARANCE_M: f64 = 0.15;

/// The feet of a new player. A closed world is entered at its pole, from where every straight walk comes home.
pub fn spawn_point(field: &Field) -> ChartPoint {
    let closed = field.strategy().globe().is_some();
    let rings = if closed { &RINGS_M[..1] } else { &RINGS_M[..] };
    let mut best: Option<(f64, DVec3)> = None;
    for &ring_m in rings {
        for turn in 0..8 {
            let angle = f64::from(turn) * FRAC_PI_2 / 2.0;
            let (x, z) = (ring_m * angle.cos(), ring_m * angle.sin());
            let (height, roughness) = column(field, x, z);
            if best.is_none_or(|(least, _)| roughness < least - 0.05) {
                best = Some((roughness, DVec3::new(x, height + CLEARANCE_M, z)));
            }
            if ring_m == 0.0 {
                break;
            }
        }
    }
    ChartPoint::a(best.map_or(DVec3::ZERO, |(_, point)| point))
}

/// The elevation at which a new player's view, by that eye through that picture, has the ground ahead.
pub(crate) fn first_pitch_rad(field: &Field, head: &Eye, pictured: &dyn Map) -> f64 {
    let mut pitches = (0..=MOST_STEPS).map(|step| FIRST_PITCH_RAD - f64::from(step) * LOWER_BY_RAD);
    let found = pitches.find(|pitch| {
        let eye = Eye {
            pitch: *pitch,
            ..*head
        };
        sees_ground(field, &eye, pictured)
    });
    found.unwrap_or(FIRST_PITCH_RAD)
}

/// Whether ground in reach is under an eye's crosshair.
fn sees_ground(field: &Field, eye: &Eye, pictured: &dyn Map) -> bool {
    let (step_m, most_m) = LOOK_M;
    let steps = (most_m / step_m) as u32;
    (1..=steps).any(|step| {
        let at = pictured.along(eye, DVec3::NEG_Z, f64::from(step) * step_m);
        field.sample(at) < 0.0
    })
}

/// Feet on untouched ground at a place of hemisphere A.
pub(crate) fn standing_at(field: &Field, x: f64, z: f64) -> ChartPoint {
    let (height, _) = column(field, x, z);
    ChartPoint::a(DVec3::new(x, height + CLEARANCE_M, z))
}

/// Height of a column, the highest of its close neighbourhood, and how far that neighbourhood spreads.
fn column(field: &Field, x: f64, z: f64) -> (f64, f64) {
    let near = 0.5;
    let around = [
        (0.0, 0.0),
        (near, 0.0),
        (-near, 0.0),
        (0.0, near),
        (0.0, -near),
    ]
    .map(|(dx, dz)| field.surface_height(ChartId::FIRST, x + dx, z + dz));
    let high = around.iter().copied().fold(f64::MIN, f64::max);
    let low = around.iter().copied().fold(f64::MAX, f64::min);
    (high, high - low)
}

#[cfg(test)]
mod tests {

    use antipode_geometry::{Geometry, strategy};

    use super::*;

    #[test]
    fn a_closed_world_is_entered_at_its_pole() {
        let space = strategy(Geometry::Spherical, 32.0);
        let feet = spawn_point(&Field::new(12, space));
        assert_eq!((feet.pos.x, feet.pos.z), (0.0, 0.0));
    }

    #[test]
    fn a_new_player_stands_clear_above_ground_in_every_space_and_biome() {
        for geometry in [
            Geometry::Euclidean,
            Geometry::Hyperbolic,
            Geometry::Spherical,
        ] {
            for seed in 0..20 {
                let space = strategy(
                    geometry,
                    if geometry == Geometry::Spherical {
                        32.0
                    } else {
                        20.0
                    },
                );
                let field = Field::new(seed, space.clone());
                let feet = spawn_point(&field);
                for rise in [0.0, 0.5, 1.0, 1.8] {
                    let body = ChartPoint::a(feet.pos + DVec3::Y * rise);
                    assert!(
                        field.sample(body) > 0.0,
                        "{geometry:?} seed {seed}: {rise} m above the feet is rock"
                    );
                }
                let below = ChartPoint::a(feet.pos - DVec3::Y * 1.5);
                assert!(
                    field.sample(below) < 0.0,
                    "{geometry:?} seed {seed}: floats"
                );
            }
        }
    }
}
