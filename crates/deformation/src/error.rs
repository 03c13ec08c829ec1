//! Why lists of aberrations and portals make no space.

use thiserror::Error;

/// What is refused of aberrations and portals. Each message says which, what is wrong and what to do.
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
    /// More portals than there may be.
    #[error("There are {found} portals, and there may be {most}. Remove some.")]
    TooManyPortals {
        /// Portals given.
        found: usize,
        /// Portals allowed.
        most: usize,
    },
    /// A polygon that is none, or a number that is not finite.
    #[error(
        "The portal \"{name}\" {what}. Give it a convex polygon of three to sixteen corners, each once and in their order."
    )]
    PortalShape {
        /// The portal.
        name: String,
        /// What is wrong with it.
        what: &'static str,
    },
    /// A portal whose partner there is not.
    #[error("The portal \"{name}\" leads to none. Say which portal it leads to.")]
    NoPartner {
        /// The portal.
        name: String,
    },
    /// A portal whose partner leads elsewhere.
    #[error(
        "The portal \"{name}\" leads to \"{partner}\", which does not lead back to it. Let each lead to the other."
    )]
    OneWay {
        /// The portal.
        name: String,
        /// Its partner.
        partner: String,
    },
    /// Of a pair one has two sides and the other one.
    #[error(
        "Of the portals \"{name}\" and \"{partner}\" one has two sides and the other one. Give both as many."
    )]
    OtherSides {
        /// The portal.
        name: String,
        /// Its partner.
        partner: String,
    },
    /// Felt shapes that are not similar.
    #[error(
        "The portals \"{name}\" and \"{partner}\" do not feel similar: seen from the front, one has to be the mirror image of \
         the other, as large or in proportion. Stretches of the boxes that they stand in count."
    )]
    NotSimilar {
        /// The portal.
        name: String,
        /// Its partner.
        partner: String,
    },
    /// One of a pair is too many times larger.
    #[error(
        "Of the portals \"{name}\" and \"{partner}\" one feels more than 32 times as large as the other. Make them more alike."
    )]
    OtherSize {
        /// The portal.
        name: String,
        /// Its partner.
        partner: String,
    },
    /// A portal that reaches through a side of a box.
    #[error(
        "The portal \"{name}\" overlaps a side of the aberration \"{aberration}\". Put it wholly in or out, a millimetre off at \
         least."
    )]
    OverSide {
        /// The portal.
        name: String,
        /// The box.
        aberration: String,
    },
    /// A portal in a box in which lengths depend on who goes there.
    #[error(
        "The portal \"{name}\" stands in the aberration \"{aberration}\", which is felt one way only or bends light by the thesis's \
         rule. Put it out of that."
    )]
    InOddBox {
        /// The portal.
        name: String,
        /// The box.
        aberration: String,
    },
    /// Two portals that touch or go through each other.
    #[error(
        "The portals \"{first}\" and \"{second}\" touch or overlap. Move them apart, by a millimetre at least."
    )]
    PortalsOverlap {
        /// One portal.
        first: String,
        /// The other.
        second: String,
    },
}
