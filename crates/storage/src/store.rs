//! The embedded store as this crate uses it: four tables of sealed records.
//!
//! The store trusts its file: so [`page_check`] reads every page before it is opened, and
//! every call goes through [`guard`] besides.

use std::path::{Path, PathBuf};

use redb::{
    Builder, Database, DatabaseError, ReadTransaction, ReadableDatabase, ReadableTable,
    ReadableTableMetadata, TableDefinition, TableError, WriteTransaction,
};

use crate::codec::Kind;
use crate::error::StorageError;
use crate::guard::guard;
use crate::opening::patiently;
use crate::overlay::Overlay;
use crate::page_check;
use crate::schema::ChunkKey;

/// What the world is, under `world`; up to version 6 also all that changes, under `state`.
pub(crate) const VALUES: TableDefinition<'static, &str, &[u8]> = TableDefinition::new("values");
/// One record per edited chunk of the two hemispheres.
pub(crate) const CHUNKS: TableDefinition<'static, &[u8; ChunkKey::BYTES], &[u8]> =
    TableDefinition::new("chunks");
/// Those of charts that have a name: see [`ChunkKey::is_of_named_chart`].
pub(crate) const NAMED: TableDefinition<'static, &[u8], &[u8]> = TableDefinition::new("land");
/// One record per thing, see [`crate::record`].
pub(crate) const RECORDS: TableDefinition<'static, &[u8], &[u8]> = TableDefinition::new("records");
/// Key of the [`crate::WorldMeta`].
pub(crate) const META_KEY: &str = "world";
/// Key of the state of worlds up to version 6.
pub(crate) const STATE_KEY: &str = "state";

/// Memory the store may keep pages in; it would take a gigabyte by itself.
const CACHE_BYTES: usize = 32 << 20;

const MISCOUNTED: &str = "its index does not hold as many chunks as it says";

/// A value as stored: which, under which key, its sealed bytes.
#[derive(Clone, Debug)]
pub(crate) struct Raw {
    /// What it should be, by the table it is in.
    pub kind: Kind,
    /// Its key.
    pub key: Vec<u8>,
    /// The sealed record.
    pub bytes: Vec<u8>,
}

/// What a transaction does to one key: another value, or none.
#[derive(Clone, Debug)]
pub(crate) struct Put {
    /// In which table it is.
    pub kind: Kind,
    /// Its key.
    pub key: Vec<u8>,
    /// The sealed record; `None` removes it.
    pub bytes: Option<Vec<u8>>,
}

impl Put {
    /// Whether it changes what is in that table under that key.
    pub(crate) fn is_at(&self, kind: Kind, key: &[u8]) -> bool {
        self.kind == kind && self.key == key
    }

    /// With its key, if it is one of [`VALUES`].
    fn value(&self) -> Option<(&str, &Self)> {
        let is_value = matches!(self.kind, Kind::Meta | Kind::State);
        let key = std::str::from_utf8(&self.key).ok()?;
        is_value.then_some((key, self))
    }

    /// With its key, if it is one of [`CHUNKS`].
    fn chunk(&self) -> Option<(&[u8; ChunkKey::BYTES], &Self)> {
        let key = self.key.as_slice().try_into().ok()?;
        (self.kind == Kind::Chunk).then_some((key, self))
    }

    /// With its key, if it is one of [`NAMED`].
    fn named_chunk(&self) -> Option<(&[u8], &Self)> {
        let is_named = self.kind == Kind::Chunk && self.chunk().is_none();
        is_named.then_some((self.key.as_slice(), self))
    }

    /// With its key, if it is one of [`RECORDS`].
    fn record(&self) -> Option<(&[u8], &Self)> {
        (self.kind == Kind::Record).then_some((self.key.as_slice(), self))
    }
}

impl From<Raw> for Put {
    fn from(raw: Raw) -> Self {
        Self {
            kind: raw.kind,
            key: raw.key,
            bytes: Some(raw.bytes),
        }
    }
}

/// An open store.
pub(crate) struct Store {
    path: PathBuf,
    /// The world's name, or its directory's until that is known.
    world: String,
    // Some until drop.
    db: Option<Database>,
    /// Leaves of records that were not as they were written when it was opened.
    torn_leaves: u64,
}

impl Store {
    /// Makes a store in a file that must not exist.
    pub(crate) fn create(path: &Path, world: &str) -> Result<Self, StorageError> {
        let file = std::fs::File::options()
            .read(true)
            .write(true)
            .create_new(true)
            .open(path);
        let file = StorageError::at("Making", path, file)?;
        let db = guard(path, || {
            let mut builder = Builder::new();
            builder
                .set_cache_size(CACHE_BYTES)
                .create_file(file)
                .map_err(|e| StorageError::store(path, world, e))
        })?;
        Ok(Self {
            path: path.to_path_buf(),
            world: world.to_owned(),
            db: Some(db),
            torn_leaves: 0,
        })
    }

