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
}

impl Kind {
    /// Every kind, in the order of their numbers.
    pub const ALL: [Self; 14] = [
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
    ];
    /// What a number without a kind is shown as.
    pub const PLAIN: Self = Self::Soil;

    /// The number that saves have for it, 1 to 14.
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
        }
    }

    /// The kind of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Whether untouched land has it below ground only.
    pub fn is_deep(self) -> bool {
        self >= Self::Slate
    }

    /// Whether it is an ore.
    pub fn is_ore(self) -> bool {
        self >= Self::Coal
    }

    /// What a steep face of untouched land shows in its place.
    #[must_use]
    pub fn where_steep(self) -> Self {
        match self {
            Self::Snow | Self::Basalt => self,
            kind if kind.is_deep() => kind,
            _ => Self::Rock,
        }
    }

    /// How it sounds underfoot.
    pub fn cover(self) -> Cover {
        match self {
            Self::Grass | Self::Moss => Cover::Grass,
            Self::Soil | Self::Clay | Self::Snow => Cover::Soil,
            Self::Sand => Cover::Sand,
            Self::Gravel | Self::Ash | Self::Coal => Cover::Gravel,
            Self::Rock | Self::Basalt | Self::Slate | Self::Copper | Self::Crystal => Cover::Rock,
        }
    }
}

/// Added to a vertex's number of a kind where that is the skin of land that nobody laid: where it is steep it shows the
/// rock below, as the slope of a pixel says and not that of a level.
pub(crate) const SKIN: u8 = 0x40;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_names_lead_back_to_their_kinds() {
        for (number, kind) in (1..).zip(Kind::ALL) {
            assert_eq!((kind.byte(), Kind::of_byte(number)), (number, Some(kind)));
            assert_eq!(Kind::of_name(kind.name()), Some(kind));
        }
        for byte in [0, 15, 127, 255] {
            assert_eq!(Kind::of_byte(byte), None, "{byte}");
        }
        assert_eq!(Kind::of_name("lava"), None);
    }

    #[test]
    fn there_are_kinds_enough_and_the_deep_ones_are_told() {
        let deep: Vec<_> = Kind::ALL.into_iter().filter(|k| k.is_deep()).collect();
        let ores: Vec<_> = Kind::ALL.into_iter().filter(|k| k.is_ore()).collect();
        assert_eq!((Kind::ALL.len(), deep.len(), ores.len()), (14, 4, 3));
    }
}
