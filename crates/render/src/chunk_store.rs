//! Keeps the terrain's meshes on the adapter. Each chunk has a mesh that is shown, perhaps one that fades out, and
//! perhaps one that waits to be uploaded.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use antipode_frame::{ChunkChange, Frame, LandCursor};
use antipode_geometry::{Atlas, ChartPoint, ChunkCoord};
use antipode_terrain::{ChunkMesh, Level, Vertex};
use glam::DVec3;

use crate::blend::BlendClock;
use crate::block_sight::BlockSight;
use crate::charts::Charts;
use crate::draw_list::DrawList;
use crate::fallen::Fallen;
use crate::gpu::Gpu;
use crate::lamps::lights_near;
use crate::land_mesh::{LandMesh, SeamMask};
use crate::low_growth::LowGrowth;
use crate::pages::Pages;
use crate::parts::{Block, parts, sections};
use crate::plan::{ChunkLand, FramePlan, LandIndex};
use crate::pressers::Pressers;
use crate::refinements::{Refinement, Refinements};
use crate::renderer::Preset;
use crate::seams;
use crate::shades::Shades;
use crate::shadow::{Caster, Shadows};
use crate::terrain_pipelines::{ShadowReach, TerrainPipelines};
use crate::things::{self, Grown, ThingsLight};
use crate::touched::Touched;
use crate::uniforms::ChunkInstance;

/// Bytes of meshes that a frame sends to the adapter at most, but for one mesh and for edits: at sixty frames a
/// second as much as a player can run up against, and a fraction of a millisecond.
const UPLOAD_BYTES: usize = 2 << 20;

/// Attributes of a terrain vertex, from location 0 on.
pub const VERTEX_ATTRIBUTES: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Uint16x4, 1 => Snorm16x2, 2 => Unorm8x4];
/// Bytes of a terrain vertex.
pub const VERTEX_BYTES: u64 = size_of::<Vertex>() as u64;

/// What is shown of a chunk.
#[derive(Debug)]
pub struct GpuChunk {
    /// Its mesh.
    pub mesh: LandMesh,
    /// What the mesh was made from.
    pub source: Arc<ChunkMesh>,
    /// What the planner knows of it.
    pub land: ChunkLand,
    /// Its refinement, where it is near enough to need one.
    pub refined: Option<Refinement>,
    /// The next one, until those of its neighbours have come as well.
    pub coming: Option<Refinement>,
    /// Whether it had a refinement before it changed, and so needs another at once.
    pub is_urgent: bool,
    /// What stands on it.
    pub grown: Option<Grown>,
    /// What grows low on it, near the eye.
    pub low: Option<LowGrowth>,
    /// The mesh of another level that it follows, for a moment.
    fading: Option<Fading>,
}

/// A mesh that makes way for one of another level.
#[derive(Debug)]
struct Fading {
    mesh: LandMesh,
    level: Level,
    began_s: f32,
}

impl GpuChunk {
    fn drawn(&self) -> &LandMesh {
        match &self.refined {
            Some(Refinement {
                mesh: Some(refined),
                ..
            }) => refined,
            _ => &self.mesh,
        }
    }

    /// The finest level of which something is shown.
    fn finest(&self) -> Level {
        let fading = self.fading.as_ref().map(|fading| fading.level);
        fading.map_or(self.land.level, |level| level.min(self.land.level))
    }

    fn give_back(self, pages: &mut Pages) {
        self.mesh.give_back(pages);
        for refinement in [self.refined, self.coming].into_iter().flatten() {
            refinement.give_back(pages);
        }
        if let Some(fading) = self.fading {
            fading.mesh.give_back(pages);
        }
        if let Some(low) = self.low {
            low.give_back(pages);
        }
        if let Some(grown) = self.grown {
            grown.give_back(pages);
        }
    }
}

/// All chunks.
#[derive(Debug)]
pub struct ChunkStore {
    /// In an order that depends on nothing else.
    pub(crate) chunks: BTreeMap<ChunkCoord, GpuChunk>,
    /// New chunks and new levels that no frame had room for yet.
    waiting: HashMap<ChunkCoord, Arc<ChunkMesh>>,
    /// What falls in the last frame.
    pub(crate) fallen: Vec<Fallen>,
    pub(crate) pages: Pages,
    pub(crate) refinements: Refinements,
    /// The land of `chunks`, until they change.
    land_index: Option<Arc<LandIndex>>,
    clock: BlendClock,
    world: Option<u64>,
    /// How far that world's land has been read.
    cursor: LandCursor,
    /// Land that came, changed or went since somebody asked.
    touched: Vec<Touched>,
    /// Whether the next frame is to be complete, however long that takes.
    pub(crate) rush: bool,
    /// The preset of the last frame.
    pub(crate) preset: Preset,
}

