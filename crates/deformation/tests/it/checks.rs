//! What is refused.

use antipode_deformation::{
    Aberration, MAX_ABERRATIONS, MAX_DEPTH, Place, Sides, Space, SpaceError, Ways,
    stretch_of_legacy,
};
use glam::{DQuat, DVec3};

use crate::common::{boxed, go, v};

fn cube(name: &str, at: DVec3, half: f64) -> Aberration {
    boxed(name, at, DVec3::splat(half), v(2.0, 1.0, 1.0), Sides::Soft)
}

fn turned(mut aberration: Aberration, angle: f64) -> Aberration {
    aberration.turn = DQuat::from_rotation_y(angle);
    aberration
}

fn refusal(aberrations: Vec<Aberration>) -> String {
    Space::new(aberrations).unwrap_err().to_string()
}

#[test]
fn boxes_that_overlap_in_part_must_have_parallel_axes() {
    let first = cube("cellar", DVec3::ZERO, 2.0);
    let beside = cube("attic", v(3.0, 0.0, 0.0), 2.0);
    let words = refusal(vec![first.clone(), turned(beside.clone(), 0.3)]);
    assert!(
        words.contains("cellar") && words.contains("attic") && words.contains("parallel"),
        "{words}"
    );
    let quarter = turned(beside.clone(), std::f64::consts::FRAC_PI_2);
    assert!(Space::new(vec![first.clone(), beside]).is_ok());
    assert!(Space::new(vec![first.clone(), quarter]).is_ok());
    assert!(
        Space::new(vec![
            first.clone(),
            turned(cube("inner", DVec3::ZERO, 0.5), 0.3)
        ])
        .is_ok()
    );
    assert!(
        Space::new(vec![
            first,
            turned(cube("apart", v(9.0, 0.0, 0.0), 2.0), 0.3)
        ])
        .is_ok()
    );
}

#[test]
fn edges_that_pass_each_other_are_told_from_boxes_that_overlap() {
    // Two long beams that cross at a distance: only the cross product of their edges parts them.
    let beam = |name: &str, at: f64, turn: DQuat| Aberration {
        turn,
        ..boxed(
            name,
            v(0.0, at, 0.0),
            v(9.0, 0.5, 0.5),
            v(2.0, 1.0, 1.0),
            Sides::Soft,
        )
    };
    let tilt = DQuat::from_rotation_x(0.5);
    let other = DQuat::from_rotation_y(1.0) * DQuat::from_rotation_x(0.9);
    assert!(Space::new(vec![beam("low", 0.0, tilt), beam("high", 1.5, other)]).is_ok());
    assert!(Space::new(vec![beam("low", 0.0, tilt), beam("high", 1.1, other)]).is_err());
}

#[test]
fn boxes_nest_to_eight_and_no_deeper() {
    let nested = |count: usize| -> Vec<_> {
        (0..count)
            .map(|n| {
                turned(
                    cube(
                        &format!("shell {n}"),
                        DVec3::ZERO,
                        100.0 * 0.5_f64.powi(n as i32),
                    ),
                    n as f64,
                )
            })
            .collect()
    };
    assert!(Space::new(nested(MAX_DEPTH)).is_ok());
    let words = refusal(nested(MAX_DEPTH + 1));
    assert!(
        words.contains("shell 0") && words.contains("shell 8"),
        "{words}"
    );
    // Boxes that only overlap count as well.
    let row: Vec<_> = (0..9)
        .map(|n| cube(&format!("row {n}"), v(f64::from(n) * 0.2, 0.0, 0.0), 2.0))
        .collect();
    assert!(matches!(Space::new(row), Err(SpaceError::TooDeep { .. })));
}

#[test]
fn as_many_boxes_as_there_may_be_make_a_space_however_they_cross() {
    // Plates across each axis: all of one axis cross all of the others, and no place is in more than three.
    let plate = |number: usize| {
        let axis = number % 3;
        let (mut centre, mut half) = (DVec3::ZERO, DVec3::splat(90.0));
        centre[axis] = (number / 3) as f64 * 2.0 - 85.0;
        half[axis] = 0.9;
        boxed(
            &format!("plate {number}"),
            centre,
            half,
            DVec3::splat(1.1),
            Sides::Soft,
        )
    };
    let space = Space::new((0..MAX_ABERRATIONS).map(plate).collect()).unwrap();
    let deep = Place::at(&space, v(-85.0, -85.0, -85.0));
    assert_eq!(deep.stack.len(), 3);
    // What goes straight through enters and leaves as many as it has events for.
    let path = go(
        &space,
        &Place::at(&space, v(-100.0, 0.3, 0.3)),
        DVec3::X,
        60.0,
    );
    assert!(path.events.len() > 20, "{path:?}");
    // Nine that have a place in common are found among them.
    let mut all: Vec<_> = (0..MAX_ABERRATIONS - 9).map(plate).collect();
    all.extend((0..9).map(|n| {
        cube(
            &format!("row {n}"),
            v(200.0 + f64::from(n) * 0.2, 0.0, 0.0),
            2.0,
        )
    }));
    let words = refusal(all);
    assert!(
        words.contains("row 0") && words.contains("row 8"),
        "{words}"
    );
}

#[test]
fn numbers_out_of_range_are_refused_by_name() {
    let with = |change: &dyn Fn(&mut Aberration)| {
        let mut one = cube("odd", DVec3::ZERO, 1.0);
        change(&mut one);
        refusal(vec![one])
    };
    assert!(with(&|one| one.stretch.y = 33.0).contains("a stretch"));
    assert!(with(&|one| one.stretch.y = f64::NAN).contains("\"odd\""));
    assert!(with(&|one| one.half.x = 0.0).contains("an edge"));
    assert!(with(&|one| one.centre.x = f64::INFINITY).contains("a place"));
    assert!(with(&|one| one.turn = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)).contains("a turn"));
    assert!(with(&|one| one.ways = Ways::Along(3)).contains("a way"));
    assert!(
        with(&|one| {
            one.sides = Sides::Walls;
            one.stretch = v(2.0, 2.0, 1.0);
        })
        .contains("walls on all six sides")
    );
    let many = vec![cube("one", DVec3::ZERO, 1.0); 257];
    assert!(refusal(many).contains("257"));
}

#[test]
fn the_numbers_of_the_thesis_are_stretches() {
    assert_eq!(stretch_of_legacy(2.0), Some(1.0 / 3.0));
    assert!((stretch_of_legacy(-0.8).unwrap() - 5.0).abs() < 1e-12);
    assert_eq!(stretch_of_legacy(-1.0), None);
    assert_eq!(stretch_of_legacy(f64::NAN), None);
}
