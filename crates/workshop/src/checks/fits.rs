//! Aberrations and portals that do not fit and are closed, and walls of tunnels that stand across others.

use antipode_deformation::{Placed, Sides, SpaceError};
use antipode_rooms::{Room, SpaceSoFar, What, poses};
use glam::DVec3;

use super::Finding;
use crate::said::Said;

/// A wall is looked at in so many places along each of its edges.
const PLACES: usize = 15;
/// So far inside another tunnel a wall stands across it; less is the overlap of things that end together, metres.
const WITHIN_M: f64 = 0.02;

/// Two tunnels with walls that lie in one another so that a wall of one is inside the other, where one would walk; or that are
/// in the same place.
pub(crate) fn find_walls_across(room: &Room, so_far: &SpaceSoFar) -> Vec<Finding> {
    let placed = so_far.space.placed();
    let has_walls = |it: &Placed| it.aberration.sides == Sides::Walls;
    let mut found = Vec::new();
    for (number, one) in placed.iter().enumerate().filter(|(_, it)| has_walls(it)) {
        let others = one.neighbours.iter().map(|it| usize::from(*it));
        for second in others.filter(|it| *it > number && has_walls(&placed[*it])) {
            let other = &placed[second];
            let (object, partner) = (so_far.boxes[number], so_far.boxes[second]);
            let (id, object, partner) = match (holds(one, other), holds(other, one)) {
                (true, true) => ("same-place", partner, object),
                (false, false) if is_across(one, other) || is_across(other, one) => {
                    ("walls-across", object, partner)
                }
                _ => continue,
            };
            let name = |index: usize| room.objects[index].name.clone();
            found.push(Finding {
                said: Said::new(id)
                    .with("name", name(object))
                    .with("other", name(partner)),
                is_grave: false,
                objects: vec![name(object), name(partner)],
                at: (one.aberration.centre + other.aberration.centre) / 2.0,
            });
        }
    }
    found
}

/// Whether the other lies wholly in a box.
fn holds(it: &Placed, other: &Placed) -> bool {
    let corners = (0..8).map(|n| {
        let side = |bit: u32| if n >> bit & 1 == 1 { 1.0 } else { -1.0 };
        point(other, DVec3::new(side(0), side(1), side(2)))
    });
    let half = it.aberration.half + WITHIN_M;
    corners
        .into_iter()
        .all(|at| it.local(at).abs().cmple(half).all())
}

/// A place of a box, from -1 to 1 along each of its axes, in the scene.
fn point(it: &Placed, share: DVec3) -> DVec3 {
    it.aberration.centre + it.axes * (share * it.aberration.half)
}

/// Whether a wall of a tunnel stands in the inside of the other.
fn is_across(it: &Placed, other: &Placed) -> bool {
    let half = other.aberration.half - WITHIN_M;
    let at = |n: usize| (2.0 * n as f64 + 1.0) / PLACES as f64 - 1.0;
    let walls = (0..3).filter(|axis| it.aberration.is_wall(*axis));
    let faces = walls.flat_map(|axis| [(axis, -1.0), (axis, 1.0)]);
    faces.into_iter().any(|(axis, side)| {
        (0..PLACES * PLACES).any(|n| {
            let mut share = DVec3::ZERO;
            share[axis] = side;
            share[(axis + 1) % 3] = at(n % PLACES);
            share[(axis + 2) % 3] = at(n / PLACES);
            other.local(point(it, share)).abs().cmplt(half).all()
        })
    })
}

pub(crate) fn find(room: &Room, so_far: &SpaceSoFar) -> Vec<Finding> {
    if so_far.closed.is_empty() {
        return Vec::new();
    }
    let poses = poses(room);
    let told = so_far
        .closed
        .iter()
        .filter(|(index, error)| !is_told_already(room, *index, error));
    told.map(|(index, error)| {
        let name = &room.objects[*index].name;
        let (id, other) = id_of(error, name);
        let mut said = Said::new(id).with("name", name.clone());
        let mut objects = vec![name.clone()];
        if let Some(other) = other {
            said = said.with("other", other.clone());
            objects.push(other.clone());
        }
        Finding {
            said,
            is_grave: true,
            objects,
            at: poses[*index].translation,
        }
    })
    .collect()
}

/// A portal whose partner is closed has none any more; that is told of the partner.
fn is_told_already(room: &Room, index: usize, error: &SpaceError) -> bool {
    let What::Portal(portal) = &room.objects[index].what else {
        return false;
    };
    let partner = room.find(&portal.to);
    matches!(error, SpaceError::NoPartner { .. })
        && partner.is_some_and(|(_, it)| matches!(it.what, What::Portal(_)))
}

/// The id of what is wrong with an object, and who else has a part in it.
fn id_of<'e>(error: &'e SpaceError, own: &str) -> (&'static str, Option<&'e String>) {
    match error {
        SpaceError::Overlap { first, .. } => ("not-parallel", Some(first)),
        SpaceError::TooDeep { first, .. } => ("too-deep", Some(first)),
        SpaceError::TooTangled { .. } => ("tangled", None),
        SpaceError::NoDoor { .. } => ("no-door", None),
        SpaceError::NoPartner { .. } => ("no-partner", None),
        SpaceError::OneWay { partner, .. } => ("one-way", Some(partner)),
        SpaceError::OtherSides { partner, .. } => ("other-sides", Some(partner)),
        SpaceError::NotSimilar { partner, .. } => {
            ("not-similar", Some(partner).filter(|it| *it != own))
        }
        SpaceError::OtherSize { partner, .. } => ("other-size", Some(partner)),
        SpaceError::PortalShape { .. } => ("portal-shape", None),
        SpaceError::OverSide { aberration, .. } => ("over-side", Some(aberration)),
        SpaceError::InOddBox { aberration, .. } => ("in-odd-box", Some(aberration)),
        SpaceError::PortalsOverlap { first, .. } => ("portals-touch", Some(first)),
        _ => ("out-of-range", None),
    }
}
