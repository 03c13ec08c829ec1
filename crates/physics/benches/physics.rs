//! What the physics costs: a chunk's collider, a move of the player, a ray.
#![allow(clippy::unwrap_used, reason = "a bench fails by panicking")]

#[path = "../tests/it/common/mod.rs"]
mod common;

use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{ChartId, Geometry, Strategy, strategy};
use antipode_physics::{
    Character, CharacterInput, CharacterTuning, ChartGround, PhysicsWorld, TerrainCollider,
};
use common::{STEP_S, Soup, bumps, coord};
use divan::{Bencher, black_box};
use glam::{DVec3, IVec3, Vec3};

fn main() {
    divan::main();
}

/// A chunk of hilly ground, about 7200 triangles.
fn hills() -> Soup {
    let mut soup = Soup::default();
    soup.march(IVec3::ZERO, IVec3::new(32, 12, 23), |at| {
        bumps(at - Vec3::Y * 4.0)
    });
    soup
}

/// Such ground with the roof of a cave above, three times as many triangles.
fn cave() -> Soup {
    let mut soup = Soup::default();
    soup.march(IVec3::ZERO, IVec3::new(32, 32, 32), |at| {
        let roof = (at.y - 10.0 - (at.x * 0.4).sin()).abs() - 1.5;
        bumps(at - Vec3::Y * 4.0).min(roof)
    });
    soup
}

/// With vertices that neighbours share, as those of the game's chunks are.
fn welded(soup: &Soup) -> TerrainCollider {
    let mut numbers = HashMap::new();
    let mut positions = Vec::new();
    let shared: Vec<u32> = soup
        .positions
        .iter()
        .map(|at| {
            *numbers.entry(at.map(f32::to_bits)).or_insert_with(|| {
                positions.push(*at);
                positions.len() as u32 - 1
            })
        })
        .collect();
    let triangles: Vec<_> = soup
        .triangles
        .iter()
        .map(|corners| corners.map(|it| shared[it as usize]))
        .collect();
    TerrainCollider::build(&positions, &triangles).unwrap()
}

/// Nine chunks around the one in the middle.
fn land() -> ChartGround {
    let collider = welded(&cave());
    let mut world = ChartGround::new();
    for (x, z) in (-1..=1).flat_map(|x| (-1..=1).map(move |z| (x, z))) {
        let at = DVec3::new(f64::from(x), 0.0, f64::from(z)) * 32.0;
        world.set_terrain(coord(x, 0, z), at, Some(collider.clone()));
    }
    world
}

/// The player at rest in the middle of [`land`], and looked after that it rests there.
fn player(world: &ChartGround) -> Character {
    let mut character = Character::at(DVec3::new(16.0, 6.0, 16.0));
    for _ in 0..120 {
        world.in_chart().move_character(
            &mut character,
            &CharacterTuning::default(),
            &CharacterInput::default(),
            STEP_S,
        );
    }
    assert!(character.grounded, "{character:?}");
    character
}

#[divan::bench]
fn build_collider(bencher: Bencher<'_, '_>) {
    let soup = hills();
    bencher
        .counter(divan::counter::ItemsCount::new(soup.triangles.len()))
        .bench(|| black_box(&soup).build());
}

#[divan::bench]
fn place_chunk(bencher: Bencher<'_, '_>) {
    let collider = hills().build();
    let mut world = land();
    bencher.bench_local(|| world.set_terrain(coord(0, 0, 0), DVec3::ZERO, Some(collider.clone())));
}

#[divan::bench]
fn sprint_one_step(bencher: Bencher<'_, '_>) {
    let (world, tuning) = (land(), CharacterTuning::default());
    let mut character = player(&world);
    let mut step = 0.0_f64;
    bencher.bench_local(|| {
        step += 1.0;
        let wish = DVec3::new((step * 0.02).cos(), 0.0, (step * 0.02).sin());
        let input = CharacterInput {
            wish,
            sprint: true,
            ..CharacterInput::default()
        };
        world
            .in_chart()
            .move_character(&mut character, &tuning, &input, STEP_S);
    });
}

#[divan::bench]
fn stand_one_step(bencher: Bencher<'_, '_>) {
    let (world, tuning) = (land(), CharacterTuning::default());
    let mut character = player(&world);
    bencher.bench_local(|| {
        world.in_chart().move_character(
            &mut character,
            &tuning,
            &CharacterInput::default(),
            STEP_S,
        );
    });
}

/// The same land about the middle of a closed world, where its metres are those of the space, and a character that rests there.
fn closed() -> (Arc<dyn Strategy>, PhysicsWorld, Character) {
    let mut world = PhysicsWorld::new();
    let ground = world.chart_mut(ChartId::FIRST);
    *ground = land();
    let character = player(ground);
    (strategy(Geometry::Spherical, 64.0), world, character)
}

#[divan::bench]
fn sprint_one_step_in_a_closed_world(bencher: Bencher<'_, '_>) {
    let ((space, world, mut character), tuning) = (closed(), CharacterTuning::default());
    let mut step = 0.0_f64;
    bencher.bench_local(|| {
        step += 1.0;
        let wish = DVec3::new((step * 0.02).cos(), 0.0, (step * 0.02).sin());
        let input = CharacterInput {
            wish,
            sprint: true,
            ..CharacterInput::default()
        };
        let ground = world.for_bodies(&*space, ChartId::FIRST);
        ground.move_character(&mut character, &tuning, &input, STEP_S)
    });
}

#[divan::bench]
fn stand_one_step_in_a_closed_world(bencher: Bencher<'_, '_>) {
    let ((space, world, mut character), tuning) = (closed(), CharacterTuning::default());
    bencher.bench_local(|| {
        let ground = world.for_bodies(&*space, ChartId::FIRST);
        ground.move_character(&mut character, &tuning, &CharacterInput::default(), STEP_S)
    });
}

#[divan::bench]
fn fall_at_60_m_s(bencher: Bencher<'_, '_>) {
    let (world, tuning) = (land(), CharacterTuning::default());
    let rest = player(&world);
    bencher.bench(|| {
        let mut character = Character::at(rest.feet + DVec3::Y * 0.7);
        character.velocity.y = -60.0;
        world.in_chart().move_character(
            &mut character,
            &tuning,
            &CharacterInput::default(),
            STEP_S,
        );
        assert!(character.grounded);
        character
    });
}

#[divan::bench]
fn ray_of_100_m(bencher: Bencher<'_, '_>) {
    let world = land();
    let mut turn = 0.0_f64;
    bencher.bench_local(|| {
        turn += 0.1;
        world.cast_ray(
            DVec3::new(16.0, 6.5, 16.0),
            DVec3::new(turn.cos(), -0.03, turn.sin()),
            100.0,
        )
    });
}

#[divan::bench]
fn camera_ball_of_4_m(bencher: Bencher<'_, '_>) {
    let world = land();
    let mut turn = 0.0_f64;
    bencher.bench_local(|| {
        turn += 0.1;
        world.cast_sphere(
            DVec3::new(16.0, 6.5, 16.0),
            DVec3::new(turn.cos(), -0.4, turn.sin()),
            0.2,
            4.0,
        )
    });
}
