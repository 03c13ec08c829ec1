//! The store of edits against a disk in memory.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock};

use antipode_geometry::ChartId;
use antipode_storage::{Batch, ChunkKey};
use glam::IVec3;

use super::*;
use crate::edit_backend::Failure;

#[derive(Default)]
struct Disk(Mutex<HashMap<ChunkKey, Vec<i16>>>);

impl EditBackend for Disk {
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure> {
        Ok(Vec::new())
    }

    fn chunk(&self, key: &ChunkKey) -> Result<Option<Stored>, ReadFault> {
        let units = self.0.lock().unwrap().get(key).cloned();
        Ok(units.map(|units| (units, Vec::new())))
    }

    fn commit(&self, _: &Batch) -> Result<(), Failure> {
        Ok(())
    }
}

fn chunk(x: i32) -> ChunkCoord {
    ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(x, 0, 0),
    }
}

fn enter(edit_store: &EditStore, x: i32) -> EditMap {
    let edits = edit_store.edits(chunk(x), &mut Vec::new()).unwrap();
    let mut change = Change::of(chunk(x), edits);
    change.visible = change.edits_mut().add(1, 2, 3, 0.5);
    edit_store.enter(vec![change]).land
}

fn save(edit_store: &EditStore, disk: &Disk) {
    let land = edit_store.unsaved();
    for (coord, edits) in &land {
        disk.0
            .lock()
            .unwrap()
            .insert(key_of(*coord), edits.to_units());
    }
    edit_store.saved(&land);
    edit_store.forget_saved();
}

#[test]
fn what_is_saved_and_not_used_leaves_the_memory_and_comes_back() {
    let disk = Arc::new(Disk::default());
    let edit_store = EditStore::new(
        Some(Arc::clone(&disk) as Arc<dyn EditBackend>),
        HashSet::new(),
    );
    let count = MOST_SAVED as i32 + 40;
    for x in 0..count {
        enter(&edit_store, x);
        save(&edit_store, &disk);
    }
    assert_eq!(edit_store.held(), MOST_SAVED);
    for x in [0, 20, count - 1] {
        let edits = edit_store.edits(chunk(x), &mut Vec::new()).unwrap();
        assert_eq!(edits.delta(1, 2, 3), 0.5, "{x}");
    }
    enter(&edit_store, 3);
    save(&edit_store, &disk);
    assert_eq!(
        edit_store
            .edits(chunk(3), &mut Vec::new())
            .unwrap()
            .delta(1, 2, 3),
        1.0
    );
    assert_eq!(edit_store.held(), MOST_SAVED);
}

#[test]
fn what_is_not_saved_stays_and_so_does_everything_without_a_store() {
    let edit_store = EditStore::new(Some(Arc::new(Disk::default())), HashSet::new());
    let bare = EditStore::new(None, HashSet::new());
    for x in 0..MOST_SAVED as i32 + 40 {
        enter(&edit_store, x);
        enter(&bare, x);
    }
    edit_store.forget_saved();
    assert!(bare.unsaved().is_empty());
    bare.forget_saved();
    assert_eq!(
        (edit_store.held(), bare.held()),
        (MOST_SAVED + 40, MOST_SAVED + 40)
    );
}

#[test]
fn what_is_on_its_way_to_the_disk_stays_in_memory_until_it_is_there() {
    let disk = Arc::new(Disk::default());
    let edit_store = EditStore::new(
        Some(Arc::clone(&disk) as Arc<dyn EditBackend>),
        HashSet::new(),
    );
    let count = MOST_SAVED as i32 + 10;
    let first: EditMap = (0..count).flat_map(|x| enter(&edit_store, x)).collect();
    assert_eq!(first.len(), count as usize);
    // The second moment has a newer edit of one of them; the first is saved meanwhile.
    let second = enter(&edit_store, 0);
    assert_eq!(second.len(), 1);
    edit_store.forget_saved();
    assert_eq!(edit_store.held(), count as usize, "nothing is saved yet");
    edit_store.saved(&first);
    assert_eq!(edit_store.unsaved().len(), 1, "the newer edit is not saved");
    edit_store.saved(&second);
    assert!(edit_store.unsaved().is_empty());
}

/// A disk on which something else happens while it is first read.
struct Busy {
    disk: Arc<Disk>,
    meanwhile: OnceLock<Box<dyn Fn() + Send + Sync>>,
    read: AtomicBool,
}

impl EditBackend for Busy {
    fn edited(&self) -> Result<Vec<ChunkKey>, Failure> {
        Ok(Vec::new())
    }

    fn chunk(&self, key: &ChunkKey) -> Result<Option<Stored>, ReadFault> {
        if let Some(meanwhile) = self.meanwhile.get()
            && !self.read.swap(true, Ordering::Relaxed)
        {
            meanwhile();
        }
        self.disk.chunk(key)
    }

    fn commit(&self, _: &Batch) -> Result<(), Failure> {
        Ok(())
    }
}

#[test]
fn what_leaves_the_memory_while_its_neighbour_is_read_is_read_too() {
    let disk = Arc::new(Disk::default());
    let busy = Arc::new(Busy {
        disk: Arc::clone(&disk),
        meanwhile: OnceLock::new(),
        read: AtomicBool::new(false),
    });
    let backend = Arc::clone(&busy) as Arc<dyn EditBackend>;
    let edit_store = Arc::new(EditStore::new(Some(backend), HashSet::new()));
    // The first has left the memory, and the second is the next to go.
    for x in 0..=MOST_SAVED as i32 {
        enter(&edit_store, x);
        save(&edit_store, &disk);
    }
    let other = Arc::clone(&edit_store);
    let saver = move || {
        enter(&other, 1000);
        save(&other, &disk);
    };
    assert!(busy.meanwhile.set(Box::new(saver)).is_ok());
    let near = edit_store.snapshot(chunk(0), &mut Vec::new()).near;
    assert!(busy.read.load(Ordering::Relaxed), "the disk was read");
    assert_eq!(near.len(), 2, "both have changes");
}
