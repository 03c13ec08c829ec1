//! How what is in a hand moves, in worlds and rooms alike: it comes up when it is taken, bobs with the steps, is swung while
//! it digs or builds, and is thrown back and flashes when it shoots. Advanced with the steps of a world or a room, so that the
//! same steps give the same picture.

use std::f64::consts::TAU;

use antipode_items::Item;

use crate::posture::Posture;
use crate::view::Hand;

/// Time between two sounds of a tool that is held down, in seconds.
pub const STROKE_S: f64 = 0.27;
/// How long the flash of a shot is seen, in seconds.
pub const FLASH_S: f64 = 0.05;
/// How long it takes to take another thing in hand, in seconds.
pub const TAKES_S: f64 = 0.22;
/// Time in which the kick of a shot falls to a third, in seconds.
pub const KICK_S: f64 = 0.07;
/// How far a step moves what is held, as seen from the eye: sideways and up, in metres.
pub const BOB_M: (f64, f64) = (0.012, 0.010);
/// Colour times strength of the flash of a shot, and where it has faded away, metres.
pub const FLASH_COLOUR: [f32; 3] = [5.0, 3.2, 1.2];
/// See [`FLASH_COLOUR`].
pub const FLASH_RANGE_M: f64 = 9.0;
/// Strokes of a tool that are seen for one that is heard: as quick as those, they would blur.
const STROKES_SEEN: f64 = 0.5;
/// Share of a stroke in which the tool comes down; the rest raises it again.
const DOWN_SHARE: f64 = 0.36;
/// Speed at which what is held bobs in full, in m/s.
const BOBS_FULLY_M_S: f64 = 4.5;
/// How quickly the bob comes and goes, per second.
const BOB_RATE_PER_S: f64 = 7.0;
/// A kick or a bob that is nearer to its end than this is there: a picture that stands still is not made again.
const LEAST: f64 = 1e-3;

/// How what is in a hand moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HandMotion {
    held: Option<Item>,
    /// Since it was taken in hand, seconds.
    taken_s: f64,
    /// Since the stroke began, seconds; none while nothing is struck.
    stroke_s: Option<f64>,
    kick: f64,
    flash_left_s: f64,
    /// Share of the bob, 0 to 1.
    bob: f64,
    /// How far it is put aside, 0 to 1.
    aside: f64,
}

/// How much of a bob there is to be at a speed over the ground, m/s.
pub fn bob_at(speed_m_s: f64) -> f64 {
    (speed_m_s / BOBS_FULLY_M_S).min(1.3)
}

impl HandMotion {
    /// A shot was fired.
    pub fn fire(&mut self) {
        self.kick = 1.0;
        self.flash_left_s = FLASH_S;
        self.aside = 0.0;
    }

    /// Lets a step pass in which what is held is put out of the picture, or back into it. A shot brings it back at once.
    pub fn put_aside(&mut self, aside: bool, dt_s: f64) {
        let way = if aside { dt_s } else { -dt_s };
        self.aside = (self.aside + way / TAKES_S).clamp(0.0, 1.0);
    }

    /// Lets a step pass with `held` in hand, in use or not, and so much of a bob.
    pub fn pass(&mut self, held: Option<Item>, used: bool, bob: f64, dt_s: f64) {
        self.taken_s += dt_s;
        if self.held != held {
            *self = Self {
                held,
                bob: self.bob,
                ..Self::default()
            };
        }
        let period_s = STROKE_S / STROKES_SEEN;
        self.stroke_s = match self.stroke_s {
            Some(since_s) if since_s + dt_s < period_s => Some(since_s + dt_s),
            // A stroke that has begun is ended, and followed by another while the button is down.
            Some(since_s) => used.then_some((since_s + dt_s) % period_s),
            None => used.then_some(0.0),
        };
        self.kick *= (-dt_s / KICK_S).exp();
        if self.kick < LEAST {
            self.kick = 0.0;
        }
        self.flash_left_s = (self.flash_left_s - dt_s).max(0.0);
        self.bob += (bob - self.bob) * (BOB_RATE_PER_S * dt_s).min(1.0);
        if (bob - self.bob).abs() < LEAST {
            self.bob = bob;
        }
    }

    /// How the own figure's arm is moved by it.
    pub fn move_arm(&self, posture: &mut Posture) {
        posture.swing = self.swing();
        posture.kick = self.kick as f32;
    }

    /// What is seen in first person of what is held now, after so many cycles of the gait; without a bob where the player wants
    /// it `still`.
    pub fn seen(&self, held: Item, cycles: f64, still: bool) -> Hand {
        let phase = TAU * cycles;
        let (aside_m, up_m) = BOB_M;
        let bob = if still { 0.0 } else { self.bob };
        Hand {
            model: held.into(),
            lowered: self.lowered(),
            // Once to each side in a cycle, and down with each foot.
            bob_m: [
                (bob * aside_m * phase.sin()) as f32,
                (-bob * up_m * (2.0 * phase).cos().abs()) as f32,
            ],
            swing: self.swing(),
            kick: self.kick as f32,
            flashes: self.flashes(),
        }
    }

