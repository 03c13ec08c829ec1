//! The order of a table's keys.

use std::cmp::Ordering;

use super::{u32_at, u64_at};

/// The order of the keys of a table, which follows from their type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum KeyOrder {
    /// As bytes, which must be text.
    Text,
    /// As bytes.
    Bytes,
    /// Two numbers of eight bytes: a transaction's, and a count within it.
    Transactions,
    /// A kind, and for one of the kinds a region's number; see [`super::free`].
    Allocator,
    /// Of a type that this game does not have; nothing looks for keys in such a table.
    Unknown,
}

impl KeyOrder {
    /// Compares two keys that [`Self::allows`].
    pub(crate) fn compare(self, a: &[u8], b: &[u8]) -> Ordering {
        match self {
            Self::Text | Self::Bytes => a.cmp(b),
            Self::Transactions => {
                let key = |bytes| (u64_at(bytes, 0), u64_at(bytes, 8));
                key(a).cmp(&key(b))
            }
            Self::Allocator => allocator_rank(a).cmp(&allocator_rank(b)),
            Self::Unknown => Ordering::Less,
        }
    }

    /// Whether the store can take these bytes for a key.
    pub(crate) fn allows(self, key: &[u8]) -> bool {
        match self {
            Self::Text => std::str::from_utf8(key).is_ok(),
            Self::Transactions => key.len() == 16,
            Self::Allocator => key.len() == 5 && key[0] <= 5,
            Self::Bytes | Self::Unknown => true,
        }
    }
}

/// Old kinds, then regions by their number, then the others.
fn allocator_rank(key: &[u8]) -> (u8, u32) {
    match key.first() {
        Some(3) => (3, u32_at(key, 1).unwrap_or(u32::MAX)),
        Some(&kind) if kind > 3 => (kind, 0),
        _ => (0, 0),
    }
}
