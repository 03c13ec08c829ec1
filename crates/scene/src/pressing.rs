//! What bends leaves and grass in a picture: cars, and the feet of who walks. Nothing of it is part of the world.

use antipode_geometry::{ChartPoint, Eye};
use glam::DVec3;

use crate::camera::CameraMode;
use crate::frame::{Figure, Presser};
use crate::moment::{Taker, Who};
use crate::world::World;

/// What is farther from the eye than this bends nothing that anybody would see, metres of the chart.
const SEEN_M: f64 = 60.0;
/// From a car's middle to the end of the line from which it presses, how far that reaches, and how high, metres: all that is
/// under its floor and what its bumper is about to meet, up to its roof.
const CAR_HALF_M: f64 = 1.2;
const CAR_REACH_M: f64 = 1.7;
const CAR_HEIGHT_M: f64 = 2.6;
/// The same of feet. They leave grass half upright.
const FEET_REACH_M: f64 = 0.75;
const FEET_HEIGHT_M: f64 = 1.3;
const FEET_STRENGTH: f64 = 0.6;

/// What bends leaves and grass in a picture of these figures. Who sees it in first person is not among them, but stands there.
pub(crate) fn seen(
    world: &World,
    taker: Taker,
    eye: &Eye,
    figures: &[(Who, Figure)],
) -> Vec<Presser> {
    let is_near = |point: ChartPoint| {
        let carried = world.strategy.carry_near(point, eye.point);
        carried.is_some_and(|it| it.point.pos.distance(eye.point.pos) < SEEN_M)
    };
    let pressing = figures.iter().filter_map(|(who, figure)| match who {
        _ if !is_near(figure.point) => None,
        Who::Car(_) => Some(under_car(figure)),
        Who::Player { drives: None, .. } | Who::Bot { .. } => Some(under_feet(world, figure.point)),
        _ => None,
    });
    let own = match taker {
        Taker::Player {
            mode: CameraMode::First,
            drives: None,
            ..
        } => Some(eye.point.moved(DVec3::NEG_Y * eye.lift_m)),
        Taker::Player { .. } | Taker::Photographer => None,
    };
    let own = own.map(|feet| under_feet(world, feet));
    own.into_iter().chain(pressing).collect()
}

fn under_car(figure: &Figure) -> Presser {
    Presser {
        point: figure.point,
        along: figure.level.in_chart(figure.turn * DVec3::X * CAR_HALF_M),
        up: figure.turn * DVec3::Y,
        reach_m: CAR_REACH_M,
        height_m: CAR_HEIGHT_M,
        strength: 1.0,
    }
}

fn under_feet(world: &World, feet: ChartPoint) -> Presser {
    Presser {
        point: feet,
        along: DVec3::ZERO,
        up: world.ground.normal(feet).as_dvec3(),
        reach_m: FEET_REACH_M,
        height_m: FEET_HEIGHT_M,
        strength: FEET_STRENGTH,
    }
}
