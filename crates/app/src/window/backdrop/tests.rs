//! The world behind the menu: that it comes, changes its space, and goes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use antipode_geometry::Geometry;

use super::*;

const STEP: Duration = Duration::from_millis(50);

fn enabled() -> Backdrop {
    let mut backdrop = Backdrop::default();
    backdrop.enable(true);
    backdrop
}

/// Lets time pass, with a picture each time, until it is so; how long background work takes decides nothing.
fn pass_until(backdrop: &mut Backdrop, there: impl Fn(&Backdrop) -> bool) {
    for _ in 0..1_000_000 {
        if there(backdrop) {
            return;
        }
        backdrop.tick(STEP, true);
        let _ = backdrop.frame(16.0 / 9.0, 360);
        std::thread::yield_now();
    }
    panic!("it never got there: {backdrop:?}");
}

fn number(backdrop: &mut Backdrop) -> Option<u64> {
    backdrop
        .frame(16.0 / 9.0, 360)
        .map(|frame| frame.content.loaded_world)
}

#[test]
fn a_world_comes_after_a_while_and_another_one_follows_in_the_dark() {
    let mut backdrop = enabled();
    assert_eq!(number(&mut backdrop), None);
    pass_until(&mut backdrop, |backdrop| backdrop.shown.is_some());
    assert_eq!(number(&mut backdrop), Some(FIRST_NUMBER));
    assert!(backdrop.model().live && backdrop.model().shade > 0.9);
    pass_until(&mut backdrop, |backdrop| backdrop.shade == 0.0);
    let second = |backdrop: &Backdrop| {
        backdrop.begun == 2
            && backdrop
                .shown
                .as_ref()
                .is_some_and(|shown| shown.shown_s() < 1.0)
    };
    pass_until(&mut backdrop, second);
    assert!(backdrop.model().shade > 0.9, "it changes in the dark");
    assert_eq!(number(&mut backdrop), Some(FIRST_NUMBER - 1));
}

#[test]
fn nothing_darkens_for_a_world_that_cannot_be_drawn_yet() {
    let mut backdrop = enabled();
    backdrop.held = true;
    pass_until(&mut backdrop, |backdrop| match &backdrop.next {
        Next::Coming(flight, _) => flight.is_complete(),
        Next::None | Next::Opening(_) => backdrop.shown.is_some(),
        Next::Ready(_) | Next::Failed => true,
    });
    let longer_than_land_is_waited_for = (2.0 * WAIT_S / STEP.as_secs_f64()) as u32;
    for _ in 0..longer_than_land_is_waited_for {
        backdrop.tick(STEP, true);
        assert_eq!(backdrop.model(), antipode_ui::Backdrop::default());
    }
    backdrop.held = false;
    pass_until(&mut backdrop, |backdrop| backdrop.shown.is_some());
}

#[test]
fn the_worlds_are_dropped_as_soon_as_none_is_wanted() {
    let mut backdrop = enabled();
    pass_until(&mut backdrop, |backdrop| backdrop.shown.is_some());
    backdrop.tick(STEP, false);
    assert_eq!(number(&mut backdrop), None);
    assert_eq!(backdrop.model(), antipode_ui::Backdrop::default());
    assert!(matches!(backdrop.next, Next::None));
}

#[test]
fn nothing_is_begun_where_it_is_not_enabled() {
    let mut backdrop = Backdrop::default();
    backdrop.tick(STEP, true);
    assert!(matches!(backdrop.next, Next::None) && backdrop.begun == 0);
}

#[test]
fn every_world_lies_in_another_space_than_the_one_before() {
    let spaces = WORLDS.map(Flight::geometry_of);
    for (number, space) in spaces.iter().enumerate() {
        assert_ne!(*space, spaces[(number + 1) % spaces.len()]);
    }
    for space in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        assert!(spaces.contains(&space));
    }
}

#[test]
fn the_flight_moves_and_never_goes_into_the_ground() {
    for world in WORLDS {
        let mut flight = Flight::open(world, 1, true, Quality::Fast).unwrap();
        let begin = flight.point();
        for _ in 0..(SHOWN_S / 0.05) as u32 {
            flight.fly(0.05);
            let above_m = flight.above_ground_m();
            assert!(above_m > 1.0, "{world:?}: {above_m} m over the ground");
        }
        assert_ne!(begin, flight.point());
    }
}

#[test]
fn the_menu_begins_over_a_closed_world_by_night_that_is_large_beside_its_hills() {
    assert_eq!(Flight::geometry_of(WORLDS[0]), Geometry::Spherical);
    for world in WORLDS {
        if Flight::geometry_of(world) != Geometry::Spherical {
            continue;
        }
        let mut flight = Flight::open(world, 1, true, Quality::Fast).unwrap();
        let frame = flight.frame(1.5, 400);
        let radius_m = frame.view.strategy.radius_m();
        assert!(radius_m >= 100.0, "{world:?}: {radius_m} m");
        assert!(frame.content.sky.stars > 0.5, "{world:?} in the sun");
    }
}
