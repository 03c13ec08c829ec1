//! Rays beside a raster over the rooms of the game: how long pictures take, how many pixels differ, and both as pictures:
//! `cargo run --release -p antipode-room-scene --example raster [DIRECTORY [ROOM]]`.
//!
//! Times are of the process's work on all cores (Linux), the least of some pictures, since a machine with other things to do
//! gives a share of its cores only. In the pictures rays are above, the raster below, and at the bottom white where another thing is seen;
//! what stands on signs is left out.

#[path = "../tests/it/eyes.rs"]
mod eyes;

use std::convert::Infallible;
use std::path::Path;
use std::time::Instant;

use antipode_rays::{Eye, Loaded, Options, Picture, Pixel, RayScene, Rays, View};
use antipode_room_scene::RoomScene;
use antipode_rooms::shipped;
use image::{Rgb, RgbImage, RgbaImage};

type Fault = Box<dyn std::error::Error>;

/// Pixels.
const SIZE: (u32, u32) = (640, 360);
/// Pictures of which the fastest counts.
const ROUNDS: u32 = 3;

/// What draws.
struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    rays: Rays,
}

/// A picture and what it took.
struct Made {
    light: Vec<[f32; 3]>,
    seen: Vec<Pixel>,
    work_s: f64,
    wall_s: f64,
}

fn main() -> Result<(), Fault> {
    let gpu = open()?;
    let directory = std::env::args().nth(1);
    let only = std::env::args().nth(2);
    for (view, word) in [(View::Plain, "plain"), (View::Exact, "exact")] {
        let wanted = |id: &str| only.as_ref().is_none_or(|only| only == id);
        for room in shipped::ROOMS.iter().filter(|room| wanted(room.id)) {
            let open = RoomScene::open(room.loaded()?);
            let made: Result<_, Infallible> = open.ray_scene(|_| Ok(RgbaImage::new(4, 4)));
            let scene = made?;
            if view == View::Plain && !scene.aberrations.portals().is_empty() {
                // Drawn by rays alone.
                continue;
            }
            let loaded = gpu.rays.upload(&gpu.device, &gpu.queue, &scene)?;
            let begun = Instant::now();
            gpu.rays.prepare(&gpu.device, &loaded)?;
            println!(
                "{} is made ready in {:.1} s",
                room.id,
                begun.elapsed().as_secs_f64()
            );
            for (number, eye) in eyes::of(&open).iter().enumerate() {
                let by = |raster| gpu.draw((&scene, &loaded), eye, view, raster);
                let (rays, raster) = (by(false)?, by(true)?);
                println!("{word} {:<14} {number}: {}", room.id, told(&rays, &raster));
                if let Some(directory) = &directory {
                    let path = format!("{word}-{}-{number}.png", room.id);
                    save(&Path::new(directory).join(path), [&rays, &raster])?;
                }
            }
        }
    }
    Ok(())
}

fn told(rays: &Made, raster: &Made) -> String {
    let pairs = || rays.seen.iter().zip(&raster.seen);
    let others = pairs().filter(|(a, b)| a.seen != b.seen).count();
    let far = pairs()
        .filter(|(a, b)| a.seen == b.seen && (a.length_m - b.length_m).abs() > 1e-3 * a.length_m);
    format!(
        "rays {:6.1} ms of work ({:6.1} pass), raster {:6.1} ({:6.1}), {:.2} times; {others} pixels show another thing, {} are elsewhere",
        1e3 * rays.work_s,
        1e3 * rays.wall_s,
        1e3 * raster.work_s,
        1e3 * raster.wall_s,
        raster.work_s / rays.work_s,
        far.count(),
    )
}

impl Gpu {
    fn draw(
        &self,
        (scene, loaded): (&RayScene, &Loaded),
        eye: &Eye,
        view: View,
        raster: bool,
    ) -> Result<Made, Fault> {
        let options = Options {
            view,
            raster,
            ..Options::default()
        };
        let picture = Picture::new(&self.device, SIZE);
        let (mut work_s, mut wall_s) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..=ROUNDS {
            let (begun, worked) = (Instant::now(), worked_s());
            let mut encoder = self
                .device
                .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let gpu = (&self.device, &self.queue);
            let what = (scene, loaded);
            self.rays
                .draw(gpu, &mut encoder, what, (eye, &picture), options);
            self.queue.submit([encoder.finish()]);
            self.device.poll(wgpu::PollType::wait_indefinitely())?;
            work_s = work_s.min(worked_s() - worked);
            wall_s = wall_s.min(begun.elapsed().as_secs_f64());
        }
        Ok(Made {
            light: picture.read_light(&self.device, &self.queue)?,
            seen: picture.read_seen(&self.device, &self.queue)?,
            work_s,
            wall_s,
        })
    }
}

fn open() -> Result<Gpu, Fault> {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter =
        pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    println!("{}", adapter.get_info().name);
    let (device, queue) =
        pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
    let rays = Rays::new(&device)?;
    Ok(Gpu {
        device,
        queue,
        rays,
    })
}

/// Seconds that all threads of this process have worked (Linux; elsewhere 0).
fn worked_s() -> f64 {
    antipode_timing::program_ran().map_or(0.0, |ran| ran.as_secs_f64())
}

fn save(path: &Path, pictures: [&Made; 2]) -> Result<(), Fault> {
    let mut image = RgbImage::new(SIZE.0, 3 * SIZE.1);
    for (top, made) in pictures.into_iter().enumerate() {
        for (at, light) in made.light.iter().enumerate() {
            let (x, y) = (at as u32 % SIZE.0, at as u32 / SIZE.0);
            image.put_pixel(x, y + top as u32 * SIZE.1, Rgb(eyes::bytes(*light)));
        }
    }
    for at in 0..pictures[0].seen.len() {
        let differs = pictures[0].seen[at].seen != pictures[1].seen[at].seen;
        let (x, y) = (at as u32 % SIZE.0, at as u32 / SIZE.0);
        image.put_pixel(x, y + 2 * SIZE.1, Rgb([if differs { 255 } else { 0 }; 3]));
    }
    Ok(image.save(path)?)
}
