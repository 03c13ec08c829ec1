//! What is solid about a body, in the frame in which rapier has it: what `show_cut` shows at its place, that is, of this side of
//! portals and of the other.

use antipode_deformation::{Space, Stack, show_cut};
use antipode_physics::LooseBodies;
use glam::{DMat3, DVec3};

use super::frame::Frame;
use super::{Around, Body};

/// Felt metres that a body may come nearer to what is not shown yet.
const NEAR_M: f64 = 0.03;
/// What is shown about a body reaches farther than it does by this much, felt metres, and by this share of its size.
const MORE: (f64, f64) = (0.25, 0.3);

/// For what the ground of a body was gathered.
#[derive(Clone, Debug)]
pub struct Region {
    low: DVec3,
    high: DVec3,
    stack: Stack,
    squeeze: DMat3,
    scale: f64,
    frame: Frame,
    /// On which side of portals near by it is.
    sides: Vec<(usize, bool)>,
}

impl Body {
    /// The box in the scene about all that is within so many felt metres of its own size.
    fn about(&self, reach: f64) -> (DVec3, DVec3) {
        let half = self.out().abs() * DVec3::splat(reach);
        (self.place.point - half, self.place.point + half)
    }

    /// Sees to it that rapier knows what is solid about it for the next `time` seconds.
    pub fn tread(
        &mut self,
        number: usize,
        around: &Around<'_>,
        solver: &mut LooseBodies,
        time: f64,
    ) {
        let goes = (self.velocity.length() + around.g.length() * time) * time;
        let (low, high) = self.about(self.reach_m + NEAR_M + goes);
        if self
            .region
            .as_ref()
            .is_some_and(|it| it.serves(self, (low, high), around.space))
        {
            return;
        }
        let reach = self.reach_m * (1.0 + MORE.1) + MORE.0 + 3.0 * goes;
        let (low, high) = self.about(reach);
        let (mut solids, mut walls) = (Vec::new(), Vec::new());
        let (into, frame) = (self.squeeze.inverse(), self.frame);
        let mut show = |corners: [DVec3; 3], two_sided: bool| {
            let here = corners.map(|it| frame.place(into * it));
            let list = if two_sided { &mut walls } else { &mut solids };
            list.push(here);
        };
        show_cut(
            around.space,
            around.solids,
            &self.place,
            (low, high),
            &mut show,
        );
        solver.set_ground(number, &solids, &walls);
        self.region = Some(Region {
            low,
            high,
            stack: self.place.stack,
            squeeze: self.squeeze,
            scale: self.place.scale,
            frame,
            sides: sides(self, around.space, (low, high)),
        });
    }
}

impl Region {
    fn serves(&self, body: &Body, (low, high): (DVec3, DVec3), space: &Space) -> bool {
        self.stack == body.place.stack
            && self.squeeze == body.squeeze
            && self.scale == body.place.scale
            && self.frame == body.frame
            && low.cmpge(self.low).all()
            && high.cmple(self.high).all()
            && self.sides == sides(body, space, (self.low, self.high))
    }
}

/// On which side of portals that reach into a box of the scene a body is.
fn sides(body: &Body, space: &Space, (low, high): (DVec3, DVec3)) -> Vec<(usize, bool)> {
    let all = space.portals().iter().enumerate();
    let near = all.filter(|(_, portal)| {
        let reaches = |outside: fn(DVec3, DVec3, DVec3) -> bool| {
            !portal.corners.iter().all(|it| outside(*it, low, high))
        };
        reaches(|it, low, _| it.x < low.x)
            && reaches(|it, low, _| it.y < low.y)
            && reaches(|it, low, _| it.z < low.z)
            && reaches(|it, _, high| it.x > high.x)
            && reaches(|it, _, high| it.y > high.y)
            && reaches(|it, _, high| it.z > high.z)
    });
    near.map(|(number, portal)| {
        let place = &body.place;
        let side = portal.side(number, place.point, -portal.normal, place.passage);
        (number, side)
    })
    .collect()
}
