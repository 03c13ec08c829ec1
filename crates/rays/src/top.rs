//! Instances as the shaders have them, and the upper level of the hierarchy: a box for all that stays, and one for each mover,
//! made anew whenever they move.

use bytemuck::{Pod, Zeroable};
use glam::{Affine3A, Mat3A, Vec3, Vec4};

use crate::error::RaysError;
use crate::scene::{Instance, Mover};
use crate::tree::{INSTANCE, NOTHING, Node, Tree};

/// What instances take up in their texture.
pub const INSTANCE_TEXELS: usize = 8;
/// Instances of meshes that move there may be at most; `MOVES` of scene.wgsl.
pub const MOST_MOVERS: usize = 512;
/// Flags of an instance: its triangles are in its own coordinates; light of the eye passes it; all other light does.
const MOVES: u32 = 1;
const UNSEEN: u32 = 2;
const HELD: u32 = 4;

/// An instance, as scene.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedInstance {
    rows: [Vec4; 3],
    root: u32,
    object: u32,
    materials: u32,
    flags: u32,
    scale: Vec4,
    cut: Vec4,
    room: [Vec4; 2],
}

/// A mesh that may move and lies in the adapter's memory.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Its box; none of a mesh without triangles.
    pub bounds: Option<(Vec3, Vec3)>,
    /// What the root of its hierarchy is.
    pub root: u32,
    /// The greatest number of a material.
    pub most_material: usize,
}

/// What stays.
#[derive(Clone, Copy, Debug)]
pub struct Resting {
    /// Its box; none where there is nothing.
    pub bounds: Option<(Vec3, Vec3)>,
    /// What the root of its hierarchy is.
    pub root: u32,
    /// Instances that stay; the numbers of those that move come after theirs.
    pub instances: u32,
    /// Materials of the scene.
    pub materials: usize,
}

/// The upper level.
#[derive(Clone, Debug, Default)]
pub struct Top {
    /// What a path begins with.
    pub root: u32,
    /// Nodes, numbered from 0.
    pub nodes: Vec<Node>,
    /// The movers, in their order.
    pub instances: Vec<PackedInstance>,
}

/// Puts movers beside what stays.
pub fn build(movers: &[Mover], meshes: &[Placed], resting: &Resting) -> Result<Top, RaysError> {
    if movers.len() > MOST_MOVERS {
        return Err(RaysError::TooLarge {
            what: format!("{} things that move", movers.len()),
            most: MOST_MOVERS as u64,
        });
    }
    let mut top = Top::default();
    let (mut boxes, mut leaves) = (Vec::new(), Vec::new());
    if let Some(bounds) = resting.bounds {
        boxes.push(bounds);
        leaves.push(resting.root);
    }
    for (number, mover) in movers.iter().enumerate() {
        let mesh = checked(mover, meshes, resting)?;
        top.instances.push(pack_mover(mover, mesh.root));
        if let Some(limits) = mesh.bounds {
            boxes.push(bounds(&mover.pose, limits));
            leaves.push(INSTANCE | (resting.instances + number as u32));
        }
    }
    let tree = Tree::new(&boxes, 1);
    let leaf = |first: u32| {
        let number = tree.order().get(first as usize);
        number.map_or(NOTHING, |number| leaves[*number as usize])
    };
    (top.root, top.nodes) = tree.packed(0, leaf);
    Ok(top)
}

fn checked<'a>(
    mover: &Mover,
    meshes: &'a [Placed],
    resting: &Resting,
) -> Result<&'a Placed, RaysError> {
    let refuse = |what| {
        let object = mover.object;
        Err(RaysError::Instance { object, what })
    };
    let Some(mesh) = meshes.get(mover.mesh) else {
        return refuse("is of a mesh that the room lacks. Load the model first");
    };
    if mover.materials + mesh.most_material >= resting.materials {
        return refuse("has a material that the room lacks. Give it another");
    }
    if !mover.pose.is_finite() || !mover.pose.inverse().is_finite() {
        return refuse("has no size. Make it larger than nought along every axis");
    }
    Ok(mesh)
}

/// The box of a posed box in the scene, a little too large rather than too small.
pub fn bounds(pose: &Affine3A, (low, high): (Vec3, Vec3)) -> (Vec3, Vec3) {
    let matrix = pose.matrix3;
    let middle = pose.transform_point3(0.5 * (low + high));
    let reach = Mat3A::from_cols(
        matrix.x_axis.abs(),
        matrix.y_axis.abs(),
        matrix.z_axis.abs(),
    ) * (0.5 * (high - low));
    let spare = 1e-6 * (middle.abs() + reach) + 1e-6;
    (middle - reach - spare, middle + reach + spare)
}

/// An instance that stays: its triangles are in metres of the scene.
pub fn pack(instance: &Instance) -> PackedInstance {
    packed(&instance.pose, instance.object, instance.materials)
}

fn pack_mover(mover: &Mover, root: u32) -> PackedInstance {
    PackedInstance {
        root,
        flags: MOVES | flag(mover.unseen_by_eye, UNSEEN) | flag(mover.held, HELD),
        cut: mover.cut.map_or(Vec4::ZERO, |it| plane_in(&mover.pose, it)),
        ..packed(&mover.pose, mover.object, mover.materials)
    }
}

/// A plane of the scene in a mesh's coordinates: n.(P x + p) + e = (P^T n).x + (n.p + e).
pub fn plane_in(pose: &Affine3A, plane: Vec4) -> Vec4 {
    let normal = plane.truncate();
    let turned = pose.matrix3.transpose() * normal;
    turned.extend(normal.dot(pose.translation.into()) + plane.w)
}

fn flag(is_on: bool, flag: u32) -> u32 {
    if is_on { flag } else { 0 }
}

fn packed(pose: &Affine3A, object: u32, materials: usize) -> PackedInstance {
    let inverse = pose.inverse();
    let rows = inverse.matrix3.transpose();
    let offset = inverse.translation;
    let matrix = pose.matrix3;
    PackedInstance {
        rows: [
            rows.x_axis.extend(offset.x),
            rows.y_axis.extend(offset.y),
            rows.z_axis.extend(offset.z),
        ],
        root: NOTHING,
        object,
        materials: materials as u32,
        flags: 0,
        scale: Vec4::new(
            matrix.x_axis.length(),
            matrix.y_axis.length(),
            matrix.z_axis.length(),
            0.0,
        ),
        cut: Vec4::ZERO,
        room: [Vec4::ZERO; 2],
    }
}
