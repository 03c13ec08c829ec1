//! Uniforms of the shadow maps, laid out as the shaders read them.

use std::f64::consts::FRAC_PI_2;

use antipode_frame::Frame;
use antipode_geometry::{ChartPoint, Eye};
use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec4};

use super::levels::Shot;
use super::light::Light;

/// Where charts have no edge, metres: farther than anything, and squared still in `f32`.
const UNLIMITED_M: f64 = 1e18;

/// Maps that a picture reads; `SHADOW_MAPS` of common.wgsl. The last is that of figures.
pub const MAPS: usize = 8;
/// The map of figures.
pub const FIGURES: usize = MAPS - 1;

/// `ShadowMap` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct MapUniform {
    pub(crate) clip: [[f32; 4]; 4],
    pub(crate) layer: f32,
    pub(crate) texel_depth: f32,
    pub(crate) weight: f32,
    /// 1, or -1 where the picture is mirrored.
    pub(crate) hand: f32,
}

/// `Shadows` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct ShadowUniform {
    pub maps: [MapUniform; MAPS],
    /// Strength of the key light's shadows, 0 to 1.
    pub strength: f32,
    /// Texels of a map's side.
    pub side_texels: f32,
    /// One over that.
    pub texel: f32,
    /// 1 where a closed world's moon throws them.
    pub by_moon: f32,
}

/// `Caster` of common.wgsl: one pass into a map.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct CasterUniform {
    pub(crate) clip: [[f32; 4]; 4],
    pub(crate) curvature_per_m: f32,
    /// How far charts reach, metres.
    pub(crate) rim_m: f32,
    padding: [f32; 2],
}

impl CasterUniform {
    /// A pass over what a matrix takes to the base of the light.
    pub fn new(shot: &Shot, to_base: DMat4) -> Self {
        let (clip, k, rim_m) = match shot.light {
            Light::Far { .. } => (shot.clip() * to_base, 0.0, UNLIMITED_M),
            Light::Star { radius_m, .. } => (shot.clip(), 1.0 / radius_m, FRAC_PI_2 * radius_m),
        };
        Self {
            clip: clip.as_mat4().to_cols_array_2d(),
            curvature_per_m: k as f32,
            rim_m: rim_m as f32,
            padding: [0.0; 2],
        }
    }
}

/// To a light's base from what the shaders make of land: nothing, but where charts have models of their own, from that of the
/// eye's.
pub fn own_base(frame: &Frame, light: &Light) -> DMat4 {
    match light {
        Light::Far { anchor, .. } if light.is_ideal() => {
            let view = &frame.view;
            view.strategy.between(view.eye.point.chart, anchor.chart)
        }
        Light::Far { .. } | Light::Star { .. } => DMat4::IDENTITY,
    }
}

/// Where the reference is in a light's base, under a sky.
pub fn reference_from(frame: &Frame, light: &Light) -> DVec4 {
    let (strategy, eye): (_, &Eye) = (&*frame.view.strategy, &frame.view.eye);
    let reference = strategy.reference(eye, eye.point.chart);
    light.base(strategy, ChartPoint::new(eye.point.chart, reference))
}

/// From what a shader has of a point to a light's base: its place from the reference, or its view coordinates.
pub fn to_base(frame: &Frame, light: &Light) -> DMat4 {
    match light {
        Light::Far { .. } if light.is_ideal() => {
            let view = &frame.view;
            let own = (view.isometry * view.strategy.view_matrix(&view.eye)).inverse();
            own_base(frame, light) * own
        }
        Light::Far { .. } => DMat4::from_translation(reference_from(frame, light).truncate()),
        Light::Star { .. } => {
            let view = frame.view.uniform().view;
            glam::Mat4::from_cols_array_2d(&view).as_dmat4().inverse()
        }
    }
}

impl MapUniform {
    /// A map that lies in a layer of `texels` a side, to be trusted by a weight from 0 to 1.
    pub fn new(frame: &Frame, shot: &Shot, layer: u32, texels: u32, weight: f64) -> Self {
        let clip = shot.clip() * to_base(frame, &shot.light);
        let depth = shot.light.texel_depth(&shot.crop, shot.heights, texels);
        Self {
            clip: clip.as_mat4().to_cols_array_2d(),
            layer: layer as f32,
            texel_depth: depth as f32,
            weight: weight as f32,
            hand: shot.hand(),
        }
    }

    /// Has it lie in another layer.
    pub fn lie_in(&mut self, layer: u32) {
        self.layer = layer as f32;
    }
}