/// What falls on land as it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Shading<'a> {
    /// Shadows of the key light.
    pub shadows: &'a Shadows,
    /// The soft shades below figures.
    pub shades: &'a Shades,
    /// What bends what grows.
    pub pressers: &'a Pressers,
}

impl ChunkStore {
    /// An empty store.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            chunks: BTreeMap::new(),
            waiting: HashMap::new(),
            fallen: Vec::new(),
            pages: Pages::new(&gpu.device, &gpu.queue),
            refinements: Refinements::default(),
            land_index: None,
            clock: BlendClock::default(),
            world: None,
            cursor: LandCursor::default(),
            touched: Vec::new(),
            rush: false,
            preset: Preset::Card,
        }
    }

    /// Takes what is new of the frame's land, dropping everything first when the world is another, and shows as much of what
    /// waits as a frame has room for, the nearest first.
    ///
    /// A mesh of the level that is shown already is an edit. All that comes with an edit is shown at once: an edit
    /// over several chunks appears as a whole.
    pub fn apply(&mut self, frame: &Frame) {
        if self.world != Some(frame.content.loaded_world) {
            self.clear();
            self.world = Some(frame.content.loaded_world);
            self.cursor = LandCursor::default();
        }
        let news = frame.content.land.news(&mut self.cursor);
        if news.starts_over {
            self.clear();
        }
        self.clock.advance(frame.content.time_s);
        if self.rush {
            self.clock.stop();
        }
        self.end_blends();
        let edited = self.edited(&news.changes);
        // What is built may reach into a chunk that was empty; land that streams in elsewhere is no part of the edit.
        let is_near_edit = |coord: &ChunkCoord| {
            let beside = |it: &ChunkCoord| (it.index - coord.index).abs().max_element() <= 1;
            let mut same_chart = edited.iter().filter(|it| it.chart == coord.chart);
            same_chart.any(beside)
        };
        for change in &news.changes {
            match change {
                ChunkChange::Put(coord, mesh) if !mesh.is_empty() => {
                    self.waiting.remove(coord);
                    if self.rush || !edited.is_empty() {
                        self.show(*coord, mesh, is_near_edit(coord));
                    } else {
                        self.waiting.insert(*coord, Arc::clone(mesh));
                    }
                }
                ChunkChange::Put(coord, _) => self.take_away(*coord, is_near_edit(coord)),
                ChunkChange::Remove(coord) => self.take_away(*coord, false),
            }
        }
        self.show_waiting(frame);
    }

    fn take_away(&mut self, coord: ChunkCoord, is_edited: bool) {
        self.waiting.remove(&coord);
        if let Some(gone) = self.chunks.remove(&coord) {
            let of = Caster::of(&gone.land);
            self.touched.push(Touched { of, is_edited });
            self.land_index = None;
            gone.give_back(&mut self.pages);
        }
    }

    fn clear(&mut self) {
        let gone = self.chunks.values().map(|chunk| Touched {
            of: Caster::of(&chunk.land),
            is_edited: false,
        });
        self.touched.extend(gone);
        self.chunks.clear();
        self.land_index = None;
        self.waiting.clear();
        self.fallen.clear();
        self.pages.clear();
        self.refinements.forget();
        self.clock = BlendClock::default();
    }

    /// The chunks whose meshes come again at the level that they have.
    fn edited(&self, changes: &[ChunkChange]) -> Vec<ChunkCoord> {
        let is_edit = |change: &ChunkChange| {
            let ChunkChange::Put(coord, mesh) = change else {
                return None;
            };
            let shown = self.chunks.get(coord).map(|chunk| chunk.land.level);
            let waiting = self.waiting.get(coord).map(|waiting| waiting.level);
            let levels = [shown, waiting];
            levels.contains(&Some(mesh.level)).then_some(*coord)
        };
        changes.iter().filter_map(is_edit).collect()
    }

    fn show_waiting(&mut self, frame: &Frame) {
        if self.waiting.is_empty() {
            return;
        }
        let (strategy, eye) = (&frame.view.strategy, frame.view.eye.point);
        let away_m = |coord: &ChunkCoord| {
            let way = strategy.way_m(eye, ChartPoint::new(coord.chart, coord.centre()));
            way.map_or(f64::INFINITY, DVec3::length)
        };
        let mut order: Vec<_> = self.waiting.keys().map(|c| (away_m(c), *c)).collect();
        order.sort_by(|(a, of), (b, other)| a.total_cmp(b).then(of.cmp(other)));
        let mut left = if self.rush { usize::MAX } else { UPLOAD_BYTES };
        for (_, coord) in order {
            if left == 0 {
                break;
            }
            if let Some(mesh) = self.waiting.remove(&coord) {
                left = left.saturating_sub(bytes(&mesh));
                self.show(coord, &mesh, false);
            }
        }
    }

    /// Shows a mesh from this frame on; it comes with an edit, or not.
    fn show(&mut self, coord: ChunkCoord, mesh: &Arc<ChunkMesh>, is_edited: bool) {
        let parts = parts(&mesh.vertices, sections(mesh), &[]);
        let chunk = GpuChunk {
            mesh: LandMesh::put(&mut self.pages, parts),
            source: Arc::clone(mesh),
            land: ChunkLand::of(coord, mesh),
            refined: None,
            coming: None,
            is_urgent: false,
            grown: None,
            low: None,
            fading: None,
        };
        self.land_index = None;
        let of = Caster::of(&chunk.land);
        let mut old = self.chunks.insert(coord, chunk);
        self.plant(coord, old.as_mut());
        let Some(mut old) = old else {
            self.touched.push(Touched { of, is_edited });
            return;
        };
        if old.land.level == mesh.level {
            self.touched
                .extend(Touched::between(coord, &old.source, mesh));
            let felled = things::changed(coord, &old.source.things, &mesh.things);
            self.touched.extend(felled);
        } else {
            let both = [of, Caster::of(&old.land)];
            let whole = |of| Touched {
                of,
                is_edited: false,
            };
            self.touched.extend(both.map(whole));
        }
        if let Some(new) = self.chunks.get_mut(&coord) {
            new.is_urgent = old.refined.is_some();
            if old.land.level == mesh.level {
                new.fading = old.fading.take();
            } else if self.clock.moves() {
                let refined = old.refined.as_mut().and_then(|refined| refined.mesh.take());
                new.fading = Some(Fading {
                    mesh: refined.unwrap_or_else(|| std::mem::take(&mut old.mesh)),
                    level: old.land.level,
                    began_s: self.clock.now_s(),
                });
            }
        }
        old.give_back(&mut self.pages);
    }

    /// Lets go of what has faded.
    fn end_blends(&mut self) {
        for chunk in self.chunks.values_mut() {
            let clock = &self.clock;
            let is_over = |fading: &mut Fading| clock.progress(fading.began_s).is_none();
            if let Some(faded) = chunk.fading.take_if(is_over) {
                faded.mesh.give_back(&mut self.pages);
            }
        }
    }

    /// The land of every chunk that is shown, in an order that depends on nothing else.
    pub fn land(&mut self) -> Arc<LandIndex> {
        let chunks = self.chunks.values();
        let land_index = || Arc::new(LandIndex::new(chunks.map(|chunk| chunk.land).collect()));
        Arc::clone(self.land_index.get_or_insert_with(land_index))
    }

    /// Whether meshes wait to be shown or are being refined.
    pub fn is_busy(&self) -> bool {
        !self.waiting.is_empty() || self.refinements.is_busy()
    }

    /// Lets the next frame bring everything up to date.
    pub fn rush(&mut self) {
        self.rush = true;
    }

    /// The next frame has all the time that it needs, if that was asked for; asking clears it.
    pub fn end_rush(&mut self) {
        self.rush = false;
    }

    /// How many chunks are shown.
    pub fn len(&self) -> usize {
        self.chunks.len()
    }

    /// Bytes of the adapter's memory that the meshes lie in.
    pub fn bytes(&self) -> u64 {
        self.pages.bytes()
    }

    /// The pages that the meshes lie in.
    pub fn pages(&self) -> &Pages {
        &self.pages
    }

    /// Land that came, changed or went since this was last asked.
    pub fn take_touched(&mut self) -> Vec<Touched> {
        std::mem::take(&mut self.touched)
    }

    /// All chunks as what throws shadows, in an order that depends on nothing else.
    pub fn casters(&self) -> impl Iterator<Item = (ChunkCoord, Caster)> {
        let caster = |(coord, chunk): (&ChunkCoord, &GpuChunk)| (*coord, Caster::of(&chunk.land));
        self.chunks.iter().map(caster)
    }

    /// Adds a chunk's mesh, as it was authored, with its seams and what stands on it to a list, for a map whose matrix begins at
    /// a place of the chart; returns its triangles.
    pub fn list_caster(
        &self,
        atlas: &dyn Atlas,
        coord: ChunkCoord,
        chart: u32,
        from: DVec3,
        list: &mut DrawList,
    ) -> usize {
        let Some(chunk) = self.chunks.get(&coord) else {
            return 0;
        };
        let seams = self.seams(atlas, coord, chunk.land.level, &chunk.mesh);
        let pieces = chunk.mesh.pieces(seams).map(|piece| (0, piece));
        list.add(chart, ChunkInstance::new(coord.origin(), from), pieces);
        let things = chunk.grown.as_ref();
        chunk.land.triangles + things.map_or(0, |it| it.list_caster(coord, chart, from, list))
    }

    /// What a chunk's mesh takes over from, and how far it has; none where that is done with.
    fn blend<'a>(&self, chunk: &'a GpuChunk) -> Option<(&'a Fading, f32)> {
        let fading = chunk.fading.as_ref()?;
        Some((fading, self.clock.progress(fading.began_s)?))
    }

    /// Lists the chosen chunks in order, with the seams that are needed beside what is finer.
    pub fn list(
        &self,
        frame: &Frame,
        land: &[ChunkLand],
        plan: &mut FramePlan,
        shading: Shading<'_>,
        list: &mut DrawList,
        charts: &mut Charts,
    ) {
        let shadows = shading.shadows;
        list.clear();
        self.list_fallen(frame, list, charts);
        let sight = BlockSight::of(frame);
        for choice in &plan.chunks {
            let coord = land[choice.place].coord;
            let Some(chunk) = self.chunks.get(&coord) else {
                continue;
            };
            let chart = charts.number(coord.chart);
            let lights = lights_near(frame, coord.chart, chunk.land.min, chunk.land.max);
            let reach = shadows.reach(frame, &Caster::of(&chunk.land));
            let instance = ChunkInstance::of(frame, coord, &choice.port)
                .shaded(shading.shades.on(&chunk.land), reach == ShadowReach::All)
                .lit(lights, chunk.land.level);
            let bent = shading.pressers.on(frame, &chunk.land);
            let light = ThingsLight::of(self.preset, shadows, reach, lights).bent_by(bent);
            plan.stats.triangles_outside += chunk.list_growth(&sight, choice, light, list, chart);
            if !choice.shows_land {
                continue;
            }
            let mesh = chunk.drawn();
            let atlas = &*frame.view.strategy;
            let seams = self.seams(atlas, coord, chunk.land.level, mesh);
            let Some((old, progress)) = self.blend(chunk) else {
                let numbered = |reach| TerrainPipelines::number(choice, false, reach, lights);
                let seen = |block: &Block| {
                    let of = sight.shown(coord, block)?;
                    Some(numbered(shadows.reach_within(frame, reach, &of)))
                };
                let whole = numbered(shadows.told_apart(reach));
                let (pieces, left_out) = mesh.pieces_seen(seams, whole, seen);
                plan.stats.triangles_outside += left_out;
                list.add(chart, instance, pieces.into_iter());
                continue;
            };
            plan.stats.chunks_blending += 1;
            let number = TerrainPipelines::number(choice, true, shadows.told_apart(reach), lights);
            let before = old
                .mesh
                .pieces(self.seams(atlas, coord, old.level, &old.mesh));
            let comes = mesh.pieces(seams).map(|piece| (number, piece));
            list.add(chart, instance.blending(progress), comes);
            let goes = before.map(|piece| (number, piece));
            list.add(chart, instance.blending(-progress), goes);
        }
    }

    fn seams(
        &self,
        atlas: &dyn Atlas,
        coord: ChunkCoord,
        level: Level,
        mesh: &LandMesh,
    ) -> SeamMask {
        if level == Level::FULL || !mesh.has_seams() {
            return 0;
        }
        seams::mask(atlas, coord, level, |other| {
            self.chunks.get(&other).map(GpuChunk::finest)
        })
    }
}

/// Bytes that a mesh takes on the adapter.
fn bytes(mesh: &ChunkMesh) -> usize {
    size_of_val(mesh.vertices.as_slice()) + mesh.indices.len() * size_of::<u16>()
}

#[cfg(test)]
mod tests;
