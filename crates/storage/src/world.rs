//! One world on disk: opens it, reads it and commits to it.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError, RwLock};

use crate::batch::{Batch, sealed_meta, sealed_record};
use crate::codec::{self, Kind};
use crate::error::StorageError;
use crate::maintenance::free_beside;
use crate::record::{RecordKind, Records};
use crate::regular::{Entry, FileId};
use crate::schema::{
    self, ChunkBody, ChunkKey, SCHEMA_VERSION, SchemaFault, StoredGround, WorldMeta, WorldState,
};
use crate::store::{META_KEY, Put, STATE_KEY, Store};
use crate::survey::{Known, fault_in, survey};
use crate::{THUMBNAIL_FILE, WORLD_FILE, atomic_file, copying, scratch, summary};

/// An open world. Reading and committing are possible from several threads; one
/// commit runs at a time. The world is closed when this is dropped.
pub struct WorldStore {
    dir: PathBuf,
    /// The file that was opened, wherever it is now.
    file: FileId,
    // None after a failed commit, until the next use opens it again.
    store: RwLock<Option<Store>>,
    known: Mutex<Known>,
    /// Number of the last commit; held during one. Apart from `known`, so that
    /// reading never waits for the disk.
    sequence: Mutex<u64>,
    /// Whether the damaged file has been kept beside this one.
    kept: AtomicBool,
}

impl std::fmt::Debug for WorldStore {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("WorldStore")
            .field("dir", &self.dir)
            .finish_non_exhaustive()
    }
}

impl WorldStore {
    /// Makes a new world in `dir`, which is made too if need be.
    ///
    /// # Errors
    /// [`StorageError::Exists`] if there is a world already; failures of the file system.
    pub fn create(dir: &Path, meta: &WorldMeta) -> Result<Self, StorageError> {
        StorageError::at("Making", dir, fs::create_dir_all(dir))?;
        let path = dir.join(WORLD_FILE);
        let store = Store::create(&path, &meta.name)?;
        let world = Self {
            dir: dir.to_path_buf(),
            file: file_at(&path)?,
            store: RwLock::new(Some(store)),
            known: Mutex::new(Known::of(meta.clone(), SCHEMA_VERSION)),
            sequence: Mutex::new(0),
            kept: AtomicBool::new(false),
        };
        world.commit(&Batch {
            meta: Some(meta.clone()),
            ..Batch::default()
        })?;
        atomic_file::sync_dir(dir);
        Ok(world)
    }

    /// Opens a world and looks at every record in it. Damaged chunks and a damaged
    /// state do not keep it from opening; see [`Self::problems`].
    ///
    /// # Errors
    /// [`StorageError::InUse`] if it is open anywhere, [`StorageError::Newer`],
    /// [`StorageError::NotFound`], [`StorageError::NoStore`],
    /// [`StorageError::Unreadable`] or [`StorageError::Damaged`] if it cannot be told
    /// what world it is.
    pub fn open(dir: &Path) -> Result<Self, StorageError> {
        let world = Self::open_by(dir, Store::open)?;
        summary::sweep(dir);
        scratch::sweep(dir);
        Ok(world)
    }

    /// The same for reading alone: nothing on disk is changed, nor need it be writable.
    pub(crate) fn open_to_read(dir: &Path) -> Result<Self, StorageError> {
        Self::open_by(dir, Store::open_to_read)
    }

    fn open_by(
        dir: &Path,
        opener: fn(&Path, &str) -> Result<Store, StorageError>,
    ) -> Result<Self, StorageError> {
        let path = store_path(dir)?;
        let label = label(dir);
        let store = opener(&path, &label)?;
        // Asked after opening, which may move a file of a layered file system.
        let file = file_at(&path)?;
        let (known, sequence) = survey(&store, &label)?;
        Ok(Self {
            dir: dir.to_path_buf(),
            file,
            store: RwLock::new(Some(store)),
            known: Mutex::new(known),
            sequence: Mutex::new(sequence),
            kept: AtomicBool::new(false),
        })
    }

