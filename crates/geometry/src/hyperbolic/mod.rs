//! Hyperbolic space and the two maps that carry a flat chart into it. The horizon map is of any curvature.

mod horizon;
mod raised;

pub use horizon::Horizon;
pub use raised::Raised;
