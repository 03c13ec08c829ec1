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

/// What the space of a room is made of: its aberrations and portals where they stand, each with the place of its object among all.
#[derive(Debug, Clone, Default)]
pub struct SpaceParts {
    boxes: Vec<(usize, deformation::Aberration)>,
    portals: Vec<(usize, deformation::Portal)>,
}

/// The space of a room of which [`crate::check_each`] finds nothing wrong.
pub fn space_in_parts(room: &Room) -> SpaceSoFar {
    SpaceParts::of(room).space()
}

impl SpaceParts {
    /// Those of a room.
    pub fn of(room: &Room) -> Self {
        Self {
            boxes: aberrations(room),
            portals: portals(room),
        }
    }

    /// The aberrations.
    pub fn boxes(&self) -> impl Iterator<Item = &deformation::Aberration> {
        self.boxes.iter().map(|(_, it)| it)
    }

    /// Whether the space of both is the same, wherever their objects are among the others.
    pub fn make_the_space_of(&self, other: &Self) -> bool {
        self.boxes
            .iter()
            .map(|it| &it.1)
            .eq(other.boxes.iter().map(|it| &it.1))
            && (self.portals.iter().map(|it| &it.1)).eq(other.portals.iter().map(|it| &it.1))
    }

    /// The place among all objects of the one that had the place `was` for what makes the same space.
    pub fn now_of(&self, before: &Self, was: usize) -> Option<usize> {
        let pairs = (before.boxes.iter().map(|it| it.0)).zip(self.boxes.iter().map(|it| it.0));
        let doors = before.portals.iter().map(|it| it.0);
        let mut pairs = pairs.chain(doors.zip(self.portals.iter().map(|it| it.0)));
        pairs.find(|(old, _)| *old == was).map(|(_, new)| new)
    }

    /// Their space, without what does not fit.
    pub fn space(&self) -> SpaceSoFar {
        let (mut boxes, mut left) = (self.boxes.clone(), self.portals.clone());
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
            let index = self.find(&is_it);
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

    fn find(&self, is_it: &dyn Fn(&String) -> bool) -> Option<usize> {
        let boxes = self.boxes.iter().map(|(index, it)| (*index, &it.name));
        let portals = self.portals.iter().map(|(index, it)| (*index, &it.name));
        let mut all = boxes.chain(portals);
        all.find(|(_, name)| is_it(name)).map(|(index, _)| index)
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
