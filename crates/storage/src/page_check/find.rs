//! One value by its key, through as few pages as lead to it.

use std::cmp::Ordering;
use std::io::{Read, Seek};

use super::Fault;
use super::header::{Header, Root};
use super::node::Node;
use super::order::KeyOrder;
use super::pages::Pages;
use super::table::Table;
use super::walk::{MAX_DEPTH, Shape};
use super::whole::NAMES;
use crate::store::META_KEY;

/// What the list of worlds tells of a store.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Look {
    /// The sealed record of what the world is.
    pub(crate) meta: Option<Vec<u8>>,
    /// How many chunks it says are stored.
    pub(crate) chunks: u64,
}

/// Reads what the list of worlds tells; `None` if the store was not closed, since it is
/// not yet decided then which commit is in force.
pub(crate) fn look<R: Read + Seek>(pages: &mut Pages<R>) -> Result<Option<Look>, Fault> {
    let header = Header::read(pages)?;
    let (slot, _) = header.chosen()?;
    if !header.closed || !header.two_phases {
        return Ok(None);
    }
    let values = Shape {
        sealed: true,
        ..NAMES
    };
    let meta = match table(pages, slot.user, "values")? {
        Some(root) => find(pages, root, values, META_KEY.as_bytes())?,
        None => None,
    };
    let chunks = table(pages, slot.user, "chunks")?.map_or(0, |root| root.length);
    Ok(Some(Look { meta, chunks }))
}

fn table<R: Read + Seek>(
    pages: &mut Pages<R>,
    names: Option<Root>,
    name: &str,
) -> Result<Option<Root>, Fault> {
    let Some(names) = names else {
        return Ok(None);
    };
    let definition = find(pages, names, NAMES, name.as_bytes())?;
    Ok(match definition {
        Some(bytes) => Table::of(&bytes)?.root,
        None => None,
    })
}

/// The value under `key` in a tree of text.
fn find<R: Read + Seek>(
    pages: &mut Pages<R>,
    root: Root,
    shape: Shape,
    key: &[u8],
) -> Result<Option<Vec<u8>>, Fault> {
    let mut at = root;
    let mut bytes = Vec::new();
    for _ in 0..MAX_DEPTH {
        pages.read(at.page, &mut bytes)?;
        let (node, whole) = Node::of(&bytes, shape.widths, at.checksum)?;
        let is_record = shape.sealed && matches!(node, Node::Leaf(_));
        if !whole && !is_record {
            return Err(Fault::Torn("a page of its index is not as it was written"));
        }
        match node {
            Node::Leaf(leaf) => {
                for entry in leaf.entries() {
                    let (found, value) = entry?;
                    if found == key {
                        return Ok(Some(value.to_vec()));
                    }
                }
                return Ok(None);
            }
            Node::Branch(branch) => {
                let mut child = 0;
                while child < branch.count
                    && KeyOrder::Text.compare(branch.key(child)?, key) == Ordering::Less
                {
                    child += 1;
                }
                at = branch.child(child)?;
            }
        }
    }
    Err(Fault::Wrong("its index is deeper than any can be"))
}
