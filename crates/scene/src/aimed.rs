//! What the player looks and aims through, which has a part in the world. The picture's own lens has none: see `moment`.
//!
//! The simulation's own lens glides in simulated time and its head dips, however the player wants to see the world. Who
//! plays aims by the picture, so an action may tell the lens of the picture it was made by; what is dug is then what the
//! crosshair covered, and the same recorded actions give the same world through whatever picture they are played again.

use std::sync::Arc;

use antipode_geometry::{Strategy, ViewMode};

use crate::camera::CameraMode;
use crate::dip::HeadDip;
use crate::lens::Lens;

/// The lens that an action was aimed by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    pub(crate) view: ViewMode,
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
pub(crate) struct ViewParams {
    pub strategy: Arc<dyn Strategy>,
    pub dial: f64,
    pub straight_shots: bool,
    pub dips: bool,
    /// Whether it is level in a car, and lies at once when one dies.
    pub reduced_motion: bool,
    /// Whether it is the world's own picture, by which others see.
    pub own: bool,
}

/// What the player looks and aims through: what the actions tell, or else the simulation's own lens.
#[derive(Debug)]
pub(crate) struct Gaze {
    pub camera: CameraMode,
    pub lens: Lens,
    /// Whether bullets follow the space's geodesics.
    pub straight_shots: bool,
    pub dip: HeadDip,
    /// What the last step's actions were aimed through, if they told.
    aimed: Option<(Aim, ViewParams)>,
}

impl Gaze {
    /// Looks through a lens from the head.
    pub fn through(lens: Lens) -> Self {
        Self {
            camera: CameraMode::First,
            lens,
            straight_shots: false,
            dip: HeadDip::default(),
            aimed: None,
        }
    }

    /// Takes over the lens that a step's actions were aimed by; without one they go by the simulation's own.
    pub fn take_aim(&mut self, aimed: Option<Aim>) {
        let kept = self.aimed.take();
        self.aimed = aimed.map(|aim| match kept {
            Some(kept) if kept.0 == aim => kept,
            _ => (aim, self.params_of(&aim)),
        });
    }

    /// Lets go of what the last actions were aimed by.
    pub fn forget_aim(&mut self) {
        self.aimed = None;
    }

    fn params_of(&self, aim: &Aim) -> ViewParams {
        ViewParams {
            strategy: self.lens.pictured(aim.view, aim.share),
            dial: aim.value,
            straight_shots: aim.straight_shots,
            dips: aim.dips,
            reduced_motion: false,
            own: crate::lens::is_own(aim.view, aim.value, aim.share),
        }
    }

    /// What the player aims through.
    pub fn aiming(&self) -> ViewParams {
        if let Some((_, params)) = &self.aimed {
            return params.clone();
        }
        ViewParams {
            strategy: Arc::clone(self.lens.strategy()),
            dial: self.lens.value(),
            straight_shots: self.straight_shots,
            dips: true,
            reduced_motion: false,
            own: self.lens.is_own(),
        }
    }
}
