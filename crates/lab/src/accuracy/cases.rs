//! Whole cases for the four functions of the shader, as a renderer would send them: positions
//! relative to the space's reference, every number rounded to single once.

use std::sync::Arc;

use antipode_geometry::kernel::sphere as sphere_kernel;
use antipode_geometry::shader::MAPS;
use antipode_geometry::{
    ChartPoint, ChunkCoord, Eye, Geometry, HyperbolicMap, Projection, SpaceUniform, Strategy,
    picture,
};
use antipode_render::Gpu;
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Mat4, Vec3, Vec4};

use crate::compute;
use crate::error::LabError;
use crate::single;

/// The picture that pixels are counted in.
pub const WIDTH: f64 = 1280.0;
/// Height of that picture in pixels.
pub const HEIGHT: f64 = 720.0;
/// Near distance in metres.
pub const NEAR_M: f64 = 0.05;
/// Radius of the hyperbolic world, in metres.
pub const RADIUS_M: f64 = 20.0;

/// 1280 by 720 with a vertical field of view of 75 degrees.
pub fn projection() -> Projection {
    Projection::new(75.0_f64.to_radians(), WIDTH / HEIGHT, NEAR_M)
}

/// What the shader is given.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Case {
    pub space: SpaceUniform,
    pub p: Vec3,
    /// The place of its map among [`antipode_geometry::shader::MAPS`].
    pub map: u32,
    pub n: Vec3,
    /// The number of its chart, which the shader does without.
    pub chart: u32,
}

/// What it answers.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Answer {
    pub view: Vec4,
    pub clip: Vec4,
    pub normal: Vec3,
    pub distance: f32,
}

/// What the shader is given and answers.
pub const TYPES: &str = "
struct Case { space: Space, p: vec3<f32>, map: u32, n: vec3<f32>, chart: u32 }
struct Answer { view: vec4<f32>, clip: vec4<f32>, normal: vec3<f32>, distance: f32 }";
const BODY: &str = "let space = inputs[i].space;
    let view = port_to_view(space, inputs[i].p);
    outputs[i].view = view;
    outputs[i].clip = clip_from_view(space, view);
    outputs[i].normal = port_normal(space, inputs[i].p, inputs[i].n);
    outputs[i].distance = eye_distance(space, view);";

/// The shader's answers, where there is an adapter.
///
/// # Errors
/// When the adapter fails.
pub fn answers(gpu: Option<&Gpu>, cases: &[Case]) -> Result<Option<Vec<Answer>>, LabError> {
    let shader = compute::shader(TYPES, "Case", "Answer", BODY);
    gpu.map(|gpu| compute::run_by_map(gpu, &shader, cases, |case| case.map))
        .transpose()
}

/// A case: a point and a normal of the chart, seen by an eye.
pub fn case(space: &dyn Strategy, eye: &Eye, point: ChartPoint, normal: DVec3) -> Case {
    let reference = space.reference(eye, point.chart);
    Case {
        space: SpaceUniform {
            view: space
                .chart_matrix(eye, point.chart)
                .as_mat4()
                .to_cols_array_2d(),
            ..space.uniform(eye, &projection())
        },
        p: (point.pos - reference).as_vec3(),
        map: compute::number_of(space.shader()),
        n: normal.as_vec3(),
        chart: point.chart.number() as u32,
    }
}

/// A vertex of a chunk as the shader has it, relative to the space's reference: the chunk's corner
/// is measured from the whole metres next to the reference, which is exact, then comes the place in
/// the chunk, and last the rest of the reference.
pub fn sent(space: &dyn Strategy, eye: &Eye, chunk: ChunkCoord, local: Vec3) -> Vec3 {
    let reference = space.reference(eye, chunk.chart);
    let whole = reference.round();
    let offset = (chunk.origin() - whole).as_vec3();
    offset + local - (reference - whole).as_vec3()
}

/// The view of a case in single precision on the processor: the shader's arithmetic.
pub fn single_view(case: &Case) -> Vec4 {
    let p = case.p.to_array();
    let map = MAPS.get(case.map as usize).map_or("", |map| map.name);
    let ported = match map {
        "flat" => [p[0], p[1], p[2], 1.0],
        "raised" => single::raised_map(&case.space).port(p),
        "sphere" => sphere_kernel::port(case.space.k_per_m, false, p),
        _ => single::horizon_map(&case.space).port(p),
    };
    Mat4::from_cols_array_2d(&case.space.view) * Vec4::from_array(ported)
}

/// A space, a dial and their name.
#[derive(Clone, Debug)]
pub struct Setting {
    pub name: String,
    pub space: Arc<dyn Strategy>,
    pub dial: f64,
}

/// The raised hyperbolic map at a dial.
pub fn raised(dial: f64) -> Setting {
    Setting {
        name: format!("raised, dial {dial}"),
        space: picture(Geometry::Hyperbolic, RADIUS_M, HyperbolicMap::Raised, false),
        dial,
    }
}

/// The horizon map at a dial.
pub fn horizon(dial: f64) -> Setting {
    Setting {
        name: format!("horizon, dial {dial}"),
        space: picture(
            Geometry::Hyperbolic,
            RADIUS_M,
            HyperbolicMap::Horizon,
            false,
        ),
        dial,
    }
}

/// A flat world bent by a dial.
pub fn bent(dial: f64) -> Setting {
    Setting {
        name: format!("flat, bent by {dial}"),
        space: picture(Geometry::Euclidean, 0.0, HyperbolicMap::Raised, true),
        dial,
    }
}

/// A sphere of a radius in metres.
pub fn sphere(radius_m: f64) -> Setting {
    Setting {
        name: format!("spherical, R = {radius_m} m"),
        space: picture(Geometry::Spherical, radius_m, HyperbolicMap::Raised, false),
        dial: 0.0,
    }
}

/// Flat space.
pub fn flat() -> Setting {
    Setting {
        name: "euclidean".to_owned(),
        space: picture(Geometry::Euclidean, 0.0, HyperbolicMap::Raised, false),
        dial: 0.0,
    }
}

/// Height of an eye over the feet in metres, for the horizon map.
pub const LIFT_M: f64 = 1.6;
