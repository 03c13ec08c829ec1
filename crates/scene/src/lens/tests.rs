//! The dial glides, and one map gives way to the other where both are flat.

use HyperbolicMap::{Horizon as Level, Raised as High};
use antipode_geometry::{ChartPoint, Eye, Geometry, strategy};
use glam::DVec3;

use super::*;
use crate::tuning::STEP_S;

/// The most that one step of gliding towards `goal` may move the dial.
fn most(value: f64, goal: f64) -> f64 {
    let share = 1.0 - DIAL_REMAINDER_PER_S.powf(STEP_S);
    (value - goal).abs() * share + DIAL_SWAP_AT
}

fn hyperbolic() -> Lens {
    Lens::new(strategy(Geometry::Hyperbolic, 20.0))
}

fn flat() -> Lens {
    Lens::new(strategy(Geometry::Euclidean, f64::INFINITY))
}

/// Glides to rest and returns every value on the way with whether the picture was the level one there.
fn way(lens: &mut Lens) -> Vec<(f64, ViewMode)> {
    let mut values = vec![(lens.value(), lens.shown)];
    for _ in 0..240 {
        lens.glide(STEP_S);
        values.push((lens.value(), lens.shown));
    }
    values
}

#[test]
fn a_notch_glides_without_a_step_and_comes_to_rest() {
    let mut lens = hyperbolic();
    lens.turn(1.0);
    let mut last = lens.value();
    for _ in 0..120 {
        lens.glide(STEP_S);
        assert!(lens.value() >= last && lens.value() - last < 0.2);
        last = lens.value();
    }
    assert_eq!(lens.value(), 11.0);
}

#[test]
fn dials_stop_at_both_ends() {
    let mut lens = hyperbolic();
    lens.turn(50.0);
    assert_eq!(lens.goal(), 20.0);
    lens.turn(-90.0);
    assert_eq!(lens.goal(), 0.0);
    assert!(!lens.set_curvature(20.5) && !lens.set_curvature(f64::NAN));
    let mut lens = flat();
    assert!(lens.set_bend(3.0) && !lens.set_bend(-20.5) && !lens.set_bend(f64::NAN));
    lens.turn(-90.0);
    assert_eq!(lens.goal(), -20.0);
}

#[test]
fn maps_are_swapped_at_zero_and_each_keeps_its_own_dial() {
    let mut lens = hyperbolic();
    assert!(lens.set_curvature(17.0) && lens.set_map(Level) && lens.set_curvature(4.0));
    assert!(lens.turn_map());
    assert_eq!((lens.map(), lens.curvature()), (Some(High), Some(17.0)));
    let values = way(&mut lens);
    for pair in values.windows(2) {
        let [(from, before), (to, after)] = [pair[0], pair[1]];
        let goal = if before == ViewMode::Map(High) {
            17.0
        } else {
            0.0
        };
        assert!((to - from).abs() <= most(from, goal), "from {from} to {to}");
        assert!(before == after || to == 0.0, "swapped at {to}");
    }
    assert_eq!(values.last(), Some(&(17.0, ViewMode::Map(High))));
    assert_eq!(lens.strategy().radius_m(), 20.0);
    assert!(lens.turn_map());
    assert_eq!(way(&mut lens).last(), Some(&(4.0, ViewMode::Map(Level))));
}

#[test]
fn land_is_lit_alike_before_and_after_the_maps_are_swapped() {
    let mut lens = hyperbolic();
    let normal = |lens: &Lens| {
        let point = ChartPoint::a(DVec3::new(60.0, -9.0, 25.0));
        let eye = Eye {
            dial: lens.value(),
            lift_m: 1.62,
            ..Eye::default()
        };
        let slope = DVec3::new(0.5, 0.8, -0.33).normalize();
        lens.strategy().port_normal(&eye, point, slope)
    };
    assert!(lens.set_curvature(0.0) && lens.turn_map());
    let raised = normal(&lens);
    let mut last = raised;
    for _ in 0..240 {
        lens.glide(STEP_S);
        let turned = (normal(&lens) - last).length();
        last = normal(&lens);
        if lens.shown == ViewMode::Map(Level) {
            assert!(turned < 0.005, "the light jumps by {turned}");
            break;
        }
    }
    assert!(
        (last - raised).length() > 0.2,
        "there was something to fade"
    );
    assert_eq!((lens.shown, lens.value()), (ViewMode::Map(Level), 0.0));
}

#[test]
fn scrolling_while_maps_change_sets_where_the_dial_comes_back_to() {
    let mut lens = hyperbolic();
    assert!(lens.turn_map());
    lens.glide(STEP_S);
    lens.turn(3.0);
    assert_eq!(lens.curvature(), Some(13.0));
    assert_eq!(way(&mut lens).last(), Some(&(13.0, ViewMode::Map(Level))));
    assert_eq!(lens.goals().raised, 10.0);
}

#[test]
fn a_second_turn_on_the_way_goes_back_to_the_first_map() {
    let mut lens = hyperbolic();
    assert!(lens.turn_map());
    for _ in 0..5 {
        lens.glide(STEP_S);
    }
    assert!(lens.turn_map() && lens.value() > 0.0);
    let values = way(&mut lens);
    assert!(
        values
            .iter()
            .all(|(value, view)| *view == ViewMode::Map(High) && *value > 0.0)
    );
    assert_eq!(values.last().map(|(value, _)| *value), Some(10.0));
}

#[test]
fn a_flat_world_bends_and_unbends_without_a_step() {
    let mut lens = flat();
    assert_eq!((lens.range(), lens.bend()), (None, None));
    lens.turn(3.0);
    assert!(lens.turn_map());
    lens.turn(-12.0);
    assert_eq!(
        (lens.range(), lens.bend()),
        (Some((-20.0, 20.0)), Some(-12.0))
    );
    assert_eq!(way(&mut lens).last(), Some(&(-12.0, ViewMode::Bent)));
    assert!(lens.turn_map());
    assert_eq!((lens.range(), lens.bend()), (None, None));
    let values = way(&mut lens);
    for pair in values.windows(2) {
        assert!((pair[1].0 - pair[0].0).abs() <= most(pair[0].0, 0.0));
    }
    assert_eq!(values.last(), Some(&(0.0, ViewMode::Plain)));
}

#[test]
fn a_space_without_another_picture_ignores_it_all() {
    let mut lens = Lens::new(strategy(Geometry::Spherical, 32.0));
    lens.turn(3.0);
    assert!(!lens.turn_map() && !lens.set_map(Level) && !lens.set_bend(1.0));
    assert!(!lens.set_curvature(1.0) && !flat().set_curvature(1.0) && !flat().set_map(High));
    assert!(!hyperbolic().set_bend(1.0));
    assert_eq!((lens.value(), lens.goal(), lens.range()), (0.0, 0.0, None));
}

#[test]
fn what_no_play_could_have_saved_is_left_as_in_a_new_world() {
    let mut lens = hyperbolic();
    let goals = DialGoals {
        raised: f64::NAN,
        horizon: 21.0,
        bend: f64::INFINITY,
    };
    lens.restore(Level, true, goals);
    assert_eq!(lens.goals(), DialGoals::default());
    assert_eq!(
        (lens.map(), lens.bend(), lens.value()),
        (Some(Level), None, 10.0)
    );
}
