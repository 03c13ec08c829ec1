//! One page of a tree: a leaf of entries or a branch of children, its every offset checked.

use super::header::Root;
use super::pages::PageNumber;
use super::{Fault, checksum, u16_at, u32_at, u64_at, u128_at};

/// The longest key: those of chunks and things have at most 157 bytes, and names of tables fewer.
const MAX_KEY_BYTES: usize = 255;

/// How wide the keys and values of a table are, where all are alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Widths {
    pub(crate) key: Option<usize>,
    pub(crate) value: Option<usize>,
}

/// A page of a tree.
pub(crate) enum Node<'a> {
    Leaf(Leaf<'a>),
    Branch(Branch<'a>),
}

impl<'a> Node<'a> {
    /// Takes a page for what it says it is, and compares its checksum; false if that is
    /// another than `expected`.
    pub(crate) fn of(
        bytes: &'a [u8],
        widths: Widths,
        expected: u128,
    ) -> Result<(Self, bool), Fault> {
        let (node, covered) = Self::covered(bytes, widths)?;
        Ok((node, checksum(covered) == expected))
    }

    /// A page, and the bytes that its checksum covers. Where those end is in them; so a torn
    /// page may have no checksum at all.
    pub(crate) fn covered(bytes: &'a [u8], widths: Widths) -> Result<(Self, &'a [u8]), Fault> {
        let count = usize::from(u16_at(bytes, 2).unwrap_or(0));
        let (node, end) = match bytes.first() {
            Some(1) => {
                let leaf = Leaf::new(bytes, count, widths);
                (Self::Leaf(leaf), leaf.end())
            }
            Some(2) => {
                let branch = Branch::new(bytes, count, widths.key);
                (Self::Branch(branch), branch.end())
            }
            _ => return Err(Fault::Torn("a page of its index is of no kind")),
        };
        let covered = end.and_then(|end| bytes.get(..end)).filter(|_| count > 0);
        let covered = covered.ok_or(Fault::Torn("a page of its index has no end"))?;
        Ok((node, covered))
    }
}

/// Ends of keys or values, from a list of them or from their common width.
#[derive(Debug, Clone, Copy)]
struct Ends {
    /// Where the first begins.
    start: usize,
    /// Their common width, or where the list of ends is.
    width: Result<usize, usize>,
}

impl Ends {
    fn end(self, bytes: &[u8], index: usize) -> Option<usize> {
        match self.width {
            Ok(width) => width.checked_mul(index + 1)?.checked_add(self.start),
            Err(list) => u32_at(bytes, list + 4 * index).map(|end| end as usize),
        }
    }

    fn get(self, bytes: &[u8], index: usize) -> Option<&[u8]> {
        let start = match index.checked_sub(1) {
            Some(before) => self.end(bytes, before)?,
            None => self.start,
        };
        bytes.get(start..self.end(bytes, index)?)
    }
}

/// A leaf.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leaf<'a> {
    bytes: &'a [u8],
    pub(crate) count: usize,
    keys: Ends,
    value_width: Result<usize, usize>,
}

impl<'a> Leaf<'a> {
    fn new(bytes: &'a [u8], count: usize, widths: Widths) -> Self {
        let mut start = 4;
        let mut list = |width: Option<usize>| {
            width.ok_or_else(|| {
                let list = start;
                start += 4 * count;
                list
            })
        };
        let (key_width, value_width) = (list(widths.key), list(widths.value));
        Self {
            bytes,
            count,
            keys: Ends {
                start,
                width: key_width,
            },
            value_width,
        }
    }

    fn values(&self) -> Option<Ends> {
        Some(Ends {
            start: self.keys.end(self.bytes, self.count.checked_sub(1)?)?,
            width: self.value_width,
        })
    }

    fn end(&self) -> Option<usize> {
        self.values()?.end(self.bytes, self.count.checked_sub(1)?)
    }

    /// Its entries; [`Fault::Wrong`] for the first whose offsets contradict the others.
    pub(crate) fn entries(&self) -> impl Iterator<Item = Result<(&'a [u8], &'a [u8]), Fault>> {
        let (leaf, values) = (*self, self.values());
        (0..self.count).map(move |index| {
            let entry = || {
                let key = leaf.keys.get(leaf.bytes, index)?;
                Some((key, values?.get(leaf.bytes, index)?))
            };
            let entry = entry().filter(|(key, _)| key.len() <= MAX_KEY_BYTES);
            entry.ok_or(Fault::Wrong(
                "an entry of its index lies outside of its page",
            ))
        })
    }
}

/// A branch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Branch<'a> {
    bytes: &'a [u8],
    /// How many keys; there is one child more.
    pub(crate) count: usize,
    keys: Ends,
}

impl<'a> Branch<'a> {
    /// A page that [`Node::of`] took for a branch before.
    pub(crate) fn of(bytes: &'a [u8], widths: Widths) -> Self {
        let count = usize::from(u16_at(bytes, 2).unwrap_or(0));
        Self::new(bytes, count, widths.key)
    }

    fn new(bytes: &'a [u8], count: usize, key_width: Option<usize>) -> Self {
        let list = 8 + 24 * (count + 1);
        let keys = match key_width {
            Some(width) => Ends {
                start: list,
                width: Ok(width),
            },
            None => Ends {
                start: list + 4 * count,
                width: Err(list),
            },
        };
        Self { bytes, count, keys }
    }

    fn end(&self) -> Option<usize> {
        self.keys.end(self.bytes, self.count.checked_sub(1)?)
    }

    /// The key between a child and the next.
    pub(crate) fn key(&self, index: usize) -> Result<&'a [u8], Fault> {
        let key = self.keys.get(self.bytes, index);
        key.filter(|key| key.len() <= MAX_KEY_BYTES)
            .ok_or(Fault::Wrong("a key of its index lies outside of its page"))
    }

    /// A child, of unknown length.
    pub(crate) fn child(&self, index: usize) -> Result<Root, Fault> {
        let child = || {
            let page = 8 + 16 * (self.count + 1) + 8 * index;
            Some(Root {
                page: PageNumber::from_bits(u64_at(self.bytes, page)?),
                checksum: u128_at(self.bytes, 8 + 16 * index)?,
                length: 0,
            })
        };
        child().ok_or(Fault::Wrong("a page of its index is too short"))
    }
}
