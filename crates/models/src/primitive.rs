//! Reads a file's primitives into [`Primitive`]s.

use glam::{Vec2, Vec3, Vec4};
use gltf::json::mesh::{Primitive as JsonPrimitive, Semantic};
use gltf::json::validation::Checked::Valid;
use gltf::json::{Index, accessor::ComponentType};

use crate::accessor::{Source, valid};
use crate::error::Error;
use crate::mesh::{Mesh, Primitive, Vertex, flatten, triangles};

/// No model has more vertices than this, nor more than three times as many corners.
pub const MOST_VERTICES: usize = 1 << 20;
/// No coordinate is farther from the origin than this, metres.
pub const FARTHEST_M: f32 = 1.0e4;

type Accessor = Index<gltf::json::Accessor>;

impl Source<'_> {
    /// All meshes; `materials` is how many the file has, and one more stands for primitives without.
    pub fn meshes(self, materials: usize) -> Result<Vec<Mesh>, Error> {
        let mut budget = MOST_VERTICES;
        let mut out = Vec::with_capacity(self.root.meshes.len());
        for (i, mesh) in self.root.meshes.iter().enumerate() {
            let name = mesh.name.clone().unwrap_or_else(|| format!("mesh {i}"));
            let mut primitives = Vec::with_capacity(mesh.primitives.len());
            for primitive in &mesh.primitives {
                let material = primitive.material.map_or(materials, |m| m.value());
                if material > materials {
                    return Err(Error::OutOfRange("materials"));
                }
                let made = self.primitive(primitive, material, &name)?;
                let used = made.vertices.len().max(made.indices.len() / 3);
                budget = budget.checked_sub(used).ok_or(Error::TooMany("vertices"))?;
                primitives.push(made);
            }
            out.push(Mesh { name, primitives });
        }
        Ok(out)
    }

    fn primitive(
        self,
        json: &JsonPrimitive,
        material: usize,
        name: &str,
    ) -> Result<Primitive, Error> {
        if json
            .targets
            .as_ref()
            .is_some_and(|targets| !targets.is_empty())
        {
            return Err(Error::MorphTargets(name.to_owned()));
        }
        let find = |semantic: Semantic| json.attributes.get(&Valid(semantic)).copied();
        let positions = find(Semantic::Positions).ok_or(Error::OutOfRange("positions"))?;
        let positions = self.floats::<3>(positions, "positions")?;
        if positions.len() > MOST_VERTICES {
            return Err(Error::TooMany("vertices"));
        }
        if positions.iter().flatten().any(|c| c.abs() > FARTHEST_M) {
            return Err(Error::Absurd("positions"));
        }
        let mut vertices: Vec<Vertex> = positions.into_iter().map(plain).collect();
        self.dress(&mut vertices, json, name)?;
        let indices = self.indices(json, vertices.len(), name)?;
        let (vertices, indices) = if find(Semantic::Normals).is_some() {
            (vertices, indices)
        } else {
            flatten(&vertices, &indices)
        };
        Ok(Primitive {
            material,
            vertices,
            indices,
        })
    }

    /// Gives vertices that have places whatever else the primitive says of them.
    fn dress(self, vertices: &mut [Vertex], json: &JsonPrimitive, name: &str) -> Result<(), Error> {
        let find = |semantic: Semantic| json.attributes.get(&Valid(semantic)).copied();
        if let Some(normals) = find(Semantic::Normals) {
            let set = |v: &mut Vertex, n: [f32; 3]| {
                v.normal = Vec3::from(n).try_normalize().unwrap_or(Vec3::Y);
            };
            each(
                vertices,
                self.floats::<3>(normals, "normals")?,
                "normals",
                set,
            )?;
        }
        if let Some(colours) = find(Semantic::Colors(0)) {
            let set = |v: &mut Vertex, c: Vec4| v.colour = c;
            each(vertices, self.colours(colours)?, "colours", set)?;
        }
        if let Some(uvs) = find(Semantic::TexCoords(0)) {
            let set = |v: &mut Vertex, uv: [f32; 2]| v.uv = Vec2::from(uv);
            each(
                vertices,
                self.floats::<2>(uvs, "texture coordinates")?,
                "texture coordinates",
                set,
            )?;
        }
        if let (Some(joints), Some(weights)) =
            (find(Semantic::Joints(0)), find(Semantic::Weights(0)))
        {
            self.weigh(vertices, joints, weights)?;
        }
        if let Some(more) = find(Semantic::Weights(1))
            && self
                .floats::<4>(more, "weights")?
                .iter()
                .flatten()
                .any(|w| *w > 1.0e-4)
        {
            return Err(Error::Influences(name.to_owned()));
        }
        Ok(())
    }

    fn indices(self, json: &JsonPrimitive, vertices: usize, name: &str) -> Result<Vec<u32>, Error> {
        let list = match json.indices {
            Some(index) => {
                let rows = self.rows(index, "indices")?;
                let whole = matches!(
                    rows.component,
                    ComponentType::U8 | ComponentType::U16 | ComponentType::U32
                );
                if rows.width != 1 || rows.normalised || !whole {
                    return Err(Error::Format("indices"));
                }
                rows.values.iter().map(|v| *v as u32).collect()
            }
            None => (0..vertices as u32).collect::<Vec<_>>(),
        };
        if list.iter().any(|&i| i as usize >= vertices) {
            return Err(Error::OutOfRange("vertices"));
        }
        let mode = valid(json.mode, "triangles")?;
        let out = triangles(&list, mode).ok_or_else(|| Error::NotTriangles(name.to_owned()))?;
        if out.len() > 3 * MOST_VERTICES {
            Err(Error::TooMany("triangles"))
        } else {
            Ok(out)
        }
    }

    fn colours(self, index: Accessor) -> Result<Vec<Vec4>, Error> {
        let width = self.rows(index, "colours")?.width;
        let inside = |c: Vec4| c.clamp(Vec4::ZERO, Vec4::ONE);
        match width {
            3 => Ok(self
                .floats::<3>(index, "colours")?
                .into_iter()
                .map(|c| inside(Vec3::from(c).extend(1.0)))
                .collect()),
            _ => Ok(self
                .floats::<4>(index, "colours")?
                .into_iter()
                .map(|c| inside(Vec4::from(c)))
                .collect()),
        }
    }

    fn weigh(
        self,
        vertices: &mut [Vertex],
        joints: Accessor,
        weights: Accessor,
    ) -> Result<(), Error> {
        let rows = self.rows(joints, "joints")?;
        if rows.width != 4
            || !matches!(rows.component, ComponentType::U8 | ComponentType::U16)
            || rows.normalised
        {
            return Err(Error::Format("joints"));
        }
        let joints: Vec<[u16; 4]> = rows
            .values
            .chunks_exact(4)
            .map(|r| std::array::from_fn(|i| r[i] as u16))
            .collect();
        each(vertices, joints, "joints", |v, joints| v.joints = joints)?;
        each(
            vertices,
            self.floats::<4>(weights, "weights")?,
            "weights",
            |v, weights| v.weights = weights,
        )?;
        for vertex in vertices {
            let sum: f32 = vertex.weights.iter().sum();
            if vertex.weights.iter().any(|w| *w < 0.0) || !(1.0e-3..1.0e3).contains(&sum) {
                return Err(Error::Absurd("weights"));
            }
            vertex.weights = vertex.weights.map(|w| w / sum);
            for (joint, weight) in vertex.joints.iter_mut().zip(vertex.weights) {
                // What has no weight may point anywhere.
                if weight == 0.0 {
                    *joint = 0;
                }
            }
        }
        Ok(())
    }
}

fn plain(position: [f32; 3]) -> Vertex {
    Vertex {
        position: position.into(),
        normal: Vec3::Y,
        colour: Vec4::ONE,
        uv: Vec2::ZERO,
        joints: [0; 4],
        weights: [0.0; 4],
    }
}

fn each<T>(
    vertices: &mut [Vertex],
    values: Vec<T>,
    what: &'static str,
    set: impl Fn(&mut Vertex, T),
) -> Result<(), Error> {
    if values.len() != vertices.len() {
        return Err(Error::Format(what));
    }
    for (vertex, value) in vertices.iter_mut().zip(values) {
        set(vertex, value);
    }
    Ok(())
}
