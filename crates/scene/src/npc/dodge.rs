//! Out of the way of cars: fear before all other fear, for those who fight as for those who do not.

use antipode_geometry::ChartPoint;
use glam::DVec3;

use super::choice::at_pace;
use super::figure::Npc;
use super::mind::State;
use super::senses::Around;
use super::tuning::{DODGES_BY_M, DODGES_S, FLEE_PACE};
use crate::car::CarView;
use crate::pick::over;

/// Half the width of the way that a car takes, with the room that one wants beside it, in metres.
const HALF_WAY_M: f64 = 1.9;
/// From the middle of a car to its ends, in metres.
const HALF_CAR_M: f64 = 2.0;
/// A car farther above or below than this drives elsewhere, in metres.
const LEVEL_M: f64 = 4.0;
/// Slower than this a car without a driver does not come, in m/s; one with a driver may at any time.
const ROLLS_M_S: f64 = 2.0;

impl CarView {
    /// The level way that it takes, m/s; `None` where nobody need fear it.
    pub(crate) fn comes(&self) -> Option<DVec3> {
        let velocity = self.velocity.with_y(0.0);
        let speed_m_s = velocity.length();
        match (speed_m_s > ROLLS_M_S, self.driven) {
            (true, _) => Some(velocity),
            (false, true) => {
                let ahead = (self.turn * DVec3::X).with_y(0.0);
                Some(ahead.normalize_or_zero() * ROLLS_M_S)
            }
            (false, false) => None,
        }
    }
}

impl Npc<'_> {
    /// Runs out of the way of a car that comes; whether one does.
    pub(super) fn dodges(&mut self, around: &Around<'_>) -> bool {
        let spot = around
            .cars
            .iter()
            .find_map(|(car, way)| self.way_out(around, car, *way));
        let Some(spot) = spot else { return false };
        self.mind.enter(State::Aside);
        self.mind.face = None;
        self.mind.follow(at_pace(spot, FLEE_PACE));
        true
    }

    /// A place beside a car's way for a figure that stands in it. Near the equator the chart of the car is good enough: it is off
    /// by parts in a hundred over such distances, and nobody runs so exactly.
    fn way_out(&self, around: &Around<'_>, car: &CarView, way: DVec3) -> Option<ChartPoint> {
        let strategy = around.strategy();
        let own = over(strategy, car.point, self.position.0);
        let off = own.pos - car.point.pos;
        let (speed_m_s, ahead) = (way.length(), way.normalize_or_zero());
        let along_m = off.dot(ahead);
        let aside = off.with_y(0.0) - ahead * along_m;
        let is_before = (-HALF_CAR_M..speed_m_s * DODGES_S + 2.0 * HALF_CAR_M).contains(&along_m);
        if !is_before || aside.length() > HALF_WAY_M || off.y.abs() > LEVEL_M {
            return None;
        }
        let right = DVec3::new(-ahead.z, 0.0, ahead.x);
        let side = aside.try_normalize().unwrap_or(right * self.mind.side);
        let spot = own.moved(side * DODGES_BY_M);
        Some(strategy.cross(spot).map_or(spot, |over| over.point))
    }
}
