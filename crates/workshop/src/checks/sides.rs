//! Tunnels with open sides: boxes that are stretched along one axis and have no walls of their own, where nothing that stands
//! there takes the place of walls. Who looks in from the side sees space bent.

use antipode_deformation::{Place, SceneQuery, Sides};
use antipode_rooms::{Room, SpaceSoFar};
use glam::DVec3;

use super::ground::Ground;
use super::{Finding, GoesOn};
use crate::said::Said;

/// A side is looked at in so many places along each of its edges.
const PLACES: usize = 7;
/// What stands so far before or behind a side, metres, covers it.
const NEAR_M: f64 = 0.6;
/// So much of the sides may be open: cracks between walls.
const MOST_OPEN: f64 = 0.05;
/// A stretch nearer to 1 is none.
const LEAST_STRETCH: f64 = 1e-3;

pub(crate) fn find(
    room: &Room,
    so_far: &SpaceSoFar,
    ground: &Ground<'_>,
    goes_on: GoesOn<'_>,
    found: &mut Vec<Finding>,
) {
    for (number, object) in so_far.boxes.iter().enumerate() {
        if !goes_on() {
            return;
        }
        let Some(open) = open_side(ground, number) else {
            continue;
        };
        let name = room.objects[*object].name.clone();
        found.push(Finding {
            said: Said::new("open-sides").with("name", name.clone()),
            is_grave: false,
            objects: vec![name],
            at: open,
        });
    }
}

/// An open place of the sides of a tunnel, if more than cracks are open.
fn open_side(ground: &Ground<'_>, number: usize) -> Option<DVec3> {
    let placed = &ground.space.placed()[number];
    let it = &placed.aberration;
    let stretched: Vec<_> = (0..3)
        .filter(|i| (it.stretch[*i] - 1.0).abs() > LEAST_STRETCH)
        .collect();
    let ([along], true) = (
        stretched.as_slice(),
        matches!(it.sides, Sides::Soft | Sides::Snell),
    ) else {
        return None;
    };
    // What is shut at both of its ends is no tunnel: one goes through it across, by what would be its sides.
    let has_end = [-1.0, 1.0].into_iter().any(|side| {
        let open = open_places(ground, number, (*along, side));
        open.len() * 2 > PLACES * PLACES
    });
    let across = (0..3).filter(|axis| axis != along);
    let faces = across.flat_map(|axis| [(axis, -1.0), (axis, 1.0)]);
    let open: Vec<_> = faces
        .flat_map(|face| open_places(ground, number, face))
        .collect();
    let is_open = open.len() as f64 > MOST_OPEN * (4 * PLACES * PLACES) as f64;
    (has_end && is_open).then(|| open[open.len() / 2])
}

/// The places of a face that nothing covers. A face is told by its axis and its side of that.
fn open_places(ground: &Ground<'_>, number: usize, (axis, side): (usize, f64)) -> Vec<DVec3> {
    let placed = &ground.space.placed()[number];
    let it = &placed.aberration;
    let outward = placed.axes.col(axis) * side;
    let of_face = places().map(|place| {
        let mut local = DVec3::ZERO;
        local[axis] = side;
        local[(axis + 1) % 3] = place.0;
        local[(axis + 2) % 3] = place.1;
        it.centre + placed.axes * (local * it.half)
    });
    of_face
        .filter(|at| !is_covered(ground, *at, outward, it.half[axis]))
        .collect()
}

/// Places of a face, from -1 to 1 along each edge, none at its rim.
fn places() -> impl Iterator<Item = (f64, f64)> {
    let at = |n: usize| (2.0 * n as f64 + 1.0) / PLACES as f64 - 1.0;
    (0..PLACES * PLACES).map(move |n| (at(n % PLACES), at(n / PLACES)))
}

/// Whether something solid is just before or behind a place of a side, or around it.
fn is_covered(ground: &Ground<'_>, at: DVec3, outward: DVec3, half: f64) -> bool {
    let (within, beyond) = (NEAR_M.min(half), NEAR_M);
    let (from, length) = (at - outward * within, within + beyond);
    ground.solids.first(from, outward, length).is_some()
        || !ground.solids_around(at).is_empty()
        || has_wall(ground, at, outward)
}

/// Whether the wall of another box is there.
fn has_wall(ground: &Ground<'_>, at: DVec3, outward: DVec3) -> bool {
    let place = Place::at(ground.space, at + outward * 1e-3);
    let way = ground.go(&place, outward, NEAR_M);
    way.hit().is_some()
}
