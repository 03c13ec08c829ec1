//! Who walks, as what is loose meets them: a capsule of their size that goes as they go, whatever strikes it.

use antipode_deformation::{Place, Space, Traveller};
use antipode_physics::{LooseBody, LooseShape};
use glam::{DQuat, DVec3};

use super::{Bodies, Body, Owner};
use crate::tuning::{RADIUS_M, SHAPE, WALKER_MASS_KG};

/// What is loose comes nearer to who walks than they go to it by this, felt metres, so that who only stands there moves nothing.
const NEARER_M: f64 = 0.02;
/// Moved by more than this, metres, it is put back.
const MOVED_M: f64 = 1e-6;

impl Bodies {
    /// Who walks is there, upright along `up`, felt and of length 1, and goes so fast, by the axes of the scene.
    pub fn set_who(&mut self, space: &Space, place: Place, up: DVec3, velocity: DVec3) {
        let turn = DQuat::from_rotation_arc(DVec3::Y, up);
        let Some(body) = self.of(Owner::Walker) else {
            self.put(who(place, turn, space));
            return;
        };
        let squeeze = space.squeeze(&place.stack, velocity, &Traveller::Body);
        let is_there = body.place == place && body.squeeze == squeeze;
        if !is_there || body.velocity != velocity || body.turn != turn {
            (body.place, body.turn, body.velocity) = (place, turn, velocity);
            (body.squeeze, body.laid) = (squeeze, None);
        }
    }

    /// Puts who walks back to where they are, if rapier has moved them.
    pub(super) fn hold_still(&mut self, number: usize) {
        let body = &mut self.all[number];
        let moved = self.solver.motion(number);
        let is_there = moved
            .zip(body.laid)
            .is_some_and(|(now, laid)| now.place.distance(laid) < MOVED_M);
        if !is_there {
            body.laid = None;
        }
    }
}

fn who(place: Place, turn: DQuat, space: &Space) -> Body {
    let (radius, half_height) = (RADIUS_M - NEARER_M, SHAPE.axis_m() / 2.0);
    let made = LooseBody {
        shape: LooseShape::Capsule {
            radius,
            half_height,
        },
        mass_kg: WALKER_MASS_KG,
        friction: 0.2,
        bounce: 0.0,
        spin_damping_per_s: 0.0,
    };
    let mut body = Body::new(Owner::Walker, made, Vec::new(), (place.point, turn));
    body.stand(place, space);
    body.reach_m = radius + half_height;
    body
}
