//! The space that the store believes to be free. It reads this when it opens, and hands it out as pages.
//!
//! The table `allocator_state` has a key of five bytes: a kind, and a number. Kind 3 is a
//! region by its number, 4 which regions have room, 5 the transaction that wrote it.
//!
//! | bytes of a region | what |
//! |---|---|
//! | 0 | the largest order, 20 |
//! | 4..8 | pages |
//! | 8..92 | ends of the bitmaps of orders 0 to 20, u32 |
//! | 92.. | the bitmaps: bit set where no page of that order is free |
//!
//! What says which regions have room is the number of orders, u32, the lengths of their
//! bitmaps, u32 each, and those bitmaps, with a bit for each region.
//!
//! A bitmap is a tree of 64 branches: its height, u32; ends of the levels, u32 each; then
//! the levels, topmost first, each its number of bits, u32, and words of u64. A bit above
//! is set where its whole word below is. The store follows clear bits without looking, so
//! none may lead to a word without one, or behind the last bit.

use std::ops::Range;

use super::claims::Claims;
use super::pages::{MAX_FILE_BYTES, MAX_ORDER, PAGE_BYTES, REGION_PAGES};
use super::{Fault, u32_at, u64_at};

/// Bytes before the bitmaps of a region.
const REGION_HEADER_BYTES: usize = 8 + 4 * (MAX_ORDER as usize + 1);
/// The most regions that the longest file has.
const MOST_REGIONS: usize = MAX_FILE_BYTES.div_ceil(REGION_PAGES * PAGE_BYTES) as usize;
/// No value is near this long: the bitmaps of a full region take half of it. They are kept
/// until all are there, in the game's own process.
const MOST_VALUE_BYTES: usize = 512 << 10;
/// How many regions a store has room for from the beginning.
const LEAST_REGIONS: u32 = 1000;

/// What the store wrote of its free space when it closed.
#[derive(Default)]
pub(crate) struct FreeSpace {
    /// The transaction that wrote it.
    pub(crate) transaction: Option<u64>,
    regions: Vec<Vec<u8>>,
    room: Option<Vec<u8>>,
}

impl FreeSpace {
    /// Takes an entry of the table, in order of the keys.
    pub(crate) fn take(&mut self, key: &[u8], value: &[u8]) -> Result<(), Fault> {
        if value.len() > MOST_VALUE_BYTES {
            return Err(wrong());
        }
        match key.first() {
            Some(3) if u32_at(key, 1) == u32::try_from(self.regions.len()).ok() => {
                if self.regions.len() >= MOST_REGIONS {
                    return Err(wrong());
                }
                self.regions.push(value.to_vec());
            }
            Some(4) => self.room = Some(value.to_vec()),
            Some(5) if value.len() == 8 => self.transaction = u64_at(value, 0),
            Some(3 | 5) => return Err(wrong()),
            // Kinds of older versions of the store, which it does not read any more.
            _ => {}
        }
        Ok(())
    }

    /// Claims every page that it says is free; `pages` are those of each region now.
    ///
    /// The file may have another length than it had then, if a process was killed while it
    /// grew or shrank: pages that came are free, and pages that went must have been.
    pub(crate) fn claim(&self, pages: &[u64], claims: &mut Claims) -> Result<(), Fault> {
        self.check_room()?;
        let (regions, last) = (self.regions.len(), pages.len().saturating_sub(1));
        for (index, &now) in pages.iter().enumerate() {
            let start = index as u64 * REGION_PAGES;
            let mut then = 0;
            if let Some(bytes) = self.regions.get(index) {
                let region = Region::of(bytes).ok_or_else(wrong)?;
                region.claim(start, now, claims)?;
                then = region.pages;
            }
            // The store brings the last region to its length, and if some came all.
            let grown =
                then < now && (regions < pages.len() || index == last && regions == pages.len());
            let shrunk = then > now && index == last && regions >= pages.len();
            if then != now && !grown && !shrunk {
                return Err(wrong());
            }
            if !claims.claim(start + then.min(now)..start + now) {
                return Err(wrong());
            }
        }
        for gone in self.regions.iter().skip(pages.len()) {
            Region::of(gone).ok_or_else(wrong)?;
        }
        if self.regions.is_empty() {
            Err(wrong())
        } else {
            Ok(())
        }
    }

    /// Looks at the list of regions with room.
    fn check_room(&self) -> Result<(), Fault> {
        let check = || {
            let bytes = self.room.as_deref()?;
            let orders = usize::from(MAX_ORDER) + 1;
            if u32_at(bytes, 0)? as usize != orders {
                return None;
            }
            let mut start = 4 + 4 * orders;
            for order in 0..orders {
                let end = start.checked_add(u32_at(bytes, 4 + 4 * order)? as usize)?;
                let bitmap = Bitmap::of(bytes.get(start..end)?, REGION_PAGES)?;
                let clear = bitmap.clear();
                let beyond = clear.filter(|&region| region >= self.regions.len() as u64);
                if bitmap.bits < LEAST_REGIONS || beyond.count() > 0 {
                    return None;
                }
                start = end;
            }
            Some(())
        };
        check().ok_or_else(wrong)
    }
}

fn wrong() -> Fault {
    Fault::Wrong("its list of free pages makes no sense")
}

