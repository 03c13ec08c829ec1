//! The calls that draw a frame's land, and their buffers on the adapter.
//!
//! Where the adapter can, one call draws everything that one pipeline draws from one page; the arguments lie in a
//! buffer. OpenGL may not be able to, and gets a call for each piece. Either way what is nearer comes first, strictly
//! where a handful of calls allows it and by bands of distance otherwise: what is drawn first hides later pieces before
//! they are shaded.

use antipode_terrain::Vertex;
use wgpu::util::DrawIndexedIndirectArgs;
use wgpu::{
    Buffer, BufferUsages, Device, DownlevelFlags, Features, IndexFormat, Queue, RenderPass,
};

use crate::charts::Charts;
use crate::gpu::Gpu;
use crate::land_mesh::Piece;
use crate::pages::Pages;
use crate::uniforms::ChunkInstance;

/// What must be there for calls whose arguments lie in a buffer and name their instance.
pub const MULTI_DRAW_FEATURES: Features = Features::INDIRECT_FIRST_INSTANCE;

/// Calls that are worth a strict order, nearest first, and for each chart where there are many. Where there are more, the
/// order is let go step by step, and in the end there is one call for each pipeline, page and chart.
const FEW_CALLS: usize = 16;
const FEW_CALLS_A_CHART: usize = 4;
/// Bands of so many meshes, as a power of two, hold all that there are.
const WIDEST_BAND: u32 = 16;

/// What was sent to be drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DrawCount {
    /// Triangles.
    pub triangles: usize,
    /// Calls to the adapter that draw something.
    pub draws: usize,
}

/// One piece of land to be drawn.
#[derive(Clone, Copy, Debug)]
struct Draw {
    /// The pipeline's number.
    pipeline: u8,
    page: usize,
    /// The chart's number among those of the view.
    chart: u32,
    args: DrawIndexedIndirectArgs,
}

impl Draw {
    /// What one call may draw together.
    fn batch(&self) -> (u8, usize, u32) {
        (self.pipeline, self.page, self.chart)
    }
}

/// Everything to be drawn, and where it stands.
#[derive(Debug, Default)]
pub struct DrawList {
    instances: Vec<ChunkInstance>,
    draws: Vec<Draw>,
}

impl DrawList {
    /// Nothing.
    pub fn clear(&mut self) {
        self.instances.clear();
        self.draws.clear();
    }

    /// Adds the pieces of a mesh that stands at `instance` in the chart of a number, each with its pipeline's number.
    /// Meshes are to be added nearest first.
    pub fn add(
        &mut self,
        chart: u32,
        instance: ChunkInstance,
        pieces: impl Iterator<Item = (u8, Piece)>,
    ) {
        let first_instance = self.instances.len() as u32;
        self.instances.push(instance);
        self.draws.extend(pieces.map(|(pipeline, piece)| Draw {
            pipeline,
            page: piece.page,
            chart,
            args: DrawIndexedIndirectArgs {
                first_instance,
                ..piece.args
            },
        }));
    }

    /// Brings together what one call can draw: within bands of 1, 4, 16... meshes, the first that make few calls.
    fn sort(&mut self) {
        let charts = self.draws.iter().map(|draw| draw.chart + 1).max();
        let few = FEW_CALLS.max(FEW_CALLS_A_CHART * charts.unwrap_or(0) as usize);
        for band in (0..=WIDEST_BAND).step_by(2) {
            self.draws.sort_by_key(|draw| {
                let place = draw.args.first_instance;
                (place >> band, draw.batch(), place)
            });
            if self.batches().count() <= few {
                return;
            }
        }
    }

    /// What one call each can draw.
    fn batches(&self) -> impl Iterator<Item = &[Draw]> {
        self.draws.chunk_by(|a, b| a.batch() == b.batch())
    }

    /// Triangles of everything.
    fn triangles(&self) -> usize {
        let indices = |draw: &Draw| draw.args.index_count as usize;
        self.draws.iter().map(indices).sum::<usize>() / 3
    }
}

/// Instances and arguments on the adapter.
#[derive(Debug)]
pub struct LandDraws {
    device: Device,
    multi: bool,
    instances: Buffer,
    arguments: Buffer,
}

impl LandDraws {
    /// Buffers for a handful of draws.
    pub fn new(gpu: &Gpu) -> Self {
        let flags = gpu.adapter.get_downlevel_capabilities().flags;
        let multi = gpu.device.features().contains(MULTI_DRAW_FEATURES)
            && flags.contains(DownlevelFlags::INDIRECT_EXECUTION);
        Self::with(gpu.device.clone(), multi)
    }

    fn with(device: Device, multi: bool) -> Self {
        Self {
            multi,
            instances: buffer::<ChunkInstance>(&device, 256, BufferUsages::VERTEX),
            arguments: buffer::<DrawIndexedIndirectArgs>(&device, 256, BufferUsages::INDIRECT),
            device,
        }
    }

    /// The same for other draws.
    pub fn another(&self) -> Self {
        Self::with(self.device.clone(), self.multi)
    }

    /// Draws each piece by a call of its own from now on.
    pub fn draw_singly(&mut self) {
        self.multi = false;
    }

