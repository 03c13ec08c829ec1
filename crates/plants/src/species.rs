//! What kinds of plants and stones there are, and what is known of each without its shape.

use antipode_terrain::Thing;

/// A kind of plant or stone. The numbers are those of saved worlds: none may ever change its meaning.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Species {
    /// A broad round crown on a short strong trunk: forests.
    Oak = 1,
    /// A tall narrow cone of drooping storeys: forests and cold land.
    Spruce = 2,
    /// A slender pale trunk and a light oval crown high up.
    Birch = 3,
    /// A bare curved trunk with a tuft of long leaves: shores and jungle.
    Palm = 4,
    /// A flat wide umbrella on a forked trunk: deserts.
    Acacia = 5,
    /// A wide crown that hangs down to the ground in curtains: wetland.
    Willow = 6,
    /// A very tall smooth trunk with buttresses and a layered flat crown at the top: jungle.
    Kapok = 7,
    /// A dead, forked, leafless trunk: volcanic land.
    Snag = 8,
    /// A mushroom as high as a tree, with a wide cap: toxic land.
    Toadstool = 9,
    /// A low round bush.
    Bush = 32,
    /// What a felled tree leaves. Nothing of it is saved but that the tree was felled.
    Stump = 40,
    /// What a felled toadstool leaves.
    Stalk = 41,
    /// A boulder.
    Boulder = 48,
    /// A prism with a sign, where five squares meet. It has one size.
    CornerStone = 49,
}

/// How old a plant is; of a boulder, how large.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Age {
    /// About a third as high as a grown one.
    Young,
    /// Grown.
    Grown,
    /// Old, and half as high again, wider and more gnarled.
    Old,
}

/// The part of a plant that one bumps into: an upright cylinder about its root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trunk {
    /// Its radius, metres.
    pub radius_m: f64,
    /// How high it stands, metres.
    pub height_m: f64,
}

impl Age {
    /// All, from the youngest.
    pub const ALL: [Self; 3] = [Self::Young, Self::Grown, Self::Old];

    /// Its number: 0, 1 and 2, from the youngest.
    pub fn byte(self) -> u8 {
        match self {
            Self::Young => 0,
            Self::Grown => 1,
            Self::Old => 2,
        }
    }

    /// The age with a number, if there is one.
    pub fn of_byte(byte: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|age| age.byte() == byte)
    }
}

/// The radius of a stump's trunk that is as large as its kind, metres.
const STUMP_M: f64 = 0.3;

/// What is left of a thing that was felled: nothing but of trees.
pub fn left_of(felled: &Thing) -> Option<Thing> {
    let (species, age) = (Species::of_byte(felled.species)?, Age::of_byte(felled.age)?);
    let trunk = species.trunk(age).filter(|_| species.is_tree())?;
    let left = match species {
        Species::Toadstool => Species::Stalk,
        _ => Species::Stump,
    };
    Some(Thing {
        species: left.byte(),
        age: Age::Grown.byte(),
        scale: felled.scale * (trunk.radius_m / STUMP_M) as f32,
        ..*felled
    })
}

/// Lengths of a grown plant, metres.
struct Lengths {
    height: f64,
    crown: f64,
    trunk: f64,
    bare: f64,
}

impl Species {
    /// All.
    pub const ALL: [Self; 14] = [
        Self::Oak,
        Self::Spruce,
        Self::Birch,
        Self::Palm,
        Self::Acacia,
        Self::Willow,
        Self::Kapok,
        Self::Snag,
        Self::Toadstool,
        Self::Bush,
        Self::Stump,
        Self::Stalk,
        Self::Boulder,
        Self::CornerStone,
    ];

    /// Whether it is of stone, and breaks to stones.
    pub fn is_stone(self) -> bool {
        self >= Self::Boulder
    }

    /// Whether it is a tree: it falls, and there is wood in it.
    pub fn is_tree(self) -> bool {
        self < Self::Bush
    }

    /// Its number in saved worlds.
    pub fn byte(self) -> u8 {
        self as u8
    }

    /// The species with a number, if there is one.
    pub fn of_byte(byte: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|species| species.byte() == byte)
    }

    /// Its English name, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Oak => "oak",
            Self::Spruce => "spruce",
            Self::Birch => "birch",
            Self::Palm => "palm",
            Self::Acacia => "acacia",
            Self::Willow => "willow",
            Self::Kapok => "kapok",
            Self::Snag => "snag",
            Self::Toadstool => "toadstool",
            Self::Bush => "bush",
            Self::Stump => "stump",
            Self::Stalk => "stalk",
            Self::Boulder => "boulder",
            Self::CornerStone => "corner stone",
        }
    }

    /// How high it stands over its root, metres.
    pub fn height_m(self, age: Age) -> f64 {
        let factor = match (self, age) {
            (Self::CornerStone, _) | (_, Age::Grown) => 1.0,
            (Self::Boulder, Age::Young) => 0.5,
            (Self::Boulder, Age::Old) => 2.0,
            (_, Age::Young) => 0.4,
            (_, Age::Old) => 1.45,
        };
        self.lengths().height * factor
    }

    /// How far its crown reaches sideways from the upright line through its root, metres.
    pub fn radius_m(self, age: Age) -> f64 {
        let factor = match (self, age) {
            (Self::CornerStone, _) | (_, Age::Grown) => 1.0,
            (Self::Boulder, Age::Young) => 0.5,
            (Self::Boulder, Age::Old) => 2.0,
            (_, Age::Young) => 0.36,
            (_, Age::Old) => 1.6,
        };
        self.lengths().crown * factor
    }

    /// What one bumps into: nothing of a bush, the whole of a boulder.
    pub fn trunk(self, age: Age) -> Option<Trunk> {
        let lengths = self.lengths();
        match self {
            Self::Bush => None,
            Self::Boulder => Some(Trunk {
                radius_m: self.radius_m(age),
                height_m: self.height_m(age),
            }),
            _ => {
                let stout = match (self, age) {
                    (Self::CornerStone, _) | (_, Age::Grown) => 1.0,
                    (_, Age::Young) => 0.4,
                    (_, Age::Old) => 1.7,
                };
                let height_m = lengths.bare / lengths.height * self.height_m(age);
                Some(Trunk {
                    radius_m: lengths.trunk * stout,
                    height_m,
                })
            }
        }
    }

    /// Lengths of a grown one: the whole height, the crown's reach, the trunk's radius where one bumps into it, and the
    /// height up to which the trunk stands alone.
    fn lengths(self) -> Lengths {
        let (height, crown, trunk, bare) = match self {
            Self::Oak => (8.0, 3.7, 0.28, 3.6),
            Self::Spruce => (11.0, 2.3, 0.2, 9.0),
            Self::Birch => (9.0, 1.7, 0.13, 7.0),
            Self::Palm => (8.0, 3.3, 0.17, 6.5),
            Self::Acacia => (6.0, 4.2, 0.2, 3.2),
            Self::Willow => (7.0, 3.9, 0.3, 4.0),
            Self::Kapok => (16.0, 5.6, 0.55, 11.0),
            Self::Snag => (5.0, 1.7, 0.22, 3.4),
            Self::Toadstool => (5.0, 2.4, 0.3, 4.0),
            Self::Bush => (1.1, 0.95, 0.0, 0.0),
            Self::Stump | Self::Stalk => (0.45, 0.42, STUMP_M, 0.45),
            Self::Boulder => (1.0, 0.9, 0.9, 1.0),
            Self::CornerStone => (1.6, 0.35, 0.33, 1.5),
        };
        Lengths {
            height,
            crown,
            trunk,
            bare,
        }
    }
}
