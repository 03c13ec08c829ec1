//! Aberrations and portals that do not fit and are closed.

use antipode_deformation::SpaceError;
use antipode_rooms::{Room, SpaceSoFar, What, poses};

use super::Finding;
use crate::said::Said;

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
