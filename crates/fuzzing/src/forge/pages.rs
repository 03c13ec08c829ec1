//! The pages of a redb store of format 3: what stands where in them, and giving every
//! page the checksum that its parent keeps of it.
//!
//! Written from redb's `docs/design.md`; the game's own check of pages is another piece
//! of code on purpose.

use std::collections::HashMap;
use std::ops::Range;

use twox_hash::XxHash3_128;

const PAGE: usize = 4096;
/// The two commit slots, of which a bit of the tenth byte says which holds.
const SLOTS: [usize; 2] = [64, 192];
const SLOT_SUM: usize = 112;
/// In a slot: whether there is a tree, and its root; the tables of the user, the store's own.
const ROOTS: [(usize, usize); 2] = [(1, 8), (2, 40)];
const LEAF: u8 = 1;
const BRANCH: u8 = 2;
const SUM: usize = 16;
const POINTER: usize = 8;
/// No sound index is deeper.
const DEEPEST: usize = 24;

/// What a part of a store is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The first 64 bytes.
    Header,
    /// A commit slot.
    Slot,
    /// What kind a page is and how many entries it has, reserved bytes included.
    Count,
    /// The number of a child page.
    Pointer,
    /// Where a key or a value ends.
    Offset,
    /// A key of a branch or a leaf.
    Key,
    /// The definition of a table.
    Table,
    /// The header of a record.
    RecordHead,
    /// The rest of a record.
    RecordBody,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Header,
        Self::Slot,
        Self::Count,
        Self::Pointer,
        Self::Offset,
        Self::Key,
        Self::Table,
        Self::RecordHead,
        Self::RecordBody,
    ];
}

/// Widths of keys and values, where they have one.
type Widths = (Option<usize>, Option<usize>);

fn word<const N: usize>(bytes: &[u8], at: usize) -> Option<[u8; N]> {
    bytes.get(at..at.checked_add(N)?)?.first_chunk().copied()
}

fn number(bytes: &[u8], at: usize) -> Option<usize> {
    Some(u32::from_le_bytes(word(bytes, at)?) as usize)
}

/// Where the page that a pointer at `at` names is, if it is inside of the file.
fn page_at(bytes: &[u8], at: usize) -> Option<Range<usize>> {
    let pointer = u64::from_le_bytes(word(bytes, at)?);
    let order = (pointer >> 59) as u32;
    let index = (pointer & (0xf_ffff >> order)) as usize;
    let region = (pointer >> 20 & 0xf_ffff) as usize;
    let header_pages = number(bytes, 16)?;
    let most_pages = number(bytes, 20)?;
    let length = PAGE
        .checked_shl(order)
        .filter(|length| *length <= bytes.len())?;
    let region_bytes = header_pages.checked_add(most_pages)?.checked_mul(PAGE)?;
    let start = PAGE
        .checked_add(region.checked_mul(region_bytes)?)?
        .checked_add(header_pages.checked_mul(PAGE)?)?
        .checked_add(index.checked_mul(length)?)?;
    (start.checked_add(length)? <= bytes.len()).then(|| start..start + length)
}

/// Where things stand in a page, relative to the file.
struct Layout {
    branch: bool,
    pointers: Vec<usize>,
    sums: Vec<usize>,
    offsets: Range<usize>,
    keys: Vec<Range<usize>>,
    values: Vec<Range<usize>>,
    /// How far the checksum goes.
    end: usize,
}

fn layout(bytes: &[u8], page: &Range<usize>, widths: Widths) -> Option<Layout> {
    let count = usize::from(u16::from_le_bytes(word(bytes, page.start + 2)?));
    let branch = match *bytes.get(page.start)? {
        LEAF => false,
        BRANCH => true,
        _ => return None,
    };
    if count == 0 {
        return None;
    }
    let at = |relative: usize| {
        page.start
            .checked_add(relative)
            .filter(|at| *at <= page.end)
    };
    let children = if branch { count + 1 } else { 0 };
    let table = if branch {
        8 + (SUM + POINTER) * children
    } else {
        4
    };
    let tables = [widths.0, if branch { Some(0) } else { widths.1 }];
    let lengths = tables.map(|width| if width.is_none() { 4 * count } else { 0 });
    let mut from = table + lengths[0] + lengths[1];
    at(from)?;
    let mut pieces = [Vec::new(), Vec::new()];
    for (kind, pieces) in pieces
        .iter_mut()
        .enumerate()
        .take(if branch { 1 } else { 2 })
    {
        for n in 0..count {
            let to = match tables[kind] {
                Some(width) => from.checked_add(width)?,
                None => number(bytes, page.start + table + lengths[0] * kind + 4 * n)?,
            };
            at(to)?;
            if to < from {
                return None;
            }
            pieces.push(page.start + from..page.start + to);
            from = to;
        }
    }
    let [keys, values] = pieces;
    Some(Layout {
        branch,
        sums: (0..children).map(|n| page.start + 8 + SUM * n).collect(),
        pointers: (0..children)
            .map(|n| page.start + 8 + SUM * children + POINTER * n)
            .collect(),
        offsets: at(table)?..at(table + lengths[0] + lengths[1])?,
        keys,
        values,
        end: page.start + from,
    })
}

