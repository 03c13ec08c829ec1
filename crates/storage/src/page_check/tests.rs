//! The check against real stores, damaged and forged ones, and against the store itself.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use std::cell::RefCell;
use std::fs;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::Path;
use std::rc::Rc;
use std::sync::OnceLock;

use super::find::look;
use super::pages::Pages;
use super::whole::whole;
use super::{Checked, Fault, u32_at};
use crate::codec::Kind;
use crate::store::Store;
use crate::{Batch, ChunkKey, SavesDir, WORLD_FILE, WorldMeta, WorldState, WorldStore};

mod forge;
mod survival;

use forge::Forge;

/// Enough for branches of branches.
const CHUNKS: i32 = 2400;

fn check(bytes: &[u8]) -> Result<Checked, Fault> {
    Pages::new(Cursor::new(bytes)).and_then(|mut pages| whole(&mut pages))
}

/// Why a store is refused.
fn refusal(bytes: &[u8]) -> String {
    match check(bytes) {
        Err(Fault::Torn(reason) | Fault::Wrong(reason)) => reason.to_owned(),
        other => panic!("{other:?}"),
    }
}

fn key(x: i32) -> ChunkKey {
    ChunkKey {
        x,
        ..ChunkKey::default()
    }
}

fn samples(x: i32, commit: i16) -> Vec<i16> {
    vec![x as i16 ^ commit; crate::CHUNK_SAMPLES]
}

fn meta() -> WorldMeta {
    WorldMeta {
        name: "Victim".to_owned(),
        ..WorldMeta::default()
    }
}

fn commit(world: &WorldStore, number: i16, chunks: impl Iterator<Item = i32>) {
    let state = WorldState {
        simulated_s: f64::from(number),
        ..WorldState::default()
    };
    let batch = Batch {
        meta: None,
        records: (&state).into(),
        chunks: chunks.map(|x| (key(x), samples(x, number))).collect(),
        kinds: std::collections::BTreeMap::new(),
    };
    world.commit(&batch).unwrap();
}

/// A world of two commits, the second of which changes a part, closed or as a kill leaves it.
fn made(chunks: i32, close: bool) -> Vec<u8> {
    let dir = tempfile::tempdir().unwrap();
    let world = WorldStore::create(dir.path(), &meta()).unwrap();
    commit(&world, 1, 0..chunks);
    commit(&world, 2, (0..chunks).step_by(7));
    let path = dir.path().join(WORLD_FILE);
    if close {
        drop(world);
        return fs::read(path).unwrap();
    }
    fs::read(path).unwrap()
}

fn closed() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| made(CHUNKS, true))
}

fn killed() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| made(CHUNKS, false))
}

/// Small ones, to be used in whole many times.
fn small(close: bool) -> &'static [u8] {
    static BYTES: OnceLock<[Vec<u8>; 2]> = OnceLock::new();
    &BYTES.get_or_init(|| [made(40, false), made(40, true)])[usize::from(close)]
}

#[test]
fn real_stores_pass() {
    for chunks in [0, 1, 40, CHUNKS] {
        for close in [false, true] {
            let checked = check(&made(chunks, close));
            assert!(
                matches!(checked, Ok(Checked { torn_leaves: 0 })),
                "{chunks} {close} {checked:?}"
            );
        }
    }
    let branches = Forge::of(closed()).pages_of_kind(2);
    assert!(branches.len() > 2, "{branches:?}");
    assert!(check(&Forge::of(closed()).reseal().bytes).is_ok());
    assert_eq!(Forge::of(closed()).reseal().bytes, closed());
}

/// Notes what of a store is read.
struct Noting {
    store: Cursor<Vec<u8>>,
    /// Where each read began, and its bytes.
    reads: Rc<RefCell<Vec<(u64, usize)>>>,
}

impl Read for Noting {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let at = self.store.position();
        let bytes = self.store.read(into)?;
        self.reads.borrow_mut().push((at, bytes));
        Ok(bytes)
    }
}

impl Seek for Noting {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.store.seek(to)
    }
}

