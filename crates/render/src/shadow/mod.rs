//! Shadows of the key light: maps of depth as the light sees the land and the figures.
//!
//! A map of land is drawn anew only when the light has turned by more than its texels show, when the eye has left its
//! middle, or when land on it has changed. Each frame draws a part of it into another layer, which replaces the old
//! one when it is complete. Figures move all the time, so they have a map of their own, which covers what is near.

mod caster;
mod casting;
mod ideal;
mod levels;
mod light;
mod making;
mod maps;
mod mending;
mod uniform;

use antipode_frame::Frame;
use wgpu::{Backend, CommandEncoder, Device, Queue};

pub use caster::Caster;
pub use levels::Shot;
use levels::{Level, count};
use light::Crop;
pub use light::{Light, key_body};
use making::Job;
use maps::{Maps, PASSES};
pub use maps::{caster_layout, scene_entries};
#[cfg(test)]
pub(crate) use uniform::CasterUniform;
use uniform::FIGURES;
pub(crate) use uniform::MapUniform;
pub use uniform::ShadowUniform;

use crate::charts::Charts;
use crate::chunk_store::ChunkStore;
use crate::draw_list::{DrawList, LandDraws};
use crate::figure_buffers::Statics;
use crate::figure_draws::FigureDraws;
use crate::gpu::Gpu;
use crate::pages::Pages;
use crate::pipelines::Pipelines;
use crate::timing::Timing;
use crate::touched::Touched;

/// How shadows are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ShadowQuality {
    /// Not at all.
    #[default]
    Off,
    /// As a processor can.
    Low,
    /// Finer and softer.
    High,
}

impl ShadowQuality {
    /// `SHADOWS` of shadow.wgsl.
    pub fn number(self) -> u32 {
        match self {
            Self::Off => 0,
            Self::Low => 1,
            Self::High => 2,
        }
    }

    /// Texels of a map's side; more maps are smaller.
    fn texels(self, maps: usize) -> u32 {
        let few = maps <= levels::CASCADES;
        match (self, few) {
            (Self::Off, _) => 1,
            (Self::Low, _) | (Self::High, false) => 1024,
            (Self::High, true) => 2048,
        }
    }

    /// Triangles of land that a frame draws into maps at most, but for one mesh.
    fn triangles_a_frame(self) -> usize {
        match self {
            Self::Off => 0,
            Self::Low => 2_000,
            Self::High => 400_000,
        }
    }
}

/// A map that the light has turned away from by this much tells nothing, radians; from half of that on it fades.
const OUT_OF_DATE_RAD: f64 = 0.06;

/// Maps that can be in the making at once.
const SLOTS: usize = 2;

/// What maps are drawn from, and where the charts of what is drawn are numbered.
#[derive(Debug)]
struct ShadowSources<'a> {
    chunks: &'a ChunkStore,
    charts: &'a mut Charts,
}

/// What is drawn into a layer of the maps.
#[derive(Clone, Copy, Debug)]
struct MapTarget<'a> {
    shot: &'a Shot,
    layer: u32,
}

/// What throws shadows in a frame.
#[derive(Clone, Copy, Debug)]
pub struct Casters<'a> {
    /// The land's buffers.
    pub pages: &'a Pages,
    /// The charts of what is drawn.
    pub charts: &'a Charts,
    /// The figures.
    pub figures: &'a FigureDraws,
    /// Their models.
    pub models: &'a Statics,
}

/// A pass of this frame over land.
#[derive(Clone, Copy, Debug)]
struct Pass {
    layer: u32,
    over: Over,
}

/// What a pass draws over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Over {
    /// A new map.
    Nothing,
    /// What is on the map.
    Map,
    /// The same, but for a rectangle that is drawn anew: its first texel and how many there are along each side.
    Hole([u32; 4]),
}

