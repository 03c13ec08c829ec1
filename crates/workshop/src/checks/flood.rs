//! Where one can walk to: places spread from a beginning, from free cell to free cell in the open and in strides near what stands
//! there.

use std::cmp::Ordering;
use std::collections::{BinaryHeap, HashSet};

use antipode_deformation::{Passage, Place, Traveller};
use glam::DVec3;

use super::cells::{CELL_M, Cell, Cells, Frame, Kind};
use super::ground::{STRIDE_M, Stride};

/// Directions in which one sets out near something.
const WAYS: usize = 8;
/// Strides to the next of the least cells.
const STRIDES: usize = 2;
/// And at most, till one is out of a cell: so one goes through whatever parts it.
const MOST_STRIDES: usize = 4;

/// In which order places are gone on from: those with the least first.
type Key<'a> = &'a dyn Fn(&Reached) -> f64;

/// A place that was reached.
#[derive(Clone, Copy)]
pub(crate) struct Reached {
    pub place: Place,
    /// Felt metres walked.
    pub walked_m: f64,
    /// The cell that it stands for.
    pub cell: Cell,
    kind: Kind,
}

/// A place to go on from; the least key first.
struct Next {
    key: f64,
    index: usize,
}

/// What spreads.
pub(crate) struct Flood<'a> {
    cells: &'a Cells<'a>,
    all: Vec<Reached>,
    known: HashSet<Cell>,
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
    pub fn new(cells: &'a Cells<'a>, start: &Place) -> Self {
        let mut flood = Self {
            cells,
            all: Vec::new(),
            known: HashSet::new(),
            next: BinaryHeap::new(),
            passed: HashSet::new(),
            void: None,
        };
        let mut start = *start;
        start.straighten();
        flood.reach(start, 0.0, &|_| 0.0);
        flood
    }

    /// All places so far, in the order in which they were reached.
    pub fn reached(&self) -> &[Reached] {
        &self.all
    }

    /// Whether a place of the other is in a cell of this.
    pub fn meets(&self, other: &Self) -> bool {
        !self.known.is_disjoint(&other.known)
    }

    /// Goes on from the place with the least key; false if there is none left.
    pub fn go_on(&mut self, key: Key<'_>) -> bool {
        let Some(next) = self.next.pop() else {
            return false;
        };
        let from = self.all[next.index];
        if from.kind == Kind::Free {
            self.cross(&from, key);
        } else {
            for w in self.ways(&from.place) {
                self.walk(&from, w, key);
            }
        }
        true
    }

    /// The least key of the places to go on from.
    pub fn least_key(&self) -> Option<f64> {
        self.next.peek().map(|it| it.key)
    }

    /// Orders what is left anew, after what is sought has changed.
    pub fn reorder(&mut self, key: Key<'_>) {
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
        let up = self.cells.ground.up(place);
        let ahead = up.any_orthonormal_vector();
        let aside = up.cross(ahead);
        (0..WAYS).map(move |n| {
            let (sin, cos) = (n as f64 * std::f64::consts::TAU / WAYS as f64).sin_cos();
            ahead * cos + aside * sin
        })
    }

    /// Goes from a free cell to all cells beside it: to free ones, and in strides to what is in the least of the others.
    fn cross(&mut self, from: &Reached, key: Key<'_>) {
        let cells = self.cells;
        let frame = Frame::of(cells.ground, &from.place);
        let knee = frame.felt * from.place.point;
        let half = DVec3::new(1.0, 0.0, 1.0) * CELL_M / 2.0;
        let (low, high) = from.cell.corners(knee.y, knee.y);
        for out in [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z] {
            let along = DVec3::new(out.z.abs(), 0.0, out.x.abs());
            // The middles of the least cells at this rim, one after the other.
            let mut inside = low + half + (high - low - 2.0 * half) * out.max(DVec3::ZERO);
            while along.dot(inside) < along.dot(high) {
                let beside = cells.around(&frame, inside + out * CELL_M);
                let mut step = CELL_M;
                let mut to = inside;
                if beside.1 == Kind::Free {
                    let (least, most) = beside.0.corners(knee.y, knee.y);
                    to = knee.clamp(least, most);
                    step = along.dot(most + half - inside);
                }
                let point = frame.scene * to;
                let mut there = Reached {
                    // In a free cell there is no portal that one could have come out of just now, though perhaps its plane.
                    place: Place {
                        point,
                        passage: Passage::default(),
                        ..from.place
                    },
                    walked_m: from.walked_m + to.distance(knee),
                    ..*from
                };
                if beside.1 == Kind::Free {
                    (there.cell, there.kind) = beside;
                    self.add(there, key);
                } else {
                    self.walk(&there, frame.upright.inverse() * out, key);
                }
                inside += along * step;
            }
        }
    }

    /// Walks to the next of the least cells.
    fn walk(&mut self, from: &Reached, w: DVec3, key: Key<'_>) {
        if self.leads_to_known(from, w) {
            return;
        }
        let ground = self.cells.ground;
        let (mut place, mut w, mut walked_m) = (from.place, w, from.walked_m);
        for n in 1..=MOST_STRIDES {
            let before = place;
            match ground.stride(&place, w) {
                Stride::Blocked => return,
                Stride::Void(at) => {
                    if self.void.is_none_or(|(_, so_far)| walked_m < so_far) {
                        self.void = Some((at, walked_m));
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
                    walked_m += STRIDE_M;
                    if turned || (n >= STRIDES && self.cells.find(&place).0 != from.cell) {
                        break;
                    }
                }
            }
            // Where up is another way than before, so is what is level.
            let up = ground.up(&place);
            if up != ground.up(&before) {
                w = w.reject_from(up).try_normalize().unwrap_or(w);
            }
        }
        self.reach(place, walked_m, key);
    }

    /// Whether one comes, straight on, to a cell that is known, and through nothing that leads elsewhere.
    fn leads_to_known(&self, from: &Reached, w: DVec3) -> bool {
        if from.kind == Kind::Faced {
            return false;
        }
        let ground = self.cells.ground;
        let way = ground.space.carry(&from.place, w, &Traveller::Body) * w * STRIDE_M;
        let after = |n: usize| {
            let point = from.place.point + way * n as f64;
            self.cells.find(&Place {
                point,
                ..from.place
            })
        };
        let mut cells = (STRIDES..=MOST_STRIDES).map(after);
        let next = cells.find(|it| it.0 != from.cell);
        next.is_some_and(|(cell, kind)| kind != Kind::Faced && self.known.contains(&cell))
    }

    /// Comes to a place.
    fn reach(&mut self, place: Place, walked_m: f64, key: Key<'_>) {
        let (cell, kind) = self.cells.find(&place);
        let reached = Reached {
            place,
            walked_m,
            cell,
            kind,
        };
        self.add(reached, key);
    }

    fn add(&mut self, reached: Reached, key: Key<'_>) {
        if self.known.insert(reached.cell) {
            let (index, key) = (self.all.len(), key(&reached));
            self.all.push(reached);
            self.next.push(Next { key, index });
        }
    }
}
