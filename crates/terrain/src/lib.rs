//! Scalar field, biomes, edits, brushes and marching cubes.
//!
//! Everything here is a pure function of the world's seed, a chunk and its edits;
//! nothing reads a file, a clock or a thread. Lengths are metres of a chart
//! ([`antipode_geometry`]), `y` is up, and a value below zero is solid ground.
//!
//! A chunk becomes a mesh in four steps: [`Field::content`] says whether it can hold
//! surface at all, [`Field::samples`] fills its block with one sample of border,
//! [`apply_edits`] adds what players dug and built, and [`march`] meshes the result.

mod biome;
mod carve;
mod caves;
mod climate;
mod colour;
mod content;
mod cover;
mod crossings;
mod earth;
mod edits;
mod field;
mod fixed;
mod form;
mod fractal;
mod generator;
mod kind;
mod lattice;
mod level;
mod light;
mod loops;
mod maker;
mod march;
mod memo;
mod mesh;
mod region;
mod relief;
mod samples;
mod seam;
mod shape;
mod sites;
mod stock;
mod strata;
mod stroke;
mod tables;
mod thing;
mod tilted;
mod tint;
mod tracts;
mod tuft;
mod undo;
mod upright;
mod wide;

pub use biome::Biome;
pub use content::Content;
pub use cover::Cover;
pub use earth::{Cells, Earth, Moved, Owners, changed_cells};
pub use edits::{ChunkEdits, EDIT_LIMIT_M, EDIT_STEP, EditsError, apply_edits};
pub use field::{FIELD_BAND_M, Field, RIM_REACH_M};
pub use generator::Generator;
pub use kind::Kind;
pub use level::Level;
pub use march::{Mesher, march};
pub use mesh::{ChunkMesh, PARTS_PER_M, UNITS_PER_M, Vertex};
pub use samples::{SAMPLES, Samples};
pub use shape::Shape;
pub use stock::Stock;
pub use stroke::{FALLOFF_PER_M2, Gate, Ground, Part, Stroke};
pub use thing::{FIRST_PLANTED, Footing, Thing};
pub use tuft::Tuft;
pub use undo::SampleChange;
