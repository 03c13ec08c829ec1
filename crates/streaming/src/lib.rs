//! Loads, edits and saves chunks away from the main thread. It joins terrain, storage and colliders.
//!
//! The game holds one [`Streamer`]. It tells it what is wanted ([`Streamer::wish`]), edits ([`Streamer::edit`]), and
//! takes finished work over ([`Streamer::poll`]). The streamer never locks, touches the disk or builds a mesh. It
//! exchanges messages with chunk workers (`antipode-chunk-N`) and one saver (`antipode-save`) over bounded channels.
//!
//! - The scheduler hands out loads, the nearest and those in view first, and only a few at a time. So a load that is
//!   no longer wanted costs nothing, and an edit never waits behind a queue.
//! - An edit of several chunks is a batch. All its meshes and colliders arrive in one [`Update::Edited`], or none do.
//!   Strokes that are made while a batch is in flight form the next batch.
//! - Only the saver commits, since waiting for the disk must never delay an edit.
//! - A worker also plans which chunks are to be there and at which level of detail, from the size of the land in the
//!   picture ([`Detail`]). Only ground that bodies can reach ([`Reach`]) is solid: it has colliders and samples, and
//!   always the full resolution.
//!
//! No gap ever appears in a picture. Each batch raises the revision of the world's edits by one. A loaded chunk names
//! the revision that it was made from. It is held back until that batch is shown, and it is made again if a batch that
//! was shown in the meantime has touched it.

mod api;
mod bases;
mod batch_job;
mod earthworks;
mod edit_backend;
mod edit_store;
mod gathered;
mod history;
mod levels;
mod maps;
mod outcome;
mod plan;
mod queue;
mod range;
mod reaches;
mod saver;
mod scheduler;
mod shared;
mod streamer;
mod strokes;
mod updates;
mod waiting;
mod within;
mod worker;
mod worker_pool;

#[cfg(test)]
mod tests;

pub use api::{
    Cause, Chunk, Config, Detail, NotUndone, Reach, StreamingError, Until, Update, Wish,
};
pub use edit_store::{Column, column_of};
pub use range::is_in_world;
pub use shared::BELOW_ROOT_M;
pub use streamer::Streamer;
