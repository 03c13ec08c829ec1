//! Poses: where every node is from its parent, and how poses are mixed.

use glam::{Mat4, Quat, Vec3, Vec4};

use crate::skeleton::{Skeleton, Transform};

/// Where every node of a skeleton is from its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// One for each of [`Skeleton::joints`].
    pub locals: Vec<Transform>,
}

/// How much each node takes from a layer, 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Mask {
    /// One for each of [`Skeleton::joints`].
    pub shares: Vec<f32>,
}

impl Mask {
    /// All of what hangs from a node and the node itself, and nothing else.
    pub fn below(skeleton: &Skeleton, joint: usize) -> Self {
        let share = |j| {
            if skeleton.is_below(j, joint) {
                1.0
            } else {
                0.0
            }
        };
        Self {
            shares: (0..skeleton.joints.len()).map(share).collect(),
        }
    }
}

impl Pose {
    /// The bind pose, or whatever the file's nodes rest in.
    pub fn rest(skeleton: &Skeleton) -> Self {
        Self {
            locals: skeleton.joints.iter().map(|joint| joint.rest).collect(),
        }
    }

    /// Goes toward `other` by `share`, 0 to 1: a cross-fade whose ends are the two poses exactly.
    pub fn fade(&mut self, other: &Self, share: f32) {
        for (local, to) in self.locals.iter_mut().zip(&other.locals) {
            *local = between(local, to, share);
        }
    }

    /// Goes toward `over` by `share`, but each node only by its share of the mask: the upper body over a walk.
    pub fn layer(&mut self, over: &Self, mask: &Mask, share: f32) {
        for ((local, to), part) in self.locals.iter_mut().zip(&over.locals).zip(&mask.shares) {
            *local = between(local, to, share * part);
        }
    }

    /// The mean of several poses by weights of 0 or more, in any order; `None` where nothing has weight.
    ///
    /// Turns are summed as vectors of four, each on the side of the heaviest, and made unit length again: for two
    /// that is the shortest arc, and for more it does not depend on their order.
    pub fn mix(poses: &[(&Self, f32)]) -> Option<Self> {
        let sane = |weight: f32| weight.is_finite() && weight > 0.0;
        let poses: Vec<_> = poses.iter().filter(|(_, weight)| sane(*weight)).collect();
        let (heaviest, _) = poses.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let total: f32 = poses.iter().map(|(_, weight)| weight).sum();
        if poses.len() == 1 {
            return Some((*heaviest).clone());
        }
        let joint = |(j, lead): (usize, &Transform)| {
            let mut sum = (Vec3::ZERO, Vec4::ZERO, Vec3::ZERO);
            for (pose, weight) in &poses {
                let Some(local) = pose.locals.get(j) else {
                    continue;
                };
                let share = weight / total;
                let side = if local.rotation.dot(lead.rotation) < 0.0 {
                    -share
                } else {
                    share
                };
                sum.0 += local.translation * share;
                sum.1 += Vec4::from(local.rotation) * side;
                sum.2 += local.scale * share;
            }
            let rotation = sum.1.try_normalize().map_or(lead.rotation, Quat::from_vec4);
            Transform {
                translation: sum.0,
                rotation,
                scale: sum.2,
            }
        };
        Some(Self {
            locals: heaviest.locals.iter().enumerate().map(joint).collect(),
        })
    }

    /// Where every node is in the model: its own matrix after its parent's, which comes before it.
    pub fn model_matrices(&self, skeleton: &Skeleton) -> Vec<Mat4> {
        let mut out: Vec<Mat4> = Vec::with_capacity(self.locals.len());
        for (local, joint) in self.locals.iter().zip(&skeleton.joints) {
            let above = joint
                .parent
                .and_then(|p| out.get(p))
                .copied()
                .unwrap_or(Mat4::IDENTITY);
            out.push(above * local.matrix());
        }
        out
    }
}

fn between(a: &Transform, b: &Transform, share: f32) -> Transform {
    if share <= 0.0 {
        return *a;
    }
    if share >= 1.0 {
        return *b;
    }
    Transform {
        translation: a.translation.lerp(b.translation, share),
        // Slerp takes the short way, and turns evenly where a fade is slow.
        rotation: a.rotation.slerp(b.rotation, share),
        scale: a.scale.lerp(b.scale, share),
    }
}
