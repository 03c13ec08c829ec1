//! Ground that somebody has gathered, by kind: digging adds to it, building spends it.

use crate::earth::{Earth, KINDS, at};
use crate::kind::Kind;

/// What cannot be measured, cubic metres.
const LEAST_M3: f64 = 1e-6;

/// Nobody digs more, cubic metres: a cube of ten kilometres.
const MOST_M3: f64 = 1e12;

/// Ground by kind, cubic metres of the space; or what is added to some, where it may be less than zero.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stock {
    m3: [f64; KINDS],
}

impl Stock {
    /// How much there is of a kind, cubic metres.
    pub fn of(&self, kind: Kind) -> f64 {
        self.m3[at(kind)].max(0.0)
    }

    /// What there is, as it is kept: of ores it may be less than zero.
    pub fn kept(&self) -> impl Iterator<Item = (Kind, f64)> {
        let all = Kind::ALL.into_iter().zip(self.m3);
        all.filter(|(_, m3)| *m3 != 0.0)
    }

    /// The kind of which there is most, if there is anything.
    pub fn most(&self) -> Option<Kind> {
        let some = Kind::ALL.into_iter().filter(|kind| self.of(*kind) > 0.0);
        some.max_by(|a, b| self.of(*a).total_cmp(&self.of(*b)))
    }

    /// Adds cubic metres of a kind; nothing that is no number, and no more than anybody digs.
    pub fn add(&mut self, kind: Kind, m3: f64) {
        if m3.is_finite() {
            let sum = &mut self.m3[at(kind)];
            *sum = (*sum + m3).clamp(-MOST_M3, MOST_M3);
        }
    }

    /// Adds all of another.
    pub fn add_all(&mut self, other: &Self) {
        for (sum, more) in self.m3.iter_mut().zip(other.m3) {
            *sum += more;
        }
    }

    /// The same with the other sign.
    #[must_use]
    pub fn negative(&self) -> Self {
        Self {
            m3: self.m3.map(|m3| -m3),
        }
    }

    /// Whether a change takes no more than there is.
    pub fn allows(&self, change: &Self) -> bool {
        let mut pairs = self.m3.iter().zip(change.m3);
        pairs.all(|(there, change)| change >= 0.0 || there + change >= -LEAST_M3)
    }

    /// Whether so much can be built of a kind. Ores that only grow with it do not count: see [`Earth::gathered`].
    pub fn allows_building(&self, change: &Self, builds: Option<Kind>) -> bool {
        let mut counted = *change;
        for ore in Kind::ALL
            .into_iter()
            .filter(|kind| kind.is_ore() && builds != Some(*kind))
        {
            counted.m3[at(ore)] = 0.0;
        }
        self.allows(&counted)
    }
}

impl Earth {
    /// What this adds to a stock, and takes from it, of who builds of a kind; without one, of what was dug most of.
    ///
    /// A surface between two samples moves before a sample turns, and what grows so is of the kind that is there. It is paid for
    /// with what is built all the same, but for ores: each is paid for with itself, at once or when it is dug again, so that
    /// nobody grows copper with soil.
    pub fn gathered(&self, builds: Option<Kind>) -> Stock {
        let mut stock = Stock::default();
        let builds = builds.or_else(|| self.most_dug());
        for kind in Kind::ALL {
            let pays = builds.filter(|_| !kind.is_ore()).unwrap_or(kind);
            stock.add(kind, self.dug_m3(kind));
            stock.add(pays, -self.built_m3(kind));
        }
        stock
    }

    /// The kind, no ore, of which most was dug.
    fn most_dug(&self) -> Option<Kind> {
        let dug = Kind::ALL.into_iter().filter(|kind| !kind.is_ore());
        let dug = dug.filter(|kind| self.dug_m3(*kind) > 0.0);
        dug.max_by(|a, b| self.dug_m3(*a).total_cmp(&self.dug_m3(*b)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stock(heaps: &[(Kind, f64)]) -> Stock {
        let mut stock = Stock::default();
        for (kind, m3) in heaps {
            stock.add(*kind, *m3);
        }
        stock
    }

    #[test]
    fn a_change_is_allowed_as_far_as_there_is_what_it_takes() {
        let some = stock(&[(Kind::Soil, 2.0)]);
        let allowed = |kind, m3| some.allows_building(&stock(&[(kind, m3)]), Some(Kind::Soil));
        assert!(allowed(Kind::Soil, -2.0) && allowed(Kind::Rock, 3.0));
        assert!(!allowed(Kind::Soil, -2.1) && !allowed(Kind::Grass, -0.1));
        assert!(allowed(Kind::Copper, -0.1), "it grew");
        let copper = stock(&[(Kind::Copper, -0.1)]);
        assert!(
            !some.allows_building(&copper, Some(Kind::Copper)),
            "it is built"
        );
        assert!(!some.allows(&copper));
    }

    #[test]
    fn the_most_is_what_there_is_most_of_and_debts_are_nothing() {
        assert_eq!(Stock::default().most(), None);
        let mut some = stock(&[(Kind::Coal, -1.0), (Kind::Sand, 0.5), (Kind::Clay, 2.0)]);
        assert_eq!((some.most(), some.of(Kind::Coal)), (Some(Kind::Clay), 0.0));
        let before = some;
        some.add(Kind::Clay, f64::NAN);
        assert_eq!(some, before);
        let mut full = stock(&[(Kind::Clay, f64::MAX), (Kind::Clay, f64::MAX)]);
        assert_eq!(full.of(Kind::Clay), MOST_M3);
        full.add(Kind::Clay, -f64::MAX);
        assert_eq!(full.of(Kind::Clay), 0.0);
        some.add_all(&before.negative());
        assert_eq!(some.kept().count(), 0);
    }
}
