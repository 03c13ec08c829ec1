//! Salvages records from a damaged store: by its index as far as possible, then by searching the raw bytes for
//! sealed records.

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
use crate::survey::{check_record, what_at};

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
    /// Records of things, of whatever kind and version, and edits of chunks, as they were packed: a small part of what
    /// they are unpacked. Those of charts that this version knows do unpack.
    found: BTreeMap<(Kind, Vec<u8>), Packed>,
    /// Where the index led to, but to a damaged record.
    damaged: BTreeSet<(Kind, Vec<u8>)>,
    /// Whether the index led to everything: what it did not lead to is gone then, and not lost.
    by_index: bool,
    /// The last commit that the index led to, or that anything tells of.
    last: u64,
    newer: Option<u16>,
    /// How many bytes of the file were searched, if not all.
    searched: Option<u64>,
}

/// A record as it was sealed.
struct Packed {
    sequence: u64,
    version: u16,
    body: Vec<u8>,
}

impl Packed {
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
        self.count(Kind::Chunk)
    }

    /// Whether the state was found.
    pub(crate) fn has_state(&self) -> bool {
        let player = RecordKind::Player.numbered(0).to_bytes();
        let is_there = self.found.contains_key(&(Kind::Record, player));
        is_there || self.old_state().is_some()
    }

    fn count(&self, kind: Kind) -> usize {
        self.found
            .keys()
            .filter(|(found, _)| *found == kind)
            .count()
    }

    /// The state of a world up to version 6, which no record has taken the place of.
    fn old_state(&self) -> Option<&WorldState> {
        let (_, state) = self.state.as_ref()?;
        (self.count(Kind::Record) == 0).then_some(state)
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
            store.scan(|raw| {
                let record = codec::unseal(&raw.bytes).ok();
                // One under a damaged key is whole, and tells its own.
                if let Some(record) = &record {
                    self.add(record);
                }
                let is_there = record.is_some_and(|record| record.key == raw.key);
                if !is_there && matches!(raw.kind, Kind::Chunk | Kind::Record) {
                    self.damaged.insert((raw.kind, raw.key));
                }
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
        if ChunkKey::from_bytes(record.key).is_some() {
            if self.is_newest(record) {
                ChunkBody::upgrade(record.version, record.body)?;
            }
        } else if !ChunkKey::is_of_named_chart(record.key) {
            return Err(SchemaFault::Damaged("its key is no chunk's".to_owned()));
        }
        self.keep(record);
        Ok(())
    }

    /// Takes the record of a thing, of whatever kind and version.
    fn add_thing(&mut self, record: &Record<'_>) -> Result<(), SchemaFault> {
        check_record(record, record.key)?;
        // What a whole index does not lead to was taken away.
        let place = (Kind::Record, record.key.to_vec());
        if !self.by_index || self.damaged.contains(&place) {
            self.keep(record);
        }
        Ok(())
    }

    fn is_newest(&self, record: &Record<'_>) -> bool {
        let known = self.found.get(&(record.kind, record.key.to_vec()));
        known.is_none_or(|known| record.sequence > known.sequence)
    }

    /// Keeps a record that is newer than what there is.
    fn keep(&mut self, record: &Record<'_>) {
        if self.is_newest(record) {
            let packed = Packed {
                sequence: record.sequence,
                version: record.version,
                body: record.body.to_vec(),
            };
            let place = (record.kind, record.key.to_vec());
            self.found.insert(place, packed);
        }
    }

    /// Writes what was found into a new store, closed when this returns.
    pub(crate) fn write(&self, path: &Path, meta: &WorldMeta) -> Result<(), StorageError> {
        let sequence = codec::next_commit(self.last);
        let mut puts = vec![batch::sealed_meta(meta, sequence, &meta.name)?];
        let found = self.found.iter();
        puts.extend(found.map(|((kind, key), packed)| packed.put(*kind, key, sequence)));
        for (key, record) in self.old_state().iter().flat_map(|it| it.to_records()) {
            puts.push(batch::sealed_record(
                key,
                Some(&record),
                sequence,
                &meta.name,
            )?);
        }
        Store::create(path, &meta.name)?.write(&puts)
    }

    pub(crate) fn losses(&self, problems: &[String]) -> Vec<String> {
        let loss = |place: &(Kind, Vec<u8>)| {
            let what = what_at(place.0, &place.1);
            let older = self.found.get(place).map(|it| it.sequence);
            match (place.0, older) {
                (Kind::Chunk, Some(commit)) => {
                    format!(
                        "The edits of {what} are those of commit {commit}; later ones are lost."
                    )
                }
                (Kind::Chunk, None) => {
                    format!("The edits of {what} are lost; it is as the seed made it.")
                }
                (_, Some(commit)) => format!(
                    "What is known of {what} is of commit {commit}; what came later is lost."
                ),
                (_, None) => format!("What was known of {what} is lost."),
            }
        };
        let mut losses: Vec<_> = self.damaged.iter().map(loss).collect();
        if !self.by_index && self.count(Kind::Record) > 0 {
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
