//! The gun in the hand of who walks, as it is seen before the eye. How it moves is worlds' own [`HandMotion`].

use antipode_deformation::Traveller;
use antipode_frame::Hand;
use antipode_frame::hand::{FLASH_COLOUR, FLASH_RANGE_M, bob_at};
use antipode_items::Item;
use antipode_rays::{Eye, Lamp, MAX_LAMPS};
use glam::{Affine3A, DAffine3, DMat3, Vec3};

use crate::scene::RoomScene;
use crate::tuning::{DAYLIGHT, FOV_Y_RAD, LAMP_RADIUS_M, MUZZLE_M, STEP_S};

/// What is held before the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InHand {
    /// What it is, and how it is moved.
    pub hand: Hand,
    /// From the eye's own axes (x to the right, y up, z back; felt metres from the eye) to the scene.
    pub pose: Affine3A,
}

/// How a player wants to see a room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoomViewing {
    /// Angle between the top and the bottom of a picture, radians.
    pub fov_y_rad: f64,
    /// Whether what is held does not bob, and a view that a portal has rolled is level at once.
    pub reduced_motion: bool,
}

impl Default for RoomViewing {
    fn default() -> Self {
        Self {
            fov_y_rad: FOV_Y_RAD,
            reduced_motion: false,
        }
    }
}

impl RoomScene {
    /// Pictures are made so from now on.
    pub fn set_viewing(&mut self, viewing: RoomViewing) {
        self.viewing = viewing;
    }

    /// Lets a step pass for what is in the hand.
    pub(crate) fn move_hand(&mut self) {
        let still = self.viewing.reduced_motion;
        let body = self.walker.body;
        let bob = if still || !self.walker.grounded {
            0.0
        } else {
            bob_at(body.velocity.reject_from_normalized(self.up()).length())
        };
        self.hand_before = Some(self.hand_now());
        self.hand.put_aside(self.reads_sign(), STEP_S);
        self.hand.pass(Some(Item::Gun), false, bob, STEP_S);
    }

    fn hand_now(&self) -> Hand {
        let still = self.viewing.reduced_motion;
        self.hand.seen(Item::Gun, self.motion.cycles(), still)
    }

    /// What is held before that eye, at a share of the way of the last step; nothing where one looks from behind.
    pub(crate) fn held_between(&self, eye: &Eye, share: f64) -> Option<InHand> {
        if self.third_person {
            return None;
        }
        let now = self.hand_now();
        let hand = self
            .hand_before
            .map_or(now, |before| now.between(&before, share as f32));
        let felt = DMat3::from_cols(eye.right, eye.up, -eye.front);
        let k = self.space.carry(&eye.place, eye.front, &Traveller::Body);
        let pose = DAffine3 {
            matrix3: k * felt,
            translation: eye.place.point,
        };
        let pose = pose.as_affine3a();
        Some(InHand { hand, pose })
    }

    /// The light of a shot that has just been fired, where there is room for one more among the others.
    pub(crate) fn shot_light(&self, others: usize) -> Option<Lamp> {
        let flashes = self.hand.flashes() && others < MAX_LAMPS;
        flashes.then(|| {
            let eye = self.walker.eye_place(&self.space, self.up());
            Lamp {
                place: self.beside(&eye, self.look.front(), MUZZLE_M),
                colour: Vec3::from(FLASH_COLOUR) * DAYLIGHT,
                reach_m: FLASH_RANGE_M as f32,
                radius_m: LAMP_RADIUS_M,
            }
        })
    }
}
