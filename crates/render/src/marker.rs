//! What shows where tools work: a thin ring on the land about what is dug or built, and a small ball where the lamp in
//! hand would hang.

use antipode_frame::{Frame, Marker, MarkerShape};
use antipode_geometry::ChartPoint;
use glam::{DMat3, DVec3, DVec4};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass, RenderPipeline};

use crate::ball::ball;
use crate::charts::{Charts, offset_of};
use crate::draw_list::DrawCount;
use crate::uniforms::MarkerInstance;

/// The inner ball's radius as a share of the outer's.
const BALL_SHARE: f64 = 0.2;
/// Linear light of the ball.
const BALL: [f32; 3] = [1.6, 1.6, 1.6];
/// Opacity of the inner ball, face on and edge on; then of the outer.
const BALL_OPACITY: (f32, f32) = (0.7, 1.0);
const SHELL_OPACITY: (f32, f32) = (0.0, 0.7);
/// Linear light of the ring by day, and how dark its edges are.
const RING: ([f32; 3], f32) = ([1.25, 0.52, 0.12], 0.0);
/// The same for eyes that see few colours: white between black edges.
const SAFE_RING: ([f32; 3], f32) = ([1.6, 1.6, 1.6], 0.97);
/// Least light of the ring, so that it is seen in the darkest night.
const LEAST_LIGHT: f32 = 0.3;
const RINGS: u16 = 20;
const SIDES: u16 = 32;

/// A unit sphere on the adapter and this frame's ball.
#[derive(Debug)]
pub struct MarkerBalls {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    instances: Buffer,
    /// The number of its chart, where it is shown.
    shown: Option<u32>,
}

impl MarkerBalls {
    /// Uploads the sphere.
    pub fn new(device: &Device) -> Self {
        let (positions, triangles) = ball(RINGS, SIDES);
        let vertices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("marker vertices"),
            contents: bytemuck::cast_slice(&positions),
            usage: BufferUsages::VERTEX,
        });
        let indices = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("marker indices"),
            contents: bytemuck::cast_slice(&triangles),
            usage: BufferUsages::INDEX,
        });
        let instances = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("marker"),
            size: 2 * size_of::<MarkerInstance>() as u64,
            usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self {
            vertices,
            indices,
            index_count: triangles.len() as u32,
            instances,
            shown: None,
        }
    }

    /// Takes this frame's ball.
    pub fn prepare(&mut self, queue: &Queue, frame: &Frame, charts: &mut Charts) {
        let marker = frame.marker();
        let ball = marker.filter(|marker| marker.shape == MarkerShape::Ball);
        self.shown = ball.map(|marker| charts.number(marker.point.chart));
        if let Some(marker) = ball {
            queue.write_buffer(
                &self.instances,
                0,
                bytemuck::cast_slice(&balls(frame, &marker)),
            );
        }
    }

    /// Draws both balls by some pipelines, if they are to be seen; returns what that took.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        charts: &Charts,
        pipelines: [&RenderPipeline; 2],
    ) -> DrawCount {
        let Some(chart) = self.shown else {
            return DrawCount::default();
        };
        charts.bind(pass, chart);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        for pipeline in pipelines {
            pass.set_pipeline(pipeline);
            pass.draw_indexed(0..self.index_count, 0, 0..2);
        }
        DrawCount {
            triangles: self.index_count as usize / 3 * 4,
            draws: 2,
        }
    }
}

/// How bright the ring is for the light of the moment: as bright as by day it would be a lamp at night.
fn light_of(frame: &Frame) -> f32 {
    let sky = &frame.content.sky;
    let [ambient, key] = [sky.ambient_sky, sky.key_colour].map(|c| c.iter().sum::<f32>() / 3.0);
    (1.3 * ambient + 0.5 * key).clamp(LEAST_LIGHT, 1.0)
}

