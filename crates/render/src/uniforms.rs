//! Uniforms and instances of a frame, laid out as the shaders read them.

use antipode_frame::{Cut, Frame, Orbs, View};
use antipode_geometry::{ChartPoint, ChunkCoord, LevelMap, NoiseFrame, SpaceUniform};
use antipode_terrain::Level;
use bytemuck::{Pod, Zeroable};
use glam::DVec3;

use crate::charts::whole_reference;
use crate::lamps::{BEAMS, BeamUniform, LAMPS, LampUniform, beams, lamps};
use crate::marker::Ring;
use crate::plan::{Affine, Port};
use crate::shades::{SHADES, Shades};
use crate::shadow::ShadowUniform;

/// Strength of the contour bands, where they are drawn.
const CONTOUR_STRENGTH: f32 = 0.24;
/// Grain repeats after this many metres, so that its coordinates stay small however far one walks.
const GRAIN_PERIOD_M: f64 = 256.0;

/// How far a gust bends a blade's tip, metres.
const WIND_M: f32 = 0.12;

/// `Scene` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct SceneUniform {
    space: SpaceUniform,
    right: [f32; 3],
    time_s: f32,
    up: [f32; 3],
    contour_strength: f32,
    front: [f32; 3],
    fog_distance_m: f32,
    top: [f32; 3],
    star_strength: f32,
    horizon: [f32; 3],
    star_sine: f32,
    glare: [f32; 3],
    star_cosine: f32,
    sun: [f32; 3],
    cloud_drift: f32,
    moon: [f32; 3],
    cloud_cover: f32,
    key_direction: [f32; 3],
    pixel_width: f32,
    key_colour: [f32; 3],
    pixel_height: f32,
    ambient_sky: [f32; 3],
    orb_radius: f32,
    ambient_ground: [f32; 3],
    ring_edges: f32,
    moon_colour: [f32; 3],
    covered: f32,
    sun_place: [f32; 4],
    moon_place: [f32; 4],
    ring_centre: [f32; 4],
    ring_light: [f32; 3],
    ring_radius_m: f32,
    ring_axes: [[f32; 4]; 3],
    wind: [f32; 4],
    ring_ground: [f32; 4],
    cuts: [[f32; 4]; View::CUTS],
    figure_cut: [f32; 4],
    shades: [[f32; 4]; SHADES],
    lamps: [LampUniform; LAMPS],
    beams: [BeamUniform; BEAMS],
    shadows: ShadowUniform,
}

impl SceneUniform {
    /// Everything the shaders need to know of a frame drawn `size` pixels large.
    pub fn new(frame: &Frame, size: (u32, u32), shades: &Shades, shadows: &ShadowUniform) -> Self {
        let sky = &frame.content.sky;
        let [_, sun_y, sun_z] = sky.sun_direction;
        // The stars turn about x with the sun, which rises at -z: this is the sun's turn since then.
        let (sin, cos) = (sun_y, -sun_z);
        let length = sin.hypot(cos).max(f32::MIN_POSITIVE);
        let ring = Ring::of(frame);
        let radius_m = frame.view.strategy.radius_m();
        let orb_radius = sky.orbs.map_or(0.0, |orbs| orbs.radius_m / radius_m);
        let [right, up, front] = frame.view.axes().map(DVec3::as_vec3);
        Self {
            space: frame.view.uniform(),
            right: right.into(),
            time_s: frame.content.time_s,
            up: up.into(),
            contour_strength: if frame.view.contour_bands {
                CONTOUR_STRENGTH
            } else {
                0.0
            },
            front: front.into(),
            fog_distance_m: frame.view.fog_distance_m.max(1.0),
            top: sky.top,
            star_strength: sky.stars,
            horizon: sky.horizon,
            star_sine: sin / length,
            glare: sky.glare,
            star_cosine: cos / length,
            sun: sky.sun_direction,
            cloud_drift: sky.drift,
            moon: sky.moon_direction,
            cloud_cover: sky.clouds,
            key_direction: sky.key_direction,
            pixel_width: 2.0 / size.0 as f32,
            key_colour: sky.key_colour,
            pixel_height: 2.0 / size.1 as f32,
            ambient_sky: sky.ambient_sky,
            orb_radius: orb_radius as f32,
            ambient_ground: sky.ambient_ground,
            ring_edges: ring.edges,
            moon_colour: sky.moon_colour,
            covered: frame.view.covered,
            sun_place: orb_place(frame, |orbs| orbs.sun),
            moon_place: orb_place(frame, |orbs| orbs.moon),
            ring_centre: ring.centre,
            ring_light: ring.light,
            ring_radius_m: ring.radius_m,
            ring_axes: ring.axes,
            wind: wind(frame),
            ring_ground: ring.ground,
            cuts: frame.view.cuts.map(|cut| cut.as_vec4().into()),
            figure_cut: frame.view.figure_cut.as_vec4().into(),
            shades: shades.places(),
            lamps: lamps(frame),
            beams: beams(frame),
            shadows: *shadows,
        }
    }
}

