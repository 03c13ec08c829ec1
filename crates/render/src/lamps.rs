//! Lamps and beams as the shaders are told of them, and which of them may light a box of the chart.

use std::f64::consts::FRAC_PI_2;

use antipode_frame::{BeamLight, Frame, LampLight, sheet_behind};
use antipode_geometry::{ChartId, ChartPoint};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4};

/// Lamps lit at once; `LAMPS` of common.wgsl.
pub const LAMPS: usize = 64;
/// Beams lit at once; `BEAMS` of common.wgsl.
pub const BEAMS: usize = 16;

/// How many times as far as in the space a place may be in the chart: on the ground of a sphere charts are stretched by
/// pi/2 at the equator, and by 1 over the cosine of the height.
const CHART_STRETCH: f64 = 2.0;
/// Radii beyond this, metres, count as flat: the shader could not tell the difference from the fourth coordinate.
const FLAT_FROM_M: f64 = 1e4;
/// Step of the derivative that turns a way of the chart into one of the space, metres.
const STEP_M: f64 = 1e-3;

/// `Lamp` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct LampUniform {
    pub(crate) place: [f32; 4],
    pub(crate) colour: [f32; 3],
    pub(crate) fades_per_m2: f32,
}

/// `Beam` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct BeamUniform {
    pub(crate) place: [f32; 4],
    pub(crate) axis: [f32; 4],
    pub(crate) colour: [f32; 3],
    pub(crate) fades_per_m2: f32,
    pub(crate) full_cosine: f32,
    pub(crate) dark_cosine: f32,
    padding: [f32; 2],
    /// A covector of view coordinates: nothing is lit that has a negative product with it.
    pub(crate) behind: [f32; 4],
}

/// The curvature of a picture: its sign and its radius in metres, none where it is flat or as good as flat. A way off
/// the eye the fourth coordinate is over 1 in hyperbolic pictures and under 1 in spherical ones.
fn curvature(frame: &Frame) -> Option<(f64, f64)> {
    let radius_m = frame.view.strategy.radius_at_m(&frame.view.eye);
    if radius_m >= FLAT_FROM_M {
        return None;
    }
    let ahead = frame
        .view
        .eye
        .point
        .moved(frame.view.eye.front() * (0.2 * radius_m));
    let opens = frame.view.strategy.view_point(&frame.view.eye, ahead).w > 1.0;
    Some((if opens { -1.0 } else { 1.0 }, radius_m))
}

/// A point in view coordinates with w in metres, as `lit_at` of lights.wgsl has it.
fn place(frame: &Frame, point: ChartPoint) -> DVec4 {
    let view = frame.view.point(point);
    let w = curvature(frame).map_or(0.0, |(_, radius_m)| view.w * radius_m);
    view.truncate().extend(w)
}

/// The chord over a distance, metres: `2 R sin(d / 2 R)` or, in hyperbolic space, with sinh.
fn chord_m(frame: &Frame, range_m: f64) -> f64 {
    let Some((sign, radius_m)) = curvature(frame) else {
        return range_m;
    };
    let half = 0.5 * range_m / radius_m;
    let chord = if sign < 0.0 {
        half.sinh()
    } else {
        half.min(FRAC_PI_2).sin()
    };
    2.0 * radius_m * chord
}

/// One over the square of the chord at which a light of that range has faded away, per square metre.
fn fades_per_m2(frame: &Frame, range_m: f64) -> f32 {
    let chord_m = chord_m(frame, range_m);
    (1.0 / (chord_m * chord_m).max(f64::MIN_POSITIVE)) as f32
}

/// A frame's lamps.
pub fn lamps(frame: &Frame) -> [LampUniform; LAMPS] {
    let mut uniforms = [LampUniform::default(); LAMPS];
    for (uniform, lamp) in uniforms.iter_mut().zip(&frame.content.lights.lamps) {
        *uniform = LampUniform {
            place: place(frame, lamp.point).as_vec4().into(),
            colour: lamp.colour,
            fades_per_m2: fades_per_m2(frame, lamp.range_m),
        };
    }
    uniforms
}

/// A frame's beams.
pub fn beams(frame: &Frame) -> [BeamUniform; BEAMS] {
    let mut uniforms = [BeamUniform::default(); BEAMS];
    for (uniform, beam) in uniforms.iter_mut().zip(&frame.content.lights.beams) {
        let (inner, outer) = beam.cone_rad;
        *uniform = BeamUniform {
            place: place(frame, beam.point).as_vec4().into(),
            axis: axis(frame, beam).as_vec4().into(),
            colour: beam.colour,
            fades_per_m2: fades_per_m2(frame, beam.range_m),
            full_cosine: inner.cos() as f32,
            dark_cosine: outer.cos() as f32,
            padding: [0.0; 2],
            behind: beam
                .behind
                .as_ref()
                .map_or([0.0; 4], |(leaf, is_in_front)| {
                    sheet_behind(&frame.view, leaf, *is_in_front)
                        .as_vec4()
                        .into()
                }),
        };
    }
    uniforms
}

/// The way of a beam as a unit vector of the space, in view coordinates without unit: the derivative of the port along
/// it, over its length in the model.
fn axis(frame: &Frame, beam: &BeamLight) -> DVec4 {
    let step = beam.direction * STEP_M;
    let there = place(frame, beam.point.moved(step)) - place(frame, beam.point.moved(-step));
    let sign = curvature(frame).map_or(0.0, |(sign, _)| sign);
    let length2 = there.truncate().length_squared() + sign * there.w * there.w;
    there / length2.max(f64::MIN_POSITIVE).sqrt()
}

/// Which lamps, by 64 bits, and which beams may light a box of the chart from `min` to `max` metres.
pub fn lights_near(frame: &Frame, chart: ChartId, min: DVec3, max: DVec3) -> [u32; 3] {
    let lights = &frame.content.lights;
    if lights.lamps.is_empty() && lights.beams.is_empty() {
        return [0; 3];
    }
    let near = |point: ChartPoint, range_m: f64| {
        let here = frame.view.strategy.carry(point, chart).map(|it| it.point);
        let stretch = if curvature(frame).is_some() {
            CHART_STRETCH
        } else {
            1.0
        };
        here.is_some_and(|here| here.pos.distance(here.pos.clamp(min, max)) <= range_m * stretch)
    };
    let mut mask = [0; 3];
    for (i, LampLight { point, range_m, .. }) in lights.lamps.iter().take(LAMPS).enumerate() {
        mask[i / 32] |= u32::from(near(*point, *range_m)) << (i % 32);
    }
    for (i, BeamLight { point, range_m, .. }) in lights.beams.iter().take(BEAMS).enumerate() {
        mask[2] |= u32::from(near(*point, *range_m)) << i;
    }
    mask
}
