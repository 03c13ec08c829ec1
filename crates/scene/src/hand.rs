//! What is in the player's hand, and how it moves: it comes up when it is taken, bobs with the steps, is swung while it
//! digs or builds, and is thrown back and flashes when it shoots.

use std::f64::consts::TAU;

use antipode_geometry::ChartPoint;

use crate::camera::CameraMode;
use crate::frame::{Figure, Hand, LampLight, ModelId};
use crate::player::Appearance;
use crate::situation::Situation;
use crate::sound::STROKE_S;
use crate::tuning::{BOB_M, FLASH_S, KICK_S, STEP_S, TAKES_S};
use antipode_items::Item;

/// Strokes of a tool that are seen for one that is heard: as quick as those, they would blur.
const STROKES_SEEN: f64 = 0.5;
/// Share of a stroke in which the tool comes down; the rest raises it again.
const DOWN_SHARE: f64 = 0.36;
/// Speed at which what is held bobs in full, in m/s.
const BOBS_FULLY_M_S: f64 = 4.5;
/// How quickly the bob comes and goes, per second.
const BOB_RATE_PER_S: f64 = 7.0;
/// Colour times strength of the flash of a shot, and where it has faded away, metres.
const FLASH_COLOUR: [f32; 3] = [5.0, 3.2, 1.2];
const FLASH_RANGE_M: f64 = 9.0;

/// How what is in the player's hand moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct HandMotion {
    held: Option<Item>,
    /// Since it was taken in hand, seconds.
    taken_s: f64,
    /// Since the stroke began, seconds; none while nothing is struck.
    stroke_s: Option<f64>,
    kick: f64,
    flash_left_s: f64,
    /// Share of the bob, 0 to 1.
    bob: f64,
}

impl HandMotion {
    /// A shot was fired.
    fn fire(&mut self) {
        self.kick = 1.0;
        self.flash_left_s = FLASH_S;
    }

    /// Goes on by the step that has just been taken, in which a shot was fired or not; without a bob where the player wants it
    /// `still`.
    pub fn step(&mut self, now: Situation<'_>, fired: bool, still: bool) {
        if fired {
            self.fire();
        }
        let (player, body) = (now.player, now.actors.player_body());
        let bob = if still || !body.grounded {
            0.0
        } else {
            let speed_m_s = body.velocity.x.hypot(body.velocity.z);
            (speed_m_s / BOBS_FULLY_M_S).min(1.3)
        };
        let held = player.inventory.held();
        let digs = held.and_then(Item::brush_strength_per_s).is_some();
        let used = digs && player.primary_before != player.secondary_before;
        self.pass(held, used, bob, STEP_S);
    }

    /// Puts what the player holds and does with it into the own figure's hand.
    pub fn use_in(&self, held: Option<Item>, figure: &mut Figure) {
        figure.held = held.map(ModelId::from);
        figure.posture.swing = self.swing();
        figure.posture.kick = self.kick as f32;
        figure.flashes = self.flashes();
    }

    /// The light of a shot that has just been fired.
    pub fn shot_light(&self, muzzle: impl Fn() -> ChartPoint) -> Option<LampLight> {
        self.flashes().then(|| LampLight {
            point: muzzle(),
            colour: FLASH_COLOUR,
            range_m: FLASH_RANGE_M,
        })
    }

    /// Lets a step pass with `held` in hand, in use or not, and so much of a bob.
    fn pass(&mut self, held: Option<Item>, used: bool, bob: f64, dt_s: f64) {
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
        self.flash_left_s = (self.flash_left_s - dt_s).max(0.0);
        self.bob += (bob - self.bob) * (BOB_RATE_PER_S * dt_s).min(1.0);
    }

    /// How far it is out of the picture, 0 to 1.
    fn lowered(&self) -> f32 {
        let left = (1.0 - self.taken_s / TAKES_S).clamp(0.0, 1.0);
        (left * left) as f32
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

    fn flashes(&self) -> bool {
        self.flash_left_s > 0.0
    }
}

/// What the player sees in the own hand.
pub(crate) fn seen(now: Situation<'_>, hand: &HandMotion, still: bool) -> Option<Hand> {
    let player = now.player;
    let held = player.inventory.held()?;
    let from_head = player.gaze.camera == CameraMode::First;
    if !from_head || player.is_dead() || player.flying || now.actors.cars.is_driving() {
        return None;
    }
    let appearance = now.actors.ecs.get::<&Appearance>(now.actors.player);
    let phase = TAU * appearance.map_or(0.0, |appearance| appearance.motion.cycles());
    let (aside_m, up_m) = BOB_M;
    let bob = if still { 0.0 } else { hand.bob };
    Some(Hand {
        model: held.into(),
        lowered: hand.lowered(),
        // Once to each side in a cycle, and down with each foot.
        bob_m: [
            (bob * aside_m * phase.sin()) as f32,
            (-bob * up_m * (2.0 * phase).cos().abs()) as f32,
        ],
        swing: hand.swing(),
        kick: hand.kick as f32,
        flashes: hand.flashes(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tuning::SHOT_EVERY_S;

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

    /// The next shot's flash is a new one.
    #[test]
    fn a_flash_is_over_before_the_next_shot() {
        const { assert!(FLASH_S < SHOT_EVERY_S) };
    }
}
