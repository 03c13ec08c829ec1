//! The contents of one commit, and their sealing.

use std::collections::BTreeMap;

use crate::codec::{self, Kind};
use crate::error::StorageError;
use crate::pack_ground;
use crate::record::{Record, RecordChanges, RecordKey};
use crate::schema::{ChunkKey, SCHEMA_VERSION, WorldMeta};
use crate::store::{META_KEY, Put};

/// What one commit writes: all of it or none.
#[derive(Debug, Clone, Default)]
pub struct Batch {
    /// The new meta record, if it changed.
    pub meta: Option<WorldMeta>,
    /// Records that changed, and those of what is gone.
    pub records: RecordChanges,
    /// Edited chunks with their [`crate::CHUNK_SAMPLES`] edits each; one that has none any more, without
    /// samples, loses its record.
    pub chunks: Vec<(ChunkKey, Vec<i16>)>,
    /// Of those chunks in which kinds of ground were laid, a byte for each sample.
    pub kinds: BTreeMap<ChunkKey, Vec<u8>>,
}

impl Batch {
    /// Whether there is nothing to write.
    pub fn is_empty(&self) -> bool {
        self.meta.is_none() && self.records.is_empty() && self.chunks.is_empty()
    }

    /// What it does to the store of the world called `world`.
    pub(crate) fn puts(&self, sequence: u64, world: &str) -> Result<Vec<Put>, StorageError> {
        let mut puts = Vec::new();
        if let Some(meta) = &self.meta {
            puts.push(sealed_meta(meta, sequence, world)?);
        }
        for (key, record) in &self.records {
            puts.push(sealed_record(*key, record.as_ref(), sequence, world)?);
        }
        for (key, samples) in &self.chunks {
            let kinds = self.kinds.get(key).map_or(&[][..], Vec::as_slice);
            if samples.is_empty() {
                puts.push(Put {
                    kind: Kind::Chunk,
                    key: key.to_bytes(),
                    bytes: None,
                });
                continue;
            }
            let body = pack_ground(samples, kinds)
                .map_err(|reason| unstorable(world, &key.to_string(), reason))?;
            puts.push(sealed_chunk(*key, sequence, &body));
        }
        Ok(puts)
    }
}

/// Seals what a world is, for the world called `world`.
pub(crate) fn sealed_meta(
    meta: &WorldMeta,
    sequence: u64,
    world: &str,
) -> Result<Put, StorageError> {
    let body =
        codec::encode(meta).map_err(|fault| unstorable(world, META_KEY, fault.to_string()))?;
    let key = META_KEY.as_bytes().to_vec();
    let bytes = codec::seal(SCHEMA_VERSION, Kind::Meta, &key, sequence, &body);
    Ok(Put {
        kind: Kind::Meta,
        key,
        bytes: Some(bytes),
    })
}

/// Seals the record of a thing, or removes it.
pub(crate) fn sealed_record(
    key: RecordKey,
    record: Option<&Record>,
    sequence: u64,
    world: &str,
) -> Result<Put, StorageError> {
    let stored = key.to_bytes();
    let unstorable = |reason| unstorable(world, &key.to_string(), reason);
    let bytes = match record {
        Some(record) if record.kind() != key.kind => {
            return Err(unstorable(format!("it is a {}", record.kind().name())));
        }
        Some(record) => {
            let body = (record.encoded()).map_err(|fault| unstorable(fault.to_string()))?;
            let version = key.kind.version();
            Some(codec::seal(version, Kind::Record, &stored, sequence, &body))
        }
        None => None,
    };
    Ok(Put {
        kind: Kind::Record,
        key: stored,
        bytes,
    })
}

/// Seals the packed edits of a chunk.
pub(crate) fn sealed_chunk(key: ChunkKey, sequence: u64, body: &[u8]) -> Put {
    let key = key.to_bytes();
    let bytes = codec::seal(SCHEMA_VERSION, Kind::Chunk, &key, sequence, body);
    Put {
        kind: Kind::Chunk,
        key,
        bytes: Some(bytes),
    }
}

fn unstorable(world: &str, what: &str, reason: String) -> StorageError {
    StorageError::Unstorable {
        world: world.to_owned(),
        what: what.to_owned(),
        reason,
    }
}