/// The maps and what is on them.
#[derive(Debug)]
pub struct Shadows {
    device: Device,
    queue: Queue,
    quality: ShadowQuality,
    /// Whether the adapter copies depth: what wgpu has for OpenGL does not.
    copies: bool,
    maps: Maps,
    levels: Vec<Level>,
    /// What is in the making, and the layer that it is drawn into: of the finest map, which shows at once what is
    /// dug, and of one of the others.
    jobs: [Option<Job>; SLOTS],
    spares: [u32; SLOTS],
    passes: Vec<Pass>,
    lists: Vec<(DrawList, LandDraws)>,
    figures: Option<Shot>,
    /// What of the map each figure on it may shade, and the height towards the light up to which it does, where they
    /// have a map of their own.
    rooms: Vec<(Crop, f64)>,
    /// The world that is on the maps.
    world: Option<u64>,
    busy: bool,
}

/// What drawing the maps took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ShadowStats {
    /// Triangles drawn into maps.
    pub triangles: usize,
    /// Passes over land.
    pub passes: usize,
}

impl Shadows {
    /// Maps of a quality, with nothing on them.
    pub fn new(gpu: &Gpu, quality: ShadowQuality) -> Self {
        Self {
            device: gpu.device.clone(),
            queue: gpu.queue.clone(),
            quality,
            copies: gpu.adapter.get_info().backend != Backend::Gl,
            maps: Maps::new(&gpu.device, 1, 1),
            levels: Vec::new(),
            jobs: [const { None }; SLOTS],
            spares: [0; SLOTS],
            passes: Vec::new(),
            lists: (0..PASSES - 1)
                .map(|_| (DrawList::default(), LandDraws::new(gpu)))
                .collect(),
            figures: None,
            rooms: Vec::new(),
            world: None,
            busy: false,
        }
    }

    /// Draws with another quality from the next frame on.
    pub fn set_quality(&mut self, quality: ShadowQuality) {
        if quality != self.quality {
            self.quality = quality;
            self.forget();
        }
    }

    /// Draws each mesh by a call of its own from now on.
    pub fn draw_singly(&mut self) {
        for (_, draws) in &mut self.lists {
            draws.draw_singly();
        }
    }

    /// Whether maps are out of date for want of time.
    pub fn is_busy(&self) -> bool {
        self.busy
    }

    fn forget(&mut self) {
        self.busy = false;
        self.levels.clear();
        self.jobs = [const { None }; SLOTS];
    }

    /// What the scene's group has of them: [`scene_entries`].
    pub fn bind(&self) -> [wgpu::BindGroupEntry<'_>; 2] {
        [
            wgpu::BindGroupEntry {
                binding: 2,
                resource: wgpu::BindingResource::TextureView(&self.maps.all),
            },
            wgpu::BindGroupEntry {
                binding: 3,
                resource: wgpu::BindingResource::Sampler(&self.maps.sampler),
            },
        ]
    }

    /// Plans this frame's passes over land; `true` where what [`Shadows::bind`] gives is other than before. In a rush
    /// all maps are brought to just what the frame wants. [`Shadows::prepare_figures`] is to follow.
    pub fn prepare(&mut self, frame: &Frame, chunks: &mut ChunkStore, charts: &mut Charts) -> bool {
        let touched = chunks.take_touched();
        let land = &mut ShadowSources { chunks, charts };
        if self.world.replace(frame.content.loaded_world) != Some(frame.content.loaded_world) {
            self.jobs = [const { None }; SLOTS];
            self.levels.iter_mut().for_each(|level| level.shot = None);
        }
        self.passes.clear();
        self.figures = None;
        self.rooms.clear();
        if self.quality == ShadowQuality::Off {
            return self.fit(0);
        }
        let light = Light::of(frame);
        let is_new = self.fit(count(&light, self.quality == ShadowQuality::High));
        for level in &mut self.levels {
            level.changed = level.changed.map(|frames| frames.saturating_add(1));
        }
        let left = if land.chunks.rush {
            self.jobs = [const { None }; SLOTS];
            self.note_all(frame, &touched);
            usize::MAX
        } else {
            let mended = self.follow(frame, land, &touched);
            self.quality
                .triangles_a_frame()
                .saturating_sub(mended)
                .max(1)
        };
        self.make(frame, &light, land, left);
        is_new
    }

    /// Whether figures are drawn over a copy of the only map of land, so that one is read and not two: in a closed world
    /// in software, where reading is most of what shadows cost.
    fn merges(&self) -> bool {
        self.copies && self.levels.len() == 1
    }

    /// The layer that figures are drawn into.
    fn figures_layer(&self) -> u32 {
        (self.levels.len() + SLOTS) as u32
    }