    /// Opens a store, recovering it if it was not closed, if its every page can be trusted.
    pub(crate) fn open(path: &Path, world: &str) -> Result<Self, StorageError> {
        Self::opened(path, world, |builder| builder.open(path))
    }

    /// Opens a store to read it, if its every page can be trusted: the file is not changed, and
    /// need not be writable. It is shared with others who read, not with one who writes.
    pub(crate) fn open_to_read(path: &Path, world: &str) -> Result<Self, StorageError> {
        Self::opened(path, world, |builder| {
            builder.create_with_backend(Overlay::over(path)?)
        })
    }

    fn opened(
        path: &Path,
        world: &str,
        open: impl Fn(&mut Builder) -> Result<Database, DatabaseError>,
    ) -> Result<Self, StorageError> {
        let checked = patiently(|| page_check::check(path, world))?;
        // The check is dear and holds off whoever writes: what waits for others who look is not to repeat it.
        let db = patiently(|| {
            guard(path, || {
                open(Builder::new().set_cache_size(CACHE_BYTES))
                    .map_err(|e| StorageError::store(path, world, e))
            })
        })?;
        Ok(Self {
            path: path.to_path_buf(),
            world: world.to_owned(),
            db: Some(db),
            torn_leaves: checked.torn_leaves,
        })
    }

    /// How many leaves of records were not as they were written, but well formed, when it
    /// was opened: which records are damaged their seals tell.
    pub(crate) fn torn_leaves(&self) -> u64 {
        self.torn_leaves
    }

    fn db(&self) -> Result<&Database, StorageError> {
        self.db
            .as_ref()
            .ok_or_else(|| StorageError::unreadable(&self.path, "it has been closed"))
    }

    /// What an error of the store means for this world.
    fn error(&self, error: impl Into<redb::Error>) -> StorageError {
        StorageError::store(&self.path, &self.world, error)
    }

    /// The sealed bytes of one chunk.
    pub(crate) fn chunk(&self, key: &[u8]) -> Result<Option<Vec<u8>>, StorageError> {
        guard(&self.path, || {
            let read = self.db()?.begin_read().map_err(|e| self.error(e))?;
            let value = match key.try_into() {
                Ok(key) => value_of(&read, CHUNKS, key),
                Err(_) => value_of(&read, NAMED, key),
            };
            value.map_err(|e| self.error(e))
        })
    }

    /// The sealed bytes under one key of [`VALUES`].
    pub(crate) fn value(&self, key: &str) -> Result<Option<Vec<u8>>, StorageError> {
        guard(&self.path, || {
            let read = self.db()?.begin_read().map_err(|e| self.error(e))?;
            value_of(&read, VALUES, key).map_err(|e| self.error(e))
        })
    }

    /// Hands over every stored value in order of the keys. Ends with an error where
    /// the index is damaged, and where it has more entries than it says or their keys do not
    /// rise; what was handed over until then stands.
    pub(crate) fn scan(&self, mut each: impl FnMut(Raw)) -> Result<(), StorageError> {
        guard(&self.path, || {
            let read = self.db()?.begin_read().map_err(|e| self.error(e))?;
            for (kind, key) in [(Kind::Meta, META_KEY), (Kind::State, STATE_KEY)] {
                if let Some(bytes) = value_of(&read, VALUES, key).map_err(|e| self.error(e))? {
                    each(Raw {
                        kind,
                        key: key.as_bytes().to_vec(),
                        bytes,
                    });
                }
            }
            self.scan_table(&read, RECORDS, Kind::Record, |key| key.to_vec(), &mut each)?;
            self.scan_table(&read, CHUNKS, Kind::Chunk, |key| key.to_vec(), &mut each)?;
            self.scan_table(&read, NAMED, Kind::Chunk, |key| key.to_vec(), &mut each)
        })
    }

    /// Hands over the records of things alone, as [`Self::scan`] does.
    pub(crate) fn scan_records(&self, mut each: impl FnMut(Raw)) -> Result<(), StorageError> {
        guard(&self.path, || {
            let read = self.db()?.begin_read().map_err(|e| self.error(e))?;
            self.scan_table(&read, RECORDS, Kind::Record, |key| key.to_vec(), &mut each)
        })
    }

