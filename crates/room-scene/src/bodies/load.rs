//! What stands on a body without being one: who walks.

use antipode_deformation::felt_gravity;
use glam::DVec3;

use super::{Around, Bodies, Body, Owner};

/// Who stands elsewhere by more than this, metres, has moved.
const MOVED_M: f64 = 0.03;

/// What weighs on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Where, metres of the scene.
    pub at: DVec3,
    /// Kilograms.
    pub mass_kg: f64,
}

impl Bodies {
    /// That is what weighs on a body from now on, and nothing on all others.
    pub fn bear(&mut self, load: Option<(Owner, Load)>) {
        for body in &mut self.all {
            let load = load.filter(|it| it.0 == body.owner).map(|it| it.1);
            let is_same = match (&load, &body.load) {
                (Some(now), Some(before)) => now.at.distance(before.at) < MOVED_M,
                (now, before) => now.is_none() && before.is_none(),
            };
            if !is_same {
                (body.load, body.laid, body.rests) = (load, None, false);
            }
        }
    }

    /// Tells rapier what weighs on its bodies.
    pub(super) fn weigh(&mut self, around: &Around<'_>) {
        for (number, body) in self.all.iter().enumerate() {
            let (share, at) = body.pressed(around);
            let at = body.frame.place(body.squeeze.inverse() * at);
            self.solver
                .load(number, body.frame.way(share * body.place.scale), at);
        }
    }
}

impl Body {
    /// The acceleration that its load would give it if nothing held it, felt metres of its own size per second squared, and where.
    fn pressed(&self, around: &Around<'_>) -> (DVec3, DVec3) {
        let Some(load) = self.load else {
            return (DVec3::ZERO, self.place.point);
        };
        let falls = felt_gravity(self.squeeze, around.g);
        (falls * (load.mass_kg / self.mass_kg()), load.at)
    }
}