    /// Has so many maps of land, or none.
    fn fit(&mut self, count: usize) -> bool {
        let (texels, layers) = if count == 0 {
            (1, 1)
        } else {
            (self.quality.texels(count), (count + SLOTS) as u32 + 1)
        };
        if self.levels.len() == count && self.maps.texels == texels {
            return false;
        }
        self.forget();
        self.maps = Maps::new(&self.device, texels, layers);
        let level = |layer| Level {
            layer,
            shot: None,
            changed: None,
            is_mended: false,
        };
        self.levels = (0..count as u32).map(level).collect();
        self.spares = [count as u32, count as u32 + 1];
        true
    }

    fn note_all(&mut self, frame: &Frame, touched: &[Touched]) {
        for level in &mut self.levels {
            for it in touched {
                level.note(frame, &it.of);
            }
        }
    }

    /// What the scene's shaders are told.
    pub fn uniform(&self, frame: &Frame) -> ShadowUniform {
        let mut uniform = ShadowUniform::default();
        if self.quality == ShadowQuality::Off {
            return uniform;
        }
        let (texels, light) = (self.maps.texels, Light::of(frame));
        uniform.strength = frame.content.sky.key_shadow;
        uniform.side_texels = texels as f32;
        uniform.texel = 1.0 / texels as f32;
        uniform.by_moon = if is_closed_moon(frame) { 1.0 } else { 0.0 };
        for (level, map) in self.levels.iter().zip(&mut uniform.maps) {
            if let Some(shot) = &level.shot {
                let late = shot.light.turn_to(&light, &frame.view) / OUT_OF_DATE_RAD;
                let weight = (2.0 - 2.0 * late).clamp(0.0, 1.0);
                *map = MapUniform::new(frame, shot, level.layer, texels, weight);
            }
        }
        if let Some(shot) = &self.figures {
            let layer = self.figures_layer();
            if self.merges() {
                uniform.maps[0].lie_in(layer);
            } else {
                uniform.maps[FIGURES] = MapUniform::new(frame, shot, layer, texels, 1.0);
            }
        }
        uniform
    }

    /// Draws what was planned. `timing` stamps the first pass; tells whether one was stamped.
    pub fn draw(
        &self,
        encoder: &mut CommandEncoder,
        pipelines: &Pipelines,
        casters: Casters<'_>,
        mut timing: Option<&Timing>,
    ) -> (ShadowStats, bool) {
        let Casters {
            pages,
            charts,
            figures,
            models,
        } = casters;
        let mut stats = ShadowStats::default();
        let stamps = timing.is_some();
        for (number, (planned, (list, draws))) in self.passes.iter().zip(&self.lists).enumerate() {
            let layer = planned.layer;
            let is_fresh = planned.over == Over::Nothing;
            let begun = self
                .maps
                .begin(encoder, number, layer, is_fresh, timing.take());
            if let Some(mut pass) = begun {
                charts.bind(&mut pass, 0);
                if let Over::Hole([x, y, width, height]) = planned.over {
                    pass.set_scissor_rect(x, y, width, height);
                    pass.set_pipeline(&pipelines.hole);
                    pass.draw(0..3, 0..1);
                }
                let drawn = draws.draw(&mut pass, list, charts, pages, |_| &pipelines.caster);
                stats.triangles += drawn.triangles;
                stats.passes += 1;
            }
        }
        if self.figures.is_some() {
            let layer = self.figures_layer();
            let merges = self.merges();
            if merges {
                self.maps.copy(encoder, self.levels[0].layer, layer);
            }
            let begun = self
                .maps
                .begin(encoder, PASSES - 1, layer, !merges, timing.take());
            if let Some(mut pass) = begun {
                let coarse = self.quality == ShadowQuality::Low;
                stats.triangles +=
                    figures.draw_shadows(&mut pass, models, charts, &pipelines.figures, coarse);
            }
        }
        (stats, stamps && timing.is_none())
    }
}

/// Whether it is the moon of a closed world that throws shadows.
fn is_closed_moon(frame: &Frame) -> bool {
    frame.content.sky.orbs.is_some()
        && frame.content.sky.key_direction != frame.content.sky.sun_direction
}
