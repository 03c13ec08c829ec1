//! Where one can walk to: places spread from a beginning, in strides near what stands there and in long ways in the open.
//!
//! Places are kept by the cells that they are in, in felt metres of the boxes around them, so that a box with more room inside
//! has more cells. A long way to a cell that another place is in adds nothing if both see each other.

use std::cmp::Ordering;
use std::collections::{BinaryHeap, HashMap, HashSet};

use antipode_deformation::{Place, Traveller};
use glam::{DQuat, DVec3, IVec3};

use super::ground::{Ground, STRIDE_M, Stride};

/// The edge of a cell, and its height, felt metres.
const CELL_M: f64 = 0.5;
const CELL_HIGH_M: f64 = 1.0;
/// The length of a long way, and the edge of the cells for these, felt metres.
const LONG_M: f64 = 1.987;
const FAR_CELL_M: f64 = 1.0;
/// Directions in which one sets out.
const WAYS: usize = 8;
/// Strides to the next cell.
const STRIDES: usize = 2;

/// A cell: the innermost box around it, the size of who is there in eighths of octaves, and its numbers.
type Cell = (usize, i32, IVec3);

/// A place that was reached.
#[derive(Clone, Copy)]
pub(crate) struct Reached {
    pub place: Place,
    /// Felt metres walked.
    pub walked_m: f64,
}

/// A place to go on from; the least key first.
struct Next {
    key: f64,
    index: usize,
}

/// What spreads.
pub(crate) struct Flood<'a> {
    ground: &'a Ground<'a>,
    upright: DQuat,
    all: Vec<Reached>,
    cells: HashSet<Cell>,
    far_cells: HashMap<Cell, Vec<usize>>,
    next: BinaryHeap<Next>,
    /// Portals that were gone through, by number.
    pub passed: HashSet<usize>,
    /// Where one falls out, with what was walked till there: the nearest.
    pub void: Option<(DVec3, f64)>,
}

impl PartialEq for Next {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Next {}

impl PartialOrd for Next {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Next {
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .key
            .total_cmp(&self.key)
            .then(other.index.cmp(&self.index))
    }
}

impl<'a> Flood<'a> {
    /// Begins where somebody stands.
    pub fn new(ground: &'a Ground<'a>, start: &Place) -> Self {
        let up = -ground.gravity.normalize_or(DVec3::NEG_Y);
        let mut flood = Self {
            ground,
            upright: DQuat::from_rotation_arc(up, DVec3::Y),
            all: Vec::new(),
            cells: HashSet::new(),
            far_cells: HashMap::new(),
            next: BinaryHeap::new(),
            passed: HashSet::new(),
            void: None,
        };
        let start = Reached {
            place: *start,
            walked_m: 0.0,
        };
        flood.add(start, 0.0);
        flood
    }

    /// All places so far, in the order in which they were reached.
    pub fn reached(&self) -> &[Reached] {
        &self.all
    }

    /// Whether a place of the other is in a cell of this.
    pub fn meets(&self, other: &Self) -> bool {
        self.cells.iter().any(|it| other.cells.contains(it))
    }

    /// Goes on from the place with the least key; false if there is none left. `key` tells in which order places are gone on from.
    pub fn go_on(&mut self, key: &dyn Fn(&Reached) -> f64) -> bool {
        let Some(next) = self.next.pop() else {
            return false;
        };
        let from = self.all[next.index];
        let ways: Vec<_> = self.ways(&from.place).collect();
        let far = ways.iter().filter(|w| self.go_far(&from, **w, key)).count();
        if far < ways.len() {
            // Something is near: here it matters where exactly one walks.
            for w in ways {
                self.go_near(&from, w, key);
            }
        }
        true
    }

    /// The least key of the places to go on from.
    pub fn least_key(&self) -> Option<f64> {
        self.next.peek().map(|it| it.key)
    }

    /// Orders what is left anew, after what is sought has changed.
    pub fn reorder(&mut self, key: &dyn Fn(&Reached) -> f64) {
        let all = std::mem::take(&mut self.next).into_iter();
        self.next = all
            .map(|it| Next {
                key: key(&self.all[it.index]),
                ..it
            })
            .collect();
    }

    /// Level felt directions at a place.
    fn ways(&self, place: &Place) -> impl Iterator<Item = DVec3> + use<> {
        let up = self.ground.up(place);
        let ahead = up.any_orthonormal_vector();
        let aside = up.cross(ahead);
        (0..WAYS).map(move |n| {
            let (sin, cos) = (n as f64 * std::f64::consts::TAU / WAYS as f64).sin_cos();
            ahead * cos + aside * sin
        })
    }

    /// Goes a long way, if there is one.
    fn go_far(&mut self, from: &Reached, w: DVec3, key: &dyn Fn(&Reached) -> f64) -> bool {
        let Some(place) = self.ground.long_way(&from.place, w, LONG_M) else {
            return false;
        };
        let cell = self.cell(&place, FAR_CELL_M);
        let known = self.far_cells.get(&cell).into_iter().flatten();
        let sees = |it: &usize| self.ground.is_open_between(&place, &self.all[*it].place);
        if !known.clone().any(sees) && !self.cells.contains(&self.cell(&place, CELL_M)) {
            let walked_m = from.walked_m + LONG_M;
            let reached = Reached { place, walked_m };
            self.add(reached, key(&reached));
        }
        true
    }

    /// Goes to the next cell.
    fn go_near(&mut self, from: &Reached, w: DVec3, key: &dyn Fn(&Reached) -> f64) {
        let mut place = from.place;
        let mut w = w;
        for _ in 0..STRIDES {
            let before = place;
            match self.ground.stride(&place, w) {
                Stride::Blocked => return,
                Stride::Void(at) => {
                    let walked = from.walked_m;
                    if self.void.is_none_or(|(_, so_far)| walked < so_far) {
                        self.void = Some((at, walked));
                    }
                    return;
                }
                Stride::Falls(passed) => {
                    self.passed.extend(passed);
                    return;
                }
                Stride::To(to, passed) => {
                    place = to;
                    let turned = !passed.is_empty();
                    self.passed.extend(passed);
                    if turned {
                        break;
                    }
                }
            }
            // Where up is another way than before, so is what is level.
            let up = self.ground.up(&place);
            if up != self.ground.up(&before) {
                w = w.reject_from(up).try_normalize().unwrap_or(w);
            }
        }
        if !self.cells.contains(&self.cell(&place, CELL_M)) {
            let walked_m = from.walked_m + STRIDE_M * STRIDES as f64;
            let reached = Reached { place, walked_m };
            self.add(reached, key(&reached));
        }
    }

    fn add(&mut self, reached: Reached, key: f64) {
        let index = self.all.len();
        self.cells.insert(self.cell(&reached.place, CELL_M));
        let far = self.cell(&reached.place, FAR_CELL_M);
        self.far_cells.entry(far).or_default().push(index);
        self.all.push(reached);
        self.next.push(Next { key, index });
    }

    fn cell(&self, place: &Place, edge_m: f64) -> Cell {
        let k = self
            .ground
            .space
            .squeeze(&place.stack, DVec3::ZERO, &Traveller::Body)
            * place.scale;
        let felt = self.upright * (k.inverse() * place.point);
        let numbers = (felt / DVec3::new(edge_m, CELL_HIGH_M, edge_m))
            .floor()
            .as_ivec3();
        let within = place.stack.innermost().map_or(0, |it| it + 1);
        (within, (place.scale.log2() * 8.0).round() as i32, numbers)
    }
}
