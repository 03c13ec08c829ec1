//! Brush strokes that wait for the batch under way to be shown.

use antipode_terrain::Stroke;

/// Strokes in one batch; the rest go into the next, so that a batch stays quick however long the
/// one before it took.
const MOST_PER_BATCH: usize = 64;

/// Strokes not yet handed to a worker, oldest first.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    waiting: Vec<Stroke>,
    /// How many were handed over.
    taken: u64,
    /// As many of those that wait stand before a mark: what comes later is not added to them.
    marked: usize,
}

/// A moment between two strokes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Mark(u64);

impl Strokes {
    /// Adds a stroke; one with the same place, size and sense as a waiting one adds its amount to
    /// that, which is the same edit with less rounding. Strokes that mean nothing are dropped.
    pub(crate) fn add(&mut self, stroke: Stroke) {
        if !meaningful(&stroke) {
            tracing::debug!(?stroke, "a stroke without effect was dropped");
            return;
        }
        let open = &mut self.waiting[self.marked..];
        match open.iter_mut().find(|other| alike(other, &stroke)) {
            Some(other) => other.amount += stroke.amount,
            None => self.waiting.push(stroke),
        }
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

    /// Takes the strokes of the next batch, none that came after `until`.
    pub(crate) fn take(&mut self, until: Option<Mark>) -> Vec<Stroke> {
        let before = until.map_or(u64::MAX, |mark| mark.0.saturating_sub(self.taken));
        let most = before.min(MOST_PER_BATCH as u64) as usize;
        let rest = self.waiting.split_off(self.waiting.len().min(most));
        let taken = std::mem::replace(&mut self.waiting, rest);
        self.taken += taken.len() as u64;
        self.marked = self.marked.saturating_sub(taken.len());
        taken
    }

    /// Puts back strokes that could not be handed over, before any that came since.
    pub(crate) fn put_back(&mut self, mut strokes: Vec<Stroke>) {
        self.taken -= strokes.len() as u64;
        // A mark may stand right after them.
        self.marked += strokes.len();
        strokes.append(&mut self.waiting);
        self.waiting = strokes;
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
        && (a.amount > 0.0) == (b.amount > 0.0)
}

#[cfg(test)]
mod tests {
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
        }
    }

    #[test]
    fn equal_strokes_add_up_and_opposite_ones_stay_apart() {
        let mut strokes = Strokes::default();
        for _ in 0..8 {
            strokes.add(stroke(1.0, 0.5));
        }
        strokes.add(stroke(1.0, -0.5));
        strokes.add(stroke(2.0, 0.5));
        let amounts: Vec<f32> = strokes.take(None).iter().map(|s| s.amount).collect();
        assert_eq!(amounts, [4.0, -0.5, 0.5]);
        assert!(strokes.is_empty());
    }

    #[test]
    fn a_long_list_is_spread_over_batches_without_loss() {
        let mut strokes = Strokes::default();
        (0..150).for_each(|x| strokes.add(stroke(f64::from(x), 1.0)));
        let first = strokes.take(None);
        assert_eq!(first.len(), MOST_PER_BATCH);
        strokes.put_back(first);
        let mut all = Vec::new();
        while !strokes.is_empty() {
            all.extend(strokes.take(None));
        }
        let places: Vec<f64> = all.iter().map(|s| s.centre.pos.x).collect();
        assert_eq!(places, (0..150).map(f64::from).collect::<Vec<_>>());
    }

    #[test]
    fn no_stroke_after_a_mark_is_taken_before_it_or_added_to_one() {
        let mut strokes = Strokes::default();
        strokes.add(stroke(1.0, 0.5));
        strokes.add(stroke(2.0, 0.5));
        let mark = strokes.mark();
        strokes.add(stroke(1.0, 0.25));
        strokes.add(stroke(1.0, 0.25));
        assert!(!strokes.has_passed(mark));
        let first = strokes.take(Some(mark));
        strokes.put_back(first);
        strokes.add(stroke(2.0, 0.5));
        let amounts = |taken: &[Stroke]| taken.iter().map(|s| s.amount).collect::<Vec<_>>();
        assert_eq!(amounts(&strokes.take(Some(mark))), [0.5, 0.5]);
        assert!(strokes.has_passed(mark) && strokes.take(Some(mark)).is_empty());
        assert_eq!(amounts(&strokes.take(None)), [0.5, 0.5]);
    }

    #[test]
    fn strokes_without_meaning_are_dropped() {
        let mut strokes = Strokes::default();
        strokes.add(stroke(f64::NAN, 1.0));
        strokes.add(stroke(0.0, f32::INFINITY));
        strokes.add(stroke(0.0, 0.0));
        strokes.add(Stroke {
            radius_m: -1.0,
            ..stroke(0.0, 1.0)
        });
        assert!(strokes.is_empty());
    }
}
