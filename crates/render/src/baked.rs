//! Meshes of what grows, put together from shapes in the vertices of the land.

use std::f32::consts::TAU;

use antipode_geometry::CHUNK_CELLS;
use antipode_plants::{Corner, Material, Shape, Size, shape};
use antipode_terrain::{Thing, Tuft, Vertex};
use glam::Vec3;

use crate::land_mesh::LandMesh;
use crate::pages::Pages;
use crate::parts::{Block, parts};
use crate::things::kind_of;

/// How far a thing may reach out of its chunk, whole metres: the corner that its mesh is told from lies so far before the
/// chunk's along each axis.
pub const MARGIN_M: i32 = 16;
/// How long the sides of the blocks of things are in the plan, metres.
const THINGS_BLOCK_M: f32 = 16.0;
/// How far wind and cars move what grows, metres: leaves that a car presses go aside by 0.86 m, wind bends them by 0.17 m.
const MOVES_M: f32 = 1.1;
/// How much the normals of leaves lean upwards: light comes through them from above, so that a crown is not black from below.
const LEAVES_UP: f32 = 0.6;
/// The numbers of what they are made of in the fourth byte of vertices; surfaces.wgsl. Above them is how much of the sky is left:
/// over what has a number in a save, all of it.
const WOOD: u8 = 15;
const LEAVES: u8 = 16;
const STONE: u8 = 5;
const CRYSTAL: u8 = 14;
/// What stands still of small growth, and what sways; plants.wgsl.
const STILL: u8 = 17;
const SWAYS: u8 = 18;
const SKY_SHIFT: u8 = 5;
const OPEN_SKY: u8 = 6 << SKY_SHIFT;

/// A mesh of things in a size.
#[derive(Default)]
pub struct Baked {
    pub vertices: Vec<Vertex>,
    indices: Vec<u32>,
    /// What lies together, near the eye; none where all is drawn or nothing.
    blocks: Vec<Block>,
}

impl Baked {
    /// Things, each in its size; near an eye in blocks, the nearest first.
    pub fn of(things: &[Thing], sizes: impl Iterator<Item = Size>, eye: Option<Vec3>) -> Self {
        let mut all = Self::default();
        let mut pairs: Vec<_> = things.iter().zip(sizes).collect();
        let Some(eye) = eye else {
            for (thing, size) in pairs {
                all.add(thing, size);
            }
            return all;
        };
        // What is drawn first hides what is behind it before that is lit.
        let away = |thing: &Thing| thing.root.distance_squared(eye);
        pairs.sort_by(|(a, _), (b, _)| away(a).total_cmp(&away(b)));
        let mut blocks: Vec<(usize, Vec<_>)> = Vec::new();
        for pair in pairs {
            let number = block_at(pair.0.root, THINGS_BLOCK_M);
            match blocks.iter_mut().find(|(it, _)| *it == number) {
                Some((_, block)) => block.push(pair),
                None => blocks.push((number, vec![pair])),
            }
        }
        for (_, block) in blocks {
            all.add_block(|all| block.iter().for_each(|(thing, size)| all.add(thing, *size)));
        }
        all
    }

    /// Adds what lies together.
    pub fn add_block(&mut self, add: impl FnOnce(&mut Self)) {
        let first = (self.vertices.len(), self.indices.len() as u32);
        add(self);
        let places = self.vertices[first.0..].iter().map(Vertex::position);
        let none = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        let [min, max] = places.fold(none, |[min, max], at| [min.min(at), max.max(at)]);
        if min.is_finite() {
            self.blocks.push(Block {
                indices: first.1..self.indices.len() as u32,
                min: min - MARGIN_M as f32 - MOVES_M,
                max: max - MARGIN_M as f32 + MOVES_M,
            });
        }
    }