/// The ring about what is dug or built, as the shaders are told of it; all zero where there is none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ring {
    /// Its middle: metres from the reference in the common axes, or where charts have no axes in common view coordinates.
    pub centre: [f32; 4],
    /// Its light.
    pub light: [f32; 3],
    /// Its radius in metres of the chart.
    pub radius_m: f32,
    /// How dark its edges are, 0 to 1.
    pub edges: f32,
    /// As what the land within it is shown: the linear light of a kind and its number; all zero as it is.
    pub ground: [f32; 4],
    /// There, metres of the chart along x, y and z for a difference in view coordinates.
    pub axes: [[f32; 4]; 3],
}

impl Ring {
    /// That of a frame's marker.
    pub fn of(frame: &Frame) -> Self {
        let marker = frame.marker();
        let Some(marker) = marker.filter(|marker| marker.shape != MarkerShape::Ball) else {
            return Self::default();
        };
        let safe = marker.shape == MarkerShape::SafeRing;
        let ((colour, edges), light) = if safe {
            (SAFE_RING, 1.0)
        } else {
            (RING, light_of(frame))
        };
        let offset = offset_of(frame, marker.point);
        let offset = frame.view.in_common_axes(marker.point.chart, offset);
        let by_view = !frame.view.strategy.shader().daylight.has_axes;
        let middle = frame.view.point(marker.point);
        Self {
            centre: if by_view {
                middle.as_vec4().into()
            } else {
                offset.as_vec3().extend(0.0).into()
            },
            light: colour.map(|channel| channel * light),
            radius_m: marker.radius_m as f32,
            edges,
            ground: marker.ground.map_or([0.0; 4], |kind| {
                let [r, g, b, _] = kind.tint();
                [r, g, b, f32::from(kind.byte())]
            }),
            axes: if by_view {
                chart_axes(frame, marker.point)
            } else {
                [[0.0; 4]; 3]
            },
        }
    }
}

/// For how far a point lies from a place in view coordinates, its metres of the chart along each axis.
///
/// With the columns J of the port's derivative and the model's metric W = diag(1, 1, 1, s R^2), s the sign of the curvature, these are the rows of
/// (J^T W J)^-1 J^T W, the projection onto the columns. A chord loses to its arc a sixth of the square of their angle.
fn chart_axes(frame: &Frame, middle: ChartPoint) -> [[f32; 4]; 3] {
    const STEP_M: f64 = 1e-3;
    let strategy = &*frame.view.strategy;
    let it = strategy.curvature();
    let weights = DVec4::new(1.0, 1.0, 1.0, it.sign * it.radius_m.powi(2));
    let column = |axis: DVec3| {
        let at = |by_m: f64| frame.view.point(middle.moved(axis * by_m));
        (at(STEP_M) - at(-STEP_M)) / (2.0 * STEP_M)
    };
    let columns = DVec3::AXES.map(column);
    let products = columns.map(|a| columns.map(|b| (weights * a).dot(b)));
    let inverse = DMat3::from_cols_array_2d(&products).inverse();
    [0, 1, 2].map(|i| {
        let row = inverse.col(i);
        let sum = columns[0] * row.x + columns[1] * row.y + columns[2] * row.z;
        (weights * sum).as_vec4().into()
    })
}

fn balls(frame: &Frame, marker: &Marker) -> [MarkerInstance; 2] {
    let [r, g, b] = BALL;
    let of_radius = |radius_m: f64, (face, edge): (f32, f32)| MarkerInstance {
        offset: offset_of(frame, marker.point).as_vec3().into(),
        colour: [r, g, b, face],
        shape: [radius_m as f32, edge, 0.0, 0.0],
    };
    [
        of_radius(marker.radius_m, SHELL_OPACITY),
        of_radius(marker.radius_m * BALL_SHARE, BALL_OPACITY),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_colours_the_ring_is_white_between_edges_that_are_black() {
        let ([r, g, b], edges) = SAFE_RING;
        assert!(r == g && g == b && r > 1.0 && edges > 0.9);
        let ([r, g, b], edges) = RING;
        assert!(r > g && g > b && edges == 0.0);
    }
}
