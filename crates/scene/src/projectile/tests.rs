//! Bullets without a world.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{Atlas, ChartId, ChunkCoord, Geometry, Strategy, strategy};
use antipode_physics::TerrainCollider;
use antipode_testing::tiled::TiledFlat;
use glam::{DQuat, IVec3};

use super::*;
use crate::actors::ActorId;

fn entity(ecs: &mut hecs::World) -> Entity {
    ecs.spawn(())
}

fn flying(bullets: &Actors) -> Vec<Projectile> {
    bullets.each()
}

fn fly(
    space: &dyn Strategy,
    bullets: &mut Actors,
    standing: &[Standing],
    steps: usize,
) -> Vec<Strike> {
    fly_over(space, &PhysicsWorld::new(), bullets, standing, steps)
}

fn fly_over(
    space: &dyn Strategy,
    physics: &PhysicsWorld,
    bullets: &mut Actors,
    standing: &[Standing],
    steps: usize,
) -> Vec<Strike> {
    let air = Air {
        strategy: space,
        pictured: space,
        physics,
        standing,
        cars: &[],
        in_far_ground: &|point| point.pos.y < 0.0,
        doors: None,
    };
    (0..steps)
        .flat_map(|_| step(&mut bullets.ecs, &air).strikes)
        .collect()
}

#[test]
fn a_bullet_falls_until_it_lands_however_long_and_room_is_made_for_the_next() {
    let space = strategy(Geometry::Euclidean, 0.0);
    let mut ecs = hecs::World::new();
    let by = entity(&mut ecs);
    let mut bullets = Actors::with_player(());
    fire(
        &mut bullets,
        ChartPoint::a(DVec3::Y * 500.0),
        DVec3::X * 40.0,
        by,
    );
    fly(&*space, &mut bullets, &[], 60);
    let at = flying(&bullets)[0].point.pos;
    assert!(
        (at - DVec3::new(40.0, 500.0 - 0.5 * BULLET.gravity_m_s2, 0.0)).length() < 1e-6,
        "{at}"
    );
    // From 500 m it falls for 10.1 s.
    fly(&*space, &mut bullets, &[], 540);
    assert!(flying(&bullets)[0].point.pos.y > 0.0);
    fly(&*space, &mut bullets, &[], 10);
    assert!(flying(&bullets).is_empty());
    for _ in 0..MOST_BULLETS + 7 {
        fire(&mut bullets, ChartPoint::a(DVec3::ZERO), DVec3::ZERO, by);
    }
    assert_eq!(flying(&bullets).len(), MOST_BULLETS);
    assert_eq!(bullets.all::<Projectile>()[0].0, ActorId(8));
}

/// A ledge of 2 m by 2 m at the height of 300 m, and ground at that of 4 m.
fn ledge() -> PhysicsWorld {
    let square = |from: f32, to: f32, y: f32| {
        [[from, from], [from, to], [to, from], [to, to]].map(|[x, z]| [x, y, z])
    };
    let mut world = PhysicsWorld::new();
    for (number, positions) in [square(0.0, 2.0, 300.0), square(0.0, 32.0, 4.0)]
        .into_iter()
        .enumerate()
    {
        let collider = TerrainCollider::build(&positions, &[[1, 3, 2], [0, 1, 2]]).unwrap();
        let coord = ChunkCoord::new(ChartId::FIRST, IVec3::splat(number as i32));
        world
            .chart_mut(coord.chart)
            .set_terrain(coord, DVec3::ZERO, Some(collider));
    }
    world
}

#[test]
fn a_bullet_that_has_met_something_falls_on_and_lies_where_it_lands_for_five_seconds() {
    let space = strategy(Geometry::Euclidean, 0.0);
    let mut ecs = hecs::World::new();
    let mut bullets = Actors::with_player(());
    let over_the_edge = DVec3::new(1.0, 301.0, 1.0);
    fire(
        &mut bullets,
        ChartPoint::a(over_the_edge),
        DVec3::new(2.0, -20.0, 0.0),
        entity(&mut ecs),
    );
    let physics = ledge();
    let mut landed_s = None;
    let gone_s = (1..60 * 60)
        .map(|step| f64::from(step) * STEP_S)
        .find(|now_s| {
            fly_over(&*space, &physics, &mut bullets, &[], 1);
            let lies =
                |bullet: &Projectile| bullet.point.pos.y < 4.1 && bullet.velocity.length() < 0.3;
            if flying(&bullets).iter().any(lies) {
                landed_s.get_or_insert(*now_s);
            }
            flying(&bullets).is_empty()
        });
    let landed_s = landed_s.unwrap();
    assert!(landed_s > 7.0, "it falls for 296 m: {landed_s} s");
    let lay_s = gone_s.unwrap() - landed_s;
    assert!((4.5..6.0).contains(&lay_s), "{lay_s}");
}

#[test]
fn a_bullet_that_never_falls_is_gone_after_some_way() {
    let space = strategy(Geometry::Euclidean, 0.0);
    let mut ecs = hecs::World::new();
    let by = entity(&mut ecs);
    let mut bullets = Actors::with_player(());
    let eye = Eye {
        point: ChartPoint::a(DVec3::Y * 9.0),
        ..Eye::default()
    };
    fire_straight(
        &mut bullets,
        &*space,
        eye,
        ChartPoint::a(DVec3::new(9.0, 9.0, 0.0)),
        40.0,
        by,
    );
    fly(&*space, &mut bullets, &[], 299);
    assert_eq!(flying(&bullets).len(), 1);
    fly(&*space, &mut bullets, &[], 2);
    assert!(flying(&bullets).is_empty());
}

