//! The edits of players: bounded fixed-point offsets to a chunk's samples.
//!
//! A chunk owns the 32^3 samples at its origin plus `0..32`; its border belongs to its
//! neighbours. Sums are kept to a 256th of [`EDIT_STEP`], so that sixty small changes a second
//! amount to the same as thirty twice their size; samples and saves see whole steps only, so
//! a chunk looks the same before and after it was saved.

use std::sync::Arc;

use antipode_geometry::ChunkCoord;
use glam::IVec3;
use thiserror::Error;

use crate::kind::Kind;
use crate::level::Level;
use crate::samples::{FACE_AXES, Samples};

/// Metres per stored unit.
pub const EDIT_STEP: f32 = 1.0 / 2048.0;
/// Edits are held to this on either side of zero, metres: twice the field's band, enough to
/// turn the deepest ground to the clearest air and back.
pub const EDIT_LIMIT_M: f32 = i16::MAX as f32 * EDIT_STEP;
/// Samples owned along an edge of a chunk.
const OWNED: usize = 32;
pub(crate) const COUNT: usize = OWNED * OWNED * OWNED;
/// Parts of a stored unit that sums are kept in.
const PARTS: i32 = 256;
const LIMIT: i32 = i16::MAX as i32 * PARTS;

/// Stored edits that cannot be read.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum EditsError {
    /// The wrong number of samples.
    #[error(
        "the edits of a chunk hold {found} samples where {COUNT} belong: the saved chunk is damaged; restore the world from a copy, or repair it, which drops this chunk's edits"
    )]
    Length {
        /// Samples found.
        found: usize,
    },
    /// Half a sample at the end.
    #[error(
        "the edits of a chunk take {found} bytes, which is no whole number of samples: the saved chunk is damaged; restore the world from a copy, or repair it, which drops this chunk's edits"
    )]
    OddBytes {
        /// Bytes found.
        found: usize,
    },
}

/// Edits of the 32^3 samples that one chunk owns; those of an untouched chunk take no memory.
#[derive(Debug, Clone, Default)]
pub struct ChunkEdits {
    /// Sums in parts of a unit by `(i * 32 + k) * 32 + j`, or nothing.
    pub(crate) parts: Box<[i32]>,
    /// Numbers of the kinds that were laid, in the same order, 0 where none was; or nothing.
    pub(crate) kinds: Box<[u8]>,
}

impl PartialEq for ChunkEdits {
    /// Equal when they look and save the same.
    fn eq(&self, other: &Self) -> bool {
        (0..COUNT).all(|at| self.unit(at) == other.unit(at) && self.laid(at) == other.laid(at))
    }
}

impl Eq for ChunkEdits {}

/// Index of owned sample `(i, j, k)`.
pub(crate) const fn owned_index(i: usize, j: usize, k: usize) -> usize {
    (i * OWNED + k) * OWNED + j
}

pub(crate) fn rounded(parts: i32) -> i16 {
    ((parts + PARTS / 2).div_euclid(PARTS)) as i16
}

impl ChunkEdits {
    /// No edits.
    pub fn new() -> Self {
        Self::default()
    }

    /// Whether nothing is kept of the chunk: no edit, however small, and no kind.
    pub fn is_untouched(&self) -> bool {
        self.parts.is_empty() && self.kinds.is_empty()
    }

    /// Whether no sample is changed.
    pub fn is_empty(&self) -> bool {
        self.parts.iter().all(|&parts| rounded(parts) == 0)
    }

    /// The edit of owned sample `(i, j, k)`, each in `0..32`, in units of [`EDIT_STEP`];
    /// zero outside.
    pub fn get(&self, i: usize, j: usize, k: usize) -> i16 {
        if i.max(j).max(k) >= OWNED {
            return 0;
        }
        self.unit(owned_index(i, j, k))
    }

    /// The edit of owned sample `(i, j, k)` in metres of field.
    pub fn delta(&self, i: usize, j: usize, k: usize) -> f32 {
        f32::from(self.get(i, j, k)) * EDIT_STEP
    }

