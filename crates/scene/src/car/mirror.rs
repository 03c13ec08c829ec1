//! The rear mirror over a driver's view shows the world behind the car, through the same lens.

use antipode_geometry::{Eye, Projection};

use super::tuning::{MIRROR_FOV_Y_RAD, MIRROR_M, MIRROR_UP_RAD};
use crate::frame::{Figure, View};
use crate::tuning::NEAR_M;
use glam::DVec3;

/// The view from a car's tail, its own body behind the eye. Left and right are those of a driver who looks back: a mirror swaps them
/// where it is shown. Width and height are the same until it is fitted to its place.
pub(crate) fn rear_view(picture: &View, car: &Figure) -> View {
    let point = car.point.moved(car.level.in_chart(car.turn * MIRROR_M));
    let back = car.turn * DVec3::NEG_X;
    let eye = Eye {
        point,
        yaw: back.z.atan2(back.x),
        pitch: back.y.clamp(-1.0, 1.0).asin() + MIRROR_UP_RAD,
        roll: 0.0,
        lift_m: point.pos.y - car.point.pos.y,
        ..picture.eye
    };
    View {
        eye,
        projection: Projection::new(MIRROR_FOV_Y_RAD, 1.0, NEAR_M),
        hand: None,
        shows_marks: false,
        ..picture.clone()
    }
}
