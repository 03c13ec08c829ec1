//! Shapes of plants and stones: triangles with colours, in four sizes each, made once.

mod boulder;
mod broadleaf;
mod canopy;
mod corner_stone;
mod crown;
mod low;
mod mesh;
mod palm;
mod plan;
mod snag;
mod spruce;
mod stump;
#[cfg(test)]
#[expect(clippy::expect_used, reason = "tests fail by panicking")]
mod tests;
mod toadstool;
mod tree;
mod trunk;

use std::sync::LazyLock;

use glam::Vec3;

pub use low::low_shape;

use crate::species::{Age, Species};

/// What a corner is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Material {
    /// Bark, wood and stems.
    Wood,
    /// Leaves, needles and caps.
    Leaves,
    /// Stone.
    Stone,
    /// Grass, of the colour of its ground.
    Blade,
    /// Other small growth.
    Petal,
    /// Crystal.
    Crystal,
}

/// How large a plant is in the picture, and so how many triangles it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Size {
    /// Close by: 400 to 600 triangles, fewer of what is simple.
    Near,
    /// Farther off: 60 to 80 triangles.
    Middle,
    /// Where crowns are still seen to be round: 16 to 36 triangles.
    Coarse,
    /// A few pixels: 8 to 12 triangles.
    Far,
}

impl Size {
    /// All, from the one with the most triangles.
    pub const ALL: [Self; 4] = [Self::Near, Self::Middle, Self::Coarse, Self::Far];
}

/// A corner of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Its place, metres: y is up, and the root is at the origin.
    pub place: Vec3,
    /// Which way it faces: of length one.
    pub normal: Vec3,
    /// Its colour, sRGB, shade by the plant's own parts included.
    pub colour: [u8; 3],
    /// What it is made of.
    pub material: Material,
    /// How far wind moves it, from 0 (stiff) to 1.
    pub sway: f32,
}

/// Triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// The corners.
    pub corners: Vec<Corner>,
    /// Three indices into the corners for each triangle.
    pub triangles: Vec<[u16; 3]>,
}

impl Shape {
    /// The smallest and the largest of each coordinate over all corners, metres; zeros of an empty shape.
    pub fn limits(&self) -> [Vec3; 2] {
        let mut places = self.corners.iter().map(|corner| corner.place);
        let first = places.next().unwrap_or(Vec3::ZERO);
        places.fold([first, first], |[low, high], place| {
            [low.min(place), high.max(place)]
        })
    }
}

/// The shapes of each species, age and size, the sizes of one plant next to one another.
static SHAPES: LazyLock<Vec<Shape>> = LazyLock::new(|| {
    let plants = Species::ALL
        .iter()
        .flat_map(|&species| Age::ALL.iter().map(move |&age| (species, age)));
    plants
        .flat_map(|(species, age)| plan::grow(species, age))
        .collect()
});

/// The shape of a plant.
pub fn shape(species: Species, age: Age, size: Size) -> &'static Shape {
    let kind = Species::ALL
        .iter()
        .position(|&other| other == species)
        .unwrap_or(0);
    &SHAPES[(kind * Age::ALL.len() + age as usize) * Size::ALL.len() + size as usize]
}
