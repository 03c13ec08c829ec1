//! Hyperbolic space and the two maps that carry a flat chart into it. The horizon map is of any curvature.

mod horizon;
mod raised;

use std::sync::Arc;

use crate::kind::{Entry, Radii};

pub use horizon::Horizon;
pub use raised::Raised;

/// Radius of curvature of hyperbolic worlds unless a world says otherwise, in metres.
pub const DEFAULT_HYPERBOLIC_RADIUS_M: f64 = 20.0;
/// Hyperbolic worlds draw nothing farther than this many radii from the eye: past it a
/// hyperboloid coordinate in `f32` has no digits left to order two surfaces by.
pub const FAR_LIMIT_RADII: f64 = 20.0;

pub(crate) static ENTRY: Entry = Entry {
    name: "hyperbolic",
    radii: Radii {
        default_m: DEFAULT_HYPERBOLIC_RADIUS_M,
        // The player's dial takes its place.
        chosen_m: None,
        // Wider than any that the game makes.
        saved_m: Some(1.0..=4096.0),
    },
    make: |radius_m| Arc::new(Raised::new(radius_m)),
};
