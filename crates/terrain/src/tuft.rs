//! What a chunk's mesh says of the small growth on it, which is drawn close by and is nothing to anybody else.

use glam::Vec3;

/// A tuft on a chunk, told by numbers that only who draws it understands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tuft {
    /// Where it stands, metres from the chunk's corner.
    pub root: Vec3,
    /// The number of its kind.
    pub growth: u8,
    /// How it is turned about the upright, 256ths of a turn.
    pub turn: u8,
    /// How large it is, 256ths of its kind's most.
    pub size: u8,
    /// How few are as important, 256ths: farther off the least are left out.
    pub rank: u8,
    /// The colour of the ground, sRGB, and how much of the sky is left there, 0 to 6.
    pub ground: [u8; 4],
}