/// The wind of a moment: the turns of gusts and of what flutters, radians, and how far it bends, metres.
fn wind(frame: &Frame) -> [f32; 4] {
    let turns = frame.view.wind;
    turns.map_or([0.0; 4], |[gust, flutter]| [gust, flutter, WIND_M, 0.0])
}

/// Where a body of a closed world stands: a unit vector of the model in view coordinates.
fn orb_place(frame: &Frame, which: fn(Orbs) -> ChartPoint) -> [f32; 4] {
    let Some(orbs) = frame.content.sky.orbs else {
        return [0.0; 4];
    };
    let view = frame.view.point(which(orbs));
    let units = view.truncate() / frame.view.strategy.radius_m();
    units.extend(view.w).as_vec4().into()
}

/// Flag of a [`ChunkInstance`] in a shadow map that has no land, which ends at the edge of its chart; that of terrain.wgsl.
const PAST_RIM_FLAG: u32 = 1;

/// Where a chunk stands; the instance attributes of terrain.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct ChunkInstance {
    /// The chunk's corner from the whole metres next to the reference.
    pub offset: [f32; 3],
    /// In the lowest bit whether a figure's shadow may fall on the chunk, and above a bit for each shade that may; of what grows,
    /// for each that may bend it.
    pub flags: u32,
    /// Where grain has the chunk's corner, wrapped to [-128, 128) metres.
    pub world: [f32; 3],
    /// Of a mesh that comes in a blend, the share of the pixels that show it; of one that goes, minus the share that
    /// no longer do.
    pub blend: f32,
    /// View coordinates of the reference, and per metre along x, y and z, where the chunk is ported as a whole.
    pub frame: [[f32; 4]; 4],
    /// Which lamps, by 64 bits, and which beams, by 16, may light the chunk, and above those the level of its land.
    pub lights: [u32; 3],
}

impl ChunkInstance {
    /// The chunk with its corner at `origin`, for positions relative to `reference`; both in chart metres.
    pub fn new(origin: DVec3, reference: DVec3) -> Self {
        Self {
            offset: (origin - reference).as_vec3().into(),
            flags: 0,
            world: [0.0; 3],
            blend: 0.0,
            frame: [[0.0; 4]; 4],
            lights: [0; 3],
        }
    }

    /// A chunk of a frame, carried into its picture in such a way.
    pub fn of(frame: &Frame, coord: ChunkCoord, port: &Port) -> Self {
        Self::at(frame, ChartPoint::new(coord.chart, coord.origin()), port)
    }

    /// What is told from a corner in whole metres, carried into a frame's picture in such a way.
    pub fn at(frame: &Frame, corner: ChartPoint, port: &Port) -> Self {
        let ChartPoint { chart, pos } = corner;
        let noise = frame.view.strategy.noise_frame(chart);
        let plain = Self::new(pos, whole_reference(frame, chart)).grained(pos, noise);
        match port {
            Port::Vertex => plain,
            Port::Frame(affine) => plain.framed(&affine.moved(&frame.view)),
        }
    }

    /// The same, whose corner is where a frame of the noise has a place of the chart, metres.
    #[must_use]
    pub fn grained(self, origin: DVec3, noise: NoiseFrame) -> Self {
        let place = match noise {
            NoiseFrame::Square(frame) => frame.placed(origin),
            NoiseFrame::Radial { .. } | NoiseFrame::Upright => origin,
        };
        Self {
            world: place.map(wrap_m).as_vec3().into(),
            ..self
        }
    }

    /// The same, ported as a whole.
    #[must_use]
    pub fn framed(self, affine: &Affine) -> Self {
        Self {
            frame: frame_rows(affine),
            ..self
        }
    }

    /// The same, with the shades that may fall on it by their bits, and a figure's shadow or none.
    #[must_use]
    pub fn shaded(self, shades: u32, by_figures: bool) -> Self {
        Self {
            flags: u32::from(by_figures) | shades << 1,
            ..self
        }
    }

    /// The same of what grows: with what may bend it by bits, and a figure's shadow or none. It has no shades.
    #[must_use]
    pub fn bent(self, pressers: u32, by_figures: bool) -> Self {
        self.shaded(pressers, by_figures)
    }

    /// The same, with lights that may fall on it, whose triangles are those of a level.
    #[must_use]
    pub fn lit(self, lights: [u32; 3], level: Level) -> Self {
        let [near, far, beams] = lights;
        if lights == [0; 3] {
            return self;
        }
        Self {
            lights: [near, far, beams | (level.index() as u32) << BEAMS],
            ..self
        }
    }

    /// The same of what throws its shadow though it reach over the edge of its chart.
    #[must_use]
    pub fn past_rim(self) -> Self {
        Self {
            flags: PAST_RIM_FLAG,
            ..self
        }
    }

    /// The same, in a blend.
    #[must_use]
    pub fn blending(self, blend: f32) -> Self {
        Self { blend, ..self }
    }

    /// Attributes from location 3 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 8] = wgpu::vertex_attr_array![
        3 => Float32x3, 4 => Uint32, 5 => Float32x4,
        6 => Float32x4, 7 => Float32x4, 8 => Float32x4, 9 => Float32x4, 10 => Uint32x3
    ];
}

