//! Pictures of parts are there, are not blank, and are what the game draws.

#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::path::Path;

use antipode_deformation::Place;
use antipode_language::Texts;
use antipode_rays::{Eye, Options};
use antipode_render::{AdapterChoice, Gpu, Offscreen, Preset, ShadowQuality};
use antipode_room_scene::RoomScene;
use antipode_rooms::room::Sky;
use antipode_rooms::{Assets, Colour, Object, Room, What, direction, poses};
use antipode_workshop::{Document, make};
use glam::{DVec2, DVec3};
use image::imageops::{FilterType, resize};
use image::{ExtendedColorType, ImageEncoder as _, RgbaImage};

use super::*;
use crate::room_picture::{RoomPictures, RoomView};
use crate::window::workshop::chosen::half;
use crate::window::workshop::kits::Site;
use crate::window::workshop::parts::{self, PARTS};

/// The size of the pictures, and how many times as large they are drawn.
const SIZE: (u32, u32) = (128, 96);
const DRAWN: u32 = 3;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// How far a picture may be from that which is drawn, as the mean of all channels, steps of 255: adapters differ.
const MOST_APART: f64 = 4.0;
/// Those that are drawn where nobody asks for more.
const FEW: [&str; 2] = ["house", "box"];
/// How far it is at least from that of the floor alone.
const LEAST_SEEN: f64 = 4.0;

/// The adapter, and what draws.
struct Studio<'a> {
    gpu: &'a Gpu,
    pictures: RoomPictures,
    target: Offscreen,
    drawn: u64,
}

impl<'a> Studio<'a> {
    fn new(gpu: &'a Gpu) -> Self {
        let options = antipode_render::Options {
            samples: 1,
            scale: 1.0,
            output_format: FORMAT,
            shadows: ShadowQuality::Off,
            preset: Preset::Software,
        };
        let (width, height) = (SIZE.0 * DRAWN, SIZE.1 * DRAWN);
        Self {
            gpu,
            pictures: RoomPictures::new(gpu, &options, (width, height)).unwrap(),
            target: Offscreen::new(gpu, width, height, FORMAT),
            drawn: 0,
        }
    }

    /// A picture of a room from there, along a yaw and a pitch in degrees.
    fn shoot(&mut self, room: Room, (at, look): (DVec3, DVec2)) -> RgbaImage {
        let scene = RoomScene::of(Document::new(room), Assets::default());
        let place = Place::at(scene.space(), at);
        let eye = Eye::looking(place, direction(look), DVec3::Y, FOV_Y_RAD);
        self.drawn += 1;
        let view = RoomView {
            id: (self.drawn, 0),
            moment: scene.still(&eye),
            options: Options {
                samples: 4,
                ..Options::default()
            },
            tile: None,
        };
        let shown = (&scene, &Texts::default());
        let large = self.pictures.shoot(self.gpu, &self.target, shown, &view);
        resize(&large.unwrap(), SIZE.0, SIZE.1, FilterType::Triangle)
    }
}

/// The angle between top and bottom, rad.
const FOV_Y_RAD: f64 = 0.6;

/// What parts stand on.
const GROUND: &str = "ground";

/// Where one looks at a part, its front to the right: yaw and pitch, degrees; and how near to it one is, as a share of where all of it
/// would be seen for sure.
fn look(id: &str) -> (DVec2, f64) {
    let (yaw, pitch, near) = match id {
        "arch" => (-158.0, -10.0, 0.92),
        "portals" => (-97.0, -9.0, 0.8),
        "portal" => (-112.0, -10.0, 1.0),
        "tunnel" => (-112.0, -12.0, 0.98),
        "wall" | "floor" => (-115.0, -20.0, 0.9),
        "sign" => (-78.0, -3.0, 0.85),
        "stairs" | "ramp" => (-130.0, -18.0, 0.95),
        "house" | "ball" => (-118.0, -16.0, 0.82),
        "light" => (-112.0, -12.0, 2.4),
        _ => (-118.0, -16.0, 1.05),
    };
    (DVec2::new(yaw, pitch), near)
}

fn floor() -> Object {
    let size = DVec3::new(200.0, 1.0, 200.0);
    let mut floor = Object::new(GROUND, DVec3::NEG_Y * 0.5, What::Box { size });
    floor.surface.colour = Colour([0x9a, 0xa0, 0x94]);
    floor.surface.checker = Some(antipode_rooms::room::Checker {
        colour: Colour([0x84, 0x8a, 0x7e]),
        size: 1.0,
    });
    floor
}

/// A room with a floor and a part on it, and from where that is looked at.
fn of(id: &str) -> (Room, (DVec3, DVec2)) {
    let mut room = Room::new("part");
    room.sentence = "Abc".to_owned();
    room.sun = Some(antipode_rooms::room::Sun {
        aim: DVec2::new(60.0, 48.0),
        ..Default::default()
    });
    room.objects = vec![floor().into()];
    let site = Site {
        point: DVec3::ZERO,
        normal: DVec3::Y,
        front: DVec3::NEG_Z,
        snap: &|metres| metres,
        ground: &|point| Some(DVec3::new(point.x, 0.0, point.z)),
    };
    let edit = parts::put(&room, id, &site).unwrap();
    let mut room = make(&room, &edit).unwrap();
    let (low, high) = bounds(&room);
    if id == "light" {
        by_night(&mut room);
    }
    let (look, near) = look(id);
    let (middle, reach_m) = ((low + high) / 2.0, (high - low).length() / 2.0);
    let away_m = near * reach_m / (0.5 * FOV_Y_RAD).sin();
    (room, (middle - direction(look) * away_m, look))
}

