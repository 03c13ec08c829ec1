//! Light of lamps in pictures is that of the reference, whichever way it comes.

use antipode_deformation::{Place, Sides, Space, Traveller, Void, felt_normal, lamp_paths};
use antipode_rays::{Lamp, RayScene};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3, Vec3};

use crate::common::{Gpu, looking, middle, scene_of, shown};
use crate::pictures::boxed;

const REACH_M: f64 = 30.0;
/// Of the floor.
const COLOUR: f64 = 0.6;

/// A floor that nothing but one lamp lights, with a box over it and another in that.
fn floor_and_boxes() -> RayScene {
    let middle = DVec3::new(0.0, -1.0, 0.0);
    let solids = rooms::cuboid(middle, DQuat::IDENTITY, DVec3::new(30.0, 1.0, 30.0), 0);
    let mut scene = scene_of(&solids);
    scene.sky.ambient_sky = Vec3::ZERO;
    scene.sky.ambient_ground = Vec3::ZERO;
    scene.fog_m = 1e5;
    let outer = boxed(DVec3::new(1.0, 1.4, 1.6), Sides::Soft);
    let mut inner = boxed(DVec3::new(0.8, 1.0, 1.3), Sides::Soft);
    "inner".clone_into(&mut inner.name);
    inner.half *= 0.5;
    scene.aberrations = Space::new(vec![outer, inner]).unwrap();
    scene
}

/// What the reference says that the lamp of a scene adds at a place of the floor.
fn expected(scene: &RayScene, from: &Place) -> f64 {
    let space = &scene.aberrations;
    let lamp = &scene.lamps[0];
    let ways = lamp_paths(space, from, &lamp.place);
    let clear = ways
        .iter()
        .filter(|way| way.is_clear(space, from, &lamp.place, &Void));
    let light = clear.map(|way| {
        let k = space.squeeze(&from.stack, way.w, &Traveller::Body);
        let cosine = felt_normal(k, DVec3::Y).dot(way.w);
        let share = way.length / REACH_M;
        let fade = (1.0 - share.powi(4)).max(0.0);
        let through = fade * fade / (1.0 + 0.24 * way.length * way.length);
        if cosine > 0.0 {
            COLOUR * through * (0.9 * cosine + 0.1)
        } else {
            0.0
        }
    });
    light.sum::<f64>() * f64::from(lamp.colour.x)
}

#[test]
fn a_floor_is_lit_as_much_as_the_reference_says_through_faces_into_boxes_and_out_of_them() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let mut scene = floor_and_boxes();
    let mut rng = Rng::with_seed(17);
    // Ways met by how many boxes deeper or less deep the lamp is.
    let mut met = [0; 3];
    for _ in 0..60 {
        let mut place = |height| {
            let (x, z) = (12.0 * rng.f64() - 6.0, 13.0 * rng.f64() - 7.0);
            DVec3::new(x, height, z)
        };
        let (p, lamp) = (place(0.0), place(1.1));
        let lamp = Place::at(&scene.aberrations, lamp);
        scene.lamps = vec![Lamp {
            place: lamp,
            colour: Vec3::splat(20.0),
            reach_m: REACH_M as f32,
            radius_m: 0.01,
        }];
        let from = Place::at(&scene.aberrations, p + DVec3::new(0.0, 3e-4, 0.0));
        let expected = expected(&scene, &from);
        let above = p + DVec3::new(0.0, 0.2, 0.001);
        let light = middle(&shown(gpu, &scene, &looking(&scene, above, p)).0)[0];
        let apart = (f64::from(light) - expected).abs();
        assert!(
            apart <= 0.01 * expected + 0.003,
            "{p} to {lamp:?}: {light} and not {expected}"
        );
        if expected > 0.01 {
            met[1 + lamp.stack.len() - from.stack.len()] += 1;
        }
    }
    assert!(met.iter().all(|count| *count >= 4), "{met:?}");
}
