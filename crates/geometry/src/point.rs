//! A place in the world's charts, and the step from one chart to the other.

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

use crate::Hemisphere;

/// A point in chart metres, local to the hemisphere's centre; y is up.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ChartPoint {
    /// The chart the position is written in; `A` in flat and hyperbolic worlds.
    pub hemisphere: Hemisphere,
    /// Position in metres.
    pub pos: DVec3,
}

impl ChartPoint {
    /// The point at `pos` metres in the chart of `hemisphere`.
    pub const fn new(hemisphere: Hemisphere, pos: DVec3) -> Self {
        Self { hemisphere, pos }
    }

    /// The point at `pos` metres in chart A.
    pub const fn a(pos: DVec3) -> Self {
        Self::new(Hemisphere::A, pos)
    }

    /// The point moved by `step_m` metres along the chart, without any crossing.
    #[must_use]
    pub fn moved(self, step_m: DVec3) -> Self {
        Self::new(self.hemisphere, self.pos + step_m)
    }
}

/// A point written in the other hemisphere's chart, and the turn that goes with it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Crossing {
    /// The same point of the space, in the other chart.
    pub point: ChartPoint,
    /// Right-handed rotation about +y, as `Quat::from_rotation_y`, that every direction,
    /// velocity and orientation takes. A heading measured from x to z becomes
    /// `yaw - turn_rad`.
    pub turn_rad: f64,
}

impl Crossing {
    /// The turn as a quaternion, for orientations.
    pub fn rotation(&self) -> DQuat {
        DQuat::from_rotation_y(self.turn_rad)
    }

    /// A direction or velocity of the old chart in the new one.
    pub fn turn_vector(&self, vector: DVec3) -> DVec3 {
        self.rotation() * vector
    }
}
