//! Portals as the shaders have them.

use antipode_deformation::{MAX_CORNERS, MAX_PORTALS, PlacedPortal, Space};
use bytemuck::{Pod, Zeroable};
use glam::{DMat3, Vec3, Vec4};

use crate::packed::stack;

/// A portal, as portal.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct PackedPortal {
    at: Vec3,
    scale: f32,
    normal: Vec3,
    partner: u32,
    right: Vec3,
    sides: u32,
    up: Vec3,
    first: u32,
    linear_x: Vec3,
    edges: u32,
    linear_y: Vec3,
    is_turned: u32,
    linear_z: Vec3,
    depth: u32,
    turn: [Vec4; 3],
    stack: [u32; 4],
}

/// All portals of a space, as portal.wgsl has them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedPortals {
    all: [PackedPortal; MAX_PORTALS],
    edges: [Vec4; MAX_PORTALS * MAX_CORNERS],
}

impl PackedPortals {
    /// Those of a space.
    pub fn of(space: &Space) -> Self {
        let mut packed = Self::zeroed();
        let mut first = 0;
        for (one, portal) in packed.all.iter_mut().zip(space.portals()) {
            *one = pack(portal, first);
            let edges = &mut packed.edges[first..first + portal.edges.len()];
            for (edge, it) in edges.iter_mut().zip(&portal.edges) {
                *edge = it.as_vec3().extend(0.0);
            }
            first += portal.edges.len();
        }
        packed
    }
}

fn pack(portal: &PlacedPortal, first: usize) -> PackedPortal {
    let linear = portal.map.matrix3;
    let turn = DMat3::from_quat(portal.turn);
    let row = |m: &DMat3, i: usize| m.row(i).as_vec3();
    PackedPortal {
        at: portal.portal.at.as_vec3(),
        scale: portal.scale as f32,
        normal: portal.normal.as_vec3(),
        partner: portal.portal.to as u32,
        right: portal.right.as_vec3(),
        sides: 1 + u32::from(portal.portal.two_sided),
        up: portal.up.as_vec3(),
        first: first as u32,
        linear_x: row(&linear, 0),
        edges: portal.edges.len() as u32,
        linear_y: row(&linear, 1),
        is_turned: u32::from(portal.is_turned()),
        linear_z: row(&linear, 2),
        depth: portal.stack.len() as u32,
        turn: [0, 1, 2].map(|i| row(&turn, i).extend(0.0)),
        stack: stack(&portal.stack),
    }
}
