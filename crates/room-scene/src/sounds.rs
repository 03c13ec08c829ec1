//! What is heard in a room: who walks, and what is loose. Sounds come straight, whatever stands between, or by one portal.

use antipode_deformation::{Place, PlacedPortal};
use glam::DVec3;

use crate::scene::RoomScene;

/// Slower falls, felt metres a second, are steps.
const LANDING_FROM_M_S: f64 = 2.5;
/// The most that is kept for a host that never asks, such as a script.
const MOST: usize = 64;

/// Something that is heard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RoomSound {
    /// A foot came down, of who goes at that felt speed, metres a second.
    Step(f64),
    /// A fall ended that was so fast, felt metres a second.
    Landed(f64),
    /// The gun was fired.
    Shot,
    /// Something loose met something, and changed its felt speed by so much, metres a second; less of what is farther off.
    Knocked(f64),
}

/// Softer blows are not heard, metres a second.
const KNOCK_FROM_M_S: f64 = 1.0;
/// A blow so far off, metres of the size of who hears it, is half as loud.
const HALF_AS_LOUD_M: f64 = 4.0;
/// Blows are heard so far apart, seconds.
const KNOCKS_APART_S: f64 = 0.08;

impl RoomScene {
    /// What there was to hear since it was last asked.
    pub fn take_sounds(&mut self) -> Vec<RoomSound> {
        std::mem::take(&mut self.sounds)
    }

    pub(crate) fn sound(&mut self, sound: RoomSound) {
        if self.sounds.len() < MOST {
            self.sounds.push(sound);
        }
    }

    /// Tells of the loudest blow that something loose had in a step.
    pub(crate) fn hear_knocks(&mut self) {
        if self.time_s - self.knocked_s < KNOCKS_APART_S {
            return;
        }
        let loud = |(place, speed): (Place, f64)| {
            speed / (1.0 + self.hears_from_m(&place) / HALF_AS_LOUD_M)
        };
        let loudest = self.bodies.blows().map(loud).fold(0.0, f64::max);
        if loudest > KNOCK_FROM_M_S {
            self.knocked_s = self.time_s;
            self.sound(RoomSound::Knocked(loudest));
        }
    }

    /// How far off who walks hears something, metres of their own size: by the shortest of the straight way and those to the middle
    /// of a portal and on from its partner's, where they would be as much larger as it makes them.
    fn hears_from_m(&self, place: &Place) -> f64 {
        let ear = self.walker.body.place;
        let straight = place.point.distance(ear.point) / ear.scale;
        let portals = self.space.portals();
        let through = |portal: &PlacedPortal| {
            let beyond = portals[portal.portal.to].portal.at.distance(place.point) / portal.scale;
            (ear.point.distance(portal.portal.at) + beyond) / ear.scale
        };
        portals.iter().map(through).fold(straight, f64::min)
    }

    /// Tells what the body did in a step: whether a foot came down, and how fast it fell before.
    pub(crate) fn hear_body(&mut self, foot_down: bool, falls_m_s: f64, up: DVec3) {
        if !self.walker.grounded {
            return;
        }
        let pace_m_s = self
            .walker
            .body
            .velocity
            .reject_from_normalized(up)
            .length();
        if falls_m_s >= LANDING_FROM_M_S {
            self.sound(RoomSound::Landed(falls_m_s));
        } else if foot_down {
            self.sound(RoomSound::Step(pace_m_s));
        }
    }
}
