//! Why a list of aberrations makes no space.

use thiserror::Error;

/// What is refused of a list of aberrations. Each message says which box, what is wrong and what to do.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SpaceError {
    /// More boxes than there may be.
    #[error("There are {found} aberrations, and there may be {most}. Remove some.")]
    TooMany {
        /// Boxes given.
        found: usize,
        /// Boxes allowed.
        most: usize,
    },
    /// A number that is not finite, or an edge that is not longer than nought.
    #[error(
        "The aberration \"{name}\" has {what} that is no number or out of range. Give it another."
    )]
    Number {
        /// The box.
        name: String,
        /// Which of its numbers.
        what: &'static str,
    },
    /// Walls on all sides, or an axis that no box has.
    #[error(
        "The aberration \"{name}\" has walls on all six sides, since it is stretched along more than one axis: nobody could \
         enter it. Stretch it along one axis, or make its sides soft."
    )]
    NoDoor {
        /// The box.
        name: String,
    },
    /// Two boxes overlap in part, and their axes are not parallel.
    #[error(
        "The aberrations \"{first}\" and \"{second}\" overlap in part, and their axes are not parallel: what is seen would \
         depend on which is left first. Turn one as the other, put one wholly inside of the other, or move them apart."
    )]
    Overlap {
        /// One box.
        first: String,
        /// The other.
        second: String,
    },
    /// More boxes within each other than there may be.
    #[error(
        "The aberrations \"{first}\" and \"{second}\" and {others} more lie within each other, and {most} may. Move some out."
    )]
    TooDeep {
        /// One box of those.
        first: String,
        /// The innermost.
        second: String,
        /// How many there are besides.
        others: usize,
        /// How many may.
        most: usize,
    },
    /// So many boxes overlap in so many ways that their depth cannot be told.
    #[error(
        "So many aberrations overlap \"{name}\" that it cannot be told how deep they lie within each other. Move some apart."
    )]
    TooTangled {
        /// The box.
        name: String,
    },
}
