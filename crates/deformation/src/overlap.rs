//! How boxes lie to each other: apart, one in the other, or overlapping in part, and how deep.

use glam::{DMat3, DVec3};

use crate::space::MAX_ABERRATIONS;

/// Boxes that overlap by less than this only touch, metres.
const TOUCH_M: f64 = 1e-7;
/// Cosines within this of 0 or 1 make axes parallel.
const PARALLEL: f64 = 1e-9;

/// A box: its middle, axes as columns, and half sizes.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// Middle.
    pub centre: DVec3,
    /// Axes.
    pub axes: DMat3,
    /// Half sizes.
    pub half: DVec3,
}

impl Bounds {
    /// Half of its extent along a direction of length 1.
    fn reach(&self, direction: DVec3) -> f64 {
        (self.axes.transpose() * direction).abs().dot(self.half)
    }

    /// Whether the other lies wholly within this one, touching allowed.
    pub fn contains(&self, other: &Self) -> bool {
        let away = other.centre - self.centre;
        // The other's middle would lie within the ball about this one.
        if away.length() > self.half.length() + TOUCH_M {
            return false;
        }
        let away = self.axes.transpose() * away;
        (0..3).all(|i| away[i].abs() + other.reach(self.axes.col(i)) <= self.half[i] + TOUCH_M)
    }

    /// Whether both have more than a face in common: no direction parts them (S. Gottschalk's test of fifteen axes).
    pub fn overlaps(&self, other: &Self) -> bool {
        let away = other.centre - self.centre;
        // The balls about them are apart: so are most boxes of a large room.
        if away.length() > self.half.length() + other.half.length() {
            return false;
        }
        let parts = |direction: DVec3| {
            direction.try_normalize().is_some_and(|axis| {
                let room = self.reach(axis) + other.reach(axis) - away.dot(axis).abs();
                room <= TOUCH_M
            })
        };
        let crossed = (0..9).map(|k| {
            let (a, b) = (self.axes.col(k / 3), other.axes.col(k % 3));
            let cross = a.cross(b);
            // Parallel edges part nothing that the faces do not, and their cross product is noise.
            if cross.length_squared() < 1e-12 {
                DVec3::ZERO
            } else {
                cross
            }
        });
        let faces = (0..3).flat_map(|i| [self.axes.col(i), other.axes.col(i)]);
        !faces.chain(crossed).any(parts)
    }

    /// Whether each axis of one is an axis of the other, whichever way it points.
    pub fn is_parallel(&self, other: &Self) -> bool {
        let between = self.axes.transpose() * other.axes;
        between
            .to_cols_array()
            .iter()
            .all(|cosine| cosine.abs() < PARALLEL || (cosine.abs() - 1.0).abs() < PARALLEL)
    }
}

/// Sets of boxes looked at before it is given up.
const MOST_SETS: usize = 200_000;
/// Words of 64 bits for the numbers of all boxes.
const WORDS: usize = MAX_ABERRATIONS / 64;

/// A set of boxes, a bit for each.
type Set = [u64; WORDS];

fn first_of(set: &Set) -> Option<usize> {
    let word = set.iter().position(|word| *word != 0)?;
    Some(word * 64 + set[word].trailing_zeros() as usize)
}

fn common(one: &Set, other: &Set) -> Set {
    std::array::from_fn(|word| one[word] & other[word])
}

fn change(set: &mut Set, number: usize) {
    set[number / 64] ^= 1 << (number % 64);
}

/// More than `most` boxes that have a place in common, if there are; an error names the box at which there were too many
/// sets to look at. Of boxes that overlap, those that are not parallel have to lie within each other.
///
/// Boxes of which each two overlap have a place in common, so that it is enough to look at pairs: parallel ones since
/// intervals do, axis by axis (E. Helly). Of those that are turned otherwise, a box either lies in all of the parallel ones,
/// and so in what they have in common, or it contains one of them, and so what they have in common.
pub fn too_deep(boxes: &[Bounds], most: usize) -> Result<Option<Vec<usize>>, usize> {
    let mut search = Search {
        overlaps: vec![Set::default(); boxes.len()],
        most,
        chain: Vec::new(),
        seen: 0,
    };
    let mut all = Set::default();
    for (number, bounds) in boxes.iter().enumerate() {
        change(&mut all, number);
        for (other, against) in boxes[..number].iter().enumerate() {
            if bounds.overlaps(against) {
                change(&mut search.overlaps[number], other);
                change(&mut search.overlaps[other], number);
            }
        }
    }
    let found = search.deepen(all)?;
    search.chain.sort_unstable();
    Ok(found.then_some(search.chain))
}

/// A search for a set of boxes of which each two overlap.
struct Search {
    /// Those that overlap each.
    overlaps: Vec<Set>,
    most: usize,
    chain: Vec<usize>,
    seen: usize,
}

impl Search {
    /// Puts more boxes on the chain, of those that overlap all that are on it, until there are more than may be.
    ///
    /// Boxes that overlap each other cannot share a group in which none overlaps another: so there are at most as many more
    /// as groups (E. Tomita, 2003). Boxes are tried from the last group on, and given up when there are too few groups.
    fn deepen(&mut self, among: Set) -> Result<bool, usize> {
        let mut left = among;
        for (number, groups) in self.grouped(&among).into_iter().rev() {
            if self.chain.len() + groups <= self.most {
                return Ok(false);
            }
            self.seen += 1;
            if self.seen > MOST_SETS {
                return Err(number);
            }
            self.chain.push(number);
            let more = common(&left, &self.overlaps[number]);
            if self.chain.len() > self.most || self.deepen(more)? {
                return Ok(true);
            }
            self.chain.pop();
            change(&mut left, number);
        }
        Ok(false)
    }

    /// Boxes in groups in which none overlaps another, each with the number of its group, from 1.
    fn grouped(&self, among: &Set) -> Vec<(usize, usize)> {
        let mut left = *among;
        let mut grouped = Vec::new();
        let mut group = 0;
        while left != Set::default() {
            group += 1;
            let mut free = left;
            while let Some(number) = first_of(&free) {
                grouped.push((number, group));
                change(&mut left, number);
                change(&mut free, number);
                free = std::array::from_fn(|word| free[word] & !self.overlaps[number][word]);
            }
        }
        grouped
    }
}
