//! A scene in the adapter's memory.

use antipode_deformation::Space;
use bytemuck::{Pod, bytes_of, cast_slice};
use glam::Vec3;
use wgpu::{Buffer, BufferUsages, Device, Queue, TextureView};

use crate::baked::{Baked, Movable};
use crate::crowd::Near;
use crate::error::RaysError;
use crate::kinds::Kinds;
use crate::mesh::TRIANGLE_TEXELS;
use crate::packed::{PackedWays, Rule, aberrations, material};
use crate::packed_portals::packed_portals;
use crate::raster::{Chunk, Moved, tidy};
use crate::scene::{Mover, RayScene};
use crate::texels::{ROW, Texels};
use crate::top::{
    INSTANCE_TEXELS, MOST_MOVERS, Placed, Resting, Top, bounds, build, pack, plane_in,
};
use crate::tree::NODE_TEXELS;
use crate::trees::Trees;

/// A scene in the adapter's memory. What stays, materials, pictures and aberrations are as they were loaded; movers may be
/// others in every picture, and meshes that may move may change their shape.
#[derive(Debug)]
pub struct Loaded {
    pub(crate) nodes: Texels,
    pub(crate) triangles: Texels,
    pub(crate) instances: Texels,
    pub(crate) neighbours: Buffer,
    pub(crate) portals: Buffer,
    spaces: [Buffer; Rule::ALL.len()],
    kinds: [Kinds; Rule::ALL.len()],
    pub(crate) ways: Buffer,
    pub(crate) materials: Buffer,
    pub(crate) attributes: Buffer,
    pub(crate) textures: TextureView,
    pub(crate) host_ways: PackedWays,
    /// What stays, for a raster.
    pub(crate) chunks: Vec<Chunk>,
    /// What moves, for a raster.
    pub(crate) moved: Vec<Moved>,
    /// Aberrations, and which of them a raster sees through.
    aberrations: Space,
    pub(crate) tidy: Vec<bool>,
    movables: Vec<Movable>,
    placed: Vec<Placed>,
    resting: Resting,
    /// Where instances that move begin.
    movers_at: usize,
    /// What was shown last; none where meshes have changed since.
    shown: Option<Vec<Mover>>,
}

impl Loaded {
    /// Puts all of a scene into the adapter's memory.
    pub(crate) fn new(
        device: &Device,
        queue: &Queue,
        (scene, textures): (&RayScene, TextureView),
        (trees, sorted): (&Trees, bool),
    ) -> Result<Self, RaysError> {
        let (parts, movables) = bake_all(scene, trees, sorted)?;
        let pairs = movables.iter().zip(&parts[1..]);
        let placed = pairs.map(|(one, baked)| placed(one, baked)).collect();
        let (neighbours, near, ways) = crate::packed::neighbours(scene);
        let pictures = scene.textures.len();
        let materials = scene.materials.iter().map(|it| material(it, pictures));
        let materials: Vec<_> = materials.collect();
        let storage = BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let movers_at = (scene.instances.len() * INSTANCE_TEXELS).next_multiple_of(ROW);
        let instances = movers_at + MOST_MOVERS * INSTANCE_TEXELS;
        let sum = |of: fn(&Baked) -> usize| parts.iter().map(of).sum::<usize>();
        let nodes = MOST_MOVERS + sum(|part| part.nodes.len());
        let attributes: Vec<_> = parts.iter().map(|it| it.attributes.as_slice()).collect();
        let attributes = attributes.concat();
        let packed: Vec<_> = scene.instances.iter().map(pack).collect();
        let (node_parts, triangle_parts) = texels_of(&parts);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut texels = |label, count, contents: &[_]| {
            Texels::new(device, &mut encoder, label, count, contents)
        };
        let mut loaded = Self {
            nodes: texels("nodes", NODE_TEXELS * nodes, &node_parts)?,
            triangles: texels(
                "triangles",
                sum(|part| part.triangles.len()),
                &triangle_parts,
            )?,
            instances: texels("instances", instances, &[(0, cast_slice(&packed))])?,
            attributes: filled(device, "attributes", &attributes, storage)?,
            neighbours: filled(device, "neighbours", &neighbours, storage)?,
            portals: portals(device, scene)?,
            spaces: spaces(device, scene, &near)?,
            kinds: Rule::ALL.map(|rule| Kinds::of(&scene.aberrations, rule).with_cuts(scene.cuts)),
            ways: filled(device, "ways", &[ways], storage)?,
            materials: filled(device, "materials", &materials, storage)?,
            textures,
            host_ways: ways,
            resting: resting(&parts[0], movers_at, materials.len()),
            chunks: Chunk::all(&parts[0].triangles),
            moved: Vec::new(),
            tidy: tidy(&scene.aberrations),
            aberrations: scene.aberrations.clone(),
            movables,
            placed,
            movers_at,
            shown: None,
        };
        queue.submit([encoder.finish()]);
        loaded.show(queue, &[])?;
        Ok(loaded)
    }

