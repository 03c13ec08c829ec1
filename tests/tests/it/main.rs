//! What takes the whole program: scripts, worlds on the disk, and the shaders' numbers.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod beam;
mod car;
mod denied;
mod dust;
mod edits;
mod faults;
mod geometry_gpu;
mod long_files;
mod maps;
mod marker;
mod npc;
mod pictures;
mod presets;
mod purity;
mod room_pictures;
mod rooms;
mod saves;
mod scenario;
mod seam;
mod settings;
mod soak;
mod things;
mod tiled;
