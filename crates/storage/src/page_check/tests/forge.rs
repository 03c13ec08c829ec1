//! A forger for the tests: changes a store and seals it anew, so that no checksum tells.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::collections::HashMap;

use super::super::node::{Node, Widths};
use super::super::pages::PageNumber;
use super::super::{checksum, u64_at};

const NAMES: Widths = Widths {
    key: None,
    value: None,
};

/// The bytes of a store.
#[derive(Clone)]
pub(crate) struct Forge {
    pub(crate) bytes: Vec<u8>,
}

/// A table: where its definition is in the file, and how wide its entries.
#[derive(Clone, Copy)]
pub(crate) struct Found {
    pub(crate) definition: usize,
    pub(crate) widths: Widths,
}

impl Forge {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let bytes = bytes.to_vec();
        Self { bytes }
    }

    /// Where the commit slot in force begins.
    pub(crate) fn slot(&self) -> usize {
        if self.bytes[9] & 1 == 0 { 64 } else { 192 }
    }

    /// Where a page begins and ends, by where its number is stored.
    pub(crate) fn page(&self, number_at: usize) -> std::ops::Range<usize> {
        let bits = u64_at(&self.bytes, number_at).unwrap();
        let page = PageNumber::from_bits(bits);
        let start = 4096 + ((page.region << 20) + (page.index << page.order)) as usize * 4096;
        start..start + (4096 << page.order)
    }

    /// A table of the user tree (`of` 8) or the system tree (40).
    pub(crate) fn table(&self, of: usize, name: &str) -> Found {
        let names = self.page(self.slot() + of);
        let (node, _) = Node::covered(&self.bytes[names.clone()], NAMES).unwrap();
        let Node::Leaf(leaf) = node else {
            panic!("many tables")
        };
        let mut entries = leaf.entries().map(Result::unwrap);
        let (_, value) = entries.find(|(key, _)| *key == name.as_bytes()).unwrap();
        let definition = value.as_ptr() as usize - self.bytes.as_ptr() as usize;
        let width = |at: usize| (value[at] != 0).then_some(usize::from(value[at + 1]));
        let widths = Widths {
            key: width(42),
            value: width(47),
        };
        Found { definition, widths }
    }

    /// The chunks' table.
    pub(crate) fn chunks(&self) -> Found {
        self.table(8, "chunks")
    }

    /// Where the numbers of all pages of a table are stored, its root's first.
    pub(crate) fn numbers(&self, table: Found) -> Vec<usize> {
        let mut numbers = vec![table.definition + 10];
        let mut at = 0;
        while let Some(&number) = numbers.get(at) {
            let page = self.page(number);
            if self.bytes[page.start] == 2 {
                let count = usize::from(self.bytes[page.start + 2]) + 1;
                let first = page.start + 8 + 16 * count;
                numbers.extend((0..count).map(|child| first + 8 * child));
            }
            at += 1;
        }
        numbers
    }

    /// Where the pages of the chunks' table begin: its branches or its leaves.
    pub(crate) fn pages_of_kind(&self, kind: u8) -> Vec<usize> {
        let numbers = self.numbers(self.chunks());
        let starts = numbers.iter().map(|&number| self.page(number).start);
        starts.filter(|&start| self.bytes[start] == kind).collect()
    }

    /// Computes every checksum anew, from the leaves to the header.
    pub(crate) fn reseal(&mut self) -> &mut Self {
        let slot = self.slot();
        let mut known = HashMap::new();
        for tree in [8, 40] {
            if self.bytes[slot + tree / 32 + 1] == 0 {
                continue;
            }
            let names = self.page(slot + tree);
            let tables: Vec<Found> = {
                let (node, _) = Node::covered(&self.bytes[names], NAMES).unwrap();
                let Node::Leaf(leaf) = node else {
                    panic!("many tables")
                };
                let keys = leaf.entries().map(|entry| entry.unwrap().0.to_vec());
                let text = keys.map(|key| String::from_utf8(key).unwrap());
                text.map(|name| self.table(tree, &name)).collect()
            };
            for table in tables {
                if self.bytes[table.definition + 9] != 0 {
                    let at = table.definition + 10;
                    self.seal(at, at + 8, table.widths, &mut known);
                }
            }
            self.seal(slot + tree, slot + tree + 8, NAMES, &mut known);
        }
        let sum = checksum(&self.bytes[slot..slot + 112]);
        self.put(slot + 112, &sum.to_le_bytes());
        self
    }

    fn seal(
        &mut self,
        number_at: usize,
        sum_at: usize,
        widths: Widths,
        known: &mut HashMap<usize, u128>,
    ) {
        let page = self.page(number_at);
        let Some(sum) = known.get(&page.start).copied().or_else(|| {
            let kind = *self.bytes.get(page.start)?;
            // Not again on the way down to itself.
            known.insert(page.start, 0);
            if kind == 2 {
                let count = usize::from(self.bytes[page.start + 2]) + 1;
                for child in 0..count {
                    let sums = page.start + 8;
                    self.seal(
                        sums + 16 * count + 8 * child,
                        sums + 16 * child,
                        widths,
                        known,
                    );
                }
            }
            let bytes = self.bytes.get(page.clone())?;
            let (_, covered) = Node::covered(bytes, widths).ok()?;
            let sum = checksum(covered);
            known.insert(page.start, sum);
            Some(sum)
        }) else {
            return;
        };
        self.put(sum_at, &sum.to_le_bytes());
    }

    pub(crate) fn put(&mut self, at: usize, bytes: &[u8]) -> &mut Self {
        self.bytes[at..at + bytes.len()].copy_from_slice(bytes);
        self
    }
}
