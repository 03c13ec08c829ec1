//! The shapes by which things are hit and stand on the ground, to be drawn as outlines.

use antipode_geometry::ChartPoint;
use glam::{DQuat, DVec3};

/// What kind of shape, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HitForm {
    /// An upright capsule, about the middle of its foot.
    Capsule {
        /// From foot to crown, metres; at least twice the radius.
        height_m: f64,
        /// Radius, metres.
        radius_m: f64,
    },
    /// A ball about its middle.
    Ball {
        /// Radius, metres.
        radius_m: f64,
    },
    /// A box about its middle.
    Box {
        /// Half of its sides, metres.
        half_m: DVec3,
    },
}

/// A shape in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitShape {
    /// Kind and size.
    pub form: HitForm,
    /// Where it is.
    pub point: ChartPoint,
    /// How it is turned in the chart.
    pub turn: DQuat,
    /// Whether it moves: what rests, or waits for the ground below it, does not.
    pub awake: bool,
}

impl HitShape {
    /// One that stands upright.
    pub fn upright(form: HitForm, point: ChartPoint, awake: bool) -> Self {
        Self {
            form,
            point,
            turn: DQuat::IDENTITY,
            awake,
        }
    }
}