#[test]
fn over_the_equator_a_bullet_keeps_its_way() {
    let space = strategy(Geometry::Spherical, 32.0);
    let mut ecs = hecs::World::new();
    let by = entity(&mut ecs);
    let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap();
    let mut bullets = Actors::with_player(());
    let start = ChartPoint::a(DVec3::new(rim_m - 2.0, 10.0, 0.0));
    fire(&mut bullets, start, DVec3::new(40.0, 6.0, 0.0), by);
    fly(&*space, &mut bullets, &[], 12);
    let bullet = &flying(&bullets)[0];
    assert_eq!(bullet.point.chart, ChartId::SECOND);
    // Eight metres about ten and a half over the plane, where a metre of it is shorter.
    let gone_m = 8.0 / (10.5_f64 / 32.0).cos();
    let from_middle_m = bullet.point.pos.x.hypot(bullet.point.pos.z);
    assert!((from_middle_m - (rim_m + 2.0 - gone_m)).abs() < 0.02);
    assert!((bullet.velocity.with_y(0.0).length() - 40.0).abs() < 1e-9);
}

#[test]
fn along_a_geodesic_a_bullet_goes_straight_through_what_was_aimed_at() {
    for geometry in [
        Geometry::Hyperbolic,
        Geometry::Spherical,
        Geometry::Euclidean,
    ] {
        let space = strategy(geometry, 32.0);
        let mut ecs = hecs::World::new();
        let by = entity(&mut ecs);
        let eye = Eye {
            point: ChartPoint::a(DVec3::new(1.0, 12.0, -3.0)),
            dial: 15.0,
            lift_m: 1.62,
            ..Eye::default()
        };
        let target = ChartPoint::a(DVec3::new(16.0, 9.0, 8.0));
        let mut bullets = Actors::with_player(());
        fire_straight(&mut bullets, &*space, eye, target, 40.0, by);
        let mut nearest = f64::MAX;
        let mut last = eye.point.pos;
        for _ in 0..60 {
            fly(&*space, &mut bullets, &[], 1);
            // Nothing stops it, and below all ground it is gone.
            let Some(bullet) = flying(&bullets).into_iter().next() else {
                break;
            };
            let at = bullet.point.pos;
            let way = at - last;
            let share = ((target.pos - last).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            nearest = nearest.min((last + way * share).distance(target.pos));
            last = at;
        }
        assert!(nearest < 0.02, "{geometry:?} {nearest}");
    }
}

#[test]
fn who_stands_in_the_way_is_struck_once_and_the_shooter_is_not_at_first() {
    let space = strategy(Geometry::Euclidean, 0.0);
    let mut ecs = hecs::World::new();
    let (by, other) = (entity(&mut ecs), entity(&mut ecs));
    let stands = |entity, x: f64| Standing {
        entity,
        feet: ChartPoint::a(DVec3::new(x, 99.0, 0.0)),
        height_m: 1.8,
        radius_m: 0.35,
    };
    let mut bullets = Actors::with_player(());
    fire(
        &mut bullets,
        ChartPoint::a(DVec3::Y * 100.0),
        DVec3::X * 40.0,
        by,
    );
    let strikes = fly(
        &*space,
        &mut bullets,
        &[stands(by, 0.2), stands(other, 12.0)],
        60,
    );
    assert!(
        matches!(strikes[..], [strike] if strike.entity == other && strike.by == by && strike.way.x > 30.0),
        "{strikes:?}"
    );
    assert!(flying(&bullets)[0].point.pos.x < 12.5, "it drops there");
}

/// A bullet meets a body just beyond an edge in the chart that it has not reached yet. The body learns the direction in its own chart.
#[test]
fn who_stands_beyond_an_edge_is_struck_and_not_flown_over() {
    let mut ecs = hecs::World::new();
    let (by, other) = (entity(&mut ecs), entity(&mut ecs));
    for edge in 0..4 {
        let way = DQuat::from_rotation_y(f64::from(edge) * FRAC_PI_2) * DVec3::X;
        let stands = Standing {
            entity: other,
            feet: TiledFlat::at(way * 32.3 + DVec3::Y * 99.0),
            height_m: 1.8,
            radius_m: 0.35,
        };
        assert_ne!(stands.feet.chart, ChartId::FIRST);
        let mut bullets = Actors::with_player(());
        let from = TiledFlat::at(way * 30.95 + DVec3::Y * 100.0);
        fire(&mut bullets, from, way * 60.0, by);
        let strikes = fly(&TiledFlat, &mut bullets, &[stands], 3);
        let [strike] = strikes[..] else {
            panic!("{edge}: {strikes:?}");
        };
        let feet = TiledFlat::at(way * 32.3);
        let own = TiledFlat.carry(from, feet.chart).unwrap().turn_vector(way);
        assert!(
            strike.way.normalize().distance(own) < 0.05,
            "{strike:?} {own}"
        );
    }
}

#[test]
fn a_bullet_that_someone_has_stopped_harms_nobody_any_more() {
    let space = strategy(Geometry::Euclidean, 0.0);
    let mut ecs = hecs::World::new();
    let (by, other) = (entity(&mut ecs), entity(&mut ecs));
    let stands = |entity, x: f64| Standing {
        entity,
        feet: ChartPoint::a(DVec3::new(x, 99.0, 0.0)),
        height_m: 1.8,
        radius_m: 0.35,
    };
    let near = [stands(by, -0.7), stands(other, 2.3)];
    let mut bullets = Actors::with_player(());
    for height_m in [99.6, 100.0, 100.4] {
        fire(
            &mut bullets,
            ChartPoint::a(DVec3::Y * height_m),
            DVec3::X * 40.0,
            by,
        );
    }
    let strikes = fly(&*space, &mut bullets, &near, 200);
    assert_eq!(strikes.len(), 3, "{strikes:?}");
    assert!(strikes.iter().all(|strike| strike.entity == other));
}
