//! A walking, jumping, flying character: plain state, moved through the terrain of a world.

use antipode_geometry::BodyFrame;
use glam::DVec3;

use crate::body_ground::{arrival, turned};
use crate::mover::{Mover, level};
use crate::patch::{Capsule, Patch};
use crate::{BodyGround, CharacterTuning};

/// Longer moves are cut to this, so that a hitch does not throw anyone through the world.
const LONGEST_MOVE_S: f64 = 0.25;

/// How far around a move terrain is looked at, beyond the move itself (m).
const REACH_M: f64 = 0.3;

/// Where somebody is put down beside what is steeper in the space than in its chart, he comes to stand in so many steps of so many
/// seconds, so near, metres: slopes that are too steep are as long.
const SETTLES: (usize, f64, f64) = (300, 1.0 / 60.0, 8.0);

/// How often a height is mended to which another length of a level metre belongs.
const REFINEMENTS: usize = 3;

/// Rises and drops of the feet in one move beyond the steepest slope, plus this (m), are stairs.
const STAIR_SLACK_M: f64 = 0.02;

/// Where a character is and how it moves. Nothing of it is kept in the world, so a clone is a
/// complete copy and the same inputs repeat the same moves to the bit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Character {
    /// The lowest point of the capsule, in metres of its chart.
    pub feet: DVec3,
    /// Velocity in m/s of the space, along the axes of the chart's frame at the feet; on the ground its vertical part is zero.
    pub velocity: DVec3,
    /// Whether the character stands or walks on something.
    pub grounded: bool,
    /// Speed (m/s) of the fall that ended in the last move, zero when none did.
    pub impact_m_s: f64,
    /// The most (m/s) that slopes too steep to stand on took of a fall at once in the last move; sliding on along one
    /// takes nothing.
    pub scrape_m_s: f64,
    /// By how much (m) a stair set the feet up (or down, negative) at once in the last move; a
    /// camera may ease over it.
    pub stair_m: f64,
    coyote_left_s: f64,
    jump_left_s: f64,
    jump_held: bool,
}

/// What a player wants of a character for one move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CharacterInput {
    /// Horizontal direction to go in its chart's frame, at most unit: its length scales the speed. The
    /// vertical part is ignored.
    pub wish: DVec3,
    /// Go faster.
    pub sprint: bool,
    /// The jump key is down. The press counts, not the hold.
    pub jump: bool,
    /// Spectator flight: no gravity, nothing solid.
    pub fly: bool,
    /// Go up in flight.
    pub rise: bool,
    /// Go down in flight.
    pub sink: bool,
}

impl CharacterInput {
    /// The wish, made level and at most unit; zero when it is not finite.
    fn level_wish(&self) -> DVec3 {
        let wish = level(self.wish);
        if wish.is_finite() {
            wish.clamp_length_max(1.0)
        } else {
            DVec3::ZERO
        }
    }
}

impl Character {
    /// The hardest that the last move ended a fall or a part of it, m/s.
    pub fn hardest_m_s(&self) -> f64 {
        self.impact_m_s.max(self.scrape_m_s)
    }

    /// A character at rest with its feet at `feet` (m), not yet on the ground.
    pub fn at(feet: DVec3) -> Self {
        Self {
            feet,
            ..Self::default()
        }
    }

    fn keep_time(&mut self, tuning: &CharacterTuning, input: &CharacterInput, dt_s: f64) {
        let pressed = input.jump && !self.jump_held;
        self.jump_held = input.jump;
        self.jump_left_s = if pressed {
            tuning.jump_buffer_s
        } else {
            (self.jump_left_s - dt_s).max(0.0)
        };
        self.coyote_left_s = if self.grounded {
            tuning.coyote_s
        } else {
            (self.coyote_left_s - dt_s).max(0.0)
        };
    }

    /// Jumps when one is asked for and there is, or just was, ground to jump from.
    fn try_jump(&mut self, tuning: &CharacterTuning) {
        if self.jump_left_s > 0.0 && self.coyote_left_s > 0.0 {
            self.velocity.y = tuning.jump_speed_m_s();
            self.grounded = false;
            self.jump_left_s = 0.0;
            self.coyote_left_s = 0.0;
        }
    }

