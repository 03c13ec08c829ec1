//! What the player has dug and built in this visit, by kind of ground, and what of it is told.

use antipode_terrain::{Earth, Kind, Stock};

use crate::notice::Hint;
use crate::outbox::Outbox;
use antipode_streaming::NotUndone;

/// What a stroke has moved is shown so long after its end, seconds.
const SHOWN_S: f64 = 2.5;
/// Less is not shown, cubic metres.
const LEAST_SHOWN_M3: f64 = 0.05;
/// Who has dug so much slate in a visit and less coal than that, cubic metres, has dug where there is none.
const DEEP_M3: f64 = 40.0;
const COAL_M3: f64 = 1.0;
/// What goes against a stroke is shown from there on only, cubic metres: surfaces of ores beside it move a little.
const AGAINST_M3: f64 = 0.5;
/// So many kinds are shown, every ore among them and what there is most of besides: there is little of ores, and they are what
/// one digs for.
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
    /// What the last stroke has gathered and spent.
    paid: Stock,
    press: u64,
    /// When something was moved last, simulated seconds.
    moved_at_s: f64,
    told_of_coal: bool,
}

impl Earthworks {
    /// What was moved in this visit.
    pub fn total(&self) -> &Earth {
        &self.total
    }

    /// Enters what a press of the brush has moved, and what that gathers and spends.
    pub(crate) fn enter(&mut self, press: u64, earth: &Earth, gathered: &Stock, now_s: f64) {
        if press != self.press {
            self.press = press;
            self.stroke = Earth::default();
            self.paid = Stock::default();
        }
        self.stroke.add(earth);
        self.paid.add_all(gathered);
        self.total.add(earth);
        self.moved_at_s = now_s;
    }

    /// Whether it is to be told where coal lies: once, to who gathers, has dug deep in this visit, and found none and has none.
    pub(crate) fn misses_coal(&mut self, stock: Option<&Stock>) -> bool {
        let Some(stock) = stock else {
            return false;
        };
        let dug = |kind| self.total.dug_m3(kind);
        let has_coal = dug(Kind::Coal).max(stock.of(Kind::Coal)) >= COAL_M3;
        let in_vain = dug(Kind::Slate) > DEEP_M3 && !has_coal;
        in_vain && !std::mem::replace(&mut self.told_of_coal, true)
    }

    /// Takes back what a press has moved that is undone.
    pub(crate) fn take_back(&mut self, earth: &Earth) {
        self.total.take_back(earth);
        self.stroke = Earth::default();
        self.paid = Stock::default();
    }

    /// What is to be shown of the last stroke, ores and then the largest heap first: where one `gathers` what it gave and took, else the
    /// kinds of which most was dug, or built where that is more.
    pub(crate) fn shown(&self, gathers: bool, now_s: f64) -> Vec<Heap> {
        if now_s - self.moved_at_s > SHOWN_S {
            return Vec::new();
        }
        let mut heaps = if gathers {
            let paid = self.paid.kept();
            paid.map(|(kind, m3)| Heap { kind, m3 }).collect()
        } else {
            self.moved()
        };
        let gains = heaps.iter().map(|heap: &Heap| heap.m3).sum::<f64>() >= 0.0;
        heaps.retain(|heap| {
            let goes_along = (heap.m3 >= 0.0) == gains;
            heap.m3.abs()
                >= if goes_along {
                    LEAST_SHOWN_M3
                } else {
                    AGAINST_M3
                }
        });
        heaps.sort_by(|a, b| {
            let by_size = b.m3.abs().total_cmp(&a.m3.abs());
            b.kind.is_ore().cmp(&a.kind.is_ore()).then(by_size)
        });
        let ores = heaps.iter().filter(|heap| heap.kind.is_ore()).count();
        heaps.truncate(MOST_SHOWN.max(ores + 1));
        heaps
    }

    fn moved(&self) -> Vec<Heap> {
        let builds = self.stroke.gained_m3() < 0.0;
        let heap = |kind| Heap {
            kind,
            m3: if builds {
                -self.stroke.built_m3(kind)
            } else {
                self.stroke.dug_m3(kind)
            },
        };
        Kind::ALL.into_iter().map(heap).collect()
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
        assert!(works.shown(false, 0.0).is_empty());
        works.enter(1, &Earth::default(), &Stock::default(), 7.0);
        assert!(works.shown(false, 7.0).is_empty() && works.total().is_nothing());
    }

    #[test]
    fn an_ore_is_told_of_however_little_there_is_of_it() {
        let mut works = Earthworks::default();
        let mut paid = Stock::default();
        let dug = [
            (Kind::Slate, 30.0),
            (Kind::Soil, 9.0),
            (Kind::Coal, 0.4),
            (Kind::Copper, 0.01),
            (Kind::Crystal, -0.1),
        ];
        for (kind, m3) in dug {
            paid.add(kind, m3);
        }
        works.enter(1, &Earth::default(), &paid, 7.0);
        let shown = works.shown(true, 7.5);
        let kinds: Vec<_> = shown.iter().map(|heap| heap.kind).collect();
        assert_eq!(kinds, [Kind::Coal, Kind::Slate]);
        paid.add(Kind::Copper, 0.1);
        works.enter(2, &Earth::default(), &paid, 8.0);
        let shown = works.shown(true, 8.0);
        let kinds: Vec<_> = shown.iter().map(|heap| heap.kind).collect();
        assert_eq!(
            kinds,
            [Kind::Coal, Kind::Copper, Kind::Slate],
            "and what it lay in"
        );
    }

    /// Half of what is built may be a surface of another kind that moves.
    #[test]
    fn who_gathers_is_told_what_he_pays_and_not_what_grew() {
        let mut works = Earthworks::default();
        let mut paid = Stock::default();
        paid.add(Kind::Ash, -47.3);
        paid.add(Kind::Basalt, -0.01);
        works.enter(1, &Earth::default(), &paid, 7.0);
        let heap = Heap {
            kind: Kind::Ash,
            m3: -47.3,
        };
        assert_eq!(works.shown(true, 7.5), [heap]);
        works.enter(2, &Earth::default(), &Stock::default(), 8.0);
        assert!(works.shown(true, 8.0).is_empty());
    }
}
