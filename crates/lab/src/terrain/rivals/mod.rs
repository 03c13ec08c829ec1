//! Other people's noise and meshers, set to the same work as ours: one file for each kind. Crates are named with
//! the version they were built from; what is said about each is from its own documentation.

mod meshers;
mod noises;

pub use meshers::meshers;
pub use noises::noises;
