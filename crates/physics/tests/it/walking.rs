//! Walking: ground, slopes, steps, walls, and meshes with bad triangles.

use crate::common::{STEP_S, Soup, Walker, bumps, go, plain, still};
use antipode_physics::{CharacterInput, CharacterTuning, ChartGround};
use glam::{DVec3, IVec3, Vec3};

fn slope(degrees: f32) -> ChartGround {
    let mut soup = Soup::default();
    let rise = degrees.to_radians().tan();
    soup.field(-20, 20, |x, _| if x > 0.0 { x * rise } else { 0.0 });
    soup.world()
}

fn stair(height: f32) -> ChartGround {
    let mut soup = plain();
    soup.cuboid([3.0, -1.0, -5.0], [9.0, height, 5.0]);
    soup.world()
}

fn hills() -> ChartGround {
    let mut soup = Soup::default();
    soup.march(IVec3::new(-4, -4, -4), IVec3::new(60, 4, 8), bumps);
    soup.world()
}

#[test]
fn walking_on_level_ground_reaches_its_speed_quickly_and_stops_quickly() {
    let world = plain().world();
    let mut walker = Walker::at(&world, 0.0, 0.5, 0.0).rested();
    assert!(
        walker.character.grounded && walker.feet().y.abs() < 1e-6,
        "{:?}",
        walker.character
    );
    walker.steps(2, go(1.0, 0.0));
    assert!(
        walker.character.velocity.x > 1.0 && walker.character.velocity.x < 2.0,
        "not at once"
    );
    walker.steps(6, go(1.0, 0.0));
    assert!(
        (walker.character.velocity.x - 4.5).abs() < 1e-9,
        "{}",
        walker.character.velocity
    );
    walker.steps(
        60,
        CharacterInput {
            sprint: true,
            ..go(1.0, 0.0)
        },
    );
    assert!(
        (walker.character.velocity.x - 4.5 * 1.7).abs() < 1e-9,
        "{}",
        walker.character.velocity
    );
    walker.steps(10, still());
    assert_eq!(walker.character.velocity, DVec3::ZERO);
}

#[test]
fn standing_is_perfectly_still_on_level_sloped_and_bumpy_ground() {
    for (world, x) in [
        (plain().world(), 0.3),
        (slope(30.0), 5.2),
        (slope(48.0), 5.2),
        (hills(), 17.3),
        (hills(), 6.1),
    ] {
        let mut walker = Walker::at(&world, x, 9.0, 0.4);
        walker.steps(300, still());
        assert!(walker.character.grounded, "{:?}", walker.character);
        let rest = walker.feet();
        for _ in 0..600 {
            walker.step(still());
            assert!(walker.character.grounded);
            assert!(
                walker.feet().distance(rest) < 1e-6,
                "{} against {rest}",
                walker.feet()
            );
            assert!(walker.character.velocity.length() < 1e-6);
        }
    }
}

#[test]
fn a_slope_of_45_degrees_is_walked_up_and_stood_on() {
    let world = slope(45.0);
    let mut walker = Walker::at(&world, -1.0, 0.1, 0.5).rested();
    walker.steps(120, go(1.0, 0.0));
    assert!(
        walker.character.grounded && walker.feet().y > 5.0,
        "{:?}",
        walker.character
    );
    walker.steps(30, still());
    let rest = walker.feet();
    walker.steps(60, still());
    assert!(walker.feet().distance(rest) < 1e-9);
}

#[test]
fn a_slope_of_55_degrees_is_not_climbed_and_is_slid_down() {
    let world = slope(55.0);
    let mut walker = Walker::at(&world, -1.0, 0.1, 0.5).rested();
    for _ in 0..120 {
        walker.step(CharacterInput {
            sprint: true,
            ..go(1.0, 0.0)
        });
        assert!(walker.feet().y < 0.15, "{:?}", walker.character);
    }
    let mut faller = Walker::at(&world, 8.0, 14.0, 0.5);
    faller.steps(90, still());
    assert!(
        !faller.character.grounded && faller.character.velocity.x < -1.0,
        "{:?}",
        faller.character
    );
    faller.steps(240, still());
    assert!(
        faller.character.grounded && faller.feet().y < 0.1,
        "{:?}",
        faller.character
    );
}

