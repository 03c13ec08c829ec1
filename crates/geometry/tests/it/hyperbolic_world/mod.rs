//! The hyperbolic world, and the charts of bodies in it and on the sphere.

mod atlas;
mod bodies;
mod common;
mod near;
mod north;
mod picture;
mod robust;
mod walks;
