//! Rays, casts, the floating origin and repeatability.

use crate::common::{STEP_S, Soup, bumps, coord, plain};
use antipode_physics::{Ball, BallTuning, Character, CharacterInput, CharacterTuning, ChartGround};
use glam::{DVec3, IVec3, Vec3};

fn hills() -> Soup {
    let mut soup = Soup::default();
    soup.march(IVec3::new(-4, -4, -4), IVec3::new(60, 4, 8), bumps);
    soup
}

/// A walk with turns, sprints and jumps, relative to where it starts.
fn ramble(world: &mut ChartGround, from: DVec3, recentre: bool) -> Vec<Character> {
    let tuning = CharacterTuning::default();
    let mut character = Character::at(from + DVec3::new(1.0, 3.0, 1.0));
    (0..600)
        .map(|step| {
            let turn = f64::from(step) * 0.01;
            let wish = DVec3::new(turn.cos().abs(), 0.0, 0.4 * (turn * 3.0).sin());
            let input = CharacterInput {
                wish,
                sprint: step % 100 > 60,
                jump: step % 45 == 0,
                ..Default::default()
            };
            if recentre {
                world.recentre(character.feet);
            }
            world
                .in_chart()
                .move_character(&mut character, &tuning, &input, STEP_S);
            character.clone()
        })
        .collect()
}

#[test]
fn the_same_inputs_repeat_the_same_moves_to_the_bit() {
    let first = ramble(&mut hills().world(), DVec3::ZERO, false);
    let second = ramble(&mut hills().world(), DVec3::ZERO, false);
    assert_eq!(first, second);
    assert!(first.last().unwrap().feet.x > 20.0);
}

#[test]
fn the_order_in_which_chunks_came_does_not_matter() {
    let (left, right) = (hills().build(), plain().build());
    let mut forward = ChartGround::new();
    forward.set_terrain(coord(0, 0, 0), DVec3::ZERO, Some(left.clone()));
    forward.set_terrain(coord(1, 0, 0), DVec3::NEG_Y, Some(right.clone()));
    let mut backward = ChartGround::new();
    backward.set_terrain(coord(5, 5, 5), DVec3::ZERO, Some(right.clone()));
    backward.set_terrain(coord(1, 0, 0), DVec3::NEG_Y, Some(right));
    backward.set_terrain(coord(0, 0, 0), DVec3::ZERO, Some(left));
    backward.set_terrain(coord(5, 5, 5), DVec3::ZERO, None);
    assert_eq!(
        ramble(&mut forward, DVec3::ZERO, false),
        ramble(&mut backward, DVec3::ZERO, false)
    );
}

/// Hollows in ground of two chunks that meet where x is 0.
fn halves() -> [Soup; 2] {
    [(-8, 0), (0, 8)].map(|(from, to)| {
        let mut soup = Soup::default();
        let hollows = |at: Vec3| at.y - 0.6 * (at.x * 0.9).cos() * (at.z * 0.7).sin();
        soup.march(IVec3::new(from, -3, -8), IVec3::new(to, 3, 8), hollows);
        soup
    })
}

#[test]
fn a_ball_on_the_border_of_chunks_does_not_tell_which_came_first() {
    let [left, right] = halves().map(|soup| soup.build());
    let world = |order: [usize; 2]| {
        let mut world = ChartGround::new();
        for number in order {
            let collider = [&left, &right][number].clone();
            world.set_terrain(coord(number as i32, 0, 0), DVec3::ZERO, Some(collider));
        }
        world
    };
    let worlds = [world([0, 1]), world([1, 0])];
    let tuning = BallTuning {
        radius_m: 0.1,
        gravity_m_s2: 9.81,
        bounce: 0.4,
        slide: 0.8,
    };
    let mut borders = 0;
    for n in 0..200 {
        let z = f64::from(n) * 0.07 - 7.0;
        let mut balls = [Ball {
            centre: DVec3::new(0.3 * f64::from(n % 7) - 0.9, 1.5, z),
            velocity: DVec3::new(0.0, -1.0, 0.3),
        }; 2];
        for step in 0..240 {
            for (ball, world) in balls.iter_mut().zip(&worlds) {
                world.in_chart().throw_ball(ball, &tuning, STEP_S);
            }
            assert_eq!(balls[0], balls[1], "ball {n}, step {step}");
            borders += usize::from(balls[0].centre.x.abs() < tuning.radius_m);
        }
    }
    assert!(borders > 1000, "{borders} steps on the border");
}

#[test]
fn a_million_metres_out_the_walk_is_the_same() {
    let far = DVec3::new(1_000_000.0, 320.0, -1_000_000.0);
    let near = ramble(&mut hills().world(), DVec3::ZERO, false);
    let mut world = hills().world_at(far);
    let away = ramble(&mut world, far, true);
    assert!((world.origin() - far).length() < 600.0 && world.origin() % 32.0 == DVec3::ZERO);
    for (near, away) in near.iter().zip(&away) {
        assert!(
            (away.feet - far).distance(near.feet) < 1e-3,
            "{near:?} {away:?}"
        );
    }
}