/// Which reads of a store some work takes.
fn reads<T: std::fmt::Debug>(
    bytes: &[u8],
    work: impl FnOnce(&mut Pages<Noting>) -> Result<T, Fault>,
) -> Vec<(u64, usize)> {
    let reads = Rc::default();
    let store = Noting {
        store: Cursor::new(bytes.to_vec()),
        reads: Rc::clone(&reads),
    };
    let done = Pages::new(store).and_then(|mut pages| work(&mut pages));
    assert!(done.is_ok(), "{done:?}");
    reads.take()
}

/// That a long world opens soon, and many are listed soon, comes of reading no more than this.
#[test]
fn the_check_reads_a_page_once_and_the_list_only_the_few_that_lead_to_the_name() {
    for store in [closed(), killed()] {
        let mut places: Vec<_> = reads(store, whole).into_iter().map(|(at, _)| at).collect();
        let count = places.len();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), count, "some are read again");
    }
    for store in [closed(), small(true)] {
        let bytes: usize = reads(store, look).into_iter().map(|(_, bytes)| bytes).sum();
        assert!(bytes <= 4 * 4096, "{bytes}");
    }
}

#[test]
fn a_store_that_grew_and_shrank_passes_at_every_step() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join(WORLD_FILE);
    drop(WorldStore::create(dir.path(), &meta()).unwrap());
    for round in 1..6 {
        let world = WorldStore::open(dir.path()).unwrap();
        // Opened and killed before a commit.
        assert!(check(&fs::read(&path).unwrap()).is_ok());
        commit(&world, round, 0..i32::from(round) * 700);
        assert!(check(&fs::read(&path).unwrap()).is_ok());
        commit(&world, round + 10, 0..i32::from(round) * 700);
        assert!(check(&fs::read(&path).unwrap()).is_ok());
        drop(world);
        assert!(check(&fs::read(&path).unwrap()).is_ok());
    }
}

/// A way to change a store.
type Change = dyn Fn(&mut Forge);

#[test]
fn forgeries_that_every_checksum_lets_pass_are_refused_with_the_reason() {
    let leaf = |forge: &Forge| forge.pages_of_kind(1)[3];
    let branch = |forge: &Forge| forge.pages_of_kind(2)[1];
    let child = move |forge: &Forge, n: usize| {
        let start = branch(forge);
        let count = usize::from(forge.bytes[start + 2]) + 1;
        start + 8 + 16 * count + 8 * n
    };
    let forgeries: Vec<(&str, Box<Change>)> = vec![
        // What made 60^5 leaves of one.
        (
            "names a page twice",
            Box::new(move |forge| {
                let first = child(forge, 0);
                let number = forge.bytes[first..first + 8].to_vec();
                for n in 1..=usize::from(forge.bytes[branch(forge) + 2]) {
                    forge.put(child(forge, n), &number);
                }
            }),
        ),
        // What made 4.1 GB of one byte, and what makes more.
        (
            "behind its end",
            Box::new(move |forge| {
                forge.put(child(forge, 2) + 7, &[0xa0]);
            }),
        ),
        (
            "longer than any",
            Box::new(move |forge| {
                forge.put(child(forge, 2) + 7, &[0xf8]);
            }),
        ),
        (
            "behind its end",
            Box::new(move |forge| {
                forge.put(child(forge, 2) + 3, &[0x70]);
            }),
        ),
        // A branch as its own child.
        (
            "names a page twice",
            Box::new(move |forge| {
                let root = forge.numbers(forge.chunks())[0];
                let number = forge.bytes[root..root + 8].to_vec();
                forge.put(child(forge, 1), &number);
            }),
        ),
        (
            "do not rise",
            Box::new(move |forge| {
                let at = leaf(forge);
                let first = at + 4 + 4 * usize::from(forge.bytes[at + 2]);
                forge.put(first + 4, &[0xff]);
            }),
        ),
        (
            "outside of its page",
            Box::new(move |forge| {
                let at = leaf(forge) + 8;
                forge.put(at, &[0, 0]);
            }),
        ),
        (
            "as much as it says",
            Box::new(|forge| {
                let length = forge.chunks().definition;
                forge.put(length + 1, &[7, 0, 0, 0, 0, 0, 0, 0x70]);
                forge.put(length + 34, &[7, 0, 0, 0, 0, 0, 0, 0x70]);
            }),
        ),
        (
            "makes no sense",
            Box::new(|forge| {
                let length = forge.chunks().definition;
                forge.put(length + 1, &[7]);
            }),
        ),
        (
            "makes no sense",
            Box::new(|forge| {
                let kind = forge.chunks().definition;
                forge.put(kind, &[4]);
            }),
        ),
        (
            "makes no sense",
            Box::new(|forge| {
                let width = forge.chunks().definition + 43;
                forge.put(width, &[12]);
            }),
        ),
        (
            "header is damaged",
            Box::new(|forge| {
                let transaction = forge.slot() + 104;
                forge.put(transaction, &(u64::MAX - 1).to_le_bytes());
            }),
        ),
    ];
    for (reason, forgery) in forgeries {
        let mut forge = Forge::of(closed());
        forgery(&mut forge);
        forge.reseal();
        let said = refusal(&forge.bytes);
        assert!(said.contains(reason), "{said} for {reason}");
    }
}

