//! Verify and repair: what `antipode saves verify` and `repair` do to one world.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::codec::{self, Kind, Record};
use crate::error::StorageError;
use crate::schema::{
    self, ChunkBody, ChunkKey, SCHEMA_VERSION, SchemaFault, WorldMeta, WorldState,
};
use crate::store::{META_KEY, STATE_KEY, Store};
use crate::world::{self, WorldStore};
use crate::{WORLD_FILE, atomic_file, summary};

/// What reading every value of a world has found.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct VerifyReport {
    /// Name of the world, or its directory if that cannot be read.
    pub world: String,
    /// Edited chunks that are whole.
    pub chunks: usize,
    /// Whether there is a state (player and so on) and it is whole.
    pub has_state: bool,
    /// What is damaged, a sentence each.
    pub problems: Vec<String>,
}

impl VerifyReport {
    /// Whether nothing is damaged.
    pub fn is_sound(&self) -> bool {
        self.problems.is_empty()
    }
}

/// What a repair has done.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RepairReport {
    /// Name of the world.
    pub world: String,
    /// Edited chunks that the new store holds.
    pub chunks: usize,
    /// Whether the state (player and so on) was salvaged.
    pub has_state: bool,
    /// What is lost or older than it was, a sentence each.
    pub losses: Vec<String>,
    /// Where the damaged file is kept; `None` if nothing needed repair.
    pub kept: Option<PathBuf>,
}

/// Reads and decodes every value in the world of `dir` and walks every page.
/// A damaged world is a report, not an error; one in use or of a newer game is an error.
pub(crate) fn verify(dir: &Path) -> Result<VerifyReport, StorageError> {
    let world = match WorldStore::open(dir) {
        Ok(world) => world,
        Err(error @ (StorageError::Unreadable { .. } | StorageError::Damaged { .. })) => {
            let problems = vec![error.to_string()];
            return Ok(VerifyReport {
                world: world::label(dir),
                problems,
                ..VerifyReport::default()
            });
        }
        Err(error) => return Err(error),
    };
    let mut report = VerifyReport {
        world: world.meta().name,
        problems: world.problems(),
        ..VerifyReport::default()
    };
    match world.state() {
        Ok(state) => report.has_state = state.is_some(),
        Err(error) => report.note(&error),
    }
    match world.edited_chunks() {
        Ok(keys) => {
            for key in keys {
                match world.chunk(&key) {
                    Ok(_) => report.chunks += 1,
                    Err(error) => report.note(&error),
                }
            }
        }
        Err(error) => report.note(&error),
    }
    if let Err(error) = world.check_pages() {
        report.note(&error);
    }
    Ok(report)
}

impl VerifyReport {
    fn note(&mut self, error: &StorageError) {
        let sentence = error.to_string();
        if !self.problems.contains(&sentence) {
            self.problems.push(sentence);
        }
    }
}

/// Salvages every readable value of the world in `dir` into a fresh store that
/// takes the place of the damaged one, which stays beside it under another name.
/// `scratch` is an empty directory on the same file system.
pub(crate) fn repair(dir: &Path, scratch: &Path) -> Result<RepairReport, StorageError> {
    let before = verify(dir)?;
    if before.is_sound() {
        let VerifyReport {
            world,
            chunks,
            has_state,
            ..
        } = before;
        return Ok(RepairReport {
            world,
            chunks,
            has_state,
            losses: Vec::new(),
            kept: None,
        });
    }
    let path = dir.join(WORLD_FILE);
    if let Some(found) = summary::newer_version(dir) {
        return Err(StorageError::Newer {
            world: world::label(dir),
            found,
        });
    }
    let salvage = Salvage::of(&path, scratch, &world::label(dir))?;
    let meta = salvage
        .meta
        .clone()
        .map(|(_, meta)| meta)
        .or_else(|| summary::read(dir));
    let Some(meta) = meta else {
        let reason =
            "neither it nor summary.bin says which world it is (its seed and geometry)".to_owned();
        return Err(StorageError::Unsalvageable { path, reason });
    };
    let fresh = scratch.join(WORLD_FILE);
    salvage.write(&fresh, &meta)?;
    let kept = put_in_place(&path, &fresh)?;
    if let Ok(bytes) = world::sealed(&meta, META_KEY, salvage.last + 1, &meta.name) {
        summary::write(dir, &bytes);
    }
    Ok(RepairReport {
        world: meta.name,
        chunks: salvage.chunks.len(),
        has_state: salvage.state.is_some(),
        losses: salvage.losses(&before.problems),
        kept: Some(kept),
    })
}

/// Keeps `path` under a free name beside it and puts `fresh` in its place, in one
/// step where the file system has hard links.
fn put_in_place(path: &Path, fresh: &Path) -> Result<PathBuf, StorageError> {
    let mut number = 1;
    let kept = loop {
        let candidate = path.with_file_name(format!("{WORLD_FILE}.damaged-{number}"));
        if !candidate.exists() {
            break candidate;
        }
        number += 1;
    };
    if fs::hard_link(path, &kept).is_err() {
        StorageError::at("Keeping", &kept, fs::copy(path, &kept))?;
    }
    StorageError::at("Replacing", path, fs::rename(fresh, path))?;
    if let Some(dir) = path.parent() {
        atomic_file::sync_dir(dir);
    }
    Ok(kept)
}

