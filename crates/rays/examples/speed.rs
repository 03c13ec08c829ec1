//! How long pictures take, as the ratios that the project holds itself to:
//! `cargo run --release -p antipode-rays --example speed`.
//!
//! Times are of the process's work on all cores (Linux) beside the time that passes, since a machine with other things to
//! do gives a share of its cores only. The thesis's way asks every triangle of a model whose box a ray meets.

mod support;

use std::sync::Arc;
use std::time::Instant;

use antipode_deformation::{Aberration, Place, Sides, Space, Ways};
use antipode_rays::{Eye, Lamp, Loaded, Material, Options, Picture, RayScene, Rays, Sun};
use glam::{DQuat, DVec3, Vec3};
use support::{Gpu, hills, placed};

type Fault = Box<dyn std::error::Error>;

fn main() -> Result<(), Fault> {
    let gpu = Gpu::open()?;
    println!("{}", gpu.name);
    let rays = Rays::new(&gpu.device)?;
    let size = std::env::args()
        .nth(1)
        .map_or(Ok((320, 180)), |side| side.parse().map(|n| (n, n)))?;
    let small = (size.0 / 4, size.1 / 4);
    let few = scene(71, false)?;
    let plain = time(
        &gpu,
        &rays,
        &few,
        &rays.upload(&gpu.device, &gpu.queue, &few)?,
        size,
        7,
    )?;
    println!("10,082 triangles: {}", told(plain, plain));
    let boxed = scene(71, true)?;
    let through = time(
        &gpu,
        &rays,
        &boxed,
        &rays.upload(&gpu.device, &gpu.queue, &boxed)?,
        size,
        7,
    )?;
    println!("the same through an aberration: {}", told(through, plain));
    let many = scene(707, false)?;
    let begun = Instant::now();
    let loaded = rays.upload(&gpu.device, &gpu.queue, &many)?;
    println!(
        "a million triangles are loaded in {:.1} s",
        begun.elapsed().as_secs_f64()
    );
    let million = time(&gpu, &rays, &many, &loaded, size, 5)?;
    println!("999,698 triangles: {}", told(million, plain));
    let sorted = time(
        &gpu,
        &rays,
        &few,
        &rays.upload(&gpu.device, &gpu.queue, &few)?,
        small,
        5,
    )?;
    let unsorted = rays.upload_unsorted(&gpu.device, &gpu.queue, &few)?;
    let thesis = time(&gpu, &rays, &few, &unsorted, small, 1)?;
    println!("10,082 triangles at {small:?}: {}", told(sorted, sorted));
    println!("the thesis's way, the same: {}", told(thesis, sorted));
    Ok(())
}

fn told((wall, work): (f64, f64), (_, one): (f64, f64)) -> String {
    format!(
        "{:.1} ms pass, {:.1} ms of work, {:.2} times",
        1e3 * wall,
        1e3 * work,
        work / one
    )
}

/// Hills that fill the picture, under a sun and two lamps, with or without a box that they stand in.
fn scene(side: u32, boxed: bool) -> Result<RayScene, Fault> {
    let mut scene = RayScene {
        meshes: vec![Arc::new(hills(side))],
        materials: vec![Material::default()],
        sun: Some(Sun {
            direction: DVec3::new(0.7, 0.6, 0.3).normalize(),
            colour: Vec3::splat(1.4),
        }),
        fog_m: 200.0,
        ..RayScene::default()
    };
    scene.instances.push(placed(0, Vec3::ZERO, Vec3::ONE, 0, 0));
    if boxed {
        scene.aberrations = Space::new(vec![Aberration {
            name: "box".to_owned(),
            centre: DVec3::new(0.0, 1.0, 0.0),
            turn: DQuat::IDENTITY,
            half: DVec3::new(14.0, 2.6, 9.0),
            stretch: DVec3::new(1.0, 1.0, 1.5),
            sides: Sides::Soft,
            ways: Ways::Both,
        }])?;
    }
    for (x, z) in [(-4.0, -2.0), (5.0, 3.0)] {
        let place = Place::at(&scene.aberrations, DVec3::new(x, 2.5, z));
        scene.lamps.push(Lamp {
            place,
            colour: Vec3::splat(5.0),
            reach_m: 30.0,
            radius_m: 0.1,
        });
    }
    Ok(scene)
}

/// The least time of some pictures: seconds that pass, and seconds of work.
fn time(
    gpu: &Gpu,
    rays: &Rays,
    scene: &RayScene,
    loaded: &Loaded,
    size: (u32, u32),
    rounds: u32,
) -> Result<(f64, f64), Fault> {
    let at = DVec3::new(0.0, 14.0, 10.0);
    let eye = Eye::looking(Place::at(&scene.aberrations, at), -at, DVec3::Y, 0.8);
    let picture = Picture::new(&gpu.device, size);
    let mut least = (f64::INFINITY, f64::INFINITY);
    for _ in 0..=rounds {
        let (begun, worked) = (Instant::now(), work_s());
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        rays.draw(
            (&gpu.device, &gpu.queue),
            &mut encoder,
            (scene, loaded),
            (&eye, &picture),
            Options::default(),
        );
        gpu.queue.submit([encoder.finish()]);
        gpu.device.poll(wgpu::PollType::wait_indefinitely())?;
        let took = (begun.elapsed().as_secs_f64(), work_s() - worked);
        least = (least.0.min(took.0), least.1.min(took.1));
    }
    let seen = picture.read_seen(&gpu.device, &gpu.queue)?;
    let hits = seen
        .iter()
        .filter(|pixel| pixel.seen != antipode_rays::Seen::Nothing)
        .count();
    if hits < seen.len() {
        println!("(only {hits} of {} pixels are hits)", seen.len());
    }
    Ok(least)
}

/// Seconds that all threads of this process have worked (Linux; elsewhere 0).
fn work_s() -> f64 {
    let schedules = std::fs::read_dir("/proc/self/task")
        .into_iter()
        .flatten()
        .flatten();
    let nanoseconds: u64 = schedules
        .filter_map(|task| std::fs::read_to_string(task.path().join("schedstat")).ok())
        .filter_map(|line| line.split(' ').next()?.parse::<u64>().ok())
        .sum();
    nanoseconds as f64 * 1e-9
}
