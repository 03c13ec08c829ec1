//! All tiles in reach, numbered by `u128`.
//!
//! Which sides of a tile lead to its children depends on the tile's *kind*, and the kind of a child on the side and the
//! kind of its parent. Eight kinds are enough. They were found by growing the tree of parents with exact numbers, where two
//! tiles are of one kind if the trees above them are alike; the tests hold this table to the geometry.

use super::{Side, TilePath, TilingError};

/// Most steps from the root to a tile in reach. There are `2^127.99` tiles within so many.
pub const MOST_STEPS: usize = 105;

/// The kinds of the children over the sides 0 to 3 of each kind of tile; the last row is the root's.
const CHILDREN: [[Option<u8>; 4]; 9] = [
    [Some(1), Some(2), None, Some(3)],
    [Some(1), Some(2), None, Some(4)],
    [Some(5), None, None, Some(3)],
    [Some(1), Some(6), None, None],
    [Some(7), Some(6), None, None],
    [Some(1), None, None, Some(4)],
    [Some(1), None, None, Some(3)],
    [Some(1), Some(2), None, None],
    [Some(0), Some(0), Some(0), Some(0)],
];
const ROOT_KIND: u8 = 8;

/// `TILES[n][kind]`: how many tiles have one of that kind n steps below them.
const TILES: [[u128; 9]; MOST_STEPS + 1] = tiles();

const fn tiles() -> [[u128; 9]; MOST_STEPS + 1] {
    let mut tiles = [[1; 9]; MOST_STEPS + 1];
    let mut n = 1;
    while n <= MOST_STEPS {
        let mut kind = 0;
        while kind < 9 {
            let mut sum = 0;
            let mut side = 0;
            while side < 4 {
                if let Some(child) = CHILDREN[kind][side] {
                    sum += tiles[n - 1][child as usize];
                }
                side += 1;
            }
            tiles[n][kind] = sum;
            kind += 1;
        }
        n += 1;
    }
    tiles
}

/// Somebody on the way from the root from parent to child.
#[derive(Debug, Clone, Copy)]
pub(super) struct Walker {
    kind: u8,
}

impl Walker {
    /// At the root.
    pub const ROOT: Self = Self { kind: ROOT_KIND };

    /// Over a side, if a child is there.
    pub fn over(self, side: Side) -> Option<Self> {
        let children = CHILDREN.get(usize::from(self.kind))?;
        let kind = children[usize::from(side.number())]?;
        Some(Self { kind })
    }

    /// How many tiles are so many steps below this one.
    fn below(self, steps: usize) -> Option<u128> {
        TILES.get(steps)?.get(usize::from(self.kind)).copied()
    }
}

impl TilePath {
    /// The number of the tile there: the root has 0, then come those at one step, at two, and so on; those of one number
    /// of steps in the order of their sides.
    pub fn number(&self) -> u128 {
        let nearer = (0..self.len()).filter_map(|steps| Walker::ROOT.below(steps));
        let mut number: u128 = nearer.sum();
        let mut walker = Walker::ROOT;
        for (at, side) in self.sides().enumerate() {
            let before = Side::ALL.into_iter().take_while(|other| *other < side);
            let rest = self.len() - at - 1;
            number += before
                .filter_map(|other| walker.over(other)?.below(rest))
                .sum::<u128>();
            walker = walker.over(side).unwrap_or(walker);
        }
        number
    }

    /// The path to the tile of a number.
    ///
    /// # Errors
    /// [`TilingError::NoPath`] for numbers of tiles more than [`MOST_STEPS`] from the root.
    pub fn from_number(number: u128) -> Result<Self, TilingError> {
        let mut left = number;
        let mut steps = 0;
        loop {
            let ring = Walker::ROOT.below(steps).ok_or(TilingError::NoPath)?;
            if left < ring {
                break;
            }
            left -= ring;
            steps += 1;
        }
        let mut walker = Walker::ROOT;
        let mut sides = Vec::with_capacity(steps);
        for rest in (0..steps).rev() {
            let children = Side::ALL.map(|side| walker.over(side));
            let child = Side::ALL
                .into_iter()
                .zip(children)
                .find_map(|(side, child)| {
                    let below = child?.below(rest)?;
                    if left < below {
                        return Some((side, child?));
                    }
                    left -= below;
                    None
                });
            let (side, next) = child.ok_or(TilingError::NoPath)?;
            sides.push(side);
            walker = next;
        }
        Self::new(sides)
    }
}
