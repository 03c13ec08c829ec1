//! The header: what the store trusts before it reads a page, and which commit it takes.

use std::io::{Read, Seek};

use super::pages::{PageNumber, Pages, REGION_PAGES};
use super::{Fault, NO_SAVE, checksum, u32_at, u64_at, u128_at};

const MAGIC: [u8; 9] = *b"redb\x1a\x0a\xa9\x0d\x0a";
const SLOTS: [usize; 2] = [64, 192];
const SLOT_BYTES: usize = 128;
const SLOT_SUM: usize = 112;
const FORMAT: u8 = 3;
/// No file has seen as many transactions; the store counts on from what is stored.
const MAX_TRANSACTION: u64 = 1 << 48;

/// Root of a tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Root {
    pub(crate) page: PageNumber,
    pub(crate) checksum: u128,
    /// How many entries the tree says it has.
    pub(crate) length: u64,
}

impl Root {
    /// Decodes a root at `at`.
    pub(crate) fn at(bytes: &[u8], at: usize) -> Option<Self> {
        Some(Self {
            page: PageNumber::from_bits(u64_at(bytes, at)?),
            checksum: u128_at(bytes, at + 8)?,
            length: u64_at(bytes, at + 24)?,
        })
    }
}

/// One of the two last commits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slot {
    pub(crate) user: Option<Root>,
    pub(crate) system: Option<Root>,
    pub(crate) transaction: u64,
    whole: bool,
}

/// The header of a file.
#[derive(Debug)]
pub(crate) struct Header {
    /// Whether the last process that had it open has closed it, and nobody changed its length since.
    pub(crate) closed: bool,
    /// Whether the commit in force was written in two phases: then nothing but it counts.
    pub(crate) two_phases: bool,
    /// The slot that the god byte names, and the other.
    slots: [Slot; 2],
}

impl Header {
    /// Reads and checks the header.
    pub(crate) fn read<R: Read + Seek>(pages: &mut Pages<R>) -> Result<Self, Fault> {
        let bytes = pages.header()?;
        let number = |at| u32_at(&bytes, at).map_or(0, u64::from);
        if bytes[..9] != MAGIC {
            return Err(Fault::Wrong(NO_SAVE));
        }
        // Every store of this game has these; they are fixed when it is made.
        if (number(12), number(16), number(20)) != (4096, 0, REGION_PAGES) {
            return Err(Fault::Wrong("its header is damaged"));
        }
        let primary = (bytes[9] & 1) as usize;
        let unfinished = bytes[9] & 2 != 0;
        // A crash may tear these two, and they are counted anew then.
        let (full, last) = (number(24), number(28));
        let stored = full * REGION_PAGES + last;
        if !unfinished && (last > REGION_PAGES || stored == 0 || stored > pages.extent.count) {
            return Err(Fault::Wrong(NO_SAVE));
        }
        let slots = [
            slot(&bytes[SLOTS[primary]..][..SLOT_BYTES])?,
            slot(&bytes[SLOTS[1 - primary]..][..SLOT_BYTES])?,
        ];
        let header = Self {
            closed: !unfinished && stored == pages.extent.count,
            two_phases: bytes[9] & 4 != 0,
            slots,
        };
        // Closing is a commit of its own: the newest is in force then, or the byte is damaged.
        if header.closed && header.second_is_newer() {
            return Err(Fault::Wrong("its header is damaged"));
        }
        Ok(header)
    }

    fn second_is_newer(&self) -> bool {
        let [first, second] = &self.slots;
        second.whole && second.transaction > first.transaction
    }

    /// The commit that the store will take, and the one it falls back on if a page of the
    /// first was not written in time.
    pub(crate) fn chosen(&self) -> Result<(Slot, Option<Slot>), Fault> {
        let [first, second] = self.slots;
        let fallback = |slot: Slot| Some(slot).filter(|slot| slot.whole);
        match (first.whole, second.whole) {
            _ if self.two_phases && first.whole => Ok((first, None)),
            (false, true) if !self.two_phases => Ok((second, None)),
            (false, _) => Err(Fault::Wrong("neither of its last commits is whole")),
            (true, _) if self.second_is_newer() => Ok((second, fallback(first))),
            (true, _) => Ok((first, fallback(second))),
        }
    }
}

fn slot(bytes: &[u8]) -> Result<Slot, Fault> {
    let damaged = Fault::Wrong("its header is damaged");
    if bytes[0] != FORMAT {
        return Err(damaged);
    }
    let read = || {
        let root = |there: u8, at| {
            let root = Root::at(bytes, at)?;
            Some((there != 0).then_some(root))
        };
        Some(Slot {
            user: root(bytes[1], 8)?,
            system: root(bytes[2], 40)?,
            transaction: u64_at(bytes, 104)?,
            whole: u128_at(bytes, SLOT_SUM)? == checksum(&bytes[..SLOT_SUM]),
        })
    };
    match read() {
        Some(slot) if slot.whole && slot.transaction > MAX_TRANSACTION => Err(damaged),
        Some(slot) => Ok(slot),
        None => Err(damaged),
    }
}
