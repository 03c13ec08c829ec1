//! A scene in the adapter's memory.

use bytemuck::{Pod, bytes_of, cast_slice};
use wgpu::{Buffer, BufferUsages, Device, Queue, TextureView};

use crate::error::RaysError;
use crate::mesh::{Baked, Node, bake};
use crate::packed::{PackedWays, aberrations, material};
use crate::scene::{Instance, RayScene};
use crate::textures;
use crate::top::{Placed, build};

/// Instances that there is room for at first.
const FEWEST_INSTANCES: usize = 64;

/// A scene in the adapter's memory. Its meshes, materials, pictures and aberrations stay as they are; its instances may move.
#[derive(Debug)]
pub struct Loaded {
    pub(crate) nodes: Buffer,
    pub(crate) triangles: Buffer,
    pub(crate) instances: Buffer,
    pub(crate) neighbours: Buffer,
    pub(crate) space: Buffer,
    pub(crate) ways: Buffer,
    pub(crate) materials: Buffer,
    pub(crate) attributes: Buffer,
    pub(crate) textures: TextureView,
    pub(crate) host_ways: PackedWays,
    meshes: Vec<Placed>,
    material_count: usize,
    /// Instances that there is room for; nodes of meshes begin after twice as many.
    room: usize,
}

impl Loaded {
    /// Puts all of a scene into the adapter's memory.
    pub(crate) fn new(
        device: &Device,
        queue: &Queue,
        scene: &RayScene,
        sorted: bool,
    ) -> Result<Self, RaysError> {
        let room = scene
            .instances
            .len()
            .next_power_of_two()
            .max(FEWEST_INSTANCES);
        let (baked, meshes) = bake_all(scene, sorted)?;
        let base = 2 * room;
        let mut nodes = vec![Node::default(); base];
        nodes.extend_from_slice(&baked.nodes);
        for node in &mut nodes[base..] {
            node.first += if node.count == 0 { base as u32 } else { 0 };
        }
        let (boxes, neighbours, ways) = aberrations(scene);
        let materials: Vec<_> = scene
            .materials
            .iter()
            .map(|one| material(one, scene.textures.len()))
            .collect();
        let storage = BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let instance_bytes = room * size_of::<crate::top::PackedInstance>();
        let mut loaded = Self {
            nodes: filled(device, queue, "nodes", &nodes, storage)?,
            triangles: filled(device, queue, "triangles", &baked.triangles, storage)?,
            attributes: filled(device, queue, "attributes", &baked.attributes, storage)?,
            instances: empty(device, "instances", instance_bytes as u64, storage)?,
            neighbours: filled(device, queue, "neighbours", &neighbours, storage)?,
            space: filled(device, queue, "aberrations", &boxes, uniform)?,
            ways: filled(device, queue, "ways", &[ways], uniform)?,
            materials: filled(device, queue, "materials", &materials, storage)?,
            textures: textures::upload(device, queue, &scene.textures)?,
            host_ways: ways,
            meshes,
            material_count: materials.len(),
            room,
        };
        loaded.move_instances(queue, &scene.instances)?;
        Ok(loaded)
    }

    /// Puts the instances elsewhere, or others in their place: the upper level of the hierarchy is made anew, everything else
    /// stays. There may be as many as when the scene was loaded, rounded up to a power of two, and 64 at least.
    ///
    /// # Errors
    /// When there are more, or one is of a mesh or material that the scene lacks, or has no size.
    pub fn move_instances(
        &mut self,
        queue: &Queue,
        instances: &[Instance],
    ) -> Result<(), RaysError> {
        if instances.len() > self.room {
            return Err(RaysError::TooLarge {
                what: format!("{} objects", instances.len()),
                most: self.room as u64,
            });
        }
        let base = 2 * self.room as u32;
        let (nodes, packed) = build(instances, &self.meshes, self.material_count, base)?;
        self.host_ways.has_solids = u32::from(!packed.is_empty());
        queue.write_buffer(&self.nodes, 0, cast_slice(&nodes));
        queue.write_buffer(&self.instances, 0, cast_slice(&packed));
        queue.write_buffer(&self.ways, 0, bytes_of(&self.host_ways));
        Ok(())
    }
}

/// All meshes behind each other, and where each is.
fn bake_all(scene: &RayScene, sorted: bool) -> Result<(Baked, Vec<Placed>), RaysError> {
    let mut all = Baked::default();
    let mut placed = Vec::with_capacity(scene.meshes.len());
    for (number, mesh) in scene.meshes.iter().enumerate() {
        let baked = bake(mesh, number, sorted)?;
        let (node_base, triangle_base) = (all.nodes.len() as u32, all.triangles.len() as u32 / 3);
        placed.push(Placed {
            low: baked.low,
            high: baked.high,
            root: node_base,
            most_material: (!mesh.triangles.is_empty())
                .then(|| mesh.materials.iter().copied().max().unwrap_or(0)),
        });
        all.nodes.extend(baked.nodes.iter().map(|node| Node {
            first: node.first
                + if node.count == 0 {
                    node_base
                } else {
                    triangle_base
                },
            ..*node
        }));
        all.triangles.extend(baked.triangles);
        all.attributes.extend(baked.attributes);
    }
    Ok((all, placed))
}

fn filled<T: Pod>(
    device: &Device,
    queue: &Queue,
    label: &'static str,
    contents: &[T],
    usage: BufferUsages,
) -> Result<Buffer, RaysError> {
    let bytes: &[u8] = cast_slice(contents);
    let buffer = empty(device, label, bytes.len() as u64, usage)?;
    if !bytes.is_empty() {
        queue.write_buffer(&buffer, 0, bytes);
    }
    Ok(buffer)
}

fn empty(
    device: &Device,
    label: &'static str,
    bytes: u64,
    usage: BufferUsages,
) -> Result<Buffer, RaysError> {
    let limits = device.limits();
    let most = limits
        .max_buffer_size
        .min(limits.max_storage_buffer_binding_size);
    if bytes > most {
        return Err(RaysError::TooLarge {
            what: format!("{bytes} bytes of {label}"),
            most,
        });
    }
    Ok(device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        // A binding may not be empty.
        size: bytes.max(256),
        usage,
        mapped_at_creation: false,
    }))
}
