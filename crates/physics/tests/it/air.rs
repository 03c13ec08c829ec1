//! Jumping, falling, ceilings, flight and being lifted out of the ground.

use crate::common::{STEP_S, Soup, Walker, go, jump, plain, still};
use antipode_physics::{Character, CharacterInput, CharacterTuning};
use glam::DVec3;

#[test]
fn a_jump_rises_its_height_whether_tapped_or_held() {
    let world = plain().world();
    for held in [1, 60] {
        let mut walker = Walker::at(&world, 0.2, 0.1, 0.1).rested();
        let ground = walker.feet().y;
        let mut apex = 0.0_f64;
        for step in 0..70 {
            walker.step(if step < held { jump() } else { still() });
            apex = apex.max(walker.feet().y - ground);
        }
        assert!((apex - 1.2).abs() < 0.01, "{apex}");
        let back = (walker.feet().y - ground).abs() < 1e-9;
        assert!(
            walker.character.grounded && back,
            "a held key jumps once: {:?}",
            walker.character
        );
    }
}

#[test]
fn a_jump_is_as_high_at_other_rates() {
    let world = plain().world();
    for rate in [30.0, 144.0] {
        let mut character = Walker::at(&world, 0.0, 0.1, 0.0).rested().character;
        let mut apex = 0.0_f64;
        for _ in 0..rate as usize {
            world.in_chart().move_character(
                &mut character,
                &CharacterTuning::default(),
                &jump(),
                1.0 / rate,
            );
            apex = apex.max(character.feet.y);
        }
        assert!((apex - 1.2).abs() < 0.036, "{apex} at {rate} Hz");
    }
}

/// Walks off the edge of a table and presses jump some steps after the ground has ended.
fn late_jump(late: usize) -> Character {
    let mut soup = Soup::default();
    soup.cuboid([-10.0, 0.0, -5.0], [0.0, 5.0, 5.0]);
    let world = soup.world();
    let mut walker = Walker::at(&world, -2.0, 5.1, 0.0).rested();
    while walker.character.grounded {
        walker.step(go(1.0, 0.0));
    }
    walker.steps(late - 1, go(1.0, 0.0));
    walker.step(CharacterInput {
        jump: true,
        ..go(1.0, 0.0)
    });
    walker.character
}

#[test]
fn a_jump_is_granted_for_a_tenth_of_a_second_past_the_edge() {
    assert!(late_jump(1).velocity.y > 4.0);
    assert!(late_jump(5).velocity.y > 4.0);
    assert!(late_jump(8).velocity.y < 0.0);
}

/// Falls to the ground and taps jump some steps before landing; says whether it jumped then.
fn early_jump(early: usize) -> bool {
    let world = plain().world();
    let mut probe = Walker::at(&world, 0.0, 2.0, 0.0);
    let mut fall = 0;
    while !probe.character.grounded {
        probe.step(still());
        fall += 1;
    }
    let mut walker = Walker::at(&world, 0.0, 2.0, 0.0);
    walker.steps(fall - early, still());
    walker.step(jump());
    walker.steps(early + 3, still());
    walker.character.velocity.y > 3.0
}

#[test]
fn a_press_shortly_before_landing_jumps_on_landing() {
    assert!(early_jump(2));
    assert!(early_jump(5));
    assert!(!early_jump(9));
}

#[test]
fn nobody_jumps_twice_in_the_air() {
    let world = plain().world();
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.0).rested();
    let mut apex = 0.0_f64;
    for step in 0..40 {
        walker.step(if step % 2 == 0 { jump() } else { still() });
        apex = apex.max(walker.feet().y);
    }
    assert!(apex < 1.21, "{apex}");
}

#[test]
fn a_ceiling_stops_the_rise_at_once() {
    let mut soup = plain();
    soup.cuboid([-3.0, 2.3, -3.0], [3.0, 3.0, 3.0]);
    let world = soup.world();
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.0).rested();
    let mut apex = 0.0_f64;
    let mut airborne = 0;
    walker.step(CharacterInput {
        jump: true,
        ..go(0.3, 0.0)
    });
    while !walker.character.grounded {
        apex = apex.max(walker.feet().y);
        walker.step(still());
        airborne += 1;
        assert!(airborne < 60);
    }
    assert!((apex - 0.5).abs() < 0.02, "{apex}");
    // Up at 4.85 m/s for 0.12 s, then down from rest: sqrt(2 * 0.5 / 9.81) = 0.32 s.
    assert!(
        (22..=30).contains(&airborne),
        "no hanging at the ceiling: {airborne}"
    );
}

