//! Brush strokes that wait for the batch under way to be shown.

use antipode_terrain::Stroke;

/// Strokes in one batch; the rest go into the next, so that a batch stays quick however long the
/// one before it took.
const MOST_PER_BATCH: usize = 64;

/// Strokes not yet handed to a worker, oldest first.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    waiting: Vec<Stroke>,
}

impl Strokes {
    /// Adds a stroke; one with the same place, size and sense as a waiting one adds its amount to
    /// that, which is the same edit with less rounding. Strokes that mean nothing are dropped.
    pub(crate) fn add(&mut self, stroke: Stroke) {
        if !meaningful(&stroke) {
            tracing::debug!(?stroke, "a stroke without effect was dropped");
            return;
        }
        match self.waiting.iter_mut().find(|other| alike(other, &stroke)) {
            Some(other) => other.amount += stroke.amount,
            None => self.waiting.push(stroke),
        }
    }

    /// Takes the strokes of the next batch.
    pub(crate) fn take(&mut self) -> Vec<Stroke> {
        let rest = self
            .waiting
            .split_off(self.waiting.len().min(MOST_PER_BATCH));
        std::mem::replace(&mut self.waiting, rest)
    }

    /// Puts back strokes that could not be handed over, before any that came since.
    pub(crate) fn put_back(&mut self, mut strokes: Vec<Stroke>) {
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
    a.centre == b.centre && a.radius_m == b.radius_m && (a.amount > 0.0) == (b.amount > 0.0)
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
        let amounts: Vec<f32> = strokes.take().iter().map(|s| s.amount).collect();
        assert_eq!(amounts, [4.0, -0.5, 0.5]);
        assert!(strokes.is_empty());
    }

    #[test]
    fn a_long_list_is_spread_over_batches_without_loss() {
        let mut strokes = Strokes::default();
        (0..150).for_each(|x| strokes.add(stroke(f64::from(x), 1.0)));
        let first = strokes.take();
        assert_eq!(first.len(), MOST_PER_BATCH);
        strokes.put_back(first);
        let mut all = Vec::new();
        while !strokes.is_empty() {
            all.extend(strokes.take());
        }
        let places: Vec<f64> = all.iter().map(|s| s.centre.pos.x).collect();
        assert_eq!(places, (0..150).map(f64::from).collect::<Vec<_>>());
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