    fn scan_table<K: redb::Key + 'static>(
        &self,
        read: &ReadTransaction,
        table: TableDefinition<'static, K, &'static [u8]>,
        kind: Kind,
        bytes_of: for<'k> fn(K::SelfType<'k>) -> Vec<u8>,
        each: &mut impl FnMut(Raw),
    ) -> Result<(), StorageError> {
        let Some(table) = absent(read.open_table(table)).map_err(|e| self.error(e))? else {
            return Ok(());
        };
        let wrong = |reason| StorageError::unreadable(&self.path, reason);
        let mut left = table.len().map_err(|e| self.error(e))?;
        let mut last: Option<Vec<u8>> = None;
        for entry in table.iter().map_err(|e| self.error(e))? {
            let (key, value) = entry.map_err(|e| self.error(e))?;
            let key = bytes_of(key.value());
            left = left.checked_sub(1).ok_or_else(|| wrong(MISCOUNTED))?;
            // Or it may go on for ever: pages that name one another have no end.
            if last.as_ref().is_some_and(|last| *last >= key) {
                return Err(wrong("the keys of its index do not rise"));
            }
            last = Some(key.clone());
            each(Raw {
                kind,
                key,
                bytes: value.value().to_vec(),
            });
        }
        if left == 0 {
            Ok(())
        } else {
            Err(wrong(MISCOUNTED))
        }
    }

    /// Does all of this in one durable transaction, or nothing.
    pub(crate) fn write(&self, puts: &[Put]) -> Result<(), StorageError> {
        guard(&self.path, || {
            let write = self.db()?.begin_write().map_err(|e| self.error(e))?;
            self.put(&write, VALUES, puts.iter().filter_map(Put::value))?;
            self.put(&write, RECORDS, puts.iter().filter_map(Put::record))?;
            self.put(&write, CHUNKS, puts.iter().filter_map(Put::chunk))?;
            self.put(&write, NAMED, puts.iter().filter_map(Put::named_chunk))?;
            write.commit().map_err(|e| self.error(e))
        })
    }

    /// Opens a table only if there is something for it, since that makes it.
    fn put<'k, K: redb::Key + 'static>(
        &self,
        write: &WriteTransaction,
        table: TableDefinition<'static, K, &'static [u8]>,
        puts: impl Iterator<Item = (K::SelfType<'k>, &'k Put)>,
    ) -> Result<(), StorageError> {
        let mut puts = puts.peekable();
        if puts.peek().is_none() {
            return Ok(());
        }
        let mut table = write.open_table(table).map_err(|e| self.error(e))?;
        for (key, put) in puts {
            match &put.bytes {
                Some(bytes) => table.insert(key, bytes.as_slice()),
                None => table.remove(key),
            }
            .map_err(|e| self.error(e))?;
        }
        Ok(())
    }
}

#[cfg(test)]
impl Store {
    /// A store whose file is watched by a test.
    pub(crate) fn of(path: &Path, world: &str, db: Database) -> Self {
        Self {
            path: path.to_path_buf(),
            world: world.to_owned(),
            db: Some(db),
            torn_leaves: 0,
        }
    }
}

impl Drop for Store {
    fn drop(&mut self) {
        let db = self.db.take();
        // Closing writes; on a damaged file that may panic as reading may.
        let closed = guard(&self.path, || {
            drop(db);
            Ok(())
        });
        if closed.is_err() {
            tracing::warn!(path = %self.path.display(), "the save was not closed cleanly");
        }
    }
}

/// Reads the meta record without opening the store: `None` if the world was not closed
/// (its recovery writes) or holds none.
pub(crate) fn peek_meta(path: &Path, world: &str) -> Result<Option<Vec<u8>>, StorageError> {
    Ok(page_check::look(path, world)?.and_then(|look| look.meta))
}

/// How many chunks are stored, without opening the store: `None` if the world was not closed.
pub(crate) fn peek_chunk_count(path: &Path, world: &str) -> Result<Option<usize>, StorageError> {
    let look = page_check::look(path, world)?;
    Ok(look.map(|look| usize::try_from(look.chunks).unwrap_or(usize::MAX)))
}

fn value_of<K: redb::Key + 'static>(
    read: &ReadTransaction,
    table: TableDefinition<'static, K, &'static [u8]>,
    key: K::SelfType<'_>,
) -> Result<Option<Vec<u8>>, redb::Error> {
    let Some(table) = absent(read.open_table(table))? else {
        return Ok(None);
    };
    Ok(table.get(key)?.map(|value| value.value().to_vec()))
}

/// A table that nothing was written to yet does not exist; that is no error.
fn absent<T>(table: Result<T, TableError>) -> Result<Option<T>, TableError> {
    match table {
        Ok(table) => Ok(Some(table)),
        Err(TableError::TableDoesNotExist(_)) => Ok(None),
        Err(error) => Err(error),
    }
}
