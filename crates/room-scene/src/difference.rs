//! The exact rule beside that of the thesis: what one and the same place of the picture shows by each.

use antipode_deformation::{Exit, PictureCorners, Sides, Space, Traveller};

use crate::pick::Pick;
use crate::scene::RoomScene;

/// What the middle of the picture shows by either rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// By the exact rule, which bends nothing.
    pub exact: Pick,
    /// By the thesis's, for all aberrations; its lengths are those of the scene.
    pub thesis: Pick,
    /// How far apart in the scene both places are, metres; none where either is the sky.
    pub apart_m: Option<f64>,
}

impl RoomScene {
    /// What the middle of a picture of that width over height shows by either rule. None where the thesis's cannot be applied.
    pub fn difference(&self, aspect: f64) -> Option<Difference> {
        let eye = self.eye();
        let corners = PictureCorners::new(
            eye.direction(-1.0, -1.0, aspect),
            eye.direction(1.0, 1.0, aspect),
        );
        let space = by_the_thesis(&self.space)?;
        let (exact, here) = self.pick_by(&self.space, &Traveller::Body);
        let (thesis, there) = self.pick_by(&space, &Traveller::Light(corners));
        let are_hits = exact.object.is_some() && thesis.object.is_some();
        Some(Difference {
            apart_m: are_hits.then(|| here.distance(there)),
            exact,
            thesis,
        })
    }
}

/// The same boxes with the thesis's rule; those that have it keep their exit.
fn by_the_thesis(space: &Space) -> Option<Space> {
    let all = space.placed().iter().map(|placed| {
        let mut it = placed.aberration.clone();
        if !matches!(it.sides, Sides::Legacy(_)) {
            it.sides = Sides::Legacy(Exit::Original);
        }
        it
    });
    Space::new(all.collect()).ok()
}
