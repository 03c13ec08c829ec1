//! The walk over every page of a tree.
//!
//! In the order of the keys, with the branches on the way in memory and nothing else.
//! Keys of leaves and those between children make one sequence: it rises, and only where
//! a leaf's last key is followed by the same one in a branch may it stand still. That is
//! all that finding a key takes to lead to where walking finds it.

use std::cmp::Ordering;
use std::io::{Read, Seek};

use super::Fault;
use super::claims::Claims;
use super::header::Root;
use super::node::{Branch, Leaf, Node, Widths};
use super::order::KeyOrder;
use super::pages::Pages;

/// Twice what the largest file needs whose branches have two children each.
pub(crate) const MAX_DEPTH: usize = 48;
/// Branches hold few bytes of keys, so they never outgrow this.
const MAX_BRANCH_BYTES: usize = 1 << 16;

/// What is known of a table before its pages are read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    pub(crate) widths: Widths,
    pub(crate) order: KeyOrder,
    /// Whether each value has a seal of its own, so that a wrong checksum of its leaf is
    /// not yet a reason to refuse it.
    pub(crate) sealed: bool,
}

/// Takes an entry of a table: its key and its value.
pub(crate) type Each<'a> = dyn FnMut(&[u8], &[u8]) -> Result<(), Fault> + 'a;

/// Reads pages and remembers which.
pub(crate) struct Walk<'a, R> {
    pub(crate) pages: &'a mut Pages<R>,
    pub(crate) claims: Claims,
    /// Leaves with wrong checksums that were let pass.
    pub(crate) torn_leaves: u64,
    leaf: Vec<u8>,
}

/// A branch on the way down.
struct Step {
    bytes: Vec<u8>,
    /// The next child.
    next: usize,
}

/// The last key of a sequence.
struct Last {
    key: Vec<u8>,
    /// Whether there is one yet, and in a leaf.
    of_leaf: Option<bool>,
}

impl<'a, R: Read + Seek> Walk<'a, R> {
    /// Nothing walked yet.
    pub(crate) fn new(pages: &'a mut Pages<R>) -> Self {
        let claims = Claims::new(pages.extent.count);
        Self {
            pages,
            claims,
            torn_leaves: 0,
            leaf: Vec::new(),
        }
    }

    /// Walks the tree at `root` and hands over each entry. What was handed over before a
    /// fault is as it was written if the table is not sealed.
    pub(crate) fn tree(
        &mut self,
        root: Root,
        shape: Shape,
        each: &mut Each<'_>,
    ) -> Result<(), Fault> {
        let mut bytes = std::mem::take(&mut self.leaf);
        let walked = self.descend(root, shape, &mut bytes, each);
        self.leaf = bytes;
        if walked? == root.length {
            Ok(())
        } else {
            Err(Fault::Wrong("its index does not hold as much as it says"))
        }
    }

    fn descend(
        &mut self,
        root: Root,
        shape: Shape,
        bytes: &mut Vec<u8>,
        each: &mut Each<'_>,
    ) -> Result<u64, Fault> {
        let mut steps: Vec<Step> = Vec::new();
        let mut last = Last {
            key: Vec::new(),
            of_leaf: None,
        };
        let mut entries = 0;
        let mut at = root;
        loop {
            self.read(at, bytes)?;
            let (node, whole) = Node::of(bytes, shape.widths, at.checksum)?;
            match node {
                Node::Leaf(leaf) => {
                    self.note(whole, shape.sealed)?;
                    entries += leaf.count as u64;
                    read_leaf(&leaf, shape.order, &mut last, each)?;
                }
                Node::Branch(_) => {
                    self.note(whole, false)?;
                    if steps.len() >= MAX_DEPTH || bytes.len() > MAX_BRANCH_BYTES {
                        return Err(Fault::Wrong("its index is deeper than any can be"));
                    }
                    let bytes = std::mem::take(bytes);
                    steps.push(Step { bytes, next: 0 });
                }
            }
            match next_child(&mut steps, shape, &mut last)? {
                Some(child) => at = child,
                None => return Ok(entries),
            }
        }
    }

    fn read(&mut self, at: Root, bytes: &mut Vec<u8>) -> Result<(), Fault> {
        let place = self.pages.extent.place(at.page)?;
        if !self.claims.claim(place) {
            return Err(Fault::Wrong("its index names a page twice"));
        }
        self.pages.read(at.page, bytes)
    }

    fn note(&mut self, whole: bool, sealed: bool) -> Result<(), Fault> {
        match (whole, sealed) {
            (true, _) => {}
            (false, true) => self.torn_leaves += 1,
            (false, false) => {
                return Err(Fault::Torn("a page of its index is not as it was written"));
            }
        }
        Ok(())
    }
}

/// The next child on the way, if there is one.
fn next_child(steps: &mut Vec<Step>, shape: Shape, last: &mut Last) -> Result<Option<Root>, Fault> {
    while let Some(step) = steps.last_mut() {
        let branch = step.branch(shape);
        if step.next <= branch.count {
            if let Some(before) = step.next.checked_sub(1) {
                last.follow(branch.key(before)?, shape.order, false)?;
            }
            let child = branch.child(step.next)?;
            step.next += 1;
            return Ok(Some(child));
        }
        steps.pop();
    }
    Ok(None)
}

impl Step {
    fn branch(&self, shape: Shape) -> Branch<'_> {
        Branch::of(&self.bytes, shape.widths)
    }
}

fn read_leaf(
    leaf: &Leaf<'_>,
    order: KeyOrder,
    last: &mut Last,
    each: &mut Each<'_>,
) -> Result<(), Fault> {
    for entry in leaf.entries() {
        let (key, value) = entry?;
        last.follow(key, order, true)?;
        each(key, value)?;
    }
    Ok(())
}

impl Last {
    /// Takes the next key of the sequence.
    fn follow(&mut self, key: &[u8], order: KeyOrder, in_leaf: bool) -> Result<(), Fault> {
        if !order.allows(key) {
            return Err(Fault::Wrong("a key of its index makes no sense"));
        }
        let rises = match (self.of_leaf, order.compare(&self.key, key)) {
            (None, _) | (_, Ordering::Less) => true,
            (Some(true), Ordering::Equal) => !in_leaf,
            _ => false,
        };
        if !rises {
            return Err(Fault::Wrong("the keys of its index do not rise"));
        }
        self.key.clear();
        self.key.extend_from_slice(key);
        self.of_leaf = Some(in_leaf);
        Ok(())
    }
}
