//! Meshes, and how they lie in the adapter's memory: hierarchy, triangles, and what is drawn on them.

use antipode_deformation::{Bvh, BvhNode};
use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};

use crate::error::RaysError;

/// Triangles in a leaf at most.
const LEAF: u32 = 4;

/// Triangles with what is drawn on them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners, in metres of the mesh.
    pub positions: Vec<Vec3>,
    /// Triangles, by numbers of corners.
    pub triangles: Vec<[u32; 3]>,
    /// Normals of the corners; empty for faces that are flat.
    pub normals: Vec<Vec3>,
    /// Where in a texture the corners lie; empty where there is none.
    pub uvs: Vec<Vec2>,
    /// Number of each triangle's material; empty for 0.
    pub materials: Vec<u32>,
}

/// A box of a hierarchy, as scene.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct Node {
    pub low: Vec3,
    pub first: u32,
    pub high: Vec3,
    pub count: u32,
}

impl From<&BvhNode> for Node {
    fn from(node: &BvhNode) -> Self {
        Self {
            low: node.low,
            first: node.first,
            high: node.high,
            count: node.count,
        }
    }
}

/// A mesh ready for the adapter.
#[derive(Clone, Debug, Default)]
pub struct Baked {
    /// Its hierarchy; children and triangles are counted from its own first.
    pub nodes: Vec<Node>,
    /// Three for each triangle: a corner with the triangle's number in the mesh, and two edges.
    pub triangles: Vec<[f32; 4]>,
    /// Three for each triangle: normals and material, and uv.
    pub attributes: Vec<[u32; 4]>,
    /// Its box.
    pub low: Vec3,
    /// Its box.
    pub high: Vec3,
}

/// Checks a mesh and makes its hierarchy; one that is not to be sorted is a single leaf. `number` is what errors call it.
pub fn bake(mesh: &Mesh, number: usize, sorted: bool) -> Result<Baked, RaysError> {
    check(mesh, number)?;
    let corners = |triangle: &[u32; 3]| triangle.map(|corner| mesh.positions[corner as usize]);
    let boxes: Vec<_> = mesh
        .triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = corners(triangle);
            (a.min(b).min(c), a.max(b).max(c))
        })
        .collect();
    let bvh = Bvh::with_leaves(&boxes, LEAF);
    let mut baked = Baked {
        nodes: bvh.nodes().iter().map(Node::from).collect(),
        ..Baked::default()
    };
    if !sorted {
        baked.nodes.truncate(1);
        for root in &mut baked.nodes {
            (root.first, root.count) = (0, mesh.triangles.len() as u32);
        }
    }
    for triangle in bvh.order() {
        let [a, b, c] = corners(&mesh.triangles[*triangle as usize]);
        let edges = [b - a, c - a];
        baked.triangles.extend([
            [a.x, a.y, a.z, f32::from_bits(*triangle)],
            edges[0].extend(0.0).to_array(),
            edges[1].extend(0.0).to_array(),
        ]);
        baked
            .attributes
            .extend(attributes(mesh, *triangle as usize));
    }
    if let Some(root) = baked.nodes.first() {
        (baked.low, baked.high) = (root.low, root.high);
    }
    Ok(baked)
}

fn check(mesh: &Mesh, number: usize) -> Result<(), RaysError> {
    let corners = mesh.positions.len();
    let lengths = |what| Err(RaysError::Lengths { mesh: number, what });
    if !mesh.normals.is_empty() && mesh.normals.len() != corners {
        return lengths("normals");
    }
    if !mesh.uvs.is_empty() && mesh.uvs.len() != corners {
        return lengths("places in a texture");
    }
    if !mesh.materials.is_empty() && mesh.materials.len() != mesh.triangles.len() {
        return lengths("materials");
    }
    if !mesh.positions.iter().all(|place| place.is_finite()) {
        return Err(RaysError::Place { mesh: number });
    }
    let lacks = |triangle: &[u32; 3]| triangle.iter().any(|corner| *corner as usize >= corners);
    match mesh.triangles.iter().position(lacks) {
        Some(triangle) => Err(RaysError::Corner {
            mesh: number,
            triangle,
        }),
        None => Ok(()),
    }
}

fn attributes(mesh: &Mesh, number: usize) -> [[u32; 4]; 3] {
    let triangle = mesh.triangles[number].map(|corner| corner as usize);
    let [a, b, c] = triangle.map(|corner| mesh.positions[corner]);
    let flat = (b - a).cross(c - a);
    let normals = triangle.map(|corner| {
        let own = mesh.normals.get(corner).copied().unwrap_or(flat);
        octahedral(own.try_normalize().unwrap_or(Vec3::Y))
    });
    let uvs = triangle.map(|corner| mesh.uvs.get(corner).copied().unwrap_or(Vec2::ZERO));
    let [u, v] = [uvs[1] - uvs[0], uvs[2] - uvs[0]];
    let uv_for_metre = (u.perp_dot(v).abs() / flat.length().max(1e-12)).sqrt();
    let material = mesh.materials.get(number).copied().unwrap_or(0);
    let bits = |v: [f32; 4]| v.map(f32::to_bits);
    [
        [normals[0], normals[1], normals[2], material],
        bits([uvs[0].x, uvs[0].y, uvs[1].x, uvs[1].y]),
        bits([uvs[2].x, uvs[2].y, uv_for_metre, 0.0]),
    ]
}

/// A direction folded onto a square, each coordinate in 16 bits (Q. Meyer and others, 2010).
fn octahedral(n: Vec3) -> u32 {
    let n = n / (n.x.abs() + n.y.abs() + n.z.abs());
    let sign = |v: f32| if v >= 0.0 { 1.0 } else { -1.0 };
    let folded = if n.z < 0.0 {
        Vec2::new((1.0 - n.y.abs()) * sign(n.x), (1.0 - n.x.abs()) * sign(n.y))
    } else {
        Vec2::new(n.x, n.y)
    };
    let pack = |v: f32| u32::from(((v.clamp(-1.0, 1.0) * 32767.0).round() as i16) as u16);
    pack(folded.x) | (pack(folded.y) << 16)
}