#[test]
fn the_fastest_fall_does_not_pass_thin_ground() {
    let mut soup = Soup::default();
    soup.field(-8, 8, |x, z| {
        0.05 * (x * 3.0).sin() + 0.05 * (z * 2.0).cos()
    });
    let world = soup.world();
    for start in [0.0, 0.13, 0.37, 0.61, 0.97] {
        let mut walker = Walker::at(&world, 0.3, 40.0 + start, 0.2);
        walker.character.velocity = DVec3::new(1.0, -60.0, 0.5);
        let mut impact = 0.0_f64;
        for _ in 0..90 {
            walker.step(still());
            impact = impact.max(walker.character.impact_m_s);
        }
        assert!(
            walker.character.grounded && walker.feet().y > -0.2,
            "{:?}",
            walker.character
        );
        assert!((impact - 60.0).abs() < 1e-9, "{impact}");
    }
}

#[test]
fn someone_hurled_at_a_thin_wall_stays_on_this_side() {
    let mut soup = plain();
    soup.cuboid([3.0, -1.0, -5.0], [3.2, 9.0, 5.0]);
    let world = soup.world();
    for start in [0.0, 0.2, 0.45, 0.7, 0.9] {
        let mut walker = Walker::at(&world, start, 2.0, 0.2);
        walker.character.velocity = DVec3::new(60.0, 3.0, 4.0);
        walker.steps(30, still());
        assert!(walker.feet().x < 2.66, "{:?}", walker.character);
    }
}

#[test]
fn falls_end_at_the_terminal_speed() {
    let world = antipode_physics::ChartGround::new();
    let mut walker = Walker::at(&world, 0.0, 0.0, 0.0);
    walker.steps(600, still());
    assert!((walker.character.velocity.y + 60.0).abs() < 1e-9);
}

#[test]
fn the_air_steers_less_than_the_ground() {
    let world = plain().world();
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.0).rested();
    walker.step(jump());
    walker.steps(5, go(1.0, 0.0));
    let expected = 12.0 * 5.0 * STEP_S;
    assert!(
        (walker.character.velocity.x - expected).abs() < 1e-9,
        "{}",
        walker.character.velocity
    );
}

#[test]
fn spectators_fly_through_anything() {
    let mut soup = plain();
    soup.cuboid([3.0, -1.0, -5.0], [4.0, 5.0, 5.0]);
    let world = soup.world();
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.0).rested();
    let input = CharacterInput {
        fly: true,
        sprint: true,
        sink: true,
        ..go(1.0, 0.0)
    };
    walker.steps(60, input);
    assert!((walker.character.velocity.x - 24.0).abs() < 1e-9);
    assert!((walker.character.velocity.y + 24.0).abs() < 1e-9);
    assert!(
        walker.feet().x > 15.0 && walker.feet().y < -15.0,
        "{}",
        walker.feet()
    );
    walker.steps(
        60,
        CharacterInput {
            fly: true,
            ..still()
        },
    );
    assert_eq!(walker.character.velocity, DVec3::ZERO);
    walker.steps(
        60,
        CharacterInput {
            fly: true,
            rise: true,
            ..still()
        },
    );
    assert!((walker.character.velocity.y - 8.0).abs() < 1e-9);
}

#[test]
fn a_hill_built_over_someone_lifts_them_onto_it() {
    let hill = |x: f64, z: f64| 6.0 * (-(x * x + z * z) / 18.0).exp();
    let mut soup = Soup::default();
    soup.field(-20, 20, |x, z| hill(f64::from(x), f64::from(z)) as f32);
    let world = soup.world();
    let inside = |at: DVec3| at.y < hill(at.x, at.z);
    let mut character = Character::at(DVec3::new(0.7, 0.0, 0.2));
    character.velocity = DVec3::new(1.0, -3.0, 0.0);
    assert!(world.in_chart().lift_out(&mut character, &inside));
    assert!(character.velocity.y >= 0.0);
    assert!(!world.in_chart().overlaps_capsule(character.feet, 1.8, 0.35));
    assert!(
        (character.feet.y - hill(0.7, 0.2)).abs() < 0.25,
        "{character:?}"
    );
    assert_eq!((character.feet.x, character.feet.z), (0.7, 0.2));
    let lifted = character.clone();
    assert!(
        !world.in_chart().lift_out(&mut character, &inside),
        "once is enough"
    );
    assert_eq!(character, lifted);
}

#[test]
fn someone_on_the_ground_is_not_lifted() {
    let world = plain().world();
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.0).rested();
    assert!(
        !world
            .in_chart()
            .lift_out(&mut walker.character, &|at| at.y < 0.0)
    );
}

#[test]
fn too_deep_in_the_ground_for_a_lift_nothing_moves() {
    let world = plain().world();
    let mut character = Character::at(DVec3::new(0.0, -80.0, 0.0));
    assert!(!world.in_chart().lift_out(&mut character, &|at| at.y < 0.0));
    assert_eq!(character, Character::at(DVec3::new(0.0, -80.0, 0.0)));
}
