//! Lamps: put down on the ground, on walls and under ceilings.

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use glam::DVec3;

use crate::fixture::{Fixture, Foot, Refusals, Target};
use crate::ground::Ground;
use crate::notice::Hint;
use crate::tuning::{LAMP_HEIGHT_M, LAMP_TARGET_M, MOST_LAMPS};

/// How far from the ground a lamp's glowing middle is kept, in metres. In the ground it would leave dark what it hangs
/// on; so its globe, 0.14 m in radius, just clears it.
const CLEAR_M: f64 = 0.22;
/// A wall or a ceiling that is no farther than this from the glowing middle holds a lamp, in metres.
const HOLDS_M: f64 = 0.34;
/// Ground with less than this upright in its unit normal is a wall or a ceiling.
const WALL_UP: f32 = 0.6;

/// A lamp that was put down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Where it stands.
    pub foot: Foot,
}

impl Lamp {
    /// A lamp that stands.
    pub fn standing(point: ChartPoint) -> Self {
        Self {
            foot: Foot::standing(point),
        }
    }

    /// The middle of its glass.
    pub fn glow(&self) -> ChartPoint {
        self.foot.point.moved(DVec3::Y * LAMP_HEIGHT_M)
    }
}

impl Fixture for Lamp {
    const ITEM: Item = Item::Lamp;
    const MOST: usize = MOST_LAMPS;
    const TARGET: Target = Target {
        heights_m: [LAMP_HEIGHT_M - LAMP_TARGET_M, LAMP_HEIGHT_M + LAMP_TARGET_M],
        radius_m: LAMP_TARGET_M,
    };
    const MIDDLE_M: f64 = LAMP_HEIGHT_M;
    /// A little more than its globe.
    const MARKER_M: f64 = 0.2;
    const REFUSALS: Refusals = Refusals {
        no_place: Hint::NoPlaceForLamp,
        none_there: Hint::NoLampThere,
        too_many: Hint::TooManyLamps,
    };

    fn put(foot: Foot, _yaw: f64) -> Self {
        Self { foot }
    }

    fn foot(&self) -> &Foot {
        &self.foot
    }

    fn foot_mut(&mut self) -> &mut Foot {
        &mut self.foot
    }

    fn foot_on(spot: ChartPoint, normal: DVec3) -> Option<ChartPoint> {
        Some(clear_foot(spot, normal))
    }

    /// On a wall or a ceiling.
    fn hangs(&self, ground: &Ground) -> bool {
        let glow = self.glow();
        let normal = ground.normal(glow);
        normal.y < WALL_UP
            && !ground.is_solid(glow)
            && ground.is_solid(glow.moved(normal.as_dvec3() * -HOLDS_M))
    }
}

/// Where the foot of a lamp stands that is put on ground with this unit normal: there if it is level enough, and out from
/// a wall or down from a ceiling.
fn clear_foot(point: ChartPoint, normal: DVec3) -> ChartPoint {
    point.moved(normal * (CLEAR_M - LAMP_HEIGHT_M * normal.y).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lamp_stands_on_level_ground_and_its_light_keeps_clear_of_walls_and_ceilings() {
        let spot = ChartPoint::a(DVec3::new(3.0, 10.0, 4.0));
        assert_eq!(clear_foot(spot, DVec3::new(0.6, 0.8, 0.0)), spot);
        for degrees in [0.0, 45.0, 70.0, 90.0, 120.0, 180.0_f64] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let normal = DVec3::new(sine, cosine, 0.0);
            let lamp = Lamp::standing(clear_foot(spot, normal));
            let clear = (lamp.glow().pos - spot.pos).dot(normal);
            assert!(clear > CLEAR_M - 1e-9, "{degrees}: {clear} m");
            let off = lamp.foot.point.pos.distance(spot.pos);
            assert!(off < CLEAR_M + LAMP_HEIGHT_M + 1e-9, "{degrees}: {off} m");
        }
    }
}
