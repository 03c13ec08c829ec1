//! The list of everything that reads bytes of others.

mod archive;
mod chunk_codec;
mod room;
mod room_archive;
mod script;
mod settings;
pub(crate) mod store;
mod summary;

use fastrand::Rng;

/// How far an input came.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Seen {
    /// Every checksum was right, or there are none.
    pub past_checksums: bool,
    /// It was taken for what it claims to be.
    pub taken: bool,
}

/// Something that reads bytes of others.
#[derive(Clone, Copy)]
pub struct Target {
    /// What it is called; in `fuzz/` its folders are called so.
    pub name: &'static str,
    /// Reads an input. A sentence, if something was broken that must hold for any input.
    pub run: fn(&[u8]) -> Result<Seen, String>,
    /// Inputs to begin with, each with the name of its file in the corpus.
    pub seeds: fn() -> Vec<(String, Vec<u8>)>,
    /// Another input, made from one of the seeds.
    pub mutate: fn(&mut Rng, &[u8]) -> Vec<u8>,
}

/// Every target, in the order in which they are run.
pub static TARGETS: &[Target] = &[
    settings::TARGET,
    script::TARGET,
    chunk_codec::TARGET,
    summary::TARGET,
    archive::TARGET,
    store::TARGET,
    room::TARGET,
    room_archive::TARGET,
];

/// The target of that name.
pub fn target(name: &str) -> Option<&'static Target> {
    TARGETS.iter().find(|target| target.name == name)
}

/// `Err` with the sentence, where something that must hold does not.
pub(crate) fn must(holds: bool, sentence: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(sentence()) }
}
