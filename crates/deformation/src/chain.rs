//! A way that is held to faces and portals named beforehand, whatever their edges: what an editor drags along.
//!
//! A ray that is turned a little goes through the same faces, until it comes to the edge of one and jumps elsewhere. A
//! [`Chain`] keeps to the planes of its faces and portals beyond their edges, so that the place of its end is a smooth
//! function of the direction in which it set out: in each piece the path is x + t K w, and the next plane n.x = c is met
//! at t = (c - n.x) / (n.K w).

use glam::{DMat3, DVec3};

use crate::face::{Crossing, State, cross};
use crate::place::Place;
use crate::space::{Space, Traveller};
use crate::trace::{EventKind, Trace};

/// A face or a portal on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Link {
    /// The face of box `number` across `axis`, on the side of that sign.
    Face {
        number: usize,
        axis: usize,
        side: f64,
        kind: EventKind,
    },
    /// A portal that is gone into, before its front or from behind.
    Portal { number: usize, front: bool },
}

/// Faces and portals in the order in which they are gone through.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain(Vec<Link>);

/// The last piece of a way that was held to a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Where the last face or portal was left; where the way began if there was none.
    pub place: Place,
    /// Scene metres for each felt metre of the traveller's own size, in the direction in which it goes.
    pub velocity: DVec3,
    /// The felt direction in the axes of the scene, of length 1.
    pub w: DVec3,
    /// Felt metres up to there.
    pub length: f64,
}

impl Chain {
    /// The chain of a path that began at `start`.
    pub fn of(space: &Space, start: &Place, path: &Trace) -> Self {
        let mut from = start.point;
        let links = path.events.iter().map(|event| {
            let way = event.point - from;
            from = event.onward;
            if event.kind == EventKind::Passed {
                let normal = space.portals()[event.number].normal;
                return Link::Portal {
                    number: event.number,
                    front: normal.dot(way) < 0.0,
                };
            }
            let placed = &space.placed()[event.number];
            let share = placed.local(event.point) / placed.aberration.half;
            let axis = (0..3).fold(0, |best, axis| {
                if share[axis].abs() > share[best].abs() {
                    axis
                } else {
                    best
                }
            });
            Link::Face {
                number: event.number,
                axis,
                side: share[axis].signum(),
                kind: event.kind,
            }
        });
        Self(links.collect())
    }

    /// Its first faces and portals, so many.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        Self(self.0.iter().take(count).copied().collect())
    }

    /// Whether nothing is gone through.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many faces and portals are gone through.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether a portal is gone through.
    pub fn has_portal(&self) -> bool {
        self.0.iter().any(|it| matches!(it, Link::Portal { .. }))
    }

    /// The last piece of the way from a place in felt direction `w`, of length 1, of the traveller's own axes. None where
    /// the way does not come to one of the planes, or is turned back where it was not.
    pub fn follow(&self, space: &Space, start: &Place, w: DVec3, who: &Traveller) -> Option<Leg> {
        let mut place = *start;
        let w = start.turn * w;
        let mut state = State {
            w,
            stack: start.stack,
            unbent: w,
        };
        let mut length = 0.0;
        for link in &self.0 {
            let v = velocity(space, &place, &state, who);
            let time = link.time(space, &place, v)?;
            place.point += time * v;
            length += time;
            link.pass(space, &mut place, &mut state, who)?;
            place.stack = state.stack;
        }
        Some(Leg {
            velocity: velocity(space, &place, &state, who),
            w: state.w,
            place,
            length,
        })
    }
}

impl Link {
    /// When a straight path comes to the plane.
    fn time(&self, space: &Space, place: &Place, v: DVec3) -> Option<f64> {
        let (off, speed) = match *self {
            Self::Face {
                number, axis, side, ..
            } => {
                let placed = &space.placed()[number];
                let face = side * placed.aberration.half[axis];
                let l = placed.local(place.point)[axis];
                (face - l, placed.axes.col(axis).dot(v))
            }
            Self::Portal { number, .. } => {
                let portal = &space.portals()[number];
                (-portal.before(place.point), portal.normal.dot(v))
            }
        };
        let time = off / speed;
        (time.is_finite() && time >= -1e-9).then_some(time)
    }

    fn pass(
        &self,
        space: &Space,
        place: &mut Place,
        state: &mut State,
        who: &Traveller,
    ) -> Option<()> {
        match *self {
            Self::Portal { number, front } => {
                state.pass(space, place, number, front);
                Some(())
            }
            Self::Face {
                number, axis, kind, ..
            } => {
                let enters = match kind {
                    EventKind::Entered => true,
                    EventKind::Left => false,
                    EventKind::Reflected | EventKind::Passed => !state.stack.contains(number),
                };
                let crossing = cross(space, state, (number, axis), enters, who);
                let is_back = kind == EventKind::Reflected;
                let is_as_before = match crossing {
                    Crossing::Through => !is_back,
                    Crossing::Reflected => is_back,
                    Crossing::Wall => false,
                };
                is_as_before.then_some(())
            }
        }
    }
}

fn velocity(space: &Space, place: &Place, state: &State, who: &Traveller) -> DVec3 {
    let k: DMat3 = space.squeeze(&state.stack, state.w, who) * place.scale;
    k * state.w
}
