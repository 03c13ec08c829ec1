//! A tree's value that says what a table is: where its root is and how wide its entries.
//!
//! | bytes | what |
//! |---|---|
//! | 0 | kind: 3, an ordinary table; this game makes no other |
//! | 1..9 | entries |
//! | 9, 10..42 | whether there is a root, and the root |
//! | 42, 43..47 | whether the keys have one width, and it; 47, 48..52: the values |
//! | 52..56, 56..60 | alignments, 1 |
//! | 60..64 | bytes of the name of the keys' type, which follows; then that of the values' |

use super::header::Root;
use super::node::Widths;
use super::{Fault, u32_at, u64_at};

/// A table's definition.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Table {
    /// Where it begins; `None` if it is empty.
    pub(crate) root: Option<Root>,
    pub(crate) widths: Widths,
    /// Whether its types are called as the store calls those of its lists of pages; with
    /// others it reads, and refuses every commit.
    pub(crate) lists_pages: bool,
}

/// The names of keys and values of the store's lists of pages.
const PAGE_LISTS: (&[u8], &[u8]) = (
    b"\x01redb::TransactionIdWithPagination",
    b"\x01redb::PageList",
);

impl Table {
    /// Decodes a definition.
    pub(crate) fn of(bytes: &[u8]) -> Result<Self, Fault> {
        Self::read(bytes).ok_or(Fault::Wrong("one of its tables makes no sense"))
    }

    fn read(bytes: &[u8]) -> Option<Self> {
        let flag = |at: usize| bytes.get(at).map(|&byte| byte != 0);
        let width = |at: usize| {
            let width = u32_at(bytes, at + 1)?;
            Some(flag(at)?.then_some(width as usize))
        };
        let root = Root::at(bytes, 10)?;
        let key_type_bytes = u32_at(bytes, 60)? as usize;
        let (key_type, value_type) = bytes.get(64..)?.split_at_checked(key_type_bytes)?;
        let table = Self {
            root: flag(9)?.then_some(root),
            widths: Widths {
                key: width(42)?,
                value: width(47)?,
            },
            lists_pages: (key_type, value_type) == PAGE_LISTS,
        };
        let length = table.root.map_or(0, |root| root.length);
        let makes_sense = bytes[0] == 3
            && u64_at(bytes, 1)? == length
            && (u32_at(bytes, 52)?, u32_at(bytes, 56)?) == (1, 1)
            && is_type_name(key_type)
            && is_type_name(value_type);
        makes_sense.then_some(table)
    }
}

/// A type is named by a byte for its class and its name.
fn is_type_name(bytes: &[u8]) -> bool {
    let name = bytes.split_first();
    name.is_some_and(|(class, name)| (1..=4).contains(class) && std::str::from_utf8(name).is_ok())
}
