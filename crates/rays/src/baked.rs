//! Triangles and hierarchies ready for the adapter: of all that stays where it is together, and of each mesh that moves.

use std::ops::Range;
use std::sync::Arc;

use glam::Vec3;

use crate::error::RaysError;
use crate::mesh::{Mesh, TRIANGLE_TEXELS, bounds, triangle};
use crate::scene::{Instance, RayScene};
use crate::tree::{Node, TRIANGLES, Tree};
use crate::trees::Trees;

/// Triangles in a leaf at most.
const LEAF: u32 = 2;

/// What is ready for the adapter.
#[derive(Clone, Debug, Default)]
pub struct Baked {
    /// The hierarchy's nodes; children and triangles have the numbers that they have in the adapter's memory.
    pub nodes: Vec<Node>,
    /// Of the hierarchy.
    pub root: u32,
    /// Its box; none without triangles.
    pub bounds: Option<(Vec3, Vec3)>,
    /// Three texels for each triangle.
    pub triangles: Vec<[u32; 4]>,
    /// Three for each triangle.
    pub attributes: Vec<[u32; 4]>,
}

impl Baked {
    /// All instances that stay, in metres of the scene. Without sorting, each is a single leaf. Nodes are numbered from
    /// `node_base`, triangles from 0.
    pub fn room(scene: &RayScene, sorted: bool, node_base: u32) -> Result<Self, RaysError> {
        for (number, mesh) in scene.meshes.iter().enumerate() {
            mesh.check(number)?;
        }
        let of_instance = |it: &Instance| scene.meshes.get(it.mesh).map(|it| it.triangles.len());
        let count: usize = scene.instances.iter().filter_map(of_instance).sum();
        let mut listed = Vec::with_capacity(count);
        let mut whole = Vec::new();
        for (number, instance) in scene.instances.iter().enumerate() {
            let mesh = checked(instance, scene)?;
            let first = listed.len();
            listed.extend((0..mesh.triangles.len() as u32).map(|one| {
                let corners = mesh.corners(one, &mesh.positions);
                let corners = corners.map(|corner| instance.pose.transform_point3(corner));
                (number as u32, one, corners)
            }));
            if listed.len() > first {
                whole.push(first..listed.len());
            }
        }
        let boxes: Vec<_> = listed
            .iter()
            .map(|(.., corners)| bounds(*corners))
            .collect();
        let (tree, order, starts, ends) = if sorted {
            by_triangles(&boxes, &whole)
        } else {
            by_instances(&boxes, &whole)
        };
        let (root, nodes) = tree.packed(node_base, |first| TRIANGLES + starts[first as usize]);
        let mut baked = Self {
            nodes,
            root,
            bounds: tree.bounds(),
            triangles: Vec::with_capacity(count * TRIANGLE_TEXELS),
            attributes: Vec::with_capacity(count * TRIANGLE_TEXELS),
        };
        for (at, number) in order.iter().enumerate() {
            let (instance, one, corners) = listed[*number as usize];
            let mesh = &scene.meshes[scene.instances[instance as usize].mesh];
            let texels = triangle(corners, one, ends[at], instance);
            baked.triangles.extend(texels);
            let attributes = mesh.attributes(one, &mesh.positions, &mesh.normals);
            baked.attributes.extend(attributes);
        }
        Ok(baked)
    }
}

type Sorted = (Tree, Vec<u32>, Vec<u32>, Vec<bool>);

/// The order of triangles, where the leaf begins that a place in the order is in, and where leaves end.
fn by_triangles(boxes: &[(Vec3, Vec3)], whole: &[Range<usize>]) -> Sorted {
    let tree = Tree::with_groups(boxes, whole, LEAF);
    let order = tree.order().to_vec();
    let mut ends = vec![false; order.len()];
    tree.ends().for_each(|end| ends[end] = true);
    (tree, order, (0..boxes.len() as u32).collect(), ends)
}

