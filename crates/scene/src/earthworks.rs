//! What the player has dug and built in this visit, by kind of ground. All worlds are creative: nothing is refused for it.

use antipode_terrain::{Earth, Kind};

use crate::notice::Hint;
use crate::outbox::Outbox;
use antipode_streaming::NotUndone;

/// What a stroke has moved is shown so long after its end, seconds.
const SHOWN_S: f64 = 2.5;
/// Less is not shown, cubic metres.
const LEAST_SHOWN_M3: f64 = 0.05;
/// So many kinds are shown.
const MOST_SHOWN: usize = 2;

/// Some ground of a kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heap {
    /// The kind.
    pub kind: Kind,
    /// How much, cubic metres of the space; what is built is less than zero.
    pub m3: f64,
}

/// What was moved in this visit, and by the last stroke.
#[derive(Clone, Debug, Default)]
pub struct Earthworks {
    total: Earth,
    stroke: Earth,
    press: u64,
    /// When something was moved last, simulated seconds.
    moved_at_s: f64,
}

impl Earthworks {
    /// What was moved in this visit.
    pub fn total(&self) -> &Earth {
        &self.total
    }

    /// Enters what a press of the brush has moved.
    pub(crate) fn enter(&mut self, press: u64, earth: &Earth, now_s: f64) {
        if press != self.press {
            self.press = press;
            self.stroke = Earth::default();
        }
        self.stroke.add(earth);
        self.total.add(earth);
        self.moved_at_s = now_s;
    }

    /// Takes back what a press has moved that is undone.
    pub(crate) fn take_back(&mut self, earth: &Earth) {
        self.total.take_back(earth);
        self.stroke = Earth::default();
    }

    /// What is to be shown of the last stroke: the kinds of which most was dug, or built where that is more, the largest
    /// heap first.
    pub(crate) fn shown(&self, now_s: f64) -> Vec<Heap> {
        if now_s - self.moved_at_s > SHOWN_S {
            return Vec::new();
        }
        let builds = self.stroke.gained_m3() < 0.0;
        let heap = |kind| Heap {
            kind,
            m3: if builds {
                -self.stroke.built_m3(kind)
            } else {
                self.stroke.dug_m3(kind)
            },
        };
        let mut heaps: Vec<_> = Kind::ALL.into_iter().map(heap).collect();
        heaps.retain(|heap| heap.m3.abs() >= LEAST_SHOWN_M3);
        heaps.sort_by(|a, b| b.m3.abs().total_cmp(&a.m3.abs()));
        heaps.truncate(MOST_SHOWN);
        heaps
    }
}

/// Tells the player what became of an undo, and takes back what the stroke had moved.
pub(crate) fn undone(works: &mut Earthworks, outbox: &mut Outbox, end: Result<Earth, NotUndone>) {
    outbox.hints.push(match end {
        Ok(earth) => {
            works.take_back(&earth);
            Hint::Undone
        }
        Err(why) => Hint::NotUndone(why),
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_shown_before_and_long_after_a_stroke() {
        let mut works = Earthworks::default();
        assert!(works.shown(0.0).is_empty());
        works.enter(1, &Earth::default(), 7.0);
        assert!(works.shown(7.0).is_empty() && works.total().is_nothing());
    }
}
