//! The terrain's meshes on the adapter.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::ChunkCoord;
use antipode_scene::frame::{ChunkChange, Frame};
use antipode_terrain::{ChunkMesh, Vertex};
use glam::{DVec3, Vec3};
use wgpu::{Buffer, BufferUsages, Device, Queue, RenderPass};

use crate::mesh_buffers::MeshBuffers;
use crate::pipelines::TerrainPipelines;
use crate::plan::{ChunkChoice, ChunkLand, FramePlan, Port, RefineKey, Refined, refined};
use crate::uniforms::{ChunkInstance, whole_reference};

/// Chunks whose halved edges are brought up to date in one frame, the nearest first: the main thread has other
/// things to do, and what is late by a few frames is off by little.
const REFINED_PER_FRAME: usize = 1;
/// Buffers for refined meshes that are kept though no chunk needs them.
const MOST_SPARE: usize = 8;
/// A mesh that keeps this far from its chunk's floor does not go on below it, metres.
const FLOOR_CLEARANCE_M: f32 = 0.01;

/// Attributes of a terrain vertex, from location 0 on.
pub const VERTEX_ATTRIBUTES: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Snorm16x4, 2 => Unorm8x4];
/// Bytes of a terrain vertex.
pub const VERTEX_BYTES: u64 = size_of::<Vertex>() as u64;

/// One chunk's mesh.
#[derive(Debug)]
pub struct GpuChunk {
    buffers: MeshBuffers,
    /// Its refinement, where it is near enough to need one.
    refined: Option<Refinement>,
    mesh: Arc<ChunkMesh>,
    land: ChunkLand,
}

/// A mesh with edges halved near the eye.
#[derive(Debug)]
struct Refinement {
    made_for: RefineKey,
    /// Nothing where no edge needed it.
    buffers: Option<MeshBuffers>,
    error_px: f64,
}

impl GpuChunk {
    fn new(device: &Device, coord: ChunkCoord, mesh: &Arc<ChunkMesh>) -> Self {
        Self {
            buffers: MeshBuffers::new(device, &mesh.vertices, &mesh.indices),
            refined: None,
            land: land_of(coord, mesh),
            mesh: Arc::clone(mesh),
        }
    }

    fn drawn(&self) -> &MeshBuffers {
        match &self.refined {
            Some(Refinement {
                buffers: Some(refined),
                ..
            }) => refined,
            _ => &self.buffers,
        }
    }
}

/// What the planner is to know of a mesh.
fn land_of(coord: ChunkCoord, mesh: &ChunkMesh) -> ChunkLand {
    let positions = || {
        mesh.vertices
            .iter()
            .map(|v| Vec3::from(v.position).as_dvec3())
    };
    let origin = coord.origin();
    let lowest = mesh
        .vertices
        .iter()
        .min_by(|a, b| a.position[1].total_cmp(&b.position[1]));
    // Below the mesh's lowest place lies ground, if that place is a floor; and all the way down, if the mesh
    // stays clear of the chunk's own floor.
    let solid_below_m = lowest
        .filter(|v| v.normal[1] > 0 && v.position[1] > FLOOR_CLEARANCE_M)
        .map(|v| origin.y + f64::from(v.position[1]));
    ChunkLand {
        coord,
        min: origin + positions().reduce(DVec3::min).unwrap_or_default(),
        max: origin + positions().reduce(DVec3::max).unwrap_or_default(),
        triangles: mesh.indices.len() / 3,
        solid_below_m,
    }
}

/// All chunks, and this frame's instances.
#[derive(Debug)]
pub struct ChunkStore {
    chunks: HashMap<ChunkCoord, GpuChunk>,
    world: Option<u64>,
    instances: Buffer,
    room: usize,
    /// Buffers of refinements that are no longer needed.
    spare: Vec<MeshBuffers>,
    /// Whether the next frame is to be complete, however long that takes.
    rush: bool,
}

impl ChunkStore {
    /// An empty store.
    pub fn new(device: &Device) -> Self {
        let room = 256;
        Self {
            chunks: HashMap::new(),
            world: None,
            instances: instance_buffer(device, room),
            room,
            spare: Vec::new(),
            rush: false,
        }
    }

    /// Takes the frame's changes, dropping everything first when the world is another.
    pub fn apply(&mut self, device: &Device, frame: &Frame) {
        if self.world != Some(frame.loaded_world) {
            self.chunks.clear();
            self.world = Some(frame.loaded_world);
        }
        for change in &frame.chunk_changes {
            match change {
                ChunkChange::Put(coord, mesh) if !mesh.is_empty() => {
                    self.chunks
                        .insert(*coord, GpuChunk::new(device, *coord, mesh));
                }
                ChunkChange::Put(coord, _) | ChunkChange::Remove(coord) => {
                    self.chunks.remove(coord);
                }
            }
        }
    }

    /// The land of every chunk that has triangles, in an order that depends on nothing else.
    pub fn land(&self) -> Vec<ChunkLand> {
        let mut land: Vec<_> = self.chunks.values().map(|chunk| chunk.land).collect();
        // A table's order differs from run to run; what is drawn first may not.
        land.sort_by_key(|land| (land.coord.hemisphere, land.coord.index.to_array()));
        land
    }

