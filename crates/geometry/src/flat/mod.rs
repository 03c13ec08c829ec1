//! Flat space. Bent, it is seen through the horizon map, which it shares with hyperbolic space.

mod euclidean;

pub use euclidean::Euclidean;
pub(crate) use euclidean::rotation;