    fn add(&mut self, thing: &Thing, size: Size) {
        let Some((species, age)) = kind_of(thing) else {
            return;
        };
        let root = thing.root + Vec3::splat(MARGIN_M as f32);
        let (sin, cos) = thing.turn_rad.sin_cos();
        let turned = |v: Vec3| Vec3::new(v.x * cos - v.z * sin, v.y, v.x * sin + v.z * cos);
        self.put_up(thing, shape(species, age, size), root, turned);
    }

    /// Adds a shape whose root comes to a place, turned so.
    pub fn put_up(
        &mut self,
        thing: &Thing,
        shape: &Shape,
        root: Vec3,
        turned: impl Fn(Vec3) -> Vec3,
    ) {
        let first = self.vertices.len() as u32;
        let vertex = |corner: &Corner| {
            let [r, g, b] = corner.colour;
            let (made_of, up) = match corner.material {
                Material::Wood => (WOOD, 0.0),
                Material::Leaves => (LEAVES, LEAVES_UP),
                Material::Stone => (STONE, 0.0),
                Material::Crystal => (CRYSTAL, 0.0),
                Material::Blade | Material::Petal => (low_number(corner), 0.0),
            };
            let made_of = made_of | OPEN_SKY;
            let place = root + turned(corner.place * thing.scale);
            let normal = turned(corner.normal) + Vec3::Y * up;
            Vertex::wide(place, normal, [r, g, b, made_of])
        };
        self.vertices.extend(shape.corners.iter().map(vertex));
        let corners = shape.triangles.iter().flatten();
        self.indices
            .extend(corners.map(|&corner| first + u32::from(corner)));
    }

    /// Adds small growth, so large.
    pub fn add_tuft(&mut self, tuft: &Tuft, shape: &Shape, size: f32) {
        let first = self.vertices.len() as u32;
        let [r, g, b, sky] = tuft.ground;
        let ground = [r, g, b].map(f32::from);
        let (sin, cos) = (f32::from(tuft.turn) * (TAU / 256.0)).sin_cos();
        let turned = |v: Vec3| Vec3::new(v.x * cos - v.z * sin, v.y, v.x * sin + v.z * cos);
        let root = tuft.root + Vec3::splat(MARGIN_M as f32);
        let vertex = |corner: &Corner| {
            let mut colour = corner.colour;
            if corner.material == Material::Blade {
                // Half way between black and white it is the ground's own.
                colour = std::array::from_fn(|i| {
                    (ground[i] * f32::from(corner.colour[i]) / 128.0).min(255.0) as u8
                });
            }
            let [r, g, b] = colour;
            let number = if corner.material == Material::Crystal {
                CRYSTAL
            } else {
                low_number(corner)
            };
            let made_of = number | sky << SKY_SHIFT;
            let place = root + turned(corner.place * size);
            Vertex::wide(place, turned(corner.normal), [r, g, b, made_of])
        };
        self.vertices.extend(shape.corners.iter().map(vertex));
        let corners = shape.triangles.iter().flatten();
        self.indices
            .extend(corners.map(|&corner| first + u32::from(corner)));
    }

    /// How many corners it has.
    pub fn corners(&self) -> usize {
        self.vertices.len()
    }

    /// Puts it into pages.
    pub fn put(self, pages: &mut Pages) -> LandMesh {
        let mut sections: [&[u32]; crate::parts::SECTIONS] = Default::default();
        sections[0] = &self.indices;
        LandMesh::put(pages, parts(&self.vertices, sections, &self.blocks))
    }
}

/// The number of the block that a place lies in, metres from the chunk's corner, of blocks with sides so long in the plan.
pub fn block_at(place: Vec3, side_m: f32) -> usize {
    let along = (CHUNK_CELLS as f32 / side_m) as usize;
    let number = |at: f32| ((at / side_m) as usize).min(along - 1);
    number(place.x) + along * number(place.z)
}

/// The number of a corner of small growth.
fn low_number(corner: &Corner) -> u8 {
    if corner.sway > 0.5 { SWAYS } else { STILL }
}

const _: () = assert!(
    2 * MARGIN_M + CHUNK_CELLS <= 64,
    "vertices reach no farther"
);
