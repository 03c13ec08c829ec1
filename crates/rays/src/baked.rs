//! Triangles and hierarchies ready for the adapter: of all that stays where it is together, and of each mesh that moves.

use std::sync::Arc;

use glam::Vec3;

use crate::error::RaysError;
use crate::mesh::{Mesh, TRIANGLE_TEXELS, bounds, triangle};
use crate::scene::{Instance, RayScene};
use crate::tree::{NOTHING, Node, TRIANGLES, Tree};
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
    /// All instances that stay, in metres of the scene: a hierarchy of them, and below it that of the mesh of each, which is made
    /// once for all of them. Without sorting, each is a single leaf. Nodes are numbered from `node_base`, triangles from 0.
    pub fn room(scene: &RayScene, sorted: bool, node_base: u32) -> Result<Self, RaysError> {
        for (number, mesh) in scene.meshes.iter().enumerate() {
            mesh.check(number)?;
        }
        let (mut standing, mut around) = (Vec::new(), Vec::new());
        for (number, instance) in scene.instances.iter().enumerate() {
            let mesh = checked(instance, scene)?;
            if !mesh.triangles.is_empty() {
                standing.push(number);
                around.push(box_about(&places_of(mesh, instance)));
            }
        }
        let top = Tree::new(&around, 1);
        let mut baked = Self {
            bounds: top.bounds(),
            ..Self::default()
        };
        let mut forms: Vec<_> = (scene.meshes.iter().map(|mesh| Form::new(mesh, sorted))).collect();
        let mut roots = vec![NOTHING; around.len()];
        let base = node_base + top.node_count() as u32;
        for at in top.order() {
            let number = standing[*at as usize];
            let instance = &scene.instances[number];
            let form = &mut forms[instance.mesh];
            let places = places_of(form.mesh, instance);
            roots[*at as usize] = baked.put(form, &places, (number as u32, base));
        }
        let root = |first| roots[top.order()[first as usize] as usize];
        let (root, mut nodes) = top.packed(node_base, root);
        nodes.append(&mut baked.nodes);
        Ok(Self {
            nodes,
            root,
            ..baked
        })
    }

    /// Appends an instance of a form, whose corners are there and whose number is this; nodes are numbered from `base`. Returns the
    /// number of its root.
    fn put(&mut self, form: &mut Form<'_>, places: &[Vec3], (number, base): (u32, u32)) -> u32 {
        form.tree.refit(&boxes(form.mesh, places));
        let first = (self.triangles.len() / TRIANGLE_TEXELS) as u32;
        let next = base + self.nodes.len() as u32;
        let (root, nodes) = form.tree.packed(next, |at| TRIANGLES + first + at);
        self.nodes.extend(nodes);
        for (one, ends) in form.tree.order().iter().zip(&form.ends) {
            let corners = form.mesh.corners(*one, places);
            self.triangles
                .extend(triangle(corners, *one, *ends, number));
        }
        self.attributes.extend_from_slice(&form.attributes);
        root
    }
}

/// A mesh of which instances stay.
struct Form<'a> {
    mesh: &'a Mesh,
    tree: Tree,
    /// Of each place in the tree's order whether a leaf ends there.
    ends: Vec<bool>,
    /// In the tree's order.
    attributes: Vec<[u32; 4]>,
}

impl<'a> Form<'a> {
    fn new(mesh: &'a Mesh, sorted: bool) -> Self {
        let boxes = boxes(mesh, &mesh.positions);
        let tree = if sorted {
            Tree::new(&boxes, LEAF)
        } else {
            Tree::leaf(&boxes)
        };
        let attributes = (tree.order().iter())
            .flat_map(|one| mesh.attributes(*one, &mesh.positions, &mesh.normals));
        Self {
            mesh,
            ends: tree.ends(),
            attributes: attributes.collect(),
            tree,
        }
    }
}

/// Where the corners of an instance are, metres of the scene.
fn places_of(mesh: &Mesh, instance: &Instance) -> Vec<Vec3> {
    let all = mesh.positions.iter();
    all.map(|it| instance.pose.transform_point3(*it)).collect()
}

fn box_about(places: &[Vec3]) -> (Vec3, Vec3) {
    let empty = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let grown = |(low, high): (Vec3, Vec3), it: &Vec3| (low.min(*it), high.max(*it));
    places.iter().fold(empty, grown)
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
        for (number, end) in self.tree.order().iter().zip(self.tree.ends()) {
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
