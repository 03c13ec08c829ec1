//! What a picture needs to know, as frame.wgsl has it.

use std::ops::Range;

use antipode_deformation::PictureCorners;
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec4};

use crate::packed::{stack, vector};
use crate::rays::Options;
use crate::scene::{Eye, Lamp, MAX_LAMPS, RayScene};

/// Cosine of the angle of the sun's radius.
const SUN_COSINE: f64 = 0.9995;

#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
struct PackedLamp {
    place: Vec4,
    colour: Vec4,
    stack: [u32; 4],
    depth: u32,
    room: [u32; 3],
}

/// A part of a picture.
#[derive(Clone, Debug)]
pub struct Part {
    /// From and to which column.
    pub columns: Range<u32>,
    /// From and to which row.
    pub rows: Range<u32>,
    /// The column that is a line.
    pub line: u32,
}

/// What a picture needs to know.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Frame {
    eye: Vec4,
    right: Vec4,
    up: Vec4,
    front: Vec4,
    zenith: Vec4,
    sun: Vec4,
    sun_colour: Vec4,
    top: Vec4,
    horizon: Vec4,
    ground: Vec4,
    ambient_sky: Vec4,
    ambient_ground: Vec4,
    outline: Vec4,
    stack: [u32; 4],
    size: [u32; 4],
    counts: [u32; 4],
    marks: [u32; 4],
    lamps: [PackedLamp; MAX_LAMPS],
}

/// Of a scene's light, an eye, and a part of a picture of `size` pixels.
pub fn frame(
    scene: &RayScene,
    eye: &Eye,
    size: (u32, u32),
    options: Options,
    part: &Part,
) -> Frame {
    let half = (0.5 * eye.fov_y_rad).tan();
    let aspect = f64::from(size.0) / f64::from(size.1.max(1));
    let pixel_angle = 2.0 * half / f64::from(size.1.max(1));
    let fog = f64::from(scene.fog_m).max(1.0);
    let sky = &scene.sky;
    let (sun, sun_colour) = match &scene.sun {
        Some(sun) => (sun.direction, sun.colour.extend(1.0)),
        None => (DVec3::Y, Vec4::ZERO),
    };
    let shining = scene.lamps.len().min(MAX_LAMPS);
    let outlines = if options.outlines {
        scene.outline.strength
    } else {
        0.0
    };
    let mut lamps = [PackedLamp::default(); MAX_LAMPS];
    for (packed, lamp) in lamps.iter_mut().zip(&scene.lamps) {
        *packed = pack_lamp(lamp);
    }
    Frame {
        eye: vector(eye.place.point, pixel_angle),
        right: vector(eye.right * (half * aspect), 0.0),
        up: vector(eye.up * half, 0.0),
        front: vector(eye.front, fog),
        zenith: vector(sky.zenith, fog),
        sun: vector(sun, SUN_COSINE),
        sun_colour,
        top: sky.top.extend(0.0),
        horizon: sky.horizon.extend(0.0),
        ground: sky.ground.extend(0.0),
        ambient_sky: sky.ambient_sky.extend(0.0),
        ambient_ground: sky.ambient_ground.extend(0.0),
        outline: scene.outline.colour.extend(outlines),
        stack: stack(&eye.place.stack),
        size: [size.0, size.1, options.bounces, options.samples.clamp(1, 4)],
        counts: [
            eye.place.stack.len() as u32,
            shining as u32,
            part.columns.start,
            part.columns.end,
        ],
        marks: [part.line, part.rows.start, part.rows.end, 0],
        lamps,
    }
}

fn pack_lamp(lamp: &Lamp) -> PackedLamp {
    PackedLamp {
        place: vector(lamp.place.point, f64::from(lamp.radius_m.max(0.0))),
        colour: lamp.colour.extend(lamp.reach_m.max(1e-3)),
        stack: stack(&lamp.place.stack),
        depth: lamp.place.stack.len() as u32,
        room: [0; 3],
    }
}

/// The directions of two opposite corners of the picture, by which the thesis's rule bends light.
pub fn corners(eye: &Eye, size: (u32, u32)) -> PictureCorners {
    let aspect = f64::from(size.0) / f64::from(size.1.max(1));
    PictureCorners::new(
        eye.direction(-1.0, -1.0, aspect),
        eye.direction(1.0, 1.0, aspect),
    )
}
