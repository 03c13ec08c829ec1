//! The sill of an opening: how high the ground of the other side is where the land seen through a door begins.
//!
//! Who looks down at a sill that is higher on the other side would look under that ground, where nothing is. So an opening begins
//! at it, and below one sees what is on this side: a step up.

use antipode_geometry::doorway::{BELOW_FOOT_M, HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{ChartPoint, Doorway, Leaf};
use glam::DVec3;

use crate::frame::Opening;
use crate::world::World;

/// Halvings by which the height of the ground is found, within two centimetres.
const HALVINGS: u32 = 8;

/// Heights along the lower edge of an opening, metres over the foot of the leaf that is come out of, as [`Opening::sill_m`].
type Heights = [f64; Opening::SILLS];

/// The sills of a pair of doors. They are worked out anew when the pair or any ground has changed: that asks for the ground at some two
/// hundred places, a third of a millisecond, which no frame needs while one stands.
#[derive(Debug, Default)]
pub(crate) struct Sills(Option<Known>);

#[derive(Debug)]
struct Known {
    doors: Doorway,
    changes: u64,
    /// Of what is seen through the older leaf, and through the newer.
    heights_m: [Heights; 2],
}

impl Sills {
    /// Has them be those of the doors and the ground of a world as they are now.
    pub fn renew(&mut self, world: &World) {
        let changes = world.ground.changes();
        let is_right = |it: &Known| world.doors == Some(it.doors) && it.changes == changes;
        if self.0.as_ref().is_some_and(is_right) {
            return;
        }
        let solid = |at: ChartPoint| world.ground.is_solid(at);
        self.0 = world.doors.map(|doors| Known {
            doors,
            changes,
            heights_m: [1, 0].map(|far| sill_m(solid, &doors.leaves[far])),
        });
    }

    /// What is known of a pair's: until a step has been made, that an opening reaches as low as it can.
    pub fn of(&self, doors: &Doorway) -> [Heights; 2] {
        let known = self.0.as_ref().filter(|it| it.doors == *doors);
        known.map_or([[-BELOW_FOOT_M; Opening::SILLS]; 2], |it| it.heights_m)
    }
}

/// How high the ground is along the lower edge of a leaf, metres over its foot, as [`Opening::sill_m`] has it. Where there is none it
/// is as low as an opening reaches, and where all is rock as high: nothing is seen through that.
fn sill_m(solid: impl Fn(ChartPoint) -> bool, leaf: &Leaf) -> Heights {
    let last = (Opening::SILLS - 1) as f64;
    std::array::from_fn(|column| {
        let z = (2.0 * column as f64 / last - 1.0) * HALF_WIDTH_M;
        let is_solid = |y: f64| solid(leaf.place(DVec3::new(0.0, y, z)));
        let (mut low, mut high) = (-BELOW_FOOT_M, HEIGHT_M);
        if is_solid(high) {
            return high;
        }
        if !is_solid(low) {
            return low;
        }
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if is_solid(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    })
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, LevelMap};

    use super::*;

    #[test]
    fn a_sill_is_as_high_as_the_ground_all_of_it_in_rock_and_none_over_a_pit() {
        let leaf = Leaf {
            foot: ChartPoint::new(ChartId::FIRST, DVec3::new(7.0, 5.0, -3.0)),
            yaw: 0.0,
            level: LevelMap::SAME,
        };
        let slope = |at: ChartPoint| at.pos.y < 5.0 + 0.5 * (at.pos.z + 3.0);
        for (column, found_m) in (0..).zip(sill_m(slope, &leaf)) {
            let z = (0.2 * f64::from(column) - 1.0) * HALF_WIDTH_M;
            assert!((found_m - 0.5 * z).abs() < 0.02, "{column}: {found_m}");
        }
        assert_eq!(sill_m(|_| true, &leaf), [HEIGHT_M; Opening::SILLS]);
        assert_eq!(sill_m(|_| false, &leaf), [-BELOW_FOOT_M; Opening::SILLS]);
        let wall = |at: ChartPoint| at.pos.y < 5.0 + 2.0;
        assert!(sill_m(wall, &leaf).iter().all(|it| (it - 2.0).abs() < 0.02));
    }
}
