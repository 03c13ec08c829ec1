//! Walking: the feet follow the floor, walls push sideways, low steps are climbed.
//!
//! Height is not integrated on the ground. It is read off the floor under the capsule's lower ball,
//! a pure function of where the ball is, so someone standing stays put to the last bit and a walk
//! keeps its speed over any bumps that can be walked on.

use glam::DVec3;

use crate::mover::{Mover, clip, level};

/// How often one part of a walk is pushed out of walls before it is given up.
const PUSHES: usize = 8;

/// The longest push out of one wall (m).
const LONGEST_PUSH_M: f64 = 0.25;

/// Contacts more upright than this in their horizontal part are ceilings: no way out sideways.
const LEAST_SIDEWAYS: f64 = 0.1;

/// A part of a walk that is too low for a step tries once more with this rise (m) only.
const SLOPE_RISE_M: f64 = 0.15;

/// Where a walk got to.
pub(crate) struct Walked {
    pub feet: DVec3,
    /// Horizontal velocity, without what ran into walls.
    pub velocity: DVec3,
}

impl Mover<'_> {
    /// Walks from `feet` with a horizontal `velocity` for `dt_s`. `None` when the floor ends on the
    /// way: then nothing has happened and the character falls instead.
    pub fn walk(&self, feet: DVec3, velocity: DVec3, dt_s: f64) -> Option<Walked> {
        let parts = self.parts(velocity * dt_s);
        let part_s = dt_s / parts as f64;
        let mut walked = Walked { feet, velocity: level(velocity) };
        for _ in 0..parts {
            walked = self.walk_part(&walked, part_s)?;
        }
        Some(walked)
    }

    fn walk_part(&self, from: &Walked, part_s: f64) -> Option<Walked> {
        let tuning = self.tuning;
        let allowed = self.overlap(from.feet).map_or(0.0, |contact| contact.depth);
        for rise in [tuning.step_height_m, SLOPE_RISE_M.min(tuning.step_height_m)] {
            if let Some(outcome) = self.push_through(from, part_s, rise, allowed) {
                return outcome;
            }
        }
        let y = self.floor(from.feet, from.feet.y, tuning.step_height_m, tuning.snap_m)?;
        let feet = if self.overlap(from.feet.with_y(y)).is_some() { from.feet } else { from.feet.with_y(y) };
        Some(Walked { feet, velocity: DVec3::ZERO })
    }

    /// `None` when walls on all sides, or the ceiling, leave no place; `Some(None)` when the place
    /// has no floor.
    #[expect(clippy::option_option, reason = "no place and no floor are different endings")]
    fn push_through(&self, from: &Walked, part_s: f64, rise: f64, allowed: f64) -> Option<Option<Walked>> {
        let mut velocity = from.velocity;
        let mut at = from.feet + velocity * part_s;
        for push in 0..=PUSHES {
            let floor = self.floor(at, from.feet.y, rise, self.tuning.snap_m);
            let feet = at.with_y(floor.unwrap_or(from.feet.y));
            let ending = floor.map(|_| Walked { feet, velocity });
            let Some(wall) = self.overlap(feet) else { return Some(ending) };
            let sideways = level(wall.normal);
            let share = sideways.length();
            if push == PUSHES || share < LEAST_SIDEWAYS {
                return (wall.depth <= allowed).then_some(ending);
            }
            let way = sideways / share;
            at += way * (wall.depth / share).min(LONGEST_PUSH_M);
            velocity = clip(velocity, way);
        }
        None
    }
}
