//! The upper level of the hierarchy: a box for each instance, made anew whenever they move.

use antipode_deformation::Bvh;
use bytemuck::{Pod, Zeroable};
use glam::{Mat3A, Vec3, Vec4};

use crate::error::RaysError;
use crate::mesh::Node;
use crate::scene::Instance;

/// An instance, as scene.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedInstance {
    rows: [Vec4; 3],
    root: u32,
    object: u32,
    materials: u32,
    room: u32,
    scale: Vec4,
}

/// What is known of a mesh that lies in the adapter's memory.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Its box.
    pub low: Vec3,
    /// Its box.
    pub high: Vec3,
    /// Number of its root, from the first node of all meshes.
    pub root: u32,
    /// The greatest number of a material, or none for a mesh without triangles.
    pub most_material: Option<u32>,
}

/// Nodes of the upper level and the instances in the order of its leaves. `base` is the number that the first node of all
/// meshes has.
pub fn build(
    instances: &[Instance],
    meshes: &[Placed],
    materials: usize,
    base: u32,
) -> Result<(Vec<Node>, Vec<PackedInstance>), RaysError> {
    let mut boxes = Vec::with_capacity(instances.len());
    let mut packed = Vec::with_capacity(instances.len());
    for instance in instances {
        let refuse = |what| {
            Err(RaysError::Instance {
                object: instance.object,
                what,
            })
        };
        let Some(mesh) = meshes.get(instance.mesh) else {
            return refuse("is of a mesh that the room lacks. Load the model first");
        };
        let Some(most) = mesh.most_material else {
            continue;
        };
        if instance.materials + most as usize >= materials {
            return refuse("has a material that the room lacks. Give it another");
        }
        let inverse = instance.pose.inverse();
        if !inverse.is_finite() || !instance.pose.is_finite() {
            return refuse("has no size. Make it larger than nought along every axis");
        }
        boxes.push(bounds(instance, mesh));
        packed.push(pack(instance, mesh, base));
    }
    let bvh = Bvh::with_leaves(&boxes, 1);
    let nodes = bvh.nodes().iter().map(Node::from).collect();
    let ordered = bvh
        .order()
        .iter()
        .map(|number| packed[*number as usize])
        .collect();
    Ok((nodes, ordered))
}

/// The box of an instance in the scene, a little too large rather than too small.
fn bounds(instance: &Instance, mesh: &Placed) -> (Vec3, Vec3) {
    let matrix = instance.pose.matrix3;
    let middle = instance.pose.transform_point3(0.5 * (mesh.low + mesh.high));
    let half = 0.5 * (mesh.high - mesh.low);
    let reach = Mat3A::from_cols(
        matrix.x_axis.abs(),
        matrix.y_axis.abs(),
        matrix.z_axis.abs(),
    ) * half;
    let spare = 1e-6 * (middle.abs() + reach) + 1e-6;
    (middle - reach - spare, middle + reach + spare)
}

fn pack(instance: &Instance, mesh: &Placed, base: u32) -> PackedInstance {
    let inverse = instance.pose.inverse();
    let rows = inverse.matrix3.transpose();
    let offset = inverse.translation;
    let matrix = instance.pose.matrix3;
    PackedInstance {
        rows: [
            rows.x_axis.extend(offset.x),
            rows.y_axis.extend(offset.y),
            rows.z_axis.extend(offset.z),
        ],
        root: base + mesh.root,
        object: instance.object,
        materials: instance.materials as u32,
        room: 0,
        scale: Vec4::new(
            matrix.x_axis.length(),
            matrix.y_axis.length(),
            matrix.z_axis.length(),
            0.0,
        ),
    }
}
