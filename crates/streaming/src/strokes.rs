//! Brush strokes that wait for the batch under way to be shown.

use antipode_geometry::ChunkCoord;
use antipode_terrain::{Stroke, Thing};

/// Strokes in one batch; the rest go into the next, so that a batch stays quick however long the
/// one before it took.
const MOST_PER_BATCH: usize = 64;

/// What waits.
#[derive(Debug)]
enum Waiting {
    /// A stroke, and the press that it is of.
    Stroke(Stroke, Option<u64>),
    /// The last press is to be undone.
    Undo,
    /// What stands on a chunk changes.
    Thing(ChunkCoord, ThingChange),
}

/// A change of one thing on a chunk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ThingChange {
    /// The thing of a slot is felled.
    Felled(u8),
    /// Somebody planted it, or it has grown, in its slot.
    Planted(Thing),
    /// Nothing is left of what somebody planted in a slot.
    Gone(u8),
}

/// What a batch does.
#[derive(Debug, PartialEq)]
pub(crate) enum Work {
    /// These strokes in the order in which they were made, all of one press.
    Strokes(Vec<Stroke>, Option<u64>),
    /// The last press is undone.
    Undo,
    /// What stands on a chunk changes.
    Thing(ChunkCoord, ThingChange),
}

/// Strokes not yet handed to a worker, oldest first.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    waiting: Vec<Waiting>,
    /// How many were handed over.
    taken: u64,
    /// As many of those that wait stand before a mark: what comes later is not added to them.
    marked: usize,
}

/// A moment between two strokes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Mark(u64);

impl Strokes {
    /// Adds a stroke of a press; one with the same place, size and sense as a waiting one adds its amount to
    /// that, which is the same edit with less rounding. Strokes that mean nothing are dropped.
    pub(crate) fn add(&mut self, stroke: Stroke, press: Option<u64>) {
        if !meaningful(&stroke) {
            tracing::debug!(?stroke, "a stroke without effect was dropped");
            return;
        }
        let open = self.waiting[self.marked..].iter_mut();
        let mut alike = open.filter_map(|it| match it {
            Waiting::Stroke(other, of) if *of == press => alike(other, &stroke).then_some(other),
            _ => None,
        });
        match alike.next() {
            Some(other) => other.amount += stroke.amount,
            None => self.waiting.push(Waiting::Stroke(stroke, press)),
        }
    }

    /// Has the last press undone after every stroke so far, before any other.
    pub(crate) fn undo(&mut self) {
        self.waiting.push(Waiting::Undo);
        self.marked = self.waiting.len();
    }

    /// Has a thing changed after every stroke so far, before any other.
    pub(crate) fn change(&mut self, coord: ChunkCoord, change: ThingChange) {
        self.waiting.push(Waiting::Thing(coord, change));
        self.marked = self.waiting.len();
    }

    /// The moment now: after every stroke so far, before any other.
    pub(crate) fn mark(&mut self) -> Mark {
        self.marked = self.waiting.len();
        Mark(self.taken + self.waiting.len() as u64)
    }

    /// Has every stroke before that moment been handed over?
    pub(crate) fn has_passed(&self, mark: Mark) -> bool {
        self.taken >= mark.0
    }

    /// Takes the work of the next batch, nothing that came after `until`: strokes of one press, or an undo.
    pub(crate) fn take(&mut self, until: Option<Mark>) -> Option<Work> {
        let before = until.map_or(u64::MAX, |mark| mark.0.saturating_sub(self.taken));
        let most = before.min(MOST_PER_BATCH as u64) as usize;
        let (press, count) = match self.waiting.iter().take(most).next()? {
            Waiting::Undo | Waiting::Thing(..) => (None, 1),
            Waiting::Stroke(_, press) => {
                let first = self.waiting.iter().take(most);
                let same = |it: &&Waiting| matches!(it, Waiting::Stroke(_, of) if of == press);
                (*press, first.take_while(same).count())
            }
        };
        self.taken += count as u64;
        self.marked = self.marked.saturating_sub(count);
        let mut strokes = Vec::with_capacity(count);
        for it in self.waiting.drain(..count) {
            match it {
                Waiting::Stroke(stroke, _) => strokes.push(stroke),
                Waiting::Undo => return Some(Work::Undo),
                Waiting::Thing(coord, change) => return Some(Work::Thing(coord, change)),
            }
        }
        Some(Work::Strokes(strokes, press))
    }

    /// Puts back work that could not be handed over, before any that came since.
    pub(crate) fn put_back(&mut self, work: Work) {
        let before: Vec<_> = match work {
            Work::Undo => vec![Waiting::Undo],
            Work::Thing(coord, change) => vec![Waiting::Thing(coord, change)],
            Work::Strokes(strokes, press) => {
                let strokes = strokes.into_iter();
                strokes.map(|it| Waiting::Stroke(it, press)).collect()
            }
        };
        self.taken -= before.len() as u64;
        // A mark may stand right after them.
        self.marked += before.len();
        self.waiting.splice(0..0, before);
    }

    /// Does nothing wait?
    pub(crate) fn is_empty(&self) -> bool {
        self.waiting.is_empty()
    }
}