#[test]
fn running_down_a_walkable_slope_keeps_to_the_ground() {
    let world = slope(40.0);
    let mut walker = Walker::at(&world, 12.0, 11.0, 0.5).rested();
    while walker.feet().x > 1.0 {
        walker.step(CharacterInput {
            sprint: true,
            ..go(-1.0, 0.0)
        });
        assert!(walker.character.grounded, "{:?}", walker.character);
    }
}

#[test]
fn a_low_step_is_climbed_and_left_again_without_a_jump() {
    let world = stair(0.35);
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.2).rested();
    let mut stairs = 0.0_f64;
    for _ in 0..90 {
        walker.step(go(1.0, 0.0));
        stairs = stairs.max(walker.character.stair_m);
        assert!(walker.character.grounded);
        assert!(
            (walker.character.velocity.x - 4.5).abs() < 1e-9 || walker.feet().x < 0.5,
            "the step slows nobody"
        );
    }
    assert!(
        (walker.feet().y - 0.35).abs() < 1e-3 && walker.feet().x > 5.0,
        "{:?}",
        walker.character
    );
    assert!(stairs > 0.1, "the camera is told of the stair: {stairs}");
    walker.steps(90, go(-1.0, 0.0));
    assert!(
        walker.feet().y.abs() < 1e-3 && walker.feet().x < 1.5,
        "{:?}",
        walker.character
    );
}

#[test]
fn a_high_step_stops_the_walk() {
    for height in [0.45, 0.6, 1.0] {
        let world = stair(height);
        let mut walker = Walker::at(&world, 0.0, 0.1, 0.2).rested();
        walker.steps(
            240,
            CharacterInput {
                sprint: true,
                ..go(1.0, 0.05)
            },
        );
        assert!(
            walker.feet().y < 0.01 && walker.character.grounded,
            "{height}: {:?}",
            walker.character
        );
        assert!(
            (walker.feet().x - (3.0 - 0.35)).abs() < 0.01,
            "{height}: {:?}",
            walker.character
        );
    }
}

#[test]
fn a_low_step_under_a_low_ceiling_is_a_wall() {
    let mut soup = plain();
    soup.cuboid([3.0, -1.0, -5.0], [9.0, 0.35, 5.0]);
    soup.cuboid([2.0, 2.0, -5.0], [9.0, 3.0, 5.0]);
    let world = soup.world();
    let mut walker = Walker::at(&world, 0.0, 0.1, 0.2).rested();
    walker.steps(120, go(1.0, 0.0));
    assert!(
        walker.feet().x < 2.7 && walker.feet().y < 0.15,
        "{:?}",
        walker.character
    );
    walker.steps(30, go(0.0, 1.0));
    assert!(
        walker.feet().z > 1.5,
        "along the step the way is free: {:?}",
        walker.character
    );
}

#[test]
fn a_wall_is_slid_along_at_the_speed_that_is_left() {
    let mut soup = plain();
    soup.cuboid([3.0, -1.0, -50.0], [4.0, 5.0, 50.0]);
    let world = soup.world();
    let mut walker = Walker::at(&world, 2.0, 0.1, 0.0).rested();
    let diagonal = 0.5_f64.sqrt();
    walker.steps(60, go(diagonal, diagonal));
    let before = walker.feet();
    walker.steps(60, go(diagonal, diagonal));
    assert!(
        (walker.feet().x - 2.65).abs() < 1e-3,
        "{:?}",
        walker.character
    );
    let velocity = walker.character.velocity;
    assert!(
        velocity.x.abs() < 1e-9 && (velocity.z - 4.5 * diagonal).abs() < 1e-9,
        "{velocity}"
    );
    assert!(
        (walker.feet().z - before.z - 4.5 * diagonal).abs() < 0.02,
        "{} after {before}",
        walker.feet()
    );
}

