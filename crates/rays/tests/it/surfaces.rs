//! What surfaces look like.

use std::sync::Arc;

use antipode_rays::{Material, Options, Pattern, RayScene, TextureImage};
use antipode_testing::rooms;
use glam::{DQuat, DVec3, Vec2, Vec3};

use crate::common::{Gpu, draw, looking, mesh, middle, scene_of, shown};

#[test]
fn mirrors_show_what_stands_before_them() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let mut solids = rooms::cuboid(
        DVec3::new(0.0, 0.0, -5.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 9.0, 0.1),
        0,
    );
    solids.extend(rooms::cuboid(
        DVec3::new(0.0, 0.0, 6.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 9.0, 0.1),
        1,
    ));
    let mut scene = scene_of(&solids);
    scene.materials = vec![
        Material {
            colour: Vec3::ONE,
            mirror: 1.0,
            ..Material::default()
        },
        Material {
            colour: Vec3::ZERO,
            glow: Vec3::new(0.9, 0.0, 0.0),
            ..Material::default()
        },
    ];
    scene.instances[1].materials = 1;
    let eye = looking(&scene, DVec3::ZERO, DVec3::NEG_Z);
    let with = |bounces| {
        middle(
            &draw(
                gpu,
                &scene,
                &eye,
                Options {
                    bounces,
                    ..Options::default()
                },
            )
            .0,
        )
    };
    let [red, green, _] = with(1);
    assert!(red > 0.8 && green < 0.05, "{red} {green}");
    let [_, green, blue] = with(0);
    assert!(green > 0.1 && blue > 0.1, "the sky");
}

#[test]
fn panes_are_looked_through() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let mut solids = rooms::cuboid(
        DVec3::new(0.0, 0.0, -5.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 9.0, 0.5),
        0,
    );
    solids.extend(rooms::cuboid(
        DVec3::new(0.0, 0.0, -9.0),
        DQuat::IDENTITY,
        DVec3::new(9.0, 9.0, 0.1),
        1,
    ));
    let mut scene = scene_of(&solids);
    scene.materials = vec![
        Material {
            colour: Vec3::ONE,
            glass: Some(1.5),
            ..Material::default()
        },
        Material {
            colour: Vec3::ZERO,
            glow: Vec3::new(0.9, 0.0, 0.0),
            ..Material::default()
        },
    ];
    scene.instances[1].materials = 1;
    let eye = looking(&scene, DVec3::ZERO, DVec3::NEG_Z);
    let [red, green, _] = middle(
        &draw(
            gpu,
            &scene,
            &eye,
            Options {
                bounces: 4,
                ..Options::default()
            },
        )
        .0,
    );
    assert!(red > 0.8 && green < 0.05, "{red} {green}");
}

#[test]
fn textures_and_checkers_lie_on_surfaces() {
    let Some(shared) = Gpu::shared() else {
        return;
    };
    // Nobody else's pictures come between.
    let gpu = &shared.anew();
    let mut scene = scene_of(&rooms::cuboid(
        DVec3::new(0.0, 0.0, -5.0),
        DQuat::IDENTITY,
        DVec3::new(4.0, 4.0, 0.1),
        0,
    ));
    let mut flat = mesh(&rooms::cuboid(
        DVec3::new(0.0, 0.0, -5.0),
        DQuat::IDENTITY,
        DVec3::new(4.0, 4.0, 0.1),
        0,
    ));
    flat.uvs = flat
        .positions
        .iter()
        .map(|p| Vec2::new(0.125 * (p.x + 4.0), 0.125 * (p.y + 4.0)))
        .collect();
    scene.meshes[0] = Arc::new(flat);
    let halves = image::RgbaImage::from_fn(64, 64, |x, _| {
        image::Rgba([255 * u8::from(x >= 32), 255 * u8::from(x < 32), 0, 255])
    });
    let texture = |image: image::RgbaImage| {
        Arc::new(TextureImage {
            image: image.into(),
        })
    };
    scene.textures = vec![texture(halves)];
    let side = |scene: &RayScene, x: f64| {
        middle(
            &shown(
                gpu,
                scene,
                &looking(scene, DVec3::new(x, 0.3, 0.0), DVec3::new(x, 0.3, -5.0)),
            )
            .0,
        )
    };
    scene.materials[0].pattern = Pattern::Texture {
        number: 0,
        repeats: 1.0,
    };
    let (left, right) = (side(&scene, -2.0), side(&scene, 2.0));
    assert!(
        left[1] > 4.0 * left[0] && right[0] > 4.0 * right[1],
        "{left:?} {right:?}"
    );
    // A picture more before it, as when one hangs up a sign: it lies on another layer and is the same.
    let blue = image::RgbaImage::from_pixel(8, 8, image::Rgba([0, 0, 255, 255]));
    scene.textures.insert(0, texture(blue));
    let blue = side(&scene, 2.0);
    assert!(blue[2] > 4.0 * blue[0].max(blue[1]), "{blue:?}");
    scene.materials[0].pattern = Pattern::Texture {
        number: 1,
        repeats: 1.0,
    };
    assert_eq!((side(&scene, -2.0), side(&scene, 2.0)), (left, right));
    scene.materials[0].pattern = Pattern::Checker {
        other: Vec3::splat(0.05),
        edge_m: 1.0,
    };
    let (one, next) = (side(&scene, 0.5), side(&scene, 1.5));
    assert!(
        (one[1] / next[1]).max(next[1] / one[1]) > 4.0,
        "{one:?} {next:?}"
    );
}