    /// What moves, where it is now: the upper level of the hierarchy is made anew, everything else stays. Nothing is done
    /// where all is as it was shown last.
    ///
    /// # Errors
    /// When there are more than 512, or one is of a mesh or material that the scene lacks, or has no size.
    pub fn show(&mut self, queue: &Queue, movers: &[Mover]) -> Result<(), RaysError> {
        if self.shown.as_deref() == Some(movers) {
            return Ok(());
        }
        let Top {
            root,
            nodes,
            instances,
        } = build(movers, &self.placed, &self.resting)?;
        self.nodes.write(queue, 0, &nodes);
        self.instances.write(queue, self.movers_at, &instances);
        self.host_ways.root = root;
        queue.write_buffer(&self.ways, 0, bytes_of(&self.host_ways));
        self.moved = self.moved(movers);
        self.shown = Some(movers.to_vec());
        Ok(())
    }

    /// Movers, for a raster.
    fn moved(&self, movers: &[Mover]) -> Vec<Moved> {
        let moved = movers.iter().enumerate().filter_map(|(number, mover)| {
            let movable = self.movables.get(mover.mesh)?;
            let (low, high) = bounds(&mover.pose, self.placed.get(mover.mesh)?.bounds?);
            let first = movable.bases.1;
            Some(Moved {
                triangles: first..first + movable.sizes().1 as u32,
                pose: mover.pose,
                low,
                high,
                instance: self.resting.instances + number as u32,
                is_held: mover.held,
                is_unseen: mover.unseen_by_eye,
                cut: mover.cut.map(|it| plane_in(&mover.pose, it)),
            })
        });
        moved.collect()
    }

    /// Gives a mesh that may move, by its number among these, another shape: the places of its corners, metres of the mesh,
    /// and their normals. Its hierarchy keeps its leaves. Its movers are as they were until [`Self::show`].
    ///
    /// # Errors
    /// When there is no such mesh, or it has not as many corners.
    pub fn pose(
        &mut self,
        queue: &Queue,
        number: usize,
        places: &[Vec3],
        normals: &[Vec3],
    ) -> Result<(), RaysError> {
        let Some(movable) = self.movables.get_mut(number) else {
            return Err(RaysError::NoMovable { mesh: number });
        };
        let baked = movable.posed(number, places, normals)?;
        let (node, triangle) = movable.bases;
        let texel = TRIANGLE_TEXELS * triangle as usize;
        self.placed[number] = placed(movable, &baked);
        self.nodes
            .write(queue, NODE_TEXELS * node as usize, &baked.nodes);
        self.triangles.write(queue, texel, &baked.triangles);
        queue.write_buffer(
            &self.attributes,
            (texel * size_of::<[u32; 4]>()) as u64,
            cast_slice(&baked.attributes),
        );
        self.shown = None;
        Ok(())
    }

    /// What the shaders are told of beforehand, by a rule.
    pub(crate) fn kinds(&self, rule: Rule) -> Kinds {
        self.kinds[rule as usize]
    }

