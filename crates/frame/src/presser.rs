//! What presses down and aside what grows about it.

use antipode_geometry::{ChartPoint, Crossing};
use glam::DVec3;

/// A car or feet among leaves and blades, which bend away from the line between its ends and down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Presser {
    /// The middle of where it touches the ground.
    pub point: ChartPoint,
    /// From there to its front end, and as far back to its other one: metres of the chart, nothing of feet.
    pub along: DVec3,
    /// Away from the ground, a unit vector of the chart.
    pub up: DVec3,
    /// How far from its line it presses, metres: half of that with all of its strength.
    pub reach_m: f64,
    /// What is higher over its ground than this it leaves alone, metres.
    pub height_m: f64,
    /// Which share of the way down to the ground it presses, 0 to 1.
    pub strength: f64,
}

impl Presser {
    /// The same in another chart.
    #[must_use]
    pub fn carried(&self, crossing: &Crossing) -> Self {
        Self {
            point: crossing.point,
            along: crossing.turn_vector(self.along),
            up: crossing.turn_vector(self.up),
            ..*self
        }
    }
}
