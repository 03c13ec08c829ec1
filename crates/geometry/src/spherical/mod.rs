//! The three-sphere.

mod foot;
mod globe;
mod sphere;

use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::kind::{Entry, Radii};

pub(crate) use foot::Foot;
pub use globe::Globe;
pub use sphere::Spherical;

/// Radius of spherical worlds unless a world says otherwise, in metres.
pub const DEFAULT_SPHERE_RADIUS_M: f64 = 32.0;
const RADII_M: RangeInclusive<f64> = 16.0..=256.0;

pub(crate) static ENTRY: Entry = Entry {
    name: "spherical",
    radii: Radii {
        default_m: DEFAULT_SPHERE_RADIUS_M,
        chosen_m: Some(RADII_M),
        saved_m: Some(RADII_M),
    },
    make: |radius_m| Arc::new(Spherical::new(radius_m)),
};
