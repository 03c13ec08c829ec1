//! How a body gets on: rapier says how far and how turned, `trace` where to.

use antipode_deformation::{EventKind, Trace, Traveller, trace};
use antipode_physics::LooseMotion;
use glam::{DQuat, DVec3};

use super::{Around, Body, HEADING_FROM_M_S};
use crate::tuning::TERMINAL_SPEED_M_S;

/// Of its way to something that its middle would go through, a body goes this share.
const SHORT: f64 = 0.98;

impl Body {
    /// Takes up how rapier has moved it in `time` seconds; by how much its felt speed was changed by what it met.
    pub fn go(&mut self, motion: &LooseMotion, around: &Around<'_>, time: f64) -> f64 {
        let scale = self.place.scale;
        let from = self.laid.unwrap_or(motion.place);
        let own = self.frame.way_back(motion.place - from) / scale;
        let back = self.frame.turn.inverse();
        let before = self.velocity;
        let falls = self.falls(around.g);
        self.velocity = self.frame.way_back(motion.velocity) / scale + falls * (0.5 * time);
        let struck = (self.velocity - before - falls * time).length();
        self.turn = (back * motion.turn).normalize();
        self.spin = back * motion.spin;
        self.laid = Some(motion.place);
        self.carry(own, around);
        self.velocity = self.velocity.clamp_length_max(TERMINAL_SPEED_M_S);
        struck
    }

    /// Goes so far, felt metres of its own size in its own axes.
    fn carry(&mut self, own: DVec3, around: &Around<'_>) {
        let length = own.length();
        if length <= 0.0 {
            return;
        }
        let (start, out) = (self.place, self.out());
        let way = |length: f64| {
            let w = own.normalize();
            trace(
                around.space,
                &start,
                w,
                length,
                around.solids,
                &Traveller::Body,
            )
        };
        let mut path = way(length);
        let hit = path.hit().copied();
        if let Some(hit) = hit {
            // Its middle goes through nothing.
            path = way(SHORT * path.length);
            let into = self.velocity.dot(hit.felt_normal).min(0.0);
            self.velocity -= into * hit.felt_normal;
        } else if path.events.is_empty() {
            self.place.point = start.point + out * own;
            self.look_ahead(around);
            return;
        }
        self.place = path.place;
        if hit.is_none() && !has_passed(&path) {
            // The clock of a step that meets a face is set by the energy: |u|^2/2 - g.x/m is what it would be without.
            let gain = around.g.dot(path.place.point - start.point - out * own) / start.scale;
            let square = self.velocity.length_squared() + 2.0 * gain;
            self.velocity = self.velocity.normalize_or_zero() * square.max(0.0).sqrt();
        }
        self.straighten();
        self.laid = None;
        self.look_ahead(around);
    }

    /// Takes the axes of the scene for its own again.
    fn straighten(&mut self) {
        let turn: DQuat = self.place.straighten();
        self.turn = (turn * self.turn).normalize();
        self.velocity = turn * self.velocity;
        self.spin = turn * self.spin;
    }

    /// Boxes of one way are felt by how it goes.
    fn look_ahead(&mut self, around: &Around<'_>) {
        if self.laid.is_some() && self.velocity.length() < HEADING_FROM_M_S {
            return;
        }
        let squeeze = around
            .space
            .squeeze(&self.place.stack, self.velocity, &Traveller::Body);
        if squeeze != self.squeeze {
            self.squeeze = squeeze;
            self.laid = None;
        }
    }
}

fn has_passed(path: &Trace) -> bool {
    path.events.iter().any(|it| it.kind == EventKind::Passed)
}
