//! What lies under a point of the picture by the rule that light goes by, and by that of the thesis.

use antipode_deformation::{
    Aberration, Exit, PictureCorners, Sides, Space, Trace, Traveller, trace,
};
use glam::{DVec2, DVec3};
use serde::Serialize;

use crate::scene::RoomScene;
use crate::tuning::PICK_M;

/// What a rule shows at a point of the picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Lying {
    /// The object; null for the sky.
    pub object: Option<String>,
    /// How far off it feels, metres.
    pub felt: Option<f64>,
    /// By how much light from there is turned on its way, degrees.
    pub turned_deg: f64,
}

/// The same by each rule.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// As light goes.
    pub exact: Lying,
    /// By the thesis's rule for all aberrations.
    pub thesis: Lying,
}

impl RoomScene {
    /// What lies under a point of the picture, from -1 at its left and bottom to 1, by each rule. `aspect` is the picture's
    /// width over its height.
    pub fn difference(&self, at: DVec2, aspect: f64) -> Difference {
        let eye = self.eye();
        let w = eye.direction(at.x, at.y, aspect);
        let corner = |side: f64| eye.direction(side, side, aspect);
        let who = Traveller::Light(PictureCorners::new(corner(-1.0), corner(1.0)));
        let by = |space: &Space| {
            let path = trace(space, &eye.place, w, PICK_M, &self.solids, &who);
            self.lying(&path, w)
        };
        Difference {
            exact: by(&self.space),
            thesis: by(&by_thesis(&self.space)),
        }
    }

    fn lying(&self, path: &Trace, w: DVec3) -> Lying {
        let hit = path.hit();
        Lying {
            object: hit.map(|hit| self.room().objects[self.object_of(hit.what)].name.clone()),
            felt: hit.map(|_| path.length),
            turned_deg: w.angle_between(path.w).to_degrees(),
        }
    }
}

/// All aberrations with the thesis's rule, in the same order.
fn by_thesis(space: &Space) -> Space {
    let turned = |aberration: &Aberration| Aberration {
        sides: match aberration.sides {
            Sides::Legacy(exit) => Sides::Legacy(exit),
            _ => Sides::Legacy(Exit::Original),
        },
        ..aberration.clone()
    };
    let all = space.placed().iter().map(|it| turned(&it.aberration));
    // They lie as before, and how they lie is all that can be refused of them.
    Space::new(all.collect()).unwrap_or_else(|_| space.clone())
}
