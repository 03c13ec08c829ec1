//! What pictures show.

use std::sync::Arc;

use antipode_deformation::{Aberration, Place, Sides, Space, Ways};
use antipode_rays::{Lamp, RayScene, Seen, Sun};
use antipode_testing::rooms;
use glam::{DQuat, DVec3, Vec3};

use crate::common::{Gpu, Light, looking, mesh, middle, scene_of, shown, standing};

pub fn boxed(stretch: DVec3, sides: Sides) -> Aberration {
    Aberration {
        name: "box".to_owned(),
        centre: DVec3::new(0.3, 0.2, -1.0),
        turn: DQuat::from_rotation_y(0.4),
        half: DVec3::new(3.0, 2.0, 4.0),
        stretch,
        sides,
        ways: Ways::Both,
    }
}

/// A floor, a pillar on it and a sun.
pub fn yard() -> RayScene {
    let mut solids = rooms::cuboid(
        DVec3::new(0.0, -1.0, 0.0),
        DQuat::IDENTITY,
        DVec3::new(30.0, 1.0, 30.0),
        0,
    );
    solids.extend(rooms::cuboid(
        DVec3::new(0.5, 1.0, -2.0),
        DQuat::from_rotation_y(0.3),
        DVec3::new(0.4, 1.0, 0.4),
        1,
    ));
    let mut scene = scene_of(&solids);
    scene.sun = Some(Sun {
        direction: DVec3::new(0.6, 0.7, 0.2).normalize(),
        colour: Vec3::ONE,
    });
    scene
}

pub fn greatest_gap(one: &Light, other: &Light) -> f32 {
    let gaps = one.iter().flatten().zip(other.iter().flatten());
    gaps.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn a_stretch_of_one_is_no_box_pixel_for_pixel() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let plain = yard();
    let mut with = yard();
    with.aberrations = Space::new(vec![boxed(DVec3::ONE, Sides::Soft)]).unwrap();
    let (from, to) = (DVec3::new(-2.0, 2.5, 6.0), DVec3::new(0.0, 0.5, -2.0));
    let (light, seen) = shown(gpu, &plain, &looking(&plain, from, to));
    let (other, also) = shown(gpu, &with, &looking(&with, from, to));
    let apart = seen
        .iter()
        .zip(&also)
        .filter(|(a, b)| a.seen != b.seen || (a.length_m - b.length_m).abs() > 1e-3);
    assert_eq!(apart.count(), 0);
    let differ = light
        .iter()
        .zip(&other)
        .filter(|(a, b)| (0..3).any(|i| (a[i] - b[i]).abs() > 0.01));
    assert!(differ.count() <= 2, "pixels at the edge of a shadow");
    // And a stretch that is not 1 is seen.
    with.aberrations = Space::new(vec![boxed(DVec3::new(1.0, 2.0, 3.0), Sides::Soft)]).unwrap();
    assert!(greatest_gap(&light, &shown(gpu, &with, &looking(&with, from, to)).0) > 0.05);
}

#[test]
fn a_pixel_knows_what_it_shows_and_how_far_off_it_feels() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let solids = rooms::cuboid(
        DVec3::new(0.0, 0.0, -20.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 9.0, 1.0),
        7,
    );
    let mut scene = scene_of(&solids);
    let half = DVec3::new(1.0, 1.0, 5.0);
    let tunnel = Aberration::tunnel(DVec3::new(0.0, 0.0, -8.0), DQuat::IDENTITY, half, 2, 60.0);
    scene.aberrations = Space::new(vec![tunnel]).unwrap();
    let (_, seen) = shown(gpu, &scene, &looking(&scene, DVec3::ZERO, DVec3::NEG_Z));
    let pixel = middle(&seen);
    assert_eq!(pixel.seen, Seen::Object(7));
    // 3 m to the door, 60 m that are 10 m in the scene, and 6 m behind it.
    assert!((pixel.length_m - 69.0).abs() < 0.1, "{pixel:?}");
    assert!(seen.iter().any(|pixel| pixel.seen == Seen::Wall(0)));
    let away = looking(&scene, DVec3::ZERO, DVec3::Z);
    assert_eq!(middle(&shown(gpu, &scene, &away).1).seen, Seen::Nothing);
}

