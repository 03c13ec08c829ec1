//! What body an object of a room is that is loose.

use antipode_physics::{LooseBody, LooseShape};
use antipode_rooms::What;
use antipode_rooms::mesh::{Roundness, shape};
use glam::DVec3;

use crate::tuning::THROWN;

/// Parts of a full turn of what is round, for who walks into it; of what is thrown.
const AROUND: [u32; 2] = [16, 8];

/// The centre of mass about the middle of its box: that of a pyramid lies at a quarter of its height, that of a wedge at a third
/// of its height and at a third of its length from its steep side.
pub fn middle(what: &What) -> DVec3 {
    match what {
        What::Pyramid { size } => DVec3::new(0.0, -size.y / 4.0, 0.0),
        What::Ramp { size } => DVec3::new(size.x / 6.0, -size.y / 6.0, 0.0),
        _ => DVec3::ZERO,
    }
}

/// The triangles of its surface about the middle of its box.
pub fn surface(what: &What) -> Vec<[DVec3; 3]> {
    rounded(what, AROUND[0])
}

fn rounded(what: &What, around: u32) -> Vec<[DVec3; 3]> {
    let coarse = shape(what, Roundness { around }).unwrap_or_default();
    let corner = |it: u32| coarse.positions[it as usize];
    coarse.triangles.iter().map(|it| it.map(corner)).collect()
}

/// A ball that is thrown, and its surface.
pub fn ball() -> (LooseBody, Vec<[DVec3; 3]>) {
    let radius = THROWN.radius_m;
    let made = LooseBody {
        shape: LooseShape::Ball(radius),
        mass_kg: THROWN.mass_kg,
        friction: 0.6,
        bounce: THROWN.bounce,
        spin_damping_per_s: THROWN.spin_damping_per_s,
    };
    (made, rounded(&What::Ball { radius }, AROUND[1]))
}

/// The body that it is, of that mass.
pub fn made(what: &What, mass_kg: f64) -> Option<LooseBody> {
    let (shape, bounce, spin_damping_per_s) = match what {
        What::Box { size } => (LooseShape::Block(*size / 2.0), 0.1, 0.1),
        What::Ball { radius } => (LooseShape::Ball(*radius), 0.55, 0.6),
        What::Cylinder { radius, height } => {
            let (radius, half_height) = (*radius, height / 2.0);
            let round = LooseShape::Cylinder {
                radius,
                half_height,
            };
            (round, 0.15, 0.4)
        }
        What::Pyramid { .. } | What::Ramp { .. } => {
            let corners = surface(what).into_iter().flatten();
            let corners = corners.map(|it| it - middle(what)).collect();
            (LooseShape::Hull(corners), 0.1, 0.1)
        }
        _ => return None,
    };
    Some(LooseBody {
        shape,
        mass_kg,
        friction: 0.6,
        bounce,
        spin_damping_per_s,
    })
}
