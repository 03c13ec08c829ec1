//! The camera behind somebody who has gone through a door: its arm leads back through the opening.
//!
//! A camera is placed as if there were no doors, in the chart of whom it follows. If whom it follows would be seen through a leaf
//! from there, the arm goes into that leaf: what is beyond it lies on the other side, and so does the ground that it meets.

use antipode_geometry::doorway::{HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{ChartPoint, Doorway, Eye};
use antipode_physics::PhysicsWorld;
use glam::DVec3;

use crate::aimed::ViewParams;
use crate::camera::CameraPose;
use crate::pick::over;
use crate::tuning::CAMERA_RADIUS_M;
use crate::world::World;

/// Whom a camera follows is seen so far below the lintel at least, metres.
const BELOW_LINTEL_M: f64 = 0.12;

/// A camera in the frame of a door would see nothing else: so near to a leaf, and so far aside of its middle, metres, it is lowered
/// from heights at which the lintel is, and what is on top of it.
const AT_LEAF_M: f64 = 0.6;
const ASIDE_M: f64 = HALF_WIDTH_M + 0.35;
const OVER_LINTEL_M: f64 = 0.6;

/// Whom a camera follows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Followed {
    /// What decides through what it is seen: its middle.
    pub middle: ChartPoint,
    /// What is to be seen below the lintel besides.
    pub top: ChartPoint,
}

/// Leads a camera's arm through the door that is between it and whom it follows, if there is one. `pose` is kept from ground that
/// lies behind the leaf, `free` is the eye as it would be without any.
pub(crate) fn lead_through(
    world: &World,
    params: &ViewParams,
    followed: &Followed,
    free: Eye,
    pose: &mut CameraPose,
) {
    let Some((doors, by)) = world.door_between(followed.middle, free.point) else {
        keep_from_frames(world, pose);
        return;
    };
    let space = &*world.strategy;
    let leaf = &doors.leaves[by.leaf];
    let local = |point: ChartPoint| leaf.local(over(space, leaf.foot, point).pos);
    let (from, top, wished) = (
        local(followed.middle),
        local(followed.top),
        local(free.point),
    );
    let end = DVec3 {
        y: wished.y.min(highest_m(top, wished)),
        ..wished
    };
    let at_leaf = from.lerp(end, from.x / (from.x - end.x));
    let placed = |local: DVec3| over(space, pose.eye.point, leaf.place(local));
    let led = Led {
        doors,
        leaf: by.leaf,
        params,
    };
    let way = end - at_leaf;
    let seen_by = Eye {
        point: placed(end),
        ..free
    };
    let share = led.free_share(&world.physics, &seen_by, placed(at_leaf));
    let point = placed(at_leaf + way * share);
    pose.eye = Eye {
        lift_m: free.lift_m + point.pos.y - free.point.pos.y,
        point,
        ..free
    };
    pose.through = Some(by.leaf);
}

/// Lowers a camera that has just come through a door, or stands at one, out of its lintel.
fn keep_from_frames(world: &World, pose: &mut CameraPose) {
    let Some(doors) = &world.doors else {
        return;
    };
    let eye = &mut pose.eye;
    for leaf in &doors.leaves {
        let there = over(&*world.strategy, leaf.foot, eye.point);
        if there.chart == leaf.foot.chart {
            let lower_m = below_lintel_m(leaf.local(there.pos));
            eye.point.pos.y -= lower_m;
            eye.lift_m -= lower_m;
        }
    }
}

/// By how much a camera at a place of a leaf's axes is to be lowered, metres: to as high as it comes through, the less the farther
/// it is from the leaf.
fn below_lintel_m(at: DVec3) -> f64 {
    let share = at.x.abs() / AT_LEAF_M;
    let lintel_m = HEIGHT_M + OVER_LINTEL_M;
    if share >= 1.0 || at.z.abs() > ASIDE_M || at.y > lintel_m {
        return 0.0;
    }
    let through_m = HEIGHT_M - BELOW_LINTEL_M;
    (at.y - (through_m + share.powi(2) * (lintel_m - through_m))).max(0.0)
}

/// How high over a leaf's foot an eye may be that is to see a place below the lintel, metres. Both are in the leaf's axes, on
/// either side of it: the line between them meets the leaf at the share t = a/(a - e) of it, at the height
/// `a.y + t (e.y - a.y)`.
fn highest_m(seen: DVec3, eye: DVec3) -> f64 {
    let share = seen.x / (seen.x - eye.x);
    let room_m = HEIGHT_M - BELOW_LINTEL_M - seen.y;
    if share > 0.0 && room_m > 0.0 {
        seen.y + room_m / share
    } else {
        f64::INFINITY
    }
}

/// An arm that goes into a leaf.
struct Led<'a> {
    doors: &'a Doorway,
    leaf: usize,
    params: &'a ViewParams,
}

impl Led<'_> {
    /// The share of the way from a place of the leaf to an eye behind it that a small sphere finds free on the other side.
    fn free_share(&self, physics: &PhysicsWorld, eye: &Eye, from: ChartPoint) -> f64 {
        let space = &*self.params.strategy;
        let taken = |point| self.doors.pictured(space, self.leaf, eye, point);
        let start = taken(from);
        let way = over(space, start, taken(eye.point)).pos - start.pos;
        let length_m = way.length();
        if length_m < CAMERA_RADIUS_M {
            return 1.0;
        }
        physics
            .chart(start.chart)
            .cast_sphere(start.pos, way / length_m, CAMERA_RADIUS_M, length_m)
            .map_or(1.0, |free_m| (free_m / length_m).clamp(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_that_comes_out_of_a_door_is_in_no_part_of_its_frame() {
        // The frame reaches 0.13 m before the leaf, and from 2.2 m to 2.43 m.
        for step in 0..=70 {
            let at = DVec3::new(0.01 * f64::from(step), 2.45, 0.3);
            let y = at.y - below_lintel_m(at);
            assert!(at.x > 0.15 || y < HEIGHT_M - 0.05, "{at} {y}");
            assert!(at.x > 0.0 || (y - (HEIGHT_M - BELOW_LINTEL_M)).abs() < 1e-9);
            assert!(at.x < AT_LEAF_M || y == at.y);
        }
        assert_eq!(below_lintel_m(DVec3::new(0.0, 3.5, 0.0)), 0.0);
        assert_eq!(below_lintel_m(DVec3::new(0.0, 2.4, 2.0)), 0.0);
        assert_eq!(below_lintel_m(DVec3::new(0.0, 1.7, 0.0)), 0.0);
    }

    #[test]
    fn the_highest_eye_sees_what_it_is_to_see_right_below_the_lintel() {
        let (head, eye) = (DVec3::new(1.5, 1.6, 0.0), DVec3::new(-3.5, 9.0, 0.2));
        let eye = eye.with_y(highest_m(head, eye));
        let at_leaf = head.lerp(eye, head.x / (head.x - eye.x));
        assert!((at_leaf.y - (HEIGHT_M - BELOW_LINTEL_M)).abs() < 1e-12);
        assert_eq!(highest_m(head.with_y(2.5), eye), f64::INFINITY);
    }
}
