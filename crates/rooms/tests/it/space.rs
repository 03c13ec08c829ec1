//! How aberrations of a room may lie to each other, and what is said of those that lie otherwise.

use antipode_deformation::{Sides, Ways};
use antipode_rooms::{read, space};

/// A room of these aberrations, one a line from line 2 on: name and what else the object says.
fn room(boxes: &[(&str, &str)]) -> Result<antipode_rooms::Room, String> {
    let line = |(name, rest): &(&str, &str)| format!("(name: \"{name}\", {rest}),\n");
    let objects: String = boxes.iter().map(line).collect();
    let text = format!("(version: 1, name: \"boxes\", objects: [\n{objects}])");
    read("room.ron", text.as_bytes()).map_err(|error| error.to_string())
}

const SOFT: &str = "what: Aberration(half: (2, 2, 2), stretch: (2, 2, 2), sides: Soft)";

#[test]
fn turned_boxes_that_overlap_in_part_are_both_named_with_line_and_field() {
    let turned = format!("at: (3, 0, 0), turn: (30, 0, 0), {SOFT}");
    let said = room(&[("cellar", SOFT), ("attic", &turned)]).unwrap_err();
    assert!(said.starts_with("room.ron:3: at of \"attic\""), "{said}");
    assert!(said.contains("\"cellar\""), "{said}");
    let quarter = turned.replace("30", "90");
    assert!(room(&[("cellar", SOFT), ("attic", &quarter)]).is_ok());
    let apart = turned.replace("3, 0", "9, 0");
    assert!(room(&[("cellar", SOFT), ("attic", &apart)]).is_ok());
}

#[test]
fn eight_may_lie_in_one_another_and_nine_may_not() {
    let names: Vec<_> = (1..=9).map(|it| format!("b{it}")).collect();
    let what = |half: usize| {
        format!("what: Aberration(half: ({half}, {half}, {half}), stretch: (2, 2, 2), sides: Soft)")
    };
    let kinds: Vec<_> = (1..=9).rev().map(what).collect();
    let all: Vec<_> = names
        .iter()
        .zip(&kinds)
        .map(|(a, b)| (&a[..], &b[..]))
        .collect();
    assert!(room(&all[..8]).is_ok());
    let said = room(&all).unwrap_err();
    assert!(said.starts_with("room.ron:10: at of \"b9\""), "{said}");
    assert!(said.contains("\"b1\"") && said.contains('8'), "{said}");
}

#[test]
fn a_group_carries_its_boxes_into_the_space() {
    let made = room(&[
        ("house", "at: (10, 0, 0), turn: (90, 0, 0), what: Group"),
        (
            "corridor",
            "at: (2, 1, 0), group: \"house\", what: Aberration(half: (1, 1, 4), axis: Z, felt: 80, ways: Forward)",
        ),
        (
            "old",
            "at: (50, 0, 0), what: Aberration(half: (1, 1, 1), stretch: (2, 1, 1), sides: Legacy(exit: Inverse))",
        ),
    ])
    .unwrap();
    let space = space(&made).unwrap();
    let [corridor, old] = space.placed() else {
        panic!("{space:?}")
    };
    let (corridor, old) = (&corridor.aberration, &old.aberration);
    assert_eq!(
        (corridor.sides, corridor.ways),
        (Sides::Walls, Ways::Along(2))
    );
    assert!((corridor.stretch.z - 10.0).abs() < 1e-12);
    // A quarter turn to the right takes what is ahead along x to z.
    assert!(corridor.centre.distance(glam::DVec3::new(10.0, 1.0, 2.0)) < 1e-9);
    assert!((corridor.turn * glam::DVec3::X).distance(glam::DVec3::Z) < 1e-9);
    assert_eq!(
        old.sides,
        Sides::Legacy(antipode_deformation::Exit::Inverse)
    );
}
