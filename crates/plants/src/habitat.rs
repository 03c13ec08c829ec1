//! What grows and lies in each biome, and how densely.

use crate::species::Species;

/// What a biome bears.
#[derive(Debug)]
pub struct Habitat {
    /// Its name, as of the terrain's table.
    pub biome: &'static str,
    /// The share of the cells of 16 m2 that have a tree where its groves are densest; and where they are thinnest, as a share
    /// of that.
    pub trees: (f32, f32),
    /// Which trees, and how many of each beside the others.
    pub species: &'static [(Species, f32)],
    /// The share of the other cells that have a bush.
    pub bushes: f32,
    /// The share of all that is left that has a boulder.
    pub boulders: f32,
}

/// Every biome's.
const ALL: [Habitat; 9] = [
    Habitat {
        biome: "forest",
        trees: (0.72, 0.08),
        species: &[
            (Species::Oak, 5.0),
            (Species::Birch, 3.0),
            (Species::Spruce, 1.5),
        ],
        bushes: 0.07,
        boulders: 0.012,
    },
    Habitat {
        biome: "jungle",
        trees: (0.66, 0.14),
        species: &[
            (Species::Kapok, 3.0),
            (Species::Palm, 4.0),
            (Species::Oak, 0.6),
        ],
        bushes: 0.14,
        boulders: 0.006,
    },
    Habitat {
        biome: "tundra",
        trees: (0.30, 0.0),
        species: &[(Species::Spruce, 6.0), (Species::Birch, 0.6)],
        bushes: 0.01,
        boulders: 0.02,
    },
    Habitat {
        biome: "wetland",
        trees: (0.26, 0.04),
        species: &[(Species::Willow, 5.0), (Species::Birch, 1.5)],
        bushes: 0.12,
        boulders: 0.004,
    },
    Habitat {
        biome: "desert",
        trees: (0.07, 0.02),
        species: &[(Species::Acacia, 1.0)],
        bushes: 0.02,
        boulders: 0.014,
    },
    Habitat {
        biome: "shore",
        trees: (0.15, 0.03),
        species: &[(Species::Palm, 5.0), (Species::Acacia, 0.5)],
        bushes: 0.03,
        boulders: 0.01,
    },
    Habitat {
        biome: "volcanic",
        trees: (0.10, 0.02),
        species: &[(Species::Snag, 1.0)],
        bushes: 0.0,
        boulders: 0.035,
    },
    Habitat {
        biome: "toxic",
        trees: (0.24, 0.03),
        species: &[(Species::Toadstool, 5.0), (Species::Snag, 2.0)],
        bushes: 0.03,
        boulders: 0.012,
    },
    Habitat {
        biome: "crags",
        trees: (0.14, 0.0),
        species: &[(Species::Spruce, 5.0), (Species::Snag, 1.0)],
        bushes: 0.02,
        boulders: 0.05,
    },
];

impl Habitat {
    /// That of a biome; none of one that bears nothing.
    pub fn of(biome: &str) -> Option<&'static Self> {
        ALL.iter().find(|it| it.biome == biome)
    }

    /// The tree at a share, 0 to 1, of all that grow here.
    pub fn tree(&self, share: f32) -> Option<Species> {
        let all: f32 = self.species.iter().map(|(_, many)| many).sum();
        let mut left = share * all;
        let mut found = self.species.iter().filter(|(_, many)| {
            left -= many;
            left < 0.0
        });
        let last = self.species.last();
        found.next().or(last).map(|(species, _)| *species)
    }
}

#[cfg(test)]
mod tests {
    use antipode_terrain::Biome;

    use super::*;
    use crate::species::Species::{Birch, Oak, Spruce};

    #[test]
    fn every_biome_has_a_habitat_and_every_tree_grows_somewhere() {
        for biome in Biome::all() {
            assert!(Habitat::of(biome.name()).is_some(), "{}", biome.name());
        }
        for tree in Species::ALL.into_iter().filter(|it| it.is_tree()) {
            let grows = |it: &Habitat| it.species.iter().any(|(species, _)| *species == tree);
            assert!(ALL.iter().any(grows), "{tree:?}");
        }
    }

    #[test]
    fn trees_share_a_place_by_how_many_there_are() {
        let forest = Habitat::of("forest").into_iter();
        let found: Vec<_> = forest
            .flat_map(|it| [0.0, 0.5, 0.6, 0.9, 1.0].map(|share| it.tree(share)))
            .flatten()
            .collect();
        assert_eq!(found, [Oak, Oak, Birch, Spruce, Spruce]);
    }
}
