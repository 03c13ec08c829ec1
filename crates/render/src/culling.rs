//! Which chunks a frame shows, nearest first, so that what is hidden is never shaded.

use antipode_scene::frame::Frame;

use crate::chunk_store::{ChunkStore, GpuChunk};
use crate::uniforms::ChunkInstance;

/// A chunk to draw.
#[derive(Debug)]
pub struct Visible<'a> {
    /// Its buffers.
    pub chunk: &'a GpuChunk,
    /// Where it stands.
    pub instance: ChunkInstance,
    /// Whether it reaches over the equator and must be trimmed there.
    pub at_rim: bool,
    distance_m: f64,
}

/// The chunks in the picture and before the fog, nearest first.
pub fn visible<'a>(store: &'a ChunkStore, frame: &Frame) -> Vec<Visible<'a>> {
    let strategy = frame.strategy.as_ref();
    let frustum = strategy.frustum(&frame.eye, &frame.projection);
    let fog_m = f64::from(frame.fog_distance_m);
    let mut list: Vec<_> = store
        .iter()
        .filter_map(|(coord, chunk)| {
            let (min, max) = (
                coord.origin() + chunk.min.as_dvec3(),
                coord.origin() + chunk.max.as_dvec3(),
            );
            let cell = frustum.cell_seen(strategy, &frame.eye, coord.hemisphere, min, max)?;
            if cell.nearest_m > fog_m {
                return None;
            }
            let reference = strategy.reference(&frame.eye, coord.hemisphere);
            Some(Visible {
                chunk,
                instance: ChunkInstance::new(coord.origin(), coord.hemisphere, reference),
                at_rim: strategy.trims(&frame.eye, coord.hemisphere, min, max),
                distance_m: cell.nearest_m,
            })
        })
        .collect();
    list.sort_by(|a, b| a.distance_m.total_cmp(&b.distance_m));
    list
}
