//! Shadows while somebody digs and builds: frames drawn meanwhile show what a single picture of the same land does.

use crate::common::Studio;
use crate::common::worlds::World;
use antipode_geometry::Geometry;
use antipode_render::ShadowQuality;
use antipode_scene::Actions;
use image::RgbaImage;

/// Frames between two looks, each after some steps, as where drawing takes long.
const LOOKS: usize = 3;
const FRAMES: usize = 4;
const STEPS: usize = 6;

/// A world by day, and the ground before the player's feet.
fn world(geometry: Geometry, seed: u64, yaw_deg: f64) -> World {
    let mut world = World::new(geometry, seed, 32.0, 2).of_lines(180);
    world.scene.set_time_of_day_s(120.0);
    world.aim(yaw_deg, -35.0);
    world
}

/// Pixels of a picture that are darker or brighter than those of another by more than dust.
fn off(a: &RgbaImage, b: &RgbaImage) -> usize {
    let light = |p: &image::Rgba<u8>| p.0[..3].iter().map(|c| i32::from(*c)).sum::<i32>();
    let pairs = a.pixels().zip(b.pixels());
    pairs
        .filter(|(p, q)| (light(p) - light(q)).abs() > 45)
        .count()
}

/// The largest share of pixels that frames drawn while a button is held have wrong.
fn worst_off(mut world: World, builds: bool, shadows: ShadowQuality) -> Option<f64> {
    let size = world.size();
    let mut studio = Studio::shadowed(size, shadows)?;
    let mut other = Studio::shadowed(size, shadows)?;
    studio.draw(&world.frame());
    world.use_pickaxe(builds, 1);
    let held = Actions {
        primary: !builds,
        secondary: builds,
        ..Actions::default()
    };
    let mut worst: f64 = 0.0;
    for look in 0..LOOKS {
        let mut shown = None;
        for _ in 0..FRAMES {
            world.steps(STEPS, &held);
            shown = Some(studio.draw_in_motion(&world.frame()).0);
        }
        let settled = other.picture(&world.frame());
        let shown = shown.unwrap();
        if let Ok(dir) = std::env::var("ANTIPODE_TEST_PICTURES") {
            let name = format!(
                "{dir}/{:?}-{builds}-{shadows:?}-{look}",
                world.scene.strategy().geometry()
            );
            shown.save(format!("{name}-held.png")).unwrap();
            settled.save(format!("{name}-settled.png")).unwrap();
        }
        let share = off(&shown, &settled) as f64 / f64::from(size.0 * size.1);
        worst = worst.max(share);
    }
    Some(worst)
}

#[test]
fn shadows_follow_the_land_while_it_is_dug_and_built() {
    let (low, high) = (ShadowQuality::Low, ShadowQuality::High);
    let mut found = Vec::new();
    for (geometry, seed, builds, shadows) in [
        (Geometry::Spherical, 7, false, low),
        (Geometry::Spherical, 7, false, high),
        (Geometry::Euclidean, 2, false, low),
        (Geometry::Hyperbolic, 1, true, high),
    ] {
        let Some(worst) = worst_off(world(geometry, seed, -40.0), builds, shadows) else {
            return;
        };
        found.push((geometry, builds, shadows, worst));
    }
    assert!(found.iter().all(|it| it.3 < 0.002), "{found:?}");
}