    /// Adds `amount` metres of field to owned sample `(i, j, k)`, each in `0..32`: positive
    /// digs. Sums stop at [`EDIT_LIMIT_M`]; samples outside are left alone, and what is not a
    /// number is not added. Says whether [`Self::get`] changed.
    pub fn add(&mut self, i: usize, j: usize, k: usize, amount: f32) -> bool {
        if i.max(j).max(k) >= OWNED {
            return false;
        }
        self.add_at(owned_index(i, j, k), amount)
    }

    pub(crate) fn add_at(&mut self, at: usize, amount: f32) -> bool {
        // The cast saturates, and takes NaN to zero.
        let change = (amount / EDIT_STEP * PARTS as f32).round() as i32;
        if change == 0 {
            return false;
        }
        if self.parts.is_empty() {
            self.parts = vec![0; COUNT].into_boxed_slice();
        }
        let Some(parts) = self.parts.get_mut(at) else {
            return false;
        };
        let before = rounded(*parts);
        *parts = parts.saturating_add(change).clamp(-LIMIT, LIMIT);
        rounded(*parts) != before
    }

    fn unit(&self, at: usize) -> i16 {
        self.parts.get(at).map_or(0, |&parts| rounded(parts))
    }

    /// The number of the kind laid at owned sample `(i, j, k)`, each in `0..32`; 0 where none was, and outside.
    pub fn kind_byte(&self, i: usize, j: usize, k: usize) -> u8 {
        if i.max(j).max(k) >= OWNED {
            return 0;
        }
        self.laid(owned_index(i, j, k))
    }

    /// The numbers of all laid kinds, by `(i * 32 + k) * 32 + j`; empty where none was laid.
    pub fn kind_bytes(&self) -> &[u8] {
        &self.kinds
    }

    /// Whether a kind was laid that this game does not know.
    pub fn has_unknown_kinds(&self) -> bool {
        let is_unknown = |byte: &u8| *byte != 0 && Kind::of_byte(*byte).is_none();
        self.kinds.iter().any(is_unknown)
    }

    /// Lays a kind at a sample, or takes it away by 0. Says whether that changed anything.
    pub(crate) fn lay_at(&mut self, at: usize, byte: u8) -> bool {
        if self.laid(at) == byte {
            return false;
        }
        if self.kinds.is_empty() {
            self.kinds = vec![0; COUNT].into_boxed_slice();
        }
        if let Some(kind) = self.kinds.get_mut(at) {
            *kind = byte;
        }
        true
    }

    pub(crate) fn laid(&self, at: usize) -> u8 {
        self.kinds.get(at).copied().unwrap_or_default()
    }

    /// The same with the numbers of laid kinds that [`Self::kind_bytes`] gave; those of later games stay as they are.
    ///
    /// # Errors
    /// [`EditsError::Length`] unless there are 32^3 of them, or none.
    pub fn with_kind_bytes(self, kinds: &[u8]) -> Result<Self, EditsError> {
        if !matches!(kinds.len(), 0 | COUNT) {
            return Err(EditsError::Length { found: kinds.len() });
        }
        Ok(Self {
            kinds: kinds.into(),
            ..self
        })
    }

    /// All 32^3 edits in units of [`EDIT_STEP`], by `(i * 32 + k) * 32 + j`.
    pub fn to_units(&self) -> Vec<i16> {
        (0..COUNT).map(|at| self.unit(at)).collect()
    }

    /// The edits that [`Self::to_units`] gave.
    ///
    /// # Errors
    /// [`EditsError::Length`] unless there are 32^3 of them.
    pub fn from_units(units: &[i16]) -> Result<Self, EditsError> {
        if units.len() != COUNT {
            return Err(EditsError::Length { found: units.len() });
        }
        let sums = units
            .iter()
            .map(|&unit| (i32::from(unit) * PARTS).max(-LIMIT));
        Ok(Self {
            parts: sums.collect(),
            kinds: Box::default(),
        })
    }

    /// The units as little-endian bytes, 65,536 of them.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.to_units()
            .into_iter()
            .flat_map(i16::to_le_bytes)
            .collect()
    }

    /// The edits that [`Self::to_bytes`] gave.
    ///
    /// # Errors
    /// [`EditsError`] where the number of bytes is not 65,536.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, EditsError> {
        let (pairs, rest) = bytes.as_chunks::<2>();
        if !rest.is_empty() {
            return Err(EditsError::OddBytes { found: bytes.len() });
        }
        let units: Vec<_> = pairs.iter().map(|&pair| i16::from_le_bytes(pair)).collect();
        Self::from_units(&units)
    }
}

