//! A room's aberrations as the space that is made of them: `antipode-deformation` says which boxes may lie how, and knows how
//! one goes through them.

use antipode_deformation as deformation;
use deformation::{Space, SpaceError};
use glam::DQuat;

use crate::aberration::{Aberration, Exit, Lengths, Sides, Ways};
use crate::bounds::{MOST_DEEP, STRETCHES};
use crate::check::{fault, shown, wrong};
use crate::error::Fault;
use crate::pose::{parents, poses, rotation};
use crate::room::Room;

/// A room's aberrations where they stand, each with the place of its object among all.
pub fn aberrations(room: &Room) -> Vec<(usize, deformation::Aberration)> {
    let poses = poses(room);
    let parents = parents(room);
    room.aberrations()
        .map(|(index, it)| {
            let placed = deformation::Aberration {
                name: room.objects[index].name.clone(),
                centre: poses[index].translation,
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

/// The space that a room's aberrations make; number n of it is the n-th of [`aberrations`].
///
/// # Errors
/// The first aberration that lies to others as it may not; both are named.
pub fn space(room: &Room) -> Result<Space, Fault> {
    let placed = aberrations(room).into_iter().map(|(_, it)| it).collect();
    Space::new(placed).map_err(|error| misplaced(room, &error))
}

/// What is wrong with a room's aberrations, told of the field that is to be changed.
fn misplaced(room: &Room, error: &SpaceError) -> Fault {
    let (name, reason) = match error {
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
    };
    match name.and_then(|it| room.find(it)) {
        Some((index, _)) => fault(room, index, wrong("at", reason)),
        None => Fault {
            path: "objects".to_owned(),
            field: "objects".to_owned(),
            reason,
        },
    }
}
