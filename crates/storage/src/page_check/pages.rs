//! Pages of a file by their numbers.

use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;

use super::{Fault, NO_SAVE};

/// Bytes of a page of order 0.
pub(crate) const PAGE_BYTES: u64 = 4096;
/// Pages of a full region.
pub(crate) const REGION_PAGES: u64 = 1 << 20;
/// The largest order a page number may have: a whole region.
pub(crate) const MAX_ORDER: u8 = 20;
/// The largest order of a page that is read: 2 MiB, enough for the longest record, which
/// has a leaf to itself. A page is in memory as a whole, so this bounds that.
const MAX_READ_ORDER: u8 = 9;
/// No world is near this long; the set of its pages is kept in memory.
pub(crate) const MAX_FILE_BYTES: u64 = 1 << 36;

/// Where a page is and how long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct PageNumber {
    pub(crate) region: u64,
    /// In units of the page's own size.
    pub(crate) index: u64,
    pub(crate) order: u8,
}

impl PageNumber {
    /// Decodes a stored page number; the bits between are reserved and ignored.
    pub(crate) fn from_bits(bits: u64) -> Self {
        let order = (bits >> 59) as u8;
        Self {
            region: (bits >> 20) & 0xf_ffff,
            index: bits & (0xf_ffff >> order),
            order,
        }
    }
}

/// How many pages a file has, and so which there can be.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    /// Pages of order 0 in the file, without the header.
    pub(crate) count: u64,
}

impl Extent {
    /// How many regions there are.
    pub(crate) fn regions(self) -> u64 {
        self.count.div_ceil(REGION_PAGES)
    }

    /// How many pages a region has.
    pub(crate) fn region_pages(self, region: u64) -> u64 {
        (self.count - (region * REGION_PAGES).min(self.count)).min(REGION_PAGES)
    }

    /// The pages of order 0 that a page consists of, counted from the first of the file.
    pub(crate) fn place(self, page: PageNumber) -> Result<Range<u64>, Fault> {
        if page.order > MAX_ORDER {
            return Err(Fault::Wrong("a page in it is longer than any can be"));
        }
        let start = page.index << page.order;
        let end = start + (1 << page.order);
        if end > self.region_pages(page.region) {
            return Err(Fault::Wrong("it leads to a page behind its end"));
        }
        let region = page.region * REGION_PAGES;
        Ok(region + start..region + end)
    }
}

/// The pages of a file.
pub(crate) struct Pages<R> {
    source: R,
    pub(crate) extent: Extent,
}

impl<R: Read + Seek> Pages<R> {
    /// Looks at how long `source` is.
    pub(crate) fn new(mut source: R) -> Result<Self, Fault> {
        let bytes = source.seek(SeekFrom::End(0))?;
        if bytes < 2 * PAGE_BYTES || !bytes.is_multiple_of(PAGE_BYTES) {
            return Err(Fault::Wrong(NO_SAVE));
        }
        if bytes > MAX_FILE_BYTES {
            return Err(Fault::Wrong("no world is as long"));
        }
        let count = bytes / PAGE_BYTES - 1;
        let extent = Extent { count };
        Ok(Self { source, extent })
    }

    /// The bytes before the first page.
    pub(crate) fn header(&mut self) -> Result<[u8; 320], Fault> {
        let mut header = [0; 320];
        self.source.seek(SeekFrom::Start(0))?;
        self.source.read_exact(&mut header)?;
        Ok(header)
    }

    /// Reads a page into `bytes`, in the place of what was there.
    pub(crate) fn read(&mut self, page: PageNumber, bytes: &mut Vec<u8>) -> Result<(), Fault> {
        let place = self.extent.place(page)?;
        if page.order > MAX_READ_ORDER {
            return Err(Fault::Wrong("a page in it is longer than any of a world"));
        }
        bytes.resize(((place.end - place.start) * PAGE_BYTES) as usize, 0);
        let start = (1 + place.start) * PAGE_BYTES;
        self.source.seek(SeekFrom::Start(start))?;
        self.source.read_exact(bytes)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;
    use std::io::Cursor;

    #[test]
    fn page_numbers_are_places_in_the_file() {
        let pages = Pages::new(Cursor::new(vec![0; 11 * 4096])).unwrap();
        let place = |bits: u64| pages.extent.place(PageNumber::from_bits(bits)).ok();
        assert_eq!(place(0), Some(0..1));
        assert_eq!(place(9), Some(9..10));
        assert_eq!(place(10), None);
        assert_eq!(place(2 << 59 | 1), Some(4..8));
        assert_eq!(place(2 << 59 | 2), None);
        assert_eq!(place(3 << 59), Some(0..8));
        // Another region, an order of gigabytes, and one that no page can have.
        assert_eq!(place(1 << 20), None);
        for order in [4, 20, 21, 31] {
            assert_eq!(place(order << 59), None, "{order}");
        }
        // Reserved bits do not count.
        assert_eq!(place(0x7ff << 40 | 7), Some(7..8));
    }

    #[test]
    fn files_of_a_length_that_none_has_are_refused() {
        for length in [0, 4096, 8191, 8193] {
            assert!(Pages::new(Cursor::new(vec![0; length])).is_err());
        }
        assert!(Pages::new(Cursor::new(vec![0; 8192])).is_ok());
    }
}