/// What was free in a region.
struct Region<'a> {
    pages: u64,
    orders: Vec<Bitmap<'a>>,
}

impl<'a> Region<'a> {
    fn of(bytes: &'a [u8]) -> Option<Self> {
        let pages = u32_at(bytes, 4)?;
        if *bytes.first()? != MAX_ORDER || pages == 0 || u64::from(pages) > REGION_PAGES {
            return None;
        }
        let mut orders = Vec::new();
        let mut start = REGION_HEADER_BYTES;
        for order in 0..=MAX_ORDER {
            let end = u32_at(bytes, 8 + 4 * usize::from(order))? as usize;
            let bitmap = Bitmap::of(bytes.get(start..end)?, REGION_PAGES >> order)?;
            if bitmap.bits != pages >> order {
                return None;
            }
            orders.push(bitmap);
            start = end;
        }
        let pages = u64::from(pages);
        Some(Self { pages, orders })
    }

    /// Claims what is free before page `now`; behind it everything must be.
    fn claim(&self, start: u64, now: u64, claims: &mut Claims) -> Result<(), Fault> {
        let gone = self.pages.saturating_sub(now);
        let mut behind = Claims::new(gone);
        let mut free_behind = 0;
        for (order, bitmap) in self.orders.iter().enumerate() {
            for block in bitmap.clear() {
                let (from, to) = (block << order, (block + 1) << order);
                let here: Range<u64> = start + from.min(now)..start + to.min(now);
                let there = from.max(now) - now..to.max(now) - now;
                free_behind += there.end - there.start;
                if !claims.claim(here) || !behind.claim(there) {
                    return Err(Fault::Wrong("a page of it is in use and free at once"));
                }
            }
        }
        if free_behind == gone {
            Ok(())
        } else {
            Err(wrong())
        }
    }
}

/// The lowest level of a bitmap whose levels agree.
struct Bitmap<'a> {
    bits: u32,
    words: &'a [u8],
}

impl<'a> Bitmap<'a> {
    /// Decodes a bitmap as high as one of `most` bits must be.
    fn of(bytes: &'a [u8], most: u64) -> Option<Self> {
        let height = u32_at(bytes, 0)? as usize;
        if height != height_for(most) {
            return None;
        }
        let mut start = 4 + 4 * height;
        let mut above: Option<Bitmap<'_>> = None;
        for level in 0..height {
            let end = u32_at(bytes, 4 + 4 * level)? as usize;
            let level = Self::level(bytes.get(start..end)?)?;
            if let Some(above) = above
                && !above.leads_to(&level)
            {
                return None;
            }
            above = Some(level);
            start = end;
        }
        above.filter(|lowest| u64::from(lowest.bits) <= most)
    }

    fn level(bytes: &'a [u8]) -> Option<Self> {
        let bits = u32_at(bytes, 0)?;
        let words = bytes.get(4..)?;
        let level = Self { bits, words };
        let fits = words.len() as u64 == 8 * u64::from(bits).div_ceil(64);
        (fits && level.clear().all(|bit| bit < u64::from(bits))).then_some(level)
    }

    /// Whether each clear bit stands for a word below that has one, and every word for a bit.
    fn leads_to(&self, below: &Bitmap<'_>) -> bool {
        let words = u64::from(below.bits).div_ceil(64);
        u64::from(self.bits) == words
            && self
                .clear()
                .all(|bit| below.word(bit as usize) != Some(u64::MAX))
    }

    fn word(&self, index: usize) -> Option<u64> {
        u64_at(self.words, 8 * index)
    }

    /// The clear bits of its words, those behind its end too.
    fn clear(&self) -> impl Iterator<Item = u64> {
        let words = self.words.as_chunks::<8>().0.iter().enumerate();
        words.flat_map(|(index, word)| {
            let mut clear = !u64::from_le_bytes(*word);
            std::iter::from_fn(move || {
                let bit = (clear != 0).then(|| u64::from(clear.trailing_zeros()))?;
                clear &= clear - 1;
                Some(64 * index as u64 + bit)
            })
        })
    }
}

/// How many levels a bitmap has that has room for `most` bits.
fn height_for(mut most: u64) -> usize {
    let mut height = 1;
    while most > 64 {
        most = most.div_ceil(64);
        height += 1;
    }
    height
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes so many regions of so many bytes, as far as that goes.
    fn taken(regions: u32, bytes: usize) -> Result<usize, Fault> {
        let mut free = FreeSpace::default();
        for region in 0..regions {
            let [a, b, c, d] = region.to_le_bytes();
            free.take(&[3, a, b, c, d], &vec![0; bytes])?;
        }
        Ok(free.regions.iter().map(Vec::len).sum())
    }

    #[test]
    fn what_no_file_can_have_free_is_not_kept_in_memory() {
        assert!(taken(16, 300_000).is_ok_and(|bytes| bytes == 16 * 300_000));
        assert!(taken(17, 1).is_err(), "more regions than the longest file");
        assert!(taken(1, 600_000).is_err(), "longer than any region");
        let mut free = FreeSpace::default();
        assert!(free.take(&[4, 0, 0, 0, 0], &vec![0; 600_000]).is_err());
    }
}
