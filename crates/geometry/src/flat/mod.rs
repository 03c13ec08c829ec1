//! Flat space. Bent, it is seen through the horizon map, which it shares with hyperbolic space.

mod euclidean;

use std::sync::Arc;

use crate::kind::{Entry, Radii};

pub use euclidean::Euclidean;
pub(crate) use euclidean::rotation;

pub(crate) static ENTRY: Entry = Entry {
    name: "euclidean",
    radii: Radii {
        default_m: f64::INFINITY,
        chosen_m: None,
        saved_m: None,
    },
    make: |_| Arc::new(Euclidean),
};
