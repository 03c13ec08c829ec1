//! What is left of a damaged store: by its index as far as that goes, then by
//! searching the bare bytes for sealed records.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Read};
use std::ops::ControlFlow;
use std::path::Path;

use crate::batch;
use crate::codec::{self, Kind, Record};
use crate::error::StorageError;
use crate::record::RecordKind;
use crate::regular;
use crate::schema::{self, ChunkBody, ChunkKey, SchemaFault, Versioned, WorldMeta, WorldState};
use crate::store::{META_KEY, Put, STATE_KEY, Store};
use crate::survey::{check_record, what_record};

/// How often, on average, a byte may be looked at in the search for records. A record costs
/// two looks at most; only forged bytes need more.
const LOOKS_AT_A_BYTE: u64 = 64;
/// How much of a file is searched at a time.
const WINDOW_BYTES: u64 = 32 << 20;

/// The newest whole record of each value, by the number of its commit.
#[derive(Default)]
pub(crate) struct Salvage {
    meta: Option<(u64, WorldMeta)>,
    /// The state of a world up to version 6.
    state: Option<(u64, WorldState)>,
    /// Records of things, of whatever kind, and chunks of charts that only a later game knows, by their keys.
    others: BTreeMap<(Kind, Vec<u8>), Packed>,
    /// Keys of things that the index led to, but to a damaged record.
    damaged_things: BTreeSet<Vec<u8>>,
    /// Whether the index led to everything: what it did not lead to is gone then, and not lost.
    by_index: bool,
    /// Chunks as they were packed, which is a small part of what they are unpacked.
    chunks: BTreeMap<ChunkKey, Packed>,
    /// The last commit that the index led to, or that anything tells of.
    last: u64,
    /// Chunks that the index led to, but to a damaged record.
    damaged: Vec<ChunkKey>,
    newer: Option<u16>,
    /// How many bytes of the file were searched, if not all.
    searched: Option<u64>,
}

/// A record as it was sealed; a chunk's is known to unpack.
struct Packed {
    sequence: u64,
    version: u16,
    body: Vec<u8>,
}

impl Packed {
    fn of(record: &Record<'_>) -> Self {
        Self {
            sequence: record.sequence,
            version: record.version,
            body: record.body.to_vec(),
        }
    }

    /// The same, sealed anew under its key.
    fn put(&self, kind: Kind, key: &[u8], sequence: u64) -> Put {
        Put {
            kind,
            key: key.to_vec(),
            bytes: Some(codec::seal(self.version, kind, key, sequence, &self.body)),
        }
    }
}

impl Salvage {
    /// What the world is, if that was found.
    pub(crate) fn meta(&self) -> Option<&WorldMeta> {
        self.meta.as_ref().map(|(_, meta)| meta)
    }

    /// How many chunks were found.
    pub(crate) fn chunks(&self) -> usize {
        self.chunks.len()
    }

    /// Whether the state was found.
    pub(crate) fn has_state(&self) -> bool {
        let player = RecordKind::Player.numbered(0).to_bytes();
        let is_there = self.others.contains_key(&(Kind::Record, player));
        is_there || (!self.has_things() && self.state.is_some())
    }

    fn has_things(&self) -> bool {
        self.others.keys().any(|(kind, _)| *kind == Kind::Record)
    }

    /// The meta record as [`Self::write`] stores it.
    pub(crate) fn sealed_meta(&self, meta: &WorldMeta) -> Result<Vec<u8>, StorageError> {
        let put = batch::sealed_meta(meta, codec::next_commit(self.last), &meta.name)?;
        Ok(put.bytes.unwrap_or_default())
    }

    /// Reads by the index if that can be trusted, changing nothing; then searches the bare
    /// bytes for what the index did not lead to. A file that cannot be trusted is never
    /// opened. Whoever asks keeps others from writing to it.
    pub(crate) fn of(path: &Path, world: &str) -> Result<Self, StorageError> {
        let mut salvage = Self::default();
        let by_index = salvage.scan(path, world)?;
        // With a whole index, what is newer than its last commit was never committed.
        salvage.by_index = by_index;
        let last = if by_index && salvage.last > 0 {
            salvage.last
        } else {
            u64::MAX
        };
        let carved = carve_file(path, |record| {
            if record.sequence <= last {
                salvage.add(record);
            }
        });
        salvage.searched = StorageError::at("Reading", path, carved)?;
        match salvage.newer {
            Some(found) => Err(StorageError::Newer {
                world: world.to_owned(),
                found,
            }),
            None => Ok(salvage),
        }
    }

    /// Takes what the index leads to; false if it did not lead to everything.
    fn scan(&mut self, path: &Path, world: &str) -> Result<bool, StorageError> {
        let scanned = Store::open_to_read(path, world).and_then(|store| {
            store.scan(|raw| match codec::unseal(&raw.bytes) {
                Ok(record) if record.key == raw.key => self.add(&record),
                _ if raw.kind == Kind::Record => {
                    self.damaged_things.insert(raw.key);
                }
                _ if raw.kind == Kind::Chunk => {
                    self.damaged.extend(ChunkKey::from_bytes(&raw.key));
                }
                _ => {}
            })
        });
        match scanned {
            Ok(()) => Ok(true),
            Err(error) if error.is_damage() => Ok(false),
            Err(error) => Err(error),
        }
    }