    fn follow_wish(&mut self, tuning: &CharacterTuning, input: &CharacterInput, dt_s: f64) {
        let wish = input.level_wish();
        let factor = if input.sprint {
            tuning.sprint_factor
        } else {
            1.0
        };
        let rate = match (self.grounded, wish == DVec3::ZERO) {
            (true, false) => tuning.ground_acceleration_m_s2,
            (true, true) => tuning.ground_braking_m_s2,
            (false, false) => tuning.air_acceleration_m_s2,
            (false, true) => tuning.air_braking_m_s2,
        };
        let target = wish * (tuning.walk_speed_m_s * factor);
        let followed = approach(level(self.velocity), target, rate * dt_s);
        self.velocity = followed.with_y(self.velocity.y);
    }

    /// Returns the way that it flies.
    fn fly(&mut self, tuning: &CharacterTuning, input: &CharacterInput, dt_s: f64) -> DVec3 {
        let up = f64::from(i8::from(input.rise) - i8::from(input.sink));
        let factor = if input.sprint {
            tuning.fly_sprint_factor
        } else {
            1.0
        };
        let target = (input.level_wish() + DVec3::Y * up) * (tuning.fly_speed_m_s * factor);
        self.velocity = approach(
            self.velocity,
            target,
            tuning.fly_acceleration_m_s2 * factor * dt_s,
        );
        self.grounded = false;
        (self.coyote_left_s, self.jump_left_s) = (0.0, 0.0);
        self.velocity * dt_s
    }
}

