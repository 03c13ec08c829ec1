//! The brush marker: a small ball at the point aimed at and the faint shell of the brush's reach.

use antipode_scene::frame::{Frame, Marker};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass};

use crate::ball::ball;
use crate::uniforms::{MarkerInstance, hemisphere_index, offset_of};

/// The ball's radius as a share of the brush's.
const BALL_SHARE: f64 = 0.2;
/// Linear light of the marker at rest, and while it digs or builds.
const AT_REST: [f32; 3] = [0.55, 0.85, 1.0];
const AT_WORK: [f32; 3] = [1.25, 0.52, 0.12];
/// The same for eyes that see few colours: white, and black.
const SAFE_AT_REST: [f32; 3] = [1.6, 1.6, 1.6];
const SAFE_AT_WORK: [f32; 3] = [0.01, 0.01, 0.01];
/// Opacity of the ball, face on and edge on; then of the shell.
const BALL_OPACITY: (f32, f32) = (0.08, 0.9);
const SHELL_OPACITY: (f32, f32) = (0.0, 0.30);
/// The same where lightness alone must tell: less of the land shines through.
const SAFE_BALL_OPACITY: (f32, f32) = (0.7, 1.0);
const SAFE_SHELL_OPACITY: (f32, f32) = (0.0, 0.7);
/// Rate of the glow while at work, radians per second.
const PULSE_RAD_S: f32 = 9.0;
/// Least light of the marker, so that it is seen in the darkest night.
const LEAST_LIGHT: f32 = 0.3;
const RINGS: u16 = 20;
const SIDES: u16 = 32;

/// A unit sphere on the adapter and this frame's marker.
#[derive(Debug)]
pub struct MarkerBalls {
    vertices: Buffer,
    indices: Buffer,
    index_count: u32,
    instances: Buffer,
    shown: bool,
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
            shown: false,
        }
    }

    /// Takes this frame's marker.
    pub fn prepare(&mut self, queue: &Queue, frame: &Frame) {
        self.shown = frame.marker.is_some();
        if let Some(marker) = &frame.marker {
            queue.write_buffer(
                &self.instances,
                0,
                bytemuck::cast_slice(&balls(frame, marker)),
            );
        }
    }

    /// Whether there is a marker to draw.
    pub fn shown(&self) -> bool {
        self.shown
    }

    /// Draws both balls; returns triangles and draw calls.
    pub fn draw(&self, pass: &mut RenderPass<'_>) -> (usize, usize) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed(0..self.index_count, 0, 0..2);
        (self.index_count as usize / 3 * 2, 1)
    }
}

/// How bright the marker is for the light of the moment: as bright as by day it would be a lamp at night.
fn light_of(frame: &Frame) -> f32 {
    let sky = &frame.sky;
    let [ambient, key] = [sky.ambient_sky, sky.key_colour].map(|c| c.iter().sum::<f32>() / 3.0);
    (1.3 * ambient + 0.5 * key).clamp(LEAST_LIGHT, 1.0)
}

fn balls(frame: &Frame, marker: &Marker) -> [MarkerInstance; 2] {
    let glow = if marker.active && !marker.still {
        1.0 + 0.25 * (frame.time_s * PULSE_RAD_S).sin()
    } else {
        1.0
    };
    let colour = match (marker.by_lightness, marker.active) {
        (false, false) => AT_REST,
        (false, true) => AT_WORK,
        (true, false) => SAFE_AT_REST,
        (true, true) => SAFE_AT_WORK,
    };
    let light = if marker.by_lightness {
        1.0
    } else {
        light_of(frame)
    };
    let [r, g, b] = colour.map(|channel| channel * glow * light);
    let (shell, core) = if marker.by_lightness {
        (SAFE_SHELL_OPACITY, SAFE_BALL_OPACITY)
    } else {
        (SHELL_OPACITY, BALL_OPACITY)
    };
    let of_radius = |radius_m: f64, (face, edge): (f32, f32)| MarkerInstance {
        offset: offset_of(frame, marker.point),
        hemisphere: hemisphere_index(marker.point.hemisphere),
        colour: [r, g, b, face],
        shape: [radius_m as f32, edge, 0.0, 0.0],
    };
    [
        of_radius(marker.radius_m, shell),
        of_radius(marker.radius_m * BALL_SHARE, core),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance by the weights of BT.709.
    fn luminance([r, g, b]: [f32; 3]) -> f32 {
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn without_colours_rest_and_work_differ_as_black_from_white() {
        for colour in [SAFE_AT_REST, SAFE_AT_WORK] {
            assert!(
                colour[0] == colour[1] && colour[1] == colour[2],
                "{colour:?} has a hue"
            );
        }
        let (rest, work) = (luminance(SAFE_AT_REST), luminance(SAFE_AT_WORK));
        // The contrast of the Web Content Accessibility Guidelines, 7 being their highest demand.
        assert!((rest + 0.05) / (work + 0.05) > 7.0);
        let usual = (luminance(AT_REST) + 0.05) / (luminance(AT_WORK) + 0.05);
        assert!(usual < 7.0, "told by hue: {usual}");
    }
}
