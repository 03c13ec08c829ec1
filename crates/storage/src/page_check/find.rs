//! Values by their keys, through as few pages as lead to them.

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
    /// How many chunks it says are stored, those of charts that only a later game knows among them.
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
    let [values_root, chunks, named] = tables(pages, slot.user, ["values", "chunks", "land"])?;
    let meta = match values_root {
        Some(root) => {
            let [meta] = find(pages, root, values, [META_KEY.as_bytes()])?;
            meta
        }
        None => None,
    };
    let lengths = [chunks, named].map(|root| root.map_or(0, |root| root.length));
    Ok(Some(Look {
        meta,
        chunks: lengths[0].saturating_add(lengths[1]),
    }))
}

/// The tables of these names.
fn tables<R: Read + Seek, const N: usize>(
    pages: &mut Pages<R>,
    names: Option<Root>,
    wanted: [&str; N],
) -> Result<[Option<Root>; N], Fault> {
    let mut found = [None; N];
    if let Some(names) = names {
        let definitions = find(pages, names, NAMES, wanted.map(str::as_bytes))?;
        for (root, bytes) in found.iter_mut().zip(definitions) {
            *root = match bytes {
                Some(bytes) => Table::of(&bytes)?.root,
                None => None,
            };
        }
    }
    Ok(found)
}

/// The values under these keys in a tree of text. A page that leads to several is read once.
fn find<R: Read + Seek, const N: usize>(
    pages: &mut Pages<R>,
    root: Root,
    shape: Shape,
    keys: [&[u8]; N],
) -> Result<[Option<Vec<u8>>; N], Fault> {
    let mut found = [const { None }; N];
    let mut under: Vec<(usize, Root)> = (0..N).map(|n| (n, root)).collect();
    let mut bytes = Vec::new();
    for _ in 0..MAX_DEPTH {
        let mut read = None;
        let mut below = Vec::new();
        for (n, at) in under {
            if read != Some(at.page) {
                pages.read(at.page, &mut bytes)?;
                read = Some(at.page);
            }
            match step(&bytes, at, shape, keys[n])? {
                Step::Ends(value) => found[n] = value,
                Step::Leads(child) => below.push((n, child)),
            }
        }
        if below.is_empty() {
            return Ok(found);
        }
        under = below;
    }
    Err(Fault::Wrong("its index is deeper than any can be"))
}

/// Where a page leads who looks for a key.
enum Step {
    /// Nowhere: it holds the value, or none is there.
    Ends(Option<Vec<u8>>),
    /// To another page.
    Leads(Root),
}

fn step(bytes: &[u8], at: Root, shape: Shape, key: &[u8]) -> Result<Step, Fault> {
    let (node, whole) = Node::of(bytes, shape.widths, at.checksum)?;
    let is_record = shape.sealed && matches!(node, Node::Leaf(_));
    if !whole && !is_record {
        return Err(Fault::Torn("a page of its index is not as it was written"));
    }
    match node {
        Node::Leaf(leaf) => {
            for entry in leaf.entries() {
                let (found, value) = entry?;
                if found == key {
                    return Ok(Step::Ends(Some(value.to_vec())));
                }
            }
            Ok(Step::Ends(None))
        }
        Node::Branch(branch) => {
            let mut child = 0;
            while child < branch.count
                && KeyOrder::Text.compare(branch.key(child)?, key) == Ordering::Less
            {
                child += 1;
            }
            Ok(Step::Leads(branch.child(child)?))
        }
    }
}
