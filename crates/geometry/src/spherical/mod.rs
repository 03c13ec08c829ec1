//! The three-sphere.

mod sphere;

pub use sphere::Spherical;
