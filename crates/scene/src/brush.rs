//! The brush of the tools that dig and build: its shape, and what is built of. Both are of this visit and are not saved.

use antipode_terrain::{Kind, Shape, Stock};

/// With less of a kind nobody builds, cubic metres.
pub(crate) const LEAST_BUILT_M3: f64 = 0.01;

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

/// What was chosen of the brush.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Its shape.
    Shape,
    /// What is built.
    Kind,
}

/// The brush in hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Brush {
    /// Its shape.
    pub shape: BrushShape,
    /// What is built of. Nothing brings back what untouched land has there, and in gathering worlds stands for what there is
    /// most of.
    pub kind: Option<Kind>,
}

impl Brush {
    /// Everything that can be built, in the order in which it is gone through. Without a stock what is found at each place
    /// comes first, and then every kind; with one, what there is most of, and then what there is.
    pub fn kinds(stock: Option<&Stock>) -> Vec<Option<Kind>> {
        let there = |kind: &Kind| stock.is_none_or(|stock| stock.of(*kind) >= LEAST_BUILT_M3);
        let kinds = Kind::ALL.into_iter().filter(there).map(Some);
        std::iter::once(None).chain(kinds).collect()
    }

    /// Goes on by shapes, and by these kinds, round at the end.
    pub(crate) fn step(&mut self, shapes: i32, kinds: (i32, &[Option<Kind>])) {
        self.shape = round(BrushShape::ALL.into_iter(), self.shape, shapes);
        self.kind = round(kinds.1.iter().copied(), self.kind, kinds.0);
    }
}

/// What comes so many places after one of a row, which begins again at its end.
fn round<T: Copy + PartialEq>(row: impl Iterator<Item = T>, from: T, by: i32) -> T {
    let row: Vec<_> = row.collect();
    let at = row.iter().position(|it| *it == from).unwrap_or_default();
    let to = (at as i64 + i64::from(by)).rem_euclid(row.len().max(1) as i64);
    row.get(to as usize).copied().unwrap_or(from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_and_kinds_are_gone_through_both_ways_and_round() {
        let mut brush = Brush::default();
        let all = Brush::kinds(None);
        brush.step(1, (1, &all));
        let second = Brush {
            shape: BrushShape::Box,
            kind: Some(Kind::Grass),
        };
        assert_eq!(brush, second);
        brush.step(-2, (-2, &all));
        let last = Brush {
            shape: BrushShape::Smooth,
            kind: Some(Kind::Wood),
        };
        assert_eq!(brush, last);
        brush.step(5 * 7 + 1, (16 * 3 + 1, &all));
        assert_eq!(brush, Brush::default());
        brush.step(i32::MIN, (i32::MAX, &all));
    }

    #[test]
    fn with_a_stock_only_what_there_is_can_be_chosen() {
        let mut stock = Stock::default();
        stock.add(Kind::Coal, 1.0);
        stock.add(Kind::Sand, 0.001);
        let kinds = Brush::kinds(Some(&stock));
        assert_eq!(kinds, [None, Some(Kind::Coal)]);
        let mut brush = Brush {
            kind: Some(Kind::Sand),
            ..Brush::default()
        };
        brush.step(0, (1, &kinds));
        assert_eq!(brush.kind, Some(Kind::Coal), "what is used up is left");
    }
}