/// The newest whole record of each value, by the number of its commit.
#[derive(Default)]
struct Salvage {
    meta: Option<(u64, WorldMeta)>,
    state: Option<(u64, WorldState)>,
    chunks: BTreeMap<ChunkKey, (u64, Vec<i16>)>,
    /// The last commit that the index led to, or that anything tells of.
    last: u64,
    /// Chunks that the index led to, but to a damaged record.
    damaged: Vec<ChunkKey>,
    newer: Option<u16>,
}

impl Salvage {
    /// Reads by the index as far as it goes, from a copy, because opening writes;
    /// then searches the bare bytes for what the index did not lead to.
    fn of(path: &Path, scratch: &Path, world: &str) -> Result<Self, StorageError> {
        let copy = scratch.join("damaged.redb");
        StorageError::at("Copying", path, fs::copy(path, &copy))?;
        let mut salvage = Self::default();
        let by_index = Store::open(&copy, world).and_then(|store| {
            store.scan(|raw| match codec::unseal(&raw.bytes) {
                Ok(record) if record.key == raw.key => salvage.add(&record),
                _ if raw.kind == Kind::Chunk => {
                    salvage.damaged.extend(ChunkKey::from_bytes(&raw.key));
                }
                _ => {}
            })
        });
        // With a whole index, what is newer than its last commit was never committed.
        let last = if by_index.is_ok() && salvage.last > 0 {
            salvage.last
        } else {
            u64::MAX
        };
        let bytes = StorageError::at("Reading", path, fs::read(path))?;
        for record in codec::carve(&bytes).filter(|record| record.sequence <= last) {
            salvage.add(&record);
        }
        StorageError::at("Removing", &copy, fs::remove_file(&copy))?;
        match salvage.newer {
            Some(found) => Err(StorageError::Newer {
                world: world.to_owned(),
                found,
            }),
            None => Ok(salvage),
        }
    }

    /// Takes a record if it is readable and newer than what there is.
    fn add(&mut self, record: &Record<'_>) {
        let added = match record.kind {
            Kind::Meta => newest(&mut self.meta, record, META_KEY.as_bytes()),
            Kind::State => newest(&mut self.state, record, STATE_KEY.as_bytes()),
            Kind::Chunk => self.add_chunk(record),
        };
        match added {
            Ok(()) => self.last = self.last.max(record.sequence),
            Err(SchemaFault::Newer(found)) => self.newer = Some(found),
            Err(SchemaFault::Damaged(reason)) => {
                tracing::debug!(%reason, "a record was not salvaged");
            }
        }
    }

    fn add_chunk(&mut self, record: &Record<'_>) -> Result<(), SchemaFault> {
        schema::check::<ChunkBody>(record, record.key)?;
        let Some(key) = ChunkKey::from_bytes(record.key) else {
            return Err(SchemaFault::Damaged("its key is no chunk's".to_owned()));
        };
        let mut slot = self
            .chunks
            .remove(&key)
            .map(|(sequence, samples)| (sequence, ChunkBody(samples)));
        let added = newest(&mut slot, record, record.key);
        if let Some((sequence, ChunkBody(samples))) = slot {
            self.chunks.insert(key, (sequence, samples));
        }
        added
    }

    /// Writes what was found into a new store, closed when this returns.
    fn write(&self, path: &Path, meta: &WorldMeta) -> Result<(), StorageError> {
        let sequence = self.last + 1;
        let mut values = vec![(
            META_KEY,
            world::sealed(meta, META_KEY, sequence, &meta.name)?,
        )];
        if let Some((_, state)) = &self.state {
            values.push((
                STATE_KEY,
                world::sealed(state, STATE_KEY, sequence, &meta.name)?,
            ));
        }
        let chunks = self.chunks.iter().filter_map(|(key, (_, samples))| {
            let body = crate::pack_chunk(samples).ok()?;
            let key = key.to_bytes();
            Some((
                key,
                codec::seal(SCHEMA_VERSION, Kind::Chunk, &key, sequence, &body),
            ))
        });
        Store::create(path, &meta.name)?.write(&values, &chunks.collect::<Vec<_>>())
    }

    fn losses(&self, problems: &[String]) -> Vec<String> {
        let mut losses: Vec<_> = self
            .damaged
            .iter()
            .map(|key| match self.chunks.get(key) {
                Some((sequence, _)) => format!(
                    "The edits of {key} are those of commit {sequence}; later ones are lost."
                ),
                None => format!("The edits of {key} are lost; it is as the seed made it."),
            })
            .collect();
        if self.state.is_none() {
            losses.push(
                "The player's place and belongings are lost; the player starts anew.".to_owned(),
            );
        }
        if losses.is_empty() {
            losses.extend(
                problems
                    .iter()
                    .map(|problem| format!("It was mended; before: {problem}")),
            );
        }
        losses
    }
}

/// Replaces `slot` by the record's value if that is newer.
fn newest<T: schema::Versioned>(
    slot: &mut Option<(u64, T)>,
    record: &Record<'_>,
    key: &[u8],
) -> Result<(), SchemaFault> {
    schema::check::<T>(record, key)?;
    if slot
        .as_ref()
        .is_none_or(|(sequence, _)| record.sequence > *sequence)
    {
        *slot = Some((record.sequence, T::upgrade(record.version, record.body)?));
    }
    Ok(())
}
