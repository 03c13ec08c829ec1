//! Similarities between the charts of bodies.
//!
//! The chart of a body is that of the boxes that it is in: a place x of the scene is y = A x there, A = K^-1, so lengths are felt
//! metres and no body is ever squeezed. A portal of map G = q K2 O A1 takes charts to each other by y2 = q O y1 + t, since
//! A2 (q K2 O A1) K1 = q O: it turns and scales, and that is all. Across a face w stays, so that charts differ by a shift there:
//! who goes from x by A1 (f - x) to the face and by A2 (z - f) on has y2 - y1 = (A2 - A1) f.

use antipode_deformation::PlacedPortal;
use antipode_physics::LooseMotion;
use glam::{DMat3, DQuat, DVec3};

/// How near two frames are that are the same: of their turns, scales and shifts.
const ALIKE: f64 = 1e-6;

/// y -> scale turn y + shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    pub turn: DQuat,
    pub scale: f64,
    pub shift: DVec3,
}

impl Default for Frame {
    fn default() -> Self {
        Self::shifted(DVec3::ZERO)
    }
}

impl Frame {
    /// Without turn and scale.
    pub fn shifted(shift: DVec3) -> Self {
        Self {
            turn: DQuat::IDENTITY,
            scale: 1.0,
            shift,
        }
    }

    /// From the chart before a portal to that behind it.
    pub fn through(portal: &PlacedPortal, partner: &PlacedPortal) -> Self {
        let before = portal.squeeze.inverse() * portal.portal.at;
        let behind = partner.squeeze.inverse() * partner.portal.at;
        Self {
            turn: portal.turn,
            scale: portal.scale,
            shift: behind - portal.scale * (portal.turn * before),
        }
    }

    /// From the chart of boxes of product `k1` to that of `k2`, who go through the face at `face`, metres of the scene.
    pub fn across(k1: &DMat3, k2: &DMat3, face: DVec3) -> Self {
        Self::shifted((k2.inverse() - k1.inverse()) * face)
    }

    /// A place.
    pub fn place(&self, y: DVec3) -> DVec3 {
        self.scale * (self.turn * y) + self.shift
    }

    /// A displacement or a velocity.
    pub fn way(&self, v: DVec3) -> DVec3 {
        self.scale * (self.turn * v)
    }

    /// The displacement that becomes this one.
    pub fn way_back(&self, v: DVec3) -> DVec3 {
        self.turn.inverse() * v / self.scale
    }

    /// First `other`, then this.
    pub fn after(&self, other: &Self) -> Self {
        Self {
            turn: (self.turn * other.turn).normalize(),
            scale: self.scale * other.scale,
            shift: self.place(other.shift),
        }
    }

    /// The way back.
    pub fn inverse(&self) -> Self {
        let turn = self.turn.inverse();
        let scale = self.scale.recip();
        Self {
            turn,
            scale,
            shift: -scale * (turn * self.shift),
        }
    }

    /// Whether both are the same to rounding.
    pub fn is_like(&self, other: &Self) -> bool {
        let turned = 1.0 - self.turn.dot(other.turn).abs();
        let far = self.shift.abs().max_element().max(1.0);
        turned < ALIKE
            && (self.scale / other.scale - 1.0).abs() < ALIKE
            && self.shift.distance(other.shift) < ALIKE * far
    }

    /// How something moves, that moves so in the chart.
    pub fn motion(&self, it: &LooseMotion) -> LooseMotion {
        LooseMotion {
            place: self.place(it.place),
            turn: self.turn * it.turn,
            velocity: self.way(it.velocity),
            spin: self.turn * it.spin,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back_is_nowhere() {
        let turn = DQuat::from_scaled_axis(DVec3::new(0.3, -1.1, 0.4));
        let (scale, shift) = (2.5, DVec3::new(4.0, -3.0, 8.0));
        let frame = Frame { turn, scale, shift };
        let y = DVec3::new(-1.0, 2.0, 0.5);
        assert!(frame.inverse().place(frame.place(y)).distance(y) < 1e-12);
        assert!(frame.inverse().after(&frame).is_like(&Frame::default()));
        assert!(frame.way_back(frame.way(y)).distance(y) < 1e-12);
    }
}
