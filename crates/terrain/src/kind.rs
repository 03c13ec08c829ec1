//! What ground is made of, and the bytes by which saves and meshes tell it.
//!
//! The numbers are those of saved worlds and of `shaders/surfaces.wgsl`: none may ever change its meaning, and a new
//! one goes to the end.

use crate::cover::Cover;

/// What a sample of ground is made of.
#[repr(u8)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// Short grass.
    Grass = 1,
    /// Dark earth with crumbs and roots; what a kind of a later game is shown as.
    Soil = 2,
    /// Sand in ripples.
    Sand = 3,
    /// Pebbles.
    Gravel = 4,
    /// Layered rock.
    Rock = 5,
    /// Ash and cinders.
    Ash = 6,
    /// Snow.
    Snow = 7,
    /// Cushions of moss.
    Moss = 8,
    /// Clay with cracks.
    Clay = 9,
    /// Dark rock in columns.
    Basalt = 10,
    /// Split rock; below ground only.
    Slate = 11,
    /// An ore of beds near the surface; below ground only.
    Coal = 12,
    /// A rarer ore of veins, deeper down; below ground only.
    Copper = 13,
    /// The rarest ore, deepest down, which shines; below ground only.
    Crystal = 14,
    /// Planks and logs; only of trees that were felled.
    Wood = 15,
}

impl Kind {
    /// Every kind, in the order of their numbers.
    pub const ALL: [Self; 15] = [
        Self::Grass,
        Self::Soil,
        Self::Sand,
        Self::Gravel,
        Self::Rock,
        Self::Ash,
        Self::Snow,
        Self::Moss,
        Self::Clay,
        Self::Basalt,
        Self::Slate,
        Self::Coal,
        Self::Copper,
        Self::Crystal,
        Self::Wood,
    ];
    /// What a number without a kind is shown as.
    pub const PLAIN: Self = Self::Soil;

    /// The number that saves have for it, 1 to 15.
    pub const fn byte(self) -> u8 {
        self as u8
    }

    /// The kind of a number; `None` for 0, by which saves say that nobody built there, and for those of later games.
    pub fn of_byte(byte: u8) -> Option<Self> {
        let at = usize::from(byte).checked_sub(1)?;
        Self::ALL.get(at).copied()
    }

    /// The lower-case English word, as scripts and the probe have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grass => "grass",
            Self::Soil => "soil",
            Self::Sand => "sand",
            Self::Gravel => "gravel",
            Self::Rock => "rock",
            Self::Ash => "ash",
            Self::Snow => "snow",
            Self::Moss => "moss",
            Self::Clay => "clay",
            Self::Basalt => "basalt",
            Self::Slate => "slate",
            Self::Coal => "coal",
            Self::Copper => "copper",
            Self::Crystal => "crystal",
            Self::Wood => "wood",
        }
    }

    /// The kind of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether untouched land has it below ground only.
    pub fn is_deep(self) -> bool {
        (Self::Slate..=Self::Crystal).contains(&self)
    }

    /// Whether it is an ore.
    pub fn is_ore(self) -> bool {
        (Self::Coal..=Self::Crystal).contains(&self)
    }

    /// How hard it is to dig: 0 for loose ground, 1 for stone and coal, 2 for copper and 3 for crystal.
    pub fn hardness(self) -> u8 {
        match self {
            Self::Rock | Self::Basalt | Self::Slate | Self::Coal => 1,
            Self::Copper => 2,
            Self::Crystal => 3,
            _ => 0,
        }
    }

    /// What a steep face of untouched land shows in its place.
    #[must_use]
    pub const fn where_steep(self) -> Self {
        match self {
            Self::Snow
            | Self::Basalt
            | Self::Slate
            | Self::Coal
            | Self::Copper
            | Self::Crystal
            | Self::Wood => self,
            _ => Self::Rock,
        }
    }

    /// How it sounds underfoot.
    pub fn cover(self) -> Cover {
        match self {
            Self::Grass | Self::Moss => Cover::Grass,
            Self::Soil | Self::Clay | Self::Snow | Self::Wood => Cover::Soil,
            Self::Sand => Cover::Sand,
            Self::Gravel | Self::Ash | Self::Coal => Cover::Gravel,
            Self::Rock | Self::Basalt | Self::Slate | Self::Copper | Self::Crystal => Cover::Rock,
        }
    }
}

