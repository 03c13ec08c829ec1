//! The state and the input of a vehicle: plain data.
//!
//! Where bodies do not move in the chart, a vehicle's place is one of the chart, and how it is turned, its velocity and its spin are told in metres of
//! the space along the frame of the chart there.

use antipode_geometry::{ChartId, ChartPoint, Crossing};
use glam::{DQuat, DVec3};

use super::hull::Hull;

/// Where a vehicle is and how it moves, all in one chart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VehicleMotion {
    /// The chart.
    pub chart: ChartId,
    /// The ground below its middle, when it stands on level ground (m).
    pub place: DVec3,
    /// How it is turned from looking along +x with its right-hand side at +z.
    pub turn: DQuat,
    /// Velocity of its centre of mass over the last step, m/s.
    pub velocity: DVec3,
    /// Angular velocity, rad/s.
    pub spin: DVec3,
}

impl VehicleMotion {
    /// At rest at a place, turned so.
    pub fn at(place: ChartPoint, turn: DQuat) -> Self {
        Self {
            chart: place.chart,
            place: place.pos,
            turn,
            ..Self::default()
        }
    }

    /// The same in another chart: how it stands, its velocity and its spin are turned.
    #[must_use]
    pub fn carried(&self, crossing: &Crossing) -> Self {
        let turn = crossing.rotation();
        Self {
            chart: crossing.point.chart,
            place: crossing.point.pos,
            turn: (turn * self.turn).normalize(),
            velocity: turn * self.velocity,
            spin: turn * self.spin,
        }
    }

    /// The same at rest.
    pub(super) fn stopped(self) -> Self {
        Self {
            velocity: DVec3::ZERO,
            spin: DVec3::ZERO,
            ..self
        }
    }

    /// The ground below its middle, when it stands on level ground.
    pub fn point(&self) -> ChartPoint {
        ChartPoint::new(self.chart, self.place)
    }

    /// Where it looks, a unit vector.
    pub fn ahead(&self) -> DVec3 {
        self.turn * DVec3::X
    }

    /// Its own upward direction, a unit vector.
    pub fn up(&self) -> DVec3 {
        self.turn * DVec3::Y
    }

    /// The middle of its body, in metres of the chart.
    pub fn middle(&self) -> DVec3 {
        Hull::box_middle(self.place, self.turn)
    }

    /// Speed ahead, m/s; backwards negative.
    pub fn speed_m_s(&self) -> f64 {
        self.velocity.dot(self.ahead())
    }
}

/// What a driver wants of a vehicle for one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VehicleInput {
    /// Ahead, or backwards where negative, -1 to 1. Against the way it rolls it brakes first.
    pub throttle: f64,
    /// To the right, or to the left where negative, -1 to 1.
    pub steer: f64,
    /// Brake.
    pub brake: bool,
    /// Drive harder.
    pub boost: bool,
    /// Nobody drives: it is held by its brake, and may fall asleep.
    pub parked: bool,
}

/// A wheel of a vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VehicleWheel {
    /// Its hub, in the vehicle's axes (m).
    pub hub: DVec3,
    /// How far it is steered to the right, radians.
    pub steer_rad: f64,
    /// How far it has rolled ahead, radians within one turn.
    pub roll_rad: f64,
    /// Whether it is on the ground.
    pub contact: bool,
    /// How far its spring is pushed in (m); zero in the air.
    pub compression_m: f64,
    /// How fast the tyre slides sideways over the ground, m/s.
    pub slide_m_s: f64,
}

impl VehicleMotion {
    /// Whether all of it are numbers.
    pub(super) fn is_finite(&self) -> bool {
        self.place.is_finite()
            && self.turn.is_finite()
            && self.velocity.is_finite()
            && self.spin.is_finite()
            && self.turn != DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)
    }
}
