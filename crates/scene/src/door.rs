//! Doors: a pair of frames that are put up like flags. What goes into one comes out of the other; a single one leads nowhere.
//!
//! The way through is `antipode_geometry::doorway`. Bodies go by it here, and the picks of the crosshair in `pick`. What has gone
//! through keeps its speed, its height over the ground and its way in the doorway's own axes. Doors stand upright, so the
//! view is level on the other side at once.

use antipode_geometry::{ChartPoint, Crossing, Doorway, Leaf, Passing};
use antipode_items::Item;
use glam::DVec3;

use crate::actors::Actors;
use crate::fixture::{self, Behaviour};
use crate::ground::height_below;
use crate::player::{Body, Look, Position, wrap_angle};
use crate::world::World;

/// Ground on the other side is looked for from so far above a foot, and so far below it, metres.
const STEP_UP_M: f64 = 1.2;
const STEP_DOWN_M: f64 = 1.6;

/// What stands in pairs.
pub(crate) struct Paired;

impl Behaviour for Paired {
    fn replaces_oldest(&self) -> bool {
        true
    }
}

/// The pair, the older leaf first, if both stand.
pub(crate) fn pair(actors: &Actors) -> Option<Doorway> {
    let leaves = fixture::map_of(actors, Item::Door, |_, it| Leaf {
        foot: it.foot.point,
        yaw: it.yaw_rad,
    });
    match leaves[..] {
        [older, newer] => Some(Doorway {
            leaves: [older, newer],
        }),
        _ => None,
    }
}

impl World {
    /// Where the way between two places goes through a door, and that door's pair.
    pub fn door_between(&self, from: ChartPoint, to: ChartPoint) -> Option<(&Doorway, Passing)> {
        let doors = self.doors.as_ref()?;
        let by = doors.met(&*self.strategy, from, to)?;
        Some((doors, by))
    }

    /// How somebody or something who went from one place to another is to be carried on, if the way led through a door. It
    /// goes on as high over the ground as before, where there is ground at hand.
    pub fn through_door(&self, from: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        let (doors, by) = self.door_between(from, to)?;
        let mut crossing = doors.pass(&*self.strategy, by, to)?;
        let over_m = |at: ChartPoint| {
            let above = at.moved(DVec3::Y * STEP_UP_M);
            let solid = |point: ChartPoint| self.ground.is_solid(point);
            height_below(above, STEP_UP_M + STEP_DOWN_M, solid).map(|y| at.pos.y - y)
        };
        if let (Some(here_m), Some(there_m)) = (over_m(to), over_m(crossing.point)) {
            crossing.point.pos.y += here_m - there_m;
        }
        Some(crossing)
    }
}

/// Carries a body on whose way led through a door; returns whether it did.
pub(crate) fn pass(
    world: &World,
    before: ChartPoint,
    position: &mut Position,
    look: &mut Look,
    body: &mut Body,
) -> bool {
    let Some(crossing) = world.through_door(before, position.0) else {
        return false;
    };
    position.0 = crossing.point;
    body.0.feet = crossing.point.pos;
    look.yaw = wrap_angle(look.yaw - crossing.turn_rad);
    body.0.velocity = crossing.turn_vector(body.0.velocity);
    true
}
