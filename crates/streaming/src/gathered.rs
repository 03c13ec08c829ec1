//! The ground that the player of a gathering world has gathered, where strokes and saves come together.

use antipode_storage::{EarthRecord, Record, RecordChanges, RecordKind};
use antipode_terrain::{Kind, Stock};

/// What there is, and what became of it besides building. Changes come in the order of the batches that made them.
#[derive(Debug, Default)]
pub(crate) struct Gathered {
    /// What there is; none where nothing is gathered or spent.
    pub(crate) stock: Option<Stock>,
    /// All that was spent in this visit by other means than strokes: less than zero what was given.
    pub(crate) spent: Stock,
    /// Of kinds that only a later game knows; they stay as they are.
    strange: Vec<(u8, f64)>,
}

impl Gathered {
    /// What is kept of a world, or what a new one begins with.
    pub(crate) fn of(kept: Option<&EarthRecord>) -> Self {
        let mut stock = Stock::default();
        let mut strange = Vec::new();
        for &(byte, m3) in kept.into_iter().flat_map(|kept| &kept.kinds) {
            match Kind::of_byte(byte) {
                Some(kind) => stock.add(kind, m3),
                None => strange.push((byte, m3)),
            }
        }
        Self {
            stock: Some(stock),
            strange,
            ..Self::default()
        }
    }

    /// Adds what a batch has brought.
    pub(crate) fn add(&mut self, change: &Stock) {
        if let Some(stock) = &mut self.stock {
            stock.add_all(change);
        }
    }

    /// Takes so much out, if there is as much; less than zero is given. Says whether it was done.
    pub(crate) fn spend(&mut self, price: &Stock) -> bool {
        let Some(stock) = &mut self.stock else {
            return false;
        };
        let change = price.negative();
        let is_done = stock.allows(&change);
        if is_done {
            stock.add_all(&change);
            self.spent.add_all(price);
        }
        is_done
    }

    /// What a save holds of it that was asked for when `spent` had been spent: all that the land's edits have brought, but
    /// of the rest only what the save's other records know of.
    pub(crate) fn record(&self, spent: &Stock) -> RecordChanges {
        let Some(mut stock) = self.stock else {
            return RecordChanges::new();
        };
        stock.add_all(&self.spent);
        stock.add_all(&spent.negative());
        let known = stock.kept().map(|(kind, m3)| (kind.byte(), m3));
        let kinds = known.chain(self.strange.iter().copied()).collect();
        let record = Record::Earth(EarthRecord { kinds });
        RecordChanges::from([(RecordKind::Earth.numbered(0), Some(record))])
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic, reason = "tests fail by panicking")]

    use super::*;

    fn heap(kind: Kind, m3: f64) -> Stock {
        let mut stock = Stock::default();
        stock.add(kind, m3);
        stock
    }

    fn kinds(record: RecordChanges) -> Vec<(u8, f64)> {
        match record.into_values().next() {
            Some(Some(Record::Earth(kept))) => kept.kinds,
            other => panic!("no earth: {other:?}"),
        }
    }

    #[test]
    fn a_save_has_what_strokes_brought_and_nothing_that_was_spent_after_it_was_asked_for() {
        let mut gathered = Gathered::of(Some(&EarthRecord {
            kinds: vec![(Kind::Coal.byte(), 3.0), (200, 7.0)],
        }));
        assert!(gathered.spend(&heap(Kind::Coal, 1.0)));
        let asked = gathered.spent;
        assert!(gathered.spend(&heap(Kind::Coal, 1.5)));
        gathered.add(&heap(Kind::Sand, 2.0));
        assert!(
            !gathered.spend(&heap(Kind::Coal, 1.0)),
            "half a metre is left"
        );
        let (sand, coal) = (Kind::Sand.byte(), Kind::Coal.byte());
        let expected = vec![(sand, 2.0), (coal, 2.0), (200, 7.0)];
        assert_eq!(kinds(gathered.record(&asked)), expected);
        let now = gathered.spent;
        assert_eq!(kinds(gathered.record(&now))[1], (coal, 0.5));
    }

    #[test]
    fn a_world_that_gathers_nothing_keeps_nothing() {
        let mut none = Gathered::default();
        none.add(&heap(Kind::Soil, 1.0));
        assert!(!none.spend(&Stock::default()) && none.record(&Stock::default()).is_empty());
    }
}