    /// Whether a shot flashes.
    pub fn flashes(&self) -> bool {
        self.flash_left_s > 0.0
    }

    /// How far it is out of the picture, 0 to 1.
    fn lowered(&self) -> f32 {
        let left = (1.0 - self.taken_s / TAKES_S).clamp(0.0, 1.0);
        (left * left).max(self.aside * self.aside) as f32
    }

    /// How far it is swung, 0 to 1, or -1.
    fn swing(&self) -> f32 {
        let Some(since_s) = self.stroke_s else {
            return -1.0;
        };
        let t = since_s * STROKES_SEEN / STROKE_S;
        let part = if t < DOWN_SHARE {
            t / DOWN_SHARE
        } else {
            1.0 - (t - DOWN_SHARE) / (1.0 - DOWN_SHARE)
        };
        // Down with speed, up at ease.
        let eased = if t < DOWN_SHARE {
            part * part
        } else {
            part * part * (3.0 - 2.0 * part)
        };
        eased as f32
    }
}

impl Hand {
    /// What is seen at a share of the way of a step that began as `from`.
    #[must_use]
    pub fn between(&self, from: &Self, share: f32) -> Self {
        if self.model != from.model {
            return *self;
        }
        let [right_m, up_m] = [0, 1].map(|way| mix(from.bob_m[way], self.bob_m[way], share));
        Self {
            lowered: mix(from.lowered, self.lowered, share),
            bob_m: [right_m, up_m],
            swing: swing_between(from.swing, self.swing, share),
            kick: kick_between(from.kick, self.kick, share),
            ..*self
        }
    }
}

/// A swing at a share of the way of a step: it begins at once.
pub fn swing_between(from: f32, to: f32, share: f32) -> f32 {
    if from < 0.0 || to < 0.0 {
        to
    } else {
        mix(from, to, share)
    }
}

/// A kick at a share of the way of a step: it begins at once, too.
pub fn kick_between(from: f32, to: f32, share: f32) -> f32 {
    if to > from { to } else { mix(from, to, share) }
}

fn mix(from: f32, to: f32, share: f32) -> f32 {
    to - (to - from) * (1.0 - share)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP_S: f64 = 1.0 / 60.0;

    /// Half a second's swings while the button is down for `used_s` of it.
    fn swings(used_s: f64) -> Vec<f32> {
        let mut hand = HandMotion::default();
        let item = Some(Item::PickaxeIron);
        (0..60)
            .map(|step| {
                hand.pass(item, f64::from(step) * STEP_S < used_s, 0.0, STEP_S);
                hand.swing()
            })
            .collect()
    }

    #[test]
    fn a_stroke_that_has_begun_is_ended_and_goes_on_while_the_button_is_down() {
        let once = swings(0.05);
        let strokes = |swings: &[f32]| {
            swings
                .windows(2)
                .filter(|w| w[0] < 0.9 && w[1] >= 0.9)
                .count()
        };
        assert_eq!(strokes(&once), 1, "{once:?}");
        assert_eq!(once[59], -1.0);
        assert_eq!(strokes(&swings(1.0)), 2);
    }

    #[test]
    fn what_is_put_aside_is_out_of_the_picture_until_it_is_taken_back_or_shoots() {
        let mut hand = HandMotion::default();
        let pass = |hand: &mut HandMotion, aside: bool| {
            for _ in 0..30 {
                hand.put_aside(aside, STEP_S);
                hand.pass(Some(Item::Gun), false, 0.0, STEP_S);
            }
            hand.lowered()
        };
        assert_eq!(pass(&mut hand, true), 1.0);
        assert_eq!(pass(&mut hand, false), 0.0);
        pass(&mut hand, true);
        hand.fire();
        assert_eq!(hand.lowered(), 0.0);
    }

    #[test]
    fn what_is_taken_in_hand_comes_up_and_a_kick_passes() {
        let mut hand = HandMotion::default();
        hand.pass(Some(Item::Gun), false, 0.0, STEP_S);
        assert!(hand.lowered() > 0.8);
        hand.fire();
        assert!(hand.flashes());
        for _ in 0..30 {
            hand.pass(Some(Item::Gun), false, 0.0, STEP_S);
        }
        assert_eq!(hand.lowered(), 0.0);
        assert!(hand.kick < 0.01 && !hand.flashes());
    }

    #[test]
    fn a_hand_comes_to_rest_after_a_walk_and_a_shot() {
        let mut hand = HandMotion::default();
        for _ in 0..30 {
            hand.pass(Some(Item::Gun), false, bob_at(4.5), STEP_S);
        }
        hand.fire();
        let mut last = hand.seen(Item::Gun, 0.3, false);
        let mut moved = 0;
        for _ in 0..240 {
            hand.pass(Some(Item::Gun), false, 0.0, STEP_S);
            let seen = hand.seen(Item::Gun, 0.3, false);
            moved += usize::from(seen != last);
            last = seen;
        }
        assert!((20..90).contains(&moved), "{moved} of 240 steps");
    }
}
