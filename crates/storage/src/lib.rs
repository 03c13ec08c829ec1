//! What is on disk: versioned schema, atomic writes, recovery.
//!
//! A world is a directory `<saves>/<slug>/`:
//!
//! | file | what it holds |
//! |---|---|
//! | `world.redb` | everything, in one embedded ACID store ([`WorldStore`]) |
//! | `thumbnail.png` | a picture for the menu, may be absent |
//! | `summary.bin` | a copy of the meta record: lists a world that is in use, names one that is damaged |
//! | `*.damaged-N` | what a repair has kept of the file it replaced |
//!
//! Every stored value is a sealed record: schema version, checksum, its own key,
//! the number of the commit that wrote it. So a flipped bit is noticed before it
//! is believed, and records can be salvaged from a file whose index is lost.
//! Nothing here knows how terrain is generated; a chunk is 32 768 numbers, and as
//! many bytes where kinds of ground were laid.

mod archive;
mod atomic_file;
mod batch;
mod chunk_codec;
mod codec;
mod copying;
mod error;
mod guard;
mod listing;
mod maintenance;
mod name;
mod named_folders;
mod opening;
mod overlay;
mod page_check;
#[cfg(test)]
mod power_cut;
mod record;
mod record_shapes;
mod regular;
mod salvage;
mod saves;
mod schema;
mod schema_history;
mod scratch;
mod slug;
mod state;
mod store;
mod summary;
mod survey;
mod transfer;
mod turn;
mod world;

pub use archive::{ArchiveKind, pack as pack_archive, unpack as unpack_archive};
pub use batch::Batch;
pub use chunk_codec::{CHUNK_SAMPLES, pack_chunk, pack_ground, unpack_chunk, unpack_ground};
pub use error::StorageError;
pub use guard::is_guarded;
pub use listing::{LookError, WorldInfo, WorldSummary, holds_world, is_saves_dir_named, saves_dir};
pub use maintenance::{RepairReport, VerifyReport};
pub use name::{
    MAX_NAME_CHARS, NameError, check as check_name, folded as folded_name, free_name,
    is_unprintable,
};
pub use named_folders::{NamedFolders, make_file, new_file, read_file, replace_file};
pub use page_check::check_pages;
pub use record::{Record, RecordChanges, RecordKey, RecordKind, Records};
pub use saves::SavesDir;
pub use schema::{
    BotRecord, CarRecord, ChunkKey, CourseRecord, DropRecord, EarthRecord, FelledRecord,
    FixtureRecord, FlagRecord, LampRecord, PlaceRecord, PlantedRecord, PlayerKept, PlayerRecord,
    SCHEMA_VERSION, SlotRecord, StoredGround, ViewRecord, WorldMeta, WorldState,
};
pub use scratch::{Scratch, sweep};
pub use slug::{ROOMS_FOLDER, is_reserved_name, slug_of};
pub use transfer::{ArchiveFile, archives_in};
pub use turn::Turn;
pub use world::WorldStore;

/// Name of the store inside a world's directory.
pub const WORLD_FILE: &str = "world.redb";
/// Name of the menu picture inside a world's directory.
pub const THUMBNAIL_FILE: &str = "thumbnail.png";
/// A longer file is no menu picture, and nothing reads it.
pub(crate) const MAX_THUMBNAIL_BYTES: u64 = 16 << 20;
/// File name extension of an exported world, without the dot.
pub const ARCHIVE_EXTENSION: &str = "antipode-world";
