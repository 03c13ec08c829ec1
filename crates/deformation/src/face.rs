//! What a face does to who comes to it.

use glam::DVec3;

use crate::aberration::{Exit, Sides};
use crate::place::{Passage, Place};
use crate::space::{Space, Traveller};
use crate::stack::Stack;

/// A traveller as faces know it.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// Felt direction in the axes of the scene, of length 1.
    pub w: DVec3,
    /// The boxes that it is in.
    pub stack: Stack,
    /// Its direction before the thesis's rule bent it.
    pub unbent: DVec3,
}

impl State {
    /// Goes through a portal, before its front or from behind: x <- G x, w <- O w, and the stack is that of the new place.
    pub fn pass(&mut self, space: &Space, place: &mut Place, number: usize, front: bool) {
        let portal = &space.portals()[number];
        let partner = &space.portals()[portal.portal.to];
        self.w = (portal.turn * self.w).normalize();
        self.unbent = portal.turn * self.unbent;
        self.stack = partner.stack;
        *place = Place {
            point: portal.passed(partner, place.point),
            stack: partner.stack,
            scale: place.scale * portal.scale,
            turn: (portal.turn * place.turn).normalize(),
            passage: Passage {
                count: place.passage.count.wrapping_add(1).max(1),
                portal: portal.portal.to as u8,
                front,
            },
        };
    }
}

/// What became of a traveller at a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// It went through.
    Through,
    /// It was turned back.
    Reflected,
    /// The face is a wall.
    Wall,
}

/// Takes a traveller through a face of box `number` across axis `axis`, into it or out of it.
pub fn cross(
    space: &Space,
    state: &mut State,
    (number, axis): (usize, usize),
    enters: bool,
    who: &Traveller,
) -> Crossing {
    let placed = &space.placed()[number];
    if placed.aberration.is_wall(axis) {
        return Crossing::Wall;
    }
    let mut beyond = state.stack;
    if enters {
        space.push(&mut beyond, number);
    } else {
        beyond.remove(number);
    }
    match (placed.aberration.sides, who) {
        (Sides::Snell, _) => {
            let normal = placed.axes.col(axis);
            match refracted(space, state, &beyond, normal, who) {
                Ok(w) => state.w = w,
                Err(w) => {
                    state.w = w;
                    return Crossing::Reflected;
                }
            }
        }
        (Sides::Legacy(exit), Traveller::Light(corners)) if placed.is_felt(state.unbent) => {
            if enters {
                state.unbent = state.w;
                state.w = corners.bend(state.w, placed.legacy);
            } else {
                state.w = match exit {
                    Exit::Original => state.unbent,
                    Exit::Inverse => corners.bend(state.w, -placed.legacy),
                    Exit::None => state.w,
                };
            }
        }
        _ => {}
    }
    state.stack = beyond;
    Crossing::Through
}

/// The felt direction behind a face of normal n at which the tangential part of the covector is kept, or that of one who is
/// totally reflected.
///
/// A path of least felt length has the covector p = A^T w with A = K^-1. Behind the face p' = p + l n, and |K'^T p'| = 1:
/// with a = |m|^2 and b = q.m for m = K'^T n, q = K'^T p, that is a l^2 + 2 b l + |q|^2 - 1 = 0. The speed across the face is
/// n.K'K'^T p' = b + a l, so the root is that of the sign that it had. Without a root w is mirrored at K^T n.
fn refracted(
    space: &Space,
    state: &State,
    beyond: &Stack,
    n: DVec3,
    who: &Traveller,
) -> Result<DVec3, DVec3> {
    let here = space.squeeze(&state.stack, state.w, who);
    let there = space.squeeze(beyond, state.w, who);
    let p = here.inverse().transpose() * state.w;
    let (m, q) = (there.transpose() * n, there.transpose() * p);
    let (a, b) = (m.length_squared(), q.dot(m));
    let left = b * b - a * (q.length_squared() - 1.0);
    if left < 0.0 {
        let mirror = (here.transpose() * n).normalize();
        return Err((state.w - 2.0 * state.w.dot(mirror) * mirror).normalize());
    }
    let ahead = n.dot(here * state.w).signum();
    let l = (ahead * left.sqrt() - b) / a;
    Ok((q + l * m).normalize())
}
