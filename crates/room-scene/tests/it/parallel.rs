//! Views along parallel lines: what is dragged stays under the pointer, and pictures show what is picked.

use std::convert::Infallible;

use antipode_rays::{Options, Picture, Rays, Seen};
use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::{Facing, FreeCamera, Viewpoint};
use fastrand::Rng;
use glam::DVec2;
use image::RgbaImage;

use crate::{eyes, room};

const SIZE: (u32, u32) = (160, 90);
const FACES: [Facing; 3] = [Facing::Top, Facing::Front, Facing::Side];

fn views(scene: &RoomScene) -> Vec<Viewpoint> {
    let eye = eyes::of(scene)[0];
    let views = FACES.map(|facing| {
        let mut camera = FreeCamera::of(&eye);
        camera.pivot_m = 14.0;
        camera.face(scene.space(), facing);
        camera.parallel = Some(scene.radius_m());
        scene.viewpoint(&camera, 16.0 / 9.0)
    });
    views.to_vec()
}

#[test]
fn a_metre_is_as_long_wherever_it_is_and_what_is_picked_is_seen_where_it_was() {
    let mut rng = Rng::with_seed(3);
    let mut picks = 0;
    for id in ["big-house", "two-portals", "long-house", "four-tunnels"] {
        let scene = room(id);
        for view in views(&scene) {
            let half = view.eye.parallel_m.unwrap();
            for _ in 0..60 {
                let at = DVec2::new(rng.f64() * 2.0 - 1.0, rng.f64() * 2.0 - 1.0);
                let Some(seen) = scene.seen(&view, at) else {
                    continue;
                };
                let through = scene.through(&view, seen.chain.clone());
                let again = through.seen_at(seen.place.point, at).unwrap();
                assert!(view.apart(again, at) * 360.0 < 1.0, "{id}: {again} {at}");
                picks += 1;
                if !seen.chain.is_empty() {
                    continue;
                }
                let beside = through.seen_at(seen.place.point + view.eye.up, at);
                let apart = view.apart(beside.unwrap(), at);
                assert!((apart - 1.0 / half).abs() < 1e-6, "{id}: {apart}");
            }
        }
    }
    assert!(picks > 300, "{picks}");
}

#[test]
fn pictures_show_what_is_picked() {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter =
        pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
    let adapter = adapter.map_err(|error| error.to_string());
    let Some(adapter) = antipode_testing::needed("a graphics adapter", adapter.as_ref()) else {
        return;
    };
    let (device, queue) =
        pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default())).unwrap();
    let rays = Rays::new(&device).unwrap();
    let open = room("big-house");
    let made: Result<_, Infallible> = open.ray_scene(|_| Ok(RgbaImage::new(4, 4)));
    let scene = made.unwrap();
    let loaded = rays.upload(&device, &queue, &scene).unwrap();
    for view in views(&open) {
        let picture = Picture::new(&device, SIZE);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let options = Options {
            raster: true,
            ..Options::default()
        };
        rays.draw(
            (&device, &queue),
            &mut encoder,
            (&scene, &loaded),
            (&view.eye, &picture),
            options,
        );
        queue.submit([encoder.finish()]);
        let shown = picture.read_seen(&device, &queue).unwrap();
        let mut others = 0;
        for (number, pixel) in shown.iter().enumerate() {
            let (x, y) = (number as u32 % SIZE.0, number as u32 / SIZE.0);
            let at = DVec2::new(
                2.0 * (f64::from(x) + 0.5) / f64::from(SIZE.0) - 1.0,
                1.0 - 2.0 * (f64::from(y) + 0.5) / f64::from(SIZE.1),
            );
            let picked = open.seen(&view, at).map(|it| it.object);
            let drawn = match pixel.seen {
                Seen::Object(object) => Some(object as usize),
                _ => None,
            };
            others += usize::from(picked != drawn);
        }
        // Edges, and things in one place.
        assert!(others < shown.len() / 50, "{:?}: {others}", view.eye.front);
    }
}
