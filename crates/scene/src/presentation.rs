//! The presentation of the world to the player. It is no part of the simulation, so no rule may ask for any of it.

use std::sync::Arc;

use antipode_frame::hand::HandMotion;
use antipode_geometry::Eye;

use crate::detail::Sights;
use crate::door_sill::Sills;
use crate::frame::Quality;
use crate::lens::Lens;
use crate::particles::Particles;
use crate::tuning::PICTURE_HEIGHT_PX;
use crate::viewing::Viewing;

/// The picture's lens, the hand, and what pictures are made for.
pub(crate) struct Presentation {
    pub viewing: Viewing,
    /// The picture's lens where it is not the simulation's, which glides.
    pub jumped: Option<Lens>,
    pub quality: Quality,
    /// How what is in the player's hand moves.
    pub hand: HandMotion,
    /// What flies off the ground.
    pub particles: Particles,
    /// Where what is seen through each leaf of a pair of doors begins.
    pub sills: Sills,
    /// Lines of a picture.
    pub picture_height_px: u32,
    /// The sizes in the picture that the chunk workers go by; none if everything is to be full.
    pub sight: Option<Arc<Sights>>,
    /// A camera that is elsewhere than the player: land is made around it.
    pub watched: Option<Eye>,
}

impl Default for Presentation {
    fn default() -> Self {
        Self {
            viewing: Viewing::default(),
            jumped: None,
            quality: Quality::default(),
            hand: HandMotion::default(),
            particles: Particles::default(),
            sills: Sills::default(),
            picture_height_px: PICTURE_HEIGHT_PX,
            sight: None,
            watched: None,
        }
    }
}
