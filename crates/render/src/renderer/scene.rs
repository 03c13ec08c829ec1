//! What the scene's shaders are told of a frame and read from, and the passes into the shadow maps before theirs.

use antipode_frame::Frame;
use wgpu::{BindGroup, BindGroupLayout, Buffer, CommandEncoder, Device};

use super::{DrawStats, Renderer};
use crate::heavens::Heavens;
use crate::pipelines::scene_layout;
use crate::plan::FramePlan;
use crate::shadow::Shadows;
use crate::uniforms::SceneUniform;

impl Renderer {
    /// Takes the figures, plans the passes into the shadow maps, and tells the shaders of the frame. Which figures there
    /// are depends on what the map of their shadows is a picture of, and that on the maps of land.
    pub(super) fn prepare_figures(
        &mut self,
        frame: &Frame,
        plan: &mut FramePlan,
        drawn: (u32, u32),
    ) {
        let is_new = self.shadows.prepare(frame, &mut self.chunks);
        let map = self.shadows.figures_shot(frame);
        let adapter = (&self.device, &self.queue);
        self.figures.prepare(adapter, frame, plan, map);
        let rooms = self.figures.rooms();
        self.shadows.prepare_figures(frame, map, rooms);
        if is_new {
            let layout = scene_layout(&self.device);
            let extras = (&self.heavens, &self.shadows);
            self.scene_bindings = bind_scene(&self.device, &layout, &self.uniform, extras);
        }
        let scene = SceneUniform::new(frame, drawn, &self.shadows.uniform(frame));
        self.queue
            .write_buffer(&self.uniform, 0, bytemuck::bytes_of(&scene));
    }

    /// Draws into the shadow maps; tells whether the frame's first stamp was written.
    pub(super) fn draw_shadows(
        &self,
        map: u32,
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) -> bool {
        let Some(pipelines) = self.pipelines.get(map) else {
            return false;
        };
        let timing = self.timing.as_ref();
        let (drawn, stamped) =
            self.shadows
                .draw(encoder, pipelines, &self.chunks, &self.figures, timing);
        stats.shadows = drawn;
        stamped
    }
}

/// What the scene's shaders read.
pub(super) fn bind_scene(
    device: &Device,
    layout: &BindGroupLayout,
    uniform: &Buffer,
    (heavens, shadows): (&Heavens, &Shadows),
) -> BindGroup {
    let uniform = wgpu::BindGroupEntry {
        binding: 0,
        resource: uniform.as_entire_binding(),
    };
    let entries: Vec<_> = std::iter::once(uniform)
        .chain(heavens.bind())
        .chain(shadows.bind())
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("scene"),
        layout,
        entries: &entries,
    })
}
