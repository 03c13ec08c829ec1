//! The check of everything that the store could come to.

use std::io::{Read, Seek};
use std::ops::Range;

use super::claims::Claims;
use super::free::FreeSpace;
use super::header::{Header, Root, Slot};
use super::node::Widths;
use super::order::KeyOrder;
use super::pages::{PageNumber, Pages};
use super::table::Table;
use super::walk::{Each, Shape, Walk};
use super::{Checked, Fault, u16_at, u64_at};
use crate::schema::ChunkKey;

/// A world has four tables, and the store itself keeps six.
const MAX_TABLES: usize = 32;

/// The tree of names and definitions.
pub(crate) const NAMES: Shape = Shape {
    widths: Widths {
        key: None,
        value: None,
    },
    order: KeyOrder::Text,
    sealed: false,
};

/// Checks the commit that the store would take, down to its last page.
///
/// Checksums are a reason to go back to the commit before only where the store would
/// compare them: if the last commit was written in one phase. They are compared always,
/// though, since whatever else is checked is worth more if it is what was written.
pub(crate) fn whole<R: Read + Seek>(pages: &mut Pages<R>) -> Result<Checked, Fault> {
    let header = Header::read(pages)?;
    let (slot, before) = header.chosen()?;
    match (commit(pages, &header, slot), before) {
        (Err(Fault::Torn(_)), Some(before)) => commit(pages, &header, before),
        (result, _) => result,
    }
}

fn commit<R: Read + Seek>(
    pages: &mut Pages<R>,
    header: &Header,
    slot: Slot,
) -> Result<Checked, Fault> {
    let mut walk = Walk::new(pages);
    let free = match system(&mut walk, slot.system) {
        // The store compares its own pages last. Before it knows that this commit is torn
        // it has believed every page of the user's that has its checksum.
        Err(Fault::Torn(why)) => {
            user(&mut Walk::new(walk.pages), slot.user, false)?;
            return Err(Fault::Torn(why));
        }
        free => free?,
    };
    // What was free when the store closed counts as long as there was no commit since;
    // else the store compares all checksums and finds out what is free.
    let resumes = header.two_phases && free.transaction == Some(slot.transaction);
    user(&mut walk, slot.user, resumes)?;
    if resumes {
        let mut regions = Vec::new();
        let extent = walk.pages.extent;
        for region in 0..extent.regions() {
            regions.push(extent.region_pages(region));
        }
        free.claim(&regions, &mut walk.claims)?;
    }
    Ok(Checked {
        torn_leaves: walk.torn_leaves,
    })
}

/// The tables of the world, and whatever others there are.
fn user<R: Read + Seek>(
    walk: &mut Walk<'_, R>,
    root: Option<Root>,
    resumes: bool,
) -> Result<(), Fault> {
    for (name, table) in definitions(walk, root)? {
        let (order, widths) = match name.as_str() {
            "values" => (KeyOrder::Text, widths(None)),
            "chunks" => (KeyOrder::Bytes, widths(Some(ChunkKey::BYTES))),
            "land" | "records" => (KeyOrder::Bytes, widths(None)),
            _ => (KeyOrder::Unknown, table.widths),
        };
        let sealed = resumes && order != KeyOrder::Unknown;
        let shape = Shape {
            widths,
            order,
            sealed,
        };
        contents(walk, table, shape, &mut |_, _| Ok(()))?;
    }
    Ok(())
}

/// Keys of one width and values of many.
fn widths(key: Option<usize>) -> Widths {
    Widths { key, value: None }
}

fn definitions<R: Read + Seek>(
    walk: &mut Walk<'_, R>,
    root: Option<Root>,
) -> Result<Vec<(String, Table)>, Fault> {
    let mut tables = Vec::new();
    if let Some(root) = root {
        walk.tree(root, NAMES, &mut |name, definition| {
            if tables.len() >= MAX_TABLES {
                return Err(Fault::Wrong("it has more tables than any can have"));
            }
            let name = String::from_utf8_lossy(name).into_owned();
            tables.push((name, Table::of(definition)?));
            Ok(())
        })?;
    }
    Ok(tables)
}

fn contents<R: Read + Seek>(
    walk: &mut Walk<'_, R>,
    table: Table,
    shape: Shape,
    each: &mut Each<'_>,
) -> Result<(), Fault> {
    if table.widths != shape.widths {
        return Err(Fault::Wrong("one of its tables makes no sense"));
    }
    table
        .root
        .map_or(Ok(()), |root| walk.tree(root, shape, each))
}

/// The store's own tables: pages kept though they are freed, and what is free.
fn system<R: Read + Seek>(walk: &mut Walk<'_, R>, root: Option<Root>) -> Result<FreeSpace, Fault> {
    let mut free = FreeSpace::default();
    for (name, table) in definitions(walk, root)? {
        let shape = |order, key| Shape {
            widths: widths(Some(key)),
            order,
            sealed: false,
        };
        match name.as_str() {
            "allocator_state" => {
                let shape = shape(KeyOrder::Allocator, 5);
                contents(walk, table, shape, &mut |key, value| free.take(key, value))?;
            }
            "data_pages_unreachable" | "system_pages_unreachable" => {
                let shape = shape(KeyOrder::Transactions, 16);
                let mut freed = Claims::new(walk.pages.extent.count);
                let in_use = || Fault::Wrong("a page that it freed is in use");
                listed(walk, table, shape, &mut |place| {
                    freed.claim(place).then_some(()).ok_or_else(in_use)
                })?;
                if !walk.claims.join(&freed) {
                    return Err(in_use());
                }
            }
            "data_pages_allocated" => {
                let shape = shape(KeyOrder::Transactions, 16);
                listed(walk, table, shape, &mut |_| Ok(()))?;
            }
            // This game keeps no older states; the store would unpack them unchecked.
            _ if table.root.is_some() => {
                return Err(Fault::Wrong("it has a table that this game never makes"));
            }
            _ => {}
        }
    }
    Ok(free)
}

/// Hands over the pages that a table of page lists names: each value is their number, u16,
/// then that many page numbers, then room for more.
fn listed<R: Read + Seek>(
    walk: &mut Walk<'_, R>,
    table: Table,
    shape: Shape,
    each: &mut dyn FnMut(Range<u64>) -> Result<(), Fault>,
) -> Result<(), Fault> {
    if !table.lists_pages {
        return Err(Fault::Wrong("one of its tables makes no sense"));
    }
    let extent = walk.pages.extent;
    let mut named = 0;
    contents(walk, table, shape, &mut |_, list| {
        let wrong = || Fault::Wrong("a list of freed pages makes no sense");
        let length = u16_at(list, 0).map(usize::from).ok_or_else(wrong)?;
        named += length as u64;
        if named > extent.count {
            return Err(wrong());
        }
        for index in 0..length {
            let bits = u64_at(list, 2 + 8 * index).ok_or_else(wrong)?;
            each(extent.place(PageNumber::from_bits(bits))?)?;
        }
        Ok(())
    })
}
