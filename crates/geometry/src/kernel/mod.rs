//! The scalar kernels of the port on plain arrays, one file per map, in `f32` and `f64`.
//!
//! Points of a chart are `[x, y, z]`, points of a model and of the picture `[x, y, z, w]`. The
//! strategies call the `f64` kernels; the `f32` ones are the shader's arithmetic. Formulas are
//! derived in docs/geometry.md, which has the table of their errors too.

pub mod cylindrical;
pub mod depth;
pub mod distance;
pub mod exponential;
pub mod frame;
pub mod horizon;
pub mod library;
pub mod linear;
pub mod parts;
pub mod raised;
pub mod series;
pub mod sphere;
pub mod translation;
