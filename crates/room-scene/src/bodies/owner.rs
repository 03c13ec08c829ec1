//! Whose body something is: an object of the room, something that was thrown, or who walks.

/// What was thrown is told from the room's objects by numbers from this on.
const THROWN_FROM: u32 = 1 << 24;

/// Whose a body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// That of the room, by its place among all.
    Object(usize),
    /// A ball that was thrown, by its number among things.
    Thrown(u64),
    /// Who walks, whom no blow moves: that is for the walker to say.
    Walker,
}

impl Owner {
    /// What its triangles are known by.
    pub fn number(self) -> u32 {
        match self {
            Self::Object(object) => object as u32,
            Self::Thrown(id) => THROWN_FROM + (id % u64::from(THROWN_FROM)) as u32,
            Self::Walker => u32::MAX,
        }
    }

    /// Whose triangles are known by that.
    pub fn numbered(number: u32) -> Self {
        match number {
            u32::MAX => Self::Walker,
            it if it >= THROWN_FROM => Self::Thrown(u64::from(it - THROWN_FROM)),
            it => Self::Object(it as usize),
        }
    }
}
