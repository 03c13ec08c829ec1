//! The space of a room in an editor: aberrations and portals that do not fit are closed, as though they were not there, until
//! they do, and what is wrong with each is told.

use antipode_deformation as deformation;
use deformation::{Space, SpaceError};

use crate::room::Room;
use crate::space::{aberrations, portals, without};

/// The space of a room that may have aberrations and portals that do not fit.
#[derive(Debug, Clone, Default)]
pub struct SpaceSoFar {
    /// The space of those that fit.
    pub space: Space,
    /// The place among all objects of each of its aberrations.
    pub boxes: Vec<usize>,
    /// The same of its portals.
    pub portals: Vec<usize>,
    /// What is closed: its place among all objects, and why. Where one does not fit another, the later one is closed.
    pub closed: Vec<(usize, SpaceError)>,
}

/// The space of a room of which [`crate::check_each`] finds nothing wrong.
pub fn space_in_parts(room: &Room) -> SpaceSoFar {
    let mut boxes = aberrations(room);
    let mut left = portals(room);
    let mut closed = Vec::new();
    loop {
        let placed = boxes.iter().map(|(_, it)| it.clone()).collect();
        let listed = left.iter().map(|(_, it)| it.clone()).collect();
        let error = match Space::with_portals(placed, listed) {
            Ok(space) => {
                return SpaceSoFar {
                    space,
                    boxes: boxes.iter().map(|(index, _)| *index).collect(),
                    portals: left.iter().map(|(index, _)| *index).collect(),
                    closed,
                };
            }
            Err(error) => error,
        };
        let name = unfit(&error);
        let is_it = |it: &String| name == Some(it);
        let index = room.objects.iter().position(|it| is_it(&it.name));
        let had = boxes.len() + left.len();
        boxes.retain(|(_, it)| !is_it(&it.name));
        let kept: Vec<_> = left.iter().map(|(_, it)| !is_it(&it.name)).collect();
        left = without(left, &kept);
        if boxes.len() + left.len() == had {
            // Nobody is named, so nobody can be closed alone.
            (boxes, left) = (Vec::new(), Vec::new());
        }
        closed.extend(index.map(|it| (it, error)));
    }
}

/// The aberration or portal that is closed for an error.
fn unfit(error: &SpaceError) -> Option<&String> {
    match error {
        SpaceError::Overlap { second, .. }
        | SpaceError::TooDeep { second, .. }
        | SpaceError::PortalsOverlap { second, .. } => Some(second),
        SpaceError::TooTangled { name }
        | SpaceError::Number { name, .. }
        | SpaceError::NoDoor { name }
        | SpaceError::NoPartner { name }
        | SpaceError::OneWay { name, .. }
        | SpaceError::OtherSides { name, .. }
        | SpaceError::NotSimilar { name, .. }
        | SpaceError::OtherSize { name, .. }
        | SpaceError::PortalShape { name, .. }
        | SpaceError::OverSide { name, .. }
        | SpaceError::InOddBox { name, .. } => Some(name),
        _ => None,
    }
}
