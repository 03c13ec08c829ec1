//! Finds places for a vehicle: sets it upright, puts it down on free ground, and frees it from ground that was built over it.

use antipode_geometry::ChartPoint;
use glam::{DQuat, DVec3};
use rapier3d::math::Pose;

use super::hull::Hull;
use super::{VehicleMotion, VehiclePhysics};
use crate::{ChartGround, PhysicsWorld};

/// How far up a free place is looked for, and in what steps, in metres.
const HIGHEST_M: f64 = 64.0;
const STEP_M: f64 = 0.1;
/// A vehicle that is set upright is first tried this far below where its middle is, in metres.
const MIDDLE_UP_M: f64 = 0.7;

impl VehiclePhysics {
    /// A vehicle upright at rest above a place, looking along a heading, as high up as it takes to
    /// be free of the ground; `inside` says whether a point of the chart is in solid ground. `None` when nothing within
    /// 64 m is.
    pub fn upright_at(
        &self,
        world: &PhysicsWorld,
        place: ChartPoint,
        heading: DVec3,
        inside: &dyn Fn(DVec3) -> bool,
    ) -> Option<VehicleMotion> {
        let level = heading.with_y(0.0).try_normalize().unwrap_or(DVec3::X);
        let turn = DQuat::from_rotation_y(-level.z.atan2(level.x));
        let steps = (HIGHEST_M / STEP_M) as u32;
        let ground = world.chart(place.chart);
        (0..=steps)
            .map(|step| place.moved(DVec3::Y * (f64::from(step) * STEP_M)))
            .find(|at| self.is_free(ground, at.pos, turn, inside))
            .map(|place| VehicleMotion::at(place, turn))
    }

    /// Where a vehicle comes to stand when it is set upright where it lies, keeping its heading.
    pub fn upright(
        &self,
        motion: &VehicleMotion,
        world: &PhysicsWorld,
        inside: &dyn Fn(DVec3) -> bool,
    ) -> Option<VehicleMotion> {
        // One that stands on its nose or tail looks where its roof does, or its floor.
        let ahead = motion.ahead();
        let heading = if ahead.with_y(0.0).length() > 0.2 {
            ahead
        } else {
            motion.up() * -ahead.y.signum()
        };
        let place = ChartPoint::new(motion.chart, motion.middle() - DVec3::Y * MIDDLE_UP_M);
        self.upright_at(world, place, heading, inside)
    }

    /// Whether no ground is in the box that holds a vehicle standing at `place`, nor is its middle inside ground.
    fn is_free(
        &self,
        ground: &ChartGround,
        place: DVec3,
        turn: DQuat,
        inside: &dyn Fn(DVec3) -> bool,
    ) -> bool {
        let middle = Hull::box_middle(place, turn);
        let at = (middle - ground.origin()).as_vec3();
        let pose = Pose::from_parts(at, turn.as_quat());
        let queries = ground.queries();
        let shape = self.hull.free_box.0.as_ref();
        let touched = queries.intersect_shape(pose, shape).next().is_some();
        !touched && !inside(middle)
    }
}
