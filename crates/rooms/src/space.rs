//! A room's aberrations and portals as the space that is made of them: `antipode-deformation` says which may lie how, and knows how
//! one goes through them.

use antipode_deformation as deformation;
use deformation::{Space, SpaceError};
use glam::DQuat;

use crate::aberration::{Aberration, Exit, Lengths, Sides, Ways};
use crate::bounds::{MOST_DEEP, STRETCHES};
use crate::check::{fault, shown, wrong};
use crate::error::Fault;
use crate::portal::Opening;
use crate::pose::{parents, pose, rotation};
use crate::room::{Room, What};

/// A room's aberrations where they stand, each with the place of its object among all.
pub fn aberrations(room: &Room) -> Vec<(usize, deformation::Aberration)> {
    let parents = parents(room);
    room.aberrations()
        .map(|(index, it)| {
            let placed = deformation::Aberration {
                name: room.objects[index].name.clone(),
                centre: pose(room, &parents, index).translation,
                turn: turn(room, &parents, index),
                half: it.half,
                // The quotient of a felt length at a bound may lie beyond it in its last digit.
                stretch: it
                    .stretch()
                    .map(|one| one.clamp(*STRETCHES.start(), *STRETCHES.end())),
                sides: sides(it),
                ways: ways(it),
            };
            (index, placed)
        })
        .collect()
}

/// The turn of an object, by way of its groups. Turns are composed as rotations, so that parallel axes stay parallel to the
/// last digits.
fn turn(room: &Room, parents: &[Option<usize>], index: usize) -> DQuat {
    let mut turn = rotation(room.objects[index].turn);
    let mut at = parents[index];
    for _ in 0..MOST_DEEP {
        let Some(parent) = at else { break };
        turn = rotation(room.objects[parent].turn) * turn;
        at = parents[parent];
    }
    turn.normalize()
}

fn sides(it: &Aberration) -> deformation::Sides {
    match it.sides {
        Sides::Walls => deformation::Sides::Walls,
        Sides::Soft => deformation::Sides::Soft,
        Sides::Snell => deformation::Sides::Snell,
        Sides::Legacy { exit } => deformation::Sides::Legacy(match exit {
            Exit::Original => deformation::Exit::Original,
            Exit::Inverse => deformation::Exit::Inverse,
            Exit::Nothing => deformation::Exit::None,
        }),
    }
}

fn ways(it: &Aberration) -> deformation::Ways {
    match (it.ways, it.lengths) {
        (Ways::Forward, Lengths::Felt { axis, .. }) => deformation::Ways::Along(axis.index() as u8),
        _ => deformation::Ways::Both,
    }
}

/// A room's portals where they stand, each with the place of its object among all. What leads to no portal leads to a number
/// that there is not.
pub fn portals(room: &Room) -> Vec<(usize, deformation::Portal)> {
    let parents = parents(room);
    let all: Vec<_> = room.portals().collect();
    let number_of = |name: &str| {
        let found = all
            .iter()
            .position(|(index, _)| room.objects[*index].name == name);
        found.unwrap_or(usize::MAX)
    };
    all.iter()
        .map(|(index, it)| {
            let placed = deformation::Portal {
                name: room.objects[*index].name.clone(),
                at: pose(room, &parents, *index).translation,
                turn: turn(room, &parents, *index),
                polygon: it.opening.polygon(),
                to: number_of(&it.to),
                two_sided: it.sides == 2,
            };
            (*index, placed)
        })
        .collect()
}

/// The space that a room's aberrations and portals make; number n of it is the n-th of [`aberrations`], and of [`portals`].
///
/// # Errors
/// The first aberration or portal that lies or leads as it may not; all that have a part in it are named.
pub fn space(room: &Room) -> Result<Space, Fault> {
    let boxes = aberrations(room).into_iter().map(|(_, it)| it).collect();
    let portals = portals(room).into_iter().map(|(_, it)| it).collect();
    Space::with_portals(boxes, portals).map_err(|error| misplaced(room, &error))
}

/// The space of a room that is being changed, without portals that do not fit their partners yet, and the objects of the portals
/// that it has.
///
/// # Errors
/// As of [`space`], but for what is amiss between a portal and its partner.
pub fn space_so_far(room: &Room) -> Result<(Space, Vec<usize>), Fault> {
    let boxes: Vec<_> = aberrations(room).into_iter().map(|(_, it)| it).collect();
    let mut left = portals(room);
    loop {
        let listed = left.iter().map(|(_, it)| it.clone()).collect();
        let error = match Space::with_portals(boxes.clone(), listed) {
            Ok(space) => return Ok((space, left.iter().map(|(index, _)| *index).collect())),
            Err(error) => error,
        };
        let unfit = unfit(&error);
        let is_fit = |it: &deformation::Portal| unfit.is_none_or(|name| it.name != *name);
        let kept: Vec<_> = left.iter().map(|(_, it)| is_fit(it)).collect();
        if kept.iter().all(|it| *it) {
            return Err(misplaced(room, &error));
        }
        left = without(left, &kept);
    }
}

/// The portal that does not fit its partner, if that is what is wrong.
fn unfit(error: &SpaceError) -> Option<&String> {
    match error {
        SpaceError::NoPartner { name }
        | SpaceError::OneWay { name, .. }
        | SpaceError::OtherSides { name, .. }
        | SpaceError::NotSimilar { name, .. }
        | SpaceError::OtherSize { name, .. } => Some(name),
        _ => None,
    }
}

