//! What tests share.

use antipode_deformation::{Aberration, Place, Sides, Space, Trace, Traveller, Void, Ways, trace};
use glam::{DQuat, DVec3};

pub fn boxed(name: &str, centre: DVec3, half: DVec3, stretch: DVec3, sides: Sides) -> Aberration {
    Aberration {
        name: name.to_owned(),
        centre,
        turn: DQuat::IDENTITY,
        half,
        stretch,
        sides,
        ways: Ways::Both,
    }
}

pub fn space(aberrations: impl Into<Vec<Aberration>>) -> Space {
    Space::new(aberrations.into()).unwrap()
}

/// A path that meets no solids.
pub fn go(space: &Space, place: &Place, w: DVec3, length: f64) -> Trace {
    trace(space, place, w, length, &Void, &Traveller::Body)
}

pub fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}