impl BodyGround<'_> {
    /// Moves a character by one step of `dt_s` seconds (cut to 0.25). Takes no account of other
    /// characters. State that is not finite, and a `dt_s` that is not above zero, leave it as it is.
    ///
    /// Returns by how many radians the way has turned in the chart's frames, as the turn of a
    /// [`antipode_geometry::Crossing`]: the velocity has taken it, and a heading is to, which becomes less by it. It is 0 where
    /// bodies move in the chart.
    pub fn move_character(
        &self,
        character: &mut Character,
        tuning: &CharacterTuning,
        input: &CharacterInput,
        dt_s: f64,
    ) -> f64 {
        let sound = character.feet.is_finite() && character.velocity.is_finite() && dt_s > 0.0;
        if !sound {
            return 0.0;
        }
        let dt_s = dt_s.min(LONGEST_MOVE_S);
        character.impact_m_s = 0.0;
        (character.scrape_m_s, character.stair_m) = (0.0, 0.0);
        character.keep_time(tuning, input, dt_s);
        let frame = self.frame(character.feet);
        let off = if input.fly {
            character.fly(tuning, input, dt_s)
        } else {
            character.try_jump(tuning);
            character.follow_wish(tuning, input, dt_s);
            let patch = self.patch_around(frame.as_ref(), character, tuning, dt_s);
            travel(character, &Mover::new(patch, tuning), dt_s)
        };
        let (feet, turn_rad) = arrival(frame.as_ref(), character.feet, off);
        character.feet = feet;
        character.velocity = turned(character.velocity, turn_rad);
        turn_rad
    }

    /// Sets a character that hangs no more than `most_m` over ground it can stand on down there. Returns whether it
    /// stands now.
    pub fn set_down(
        &self,
        character: &mut Character,
        tuning: &CharacterTuning,
        most_m: f64,
    ) -> bool {
        if !character.feet.is_finite() {
            return false;
        }
        if !self.lower(character, tuning, [0.0, most_m]) {
            return self.curved()
                && self.is_over_a_slope(character, tuning, most_m)
                && self.settle_down(character, tuning);
        }
        if self.curved() {
            // Down there a level metre is another one: on a slope the ground is a little higher or lower for it, each time a
            // hundredth of the time before.
            for _ in 0..REFINEMENTS {
                self.lower(character, tuning, [tuning.step_height_m, tuning.snap_m]);
            }
        }
        character.velocity = DVec3::ZERO;
        character.grounded = true;
        true
    }

    /// Whether a character hangs no more than so far over ground, however steep.
    fn is_over_a_slope(
        &self,
        character: &Character,
        tuning: &CharacterTuning,
        most_m: f64,
    ) -> bool {
        let climber = CharacterTuning {
            max_slope_rad: std::f64::consts::FRAC_PI_2,
            ..*tuning
        };
        let mut lowered = Character::at(character.feet);
        self.lower(&mut lowered, &climber, [0.0, most_m])
    }

    /// Lets a character slide to where it stands, if that is near; whether it does.
    fn settle_down(&self, character: &mut Character, tuning: &CharacterTuning) -> bool {
        let (steps, step_s, near_m) = SETTLES;
        let mut slid = Character::at(character.feet);
        for _ in 0..steps {
            self.move_character(&mut slid, tuning, &CharacterInput::default(), step_s);
        }
        let stands = slid.grounded && slid.feet.distance(character.feet) < near_m;
        if stands {
            character.feet = slid.feet;
            character.velocity = DVec3::ZERO;
            character.grounded = true;
        }
        stands
    }

    /// Puts the feet where they stand, no more than so far up and down; whether there is such a place.
    fn lower(
        &self,
        character: &mut Character,
        tuning: &CharacterTuning,
        [most_up_m, most_m]: [f64; 2],
    ) -> bool {
        let capsule = Capsule::new(tuning.height_m, tuning.radius_m);
        let (min, max) = capsule.bounds(character.feet);
        let reach = DVec3::splat(REACH_M);
        let frame = self.frame(character.feet);
        let patch = Patch::gather(
            self.ground,
            frame.as_ref(),
            character.feet,
            min - reach - DVec3::Y * most_m,
            max + reach,
        );
        let mover = Mover::new(patch, tuning);
        let floor = mover.floor(DVec3::ZERO, 0.0, most_up_m, most_m);
        let Some(y) = floor.filter(|&y| mover.overlap(DVec3::Y * y).is_none()) else {
            return false;
        };
        character.feet.y += y;
        true
    }

    /// The terrain that a move can meet, relative to the feet.
    fn patch_around(
        &self,
        frame: Option<&BodyFrame<'_>>,
        character: &Character,
        tuning: &CharacterTuning,
        dt_s: f64,
    ) -> Patch {
        let way = character.velocity * dt_s;
        let fall = tuning.gravity_m_s2 * dt_s * dt_s;
        let down = (fall - way.y.min(0.0)).max(if character.grounded {
            tuning.snap_m
        } else {
            0.0
        });
        let up = way.y.max(0.0).max(tuning.step_height_m);
        let capsule = Capsule::new(tuning.height_m, tuning.radius_m);
        let (min, max) = capsule.bounds(character.feet);
        let (low, high) = (level(way).min(DVec3::ZERO), level(way).max(DVec3::ZERO));
        let reach = DVec3::splat(REACH_M);
        Patch::gather(
            self.ground,
            frame,
            character.feet,
            min + low - reach - DVec3::Y * down,
            max + high + reach + DVec3::Y * up,
        )
    }
}

/// Walks while there is floor, else flies through the air; in the mover's frame, whose zero is the
/// character's feet. Returns how far it gets.
fn travel(character: &mut Character, mover: &Mover<'_>, dt_s: f64) -> DVec3 {
    if character.grounded {
        character.velocity.y = 0.0;
        if let Some(walked) = mover.walk(DVec3::ZERO, character.velocity, dt_s) {
            character.stair_m = stair(walked.feet, mover.tuning.max_slope_rad);
            character.velocity = walked.velocity;
            return walked.feet;
        }
    }
    let flown = mover.fly_through_air(DVec3::ZERO, character.velocity, dt_s);
    character.velocity = flown.velocity;
    character.grounded = flown.landed;
    character.impact_m_s = flown.impact_m_s;
    character.scrape_m_s = flown.scrape_m_s;
    flown.feet
}

/// The part of a walk's rise that no walkable slope explains.
fn stair(way: DVec3, max_slope_rad: f64) -> f64 {
    let slope = level(way).length() * max_slope_rad.tan() + STAIR_SLACK_M;
    if way.y.abs() > slope { way.y } else { 0.0 }
}

/// Moves `from` towards `to` by at most `most`.
fn approach(from: DVec3, to: DVec3, most: f64) -> DVec3 {
    let way = to - from;
    if way.length() <= most {
        to
    } else {
        from + way.normalize_or_zero() * most
    }
}
