//! Shared by walking and flying: which contacts are ground, and where the floor is.
//!
//! The controller advances in parts of at most half the capsule's radius and then leaves whatever it
//! overlaps, deepest contact first, by exact distances. That cannot tunnel (the axis never crosses
//! a triangle within a part) and cannot catch on the inner edges of a mesh (once the face under the
//! feet is left, its neighbours are only touched), which is where casts of the whole capsule stop.

use glam::DVec3;

use crate::CharacterTuning;
use crate::patch::{Capsule, Contact, Patch};

/// Contacts shallower than this (m) are touches and are left alone.
pub(crate) const TOUCH_M: f64 = 1e-4;

/// A ball must be at least this much above the edge of a walkable face to be carried by it.
const LEAST_LIP_UP: f64 = 0.02;

/// A capsule, the terrain around it and the rules of one character.
pub(crate) struct Mover<'a> {
    pub patch: Patch,
    pub capsule: Capsule,
    pub tuning: &'a CharacterTuning,
    least_up: f64,
}

impl<'a> Mover<'a> {
    /// A mover of a capsule of the tuning's size through a patch of ground.
    pub fn new(patch: Patch, tuning: &'a CharacterTuning) -> Self {
        let capsule = Capsule::new(tuning.height_m, tuning.radius_m);
        Self {
            patch,
            capsule,
            tuning,
            least_up: tuning.max_slope_rad.cos(),
        }
    }

    /// Into how many parts a displacement is cut.
    pub fn parts(&self, displacement: DVec3) -> usize {
        (displacement.length() / (0.5 * self.capsule.radius_m))
            .ceil()
            .clamp(1.0, 256.0) as usize
    }

    /// Whether a contact carries: its own direction is gentle enough, as on a ridge, or it is the lip
    /// of a walkable face under the lower ball, as on a step.
    pub fn carries(&self, normal_up: f64, face_up: f64, least_lip_up: f64) -> bool {
        normal_up >= self.least_up || (face_up >= self.least_up && normal_up > least_lip_up)
    }

    /// The height at which the feet stand over `at`, no more than `up` above and `down` below
    /// `from_y`, carried at points that are no higher than a step.
    pub fn floor(&self, at: DVec3, from_y: f64, up: f64, down: f64) -> Option<f64> {
        let radius = self.capsule.radius_m;
        let touch = self.patch.highest_touch(at, radius, |touch, triangle| {
            let feet_y = touch.centre_y - radius;
            let normal_up = (touch.centre_y - touch.contact_y) / radius;
            feet_y >= from_y - down
                && touch.contact_y <= from_y + up
                && self.carries(normal_up, triangle.normal.y, LEAST_LIP_UP)
        })?;
        Some(touch.centre_y - radius)
    }

    /// The deepest overlap with the feet at `feet`. Whatever the floor could carry is only touched
    /// there, so this is a wall, a ceiling, or a lip too high for a step.
    pub fn overlap(&self, feet: DVec3) -> Option<Contact> {
        self.patch.deepest(&self.capsule, feet, TOUCH_M)
    }
}

/// Removes from `motion` the part that goes against `normal`.
pub(crate) fn clip(motion: DVec3, normal: DVec3) -> DVec3 {
    motion - normal * motion.dot(normal).min(0.0)
}

/// The horizontal part.
pub(crate) fn level(v: DVec3) -> DVec3 {
    DVec3::new(v.x, 0.0, v.z)
}
