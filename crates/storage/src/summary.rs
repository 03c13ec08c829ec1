//! `summary.bin`: a copy of the meta record beside the store, so that a world in
//! use can be listed, one damaged can be named, and a repair knows its seed.

use std::fs;
use std::path::Path;

use crate::atomic_file;
use crate::codec;
use crate::schema::{self, SchemaFault, WorldMeta};
use crate::store::META_KEY;

const SUMMARY_FILE: &str = "summary.bin";

/// Writes the copy. Failing is no failure of the save: the store holds the original.
pub(crate) fn write(dir: &Path, sealed_meta: &[u8]) {
    if let Err(error) = atomic_file::replace(&dir.join(SUMMARY_FILE), sealed_meta) {
        tracing::warn!(dir = %dir.display(), %error, "the world's summary was not written");
    }
}

/// Reads the copy: `None` if there is none or it is damaged.
pub(crate) fn read(dir: &Path) -> Option<WorldMeta> {
    schema::read(&fs::read(dir.join(SUMMARY_FILE)).ok()?, META_KEY.as_bytes()).ok()
}

/// The version of the copy, if a newer game wrote it.
pub(crate) fn newer_version(dir: &Path) -> Option<u16> {
    let bytes = fs::read(dir.join(SUMMARY_FILE)).ok()?;
    match codec::unseal(&bytes)
        .map(|record| schema::check::<WorldMeta>(&record, META_KEY.as_bytes()))
    {
        Ok(Err(SchemaFault::Newer(version))) => Some(version),
        _ => None,
    }
}