/// Where in the file the list of free pages has the bitmap of order 0 of the first region.
fn free_pages(forge: &Forge) -> (usize, usize) {
    let table = forge.table(40, "allocator_state");
    let pages = forge.numbers(table).into_iter().map(|at| forge.page(at));
    // The first region's value: the largest order, how many pages, ends of bitmaps.
    let number = |at| u32_at(&forge.bytes, at).unwrap();
    let value = pages
        .flatten()
        .find(|&at| number(at) == 20 && (1..1 << 20).contains(&number(at + 4)))
        .unwrap();
    (value, value + 92)
}

#[test]
fn a_list_of_free_pages_that_would_give_a_used_one_away_is_refused() {
    let forge = Forge::of(closed());
    let (region, bitmap) = free_pages(&forge);
    // A bitmap of three levels for a million pages, four of them: the last level's words.
    let levels = u32_at(&forge.bytes, bitmap).unwrap() as usize;
    let start = u32_at(&forge.bytes, bitmap + 4 * (levels - 1)).unwrap() as usize;
    let word = bitmap + start + 4;
    let mut used = forge.clone();
    used.put(word, &[0; 8]);
    // Those above lead there, too.
    let said = refusal(&used.reseal().bytes);
    assert!(said.contains("in use and free at once"), "{said}");
    for (at, bytes) in [
        (region, &[21][..]),
        (region + 4, &[0xff, 0xff, 0xff, 0x7f]),
        (region + 8, &[0xff, 0xff]),
        (bitmap, &[200]),
        (bitmap + 4, &[0xff, 0xff]),
    ] {
        let mut forged = forge.clone();
        forged.put(at, bytes);
        let said = refusal(&forged.reseal().bytes);
        assert!(said.contains("list of free pages makes no sense"), "{said}");
    }
}

/// What reading a store hands over that was opened without this check, and what ends it.
fn scanned(bytes: &[u8]) -> (Vec<Vec<u8>>, String) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join(WORLD_FILE);
    fs::write(&path, bytes).unwrap();
    let store = Store::of(&path, "Victim", redb::Database::open(&path).unwrap());
    let mut keys = Vec::new();
    let ended = store.scan(|raw| {
        if raw.kind == Kind::Chunk {
            keys.push(raw.key);
        }
    });
    (keys, ended.unwrap_err().to_string())
}

#[test]
fn a_forged_store_that_was_opened_is_read_no_farther_than_it_makes_sense() {
    let mut short = Forge::of(closed());
    let length = short.chunks().definition;
    for at in [1, 34] {
        short.put(length + at, &7_u64.to_le_bytes());
    }
    let (keys, said) = scanned(&short.reseal().bytes);
    assert_eq!(keys.len(), 7);
    assert!(said.contains("as many chunks as it says"), "{said}");

    let mut round = Forge::of(closed());
    let branch = round.pages_of_kind(2)[1];
    let count = usize::from(round.bytes[branch + 2]);
    let children = branch + 8 + 16 * (count + 1);
    let first = round.bytes[children..children + 8].to_vec();
    for n in 1..=count {
        round.put(children + 8 * n, &first);
    }
    let (keys, said) = scanned(&round.reseal().bytes);
    assert!(keys.is_sorted_by(|a, b| a < b), "{} keys", keys.len());
    assert!(keys.len() < CHUNKS as usize / 2, "{}", keys.len());
    assert!(said.contains("do not rise"), "{said}");
}
