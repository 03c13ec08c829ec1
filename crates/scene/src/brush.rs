//! The brush of the tools that dig and build: its shape, and what is built of. Both are of this visit and are not saved.

use antipode_terrain::{Kind, Shape};

/// The shape of the brush, and what it does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BrushShape {
    /// Digs and builds round hollows and heaps.
    #[default]
    Ball,
    /// Digs and builds an upright cube.
    Box,
    /// Digs and builds an upright cylinder.
    Cylinder,
    /// Brings ground to the height where the stroke began.
    Flatten,
    /// Takes the roughness off.
    Smooth,
}

impl BrushShape {
    /// Every shape.
    pub const ALL: [Self; 5] = [
        Self::Ball,
        Self::Box,
        Self::Cylinder,
        Self::Flatten,
        Self::Smooth,
    ];

    /// Its lower-case English word, as scripts and the probe have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ball => "ball",
            Self::Box => "box",
            Self::Cylinder => "cylinder",
            Self::Flatten => "flatten",
            Self::Smooth => "smooth",
        }
    }

    /// The shape of a word.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|shape| shape.name() == name)
    }

    /// Whether both buttons do the same.
    pub(crate) fn is_for_both(self) -> bool {
        matches!(self, Self::Flatten | Self::Smooth)
    }

    /// The strokes' shape; `level_m` is the height where the stroke began, metres.
    pub(crate) fn of_stroke(self, level_m: f64) -> Shape {
        match self {
            Self::Ball => Shape::Ball,
            Self::Box => Shape::Box,
            Self::Cylinder => Shape::Cylinder,
            Self::Flatten => Shape::Flatten { height_m: level_m },
            Self::Smooth => Shape::Smooth,
        }
    }
}

/// The brush in hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Brush {
    /// Its shape.
    pub shape: BrushShape,
    /// What is built of; nothing brings back what untouched land has there.
    pub kind: Option<Kind>,
}