fn meaningful(stroke: &Stroke) -> bool {
    let finite =
        stroke.centre.pos.is_finite() && stroke.radius_m.is_finite() && stroke.amount.is_finite();
    finite && stroke.radius_m > 0.0 && stroke.amount != 0.0
}

/// Mining and building are never merged: the field's limits clip each of them on its own.
fn alike(a: &Stroke, b: &Stroke) -> bool {
    a.centre == b.centre
        && a.radius_m == b.radius_m
        && a.part == b.part
        && a.kind == b.kind
        && a.shape == b.shape
        && a.power == b.power
        && (a.amount > 0.0) == (b.amount > 0.0)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;
    use antipode_geometry::ChartPoint;
    use glam::DVec3;

    fn stroke(x: f64, amount: f32) -> Stroke {
        Stroke {
            centre: ChartPoint::a(DVec3::new(x, 0.0, 0.0)),
            radius_m: 5.0,
            amount,
            part: antipode_terrain::Part::Whole,
            kind: None,
            shape: antipode_terrain::Shape::Ball,
            power: None,
        }
    }

    fn strokes_of(work: Option<Work>) -> Vec<Stroke> {
        match work {
            Some(Work::Strokes(strokes, _)) => strokes,
            other => panic!("no strokes: {other:?}"),
        }
    }

    #[test]
    fn equal_strokes_add_up_and_opposite_ones_stay_apart() {
        let mut strokes = Strokes::default();
        for _ in 0..8 {
            strokes.add(stroke(1.0, 0.5), None);
        }
        strokes.add(stroke(1.0, -0.5), None);
        strokes.add(stroke(2.0, 0.5), None);
        let taken = strokes_of(strokes.take(None));
        let amounts: Vec<f32> = taken.iter().map(|s| s.amount).collect();
        assert_eq!(amounts, [4.0, -0.5, 0.5]);
        assert!(strokes.is_empty());
    }

    #[test]
    fn a_long_list_is_spread_over_batches_without_loss() {
        let mut strokes = Strokes::default();
        (0..150).for_each(|x| strokes.add(stroke(f64::from(x), 1.0), None));
        let first = strokes_of(strokes.take(None));
        assert_eq!(first.len(), MOST_PER_BATCH);
        strokes.put_back(Work::Strokes(first, None));
        let mut all = Vec::new();
        while !strokes.is_empty() {
            all.extend(strokes_of(strokes.take(None)));
        }
        let places: Vec<f64> = all.iter().map(|s| s.centre.pos.x).collect();
        assert_eq!(places, (0..150).map(f64::from).collect::<Vec<_>>());
    }

    #[test]
    fn no_stroke_after_a_mark_is_taken_before_it_or_added_to_one() {
        let mut strokes = Strokes::default();
        strokes.add(stroke(1.0, 0.5), None);
        strokes.add(stroke(2.0, 0.5), None);
        let mark = strokes.mark();
        strokes.add(stroke(1.0, 0.25), None);
        strokes.add(stroke(1.0, 0.25), None);
        assert!(!strokes.has_passed(mark));
        let first = strokes.take(Some(mark)).unwrap();
        strokes.put_back(first);
        strokes.add(stroke(2.0, 0.5), None);
        let amounts = |taken: &[Stroke]| taken.iter().map(|s| s.amount).collect::<Vec<_>>();
        assert_eq!(amounts(&strokes_of(strokes.take(Some(mark)))), [0.5, 0.5]);
        assert!(strokes.has_passed(mark) && strokes.take(Some(mark)).is_none());
        assert_eq!(amounts(&strokes_of(strokes.take(None))), [0.5, 0.5]);
    }

    #[test]
    fn strokes_without_meaning_are_dropped() {
        let mut strokes = Strokes::default();
        strokes.add(stroke(f64::NAN, 1.0), None);
        strokes.add(stroke(0.0, f32::INFINITY), None);
        strokes.add(stroke(0.0, 0.0), None);
        let inside_out = Stroke {
            radius_m: -1.0,
            ..stroke(0.0, 1.0)
        };
        strokes.add(inside_out, None);
        assert!(strokes.is_empty());
    }

    #[test]
    fn no_batch_is_of_two_presses_and_nothing_is_added_across_an_undo() {
        let mut strokes = Strokes::default();
        let of = |press: u64| Some(press);
        strokes.add(stroke(1.0, 0.5), of(1));
        strokes.add(stroke(1.0, 0.5), of(2));
        strokes.undo();
        strokes.add(stroke(1.0, 0.5), of(2));
        strokes.add(stroke(1.0, 0.5), of(2));
        let expected = [
            Work::Strokes(vec![stroke(1.0, 0.5)], of(1)),
            Work::Strokes(vec![stroke(1.0, 0.5)], of(2)),
            Work::Undo,
            Work::Strokes(vec![stroke(1.0, 1.0)], of(2)),
        ];
        for work in expected {
            let taken = strokes.take(None).unwrap();
            assert_eq!(taken, work);
            strokes.put_back(taken);
            assert_eq!(strokes.take(None), Some(work));
        }
        assert!(strokes.is_empty());
    }
}
