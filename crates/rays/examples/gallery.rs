//! Pictures of deformed rooms, to be looked at:
//! `cargo run --release -p antipode-rays --example gallery -- FOLDER [NAME..]`. Without names all are drawn.

mod support;

use std::f64::consts::PI;
use std::sync::Arc;

use antipode_deformation::{Aberration, Exit, Place, Sides, Space, Ways};
use antipode_rays::{
    Eye, Lamp, Material, Options, Pattern, Picture, RayScene, Rays, Sun, TextureImage,
};
use glam::{DQuat, DVec3, Vec3};
use image::RgbaImage;
use support::{Gpu, ball, cube, placed};

type Fault = Box<dyn std::error::Error>;

const SIZE: (u32, u32) = (480, 270);
const CUBE: usize = 0;
const BALL: usize = 1;
const FLOOR: usize = 1;
const RED: usize = 2;
const BLUE: usize = 3;
const MIRROR: usize = 4;
const GLASS: usize = 5;
const BULB: usize = 6;
const PICTURE: usize = 7;

fn main() -> Result<(), Fault> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| ".".to_owned());
    let gpu = Gpu::open()?;
    let rays = Rays::new(&gpu.device)?;
    let whole = Options {
        bounces: 4,
        samples: 4,
        ..Options::default()
    };
    let names: Vec<_> = std::env::args().skip(2).collect();
    for (name, scene, eye) in pictures()? {
        if !names.is_empty() && !names.iter().any(|wanted| wanted == name) {
            continue;
        }
        let picture = gpu.draw(&rays, &scene, &eye, SIZE, whole)?;
        save(&gpu, &picture, &format!("{folder}/{name}.png"))?;
    }
    Ok(())
}

/// Saves a picture through the curve of the game's tone map (shaders/tonemap.wgsl).
fn save(gpu: &Gpu, picture: &Picture, path: &str) -> Result<(), Fault> {
    let curve = |light: f32| {
        let s = light.max(0.0).sqrt();
        let shown = s * (5.072_28 * s - 0.091_362_8) / (s * (5.101_752 * s - 0.506_305_8) + 1.0);
        (shown.clamp(0.0, 1.0) * 255.0).round() as u8
    };
    let bytes = picture.read_light(&gpu.device, &gpu.queue)?;
    let bytes = bytes
        .iter()
        .flat_map(|[r, g, b]| [curve(*r), curve(*g), curve(*b), 255])
        .collect();
    let image = RgbaImage::from_raw(picture.size.0, picture.size.1, bytes).ok_or("incomplete")?;
    Ok(image.save(path)?)
}

fn materials() -> Vec<Material> {
    let plain = |r: f32, g: f32, b: f32| Material {
        colour: Vec3::new(r, g, b),
        ..Material::default()
    };
    let checker = |light: Material, edge_m: f32| Material {
        pattern: Pattern::Checker {
            other: light.colour * 0.45,
            edge_m,
        },
        ..light
    };
    vec![
        checker(plain(0.75, 0.72, 0.66), 1.0),
        checker(plain(0.55, 0.6, 0.55), 1.0),
        plain(0.75, 0.12, 0.08),
        plain(0.1, 0.25, 0.75),
        Material {
            mirror: 0.92,
            ..plain(0.9, 0.9, 0.9)
        },
        Material {
            glass: Some(1.5),
            ..plain(0.95, 1.0, 0.97)
        },
        Material {
            glow: Vec3::new(9.0, 7.0, 4.0),
            ..plain(1.0, 0.9, 0.7)
        },
        Material {
            pattern: Pattern::Texture {
                number: 0,
                repeats: 1.0,
            },
            ..plain(1.0, 1.0, 1.0)
        },
    ]
}

/// A floor under a sun.
fn ground() -> RayScene {
    let stripes = RgbaImage::from_fn(256, 256, |x, y| {
        let ring = (((x as f32 - 128.0).hypot(y as f32 - 128.0)) / 16.0) as u32 % 2;
        image::Rgba([60 + 190 * ring as u8, 200 - (y / 2) as u8, 120, 255])
    });
    let mut scene = RayScene {
        meshes: vec![Arc::new(cube()), Arc::new(ball())],
        materials: materials(),
        textures: vec![Arc::new(TextureImage {
            image: stripes.into(),
        })],
        sun: Some(Sun {
            direction: DVec3::new(0.5, 0.8, 0.45).normalize(),
            colour: Vec3::new(1.5, 1.4, 1.2),
        }),
        fog_m: 250.0,
        ..RayScene::default()
    };
    scene.instances.push(placed(
        CUBE,
        Vec3::new(0.0, -0.5, 0.0),
        Vec3::new(60.0, 0.5, 60.0),
        0,
        FLOOR,
    ));
    scene
}