    /// Sends a list, in the order in which it is to be drawn.
    pub fn send(&mut self, queue: &Queue, list: &mut DrawList) {
        list.sort();
        let device = &self.device;
        let instances = &list.instances[..];
        if holds::<ChunkInstance>(&self.instances) < instances.len() {
            self.instances = buffer::<ChunkInstance>(device, instances.len(), BufferUsages::VERTEX);
        }
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(instances));
        if self.multi {
            let arguments: Vec<_> = list.draws.iter().map(|draw| draw.args).collect();
            if holds::<DrawIndexedIndirectArgs>(&self.arguments) < arguments.len() {
                let usage = BufferUsages::INDIRECT;
                self.arguments = buffer::<DrawIndexedIndirectArgs>(device, arguments.len(), usage);
            }
            queue.write_buffer(&self.arguments, 0, bytemuck::cast_slice(&arguments));
        }
    }

    /// Draws the list that was sent; returns what that took. `pipeline` sets the pipeline of a number.
    pub fn draw<'p>(
        &self,
        pass: &mut RenderPass<'_>,
        list: &DrawList,
        charts: &Charts,
        pages: &Pages,
        pipeline: impl Fn(u8) -> &'p wgpu::RenderPipeline,
    ) -> DrawCount {
        let (mut calls, mut first) = (0, 0);
        let mut bound = (None, None, None);
        for batch in list.batches() {
            let (number, page, chart) = batch[0].batch();
            let Some(buffers) = pages.page(page) else {
                first += batch.len();
                continue;
            };
            if bound.0.replace(number) != Some(number) {
                pass.set_pipeline(pipeline(number));
            }
            if bound.2.replace(chart) != Some(chart) {
                charts.bind(pass, chart);
            }
            if bound.1.replace(page) != Some(page) {
                pass.set_index_buffer(buffers.indices.slice(..), IndexFormat::Uint16);
                pass.set_vertex_buffer(0, buffers.vertices.slice(..));
                pass.set_vertex_buffer(1, self.instances.slice(..));
            }
            if self.multi {
                let offset = first * size_of::<DrawIndexedIndirectArgs>();
                pass.multi_draw_indexed_indirect(
                    &self.arguments,
                    offset as u64,
                    batch.len() as u32,
                );
                calls += 1;
            } else {
                for draw in batch {
                    self.draw_bound(pass, &draw.args, &buffers.vertices);
                }
                calls += batch.len();
            }
            first += batch.len();
        }
        DrawCount {
            triangles: list.triangles(),
            draws: calls,
        }
    }

    /// Draws one piece. Binding slices, instead of naming a first vertex and a first instance, works on every
    /// OpenGL.
    fn draw_bound(
        &self,
        pass: &mut RenderPass<'_>,
        args: &DrawIndexedIndirectArgs,
        vertices: &Buffer,
    ) {
        let at = |first: u64, size: usize| first * size as u64;
        let first_vertex = at(
            u64::from(args.base_vertex.unsigned_abs()),
            size_of::<Vertex>(),
        );
        let instance = at(u64::from(args.first_instance), size_of::<ChunkInstance>());
        pass.set_vertex_buffer(0, vertices.slice(first_vertex..));
        pass.set_vertex_buffer(1, self.instances.slice(instance..));
        let indices = args.first_index..args.first_index + args.index_count;
        pass.draw_indexed(indices, 0, 0..1);
    }
}

/// How many of a thing a buffer holds.
fn holds<T>(buffer: &Buffer) -> usize {
    buffer.size() as usize / size_of::<T>()
}

fn buffer<T>(device: &Device, count: usize, usage: BufferUsages) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("land draws"),
        size: (count.next_power_of_two() * size_of::<T>()) as u64,
        usage: usage | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn piece(page: usize, first_index: u32) -> Piece {
        Piece {
            page,
            args: DrawIndexedIndirectArgs {
                index_count: 3,
                instance_count: 1,
                first_index,
                base_vertex: 0,
                first_instance: 0,
            },
        }
    }

    /// A list of meshes of two pieces each, whose pipeline and page follow from their place.
    fn list(count: u32, of: impl Fn(u32) -> (u8, usize, u32)) -> DrawList {
        let mut list = DrawList::default();
        for i in 0..count {
            let instance = ChunkInstance::new(DVec3::ZERO, DVec3::ZERO);
            let (pipeline, page, chart) = of(i);
            let pieces = [piece(page, i * 10), piece(page, i * 10 + 5)];
            let pieces = pieces.map(|piece| (pipeline, piece));
            list.add(chart, instance, pieces.into_iter());
        }
        list.sort();
        list
    }

    #[test]
    fn where_few_calls_do_what_is_nearer_comes_first() {
        let list = list(90, |i| (u8::from(i % 12 > 5), usize::from(i > 60), 0));
        assert_eq!(list.triangles(), 180);
        assert!(list.draws.is_sorted_by_key(|draw| draw.args.first_index));
        assert_eq!(list.batches().count(), 16);
    }

    #[test]
    fn a_call_draws_from_one_page_with_one_pipeline_what_is_nearer_first_and_there_are_few() {
        let list = list(2000, |i| (u8::from(i % 7 > 3), i as usize % 3, i % 2));
        let mut found: Vec<_> = list.draws.iter().map(|d| d.args.first_index).collect();
        found.sort_unstable();
        assert!(found.iter().copied().eq((0..4000).map(|i| i * 5)));
        assert!(list.batches().count() <= FEW_CALLS);
        for batch in list.batches() {
            assert!(batch.iter().all(|draw| draw.batch() == batch[0].batch()));
            assert!(batch.is_sorted_by_key(|draw| draw.args.first_index));
        }
        for draw in &list.draws {
            // Each piece is drawn where its mesh stands.
            assert_eq!(draw.args.first_index / 10, draw.args.first_instance);
        }
    }
}