fn by_instances(boxes: &[(Vec3, Vec3)], whole: &[Range<usize>]) -> Sorted {
    let of_all = |range: &Range<usize>| {
        let empty = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let grown = |(low, high): (Vec3, Vec3), (l, h): &(Vec3, Vec3)| (low.min(*l), high.max(*h));
        boxes[range.clone()].iter().fold(empty, grown)
    };
    let boxes: Vec<_> = whole.iter().map(of_all).collect();
    let tree = Tree::new(&boxes, 1);
    let (mut order, mut starts, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    for number in tree.order() {
        let range = &whole[*number as usize];
        starts.push(order.len() as u32);
        order.extend(range.clone().map(|one| one as u32));
        ends.resize(order.len(), false);
        if let Some(last) = ends.last_mut() {
            *last = true;
        }
    }
    (tree, order, starts, ends)
}

/// The mesh of an instance that can be drawn.
fn checked<'a>(instance: &Instance, scene: &'a RayScene) -> Result<&'a Mesh, RaysError> {
    let refuse = |what| {
        let object = instance.object;
        Err(RaysError::Instance { object, what })
    };
    let Some(mesh) = scene.meshes.get(instance.mesh) else {
        return refuse("is of a mesh that the room lacks. Load the model first");
    };
    let most = instance.materials + mesh.most_material().unwrap_or(0);
    if most >= scene.materials.len() {
        return refuse("has a material that the room lacks. Give it another");
    }
    if !instance.pose.is_finite() || !instance.pose.inverse().is_finite() {
        return refuse("has no size. Make it larger than nought along every axis");
    }
    Ok(mesh)
}

/// A mesh that may move and change its shape.
#[derive(Clone, Debug)]
pub struct Movable {
    mesh: Arc<Mesh>,
    tree: Tree,
    /// Numbers of its first node and of its first triangle.
    pub bases: (u32, u32),
}

impl Movable {
    /// Checks a mesh and makes its hierarchy, unless that is there; its nodes and triangles will have numbers from `bases` on.
    pub fn new(
        (mesh, number): (&Arc<Mesh>, usize),
        trees: &Trees,
        bases: (u32, u32),
    ) -> Result<Self, RaysError> {
        let tree = trees.of(mesh, |mesh| {
            mesh.check(number)?;
            Ok(Tree::new(&boxes(mesh, &mesh.positions), LEAF))
        })?;
        let mesh = mesh.clone();
        Ok(Self { mesh, tree, bases })
    }

    /// Nodes and triangles that it has.
    pub fn sizes(&self) -> (usize, usize) {
        (self.tree.node_count(), self.mesh.triangles.len())
    }

    /// The greatest number of a material; none without triangles.
    pub fn most_material(&self) -> Option<usize> {
        self.mesh.most_material()
    }

    /// As it is by itself.
    pub fn rest(&self) -> Baked {
        self.bake(&self.mesh.positions, &self.mesh.normals)
    }

    /// With its corners elsewhere.
    pub fn posed(
        &mut self,
        number: usize,
        places: &[Vec3],
        normals: &[Vec3],
    ) -> Result<Baked, RaysError> {
        let corners = self.mesh.positions.len();
        let lengths = |what| Err(RaysError::Lengths { mesh: number, what });
        if places.len() != corners {
            return lengths("places");
        }
        if !normals.is_empty() && normals.len() != corners {
            return lengths("normals");
        }
        if !places.iter().all(|place| place.is_finite()) {
            return Err(RaysError::Place { mesh: number });
        }
        self.tree.refit(&boxes(&self.mesh, places));
        Ok(self.bake(places, normals))
    }

    fn bake(&self, places: &[Vec3], normals: &[Vec3]) -> Baked {
        let (node_base, triangle_base) = self.bases;
        let leaf = |first| TRIANGLES + triangle_base + first;
        let (root, nodes) = self.tree.packed(node_base, leaf);
        let mut baked = Baked {
            nodes,
            root,
            bounds: self.tree.bounds(),
            ..Baked::default()
        };
        let mut ends = vec![false; self.tree.order().len()];
        self.tree.ends().for_each(|end| ends[end] = true);
        for (number, end) in self.tree.order().iter().zip(ends) {
            let corners = self.mesh.corners(*number, places);
            baked.triangles.extend(triangle(corners, *number, end, 0));
            let attributes = self.mesh.attributes(*number, places, normals);
            baked.attributes.extend(attributes);
        }
        baked
    }
}

fn boxes(mesh: &Mesh, places: &[Vec3]) -> Vec<(Vec3, Vec3)> {
    let numbers = 0..mesh.triangles.len() as u32;
    numbers
        .map(|one| bounds(mesh.corners(one, places)))
        .collect()
}
