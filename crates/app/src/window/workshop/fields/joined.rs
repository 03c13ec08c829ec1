//! Fields of several things at once: of each what they have in common.

use antipode_rooms::{Object, What};
use antipode_ui::workshop::{FieldKind, FieldRow};
use glam::DVec3;

/// Whether two things differ in nothing but where they are, and what they are called.
pub(super) fn are_alike(one: &Object, other: &Object) -> bool {
    // Each group is offered all groups but itself.
    one.what != What::Group
        && one.what == other.what
        && one.surface == other.surface
        && one.group == other.group
        && one.mass == other.mass
}

/// Joins where a thing is to rows that have all else of it already.
pub(super) fn join_place(rows: &mut [FieldRow], object: &Object) {
    for row in rows {
        let place = match row.key.as_str() {
            "at" => object.at,
            "turn" => object.turn,
            _ => continue,
        };
        row.is_default &= place == DVec3::ZERO;
        if let FieldKind::Numbers(mine, _) = &mut row.kind {
            for (mine, theirs) in mine.iter_mut().zip(place.to_array()) {
                mine.value = mine.value.filter(|it| *it == theirs);
            }
        }
    }
}

/// Leaves of a field what another has, too. Returns whether both can be changed together.
pub(super) fn join(row: &mut FieldRow, other: &FieldRow) -> bool {
    row.is_default &= other.is_default;
    match (&mut row.kind, &other.kind) {
        (FieldKind::Numbers(mine, unit), FieldKind::Numbers(theirs, same))
            if mine.len() == theirs.len() && unit == same =>
        {
            for (mine, theirs) in mine.iter_mut().zip(theirs) {
                mine.value = mine.value.filter(|it| Some(*it) == theirs.value);
            }
            true
        }
        (FieldKind::Stretch(mine), FieldKind::Stretch(theirs)) => keep_equal(mine, theirs.as_ref()),
        (FieldKind::Colour(mine), FieldKind::Colour(theirs)) => keep_equal(mine, theirs.as_ref()),
        (FieldKind::Text(mine), FieldKind::Text(theirs)) => keep_equal(mine, theirs.as_ref()),
        (FieldKind::Switch(mine), FieldKind::Switch(theirs)) => keep_equal(mine, theirs.as_ref()),
        (FieldKind::Choice(options, mine), FieldKind::Choice(others, theirs)) => {
            // The labels of the other are not said.
            let words = options.iter().map(|(word, _)| word);
            words.eq(others.iter().map(|(word, _)| word)) && keep_equal(mine, theirs.as_ref())
        }
        _ => false,
    }
}

fn keep_equal<T: PartialEq>(mine: &mut Option<T>, theirs: Option<&T>) -> bool {
    if mine.as_ref() != theirs {
        *mine = None;
    }
    true
}
