//! The terrain suites: how fast ground is made, meshed, loaded, changed and kept, each figure beside its bar and
//! beside what other programs take.
//!
//! Everything is driven through the interfaces that the game itself uses, without an adapter but for what is said to
//! be drawn.

mod bullets;
mod clock;
mod control;
mod detail;
mod edits;
mod engine;
mod field;
mod flight;
mod loading;
mod memory;
mod meshing;
#[cfg(feature = "rivals")]
mod rivals;
mod row;
mod strokes;
mod versus;

pub use field::field_section;
pub use meshing::mesh_section;

pub(crate) use engine::{radius_m, settle};

use antipode_render::Gpu;

use crate::{Effort, LabError, Section};

/// What every section of these suites has at the beginning of its name.
pub const PREFIX: &str = "terrain-";

/// What the suites leave behind besides their sections.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Logs {
    /// The flight, one line a frame, CSV.
    pub flight: String,
}

/// A suite.
pub type Suite = fn(Effort, Option<&Gpu>, &mut Logs) -> Result<Section, LabError>;

/// Every suite in the order of running. Memory comes first, while the program holds little else.
pub const SUITES: &[Suite] = &[
    |effort, _, _| memory::section(effort),
    |effort, _, _| Ok(field_section(effort)),
    |effort, _, _| Ok(mesh_section(effort)),
    |effort, _, _| loading::section(effort),
    |effort, _, _| edits::section(effort),
    |effort, _, logs| {
        let (section, log) = flight::section(effort)?;
        logs.flight = log;
        Ok(section)
    },
    |effort, _, _| bullets::section(effort),
    |effort, gpu, _| detail::section(effort, gpu),
];