fn eye(space: &Space, at: DVec3, to: DVec3, fov: f64) -> Eye {
    Eye::looking(Place::at(space, at), to - at, DVec3::Y, fov)
}

fn boxed(centre: DVec3, half: DVec3, stretch: DVec3, sides: Sides) -> Aberration {
    Aberration {
        name: "box".to_owned(),
        centre,
        turn: DQuat::IDENTITY,
        half,
        stretch,
        sides,
        ways: Ways::Both,
    }
}

fn pictures() -> Result<Vec<(&'static str, RayScene, Eye)>, Fault> {
    let mut all = vec![
        tunnels(false)?,
        tunnels(true)?,
        nested()?,
        mirrors(),
        lamps()?,
    ];
    for (name, sides) in [
        ("legacy", Sides::Legacy(Exit::Original)),
        ("soft", Sides::Soft),
        ("snell", Sides::Snell),
    ] {
        all.push(room_of(name, sides)?);
    }
    Ok(all)
}

/// Three tunnels of one size outside: longer, as long, and shorter inside.
fn tunnels(inside: bool) -> Result<(&'static str, RayScene, Eye), Fault> {
    let mut scene = ground();
    let mut boxes = Vec::new();
    for (x, felt) in [(-6.0, 50.0), (0.0, 10.0), (6.0, 10.0 / 3.0)] {
        let half = DVec3::new(2.0, 2.0, 5.0);
        boxes.push(Aberration::tunnel(
            DVec3::new(x, 2.01, 0.0),
            DQuat::IDENTITY,
            half,
            2,
            felt,
        ));
        for (z, colour) in [(-3.0, RED), (0.0, BLUE), (3.0, RED)] {
            let at = Vec3::new(x as f32 + 0.9, 0.6, z);
            scene
                .instances
                .push(placed(BALL, at, Vec3::splat(0.5), 10, colour));
        }
        scene.instances.push(placed(
            CUBE,
            Vec3::new(x as f32, 1.5, -9.0),
            Vec3::new(1.0, 1.5, 0.2),
            11,
            PICTURE,
        ));
    }
    // The middle one feels as long as it is, and needs walls of its own.
    for (x, y, half) in [
        (-2.1, 2.0, Vec3::new(0.1, 2.0, 5.0)),
        (2.1, 2.0, Vec3::new(0.1, 2.0, 5.0)),
        (0.0, 4.1, Vec3::new(2.2, 0.1, 5.0)),
    ] {
        scene
            .instances
            .push(placed(CUBE, Vec3::new(x, y, 0.0), half, 12, 0));
    }
    scene.aberrations = Space::new(boxes)?;
    scene.outlined = vec![true; 3];
    let space = &scene.aberrations;
    let view = if inside {
        eye(
            space,
            DVec3::new(-6.0, 1.7, 4.5),
            DVec3::new(-6.0, 1.6, -5.0),
            1.2,
        )
    } else {
        eye(
            space,
            DVec3::new(0.0, 2.6, 17.0),
            DVec3::new(0.0, 1.6, 0.0),
            1.0,
        )
    };
    Ok((
        if inside { "tunnel_inside" } else { "tunnels" },
        scene,
        view,
    ))
}

/// A soft box in a soft box.
fn nested() -> Result<(&'static str, RayScene, Eye), Fault> {
    let mut scene = ground();
    let outer = boxed(
        DVec3::new(0.0, 3.0, 0.0),
        DVec3::new(6.0, 3.0, 6.0),
        DVec3::new(2.0, 1.0, 2.0),
        Sides::Soft,
    );
    let mut inner = boxed(
        DVec3::new(1.0, 2.0, -1.0),
        DVec3::new(2.0, 1.5, 2.0),
        DVec3::new(1.0, 3.0, 1.0),
        Sides::Soft,
    );
    inner.turn = DQuat::from_rotation_y(0.5);
    for k in 0..7 {
        let angle = f64::from(k) * 2.0 * PI / 7.0;
        let at = Vec3::new(4.0 * angle.cos() as f32, 0.8, 4.0 * angle.sin() as f32);
        scene.instances.push(placed(
            CUBE,
            at,
            Vec3::new(0.4, 0.8, 0.4),
            20,
            RED + (k % 2) as usize,
        ));
    }
    scene.instances.push(placed(
        BALL,
        Vec3::new(1.0, 1.5, -1.0),
        Vec3::splat(0.9),
        21,
        PICTURE,
    ));
    scene.aberrations = Space::new(vec![outer, inner])?;
    scene.outlined = vec![true; 2];
    let view = eye(
        &scene.aberrations,
        DVec3::new(-7.0, 4.5, 13.0),
        DVec3::new(0.0, 1.6, 0.0),
        1.0,
    );
    Ok(("nested", scene, view))
}

