//! A world's store written anew, record by record, while it is open.
//!
//! A copy of the file would need the store to be closed, and another process could
//! open it in between. One read transaction sees one commit, whatever comes after,
//! and what it hands over leaves the free pages behind. Records are copied as they
//! are sealed: one that is damaged stays damaged, and says so in the copy too.

use std::fs;
use std::path::Path;

use crate::error::StorageError;
use crate::store::{Put, Raw, Store};
use crate::{MAX_THUMBNAIL_BYTES, THUMBNAIL_FILE, WORLD_FILE, regular};

/// How much is gathered before it is written, bytes.
const BATCH_BYTES: usize = 4 << 20;

/// Records on their way.
struct Copy<'a> {
    target: &'a Store,
    puts: Vec<Put>,
    bytes: usize,
    failure: Option<StorageError>,
}

/// Copies every record of `source`, the store of the world called `world` in
/// `source_dir`, and the menu picture beside it into the empty directory `target_dir`.
pub(crate) fn copy(
    source: &Store,
    source_dir: &Path,
    target_dir: &Path,
    world: &str,
) -> Result<(), StorageError> {
    let target = Store::create(&target_dir.join(WORLD_FILE), world)?;
    let mut copy = Copy {
        target: &target,
        puts: Vec::new(),
        bytes: 0,
        failure: None,
    };
    let scanned = source.scan(|raw| copy.take(raw));
    copy.write();
    if let Some(failure) = copy.failure {
        return Err(failure);
    }
    scanned?;
    drop(target);
    copy_picture(source_dir, target_dir)
}

impl Copy<'_> {
    fn take(&mut self, raw: Raw) {
        self.bytes += raw.bytes.len();
        self.puts.push(raw.into());
        if self.bytes >= BATCH_BYTES {
            self.write();
        }
    }

    /// Writes what has gathered; after a failure nothing more.
    fn write(&mut self) {
        self.bytes = 0;
        let puts = std::mem::take(&mut self.puts);
        if self.failure.is_none() {
            self.failure = self.target.write(&puts).err();
        }
    }
}

/// Copies the menu picture if there is one that could be shown: a file of the world's own, since a link may lead to
/// what its owner would not give away.
fn copy_picture(source_dir: &Path, target_dir: &Path) -> Result<(), StorageError> {
    let Ok(picture) = regular::read_own(&source_dir.join(THUMBNAIL_FILE), MAX_THUMBNAIL_BYTES)
    else {
        return Ok(());
    };
    let path = target_dir.join(THUMBNAIL_FILE);
    StorageError::at("Writing", &path, fs::write(&path, picture))
}
