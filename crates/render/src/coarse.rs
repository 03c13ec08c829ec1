//! Coarser triangles of a model for its shadow, where the map's texels are larger than its details.
//!
//! Vertices of one cell of a grid that hang from the same joint become one of them (vertex clustering: Rossignac and
//! Borrel, 1993), and triangles that lose a corner go. What is left is off by less than a cell's diagonal.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

use glam::{IVec3, Vec3};

use crate::models::{ModelVertex, SkinVertex};

/// Indices of coarser triangles than `indices`, over the same vertices. Cells have sides of `cell_m` metres.
pub fn coarse(
    vertices: &[ModelVertex],
    skin: &[SkinVertex],
    indices: &[u16],
    cell_m: f32,
) -> Vec<u16> {
    let mut first_of: HashMap<(IVec3, u8), u16> = HashMap::new();
    let mut own: HashMap<u16, u16> = HashMap::new();
    for &index in indices {
        let Entry::Vacant(place) = own.entry(index) else {
            continue;
        };
        let Some(vertex) = vertices.get(usize::from(index)) else {
            continue;
        };
        let cell = (Vec3::from(vertex.position) / cell_m).floor().as_ivec3();
        let joint = skin.get(usize::from(index)).map_or(0, main_joint);
        place.insert(*first_of.entry((cell, joint)).or_insert(index));
    }
    let mut seen = HashSet::new();
    let mut out = Vec::new();
    for triangle in indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|i| own.get(&triangle[i]).copied().unwrap_or(triangle[i]));
        if a == b || b == c || c == a {
            continue;
        }
        let mut corners = [a, b, c];
        corners.sort_unstable();
        if seen.insert(corners) {
            out.extend([a, b, c]);
        }
    }
    out
}

/// The joint that moves a vertex most.
fn main_joint(skin: &SkinVertex) -> u8 {
    let most = (0..4).max_by_key(|&i| skin.weights[i]).unwrap_or(0);
    skin.joints[most]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_frame::ModelId;

    use super::*;

    /// Shares of squares of 2 cm that a model's triangles cover, seen along z.
    fn covered(vertices: &[ModelVertex], indices: &[u16]) -> HashSet<(i32, i32)> {
        let mut out = HashSet::new();
        for triangle in indices.chunks_exact(3) {
            let [a, b, c] =
                [0, 1, 2].map(|i| Vec3::from(vertices[usize::from(triangle[i])].position));
            let steps = 1 + ((b - a).length().max((c - a).length()) / 0.01) as i32;
            for i in 0..=steps {
                for j in 0..=steps - i {
                    let at = a
                        + (b - a) * (i as f32 / steps as f32)
                        + (c - a) * (j as f32 / steps as f32);
                    out.insert(((at.x / 0.02).floor() as i32, (at.y / 0.02).floor() as i32));
                }
            }
        }
        out
    }

    #[test]
    fn a_figure_keeps_its_outline_with_far_fewer_triangles() {
        let models = crate::models::load_all().unwrap();
        let of = |id: ModelId| {
            let number = ModelId::ALL.iter().position(|it| *it == id).unwrap();
            &models[number].shape
        };
        for id in [ModelId::Astronaut, ModelId::AstronautTeal, ModelId::CarBody] {
            let shape = of(id);
            let fewer = coarse(&shape.vertices, &shape.skin, &shape.solid, 0.05);
            let corners = |indices: &[u16]| indices.iter().collect::<HashSet<_>>().len();
            let left = [corners(&fewer), corners(&shape.solid)];
            assert!(left[0] * 2 < left[1], "{id:?}: {left:?} vertices");
            let left = [&fewer, &shape.solid].map(|indices| indices.len() / 3);
            assert!(left[0] * 5 < left[1] * 4, "{id:?}: {left:?} triangles");
            let (fine, rough) = (
                covered(&shape.vertices, &shape.solid),
                covered(&shape.vertices, &fewer),
            );
            let off = fine.symmetric_difference(&rough).count();
            assert!(
                off * 12 < fine.len(),
                "{id:?}: {off} of {} squares",
                fine.len()
            );
        }
    }
}
