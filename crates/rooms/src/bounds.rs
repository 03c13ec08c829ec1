//! How large, how many and how long what stands in a room may be. Files come from strangers: every count and length
//! has a bound that no room made by hand comes near.

use std::ops::RangeInclusive;

/// The longest `room.ron`, bytes.
pub const MOST_ROOM_BYTES: u64 = 2 << 20;
/// The longest file under `models/`, bytes.
pub const MOST_MODEL_BYTES: u64 = 32 << 20;
/// The longest file under `textures/`, bytes.
pub const MOST_TEXTURE_BYTES: u64 = 16 << 20;
/// The longest archive, bytes.
pub const MOST_ARCHIVE_BYTES: u64 = 32 << 20;
/// What all files of a room may have together, bytes.
pub const MOST_FOLDER_BYTES: u64 = 128 << 20;
/// How many files a room may have, `room.ron` among them; as many as an archive can count.
pub const MOST_FILES: usize = 255;
/// The widest and highest texture, pixels.
pub const LARGEST_TEXTURE_PX: u32 = 4096;
/// All pixels of all textures of a room together, those of models not among them.
pub const MOST_PIXELS: u64 = 32 << 20;

/// How many objects a room may have.
pub const MOST_OBJECTS: usize = 2000;
/// How many of them may be aberrations.
pub const MOST_ABERRATIONS: usize = 256;
/// How many of them may be portals.
pub const MOST_PORTALS: usize = 64;
/// Corners of a portal's polygon.
pub const CORNERS: RangeInclusive<usize> = 3..=16;
/// How many of them may be lights.
pub const MOST_LIGHTS: usize = 8;
/// How many of them may be loose.
pub const MOST_LOOSE: usize = 100;
/// How many different models a room may have.
pub const MOST_MODELS: usize = 64;
/// How many triangles one model may have.
pub const MOST_MODEL_TRIANGLES: usize = 200_000;
/// How many triangles all solids of a room may have together.
pub const MOST_TRIANGLES: usize = 1_000_000;
/// How many aberrations may lie in one another, and how many groups.
pub const MOST_DEEP: usize = 8;

/// The longest name of an object, characters.
pub const MOST_NAME_CHARS: usize = 40;
/// The longest sentence, characters.
pub const MOST_TEXT_CHARS: usize = 240;

/// How far from the origin anything may be, metres along each axis.
pub const FARTHEST_M: f64 = 1000.0;
/// Lengths of solids, metres.
pub const SIZES_M: RangeInclusive<f64> = 0.01..=1000.0;
/// Whole lengths of what is loose, metres.
pub const LOOSE_M: RangeInclusive<f64> = 0.1..=10.0;
/// Mass of what is loose, kilograms.
pub const MASSES_KG: RangeInclusive<f64> = 0.1..=10_000.0;
/// Half sizes of aberrations, metres.
pub const HALVES_M: RangeInclusive<f64> = 0.05..=500.0;
/// Felt metres for one metre of the scene.
pub const STRETCHES: RangeInclusive<f64> = 1.0 / 32.0..=32.0;
/// Turns, degrees.
pub const TURNS_DEG: RangeInclusive<f64> = -360.0..=360.0;
/// The steps of stairs.
pub const STEPS: RangeInclusive<u32> = 1..=200;
/// What a model may be scaled by.
pub const SCALES: RangeInclusive<f64> = 0.001..=1000.0;
/// Brightness of lights and of what glows; the noon sun is 1, and a light has its brightness at one metre.
pub const POWERS: RangeInclusive<f64> = 0.0..=1000.0;
/// Strength of gravity along each axis, metres per second squared.
pub const FASTEST_FALL_M_S2: f64 = 100.0;
