//! The way back from edits: what samples were before, and what they were made.

use crate::edits::{COUNT, ChunkEdits, rounded};

/// An edit of a sample and the number of the kind laid there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct State {
    parts: i32,
    laid: u8,
}

/// A sample that was changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampleChange {
    at: u16,
    before: State,
    after: State,
}

impl ChunkEdits {
    /// Calls `found` with `(i, k)` of each column in which stored edits differ from another state's, and which do, as bits.
    pub(crate) fn each_changed_column(
        &self,
        other: &Self,
        mut found: impl FnMut(usize, usize, u32),
    ) {
        const NONE: [i32; 32] = [0; 32];
        let columns = |edits: &Self, n: usize| -> [i32; 32] {
            let column = edits.parts.as_chunks::<32>().0.get(n);
            column.copied().unwrap_or(NONE)
        };
        for n in 0..COUNT / 32 {
            let (here, there) = (columns(self, n), columns(other, n));
            if here == there {
                continue;
            }
            let differs = |j: &usize| rounded(here[*j]) != rounded(there[*j]);
            let mask = (0..32).filter(differs).fold(0, |mask, j| mask | 1 << j);
            if mask != 0 {
                found(n / 32, n % 32, mask);
            }
        }
    }

    /// The samples that differ in a later state.
    pub fn changes_to(&self, after: &Self) -> Vec<SampleChange> {
        let change = |at: usize| {
            let (before, after) = (self.state(at), after.state(at));
            (before != after).then_some(SampleChange {
                at: at as u16,
                before,
                after,
            })
        };
        (0..COUNT).filter_map(change).collect()
    }

    /// Makes samples what they were before changes. Where one of them is no longer what it was made, nothing is changed;
    /// says whether all were. What is left of edits that add up to less than can be stored does not count.
    pub fn take_back(&mut self, changes: &[SampleChange]) -> bool {
        let is_as_made = |change: &SampleChange| {
            let now = self.state(usize::from(change.at));
            let made = change.after;
            rounded(now.parts) == rounded(made.parts) && now.laid == made.laid
        };
        if !changes.iter().all(is_as_made) {
            return false;
        }
        for SampleChange { at, before, .. } in changes {
            let at = usize::from(*at);
            if let Some(parts) = self.parts.get_mut(at) {
                *parts = before.parts;
            }
            self.lay_at(at, before.laid);
        }
        if self.parts.iter().all(|parts| *parts == 0) {
            self.parts = Box::default();
        }
        if self.kinds.iter().all(|kind| *kind == 0) {
            self.kinds = Box::default();
        }
        true
    }

    fn state(&self, at: usize) -> State {
        State {
            parts: self.parts.get(at).copied().unwrap_or_default(),
            laid: self.laid(at),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;

    #[test]
    fn what_is_taken_back_is_as_it_was_and_what_was_changed_since_is_left() {
        let untouched = ChunkEdits::new();
        let mut dug = untouched.clone();
        dug.add(1, 2, 3, 0.5);
        dug.lay_at(7, Kind::Snow.byte());
        let mut deeper = dug.clone();
        deeper.add(1, 2, 3, 0.25);
        deeper.add(31, 31, 31, -4.0);
        let (first, second) = (untouched.changes_to(&dug), dug.changes_to(&deeper));
        assert_eq!((first.len(), second.len()), (2, 2));

        let mut now = deeper.clone();
        assert!(!now.take_back(&first), "changed since");
        assert_eq!(now, deeper);
        assert!(now.take_back(&second) && now == dug);
        assert!(now.take_back(&first) && now.is_empty());
        assert!(now.parts.is_empty() && now.kinds.is_empty());
    }

    #[test]
    fn columns_are_told_by_what_is_stored_of_them() {
        let mut edits = ChunkEdits::new();
        edits.add(4, 0, 9, 1.0);
        edits.add(4, 31, 9, -1.0);
        edits.add(5, 5, 5, 1e-5);
        let mut found = Vec::new();
        ChunkEdits::new().each_changed_column(&edits, |i, k, mask| found.push((i, k, mask)));
        assert_eq!(found, [(4, 9, 1 | 1 << 31)]);
    }
}