#[test]
fn moving_the_floating_origin_moves_nothing() {
    let at = DVec3::new(700.0, 0.0, 0.0);
    let mut world = plain().world_at(at);
    let hit = |world: &ChartGround| {
        world
            .cast_ray(at + DVec3::new(3.3, 9.0, 1.7), DVec3::NEG_Y, 50.0)
            .unwrap()
    };
    let before = hit(&world);
    world.recentre(at);
    assert_eq!(world.origin(), DVec3::new(704.0, 0.0, 0.0));
    let after = hit(&world);
    assert!(before.point.distance(after.point) < 1e-3);
    world.recentre(DVec3::new(f64::NAN, 0.0, 0.0));
    assert_eq!(world.origin(), DVec3::new(704.0, 0.0, 0.0));
    world.recentre(at + 500.0);
    assert_eq!(
        world.origin(),
        DVec3::new(704.0, 0.0, 0.0),
        "only a long way moves it"
    );
}

#[test]
fn rays_find_the_nearest_surface_with_its_normal() {
    let mut soup = plain();
    soup.cuboid([5.0, -1.0, -2.0], [6.0, 3.0, 2.0]);
    let world = soup.world();
    let hit = world
        .cast_ray(DVec3::new(0.0, 1.0, 0.1), DVec3::X * 7.0, 50.0)
        .unwrap();
    assert!(
        (hit.distance_m - 5.0).abs() < 1e-5,
        "the direction's length does not matter: {hit:?}"
    );
    assert!(
        hit.normal.distance(DVec3::NEG_X) < 1e-6
            && hit.point.distance(DVec3::new(5.0, 1.0, 0.1)) < 1e-5
    );
    assert!(
        world
            .cast_ray(DVec3::new(0.0, 1.0, 0.1), DVec3::X, 4.9)
            .is_none(),
        "too short"
    );
    assert!(
        world
            .cast_ray(DVec3::new(0.0, 1.0, 0.1), DVec3::Y, 500.0)
            .is_none(),
        "into the sky"
    );
    let slant = world
        .cast_ray(DVec3::new(-3.0, 4.0, 0.3), DVec3::new(0.0, -1.0, 1.0), 50.0)
        .unwrap();
    assert!(
        (slant.distance_m - 32f64.sqrt()).abs() < 1e-4 && slant.normal.distance(DVec3::Y) < 1e-6,
        "{slant:?}"
    );
}

#[test]
fn rays_that_are_no_rays_hit_nothing() {
    let world = plain().world();
    for (origin, way, far) in [
        (DVec3::splat(f64::NAN), DVec3::NEG_Y, 9.0),
        (DVec3::Y, DVec3::ZERO, 9.0),
        (DVec3::Y, DVec3::splat(f64::INFINITY), 9.0),
        (DVec3::Y, DVec3::NEG_Y, -1.0),
        (DVec3::Y, DVec3::NEG_Y, f64::NAN),
    ] {
        assert!(
            world.cast_ray(origin, way, far).is_none(),
            "{origin} {way} {far}"
        );
        assert!(world.cast_sphere(origin, way, 0.2, far).is_none());
    }
}

#[test]
fn a_ball_stops_its_radius_before_the_wall() {
    let mut soup = plain();
    soup.cuboid([5.0, -1.0, -2.0], [6.0, 3.0, 2.0]);
    let world = soup.world();
    let free = world
        .cast_sphere(DVec3::new(0.0, 1.0, 0.1), DVec3::X, 0.2, 50.0)
        .unwrap();
    assert!((free - 4.8).abs() < 1e-3, "{free}");
    assert!(
        world
            .cast_sphere(DVec3::new(0.0, 1.0, 0.1), DVec3::X, 0.2, 4.0)
            .is_none()
    );
    let touching = world
        .cast_sphere(DVec3::new(4.9, 1.0, 0.1), DVec3::X, 0.2, 4.0)
        .unwrap();
    assert!(touching < 1e-6, "{touching}");
    let along = world.cast_sphere(DVec3::new(0.0, 0.5, 0.1), DVec3::NEG_X, 0.2, 40.0);
    assert!(along.is_none(), "level over the plain: {along:?}");
}

#[test]
fn capsules_overlap_what_they_cut() {
    let world = plain().world();
    assert!(
        !world
            .in_chart()
            .overlaps_capsule(DVec3::new(0.0, 0.0, 0.0), 1.8, 0.35),
        "standing is no overlap"
    );
    assert!(
        world
            .in_chart()
            .overlaps_capsule(DVec3::new(0.0, -0.05, 0.0), 1.8, 0.35)
    );
    assert!(
        world
            .in_chart()
            .overlaps_capsule(DVec3::new(0.0, -1.7, 0.0), 1.8, 0.35),
        "from below as well"
    );
    assert!(
        !world
            .in_chart()
            .overlaps_capsule(DVec3::new(0.0, -2.0, 0.0), 1.8, 0.35)
    );
}

#[test]
fn terrain_is_replaced_and_removed() {
    let mut world = plain().world();
    let height = |world: &ChartGround| {
        world
            .cast_ray(DVec3::new(0.4, 20.0, 0.2), DVec3::NEG_Y, 50.0)
            .map(|hit| (hit.point.y * 1e3).round() / 1e3)
    };
    assert_eq!(height(&world), Some(0.0));
    world.set_terrain(coord(0, 0, 0), DVec3::Y * 2.0, Some(plain().build()));
    assert_eq!((height(&world), world.terrain_count()), (Some(2.0), 1));
    world.set_terrain(coord(0, 0, 1), DVec3::Y * 3.0, Some(plain().build()));
    world.set_terrain(coord(0, 0, 0), DVec3::ZERO, None);
    world.set_terrain(coord(7, 7, 7), DVec3::ZERO, None);
    assert_eq!((height(&world), world.terrain_count()), (Some(3.0), 1));
    world.set_terrain(coord(0, 0, 1), DVec3::ZERO, None);
    assert_eq!((height(&world), world.terrain_count()), (None, 0));
}