    /// The world's directory.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// What the world is, as last committed.
    pub fn meta(&self) -> WorldMeta {
        self.known().meta.clone()
    }

    /// What was found damaged on opening, a sentence each; empty for a sound world.
    pub fn problems(&self) -> Vec<String> {
        let faults = self.faults();
        faults.iter().map(ToString::to_string).collect()
    }

    /// What was found damaged on opening.
    pub(crate) fn faults(&self) -> Vec<StorageError> {
        let known = self.known();
        let places = known.faults.keys();
        places
            .filter_map(|(kind, key)| known.fault(*kind, key))
            .collect()
    }

    /// All that changes but the land in one value; `None` in a world never played.
    ///
    /// # Errors
    /// [`StorageError::Damaged`] if what is stored of the player cannot be believed, failures of the file system.
    pub fn state(&self) -> Result<Option<WorldState>, StorageError> {
        let records = self.records()?;
        if records.player().is_some() {
            return Ok(Some(WorldState::of_records(&records.known)));
        }
        let known = self.known();
        let player = RecordKind::Player.numbered(0).to_bytes();
        let fault = known.fault(Kind::Record, &player);
        let fault = fault.or_else(|| known.fault(Kind::State, STATE_KEY.as_bytes()));
        fault.map_or(Ok(None), Err)
    }

    /// The records of what changes. Those that are damaged are left out; see [`Self::problems`].
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn records(&self) -> Result<Records, StorageError> {
        let mut records = Records::default();
        let old = self.with_store(|store| store.value(STATE_KEY))?;
        if let Some(state) = old.as_deref().and_then(old_state) {
            for (key, record) in state.to_records() {
                records.put(key, record);
            }
        }
        self.with_store(|store| store.scan_records(|raw| records.take(&raw)))?;
        Ok(records)
    }

