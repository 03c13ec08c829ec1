//! What moves: it is where it was put, looks and throws shadows as what stays, and costs nothing while it rests.

use std::sync::Arc;

use antipode_deformation::{End, Place, Sides, Space, Traveller, Triangle, Triangles, What, trace};
use antipode_rays::{
    Loaded, Material, Mover, Options, Outcome, ProbeRay, Prober, RayScene, Seen, Sun,
};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{Affine3A, DQuat, DVec3, Mat3A, Quat, Vec3};

use crate::common::{Gpu, draw_with, looking, mesh, middle, scene_of, shown};
use crate::pictures::{boxed, yard};

fn mover(mesh: usize, pose: Affine3A, object: u32) -> Mover {
    Mover {
        mesh,
        pose,
        object,
        materials: 0,
        unseen_by_eye: false,
        held: false,
        cut: None,
    }
}

fn block(half: DVec3) -> Vec<Triangle> {
    rooms::cuboid(DVec3::ZERO, DQuat::IDENTITY, half, 0)
}

fn loaded(gpu: &Gpu, scene: &RayScene) -> Loaded {
    gpu.rays.upload(&gpu.device, &gpu.queue, scene).unwrap()
}

/// Triangles of a list elsewhere, as an object.
fn carried(triangles: &[Triangle], pose: &Affine3A, object: u32) -> Vec<Triangle> {
    let place = |corner: DVec3| pose.transform_point3(corner.as_vec3()).as_dvec3();
    let carry = |triangle: &Triangle| Triangle {
        corners: triangle.corners.map(place),
        object,
    };
    triangles.iter().map(carry).collect()
}

/// A pose that turns and squeezes.
fn some_pose(rng: &mut Rng) -> Affine3A {
    let squeeze = Mat3A::from_diagonal(Vec3::new(1.0, 0.5 + rng.f32(), 2.0 * rng.f32() + 0.1));
    Affine3A {
        matrix3: Mat3A::from_quat(Quat::from_rotation_y(7.0 * rng.f32())) * squeeze,
        translation: rooms::point(rng).as_vec3a(),
    }
}

fn some_ray(space: &Space, rng: &mut Rng) -> ProbeRay {
    ProbeRay {
        start: Place::at(space, rooms::point(rng).as_vec3().as_dvec3()),
        w: rooms::direction(rng),
        longest: 60.0,
    }
}

#[test]
fn rays_meet_movers_where_the_reference_has_them() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut rng = Rng::with_seed(77);
    let space = Space::new(rooms::aberrations(&mut rng, 4, 3.0, |_| Sides::Soft)).unwrap();
    let mut resting = rooms::solids(&mut rng, 12);
    for triangle in &mut resting {
        triangle.corners = triangle.corners.map(|corner| corner.as_vec3().as_dvec3());
    }
    let shapes = [
        block(DVec3::new(0.5, 1.0, 0.25)),
        block(DVec3::new(1.0, 0.125, 0.5)),
    ];
    let mut scene = scene_of(&resting);
    scene.aberrations = space.clone();
    scene.movables = shapes.iter().map(|shape| Arc::new(mesh(shape))).collect();
    let mut loaded = loaded(gpu, &scene);
    let prober = Prober::new(&gpu.device).unwrap();
    // One mesh has another shape from the second round on.
    let (mut shapes, mut hits, mut others) = (shapes, 0, 0);
    for round in 0..3 {
        if round == 1 {
            for triangle in &mut shapes[1] {
                triangle.corners = triangle
                    .corners
                    .map(|it| it + DVec3::new(0.0, it.x * it.x, 0.5));
            }
            let places = mesh(&shapes[1]).positions;
            loaded.pose(&gpu.queue, 1, &places, &[]).unwrap();
        }
        let mut all = resting.clone();
        let movers: Vec<_> = (0..30_u32)
            .map(|number| {
                let pose = some_pose(&mut rng);
                let shape = (number % 2) as usize;
                all.extend(carried(&shapes[shape], &pose, 1000 + number));
                mover(shape, pose, 1000 + number)
            })
            .collect();
        loaded.show(&gpu.queue, &movers).unwrap();
        let solids = Triangles::new(all);
        let rays: Vec<_> = (0..4000).map(|_| some_ray(&space, &mut rng)).collect();
        let answers = prober
            .trace(&gpu.device, &gpu.queue, &loaded, &rays)
            .unwrap();
        for (ray, answer) in rays.iter().zip(&answers) {
            let path = trace(&space, &ray.start, ray.w, 60.0, &solids, &Traveller::Body);
            let End::Hit(hit) = path.end else { continue };
            let What::Object(object, _) = hit.what else {
                continue;
            };
            hits += u32::from(object >= 1000);
            let same = matches!(answer.outcome, Outcome::Object(it, _) if it == object);
            let near = (f64::from(answer.length) - path.length).abs() < 1e-3 * path.length.max(1.0);
            others += u32::from(!(same && near));
        }
    }
    assert!(hits > 500, "{hits} of movers");
    assert!(others <= 2, "{others} ended elsewhere");
}