/// In a table's definition: where its root is, and the widths of its entries.
fn table_root(bytes: &[u8], value: &Range<usize>) -> Option<(usize, Widths)> {
    let (kind, there) = (*bytes.get(value.start)?, *bytes.get(value.start + 9)?);
    if value.len() < 52 || kind != 3 || there == 0 {
        return None;
    }
    let width = |at: usize| match bytes[at] {
        0 => Some(None),
        _ => number(bytes, at + 1).map(Some),
    };
    Some((
        value.start + 10,
        (width(value.start + 42)?, width(value.start + 47)?),
    ))
}

/// Walks the trees of the slot that holds, children before parents.
struct Walk<'a> {
    bytes: &'a mut [u8],
    /// Checksums of pages that were walked; `None` while one is, or where it has none.
    done: HashMap<usize, Option<u128>>,
    /// Whether every page was found and had the checksum that its parent keeps.
    sound: bool,
}

impl Walk<'_> {
    /// Walks a tree and puts the checksum of its root behind the pointer at `root`.
    fn tree(&mut self, root: usize, widths: Widths, master: bool, depth: usize) {
        let sum = self.page(root, widths, master, depth);
        self.keep(root + POINTER, sum);
    }

    fn keep(&mut self, at: usize, sum: Option<u128>) {
        let place = self.bytes.get_mut(at..at + SUM);
        match (sum, place) {
            (Some(sum), Some(place)) => {
                self.sound &= *place == sum.to_le_bytes();
                place.copy_from_slice(&sum.to_le_bytes());
            }
            _ => self.sound = false,
        }
    }

    fn page(&mut self, pointer: usize, widths: Widths, master: bool, depth: usize) -> Option<u128> {
        let page = page_at(self.bytes, pointer)?;
        if let Some(sum) = self.done.get(&page.start) {
            return *sum;
        }
        self.done.insert(page.start, None);
        let layout = layout(self.bytes, &page, widths).filter(|_| depth < DEEPEST)?;
        if layout.branch {
            for (pointer, sum) in layout.pointers.iter().zip(&layout.sums) {
                let child = self.page(*pointer, widths, master, depth + 1);
                self.keep(*sum, child);
            }
        } else if master {
            for value in &layout.values {
                if let Some((root, widths)) = table_root(self.bytes, value) {
                    self.tree(root, widths, false, depth + 1);
                }
            }
        }
        let sum = XxHash3_128::oneshot(&self.bytes[page.start..layout.end]);
        self.done.insert(page.start, Some(sum));
        Some(sum)
    }
}

/// Gives every page of the commit that holds, and both slots, their checksums; whether
/// all of them were right before.
pub fn seal(bytes: &mut [u8]) -> bool {
    if bytes.len() < PAGE {
        return false;
    }
    let slot = SLOTS[usize::from(bytes[9] & 1)];
    let mut walk = Walk {
        bytes,
        done: HashMap::new(),
        sound: true,
    };
    for (there, root) in ROOTS {
        if walk.bytes[slot + there] != 0 {
            walk.tree(slot + root, (None, None), true, 0);
        }
    }
    let mut sound = walk.sound;
    for slot in SLOTS {
        let sum = XxHash3_128::oneshot(&bytes[slot..slot + SLOT_SUM]).to_le_bytes();
        let place = &mut bytes[slot + SLOT_SUM..slot + SLOT_SUM + SUM];
        sound &= *place == sum;
        place.copy_from_slice(&sum);
    }
    sound
}

/// Whether every page and both slots have their checksums.
pub fn is_sealed(bytes: &[u8]) -> bool {
    seal(&mut bytes.to_vec())
}

/// Where the fields of a store's index stand, by what they are. Records are
/// [`super::record`]'s.
pub fn fields(bytes: &[u8]) -> Vec<(Part, Range<usize>)> {
    let mut found = vec![(Part::Header, 0..64)];
    found.extend(SLOTS.map(|slot| (Part::Slot, slot..slot + SLOT_SUM)));
    let slot = SLOTS[usize::from(bytes[9] & 1)];
    let mut todo: Vec<(usize, Widths, bool)> = Vec::new();
    for (there, root) in ROOTS {
        if bytes[slot + there] != 0 {
            todo.push((slot + root, (None, None), true));
        }
    }
    while let Some((pointer, widths, master)) = todo.pop() {
        found.push((Part::Pointer, pointer..pointer + POINTER));
        let Some(page) = page_at(bytes, pointer) else {
            continue;
        };
        let Some(layout) = layout(bytes, &page, widths) else {
            continue;
        };
        found.push((
            Part::Count,
            page.start..page.start + if layout.branch { 8 } else { 4 },
        ));
        found.push((Part::Offset, layout.offsets));
        found.extend(layout.keys.into_iter().map(|range| (Part::Key, range)));
        todo.extend(
            layout
                .pointers
                .into_iter()
                .map(|pointer| (pointer, widths, master)),
        );
        if master {
            for value in layout.values {
                todo.extend(table_root(bytes, &value).map(|(root, widths)| (root, widths, false)));
                found.push((Part::Table, value));
            }
        }
    }
    found.retain(|(_, range)| !range.is_empty());
    found
}
