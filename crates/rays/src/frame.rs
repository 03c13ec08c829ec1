//! What a picture needs to know, as frame.wgsl has it.

use std::ops::Range;

use antipode_deformation::PictureCorners;
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3, Vec4};

use crate::options::Options;
use crate::packed::stack;
use crate::scene::{Eye, Lamp, MAX_LAMPS, RayScene};

/// How far one sees at least along parallel lines, felt metres.
const CLEAR_M: f32 = 1e5;
/// Cosine of the angle of the sun's radius.
const SUN_COSINE: f64 = 0.9995;

/// A lamp, as frame.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct PackedLamp {
    place: Vec3,
    radius_m: f32,
    colour: Vec3,
    reach_m: f32,
    stack: [u32; 4],
    depth: u32,
    padding: [u32; 3],
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
    eye: Vec3,
    pixel_rad: f32,
    right: Vec4,
    up: Vec4,
    front: Vec3,
    reach_m: f32,
    zenith: Vec3,
    fog_m: f32,
    sun: Vec3,
    sun_cosine: f32,
    sun_colour: Vec3,
    sun_count: u32,
    top: Vec4,
    horizon: Vec4,
    ground: Vec4,
    ambient_sky: Vec4,
    ambient_ground: Vec4,
    outline_colour: Vec3,
    outline_strength: f32,
    stack: [u32; 4],
    width: u32,
    height: u32,
    bounces: u32,
    samples: u32,
    depth: u32,
    lamp_count: u32,
    first_column: u32,
    end_column: u32,
    line_column: u32,
    first_row: u32,
    end_row: u32,
    scale: f32,
    /// 1 where all is seen along parallel lines, else 0.
    parallel: u32,
    padding: [u32; 3],
}

/// Of a scene's light, an eye, and a part of a picture of `size` pixels.
pub fn frame(
    scene: &RayScene,
    eye: &Eye,
    size: (u32, u32),
    options: Options,
    part: &Part,
) -> Frame {
    let tangent = (0.5 * eye.fov_y_rad).tan();
    let half = eye.parallel_m.unwrap_or(tangent);
    let aspect = f64::from(size.0) / f64::from(size.1.max(1));
    // Of parallel lines the width of a pixel is that at the distance at which an eye would see as much.
    let pixel_angle = 2.0 * tangent / f64::from(size.1.max(1));
    let clear_m = scene.fog_m.max(1.0);
    // Lines that are parallel begin far away, where fog would hide everything.
    let fog_m = if eye.parallel_m.is_some() {
        clear_m.max(CLEAR_M)
    } else {
        clear_m
    };
    let sky = &scene.sky;
    let (sun, sun_colour) =
        (scene.sun.as_ref()).map_or((DVec3::Y, Vec3::ZERO), |sun| (sun.direction, sun.colour));
    let shining = scene.lamps.len().min(MAX_LAMPS);
    Frame {
        eye: eye.place.point.as_vec3(),
        pixel_rad: pixel_angle as f32,
        right: (eye.right * (half * aspect)).as_vec3().extend(0.0),
        up: (eye.up * half).as_vec3().extend(0.0),
        front: eye.front.as_vec3(),
        reach_m: fog_m,
        zenith: sky.zenith.as_vec3(),
        fog_m,
        sun: sun.as_vec3(),
        sun_cosine: SUN_COSINE as f32,
        sun_colour,
        sun_count: u32::from(scene.sun.is_some()),
        top: sky.top.extend(0.0),
        horizon: sky.horizon.extend(0.0),
        ground: sky.ground.extend(0.0),
        ambient_sky: sky.ambient_sky.extend(0.0),
        ambient_ground: sky.ambient_ground.extend(0.0),
        outline_colour: scene.outline.colour,
        outline_strength: scene.outline.strength,
        stack: stack(&eye.place.stack),
        width: size.0,
        height: size.1,
        bounces: options.bounces,
        samples: options.samples.clamp(1, 4),
        depth: eye.place.stack.len() as u32,
        lamp_count: shining as u32,
        first_column: part.columns.start,
        end_column: part.columns.end,
        line_column: part.line,
        first_row: part.rows.start,
        end_row: part.rows.end,
        scale: eye.place.scale as f32,
        parallel: u32::from(eye.parallel_m.is_some()),
        padding: [0; 3],
    }
}

/// The lamps of a scene, as frame.wgsl has them.
pub type Lamps = [PackedLamp; MAX_LAMPS];

/// Packs as many lamps as there may be.
pub fn lamps(scene: &RayScene) -> Lamps {
    let mut lamps = Lamps::default();
    for (packed, lamp) in lamps.iter_mut().zip(&scene.lamps) {
        *packed = pack_lamp(lamp);
    }
    lamps
}

fn pack_lamp(lamp: &Lamp) -> PackedLamp {
    PackedLamp {
        place: lamp.place.point.as_vec3(),
        radius_m: lamp.radius_m.max(0.0),
        colour: lamp.colour,
        reach_m: lamp.reach_m.max(1e-3),
        stack: stack(&lamp.place.stack),
        depth: lamp.place.stack.len() as u32,
        padding: [0; 3],
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