    /// Takes a record if it is readable and newer than what there is.
    fn add(&mut self, record: &Record<'_>) {
        let added = match record.kind {
            Kind::Meta => newest(&mut self.meta, record, META_KEY.as_bytes()),
            Kind::State => newest(&mut self.state, record, STATE_KEY.as_bytes()),
            Kind::Chunk => self.add_chunk(record),
            Kind::Record => self.add_thing(record),
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
        if let Some(key) = ChunkKey::from_bytes(record.key) {
            let known = self.chunks.get(&key);
            if known.is_none_or(|known| record.sequence > known.sequence) {
                ChunkBody::upgrade(record.version, record.body)?;
                self.chunks.insert(key, Packed::of(record));
            }
            Ok(())
        } else if ChunkKey::is_of_named_chart(record.key) {
            self.add_other(record);
            Ok(())
        } else {
            Err(SchemaFault::Damaged("its key is no chunk's".to_owned()))
        }
    }

    /// Takes the record of a thing, of whatever kind and version.
    fn add_thing(&mut self, record: &Record<'_>) -> Result<(), SchemaFault> {
        check_record(record, record.key)?;
        // What a whole index does not lead to was taken away.
        if !self.by_index || self.damaged_things.contains(record.key) {
            self.add_other(record);
        }
        Ok(())
    }

    fn add_other(&mut self, record: &Record<'_>) {
        let key = (record.kind, record.key.to_vec());
        let known = self.others.get(&key);
        if known.is_none_or(|known| record.sequence > known.sequence) {
            self.others.insert(key, Packed::of(record));
        }
    }

    fn loss_of_thing(&self, key: &[u8]) -> String {
        let what = what_record(key);
        match self.others.get(&(Kind::Record, key.to_vec())) {
            Some(Packed { sequence, .. }) => {
                format!("What is known of {what} is of commit {sequence}; what came later is lost.")
            }
            None => format!("What was known of {what} is lost."),
        }
    }

    /// Writes what was found into a new store, closed when this returns.
    pub(crate) fn write(&self, path: &Path, meta: &WorldMeta) -> Result<(), StorageError> {
        let sequence = codec::next_commit(self.last);
        let mut puts = vec![batch::sealed_meta(meta, sequence, &meta.name)?];
        let others = self.others.iter();
        puts.extend(others.map(|((kind, key), packed)| packed.put(*kind, key, sequence)));
        if let Some((_, state)) = self.state.as_ref().filter(|_| !self.has_things()) {
            for (key, record) in state.to_records() {
                puts.push(batch::sealed_record(
                    key,
                    Some(&record),
                    sequence,
                    &meta.name,
                )?);
            }
        }
        puts.extend(self.chunks.iter().filter_map(|(key, packed)| {
            let ChunkBody(samples) = ChunkBody::upgrade(packed.version, &packed.body).ok()?;
            let body = crate::pack_chunk(&samples).ok()?;
            Some(batch::sealed_chunk(*key, sequence, &body))
        }));
        Store::create(path, &meta.name)?.write(&puts)
    }

    pub(crate) fn losses(&self, problems: &[String]) -> Vec<String> {
        let mut losses: Vec<_> = self
            .damaged
            .iter()
            .map(|key| match self.chunks.get(key) {
                Some(Packed { sequence, .. }) => format!(
                    "The edits of {key} are those of commit {sequence}; later ones are lost."
                ),
                None => format!("The edits of {key} are lost; it is as the seed made it."),
            })
            .collect();
        let things = self.damaged_things.iter();
        losses.extend(things.map(|key| self.loss_of_thing(key)));
        if !self.by_index && self.has_things() {
            losses.push("What was taken away or had died may be there again.".to_owned());
        }
        if !self.has_state() {
            losses.push(
                "The player's place and belongings are lost; the player starts anew.".to_owned(),
            );
        }
        if let Some(bytes) = self.searched {
            losses.push(format!(
                "Behind byte {bytes} the file was not searched, because it pretends to hold more than any can; what is there is lost."
            ));
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
fn newest<T: Versioned>(
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

/// Hands over every intact record in the bytes of a file, however long that is; one
/// may come twice. How many bytes were searched, if they made too much work for all.
fn carve_file(path: &Path, mut each: impl FnMut(&Record<'_>)) -> io::Result<Option<u64>> {
    let (mut file, length) = regular::open(path)?;
    let mut budget = length.saturating_mul(LOOKS_AT_A_BYTE);
    let mut window = Vec::new();
    let mut before = 0;
    loop {
        let read = file.by_ref().take(WINDOW_BYTES).read_to_end(&mut window)?;
        if let ControlFlow::Break(at) = codec::carve(&window, &mut budget, &mut each) {
            return Ok(Some(before + at as u64));
        }
        if read == 0 {
            return Ok(None);
        }
        // A record that this window cut begins among the bytes that stay.
        let done = window.len().saturating_sub(codec::MAX_RECORD_BYTES);
        window.drain(..done);
        before += done as u64;
    }
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;
    use std::fs;

    #[test]
    fn records_are_found_across_the_windows_of_a_long_file() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("file");
        let long = vec![7; 900_000];
        let mut bytes = Vec::new();
        for (sequence, before) in [(1, 100), (2, WINDOW_BYTES as usize - 500_000), (3, 9)] {
            bytes.resize(bytes.len() + before, 0);
            bytes.extend(codec::seal(1, Kind::Chunk, b"key", sequence, &long));
        }
        fs::write(&path, &bytes).unwrap();
        let mut found = Vec::new();
        let searched = carve_file(&path, |record| found.push(record.sequence)).unwrap();
        assert_eq!(searched, None, "all of it");
        found.dedup();
        assert_eq!(found, [1, 2, 3]);
    }
}
