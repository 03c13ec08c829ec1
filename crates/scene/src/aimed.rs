//! What an eye looks through: the lens that the player aims by, which has a part in the world, and that of the picture,
//! which has none.
//!
//! The simulation's own lens glides in simulated time and its head dips, however the player wants to see the world. Who
//! plays aims by the picture, so an action may tell the lens of the picture it was made by; what is dug is then what the
//! crosshair covered, and the same recorded actions give the same world through whatever picture they are played again.

use std::sync::Arc;

use antipode_geometry::{Eye, Strategy};

use crate::camera::CameraMode;
use crate::lens::{Lens, LensView};
use crate::scene::Scene;

/// The lens that an action was aimed by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    pub(crate) view: LensView,
    /// Where the dial was on its way.
    pub(crate) value: f64,
    /// Share of the world's own curvature that was shown, 0 to 1.
    pub(crate) share: f64,
    /// Whether bullets follow the space's geodesics.
    pub(crate) straight_shots: bool,
    /// Whether the head dipped on landing.
    pub(crate) dips: bool,
}

/// What an eye looks through.
#[derive(Clone, Debug)]
pub(crate) struct Optics {
    pub strategy: Arc<dyn Strategy>,
    pub dial: f64,
    pub straight_shots: bool,
    pub dips: bool,
    /// Whether it is level in a car, and lies at once when one dies.
    pub reduced_motion: bool,
    /// Whether it is the world's own picture, by which others see.
    pub own: bool,
}

impl Scene {
    /// The lens of the player's picture, to be told with the actions that are aimed by it.
    pub fn aim_of_picture(&self) -> Aim {
        let (view, value, share) = self.lens().at();
        Aim {
            view,
            value,
            share,
            straight_shots: self.player.straight_shots,
            dips: self.shown.viewing.dips(),
        }
    }

    /// Takes over the lens that a step's actions were aimed by; without one they go by the simulation's own.
    pub(crate) fn take_aim(&mut self, aimed: Option<Aim>) {
        let kept = self.player.aimed.take();
        self.player.aimed = aimed.map(|aim| match kept {
            Some(kept) if kept.0 == aim => kept,
            _ => (aim, self.optics_of(&aim)),
        });
    }

    fn optics_of(&self, aim: &Aim) -> Optics {
        Optics {
            strategy: self.player.lens.pictured(aim.view, aim.share),
            dial: aim.value,
            straight_shots: aim.straight_shots,
            dips: aim.dips,
            reduced_motion: false,
            own: crate::lens::is_own(aim.view, aim.value, aim.share),
        }
    }

    /// What the player aims through.
    pub(crate) fn aiming(&self) -> Optics {
        if let Some((_, optics)) = &self.player.aimed {
            return optics.clone();
        }
        let lens = &self.player.lens;
        Optics {
            strategy: Arc::clone(lens.strategy()),
            dial: lens.value(),
            straight_shots: self.player.straight_shots,
            dips: true,
            reduced_motion: false,
            own: lens.is_own(),
        }
    }

    /// What the player's picture is taken through.
    pub(crate) fn picturing(&self) -> Optics {
        let (lens, viewing) = (self.lens(), self.shown.viewing);
        Optics {
            strategy: Arc::clone(lens.strategy()),
            dial: lens.value(),
            straight_shots: self.player.straight_shots,
            dips: viewing.dips(),
            reduced_motion: viewing.reduced_motion,
            own: lens.is_own(),
        }
    }

    /// How far the head lies beyond an eye that looks through that, metres: near a wall the camera stands closer than it
    /// would like.
    pub(crate) fn past_head_m(&self, optics: &Optics, eye: &Eye) -> f64 {
        match self.shown.camera {
            CameraMode::First => 0.0,
            CameraMode::Third => {
                let head = self.head_through(optics);
                optics.strategy.distance_m(eye.point, head.point, eye)
            }
        }
    }

    /// Keeps the picture's lens up with the simulation's, which glides: with reduced motion it is where that will be.
    pub(crate) fn renew_picture(&mut self) {
        let jumps = self.shown.viewing.reduced_motion && !self.player.lens.rests();
        self.shown.jumped = jumps.then(|| {
            let mut lens = self.player.lens.clone();
            lens.jump();
            lens
        });
    }

    /// Through which picture the world is seen.
    pub fn lens(&self) -> &Lens {
        self.shown.jumped.as_ref().unwrap_or(&self.player.lens)
    }
}
