//! Strokes whose every state can be recognised: what the field is near a corner of eight chunks after each of them.

use std::collections::BTreeMap;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord};
use antipode_terrain::{ChunkEdits, EDIT_STEP, Field, Samples, Stroke};
use glam::{DVec3, IVec3};

/// Strokes a second, and seconds that one sense lasts.
pub const PER_S: usize = 60;
/// Radius of a stroke, metres; the game's own at the start.
const RADIUS_M: f64 = 5.0;
/// Metres of field at its middle: about what the game's tools do in a sixtieth of a second.
const AMOUNT: f32 = 0.12;
/// Middles are moved about the corner by whole metres up to this, so that no two of a few seconds are alike.
const ASIDE: i64 = 2;
/// How far a field may be off its prediction, metres: the rounding of stored edits.
const TOLERANCE_M: f32 = 1.5 * EDIT_STEP;

/// The field at the eight samples around the corner, one of each chunk.
pub type Mark = [f32; 8];

/// A row of strokes over a corner of eight chunks.
#[derive(Debug)]
pub struct Strokes {
    /// Where the eight chunks meet.
    pub corner: DVec3,
    /// The strokes in order.
    pub row: Vec<Stroke>,
    /// The field before the first and after each.
    pub marks: Vec<Mark>,
}

impl Strokes {
    /// That many strokes at the corner that is nearest to the ground at the world's middle: a second of digging, a
    /// second of building, and so on.
    pub fn new(field: &Field, count: usize) -> Self {
        let ground_m = field.surface_height(ChartId::FIRST, 0.0, 0.0);
        let corner = DVec3::new(0.0, (ground_m / 32.0).round() * 32.0, 0.0);
        let strokes: Vec<Stroke> = (0..count).map(|n| stroke(corner, n)).collect();
        let bases = around(corner).map(|at| field.sample(ChartPoint::a(at)));
        let mut edits: BTreeMap<ChunkCoord, ChunkEdits> = BTreeMap::new();
        let mut marks = vec![bases];
        for stroke in &strokes {
            for coord in stroke.touched(&**field.strategy()) {
                let own = edits.entry(coord).or_default();
                stroke.apply(coord, own, &**field.strategy());
            }
            marks.push(mark(&bases, corner, &edits));
        }
        Self {
            corner,
            row: strokes,
            marks,
        }
    }

    /// The field at the corner's samples as a chunk that touches the corner has them.
    pub fn seen(&self, coord: ChunkCoord, samples: &Samples) -> Mark {
        around(self.corner).map(|at| {
            let [i, j, k] = (at - coord.origin() + 1.0).to_array().map(|c| c as usize);
            samples.get(i, j, k)
        })
    }

    /// How many strokes a field holds, if it is that after one of the first `most` of them, not before `least`.
    pub fn held(&self, seen: &Mark, least: usize, most: usize) -> Option<usize> {
        let off = |mark: &Mark| {
            let differences = mark.iter().zip(seen).map(|(a, b)| (a - b).abs());
            differences.fold(0.0, f32::max)
        };
        let states = self.marks.iter().enumerate().take(most + 1).skip(least);
        states
            .map(|(n, mark)| (n, off(mark)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|(_, off)| *off < TOLERANCE_M)
            .map(|(n, _)| n)
    }

    /// Whether a chunk touches the corner.
    pub fn touches(&self, coord: ChunkCoord) -> bool {
        let away = (coord.centre() - self.corner).abs();
        coord.chart == ChartId::FIRST && away.max_element() < 32.0
    }
}

fn stroke(corner: DVec3, n: usize) -> Stroke {
    // A walk through the cube of middles that comes back only after all of them.
    let side = 2 * ASIDE + 1;
    let place = (n as i64 * 37).rem_euclid(side * side * side);
    let step = |of: i64| (place / of).rem_euclid(side) - ASIDE;
    let aside = DVec3::new(step(1) as f64, step(side) as f64, step(side * side) as f64);
    let sense = if (n / PER_S).is_multiple_of(2) {
        1.0
    } else {
        -1.0
    };
    Stroke {
        centre: ChartPoint::a(corner + aside),
        radius_m: RADIUS_M,
        amount: sense * AMOUNT,
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    }
}

/// The samples around a corner, the last before and the first after it along each axis.
fn around(corner: DVec3) -> [DVec3; 8] {
    std::array::from_fn(|n| {
        let step = |bit: usize| f64::from(u8::from(n >> bit & 1 == 1)) - 1.0;
        corner + DVec3::new(step(0), step(1), step(2))
    })
}

fn mark(bases: &Mark, corner: DVec3, edits: &BTreeMap<ChunkCoord, ChunkEdits>) -> Mark {
    let places = around(corner);
    std::array::from_fn(|n| {
        let coord = ChunkCoord::containing(ChartPoint::a(places[n]));
        let IVec3 { x, y, z } = (places[n] - coord.origin()).as_ivec3();
        let index = ((x * 32 + z) * 32 + y) as usize;
        let units = edits.get(&coord).map(ChunkEdits::to_units);
        let unit = units.and_then(|units| units.get(index).copied());
        bases[n] + f32::from(unit.unwrap_or(0)) * EDIT_STEP
    })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use antipode_geometry::Geometry;
    use antipode_terrain::apply_edits;

    use super::*;
    use crate::terrain::engine::surface_chunk;

    #[test]
    fn every_state_is_told_from_every_other() {
        let (field, _) = surface_chunk(Geometry::Euclidean);
        let strokes = Strokes::new(&field, 5 * PER_S);
        for (n, mark) in strokes.marks.iter().enumerate() {
            assert_eq!(strokes.held(mark, 0, strokes.row.len()), Some(n));
        }
        let mut strange = strokes.marks[40];
        strange[3] += 0.01;
        assert_eq!(strokes.held(&strange, 0, 60), None);
    }

    #[test]
    fn a_chunk_of_the_engine_shows_the_state_that_was_predicted() {
        let (field, _) = surface_chunk(Geometry::Euclidean);
        let strokes = Strokes::new(&field, 30);
        let mut edits: BTreeMap<ChunkCoord, ChunkEdits> = BTreeMap::new();
        for stroke in &strokes.row[..20] {
            for coord in stroke.touched(&**field.strategy()) {
                stroke.apply(coord, edits.entry(coord).or_default(), &**field.strategy());
            }
        }
        let edits: BTreeMap<_, _> = edits.into_iter().map(|(c, e)| (c, Arc::new(e))).collect();
        assert_eq!(edits.len(), 8, "every stroke reaches all eight chunks");
        for &coord in edits.keys() {
            assert!(strokes.touches(coord));
            let mut samples = field.samples(coord);
            apply_edits(&mut samples, coord, |near| edits.get(&near).cloned());
            let seen = strokes.seen(coord, &samples);
            assert_eq!(strokes.held(&seen, 0, 30), Some(20), "{coord:?}");
        }
    }
}
