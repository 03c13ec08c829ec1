//! Who looks at a world, and how: what one picture of it has for itself.

use std::sync::Arc;

use antipode_geometry::{Eye, Projection, Strategy};

use crate::{ModelId, Quality};

/// From where and how a world is seen.
#[derive(Clone, Debug)]
pub struct View {
    /// Where the picture is taken from.
    pub eye: Eye,
    /// Field of view, aspect and near distance.
    pub projection: Projection,
    /// The space the picture is taken in.
    pub strategy: Arc<dyn Strategy>,
    /// What the player sees in the own hand; none from elsewhere than the head.
    pub hand: Option<Hand>,
    /// Distance in metres, measured in the space, at which the fog is complete.
    pub fog_distance_m: f32,
    /// Whether faint contour bands are drawn on the land.
    pub contour_bands: bool,
    /// What the picture may leave out or simplify.
    pub quality: Quality,
}

/// What the player sees in the own hand, in first person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hand {
    /// What is held.
    pub model: ModelId,
    /// How far it is out of the picture, 0 to 1, as while it is being taken in hand.
    pub lowered: f32,
    /// How far the step moves it, metres to the right and up.
    pub bob_m: [f32; 2],
    /// How far it is swung, from 0 raised to 1 struck; -1 where it is not swung.
    pub swing: f32,
    /// How far it is thrown back, 0 to 1.
    pub kick: f32,
    /// Whether it flashes.
    pub flashes: bool,
}
