//! What lies under a point of the picture by the rule that light goes by, and by that of the thesis.

use antipode_deformation::{
    Aberration, Exit, PictureCorners, Sides, Space, Trace, Traveller, trace,
};
use glam::DVec2;
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
    /// By how much it is turned on its way where that is most, degrees: what leaves a box by the thesis's rule may be turned
    /// back.
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
            let go = |longest| trace(space, &eye.place, w, longest, &self.all_solids(), &who);
            let path = go(PICK_M);
            let pieces = middles(&path).map(|middle| w.angle_between(go(middle).w));
            let turned_rad = pieces.fold(0.0, f64::max);
            self.lying(&path, turned_rad)
        };
        Difference {
            exact: by(&self.space),
            thesis: by(&by_thesis(&self.space)),
        }
    }

    fn lying(&self, path: &Trace, turned_rad: f64) -> Lying {
        let hit = path.hit();
        Lying {
            object: hit.map(|hit| self.name_hit(hit.what)),
            felt: hit.map(|_| path.length),
            turned_deg: turned_rad.to_degrees(),
        }
    }
}

/// The middles of the pieces of a path between its faces, felt metres.
fn middles(path: &Trace) -> impl Iterator<Item = f64> {
    let ends = path.events.iter().map(|event| event.length);
    let mut from = 0.0;
    ends.chain([path.length]).map(move |to| {
        let middle = f64::midpoint(from, to);
        from = to;
        middle
    })
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
    let portals = space.portals().iter().map(|it| it.portal.clone());
    // They lie as before, and how they lie is all that can be refused of them; but no portal stands in a box of that rule.
    Space::with_portals(all.clone().collect(), portals.collect())
        .or_else(|_| Space::new(all.collect()))
        .unwrap_or_else(|_| space.clone())
}
