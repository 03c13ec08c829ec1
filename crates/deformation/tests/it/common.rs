//! What tests share.

use antipode_deformation::{
    Aberration, Place, Portal, Sides, Space, Trace, Traveller, Void, Ways, trace,
};
use glam::{DQuat, DVec2, DVec3};

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

/// A portal of 2 x 2 m with one side, whose front looks along the yaw, from +x towards +z.
pub fn portal(name: &str, at: DVec3, yaw_deg: f64, to: usize) -> Portal {
    Portal {
        name: name.to_owned(),
        at,
        turn: DQuat::from_rotation_y(-yaw_deg.to_radians()),
        polygon: Portal::rectangle(DVec2::splat(2.0)),
        to,
        two_sided: false,
    }
}