fn mirrors() -> (&'static str, RayScene, Eye) {
    let mut scene = ground();
    for x in [-5.0, 5.0] {
        scene.instances.push(placed(
            CUBE,
            Vec3::new(x, 2.5, -2.0),
            Vec3::new(0.1, 2.5, 6.0),
            30,
            MIRROR,
        ));
    }
    scene.instances.push(placed(
        BALL,
        Vec3::new(-1.8, 1.2, -2.0),
        Vec3::splat(1.2),
        31,
        MIRROR,
    ));
    scene.instances.push(placed(
        BALL,
        Vec3::new(1.6, 1.2, -0.5),
        Vec3::splat(1.2),
        32,
        GLASS,
    ));
    for (x, z, colour) in [(0.0, -6.0, RED), (2.5, -5.0, BLUE), (-3.0, 1.5, RED)] {
        scene.instances.push(placed(
            CUBE,
            Vec3::new(x, 0.7, z),
            Vec3::splat(0.7),
            33,
            colour,
        ));
    }
    let view = eye(
        &scene.aberrations,
        DVec3::new(0.6, 2.4, 7.0),
        DVec3::new(0.0, 1.2, -2.0),
        1.0,
    );
    ("mirrors", scene, view)
}

/// Night, and a lamp in a box that shines out of its door.
fn lamps() -> Result<(&'static str, RayScene, Eye), Fault> {
    let mut scene = ground();
    scene.sun = None;
    scene.sky.top = Vec3::new(0.01, 0.012, 0.03);
    scene.sky.horizon = Vec3::new(0.03, 0.03, 0.05);
    scene.sky.ground = Vec3::splat(0.01);
    scene.sky.ambient_sky = Vec3::splat(0.02);
    scene.sky.ambient_ground = Vec3::splat(0.015);
    let tunnel = Aberration::tunnel(
        DVec3::new(-3.0, 2.01, -2.0),
        DQuat::IDENTITY,
        DVec3::new(2.0, 2.0, 4.0),
        2,
        24.0,
    );
    scene.aberrations = Space::new(vec![tunnel])?;
    for (at, colour) in [
        (DVec3::new(-3.0, 2.5, 0.5), Vec3::new(14.0, 9.0, 5.0)),
        (DVec3::new(4.0, 2.0, -1.0), Vec3::new(4.0, 7.0, 14.0)),
    ] {
        let place = Place::at(&scene.aberrations, at);
        scene.lamps.push(Lamp {
            place,
            colour,
            reach_m: 40.0,
            radius_m: 0.25,
        });
        scene
            .instances
            .push(placed(BALL, at.as_vec3(), Vec3::splat(0.15), 40, BULB));
    }
    for (x, z) in [(-4.0, 4.5), (-2.0, 5.5), (1.5, 0.5), (6.0, 1.5)] {
        scene.instances.push(placed(
            CUBE,
            Vec3::new(x, 0.8, z),
            Vec3::new(0.3, 0.8, 0.3),
            41,
            RED,
        ));
    }
    let view = eye(
        &scene.aberrations,
        DVec3::new(0.0, 4.5, 13.0),
        DVec3::new(0.0, 1.0, 0.0),
        1.0,
    );
    Ok(("lamps", scene, view))
}

/// The same room by one rule or another.
fn room_of(name: &'static str, sides: Sides) -> Result<(&'static str, RayScene, Eye), Fault> {
    let mut scene = ground();
    let one = boxed(
        DVec3::new(0.0, 2.5, 0.0),
        DVec3::new(4.0, 2.5, 4.0),
        DVec3::new(0.5, 1.0, 1.0),
        sides,
    );
    for k in -3..=3 {
        scene.instances.push(placed(
            CUBE,
            Vec3::new(k as f32, 1.0, -2.0),
            Vec3::new(0.15, 1.0, 0.15),
            50,
            RED,
        ));
        scene.instances.push(placed(
            CUBE,
            Vec3::new(2.0 * k as f32, 1.0, -9.0),
            Vec3::new(0.3, 1.0, 0.3),
            51,
            BLUE,
        ));
    }
    scene.aberrations = Space::new(vec![one])?;
    scene.outlined = vec![true];
    let view = eye(
        &scene.aberrations,
        DVec3::new(2.0, 2.2, 11.0),
        DVec3::new(0.5, 1.5, 0.0),
        1.0,
    );
    Ok((name, scene, view))
}
