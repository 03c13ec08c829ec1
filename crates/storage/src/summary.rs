//! `summary.bin`: a copy of the meta record beside the store, so that a world in
//! use can be listed, one damaged can be named, and a repair knows its seed.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use crate::atomic_file;
use crate::codec::{self, MAX_RECORD_BYTES};
use crate::regular;
use crate::schema::{self, SchemaFault, WorldMeta};
use crate::store::META_KEY;

const SUMMARY_FILE: &str = "summary.bin";

/// Where the copy is or would be.
pub(crate) fn path(dir: &Path) -> PathBuf {
    dir.join(SUMMARY_FILE)
}

/// Writes the copy. Failing is no failure of the save: the store holds the original.
pub(crate) fn write(dir: &Path, sealed_meta: &[u8]) {
    if let Err(error) = replace(dir, sealed_meta) {
        tracing::warn!(dir = %dir.display(), %error, "the world's summary was not written");
    }
}

/// Writes the copy.
pub(crate) fn replace(dir: &Path, sealed_meta: &[u8]) -> io::Result<()> {
    atomic_file::replace(&path(dir), sealed_meta)
}

/// Removes copies that a killed process of an earlier build had not put in place yet: files under the name that one
/// had until then, and with the game's own seal. Only whoever has the world open may ask.
pub(crate) fn sweep(dir: &Path) {
    for entry in fs::read_dir(dir).into_iter().flatten().flatten() {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        let name = entry.file_name();
        let process = name.to_str().and_then(|name| {
            name.strip_prefix(SUMMARY_FILE)?
                .strip_prefix('.')?
                .strip_suffix(".tmp")
        });
        if !is_file || process.is_none_or(|process| process.parse::<u32>().is_err()) {
            continue;
        }
        let bytes = regular::read_own(&entry.path(), MAX_RECORD_BYTES as u64).unwrap_or_default();
        if codec::unseal(&bytes).is_ok_and(|record| record.key == META_KEY.as_bytes()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Whether anything stands in its place, readable or not.
pub(crate) fn is_there(dir: &Path) -> bool {
    fs::symlink_metadata(path(dir)).is_ok()
}

/// Reads the copy: `None` if there is none or it is damaged.
pub(crate) fn read(dir: &Path) -> Option<WorldMeta> {
    schema::read(&bytes(dir).ok()?, META_KEY.as_bytes()).ok()
}

/// The version of the copy, if a newer game wrote it.
pub(crate) fn newer_version(dir: &Path) -> Option<u16> {
    let bytes = bytes(dir).ok()?;
    match codec::unseal(&bytes)
        .map(|record| schema::check::<WorldMeta>(&record, META_KEY.as_bytes()))
    {
        Ok(Err(SchemaFault::Newer(version))) => Some(version),
        _ => None,
    }
}

/// What is wrong with the copy, as a sentence; a missing one is no fault.
pub(crate) fn fault(dir: &Path) -> Option<String> {
    let reason = match bytes(dir) {
        Ok(bytes) => match schema::read::<WorldMeta>(&bytes, META_KEY.as_bytes()) {
            Ok(_) | Err(SchemaFault::Newer(_)) => return None,
            Err(SchemaFault::Damaged(reason)) => reason,
        },
        Err(error) if error.kind() == ErrorKind::NotFound => return None,
        Err(error) => error.to_string(),
    };
    Some(format!(
        "The summary {} cannot be used: {reason}. `antipode saves repair` writes it anew from the save.",
        path(dir).display()
    ))
}

fn bytes(dir: &Path) -> io::Result<Vec<u8>> {
    regular::read(&path(dir), MAX_RECORD_BYTES as u64)
}
