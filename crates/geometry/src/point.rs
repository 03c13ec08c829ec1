//! A place in the world's charts, and the step from one chart to another.

use glam::{DQuat, DVec3};

use crate::ChartId;

/// A point in metres of a chart, from the chart's centre; y is up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ChartPoint {
    /// The chart that the position is written in.
    pub chart: ChartId,
    /// Position in metres.
    pub pos: DVec3,
}

impl ChartPoint {
    /// The point at `pos` metres in a chart.
    pub const fn new(chart: ChartId, pos: DVec3) -> Self {
        Self { chart, pos }
    }

    /// The point at `pos` metres in the first chart.
    pub const fn a(pos: DVec3) -> Self {
        Self::new(ChartId::FIRST, pos)
    }

    /// The point moved by `step_m` metres along the chart, without any crossing.
    #[must_use]
    pub fn moved(self, step_m: DVec3) -> Self {
        Self::new(self.chart, self.pos + step_m)
    }
}

/// A point written in another chart, and the turn that goes with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The same point of the space, in that chart.
    pub point: ChartPoint,
    /// Right-handed rotation about +y, as `Quat::from_rotation_y`, that every direction,
    /// velocity and orientation takes. A heading measured from x to z becomes
    /// `yaw - turn_rad`.
    pub turn_rad: f64,
}

impl Crossing {
    /// No crossing: a point stays where it is.
    pub const fn within(point: ChartPoint) -> Self {
        Self {
            point,
            turn_rad: 0.0,
        }
    }

    /// The turn as a quaternion, for orientations.
    pub fn rotation(&self) -> DQuat {
        DQuat::from_rotation_y(self.turn_rad)
    }

    /// A direction or velocity of the old chart in the new one.
    pub fn turn_vector(&self, vector: DVec3) -> DVec3 {
        self.rotation() * vector
    }
}
