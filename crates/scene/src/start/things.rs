//! What stands in a view: somebody and a car, where they are seen.

use std::f64::consts::PI;

use antipode_geometry::{ChartPoint, Eye, Projection};
use glam::{DVec2, DVec3};

use super::obstacles::Obstacles;
use super::{STEEPEST_M, Search, Spot};
use crate::npc::way_to;
use crate::player;
use crate::tuning::{ASPECT, NEAR_M};

/// Of the survey's places along a ray, where a figure and where a car can be made out.
const FIGURE_AT: std::ops::Range<usize> = 1..5;
const CAR_AT: std::ops::Range<usize> = 2..7;
/// Where in the picture things are to be, in halves of its width and height: the display is at its edges, and what is in
/// hand covers what lies to the right of and below a place.
const WITHIN: DVec2 = DVec2::new(0.8, 0.7);
const HAND: DVec2 = DVec2::new(0.1, -0.05);
/// Bearings between car and figure, at least, in rays.
const APART_RAYS: i32 = 2;
/// Half of the rectangle that a car stands on, in metres, how far its ground may rise, and what is to be seen of it over
/// the ground.
const CAR_M: DVec2 = DVec2::new(1.9, 0.9);
const CAR_RISE_M: f64 = 0.7;
const CAR_SEEN_M: f64 = 1.0;
/// What is to be seen of a figure over the ground, in metres.
const FIGURE_SEEN_M: f64 = 0.9;
/// How far from what grows a figure and a car stand, so that both can go on, metres.
const FIGURE_ROOM_M: f64 = 1.0;
const CAR_ROOM_M: f64 = 3.0;
/// Steps of a line of sight, in metres.
const SIGHT_STEP_M: f64 = 0.4;

impl Search<'_> {
    /// Somebody who is seen, and the way he looks at the player.
    pub(super) fn figure(
        &self,
        eye: &Eye,
        feet: ChartPoint,
        spots: &[Spot],
        obstacles: &Obstacles,
    ) -> Option<(Spot, f64)> {
        let fits = |spot: &&Spot| {
            FIGURE_AT.contains(&spot.ring)
                && spot.ray != 0
                && obstacles.shows(spot.ground, FIGURE_ROOM_M)
                && self.is_seen(eye, spot.ground, FIGURE_SEEN_M)
                && self.is_seen(eye, spot.ground, 2.0 * FIGURE_SEEN_M)
                && self.spread_m(spot.ground, DVec2::splat(0.5), 0.0) < STEEPEST_M
        };
        let spot = spots.iter().find(fits)?;
        let back = way_to(self.strategy(), spot.ground, feet);
        Some((*spot, back.z.atan2(back.x)))
    }

    /// A car that is seen from its side.
    pub(super) fn car(
        &self,
        eye: &Eye,
        yaw: f64,
        spots: &[Spot],
        obstacles: &Obstacles,
        figure: Option<i32>,
    ) -> Option<(ChartPoint, f64)> {
        let heading = player::wrap_angle(yaw + 0.3 * PI);
        let fits = |spot: &&Spot| {
            CAR_AT.contains(&spot.ring)
                && obstacles.leave(spot.ground, CAR_ROOM_M)
                && obstacles.let_drive(spot.ground, heading)
                && figure.is_none_or(|ray| (ray - spot.ray).abs() >= APART_RAYS)
                && self.is_seen(eye, spot.ground, CAR_SEEN_M)
                && self.spread_m(spot.ground, CAR_M, heading) < CAR_RISE_M
        };
        let spot = spots.iter().rev().find(fits)?;
        Some((spot.ground, heading))
    }

    /// Whether a place so far over the ground is in the picture, and no ground before it.
    fn is_seen(&self, eye: &Eye, ground: ChartPoint, over_m: f64) -> bool {
        let strategy = &**self.lens.strategy();
        let place = ground.moved(DVec3::Y * over_m);
        let view = strategy.view_point(eye, place);
        let projection = Projection::new(self.fov_y_rad, ASPECT, NEAR_M);
        let x = projection.sx * view.x / -view.z;
        let y = projection.sy * view.y / -view.z;
        if view.z >= 0.0 || x.abs() > WITHIN.x || y.abs() > WITHIN.y {
            return false;
        }
        if x > HAND.x && y < HAND.y {
            return false;
        }
        let away_m = strategy.eye_distance_m(eye, view);
        let direction = view.truncate().normalize_or_zero();
        let steps = (away_m / SIGHT_STEP_M).ceil() as u32;
        (1..steps).all(|step| {
            let at = strategy.along(eye, direction, f64::from(step) * SIGHT_STEP_M);
            self.field.sample(at) > 0.0
        })
    }
}
