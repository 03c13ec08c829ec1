//! Lamps: put down on the ground, on walls and under ceilings.

use antipode_geometry::ChartPoint;
use antipode_items::Stands;
use glam::DVec3;

use crate::fixture::{Behaviour, Fixture};
use crate::ground::Ground;

/// How far from the ground a lamp's glowing middle is kept, in metres. In the ground it would leave dark what it hangs
/// on; so its globe, 0.14 m in radius, just clears it.
const CLEAR_M: f64 = 0.22;
/// A wall or a ceiling that is no farther than this from the glowing middle holds a lamp, in metres.
const HOLDS_M: f64 = 0.34;
/// Ground with less than this upright in its unit normal is a wall or a ceiling.
const WALL_UP: f32 = 0.6;

/// What clings to walls and ceilings, too.
pub(crate) struct Clings;

impl Behaviour for Clings {
    fn foot_on(&self, stands: &Stands, spot: ChartPoint, normal: DVec3) -> Option<ChartPoint> {
        Some(clear_foot(stands.middle_m, spot, normal))
    }

    /// On a wall or a ceiling.
    fn hangs(&self, it: &Fixture, ground: &Ground) -> bool {
        let glow = it.glow();
        let normal = ground.normal(glow);
        normal.y < WALL_UP
            && !ground.is_solid(glow)
            && ground.is_solid(glow.moved(normal.as_dvec3() * -HOLDS_M))
    }
}

/// Where the foot of a lamp stands that is put on ground with this unit normal, its glowing middle so high over its foot,
/// metres: there if it is level enough, and out from a wall or down from a ceiling.
fn clear_foot(middle_m: f64, point: ChartPoint, normal: DVec3) -> ChartPoint {
    point.moved(normal * (CLEAR_M - middle_m * normal.y).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lamp_stands_on_level_ground_and_its_light_keeps_clear_of_walls_and_ceilings() {
        let spot = ChartPoint::a(DVec3::new(3.0, 10.0, 4.0));
        let middle_m = 0.35;
        assert_eq!(clear_foot(middle_m, spot, DVec3::new(0.6, 0.8, 0.0)), spot);
        for degrees in [0.0, 45.0, 70.0, 90.0, 120.0, 180.0_f64] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let normal = DVec3::new(sine, cosine, 0.0);
            let foot = clear_foot(middle_m, spot, normal).pos;
            let clear = (foot + DVec3::Y * middle_m - spot.pos).dot(normal);
            assert!(clear > CLEAR_M - 1e-9, "{degrees}: {clear} m");
            let off = foot.distance(spot.pos);
            assert!(off < CLEAR_M + middle_m + 1e-9, "{degrees}: {off} m");
        }
    }
}
