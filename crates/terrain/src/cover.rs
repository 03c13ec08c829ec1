//! What the ground is covered with, for those who walk on it: the kinds of ground that the colours show.

use antipode_geometry::ChartPoint;
use glam::Vec3;

use crate::colour::Painter;
use crate::field::Field;

/// What one walks on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Cover {
    /// Bare rock: all steep faces.
    Rock,
    /// Loose stones, cinders and ash.
    Gravel,
    /// Sand.
    Sand,
    /// Earth and mud.
    Soil,
    /// Grass, moss and leaves.
    Grass,
}

impl Cover {
    /// Every kind.
    pub const ALL: [Self; 5] = [
        Self::Rock,
        Self::Gravel,
        Self::Sand,
        Self::Soil,
        Self::Grass,
    ];

    /// The lower-case English word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rock => "rock",
            Self::Gravel => "gravel",
            Self::Sand => "sand",
            Self::Soil => "soil",
            Self::Grass => "grass",
        }
    }
}

impl Field {
    /// What covers ground with this unit normal at a point: of the kinds whose colours mix there, the one that
    /// shows most.
    pub fn cover(&self, point: ChartPoint, normal: Vec3) -> Cover {
        let shares = Painter::new(self).shares(point, normal);
        let [low, middle, high] = self.biome_at(point).covers;
        if shares.rock > 0.5 {
            Cover::Rock
        } else if shares.high > 0.5 {
            high
        } else if shares.middle > 0.5 {
            middle
        } else {
            low
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, reason = "tests fail by panicking")]

    use antipode_geometry::{Geometry, strategy};
    use glam::DVec3;

    use super::*;
    use crate::generator::Generator;

    fn at(seed: u64, height_m: f64, normal: Vec3) -> Cover {
        let field = Field::made_by(
            Generator::OneBiome,
            seed,
            strategy(Geometry::Euclidean, 0.0),
        );
        field.cover(ChartPoint::a(DVec3::new(3.0, height_m, -8.0)), normal)
    }

    #[test]
    fn steep_faces_are_rock_in_every_biome() {
        let steep = Vec3::new(0.98, 0.2, 0.0).normalize();
        for seed in 0..5 {
            for height_m in [1.0, 12.0, 24.0] {
                assert_eq!(at(seed, height_m, steep), Cover::Rock, "{seed} {height_m}");
            }
        }
    }

    #[test]
    fn level_ground_is_what_its_biome_and_height_say() {
        // Far from the borders at 10 and 14 to 23 m, beyond what wandering moves them by.
        let levels = |seed| [1.0, 33.0].map(|height_m| at(seed, height_m, Vec3::Y));
        assert_eq!(levels(0), [Cover::Rock, Cover::Gravel], "volcanic");
        assert_eq!(levels(1), [Cover::Gravel, Cover::Sand], "desert");
        assert_eq!(levels(2), [Cover::Soil, Cover::Grass], "forest");
        assert_eq!(levels(3), [Cover::Soil, Cover::Grass], "toxic");
        assert_eq!(levels(4), [Cover::Soil, Cover::Grass], "jungle");
    }

    #[test]
    fn the_border_is_where_the_colours_change_most() {
        let field = Field::made_by(Generator::OneBiome, 1, strategy(Geometry::Euclidean, 0.0));
        let painter = Painter::new(&field);
        for n in 0..400 {
            let pos = DVec3::new(f64::from(n) * 0.7, 6.0 + f64::from(n) * 0.02, 2.0);
            let point = ChartPoint::a(pos);
            let [red, ..] = painter.paint(point, Vec3::Y, 0, 0.0);
            // Gravel is (166, 96, 66) and sand (220, 164, 102), each mottled by at most a tenth in light.
            match field.cover(point, Vec3::Y) {
                Cover::Gravel => assert!(red < 205, "{pos} {red}"),
                Cover::Sand => assert!(red > 184, "{pos} {red}"),
                other => panic!("{other:?} at {pos}"),
            }
        }
    }
}
