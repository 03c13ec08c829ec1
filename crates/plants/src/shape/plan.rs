//! Which shape each species and age grows into.

use super::mesh::match_tones;
use super::{
    Shape, Size, boulder, broadleaf, canopy, corner_stone, palm, snag, spruce, stump, toadstool,
};
use crate::species::{Age, Species};

/// The lengths that a plant's shape keeps to, metres.
#[derive(Clone, Copy)]
pub(super) struct Build {
    /// How old it is.
    pub age: Age,
    /// Its height.
    pub height: f32,
    /// How far its crown reaches.
    pub radius: f32,
    /// The radius of its trunk.
    pub trunk: f32,
}

impl Build {
    /// One of three values by age.
    pub(super) fn by_age<T>(&self, young: T, grown: T, old: T) -> T {
        match self.age {
            Age::Young => young,
            Age::Grown => grown,
            Age::Old => old,
        }
    }
}

/// The sizes of a plant.
pub(super) fn grow(species: Species, age: Age) -> [Shape; 4] {
    let build = Build {
        age,
        height: species.height_m(age) as f32,
        radius: species.radius_m(age) as f32,
        trunk: species
            .trunk(age)
            .map_or(0.0, |trunk| trunk.radius_m as f32),
    };
    let [near, mut simpler @ ..] = Size::ALL.map(|size| match species {
        Species::Spruce => spruce::grow(build, size),
        Species::Palm => palm::grow(build, size),
        Species::Snag => snag::grow(build, size),
        Species::Toadstool => toadstool::grow(build, size),
        Species::Boulder => boulder::grow(build, size),
        Species::CornerStone => corner_stone::grow(build, size),
        Species::Stump => stump::grow(build, size, &stump::WOOD),
        Species::Stalk => stump::grow(build, size, &stump::FLESH),
        Species::Oak => broadleaf::oak(build).shape(size),
        Species::Birch => broadleaf::birch(build).shape(size),
        Species::Acacia => canopy::acacia(build).shape(size),
        Species::Willow => canopy::willow(build).shape(size),
        Species::Kapok => canopy::kapok(build).shape(size),
        Species::Bush => broadleaf::bush(build).shape(size),
    });
    for shape in &mut simpler {
        match_tones(&near, shape);
    }
    let [middle, coarse, far] = simpler;
    [near, middle, coarse, far]
}
