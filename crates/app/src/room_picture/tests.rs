//! How long it takes until an edit is seen.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests")]

use std::time::Instant;

use antipode_rays::{Outlines, View};
use antipode_render::AdapterChoice;
use antipode_room_scene::workshop::FreeCamera;
use antipode_rooms::Assets;

use super::*;

fn told(what: &str, since: &mut Instant) {
    println!("  {what}: {:.1} ms", since.elapsed().as_secs_f64() * 1e3);
    *since = Instant::now();
}

fn view_of(scene: &RoomScene) -> RoomView {
    RoomView {
        id: (0, scene.revision()),
        moment: scene.still(&scene.viewpoint(&FreeCamera::of(&scene.eye()), 1.6).eye),
        options: antipode_rays::Options {
            outlines: Outlines::All,
            raster: true,
            view: View::Exact,
            ..Default::default()
        },
        tile: None,
    }
}

#[test]
#[ignore = "prints"]
fn the_first_of_each_kind() {
    let gpu = Gpu::headless(AdapterChoice::Auto).unwrap();
    let options = Options {
        samples: 1,
        scale: 1.0,
        output_format: wgpu::TextureFormat::Rgba8Unorm,
        shadows: Default::default(),
        preset: antipode_render::Preset::Software,
    };
    let mut since = Instant::now();
    let painter = RoomPainter::new(&gpu, &options).unwrap();
    told("painter", &mut since);
    let room = antipode_rooms::read("room.ron", br#"(version: 1, name: "x", objects: [(name: "floor", at: (0, -0.1, 0), what: Box(size: (40, 0.2, 40)))])"#).unwrap();
    let mut scene = RoomScene::of(antipode_workshop::Document::new(room), Assets::default());
    let edits = [
        "",
        "add box name=b at=0,1,-4 size=1,1,1",
        "add sign name=s at=3,1,-4 size=1,1 text=hello",
        "add aberration name=t at=0,1,-6 half=1,1,2 axis=z felt=20 sides=walls",
        "add aberration name=u at=4,1,-6 half=1,1,2 axis=z felt=20 sides=soft",
        "add aberration name=v at=-4,1,-6 half=1,1,2 axis=z felt=20 sides=snell",
        "add portal name=p at=0,1,-14 size=1,2 to=q ; add portal name=q at=0,1,-18 size=1,2 to=p",
        "add ball name=k at=0,4,-4 radius=0.5 mass=4",
        "change b at=0,2,-4",
    ];
    let picture = Picture::new(&gpu.device, (321, 181));
    for edit in edits {
        println!("{edit}");
        let words: Vec<_> = edit.split_whitespace().collect();
        let mut since = Instant::now();
        if !words.is_empty() {
            scene.edit(&words, |_| unreachable!()).unwrap();
        }
        told("edit", &mut since);
        let all = Instant::now();
        let copy = scene.clone();
        told("clone", &mut since);
        let mut writing = painter.signs.begin();
        let mut made = copy
            .ray_scene(|board| writing.write(&gpu, board.clone()))
            .unwrap();
        drop(writing);
        told("ray scene and signs", &mut since);
        let figures = RoomFigures::add_to(&mut made).unwrap();
        told("figures", &mut since);
        let loaded = painter.rays.upload(&gpu.device, &gpu.queue, &made).unwrap();
        told("upload", &mut since);
        let mut drawable = Drawable {
            scene: made,
            loaded,
            figures,
        };
        {
            let view = view_of(&scene);
            while let Some(shader) = painter.missing(&drawable, &view) {
                painter.compile(&gpu, shader).unwrap();
            }
        }
        told("compiled what is wanted", &mut since);
        for round in 0..2 {
            let view = view_of(&scene);
            drawable.set(&gpu, &view.moment).unwrap();
            let mut encoder = gpu.encoder();
            painter.trace(
                &gpu,
                &mut encoder,
                (&drawable, &picture),
                &view,
                0..picture.size.1,
            );
            gpu.queue.submit([encoder.finish()]);
            told("submitted", &mut since);
            gpu.device
                .poll(wgpu::PollType::wait_indefinitely())
                .unwrap();
            told(
                if round == 0 {
                    "first picture"
                } else {
                    "second picture"
                },
                &mut since,
            );
        }
        println!("  all {:.1} ms", all.elapsed().as_secs_f64() * 1e3);
        let mut since = Instant::now();
        for shader in painter.uncompiled(&drawable) {
            painter.compile(&gpu, shader).unwrap();
        }
        told("compiled the rest", &mut since);
    }
}
