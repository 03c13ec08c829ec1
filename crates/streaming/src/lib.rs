//! Chunk streaming: joins terrain, storage and colliders away from the main thread.
//!
//! The game holds one [`Streamer`]. It never locks, touches the disk or builds a mesh: it schedules
//! what is wanted against what is there, and exchanges messages with named chunk workers
//! (`antipode-chunk-N`) and one saver (`antipode-save`) over bounded channels.
//!
//! - Loads go nearest first and in view first; only a few are handed to each worker at a time, so
//!   that a load that is no longer wanted costs nothing and an edit never waits behind a queue.
//! - An edit over several chunks is a batch: all its meshes and colliders come in one
//!   [`Update::Edited`], or none. Strokes made while a batch is under way add up for the next.
//! - Commits run on the saver alone, since waiting for the disk must never delay an edit.
//!
//! - Which chunks are to be there, and at which level of detail, is planned on a worker too, from
//!   the size of the land in the picture ([`Detail`]). Only the ground that bodies reach
//!   ([`Reach`]) is solid, that is, has colliders and samples; it is always in full resolution.
//!
//! What keeps a picture free of gaps: the edits of the world carry a revision that rises by one
//! with each batch; a loaded chunk says which revision it was made from, is held back until that
//! batch is shown, and is made again when a batch shown since has touched it.

mod api;
mod bases;
mod batch_job;
mod edit_backend;
mod edit_store;
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
mod worker;
mod worker_pool;

#[cfg(test)]
mod tests;

pub use api::{Cause, Chunk, Config, Detail, Reach, StreamingError, Until, Update, Wish};
pub use range::is_in_world;
pub use streamer::Streamer;