    /// Lets the next frame bring all refinements up to date.
    pub fn rush(&mut self) {
        self.rush = true;
    }

    /// How many chunks have triangles.
    pub fn len(&self) -> usize {
        self.chunks.len()
    }

    /// Halves edges of the chunks whose choice says so, as far as that is not done, and adds to the plan's
    /// figures what came of it.
    pub fn refine(
        &mut self,
        device: &Device,
        queue: &Queue,
        frame: &Frame,
        land: &[ChunkLand],
        plan: &mut FramePlan,
    ) {
        let key = RefineKey::of(frame, &plan.bounds);
        let mut budget = if std::mem::take(&mut self.rush) {
            usize::MAX
        } else {
            REFINED_PER_FRAME
        };
        for choice in &plan.chunks {
            let land = &land[choice.place];
            let Some(chunk) = self.chunks.get_mut(&land.coord) else {
                continue;
            };
            if !choice.refine {
                self.spare
                    .extend(chunk.refined.take().and_then(|r| r.buffers));
                continue;
            }
            let current = chunk.refined.as_ref().is_some_and(|r| r.made_for == key);
            let due = !current && budget > 0;
            if due {
                budget -= 1;
                self.spare
                    .extend(chunk.refined.take().and_then(|r| r.buffers));
                chunk.refined =
                    refined(frame, land, &chunk.mesh, &plan.bounds).map(|mesh| Refinement {
                        made_for: key,
                        error_px: mesh.error_px,
                        buffers: (mesh.halved > 0)
                            .then(|| filled(&mut self.spare, device, queue, &mesh)),
                    });
            }
            if let Some(refined) = &chunk.refined {
                plan.stats.error_at_least(refined.error_px);
                if let Some(buffers) = &refined.buffers {
                    plan.stats.chunks_refined += 1;
                    plan.stats.triangles_added += buffers.triangles() - land.triangles;
                }
            }
        }
    }

    /// Makes room for the instances of all chunks.
    pub fn reserve(&mut self, device: &Device) {
        if self.chunks.len() > self.room {
            self.room = self.chunks.len().next_power_of_two();
            self.instances = instance_buffer(device, self.room);
        }
    }

    /// Sends where the chosen chunks stand.
    pub fn upload(&self, queue: &Queue, frame: &Frame, land: &[ChunkLand], plan: &FramePlan) {
        let instance = |choice: &ChunkChoice| {
            let coord = land[choice.place].coord;
            let reference = whole_reference(frame, coord.hemisphere);
            let plain = ChunkInstance::new(coord.origin(), coord.hemisphere, reference);
            match &choice.port {
                Port::Vertex => plain,
                Port::Frame(affine) => plain.framed(affine),
            }
        };
        let instances: Vec<_> = plan.chunks.iter().map(instance).collect();
        queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
    }

    /// Draws the chosen chunks in order; returns triangles and draw calls.
    pub fn draw(
        &self,
        pass: &mut RenderPass<'_>,
        land: &[ChunkLand],
        plan: &FramePlan,
        pipelines: &TerrainPipelines,
    ) -> (usize, usize) {
        let (mut triangles, mut draws) = (0, 0);
        let mut bound = None;
        for (place, choice) in plan.chunks.iter().enumerate() {
            let Some(chunk) = self.chunks.get(&land[choice.place].coord) else {
                continue;
            };
            let (number, pipeline) = pipelines.of(choice);
            if bound != Some(number) {
                bound = Some(number);
                pass.set_pipeline(pipeline);
            }
            let mesh = chunk.drawn();
            // Binding the slice instead of naming a first instance works on OpenGL too.
            let start = (place * size_of::<ChunkInstance>()) as u64;
            pass.set_vertex_buffer(1, self.instances.slice(start..));
            mesh.draw(pass);
            triangles += mesh.triangles();
            draws += 1;
        }
        (triangles, draws)
    }
}

/// Buffers filled with a refined mesh: spare ones with room, or new ones.
fn filled(
    spare: &mut Vec<MeshBuffers>,
    device: &Device,
    queue: &Queue,
    mesh: &Refined,
) -> MeshBuffers {
    let (vertices, indices) = (mesh.vertices.len(), mesh.indices.len());
    let place = spare.iter().position(|b| b.has_room(vertices, indices));
    let mut buffers = if let Some(place) = place {
        spare.swap_remove(place)
    } else {
        // What is too small for one mesh is of little use for the next.
        spare.truncate(MOST_SPARE);
        MeshBuffers::roomy(device, vertices, indices)
    };
    buffers.fill(queue, &mesh.vertices, &mesh.indices);
    buffers
}

fn instance_buffer(device: &Device, room: usize) -> Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("chunks"),
        size: (room * size_of::<ChunkInstance>()) as u64,
        usage: BufferUsages::VERTEX | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

#[cfg(test)]
mod tests {
    use std::mem::offset_of;

    use super::*;

    #[test]
    fn terrain_vertices_are_laid_out_as_the_pipeline_reads_them() {
        let ours = [
            offset_of!(Vertex, position),
            offset_of!(Vertex, normal),
            offset_of!(Vertex, colour),
        ];
        assert_eq!(VERTEX_ATTRIBUTES.map(|a| a.offset as usize), ours);
        assert_eq!(VERTEX_BYTES, 24);
    }
}