/// Samples along one axis that one chunk owns: the first in the block or face, the first that
/// is owned, and how many.
type Overlap = (usize, usize, usize);

/// The part of a block's axis that the neighbour at `offset` owns.
const fn overlap(offset: i32, level: Level) -> Overlap {
    let (step, cells) = (level.step_m() as usize, level.cells());
    match offset {
        0 => (1, 0, cells),
        o if o < 0 => (0, OWNED - step, 1),
        _ => (cells + 1, 0, 2),
    }
}

/// The part of an axis along a face that the neighbour at `offset` owns, at half the step.
const fn face_overlap(offset: i32, level: Level) -> Overlap {
    let cells = 2 * level.cells();
    match offset {
        0 => (0, 0, cells),
        1 => (cells, 0, 1),
        _ => (0, 0, 0),
    }
}

/// Adds the edits of the chunk at `coord` and of its 26 neighbours to the chunk's samples, the
/// border and the faces included. Samples of bedrock and above the ceiling stay as they are.
/// At every level a sample takes the edit of its own place, so that levels agree where they meet.
pub fn apply_edits(
    samples: &mut Samples,
    coord: ChunkCoord,
    lookup: impl Fn(ChunkCoord) -> Option<Arc<ChunkEdits>>,
) {
    for x in -1..=1 {
        for y in -1..=1 {
            for z in -1..=1 {
                let offset = IVec3::new(x, y, z);
                let owner = ChunkCoord {
                    chart: coord.chart,
                    index: coord.index.saturating_add(offset),
                };
                let Some(edits) = lookup(owner) else {
                    continue;
                };
                if !edits.parts.is_empty() {
                    add_neighbour(samples, coord, offset, &edits);
                    add_to_faces(samples, coord, offset, &edits);
                }
            }
        }
    }
}

fn add_neighbour(samples: &mut Samples, coord: ChunkCoord, offset: IVec3, edits: &ChunkEdits) {
    let (low, high) = samples.editable_y_m();
    let level = samples.level();
    let step = level.step_m() as usize;
    let first_m = coord.origin().y - f64::from(level.step_m());
    let (i0, a0, na) = overlap(offset.x, level);
    let (j0, b0, nb) = overlap(offset.y, level);
    let (k0, c0, nc) = overlap(offset.z, level);
    for a in 0..na {
        for c in 0..nc {
            let first = samples.index(i0 + a, j0, k0 + c);
            for b in 0..nb {
                let y = first_m + ((j0 + b) * step) as f64;
                if y >= low && y <= high {
                    let owned = owned_index(a0 + a * step, b0 + b * step, c0 + c * step);
                    samples.edit(first + b, edits.unit(owned), edits.laid(owned));
                }
            }
        }
    }
}

fn add_to_faces(samples: &mut Samples, coord: ChunkCoord, offset: IVec3, edits: &ChunkEdits) {
    let level = samples.level();
    let Some(finer) = level.finer() else {
        return;
    };
    let (low, high) = samples.editable_y_m();
    let (step, side) = (finer.step_m() as usize, samples.face_side());
    let first_m = coord.origin().y;
    for face in 0..6 {
        let (axis, far) = (face / 2, face % 2);
        if offset[axis] != far as i32 {
            continue;
        }
        let (row, rows) = FACE_AXES[axis];
        let (u0, a0, na) = face_overlap(offset[row], level);
        let (v0, b0, nb) = face_overlap(offset[rows], level);
        for b in 0..nb {
            for a in 0..na {
                let mut at = [0; 3];
                (at[row], at[rows]) = (a0 + a * step, b0 + b * step);
                let y = first_m + f64::from(offset.y * OWNED as i32) + at[1] as f64;
                if y >= low && y <= high {
                    let unit = edits.unit(owned_index(at[0], at[1], at[2]));
                    samples.face_mut(face)[(v0 + b) * side + u0 + a] += f32::from(unit) * EDIT_STEP;
                }
            }
        }
    }
}