/// Wraps to [-128, 128), after which grain repeats.
fn wrap_m(x: f64) -> f64 {
    (x + GRAIN_PERIOD_M / 2.0).rem_euclid(GRAIN_PERIOD_M) - GRAIN_PERIOD_M / 2.0
}

/// Flag of a [`FigureInstance`] that is red; those of figure.wgsl.
pub const HOSTILE_FLAG: u32 = 1;
/// That of a car whose head and tail lights are on.
pub const LIGHTS_FLAG: u32 = 2;
/// That of a car whose brake lights are.
pub const BRAKES_FLAG: u32 = 4;
/// That of what can be put where it is shown.
pub const POSSIBLE_FLAG: u32 = 8;
/// That of what cannot be put there.
pub const BARRED_FLAG: u32 = 16;
/// Above the flags is how much of the sky a figure lacks, in steps to [`NO_SKY`].
pub const DARK_SHIFT: u32 = 5;
/// None of the sky is left.
pub const NO_SKY: u32 = 7;
/// And above that the figure's place in its batch of joints.
pub const PLACE_SHIFT: u32 = 8;

/// How much of the sky is lacking where so much of it is left, 0 to 1, as instances have it.
pub fn dark_bits(sky: f32) -> u32 {
    let steps = (1.0 - sky.clamp(0.0, 1.0)) * NO_SKY as f32;
    (steps.round() as u32) << DARK_SHIFT
}

/// Where and how a figure stands; the instance attributes of figure.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct FigureInstance {
    /// The origin from the reference, metres; of what is in the player's hand, from the eye in its own axes.
    pub offset: [f32; 3],
    /// Flags, and above them the figure's place in its batch of joints.
    pub flags: u32,
    /// How it is turned in the chart: a quaternion, its real part last.
    pub turn: [f32; 4],
    /// View coordinates of the origin, and per metre along x, y and z, where the figure is ported as a whole.
    pub frame: [[f32; 4]; 4],
    /// Which lamps, by 64 bits, and which beams may light the figure.
    pub lights: [u32; 3],
    /// What of it is shown: [`packed_cut`], or [`WHOLE`].
    pub cut: u32,
    /// Metres of the chart for each along x, and along z, when it is turned.
    pub level: [f32; 4],
}

/// A figure that is shown whole: two numbers that no packing gives.
pub const WHOLE: u32 = 0x8000_8000;
/// Cuts farther from a figure's origin than this are as good as at this, metres.
const CUT_REACH_M: f64 = 8.0;

/// A cut as its instance carries it: the heading's share of half a turn, and above it the distance as a share of
/// [`CUT_REACH_M`], each as a normalised integer of 16 bits: to 0.1 mrad and 0.3 mm.
pub fn packed_cut(cut: &Cut) -> u32 {
    let snorm = |share: f64| (share.clamp(-1.0, 1.0) * 32767.0).round() as i16 as u16;
    let turn = cut.heading_rad / std::f64::consts::PI;
    let turn = turn - 2.0 * (0.5 * turn).round();
    u32::from(snorm(turn)) | u32::from(snorm(cut.from_m / CUT_REACH_M)) << 16
}

impl FigureInstance {
    /// Attributes from location 3 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 9] = wgpu::vertex_attr_array![
        3 => Float32x3, 4 => Uint32, 5 => Float32x4,
        6 => Float32x4, 7 => Float32x4, 8 => Float32x4, 9 => Float32x4, 10 => Uint32x4, 11 => Float32x4
    ];
}

/// How a figure's metres lie in the chart, as its instance carries it.
pub fn level_row(level: LevelMap) -> [f32; 4] {
    level.columns().map(|it| it as f32)
}

/// A frame as its instance carries it: the origin first, then the axes.
pub fn frame_rows(affine: &Affine) -> [[f32; 4]; 4] {
    let [x, y, z] = affine.columns;
    [affine.base, x, y, z].map(|v| v.as_vec4().into())
}

/// One ball of the marker; the instance attributes of marker.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct MarkerInstance {
    /// The centre from the reference, metres.
    pub offset: [f32; 3],
    /// Linear light; last, the opacity seen face on.
    pub colour: [f32; 4],
    /// Radius in metres, opacity seen edge on, and room.
    pub shape: [f32; 4],
}

impl MarkerInstance {
    /// Attributes from location 1 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 3] =
        wgpu::vertex_attr_array![1 => Float32x3, 2 => Float32x4, 3 => Float32x4];
}

/// A shape whose outline is drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct OutlineInstance {
    /// Its point from the reference, metres.
    pub offset: [f32; 3],
    /// Turn as a quaternion (x, y, z, w).
    pub turn: [f32; 4],
    /// What the unit shape is stretched by along each axis, metres; last, the height of its lower middle over its
    /// point.
    pub size: [f32; 4],
    /// Linear light; last, the height of its upper middle over its point, metres.
    pub colour: [f32; 4],
}

impl OutlineInstance {
    /// Attributes from location 3 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 4] =
        wgpu::vertex_attr_array![3 => Float32x3, 4 => Float32x4, 5 => Float32x4, 6 => Float32x4];
}

#[cfg(test)]
mod tests;