    /// Copies the file as it is now to a free name beside it, before something in it that cannot be read is written
    /// over: a repair may still find an older whole one there. Returns where.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn keep_copy(&self) -> Result<PathBuf, StorageError> {
        let file = self.dir.join(WORLD_FILE);
        let kept = free_beside(&file);
        StorageError::at("Keeping", &kept, atomic_file::copy(&file, &kept))?;
        self.kept.store(true, Ordering::Relaxed);
        Ok(kept)
    }

    /// The edits of a chunk; `None` if it was never edited.
    ///
    /// # Errors
    /// [`StorageError::Damaged`] if its record cannot be believed: go on with the
    /// chunk as generated, and say so. Failures of the file system.
    pub fn chunk(&self, key: &ChunkKey) -> Result<Option<Vec<i16>>, StorageError> {
        Ok(self.chunk_with_kinds(key)?.map(|(samples, _)| samples))
    }

    /// As [`Self::chunk`], with a byte for each sample that tells of the kind of ground laid there; none where nobody laid
    /// any.
    ///
    /// # Errors
    /// As [`Self::chunk`].
    pub fn chunk_with_kinds(&self, key: &ChunkKey) -> Result<Option<StoredGround>, StorageError> {
        let stored = key.to_bytes();
        let name = {
            let known = self.known();
            if let Some(fault) = known.fault(Kind::Chunk, &stored) {
                return Err(fault);
            }
            known.meta.name.clone()
        };
        let bytes = self.with_store(|store| store.chunk(&stored))?;
        bytes
            .map(|bytes| schema::read(&bytes, &stored))
            .transpose()
            .map(|chunk| chunk.map(|ChunkBody(samples, kinds)| (samples, kinds)))
            .map_err(|fault| fault_in(&name, &key.to_string(), fault))
    }

    /// Every chunk that was ever edited, in order.
    ///
    /// # Errors
    /// [`StorageError::Unreadable`] if the index is damaged, failures of the file system.
    pub fn edited_chunks(&self) -> Result<Vec<ChunkKey>, StorageError> {
        let mut keys = Vec::new();
        self.with_store(|store| {
            keys.clear();
            store.scan(|raw| {
                if raw.kind == Kind::Chunk {
                    keys.extend(ChunkKey::from_bytes(&raw.key));
                }
            })
        })?;
        Ok(keys)
    }

    /// Writes a batch in one durable transaction. When this returns, `kill -9` and a
    /// power cut leave it whole; when it fails, the world is as before, and calling
    /// again (after making space, say) tries again.
    ///
    /// # Errors
    /// [`StorageError::DiskFull`], [`StorageError::NotWritable`] and other failures
    /// of the file system; [`StorageError::Unstorable`] for a chunk of a wrong size;
    /// [`StorageError::Vanished`] if the file is no longer in the world's directory,
    /// where a commit would be of no use to anyone.
    pub fn commit(&self, batch: &Batch) -> Result<(), StorageError> {
        if batch.is_empty() {
            return Ok(());
        }
        self.check_place()?;
        let mut last = self.sequence.lock().unwrap_or_else(PoisonError::into_inner);
        let sequence = codec::next_commit(*last);
        let is_old = self.known().version < SCHEMA_VERSION;
        let mut puts = if is_old {
            self.brought_up(sequence)?
        } else {
            Vec::new()
        };
        puts.extend(batch.puts(sequence, &self.meta().name)?);
        self.keep_damaged(&puts)?;
        if let Err(error) = self.with_store(|store| store.write(&puts)) {
            // After a failed write the store refuses everything until it is opened again.
            *self.store.write().unwrap_or_else(PoisonError::into_inner) = None;
            return Err(error);
        }
        *last = sequence;
        self.note_committed(batch, &puts);
        // Gone meanwhile, it took the commit with it.
        self.check_place()?;
        let meta = puts.iter().rfind(|put| put.kind == Kind::Meta);
        if let Some(bytes) = meta.and_then(|put| put.bytes.as_ref()) {
            summary::write(&self.dir, bytes);
        }
        Ok(())
    }

    /// What makes a world of an older version one of today, whatever a batch changes besides. An older game is to find
    /// out by the first record that the world is none of its own any more.
    fn brought_up(&self, sequence: u64) -> Result<Vec<Put>, StorageError> {
        let meta = self.meta();
        let mut puts = vec![sealed_meta(&meta, sequence, &meta.name)?];
        if let Some(bytes) = self.with_store(|store| store.value(STATE_KEY))? {
            puts.push(Put {
                kind: Kind::State,
                key: STATE_KEY.as_bytes().to_vec(),
                bytes: None,
            });
            let state = old_state(&bytes);
            for (key, record) in state.iter().flat_map(WorldState::to_records) {
                puts.push(sealed_record(key, Some(&record), sequence, &meta.name)?);
            }
        }
        Ok(puts)
    }

    /// Keeps the file as it is before something in it that cannot be believed is written over.
    fn keep_damaged(&self, puts: &[Put]) -> Result<(), StorageError> {
        let overwrites = {
            let known = self.known();
            let mut places = known.faults.keys();
            places.any(|(kind, key)| puts.iter().any(|put| put.is_at(*kind, key)))
        };
        if overwrites && !self.kept.load(Ordering::Relaxed) {
            self.keep_copy()?;
        }
        Ok(())
    }

    fn note_committed(&self, batch: &Batch, puts: &[Put]) {
        let mut known = self.known();
        known
            .faults
            .retain(|(kind, key), _| !puts.iter().any(|put| put.is_at(*kind, key)));
        if let Some(meta) = &batch.meta {
            known.meta = meta.clone();
        }
        known.version = SCHEMA_VERSION;
    }

    /// Refuses to go on if the open file is no longer the one in the directory: the
    /// system would go on writing to a deleted file without a word.
    fn check_place(&self) -> Result<(), StorageError> {
        let path = self.dir.join(WORLD_FILE);
        if file_at(&path)? == self.file {
            Ok(())
        } else {
            Err(StorageError::Vanished { path })
        }
    }

    /// Writes the menu picture, replacing the old one.
    ///
    /// # Errors
    /// [`StorageError::Vanished`], failures of the file system.
    pub fn write_thumbnail(&self, png: &[u8]) -> Result<(), StorageError> {
        self.check_place()?;
        let path = self.dir.join(THUMBNAIL_FILE);
        StorageError::at("Writing", &path, atomic_file::replace(&path, png))
    }

    /// Writes all that was committed, and the menu picture, into the empty directory `dir`.
    pub(crate) fn copy_to(&self, dir: &Path) -> Result<(), StorageError> {
        let name = self.known().meta.name.clone();
        self.with_store(|store| copying::copy(store, &self.dir, dir, &name))
    }

    /// The sealed meta record as stored, for the summary.
    pub(crate) fn sealed_meta(&self) -> Result<Vec<u8>, StorageError> {
        let bytes = self.with_store(|store| store.value(META_KEY))?;
        bytes.ok_or_else(|| {
            let missing = SchemaFault::Damaged("it is missing".to_owned());
            fault_in(&self.meta().name, "what the world is", missing)
        })
    }

    /// Runs `work` on the store, opening it first if a failed commit has closed it.
    fn with_store<T>(
        &self,
        work: impl FnOnce(&Store) -> Result<T, StorageError>,
    ) -> Result<T, StorageError> {
        if let Some(store) = self
            .store
            .read()
            .unwrap_or_else(PoisonError::into_inner)
            .as_ref()
        {
            return work(store);
        }
        let mut slot = self.store.write().unwrap_or_else(PoisonError::into_inner);
        let store = if let Some(store) = slot.take() {
            store
        } else {
            self.check_place()?;
            Store::open(&self.dir.join(WORLD_FILE), &label(&self.dir))?
        };
        work(slot.insert(store))
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Where the store of the world in `dir` is, if it is a file.
///
/// # Errors
/// [`StorageError::NotFound`] if `dir` holds no world, [`StorageError::NoStore`] or
/// [`StorageError::Newer`] if all that is left is its summary or something else is
/// in the store's place.
pub(crate) fn store_path(dir: &Path) -> Result<PathBuf, StorageError> {
    let path = dir.join(WORLD_FILE);
    let what = match StorageError::at("Reading", &path, Entry::at(&path))? {
        Entry::File { .. } => return Ok(path),
        Entry::Missing if !summary::is_there(dir) => {
            return Err(StorageError::NotFound {
                world: label(dir),
                dir: dir.parent().unwrap_or(dir).to_path_buf(),
            });
        }
        Entry::Missing => "is missing".to_owned(),
        Entry::Other(kind) => format!("is {kind}, not a file"),
    };
    Err(match summary::newer_version(dir) {
        Some(found) => StorageError::Newer {
            world: label(dir),
            found,
        },
        None => StorageError::NoStore {
            path,
            what,
            rebuildable: summary::read(dir).is_some(),
        },
    })
}

/// Which file is at `path` where an open world's should be.
fn file_at(path: &Path) -> Result<FileId, StorageError> {
    let file = StorageError::at("Reading", path, FileId::at(path))?;
    file.ok_or_else(|| StorageError::Vanished {
        path: path.to_path_buf(),
    })
}

/// What to call a world whose name is not known yet.
pub(crate) fn label(dir: &Path) -> String {
    summary::read(dir).map_or_else(
        || {
            dir.file_name().map_or_else(
                || dir.display().to_string(),
                |name| name.to_string_lossy().into_owned(),
            )
        },
        |meta| meta.name,
    )
}

/// The state of a world up to version 6, if it can be believed.
fn old_state(bytes: &[u8]) -> Option<WorldState> {
    schema::read(bytes, STATE_KEY.as_bytes()).ok()
}