/// The byte that a vertex has of its ground: the number of a kind in the five lowest bits, and above them how much of the
/// sky is left so deep below untouched land, of [`OPEN_SKY`], or [`SKIN`].
const NUMBER_BITS: u8 = 0x1f;
const SKY_SHIFT: u32 = 5;
/// Steps of the sky: all of it.
pub(crate) const OPEN_SKY: u8 = 6;
/// The skin of land that nobody laid, under all of the sky: where it is steep it shows the rock below, as the slope of a
/// pixel says and not that of a level.
pub(crate) const SKIN: u8 = 7 << SKY_SHIFT;
/// Depths below untouched land where the sky begins to fail and where nothing of it is left, metres.
const SKY_M: (f32, f32) = (1.0, 7.5);

/// The number of a kind in a vertex's byte.
pub(crate) const fn number_of(byte: u8) -> u8 {
    byte & NUMBER_BITS
}

/// How much of the sky is left so deep below untouched land, 0 to 1.
#[inline]
pub(crate) fn sky_left(depth_m: f32) -> f32 {
    ((SKY_M.1 - depth_m) / (SKY_M.1 - SKY_M.0)).clamp(0.0, 1.0)
}

/// A vertex's byte, from the number of a kind, with [`SKIN`] or without, and the depth in metres.
#[inline]
pub(crate) fn under_sky(byte: u8, depth_m: f32) -> u8 {
    if byte >= SKIN {
        return byte;
    }
    let steps = (sky_left(depth_m) * f32::from(OPEN_SKY) + 0.5) as u8;
    byte | steps << SKY_SHIFT
}

/// The byte of a vertex half way between two: there is nothing between two kinds, and from whichever side one looks it is the
/// greater number; of the sky there is the mean.
pub(crate) fn between_bytes(a: u8, b: u8) -> u8 {
    let sky = |byte: u8| byte >> SKY_SHIFT;
    number_of(a).max(number_of(b)) | sky(a).midpoint(sky(b)) << SKY_SHIFT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_names_lead_back_to_their_kinds() {
        for (number, kind) in (1..).zip(Kind::ALL) {
            assert_eq!((kind.byte(), Kind::of_byte(number)), (number, Some(kind)));
            assert_eq!(Kind::of_name(kind.name()), Some(kind));
        }
        for byte in [0, 16, 127, 255] {
            assert_eq!(Kind::of_byte(byte), None, "{byte}");
        }
        assert_eq!(Kind::of_name("lava"), None);
    }

    #[test]
    fn the_sky_fails_with_depth_and_leaves_the_kind() {
        let sky = |depth_m: f32| under_sky(Kind::Slate.byte(), depth_m) >> SKY_SHIFT;
        let found: Vec<_> = (0..10_u8).map(|m| sky(f32::from(m))).collect();
        assert_eq!(found, [6, 6, 5, 4, 3, 2, 1, 0, 0, 0]);
        assert_eq!(number_of(under_sky(Kind::Slate.byte(), 4.0)), 11);
        let skin = Kind::Grass.byte() | SKIN;
        assert_eq!(under_sky(skin, 9.0), skin, "skin lies under the sky");
    }

    #[test]
    fn half_way_from_light_into_the_dark_is_half_of_the_sky() {
        let light = under_sky(Kind::Sand.byte(), 0.0);
        let dark = under_sky(Kind::Slate.byte(), 9.0);
        let middle = between_bytes(light, dark);
        assert_eq!((middle >> SKY_SHIFT, number_of(middle)), (3, 11));
        assert_eq!(between_bytes(dark, light), between_bytes(light, dark));
        let skin = Kind::Grass.byte() | SKIN;
        assert_eq!(between_bytes(skin, skin), skin);
    }

    #[test]
    fn there_are_kinds_enough_and_the_deep_ones_are_told() {
        let deep: Vec<_> = Kind::ALL.into_iter().filter(|k| k.is_deep()).collect();
        let ores: Vec<_> = Kind::ALL.into_iter().filter(|k| k.is_ore()).collect();
        assert_eq!((Kind::ALL.len(), deep.len(), ores.len()), (15, 4, 3));
    }
}
