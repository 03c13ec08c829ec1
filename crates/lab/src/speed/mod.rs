//! What accuracy costs: nanoseconds beside errors for every formula the game could have used, and frame times of
//! the same scene in every space.

pub(crate) mod clock;
mod columns;
mod cpu;
mod culling;
mod distance;
mod equal;
mod gpu;
mod inputs;
mod lamps;
mod library;
mod moves;
mod normals;
mod pareto;
mod passes;
mod pictures;
mod port;
mod quality;
pub(crate) mod scenes;
pub(crate) mod shadows;
pub(crate) mod stage;
mod vertex_stage;
mod view;

pub use cpu::cpu_section;
pub use gpu::gpu_section;
pub use pareto::{Group, Variant, frontier};

use antipode_render::AdapterChoice;

use crate::{Effort, LabError, Section};

/// Everything there is to measure: the processor's section and the adapter's.
///
/// # Errors
/// When there is no such adapter, it fails, or the fixed scene cannot be made.
pub fn run(effort: Effort, adapter: AdapterChoice) -> Result<Vec<Section>, LabError> {
    Ok(vec![cpu_section(effort), gpu_section(effort, adapter)?])
}
