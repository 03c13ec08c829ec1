//! How boxes lie to each other: apart, one in the other, or overlapping in part, and how deep.

use glam::{DMat3, DVec3};

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
        let away = self.axes.transpose() * (other.centre - self.centre);
        (0..3).all(|i| away[i].abs() + other.reach(self.axes.col(i)) <= self.half[i] + TOUCH_M)
    }

    /// Whether both have more than a face in common: no direction parts them (S. Gottschalk's test of fifteen axes).
    pub fn overlaps(&self, other: &Self) -> bool {
        let away = other.centre - self.centre;
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

    /// What both have in common, where it is more than a face. For boxes of which one contains the other, or whose axes
    /// are parallel.
    fn common(&self, other: &Self) -> Option<Self> {
        if !self.overlaps(other) {
            return None;
        }
        if other.contains(self) {
            return Some(*self);
        }
        if self.contains(other) {
            return Some(*other);
        }
        let away = self.axes.transpose() * (other.centre - self.centre);
        let reach = DVec3::from_array([0, 1, 2].map(|i| other.reach(self.axes.col(i))));
        let low = (-self.half).max(away - reach);
        let high = self.half.min(away + reach);
        Some(Self {
            centre: self.centre + self.axes * ((low + high) * 0.5),
            half: (high - low) * 0.5,
            ..*self
        })
    }
}

/// Sets of boxes that have a place in common, looked at before it is given up.
const MOST_SETS: usize = 200_000;

/// More than `most` boxes that have a place in common, if there are; an error names the box at which there were too many
/// sets to look at.
pub fn too_deep(boxes: &[Bounds], most: usize) -> Result<Option<Vec<usize>>, usize> {
    let mut seen = 0;
    for (first, bounds) in boxes.iter().enumerate() {
        let mut chain = vec![(first, *bounds)];
        if let Some(found) = deepen(boxes, most, &mut chain, &mut seen)? {
            return Ok(Some(found));
        }
    }
    Ok(None)
}

fn deepen(
    boxes: &[Bounds],
    most: usize,
    chain: &mut Vec<(usize, Bounds)>,
    seen: &mut usize,
) -> Result<Option<Vec<usize>>, usize> {
    let Some(&(last, place)) = chain.last() else {
        return Ok(None);
    };
    if chain.len() > most {
        return Ok(Some(chain.iter().map(|(number, _)| *number).collect()));
    }
    for next in last + 1..boxes.len() {
        if let Some(common) = place.common(&boxes[next]) {
            *seen += 1;
            if *seen > MOST_SETS {
                return Err(next);
            }
            chain.push((next, common));
            let found = deepen(boxes, most, chain, seen)?;
            if found.is_some() {
                return Ok(found);
            }
            chain.pop();
        }
    }
    Ok(None)
}