#[test]
fn a_corner_holds_without_shaking() {
    let mut soup = plain();
    soup.cuboid([3.0, -1.0, -9.0], [4.0, 5.0, 9.0]);
    soup.cuboid([-9.0, -1.0, 3.0], [9.0, 5.0, 4.0]);
    let world = soup.world();
    let mut walker = Walker::at(&world, 1.0, 0.1, 1.0).rested();
    walker.steps(120, go(0.8, 0.6));
    let rest = walker.feet();
    for _ in 0..120 {
        walker.step(go(0.8, 0.6));
        assert!(
            walker.feet().distance(rest) < 1e-4,
            "{} against {rest}",
            walker.feet()
        );
    }
    assert!(
        (rest.x - 2.65).abs() < 1e-3 && (rest.z - 2.65).abs() < 1e-3,
        "{rest}"
    );
}

#[test]
fn fifty_metres_over_marched_hills_hold_the_speed() {
    let world = hills();
    for z in [0.0, 0.31, 1.5, 2.7, 4.0] {
        let mut walker = Walker::at(&world, 0.5, 3.0, z).rested();
        walker.steps(12, go(1.0, 0.0));
        let start = walker.feet();
        let mut slowest = f64::MAX;
        for _ in 0..(50.0 / 4.5 / STEP_S) as usize {
            let before = walker.feet();
            walker.step(go(1.0, 0.0));
            assert!(walker.character.grounded, "{:?}", walker.character);
            slowest = slowest.min((walker.feet().x - before.x) / STEP_S);
        }
        assert!(slowest > 4.49, "z {z}: {slowest} m/s, started at {start}");
    }
}

#[test]
fn a_cave_is_walked_through_with_its_floor_and_its_roof() {
    // Positive, that is air, within the tube; rock around it.
    let tube = |at: Vec3| {
        let axis = 3.0 + (at.x * 0.2).sin();
        1.9 - Vec3::new(
            0.0,
            (at.y - axis).min(0.0) * 1.3 + (at.y - axis).max(0.0) * 0.9,
            at.z,
        )
        .length()
    };
    let mut rock = Soup::default();
    rock.march(IVec3::new(-4, -2, -4), IVec3::new(44, 8, 4), tube);
    let world = rock.world();
    let mut walker = Walker::at(&world, 0.0, 3.0, 0.0).rested();
    assert!(walker.character.grounded, "{:?}", walker.character);
    walker.steps(500, go(1.0, 0.0));
    assert!(
        walker.feet().x > 30.0 && walker.feet().z.abs() < 1.5,
        "{:?}",
        walker.character
    );
}

#[test]
fn ground_is_nothing_to_someone_behind_it() {
    let mut soup = plain();
    soup.field(1, 9, |_, _| 1.6);
    let world = soup.world();
    let mut walker = Walker::at(&world, -1.0, 0.0, 3.0).rested();
    walker.steps(60, go(0.96, 0.28));
    assert!(
        (walker.character.velocity.length() - 4.5).abs() < 1e-9,
        "{:?}",
        walker.character
    );
    assert!(
        walker.character.grounded && walker.feet().y.abs() < 1e-6,
        "{:?}",
        walker.character
    );
}

#[test]
fn a_pit_between_steep_slopes_is_stood_in() {
    let mut soup = Soup::default();
    soup.field(-10, 10, |x, _| x.abs() * 1.6);
    let world = soup.world();
    let mut walker = Walker::at(&world, 0.4, 6.0, 0.3);
    walker.steps(240, still());
    assert!(walker.character.grounded, "{:?}", walker.character);
    let rest = walker.feet();
    for _ in 0..300 {
        walker.step(still());
        assert!(
            walker.character.grounded && walker.feet().distance(rest) < 1e-4,
            "{:?}",
            walker.character
        );
    }
}

#[test]
fn removing_the_ground_drops_whoever_stands_on_it() {
    let mut world = plain().world();
    let mut character = Walker::at(&world, 0.0, 0.1, 0.0).rested().character;
    assert!(world.has_terrain(crate::common::coord(0, 0, 0)));
    world.set_terrain(crate::common::coord(0, 0, 0), DVec3::ZERO, None);
    assert!(!world.has_terrain(crate::common::coord(0, 0, 0)));
    for _ in 0..60 {
        world.in_chart().move_character(
            &mut character,
            &CharacterTuning::default(),
            &still(),
            STEP_S,
        );
    }
    assert!(
        !character.grounded && (character.feet.y + 4.9).abs() < 0.1,
        "{character:?}"
    );
}
