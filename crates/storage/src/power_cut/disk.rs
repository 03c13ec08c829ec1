//! A file that remembers every write to it, and what may be left of it.

use std::io;
use std::sync::{Arc, Mutex};

use proptest::prelude::RngExt as _;
use proptest::test_runner::TestRng;

/// What a disk writes as a whole.
const SECTOR: usize = 512;
/// What a copying program reads at a time.
const READ: usize = 64 << 10;

/// What happened to the file, or what was told to the game.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Event {
    /// Bytes were written at an offset.
    Write(usize, Vec<u8>),
    /// The length was changed.
    Length(usize),
    /// All before is on the disk.
    Sync,
    /// The game knows that this commit is durable.
    Committed(i32),
}

/// The file.
#[derive(Debug, Default)]
pub(super) struct Disk {
    bytes: Mutex<Vec<u8>>,
    log: Arc<Mutex<Vec<Event>>>,
}

impl Disk {
    /// What happens to it from now on.
    pub(super) fn log(&self) -> Arc<Mutex<Vec<Event>>> {
        Arc::clone(&self.log)
    }

    fn happen(&self, event: Event) {
        apply(&mut self.bytes.lock().unwrap(), &event);
        self.log.lock().unwrap().push(event);
    }
}

impl redb::StorageBackend for Disk {
    fn len(&self) -> Result<u64, io::Error> {
        Ok(self.bytes.lock().unwrap().len() as u64)
    }

    fn read(&self, offset: u64, out: &mut [u8]) -> Result<(), io::Error> {
        let bytes = self.bytes.lock().unwrap();
        let from = offset as usize;
        let found = bytes.get(from..from + out.len());
        out.copy_from_slice(found.ok_or(io::ErrorKind::UnexpectedEof)?);
        Ok(())
    }

    fn set_len(&self, length: u64) -> Result<(), io::Error> {
        self.happen(Event::Length(length as usize));
        Ok(())
    }

    fn sync_data(&self) -> Result<(), io::Error> {
        self.happen(Event::Sync);
        Ok(())
    }

    fn write(&self, offset: u64, data: &[u8]) -> Result<(), io::Error> {
        self.happen(Event::Write(offset as usize, data.to_vec()));
        Ok(())
    }
}

fn apply(bytes: &mut Vec<u8>, event: &Event) {
    match event {
        Event::Write(at, data) => {
            let end = at + data.len();
            if bytes.len() < end {
                bytes.resize(end, 0);
            }
            bytes[*at..end].copy_from_slice(data);
        }
        Event::Length(length) => bytes.resize(*length, 0),
        Event::Sync | Event::Committed(_) => {}
    }
}

/// The file after the power went: all that was synced, and of the sectors written since
/// any, in any order. A new length is there or not, and what lies beyond it is not.
pub(super) fn after_a_cut(log: &[Event], dice: &mut TestRng) -> Vec<u8> {
    let synced = log
        .iter()
        .rposition(|event| *event == Event::Sync)
        .map_or(0, |at| at + 1);
    let mut bytes = Vec::new();
    for event in &log[..synced] {
        apply(&mut bytes, event);
    }
    let mut length = bytes.len();
    let mut sectors = Vec::new();
    for event in &log[synced..] {
        match event {
            Event::Write(at, data) => sectors.extend(in_sectors(*at, data)),
            Event::Length(new) if dice.random() => length = *new,
            _ => {}
        }
    }
    // Nearly all, half or few of them, in an order of the disk's own.
    let share = [0.03, 0.5, 0.97][dice.random_range(0..3)];
    while !sectors.is_empty() {
        let event = sectors.swap_remove(dice.random_range(0..sectors.len()));
        if dice.random_bool(share) {
            apply(&mut bytes, &event);
        }
    }
    bytes.resize(length, 0);
    bytes
}

/// A write in pieces that each reach the disk as a whole.
fn in_sectors(at: usize, data: &[u8]) -> Vec<Event> {
    let mut pieces = Vec::new();
    let mut from = 0;
    while from < data.len() {
        let to = data.len().min((at + from) / SECTOR * SECTOR + SECTOR - at);
        pieces.push(Event::Write(at + from, data[from..to].to_vec()));
        from = to;
    }
    pieces
}

/// What a program gets that copies the file from front to back while so many events a
/// read happen.
pub(super) fn torn_copy(log: &[Event], begin: usize, pace: f64) -> Vec<u8> {
    let mut file = Vec::new();
    let mut copy = Vec::new();
    let mut done = 0;
    for read in 0.. {
        let until = log.len().min(begin + (f64::from(read) * pace) as usize);
        for event in &log[done..until] {
            apply(&mut file, event);
        }
        done = until;
        let Some(rest) = file.get(copy.len()..).filter(|rest| !rest.is_empty()) else {
            break;
        };
        copy.extend(&rest[..rest.len().min(READ)]);
    }
    copy
}
