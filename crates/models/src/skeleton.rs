//! Nodes and how they hang from each other, and skins that tie vertices to them.

use glam::{Mat4, Quat, Vec3};
use gltf::json;

use crate::accessor::Source;
use crate::error::Error;
use crate::primitive::FARTHEST_M;

/// No model has more nodes than this.
const MOST_NODES: usize = 1024;
/// No node is larger or smaller than its parent by more than this.
const MOST_SCALE: f32 = 1.0e4;

/// A place, a turn and a size; scales first, then turns, then moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Metres.
    pub translation: Vec3,
    /// Of unit length.
    pub rotation: Quat,
    /// Factors along the axes.
    pub scale: Vec3,
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Self = Self {
        translation: Vec3::ZERO,
        rotation: Quat::IDENTITY,
        scale: Vec3::ONE,
    };

    /// The same as a matrix.
    pub fn matrix(&self) -> Mat4 {
        Mat4::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
    }
}

/// A node.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Its name in the file.
    pub name: String,
    /// What it hangs from; always before it in [`Skeleton::joints`].
    pub parent: Option<usize>,
    /// Where it is from its parent when no clip says otherwise.
    pub rest: Transform,
}

/// All nodes of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// Parents come before children.
    pub joints: Vec<Joint>,
}

impl Skeleton {
    /// The node of that name.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|joint| joint.name == name)
    }

    /// Whether `joint` is `above` or hangs from it, however far.
    pub fn is_below(&self, joint: usize, above: usize) -> bool {
        std::iter::successors(Some(joint), |&j| self.joints.get(j)?.parent).any(|j| j == above)
    }
}

/// What ties the vertices of a mesh to nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// Nodes in the order in which vertices number them.
    pub joints: Vec<usize>,
    /// For each joint, from the bind pose to the joint's own axes.
    pub inverse_bind: Vec<Mat4>,
}

impl Skin {
    /// What vertices of the bind pose are multiplied by, given where each node is in the model: a vertex bound to a
    /// joint keeps its place in that joint's axes, so it is carried into them as bound and out of them as posed.
    pub fn matrices(&self, model_matrices: &[Mat4]) -> Vec<Mat4> {
        let matrix = |(&joint, &inverse): (&usize, &Mat4)| {
            model_matrices.get(joint).map_or(inverse, |m| *m * inverse)
        };
        self.joints
            .iter()
            .zip(&self.inverse_bind)
            .map(matrix)
            .collect()
    }
}

/// The skeleton, and which of its joints each of the file's nodes became.
pub struct Nodes {
    /// The skeleton.
    pub skeleton: Skeleton,
    /// For each node of the file; nodes outside the scene have none.
    pub joint_of: Vec<Option<usize>>,
}

impl Source<'_> {
    /// The nodes of the file's scene, parents first.
    pub fn nodes(self) -> Result<Nodes, Error> {
        let root = self.root;
        if root.nodes.len() > MOST_NODES {
            return Err(Error::TooMany("nodes"));
        }
        let scene = root
            .scenes
            .get(root.scene.map_or(0, |s| s.value()))
            .ok_or(Error::Empty)?;
        let mut joint_of = vec![None; root.nodes.len()];
        let mut joints = Vec::new();
        let mut waiting: Vec<_> = scene
            .nodes
            .iter()
            .rev()
            .map(|n| (n.value(), None))
            .collect();
        while let Some((index, parent)) = waiting.pop() {
            let node = root.nodes.get(index).ok_or(Error::OutOfRange("nodes"))?;
            // Each node is met once, so a circle or a second parent ends here.
            if joint_of[index].is_some() {
                return Err(Error::NotATree);
            }
            let at = joints.len();
            joint_of[index] = Some(at);
            let name = node.name.clone().unwrap_or_else(|| format!("node {index}"));
            joints.push(Joint {
                name,
                parent,
                rest: rest(node)?,
            });
            let children = node.children.iter().flatten().rev();
            waiting.extend(children.map(|child| (child.value(), Some(at))));
            if waiting.len() > MOST_NODES {
                return Err(Error::NotATree);
            }
        }
        Ok(Nodes {
            skeleton: Skeleton { joints },
            joint_of,
        })
    }

    /// All skins.
    pub fn skins(self, nodes: &Nodes) -> Result<Vec<Skin>, Error> {
        let joint = |node: &json::Index<json::Node>| {
            nodes
                .joint_of
                .get(node.value())
                .copied()
                .flatten()
                .ok_or(Error::OutOfRange("joints"))
        };
        let mut out = Vec::with_capacity(self.root.skins.len());
        for skin in &self.root.skins {
            if skin.joints.len() > MOST_NODES {
                return Err(Error::TooMany("joints"));
            }
            let joints = skin
                .joints
                .iter()
                .map(joint)
                .collect::<Result<Vec<_>, _>>()?;
            let inverse_bind: Vec<Mat4> = match skin.inverse_bind_matrices {
                Some(index) => self
                    .floats::<16>(index, "bind poses")?
                    .iter()
                    .map(Mat4::from_cols_array)
                    .collect(),
                None => vec![Mat4::IDENTITY; joints.len()],
            };
            if inverse_bind.len() < joints.len() {
                return Err(Error::Format("bind poses"));
            }
            if inverse_bind.iter().any(|m| {
                m.to_cols_array()
                    .iter()
                    .any(|c| c.abs() > MOST_SCALE * FARTHEST_M)
            }) {
                return Err(Error::Absurd("bind poses"));
            }
            out.push(Skin {
                inverse_bind: inverse_bind[..joints.len()].to_vec(),
                joints,
            });
        }
        Ok(out)
    }
}

fn rest(node: &json::Node) -> Result<Transform, Error> {
    let given = match node.matrix {
        Some(matrix) => {
            let (scale, rotation, translation) =
                Mat4::from_cols_array(&matrix).to_scale_rotation_translation();
            Transform {
                translation,
                rotation,
                scale,
            }
        }
        None => Transform {
            translation: node.translation.map_or(Vec3::ZERO, Vec3::from),
            rotation: node
                .rotation
                .map_or(Quat::IDENTITY, |q| Quat::from_array(q.0)),
            scale: node.scale.map_or(Vec3::ONE, Vec3::from),
        },
    };
    checked(given).ok_or(Error::Absurd("nodes"))
}

/// The transform with its turn of unit length, if all its numbers are sane.
pub fn checked(t: Transform) -> Option<Transform> {
    let size = t.rotation.length();
    let sane = t.translation.is_finite()
        && t.translation.abs().max_element() <= FARTHEST_M
        && t.scale.is_finite()
        && t.scale.abs().max_element() <= MOST_SCALE
        && size.is_finite()
        && (0.5..2.0).contains(&size);
    sane.then(|| Transform {
        rotation: t.rotation.normalize(),
        ..t
    })
}