/// The portals that are kept, numbered anew.
pub(crate) fn without(
    all: Vec<(usize, deformation::Portal)>,
    kept: &[bool],
) -> Vec<(usize, deformation::Portal)> {
    let number = |to: usize| match kept.get(to) {
        Some(true) => kept[..to].iter().filter(|it| **it).count(),
        _ => usize::MAX,
    };
    let pairs = all.into_iter().zip(kept).filter(|(_, kept)| **kept);
    pairs
        .map(|((index, it), _)| {
            let to = number(it.to);
            (index, deformation::Portal { to, ..it })
        })
        .collect()
}

/// What is wrong with a room's aberrations and portals, told of the field that is to be changed.
fn misplaced(room: &Room, error: &SpaceError) -> Fault {
    let (name, field, reason) = of_portal(error).unwrap_or_else(|| {
        let (name, reason) = of_box(error);
        (name, "at", reason)
    });
    match name.and_then(|it| room.find(it)) {
        Some((index, object)) => {
            let is_polygon = matches!(
                &object.what,
                What::Portal(it) if matches!(it.opening, Opening::Polygon(_))
            );
            let field = match field {
                "what.size" if is_polygon => "what.polygon",
                field => field,
            };
            fault(room, index, wrong(field, reason))
        }
        None => Fault {
            path: "objects".to_owned(),
            field: "objects".to_owned(),
            reason,
        },
    }
}

/// Of a portal: which, its field, and what is wrong.
type OfPortal<'e> = (Option<&'e String>, &'static str, String);

fn of_portal(error: &SpaceError) -> Option<OfPortal<'_>> {
    of_pair(error).or_else(|| of_place(error))
}

/// Of a portal and its partner.
fn of_pair(error: &SpaceError) -> Option<OfPortal<'_>> {
    let (name, field, reason) = match error {
        SpaceError::NoPartner { name } => (
            name,
            "what.to",
            "is to be the name of a portal, its partner, and there is none of that name".to_owned(),
        ),
        SpaceError::OneWay { name, partner } => (
            name,
            "what.to",
            format!(
                "is {}, which does not lead back; each of a pair leads to the other",
                shown(partner)
            ),
        ),
        SpaceError::OtherSides { name, partner } => (
            name,
            "what.sides",
            format!("is not that of its partner {}", shown(partner)),
        ),
        SpaceError::NotSimilar { name, partner } => (
            name,
            "what.size",
            format!(
                "does not feel similar to its partner {}: seen from the front, one is to be the mirror image of the other, as large or in proportion",
                shown(partner)
            ),
        ),
        SpaceError::OtherSize { name, partner } => (
            name,
            "what.size",
            format!(
                "differs from that of its partner {} by more than 32 times",
                shown(partner)
            ),
        ),
        _ => return None,
    };
    Some((Some(name), field, reason))
}

/// Of a portal by itself.
fn of_place(error: &SpaceError) -> Option<OfPortal<'_>> {
    let (name, field, reason) = match error {
        SpaceError::PortalShape { name, what } => (
            name,
            "what.size",
            format!(
                "{what}; its corners are to be those of a convex polygon, each once and in their order"
            ),
        ),
        SpaceError::OverSide { name, aberration } => (
            name,
            "at",
            format!(
                "puts it over a side of the aberration {}; put it wholly in or out, a millimetre off at least",
                shown(aberration)
            ),
        ),
        SpaceError::InOddBox { name, aberration } => (
            name,
            "at",
            format!(
                "puts it into the aberration {}, which is felt one way only or by the thesis's rule; portals cannot stand there",
                shown(aberration)
            ),
        ),
        SpaceError::PortalsOverlap { first, second } => (
            second,
            "at",
            format!(
                "lets it touch or overlap the portal {}; move them apart by a millimetre at least",
                shown(first)
            ),
        ),
        _ => return None,
    };
    Some((Some(name), field, reason))
}

/// Of an aberration: which, and what is wrong.
fn of_box(error: &SpaceError) -> (Option<&String>, String) {
    match error {
        SpaceError::Overlap { first, second } => (
            Some(second),
            format!(
                "puts it partly into the aberration {}, which is turned another way; let their axes be parallel, or put one wholly into the other",
                shown(first)
            ),
        ),
        SpaceError::TooDeep { first, second, .. } => (
            Some(second),
            format!(
                "puts it into {MOST_DEEP} aberrations that lie in one another, {} among them; {MOST_DEEP} in all is the most",
                shown(first)
            ),
        ),
        SpaceError::TooTangled { name } => (
            Some(name),
            "puts it into so many others that it cannot be told how deep they lie in one another; move some apart".to_owned(),
        ),
        SpaceError::Number { name, what } => (
            Some(name),
            format!("gives it {what} that is out of range"),
        ),
        SpaceError::NoDoor { name } => (
            Some(name),
            "has walls on all six sides, and nobody could enter".to_owned(),
        ),
        SpaceError::TooMany { found, most } => (
            None,
            format!("have {found} aberrations among them, and a room has at most {most}"),
        ),
        // Those are told of portals.
        _ => (None, error.to_string()),
    }
}