#[test]
fn shadows_fall_and_movers_move() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = yard();
    let pillar = scene.instances.remove(1);
    scene.movables = vec![scene.meshes[1].clone()];
    // Where the pillar's shadow falls on the floor.
    let eye = looking(
        &scene,
        DVec3::new(-0.6, 3.0, -2.3),
        DVec3::new(-0.6, 0.0, -2.35),
    );
    let mut loaded = loaded(gpu, &scene);
    let mut brightness = |movers: &[Mover]| {
        let drawn = draw_with(gpu, (&scene, &mut loaded), movers, &eye, Options::default());
        middle(&drawn.0)[1]
    };
    let there = mover(0, pillar.pose, 1);
    let away = mover(0, Affine3A::from_translation(Vec3::new(8.0, 0.0, 0.0)), 1);
    let in_shadow = brightness(&[there]);
    let in_sun = brightness(&[away]);
    assert!(in_sun > 2.0 * in_shadow, "{in_sun} {in_shadow}");
    assert!((brightness(&[there]) - in_shadow).abs() < 1e-6);
    assert!(brightness(&[]) > 2.0 * in_shadow);
}

#[test]
fn what_moves_looks_as_what_stays() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut resting = yard();
    resting.aberrations = Space::new(vec![boxed(DVec3::new(1.0, 2.0, 3.0), Sides::Soft)]).unwrap();
    resting.materials[0].pattern = antipode_rays::Pattern::Checker {
        other: Vec3::splat(0.1),
        edge_m: 0.3,
    };
    let turned = Affine3A::from_scale_rotation_translation(
        Vec3::new(1.0, 1.5, 0.7),
        Quat::from_rotation_y(0.7),
        Vec3::new(0.2, 0.3, 0.1),
    );
    resting.instances[1].pose = turned;
    let mut moving = resting.clone();
    moving.movables = vec![moving.meshes[1].clone()];
    moving.instances.truncate(1);
    let eye = looking(
        &resting,
        DVec3::new(-2.0, 2.5, 6.0),
        DVec3::new(0.0, 0.5, -2.0),
    );
    let (light, seen) = shown(gpu, &resting, &eye);
    let mut on_adapter = loaded(gpu, &moving);
    let movers = [mover(0, turned, 1)];
    let (other, also) = draw_with(
        gpu,
        (&moving, &mut on_adapter),
        &movers,
        &eye,
        Options::default(),
    );
    assert!(seen.iter().filter(|it| it.seen == Seen::Object(1)).count() > 30);
    let apart = seen.iter().zip(&also);
    let apart = apart.filter(|(a, b)| a.seen != b.seen || (a.length_m - b.length_m).abs() > 1e-3);
    assert!(apart.count() <= 1);
    let differ = light.iter().zip(&other);
    let differ = differ.filter(|(a, b)| (0..3).any(|i| (a[i] - b[i]).abs() > 0.02));
    assert!(
        differ.count() <= 4,
        "pixels at the edges of squares and shadows"
    );
}

#[test]
fn who_looks_sees_themselves_in_mirrors_only() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = scene_of(&rooms::cuboid(
        DVec3::new(0.0, 0.0, -5.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 9.0, 0.1),
        0,
    ));
    let red = Material {
        colour: Vec3::ZERO,
        glow: Vec3::new(0.9, 0.0, 0.0),
        ..Material::default()
    };
    scene.materials[0].mirror = 1.0;
    scene.materials[0].colour = Vec3::ONE;
    scene.materials.push(red);
    scene.movables = vec![Arc::new(mesh(&block(DVec3::splat(0.5))))];
    let eye = looking(&scene, DVec3::ZERO, DVec3::NEG_Z);
    let mut on_adapter = loaded(gpu, &scene);
    let mut seen = |unseen_by_eye: bool| {
        let who = Mover {
            unseen_by_eye,
            materials: 1,
            ..mover(0, Affine3A::IDENTITY, 9)
        };
        let options = Options {
            bounces: 1,
            ..Options::default()
        };
        let drawn = draw_with(gpu, (&scene, &mut on_adapter), &[who], &eye, options);
        (middle(&drawn.0), middle(&drawn.1).seen)
    };
    let (light, what) = seen(true);
    assert_eq!(what, Seen::Object(0), "the mirror");
    assert!(
        light[0] > 0.8 && light[1] < 0.05,
        "in it oneself: {light:?}"
    );
    assert_eq!(seen(false).1, Seen::Object(9));
}