#[test]
fn a_lamp_behind_a_door_lights_what_is_before_it() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let mut scene = yard();
    scene.sun = None;
    scene.sky.ambient_sky = Vec3::ZERO;
    scene.sky.ambient_ground = Vec3::ZERO;
    let half = DVec3::new(2.0, 2.0, 3.0);
    let tunnel = Aberration::tunnel(DVec3::new(10.0, 2.05, -5.0), DQuat::IDENTITY, half, 2, 9.0);
    scene.aberrations = Space::new(vec![tunnel]).unwrap();
    let place = Place::at(&scene.aberrations, DVec3::new(10.0, 1.0, -4.0));
    scene.lamps = vec![Lamp {
        place,
        colour: Vec3::splat(50.0),
        reach_m: 30.0,
        radius_m: 0.1,
    }];
    let lit = |x: f64, z: f64| {
        let eye = looking(&scene, DVec3::new(x, 3.0, z + 0.01), DVec3::new(x, 0.0, z));
        middle(&shown(gpu, &scene, &eye).0)[0]
    };
    let (before, beside) = (lit(10.0, 0.0), lit(16.0, -4.0));
    // 2 m felt as 3 to the door and 2 m before it, 1 m down: about 5.1 m.
    assert!(before > 0.1, "{before}");
    assert!(beside < 1e-3, "its walls are opaque: {beside}");
}

#[test]
fn outlines_are_drawn_where_they_are_switched_on_and_nothing_hides_them() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let mut scene = yard();
    scene.aberrations = Space::new(vec![boxed(DVec3::ONE, Sides::Soft)]).unwrap();
    let eye = looking(
        &scene,
        DVec3::new(-6.0, 4.0, 8.0),
        DVec3::new(0.0, 0.5, -1.0),
    );
    let off = shown(gpu, &scene, &eye).0;
    scene.outlined = vec![true];
    let on = shown(gpu, &scene, &eye).0;
    let count = |a: &Light, b: &Light| {
        a.iter()
            .zip(b)
            .filter(|(a, b)| (a[0] - b[0]).abs() > 0.05)
            .count()
    };
    let drawn = count(&off, &on);
    assert!((20..700).contains(&drawn), "{drawn}");
    // A wall before the box hides them all.
    let wall = rooms::cuboid(
        DVec3::new(-4.0, 3.0, 6.0),
        DQuat::from_rotation_y(-0.6),
        DVec3::new(9.0, 9.0, 0.1),
        3,
    );
    let mut hidden = |outlined: bool| {
        scene.outlined = vec![outlined];
        let mut with = scene.clone();
        with.instances.push(standing(with.meshes.len(), 3, 0));
        with.meshes.push(Arc::new(mesh(&wall)));
        shown(gpu, &with, &eye).0
    };
    assert_eq!(count(&hidden(true), &hidden(false)), 0);
}

#[test]
fn fog_goes_by_felt_length() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let far = |felt: f64| {
        let mut scene = scene_of(&rooms::cuboid(
            DVec3::new(0.0, 0.0, -14.0),
            DQuat::IDENTITY,
            DVec3::new(9.0, 9.0, 1.0),
            0,
        ));
        scene.materials[0].colour = Vec3::ZERO;
        scene.fog_m = 50.0;
        let half = DVec3::new(5.0, 5.0, 5.0);
        scene.aberrations = Space::new(vec![Aberration::tunnel(
            DVec3::new(0.0, 0.0, -6.0),
            DQuat::IDENTITY,
            half,
            2,
            felt,
        )])
        .unwrap();
        middle(&shown(gpu, &scene, &looking(&scene, DVec3::ZERO, DVec3::NEG_Z)).0)[2]
    };
    assert!(far(10.0) < 0.3 * far(30.0), "{} {}", far(10.0), far(30.0));
    assert!(far(49.0) > 0.6);
}

#[test]
fn faulty_scenes_are_refused_in_words() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let rays = &gpu.rays;
    let refusal = |scene: &RayScene| {
        rays.upload(&gpu.device, &gpu.queue, scene)
            .unwrap_err()
            .to_string()
    };
    let mut scene = yard();
    scene.instances[1].mesh = 9;
    assert!(refusal(&scene).contains("Object 1"));
    let mut scene = yard();
    scene.instances[1].materials = 5;
    assert!(refusal(&scene).contains("a material that the room lacks"));
    let mut scene = yard();
    scene.instances[0].pose.matrix3.x_axis = Vec3::ZERO.into();
    assert!(refusal(&scene).contains("has no size"));
    let mut scene = yard();
    let mut broken = (*scene.meshes[0]).clone();
    broken.triangles[3] = [0, 1, 999];
    scene.meshes[0] = Arc::new(broken);
    assert!(refusal(&scene).contains("Triangle 3 of mesh 0"));
}