/// The lowest and the highest corner of all but the floor.
fn bounds(room: &Room) -> (DVec3, DVec3) {
    let all = room.objects.iter().zip(poses(room));
    let boxes = all
        .filter(|(it, _)| it.what != What::Group && it.name != GROUND)
        .map(|(it, pose)| {
            let (m, half) = (pose.matrix3, half(&it.what));
            let reach = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
            (pose.translation - reach, pose.translation + reach)
        });
    boxes
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
        .unwrap_or_default()
}

/// A lamp is seen by its light: it is night, and a ball glows where it is.
fn by_night(room: &mut Room) {
    room.sun = None;
    room.sky = Sky {
        colour: Colour([0x20, 0x28, 0x3c]),
        light: 0.05,
    };
    let mut all = room.objects.iter();
    let lamp = all.position(|it| matches!(it.what, What::Light { .. }));
    let lamp = room.object_mut(lamp.unwrap());
    lamp.at.y = 0.7;
    if let What::Light { power, .. } = &mut lamp.what {
        *power = 2.0;
    }
    let mut ball = Object::new("glow", lamp.at, What::Ball { radius: 0.14 });
    ball.surface.colour = Colour([0xff, 0xe0, 0xb0]);
    ball.surface.glow = 2.0;
    room.push(ball);
}

/// How far two pictures are from each other, as the mean of all channels.
fn apart(a: &RgbaImage, b: &RgbaImage) -> f64 {
    let all = a.as_raw().iter().zip(b.as_raw());
    let sum: f64 = all.map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / a.as_raw().len() as f64
}

fn save(id: &str, picture: &RgbaImage) {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/workshop/parts");
    let picture = image::DynamicImage::from(picture.clone()).to_rgb8();
    let file = std::fs::File::create(dir.join(format!("{id}.png"))).unwrap();
    let encoder = image::codecs::png::PngEncoder::new_with_quality(
        file,
        image::codecs::png::CompressionType::Best,
        image::codecs::png::FilterType::Adaptive,
    );
    encoder
        .write_image(&picture, SIZE.0, SIZE.1, ExtendedColorType::Rgb8)
        .unwrap();
}

#[test]
fn every_part_has_a_picture_as_the_game_draws_it() {
    let opened = Gpu::headless(AdapterChoice::Auto);
    let opened = opened.map_err(|error| error.to_string());
    let Some(gpu) = antipode_testing::needed("a graphics adapter", opened.as_ref()) else {
        return;
    };
    let mut studio = Studio::new(gpu);
    let asked = |name: &str| std::env::var_os(name).is_some();
    let remake = asked("ANTIPODE_REMAKE_PICTURES");
    // A processor takes seconds for each.
    let few = !remake && !asked("ANTIPODE_TEST_PICTURES");
    for id in PARTS.into_iter().filter(|id| !few || FEW.contains(id)) {
        let (room, from) = of(id);
        let drawn = studio.shoot(room, from);
        if remake {
            save(id, &drawn);
            continue;
        }
        let mut alone = Room::new("floor");
        alone.sun = of("box").0.sun;
        alone.objects = vec![floor().into()];
        let alone = studio.shoot(alone, from);
        assert!(apart(&drawn, &alone) > LEAST_SEEN, "{id} is not seen");
        let (_, kept) = PICTURES.iter().find(|(known, _)| *known == id).unwrap();
        let kept = image::load_from_memory(kept).unwrap().to_rgba8();
        let apart = apart(&kept, &drawn);
        assert!(apart < MOST_APART, "{id} is drawn otherwise: {apart}");
    }
}

#[test]
fn the_rows_of_parts_get_their_pictures_and_all_together_are_small() {
    let mut rows = parts::rows(&Texts::default());
    PartPictures::default().add_to(&Context::default(), &mut rows);
    assert!(rows.iter().all(|row| row.picture.is_some()));
    let read = |png: &[u8]| image::load_from_memory(png).unwrap().to_rgba8();
    let all: Vec<_> = PICTURES.iter().map(|(id, png)| (id, read(png))).collect();
    for (number, (id, picture)) in all.iter().enumerate() {
        assert_eq!(picture.dimensions(), SIZE, "{id}");
        let first = *picture.get_pixel(0, 0);
        let plain = RgbaImage::from_pixel(SIZE.0, SIZE.1, first);
        assert!(apart(picture, &plain) > LEAST_SEEN, "{id} is blank");
        for (other, theirs) in &all[..number] {
            assert!(apart(picture, theirs) > 1.0, "{id} looks as {other}");
        }
    }
    let bytes: usize = PICTURES.iter().map(|(_, png)| png.len()).sum();
    assert!(bytes < 300_000, "{bytes}");
}
