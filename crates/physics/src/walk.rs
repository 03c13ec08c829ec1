//! Walking: the feet follow the floor, walls push sideways, low steps are climbed.
//!
//! Height is not integrated on the ground. It is read off the floor under the capsule's lower ball,
//! a pure function of where the ball is, so someone standing stays put to the last bit and a walk
//! keeps its speed over any bumps that can be walked on.

use glam::DVec3;

use crate::mover::{Mover, TOUCH_M, clip, level};

/// How often one part of a walk is pushed out of walls before it is given up.
const PUSHES: usize = 12;

/// How often a push may go against the one before: between walls that face each other, pushes only
/// go back and forth.
const MOST_RETURNS: usize = 1;

/// The longest push out of one wall (m).
const LONGEST_PUSH_M: f64 = 0.25;

/// Contacts more upright than this in their horizontal part are ceilings: no way out sideways.
const LEAST_SIDEWAYS: f64 = 0.1;

/// A part of a walk that is too low for a step tries once more with this rise (m) only.
const SLOPE_RISE_M: f64 = 0.15;

/// Cosine and sine of the turns that are tried in order where the straight way ends in a place too
/// tight to be pushed out of, as between a rising floor and a sinking roof: 0, 25, 50 and 75 degrees.
const DETOURS: [(f64, f64); 7] = [
    (1.0, 0.0),
    (0.906_307_787, 0.422_618_262),
    (0.906_307_787, -0.422_618_262),
    (0.642_787_610, 0.766_044_443),
    (0.642_787_610, -0.766_044_443),
    (0.258_819_045, 0.965_925_826),
    (0.258_819_045, -0.965_925_826),
];

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
        let mut walked = Walked {
            feet,
            velocity: level(velocity),
        };
        for _ in 0..parts {
            walked = self.walk_part(&walked, part_s)?;
        }
        Some(walked)
    }

    fn walk_part(&self, from: &Walked, part_s: f64) -> Option<Walked> {
        let tuning = self.tuning;
        let allowed = self.overlap(from.feet).map_or(0.0, |contact| contact.depth);
        let rises = [tuning.step_height_m, SLOPE_RISE_M.min(tuning.step_height_m)];
        for (cos, sin) in DETOURS {
            let v = from.velocity;
            let velocity = DVec3::new(v.x * cos - v.z * sin, 0.0, v.x * sin + v.z * cos) * cos;
            let start = Walked {
                feet: from.feet,
                velocity,
            };
            if let Some(ending) = rises
                .iter()
                .find_map(|&rise| self.push_through(&start, part_s, rise, allowed))
            {
                return ending;
            }
        }
        let y = self.floor(from.feet, from.feet.y, tuning.step_height_m, tuning.snap_m)?;
        let feet = if self.overlap(from.feet.with_y(y)).is_some() {
            from.feet
        } else {
            from.feet.with_y(y)
        };
        Some(Walked {
            feet,
            velocity: DVec3::ZERO,
        })
    }

    /// `None` when walls on all sides, or the ceiling, leave no place; `Some(None)` when the place
    /// has no floor.
    #[expect(
        clippy::option_option,
        reason = "no place and no floor are different endings"
    )]
    fn push_through(
        &self,
        from: &Walked,
        part_s: f64,
        rise: f64,
        allowed: f64,
    ) -> Option<Option<Walked>> {
        let mut velocity = from.velocity;
        let mut at = from.feet + velocity * part_s;
        let (mut last_way, mut returns) = (DVec3::ZERO, 0);
        for _ in 0..PUSHES {
            let floor = self.floor(at, from.feet.y, rise, self.tuning.snap_m);
            let feet = at.with_y(floor.unwrap_or(from.feet.y));
            let ending = floor.map(|_| Walked { feet, velocity });
            let Some(wall) = self.overlap(feet) else {
                return Some(ending);
            };
            let sideways = level(wall.normal);
            let share = sideways.length();
            if wall.depth <= allowed {
                return Some(ending);
            }
            if share < LEAST_SIDEWAYS {
                break;
            }
            let way = sideways / share;
            returns += usize::from(way.dot(last_way) < 0.0);
            if returns > MOST_RETURNS {
                break;
            }
            last_way = way;
            at += way * (wall.depth / share).min(LONGEST_PUSH_M);
            velocity = clip(velocity, way);
        }
        let slid = Walked {
            feet: from.feet,
            velocity,
        };
        self.lean(from, part_s, allowed)
            .or_else(|| self.lean(&slid, part_s, allowed))
            .map(Some)
    }

    /// In a gully the way off a steep side can lead down as fast as it leads away. There the ball
    /// leans on the side instead, above the floor, so long as that does not climb.
    fn lean(&self, from: &Walked, part_s: f64, allowed: f64) -> Option<Walked> {
        let at = from.feet + from.velocity * part_s;
        let radius = self.capsule.radius_m;
        let touch = self.patch.highest_touch(at, radius, |touch, _| {
            touch.contact_y <= from.feet.y + self.tuning.step_height_m
        })?;
        let feet = at.with_y(touch.centre_y - radius);
        let gentle = feet.y <= from.feet.y + TOUCH_M && feet.y >= from.feet.y - self.tuning.snap_m;
        let free = || self.overlap(feet).is_none_or(|wall| wall.depth <= allowed);
        (gentle && free()).then_some(Walked {
            feet,
            velocity: from.velocity,
        })
    }
}
