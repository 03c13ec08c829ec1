//! Particles in worlds, thrown up by hand.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::time::Duration;

use antipode_geometry::{ChartId, Geometry};
use antipode_physics::RayHit;
use antipode_terrain::{Part, Shape, Stroke};

use super::*;
use crate::projectile::{self, Air, Projectile};
use crate::setup::WorldSetup;
use crate::step::Simulation;
use crate::tuning::STEP_S;
use crate::{Actions, Scene};

const LIMIT: Duration = Duration::from_mins(2);
/// Nothing is thrown up at a step that does nothing.
const NOTHING: Surface = Surface {
    kind: antipode_terrain::Kind::Rock,
    colour: [0.2; 3],
    sky: 1.0,
};

fn opened(geometry: Geometry) -> Scene {
    let setup = WorldSetup {
        name: "Test".to_owned(),
        seed: 3,
        geometry,
        radius_m: 32.0,
        generator: antipode_terrain::Generator::default(),
        mode: crate::setup::Mode::default(),
        view_distance: 2,
    };
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// The ground so far to the side of the player's feet, metres.
fn ground_beside(scene: &Scene, x_m: f64, z_m: f64) -> (ChartPoint, RayHit) {
    let feet = scene.now().feet();
    let from = feet.moved(DVec3::new(x_m, 8.0, z_m));
    let ground = scene.sim.world.physics.chart(feet.chart);
    let hit = ground.cast_ray(from.pos, DVec3::NEG_Y, 30.0).unwrap();
    (ChartPoint::new(feet.chart, hit.point), hit)
}

/// Digs by effects about the player for so many strokes, and lets time pass.
fn dig(scene: &mut Scene, strokes: u32, steps_each: u32) {
    for stroke in 0..strokes {
        let (at, _) = ground_beside(scene, f64::from(stroke % 5) - 2.0, 3.0);
        let radius_m = 2.0;
        let effects = &mut scene.sim.outbox.effects;
        effects.push(Effect::Dug { at, radius_m });
        for _ in 0..steps_each {
            scene.step(&Actions::default());
            assert!(scene.wait_for_step(LIMIT));
        }
    }
}

#[test]
fn a_chip_flies_as_a_bullet_does_in_every_space() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let mut scene = opened(geometry);
        // On the globe it comes over the equator.
        let start = ChartPoint::new(ChartId::FIRST, DVec3::new(46.0, 24.0, 5.0));
        let velocity = DVec3::new(6.0, 9.0, -4.0);
        let chip = Particle {
            velocity,
            life_s: 9.0,
            ..Particle::of(Sort::Chip, start, DVec3::Y, &NOTHING)
        };
        let mut pool = vec![chip];
        let Simulation { world, actors, .. } = &mut scene.sim;
        projectile::fire(actors, start, velocity, actors.player);
        let air = Air {
            strategy: &*world.strategy,
            pictured: &*world.strategy,
            physics: &world.physics,
            standing: &[],
            cars: &[],
            in_far_ground: &|_| false,
            doors: None,
        };
        for _ in 0..120 {
            flight::step(&mut pool, world);
            projectile::step(&mut actors.ecs, &air);
        }
        let bullet = &actors.each::<Projectile>()[0];
        let chip = &pool[0];
        assert_eq!(chip.point.chart, bullet.point.chart, "{geometry:?}");
        let apart_m = chip.point.pos.distance(bullet.point.pos);
        assert!(apart_m < 1e-3, "{geometry:?}: {apart_m} m apart");
        // What it loses in height it wins in speed.
        let energy = |at: DVec3, velocity: DVec3| 0.5 * velocity.length_squared() + 9.81 * at.y;
        let before = energy(start.pos, velocity);
        let after = energy(chip.point.pos, chip.velocity);
        assert!((after - before).abs() < 1e-6 * before, "{before} {after}");
        let crossed = chip.point.chart != start.chart;
        assert_eq!(crossed, geometry == Geometry::Spherical, "over the equator");
    }
}

#[test]
fn landed_chips_lie_on_the_ground_and_the_pool_never_grows() {
    let mut scene = opened(Geometry::Euclidean);
    let room = scene.shown.particles.pool.capacity();
    dig(&mut scene, 60, 1);
    assert_eq!(scene.shown.particles.pool.len(), MOST_PARTICLES);
    for _ in 0..110 {
        scene.step(&Actions::default());
    }
    let particles = &scene.shown.particles;
    assert_eq!(particles.pool.capacity(), room);
    let lying: Vec<_> = particles.pool.iter().filter(|it| it.lies).collect();
    assert!(lying.len() > 20, "{} lie", lying.len());
    for chip in lying {
        let from = chip.point.pos + chip.up * 0.3;
        let ground = scene.sim.world.physics.chart(chip.point.chart);
        let hit = ground.cast_ray(from, -chip.up, 1.0).unwrap();
        let height_m = hit.distance_m - 0.3;
        assert!((0.0..0.1).contains(&height_m), "{height_m} m over ground");
    }
}

#[test]
fn the_same_steps_throw_the_same_particles_and_all_are_gone_in_the_end() {
    let fly = || {
        let mut scene = opened(Geometry::Hyperbolic);
        dig(&mut scene, 3, 9);
        scene
    };
    let (mut one, other) = (fly(), fly());
    let places = |scene: &Scene| -> Vec<_> {
        let pool = scene.shown.particles.pool.iter();
        pool.map(|it| (it.sort, it.point, it.radius_m)).collect()
    };
    assert!(!places(&one).is_empty());
    assert_eq!(places(&one), places(&other));
    for _ in 0..(6.0 / STEP_S) as u32 {
        one.step(&Actions::default());
    }
    assert!(one.frame(1.0, 1.0, 1).content.dust.particles.is_empty());
}

#[test]
fn prints_go_with_the_ground_that_is_dug_and_fade_where_it_stays() {
    let mut scene = opened(Geometry::Euclidean);
    let places = [(3.0, 0.0), (-12.0, 0.0)].map(|(x, z)| ground_beside(&scene, x, z));
    let now_s = scene.sim.world.simulated_s;
    for (at, hit) in places {
        let tracks = &mut scene.shown.particles.tracks;
        tracks.leave(print(at, hit.normal), hit.normal, now_s);
    }
    let count = |scene: &Scene| scene.probe().marks.alive;
    assert_eq!(count(&scene), 2);
    scene.sim.world.streamer.edit(Stroke {
        centre: places[0].0,
        radius_m: 2.0,
        amount: 2.0,
        part: Part::Whole,
        kind: None,
        shape: Shape::Ball,
        power: None,
    });
    for _ in 0..90 {
        scene.step(&Actions::default());
        assert!(scene.wait_for_step(LIMIT));
    }
    assert_eq!(count(&scene), 1, "the dug one alone is gone");
    for _ in 0..(31.0 / STEP_S) as u32 {
        scene.step(&Actions::default());
    }
    assert_eq!(count(&scene), 0, "the other has faded");
}

/// A small print that lies on the ground.
fn print(at: ChartPoint, up: DVec3) -> frame::GroundMark {
    let (a, b) = up.any_orthonormal_pair();
    frame::GroundMark {
        chart: at.chart,
        corners: [-a - b, a - b, b - a, a + b].map(|it| at.pos + it * 0.05 + up * 0.01),
        shape: frame::MarkShape::Print,
        strength: [0.5; 2],
        along_m: [0.0, 0.3],
    }
}
