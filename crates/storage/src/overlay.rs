//! A store's file that is only read: what the store writes on opening and closing stays in memory, so that a world
//! can be looked through where nothing can be written, and is not changed where it can.

use std::collections::BTreeMap;
use std::fmt;
use std::fs::File;
use std::io;
use std::ops::Bound;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use redb::backends::FileBackend;
use redb::{BackendError, DatabaseError, StorageBackend};

/// What is written is kept in blocks of so many bytes.
const BLOCK_BYTES: u64 = 4096;

/// A file below, what was written above it.
pub(crate) struct Overlay {
    file: FileBackend,
    above: Mutex<Above>,
}

struct Above {
    /// How much of the file still shows.
    below_bytes: u64,
    /// Length of the whole.
    bytes: u64,
    blocks: BTreeMap<u64, Box<[u8]>>,
}

impl fmt::Debug for Overlay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Overlay").finish_non_exhaustive()
    }
}

impl Overlay {
    /// Opens a file for reading. An empty one is [`io::ErrorKind::InvalidData`]: no store is made of it.
    pub(crate) fn over(path: &Path) -> Result<Self, DatabaseError> {
        let file = FileBackend::new(File::open(path)?)?;
        let bytes = file.len()?;
        if bytes == 0 {
            return Err(io::Error::from(io::ErrorKind::InvalidData).into());
        }
        Ok(Self {
            file,
            above: Mutex::new(Above {
                below_bytes: bytes,
                bytes,
                blocks: BTreeMap::new(),
            }),
        })
    }

    fn above(&self) -> MutexGuard<'_, Above> {
        self.above.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Reads from the file; zeros where it no longer shows.
    fn read_below(&self, above: &Above, offset: u64, out: &mut [u8]) -> io::Result<()> {
        let shown = above
            .below_bytes
            .saturating_sub(offset)
            .min(out.len() as u64);
        let (shown, rest) = out.split_at_mut(shown as usize);
        rest.fill(0);
        if shown.is_empty() {
            return Ok(());
        }
        self.file.read(offset, shown)
    }
}

/// The parts of a range that lie in one block each: the block, where it begins in it, its place in the range.
fn parts(offset: u64, bytes: usize) -> impl Iterator<Item = (u64, usize, std::ops::Range<usize>)> {
    let mut done = 0;
    std::iter::from_fn(move || {
        let at = offset + done as u64;
        let within = at % BLOCK_BYTES;
        let part = done..bytes.min(done + (BLOCK_BYTES - within) as usize);
        done = part.end;
        (!part.is_empty()).then_some((at / BLOCK_BYTES, within as usize, part))
    })
}

impl StorageBackend for Overlay {
    fn len(&self) -> io::Result<u64> {
        Ok(self.above().bytes)
    }

    fn read(&self, offset: u64, out: &mut [u8]) -> io::Result<()> {
        let above = self.above();
        if offset
            .checked_add(out.len() as u64)
            .is_none_or(|end| end > above.bytes)
        {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        self.read_below(&above, offset, out)?;
        for (block, within, part) in parts(offset, out.len()) {
            if let Some(written) = above.blocks.get(&block) {
                let bytes = part.len();
                out[part].copy_from_slice(&written[within..within + bytes]);
            }
        }
        Ok(())
    }

    fn write(&self, offset: u64, data: &[u8]) -> io::Result<()> {
        let mut above = self.above();
        for (block, within, part) in parts(offset, data.len()) {
            if !above.blocks.contains_key(&block) {
                let mut bytes = vec![0; BLOCK_BYTES as usize];
                self.read_below(&above, block * BLOCK_BYTES, &mut bytes)?;
                above.blocks.insert(block, bytes.into_boxed_slice());
            }
            if let Some(written) = above.blocks.get_mut(&block) {
                written[within..within + part.len()].copy_from_slice(&data[part]);
            }
        }
        above.bytes = above.bytes.max(offset + data.len() as u64);
        Ok(())
    }

    fn set_len(&self, bytes: u64) -> io::Result<()> {
        let mut above = self.above();
        if bytes < above.bytes {
            above.below_bytes = above.below_bytes.min(bytes);
            above.blocks.split_off(&bytes.div_ceil(BLOCK_BYTES));
            let within = (bytes % BLOCK_BYTES) as usize;
            if let Some(last) = above.blocks.get_mut(&(bytes / BLOCK_BYTES)) {
                last[within..].fill(0);
            }
        }
        above.bytes = bytes;
        Ok(())
    }

    fn sync_data(&self) -> io::Result<()> {
        Ok(())
    }

    fn close(&self) -> io::Result<()> {
        self.file.close()
    }

    // Whoever plays has the file for themselves; those who look share it.
    fn try_lock_range(&self, start: Bound<u64>, end: Bound<u64>) -> Result<bool, BackendError> {
        self.file.try_lock_shared_range(start, end)
    }

    fn try_lock_shared_range(
        &self,
        start: Bound<u64>,
        end: Bound<u64>,
    ) -> Result<bool, BackendError> {
        self.file.try_lock_shared_range(start, end)
    }

    fn unlock_range(&self, start: Bound<u64>, end: Bound<u64>) -> Result<(), BackendError> {
        self.file.unlock_range(start, end)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn what_is_written_is_read_again_and_the_file_stays() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("file");
        let before: Vec<u8> = (0..10_000_u32).map(|i| i as u8).collect();
        std::fs::write(&path, &before).unwrap();
        let overlay = Overlay::over(&path).unwrap();
        let mut model = before.clone();
        for (offset, bytes) in [(0, 1), (4090, 12), (8192, 4096), (9999, 3000), (20_000, 5)] {
            let data = vec![0xa5; bytes];
            overlay.write(offset as u64, &data).unwrap();
            model.resize(model.len().max(offset + bytes), 0);
            model[offset..offset + bytes].copy_from_slice(&data);
        }
        for length in [12_345, 5000, 14_000] {
            overlay.set_len(length as u64).unwrap();
            model.resize(length, 0);
            let mut read = vec![1; length];
            overlay.read(0, &mut read).unwrap();
            assert!(read == model, "{length}");
            assert!(overlay.read(1, &mut read).is_err());
        }
        assert_eq!(std::fs::read(&path).unwrap(), before);
    }
}
