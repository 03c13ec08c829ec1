//! Triangles as plain data.

use glam::{Vec2, Vec3, Vec4};

/// A corner of triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Place in metres, in the mesh's axes; with a skin, in those of the bind pose.
    pub position: Vec3,
    /// Unit vector away from the inside.
    pub normal: Vec3,
    /// Linear light and cover, 0 to 1; white where the file has none. The material's colour multiplies it.
    pub colour: Vec4,
    /// Place in the texture, (0, 0) at its upper left.
    pub uv: Vec2,
    /// Joints of the skin it hangs from.
    pub joints: [u16; 4],
    /// Shares of the joints, 0 or more; they sum to 1 with a skin and to 0 without.
    pub weights: [f32; 4],
}

/// Triangles of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// Index into [`crate::Model::materials`].
    pub material: usize,
    /// The corners.
    pub vertices: Vec<Vertex>,
    /// Three for each triangle, anticlockwise from outside; all below the number of vertices.
    pub indices: Vec<u32>,
}

/// What one node shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Its name in the file.
    pub name: String,
    /// One for each material, at least one.
    pub primitives: Vec<Primitive>,
}

impl Mesh {
    /// Number of joints that a skin must have for this mesh: 0 where no vertex has weights.
    pub fn joints_needed(&self) -> usize {
        let used = |v: &Vertex| {
            v.joints
                .iter()
                .zip(v.weights)
                .filter(|(_, w)| *w > 0.0)
                .map(|(j, _)| *j as usize + 1)
                .max()
        };
        self.primitives
            .iter()
            .flat_map(|p| &p.vertices)
            .filter_map(used)
            .max()
            .unwrap_or(0)
    }

    /// Whether every vertex hangs from some joint.
    pub fn is_weighted(&self) -> bool {
        self.primitives
            .iter()
            .flat_map(|p| &p.vertices)
            .all(|v| v.weights.iter().sum::<f32>() > 0.5)
    }
}

/// Triangles of lists, strips and fans; glTF 2.0, 3.7.2.1 has the order of their corners.
pub fn triangles(indices: &[u32], mode: gltf::json::mesh::Mode) -> Option<Vec<u32>> {
    use gltf::json::mesh::Mode;
    let count = indices.len().saturating_sub(2);
    match mode {
        Mode::Triangles => indices.len().is_multiple_of(3).then(|| indices.to_vec()),
        Mode::TriangleStrip => {
            // Every other triangle of a strip runs the other way round.
            let corner = |i: usize| [indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]];
            Some((0..count).flat_map(corner).collect())
        }
        Mode::TriangleFan => Some(
            (0..count)
                .flat_map(|i| [indices[i + 1], indices[i + 2], indices[0]])
                .collect(),
        ),
        _ => None,
    }
}

/// Gives every triangle corners of its own and the normal of its plane, as glTF 2.0, 3.7.2.1 asks where a file has no
/// normals. Triangles without area get a normal upward.
pub fn flatten(vertices: &[Vertex], indices: &[u32]) -> (Vec<Vertex>, Vec<u32>) {
    let mut out: Vec<Vertex> = indices.iter().map(|&i| vertices[i as usize]).collect();
    for corners in out.chunks_exact_mut(3) {
        let (a, b, c) = (
            corners[0].position,
            corners[1].position,
            corners[2].position,
        );
        let normal = (b - a).cross(c - a).try_normalize().unwrap_or(Vec3::Y);
        for corner in corners {
            corner.normal = normal;
        }
    }
    let indices = (0..out.len() as u32).collect();
    (out, indices)
}