    /// The aberrations, as they were given.
    pub(crate) fn aberrations(&self) -> &Space {
        &self.aberrations
    }

    /// The aberrations by a rule.
    pub(crate) fn space(&self, rule: Rule) -> &Buffer {
        &self.spaces[rule as usize]
    }
}

/// What stays, then each mesh that may move, numbered behind each other.
fn bake_all(
    scene: &RayScene,
    trees: &Trees,
    sorted: bool,
) -> Result<(Vec<Baked>, Vec<Movable>), RaysError> {
    let mut parts = vec![Baked::room(scene, sorted, MOST_MOVERS as u32)?];
    let mut movables = Vec::with_capacity(scene.movables.len());
    let mut bases = (
        MOST_MOVERS + parts[0].nodes.len(),
        parts[0].triangles.len() / TRIANGLE_TEXELS,
    );
    for (number, mesh) in scene.movables.iter().enumerate() {
        let movable = Movable::new((mesh, number), trees, (bases.0 as u32, bases.1 as u32))?;
        let (nodes, triangles) = movable.sizes();
        bases = (bases.0 + nodes, bases.1 + triangles);
        parts.push(movable.rest());
        movables.push(movable);
    }
    Ok((parts, movables))
}

/// Bytes that begin at a texel.
type Placing<'a> = (usize, &'a [u8]);

/// Nodes and triangles of all parts, one behind the other.
fn texels_of(parts: &[Baked]) -> (Vec<Placing<'_>>, Vec<Placing<'_>>) {
    let (mut node, mut texel) = (MOST_MOVERS, 0);
    let mut lists = (Vec::new(), Vec::new());
    for part in parts {
        lists.0.push((NODE_TEXELS * node, cast_slice(&part.nodes)));
        lists.1.push((texel, cast_slice(&part.triangles)));
        node += part.nodes.len();
        texel += part.triangles.len();
    }
    lists
}

/// The aberrations by each rule.
fn spaces(
    device: &Device,
    scene: &RayScene,
    near: &[Near],
) -> Result<[Buffer; Rule::ALL.len()], RaysError> {
    let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
    let by = |rule| {
        let packed = aberrations(scene, rule, near);
        filled(device, "aberrations", &packed, usage)
    };
    let [exact, thesis, plain] = Rule::ALL.map(by);
    Ok([exact?, thesis?, plain?])
}

fn portals(device: &Device, scene: &RayScene) -> Result<Buffer, RaysError> {
    let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
    let packed = packed_portals(&scene.aberrations);
    filled(device, "portals", &packed, usage)
}

fn resting(room: &Baked, movers_at: usize, materials: usize) -> Resting {
    Resting {
        bounds: room.bounds,
        root: room.root,
        instances: (movers_at / INSTANCE_TEXELS) as u32,
        materials,
    }
}

fn placed(movable: &Movable, baked: &Baked) -> Placed {
    Placed {
        bounds: baked.bounds,
        root: baked.root,
        most_material: movable.most_material().unwrap_or(0),
    }
}

/// A buffer with that in it, copied without the queue: see [`Texels::new`].
fn filled<T: Pod>(
    device: &Device,
    label: &'static str,
    contents: &[T],
    usage: BufferUsages,
) -> Result<Buffer, RaysError> {
    let bytes: &[u8] = cast_slice(contents);
    let limits = device.limits();
    let most = limits
        .max_buffer_size
        .min(limits.max_storage_buffer_binding_size);
    let size = bytes.len() as u64;
    if size > most {
        return Err(RaysError::TooLarge {
            what: format!("{size} bytes of {label}"),
            most,
        });
    }
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        // A binding may not be empty.
        size: size.max(256),
        usage,
        mapped_at_creation: true,
    });
    if !bytes.is_empty() {
        let mapped = buffer.slice(..size).get_mapped_range_mut();
        let refused = |error: wgpu::MapRangeError| RaysError::Upload(error.to_string());
        mapped.map_err(refused)?.copy_from_slice(bytes);
    }
    buffer.unmap();
    Ok(buffer)
}
