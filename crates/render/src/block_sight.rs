//! Which blocks of the meshes of chunks a picture shows, so that the others can be left out.

use std::f64::consts::PI;

use antipode_frame::Frame;
use antipode_geometry::{ChunkCoord, Frustum};

use crate::parts::Block;
use crate::plan::Tolerance;
use crate::shadow::Caster;

/// What a frame sees.
pub struct BlockSight<'a> {
    /// The frame.
    pub frame: &'a Frame,
    frustum: Frustum,
    /// Whether blocks that are not seen may be left out.
    hides: bool,
}

impl<'a> BlockSight<'a> {
    /// Of a frame. Close to the far side of a closed world the drawn edges leave the cells in which their blocks are seen,
    /// and so all blocks are shown there.
    pub fn of(frame: &'a Frame) -> Self {
        let (space, eye) = (frame.view.strategy.as_ref(), &frame.view.eye);
        let is_open = space.sight_limit_m(eye) >= PI * space.radius_at_m(eye);
        let hides = Tolerance::of(frame.view.quality).hides;
        Self {
            frame,
            frustum: space.frustum(eye, &frame.view.projection),
            hides: hides && is_open && !frame.view.is_moved(),
        }
    }

    /// The box of a block of a chunk, if it is to be drawn.
    pub fn shown(&self, coord: ChunkCoord, block: &Block) -> Option<Caster> {
        let [min, max] = [block.min, block.max].map(|p| coord.origin() + p.as_dvec3());
        let (space, eye) = (self.frame.view.strategy.as_ref(), &self.frame.view.eye);
        let is_seen = || {
            let cell = self.frustum.cell_seen(space, eye, coord.chart, min, max);
            cell.is_some()
        };
        let is_shown = !self.hides || is_seen();
        is_shown.then(|| Caster::new(coord.chart, min, max))
    }
}
