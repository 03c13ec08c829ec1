//! Parts that cannot be reached: insides of aberrations and fronts of portals where somebody could stand, but to which nobody can
//! walk who begins where one begins. And places near the beginning where one falls out of the room.
//!
//! A search that ends before it has been everywhere proves nothing, so one is made from the part, too: a part from which one comes
//! only to few places, none of which can be reached, cannot be reached itself, unless one falls into it.

use antipode_deformation::Place;
use antipode_rooms::{Room, SpaceSoFar};
use glam::DVec3;

use super::cells::Cells;
use super::flood::{Flood, Reached};
use super::ground::Ground;
use super::{Finding, GoesOn};
use crate::said::Said;

/// From how many places the search goes on at most, and that from a part.
const MOST_PLACES: usize = 9000;
const MOST_AROUND_PART: usize = 1500;
/// Falling out is told of places to which one walks no farther, felt metres.
const NEAR_M: f64 = 40.0;
/// How far before its front a portal is stood before, felt metres.
const BEFORE_M: f64 = 0.5;

/// Something that is to be reached.
struct Part {
    object: usize,
    kind: Kind,
    /// Somebody who stands there.
    stands: Place,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Box(usize),
    Portal(usize),
}

pub(crate) fn find(
    room: &Room,
    so_far: &SpaceSoFar,
    ground: &Ground<'_>,
    start: &Place,
    goes_on: GoesOn<'_>,
    found: &mut Vec<Finding>,
) {
    let mut parts = parts(so_far, ground);
    let cells = Cells::new(ground);
    let mut flood = Flood::new(&cells, start);
    let is_everywhere = spread(ground, &mut flood, &mut parts, goes_on);
    if !goes_on() {
        return;
    }
    if let Some((at, walked_m)) = flood.void.filter(|it| it.1 <= NEAR_M) {
        let said = Said::new("fall-out").with_number("metres", walked_m.round());
        found.push(Finding {
            said,
            is_grave: false,
            objects: Vec::new(),
            at,
        });
    }
    for part in parts {
        if !(is_everywhere || is_shut_off(&cells, &flood, &part, goes_on)) || !goes_on() {
            continue;
        }
        let name = room.objects[part.object].name.clone();
        found.push(Finding {
            said: Said::new("unreached").with("name", name.clone()),
            is_grave: false,
            objects: vec![name],
            at: part.stands.point,
        });
    }
}

/// The parts in which somebody could stand.
fn parts(so_far: &SpaceSoFar, ground: &Ground<'_>) -> Vec<Part> {
    let boxes = so_far
        .boxes
        .iter()
        .enumerate()
        .filter_map(|(number, object)| {
            Some(Part {
                object: *object,
                kind: Kind::Box(number),
                stands: stands_in(ground, number)?,
            })
        });
    let portals = so_far
        .portals
        .iter()
        .enumerate()
        .filter_map(|(number, object)| {
            Some(Part {
                object: *object,
                kind: Kind::Portal(number),
                stands: stands_before(ground, number)?,
            })
        });
    boxes.chain(portals).collect()
}

fn stands_in(ground: &Ground<'_>, number: usize) -> Option<Place> {
    let placed = &ground.space.placed()[number];
    let it = &placed.aberration;
    let tried = [
        DVec3::ZERO,
        DVec3::X,
        -DVec3::X,
        DVec3::Z,
        -DVec3::Z,
        DVec3::Y,
        -DVec3::Y,
    ];
    tried.iter().find_map(|side| {
        let at = it.centre + placed.axes * (*side * 0.5 * it.half);
        let stands = ground.standing_below(&Place::at(ground.space, at))?;
        let is_clear = ground.solids_around(stands.point).is_empty();
        (is_clear && stands.stack.contains(number)).then_some(stands)
    })
}

fn stands_before(ground: &Ground<'_>, number: usize) -> Option<Place> {
    let portal = &ground.space.portals()[number];
    let corners = &portal.corners;
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let on = Place::at(ground.space, middle + portal.normal * 1e-6);
    let out = (portal.squeeze.inverse() * portal.normal).normalize();
    let before = ground.go(&on, out, BEFORE_M).place;
    ground.standing_below(&before)
}

/// Spreads until all parts are reached and what is near has been looked at; whether it has been everywhere then. Parts that are
/// reached are taken off the list.
fn spread(
    ground: &Ground<'_>,
    flood: &mut Flood<'_>,
    parts: &mut Vec<Part>,
    goes_on: GoesOn<'_>,
) -> bool {
    let mut seen = 0;
    let mut had = usize::MAX;
    for _ in 0..MOST_PLACES {
        let reached = &flood.reached()[seen..];
        parts.retain(|it| !reached.iter().any(|at| is_there(ground, it, &at.place)));
        parts.retain(|it| !is_passed(ground, it, flood));
        seen = flood.reached().len();
        let places: Vec<_> = parts.iter().map(|it| it.stands.point).collect();
        let key = move |it: &Reached| key(it, &places);
        if parts.len() != had {
            had = parts.len();
            flood.reorder(&key);
        }
        let is_near = flood.least_key().is_some_and(|it| it <= NEAR_M);
        if !goes_on() || (parts.is_empty() && !is_near) {
            return parts.is_empty();
        }
        if !flood.go_on(&key) {
            return true;
        }
    }
    parts.is_empty()
}

/// What is near the beginning is looked at first; of the rest, what is near a part that is not reached: of a cell
/// another side may be nearer than that at which one came to it.
fn key(it: &Reached, parts: &[DVec3]) -> f64 {
    let nearest = parts
        .iter()
        .map(|at| (at.distance(it.place.point) - it.cell.edge_m()).max(0.0))
        .fold(f64::INFINITY, f64::min);
    if nearest.is_finite() {
        nearest + 0.5 * it.walked_m
    } else {
        it.walked_m
    }
}

fn is_there(ground: &Ground<'_>, part: &Part, at: &Place) -> bool {
    match part.kind {
        Kind::Box(number) => at.stack.contains(number),
        Kind::Portal(number) => {
            let portal = &ground.space.portals()[number];
            let near = part.stands.point.distance(portal.portal.at) * 2.0 + 1e-6;
            at.stack == part.stands.stack
                && at.point.distance(part.stands.point) < near
                && ground.is_open_between(at, &part.stands)
        }
    }
}

fn is_passed(ground: &Ground<'_>, part: &Part, flood: &Flood<'_>) -> bool {
    let Kind::Portal(number) = part.kind else {
        return false;
    };
    let partner = ground.space.portals()[number].portal.to;
    flood.passed.contains(&number) || flood.passed.contains(&partner)
}

/// Whether one comes from a part only to few places, and none of them was reached.
fn is_shut_off(cells: &Cells<'_>, reached: &Flood<'_>, part: &Part, goes_on: GoesOn<'_>) -> bool {
    let mut around = Flood::new(cells, &part.stands);
    for _ in 0..MOST_AROUND_PART {
        if !goes_on() {
            return false;
        }
        if !around.go_on(&|it| it.walked_m) {
            return !around.meets(reached);
        }
    }
    false
}
