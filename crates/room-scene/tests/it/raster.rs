//! Pictures of the rooms of the game that a raster begins are those that rays make.

use std::convert::Infallible;

use antipode_rays::{Eye, Options, Picture, Pixel, RayScene, Rays, View};
use antipode_rooms::shipped;
use image::RgbaImage;

use crate::eyes::{bytes, of};
use crate::room;

const SIZE: (u32, u32) = (640, 360);
/// Eyes of each room.
const EYES: usize = 5;
/// Of these so many are compared without the sun and lamps as well.
const DARK_EYES: usize = 2;

struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    rays: Rays,
}

fn open() -> Result<Gpu, String> {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter =
        pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
            .map_err(|error| error.to_string())?;
    let (device, queue) =
        pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))
            .map_err(|error| error.to_string())?;
    let rays = Rays::new(&device).map_err(|error| error.to_string())?;
    Ok(Gpu {
        device,
        queue,
        rays,
    })
}

type Shown = (Vec<[u8; 3]>, Vec<Pixel>);

/// A scene by rays, and by a raster.
fn both(gpu: &Gpu, scene: &RayScene, eye: &Eye, view: View) -> [Shown; 2] {
    let loaded = gpu.rays.upload(&gpu.device, &gpu.queue, scene).unwrap();
    [false, true].map(|raster| {
        let options = Options {
            view,
            raster,
            ..Options::default()
        };
        let picture = Picture::new(&gpu.device, SIZE);
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let adapter = (&gpu.device, &gpu.queue);
        gpu.rays.draw(
            adapter,
            &mut encoder,
            (scene, &loaded),
            (eye, &picture),
            options,
        );
        gpu.queue.submit([encoder.finish()]);
        let light = picture.read_light(&gpu.device, &gpu.queue).unwrap();
        let seen = picture.read_seen(&gpu.device, &gpu.queue).unwrap();
        (light.into_iter().map(bytes).collect(), seen)
    })
}

/// Pixels whose colours differ by more than that many steps of 255, among those that show the same thing.
fn unlike([rays, raster]: &[Shown; 2], steps: u8) -> usize {
    let same = rays.1.iter().zip(&raster.1).map(|(a, b)| a.seen == b.seen);
    let colours = rays.0.iter().zip(&raster.0).zip(same);
    let differs =
        colours.filter(|((a, b), same)| *same && (0..3).any(|i| a[i].abs_diff(b[i]) > steps));
    differs.count()
}

/// Pixels that show another thing: elsewhere, and where two solids have a face in common, of which either may be named.
fn others([rays, raster]: &[Shown; 2]) -> (usize, usize) {
    let pairs = rays.1.iter().zip(&raster.1);
    let others = pairs.filter(|(a, b)| a.seen != b.seen);
    let is_as_far =
        |(a, b): &(&Pixel, &Pixel)| (a.length_m - b.length_m).abs() <= 1e-5 * a.length_m;
    let (common, elsewhere): (Vec<_>, Vec<_>) = others.partition(is_as_far);
    (elsewhere.len(), common.len())
}

/// What was compared, and the most that was off in one picture.
#[derive(Debug, Default)]
struct Report {
    rooms: usize,
    eyes: usize,
    /// Pixels that show another thing or see the same one elsewhere, and of all eyes together.
    most_others: usize,
    all_others: usize,
    /// Pixels of another colour with sun and lamps, by more than 12 of 255, and without, by more than 4.
    most_lit: usize,
    most_dark: usize,
}

impl Report {
    fn add(&mut self, others: usize, lit: usize) {
        self.eyes += 1;
        self.all_others += others;
        self.most_others = self.most_others.max(others);
        self.most_lit = self.most_lit.max(lit);
    }
}

fn compare(view: View) {
    let mut report = Report::default();
    let opened = open();
    let Some(gpu) = antipode_testing::needed("a graphics adapter", opened.as_ref()) else {
        return;
    };
    let pixels = (SIZE.0 * SIZE.1) as usize;
    for shipped in shipped::ROOMS {
        let open = room(shipped.id);
        let made: Result<_, Infallible> = open.ray_scene(|_| Ok(RgbaImage::new(4, 4)));
        let scene = made.unwrap();
        if view == View::Plain && !scene.aberrations.portals().is_empty() {
            // Drawn by rays alone.
            continue;
        }
        report.rooms += 1;
        for (number, eye) in of(&open).iter().enumerate().take(EYES) {
            let name = format!("{} {number}", shipped.id);
            let shown = both(gpu, &scene, eye, view);
            let pairs = shown[0].1.iter().zip(&shown[1].1);
            // At an edge one may see past it what is the same thing farther off.
            let far = pairs.filter(|(a, b)| {
                a.seen == b.seen && (a.length_m - b.length_m).abs() > 1e-3 * a.length_m
            });
            let far = far.count();
            let (others, common) = others(&shown);
            assert!(
                far + others <= pixels / 1000 && common <= pixels / 200,
                "{name}: {others} show another thing, {far} are elsewhere, {common} show the other one of two in one place"
            );
            let lit = unlike(&shown, 12);
            assert!(lit <= pixels / 50, "{name}: {lit} are lit in another way");
            report.add(far + others, lit);
            if number < DARK_EYES {
                let dark = RayScene {
                    sun: None,
                    lamps: Vec::new(),
                    ..scene.clone()
                };
                let off = unlike(&both(gpu, &dark, eye, view), 4);
                report.most_dark = report.most_dark.max(off);
                // Edges between parts of one thing, as those between things.
                assert!(off <= pixels / 1000, "{name}: {off} have another colour");
            }
        }
    }
    println!("{view:?}, of {pixels} pixels of a picture: {report:?}");
}

#[test]
fn in_coordinates_of_the_scene() {
    compare(View::Plain);
}

#[test]
fn as_light_goes() {
    compare(View::Exact);
}