/// A block is held before the eye of somebody who is a larger block.
#[test]
fn what_is_held_is_seen_by_the_eye_alone_and_lit_as_if_nobody_stood_there() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = scene_of(&rooms::cuboid(
        DVec3::new(0.0, -1.0, 0.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 0.1, 9.0),
        0,
    ));
    scene.sun = Some(Sun {
        direction: DVec3::Y,
        colour: Vec3::ONE,
    });
    scene.sky.ambient_sky = Vec3::ZERO;
    scene.sky.ambient_ground = Vec3::ZERO;
    scene.movables = vec![Arc::new(mesh(&block(DVec3::splat(0.5))))];
    let mut on_adapter = loaded(gpu, &scene);
    let who = Mover {
        unseen_by_eye: true,
        ..mover(0, Affine3A::IDENTITY, 8)
    };
    let small = Affine3A::from_scale_rotation_translation(
        Vec3::splat(0.1),
        Quat::IDENTITY,
        Vec3::new(0.0, -0.1, -0.2),
    );
    let held = |held: bool| Mover {
        held,
        cut: None,
        ..mover(0, small, 9)
    };
    let mut seen = |movers: &[Mover], eye: DVec3, at: DVec3| {
        let eye = looking(&scene, eye, at);
        let both = (&scene, &mut on_adapter);
        let drawn = draw_with(gpu, both, movers, &eye, Options::default());
        (middle(&drawn.0)[1], middle(&drawn.1).seen)
    };
    let block_m = DVec3::new(0.0, -0.05, -0.2);
    let (light, what) = seen(&[who, held(true)], DVec3::ZERO, block_m);
    assert_eq!(what, Seen::Object(9));
    assert!(light > 0.3, "its upper face is in the sun: {light}");
    let (light, _) = seen(&[who, held(false)], DVec3::ZERO, block_m);
    assert!(
        light < 0.01,
        "another is in the shadow of who looks: {light}"
    );
    let (below, aside) = (DVec3::new(0.0, -0.9, -0.2), DVec3::new(0.5, -0.5, -0.2));
    let (shaded, _) = seen(&[held(false)], aside, below);
    let (lit, what) = seen(&[held(true)], aside, below);
    assert_eq!(what, Seen::Object(0));
    assert!(
        shaded < 0.01 && lit > 0.3,
        "no shadow of it: {shaded} {lit}"
    );
}

#[test]
fn faulty_movers_are_refused_in_words() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = yard();
    scene.movables = vec![scene.meshes[1].clone()];
    let mut loaded = loaded(gpu, &scene);
    let mut refusal = |movers: &[Mover]| loaded.show(&gpu.queue, movers).unwrap_err().to_string();
    let one = mover(0, Affine3A::IDENTITY, 5);
    assert!(refusal(&[Mover { mesh: 1, ..one }]).contains("Object 5 is of a mesh"));
    assert!(
        refusal(&[Mover {
            materials: 7,
            ..one
        }])
        .contains("a material that the room lacks")
    );
    let flat = Affine3A::from_scale(Vec3::new(1.0, 0.0, 1.0));
    assert!(refusal(&[Mover { pose: flat, ..one }]).contains("has no size"));
    assert!(refusal(&vec![one; 600]).contains("600 things that move"));
    let posed = |loaded: &mut Loaded, number, places: &[Vec3]| {
        let posed = loaded.pose(&gpu.queue, number, places, &[]);
        posed.unwrap_err().to_string()
    };
    assert!(posed(&mut loaded, 3, &[]).contains("no mesh 3"));
    assert!(posed(&mut loaded, 0, &[Vec3::ZERO]).contains("places"));
    let nowhere = vec![Vec3::NAN; scene.meshes[1].positions.len()];
    assert!(posed(&mut loaded, 0, &nowhere).contains("no number"));
}
