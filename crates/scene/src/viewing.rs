//! The player's preferences for viewing the world. They are no part of the world, so it does not save them.

use crate::tuning::FOV_Y_RAD;

/// What a player can choose about the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewing {
    /// Vertical field of view, radians, above 0 and below pi. Land is made as fine as it needs.
    pub fov_y_rad: f64,
    /// Whether faint lines of equal height are drawn on the land.
    pub contour_bands: bool,
    /// Whether the head dips on landing.
    pub head_dip: bool,
    /// Whether leaves and grass sway in the wind.
    pub wind: bool,
    /// Whether nothing glides, dips or sways.
    pub reduced_motion: bool,
    /// Whether the ring about what is dug or built is told by lightness alone.
    pub safe_marker: bool,
}

impl Default for Viewing {
    fn default() -> Self {
        Self {
            fov_y_rad: FOV_Y_RAD,
            contour_bands: false,
            head_dip: true,
            wind: true,
            reduced_motion: false,
            safe_marker: false,
        }
    }
}

impl Viewing {
    /// Whether the head dips after all.
    pub(crate) fn dips(&self) -> bool {
        self.head_dip && !self.reduced_motion
    }

    /// Whether leaves and grass sway after all.
    pub(crate) fn sways(&self) -> bool {
        self.wind && !self.reduced_motion
    }
}
