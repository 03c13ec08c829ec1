//! Statistics of a frame's plan.

use serde::Serialize;

use super::choice::{ChunkChoice, DepthMethod, Port};
use super::land::ChunkLand;

/// What the planner chose for a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PlanStats {
    /// Chunks ported as a whole, by one matrix.
    pub chunks_by_frame: usize,
    /// Chunks ported vertex by vertex.
    pub chunks_by_vertex: usize,
    /// Chunks with edges halved near the eye.
    pub chunks_refined: usize,
    /// Chunks whose fragments find their own depth.
    pub chunks_fragment_depth: usize,
    /// Chunks drawn at each level of detail, the finest first.
    pub chunks_by_level: [usize; 4],
    /// Chunks that blend from one level to another.
    pub chunks_blending: usize,
    /// Figures ported as a whole, by one matrix.
    pub figures_by_frame: usize,
    /// Figures ported vertex by vertex.
    pub figures_by_vertex: usize,
    /// Figures out of the picture, of which at most the shadow is drawn.
    pub figures_outside: usize,
    /// Triangles out of the picture or behind the fog: of chunks, and of blocks of those with edges halved.
    pub triangles_outside: usize,
    /// Triangles of chunks behind nearer land.
    pub triangles_hidden: usize,
    /// Triangles of chunks that rise over nearer land by less than the tolerance.
    pub triangles_small: usize,
    /// Triangles that halving edges added.
    pub triangles_added: usize,
    /// The largest error that these choices cause in the frame, pixels.
    pub error_px: f64,
    /// What the levels of detail are off by in the frame, pixels: 99 of 100 places of the land less.
    pub level_error_px: f64,
}

impl PlanStats {
    pub(crate) fn error_at_least(&mut self, px: f64) {
        self.error_px = self.error_px.max(px);
    }

    pub(super) fn level_error_at_least(&mut self, px: f64) {
        self.level_error_px = self.level_error_px.max(px);
    }

    pub(super) fn count(&mut self, chunk: &ChunkChoice, land: &ChunkLand) {
        self.chunks_by_level[land.level.index() % 4] += 1;
        match &chunk.port {
            Port::Vertex => self.chunks_by_vertex += 1,
            Port::Frame(_) => self.chunks_by_frame += 1,
        }
        self.error_at_least(chunk.error_px);
        self.chunks_fragment_depth += usize::from(chunk.depth == DepthMethod::Fragment);
    }
}
