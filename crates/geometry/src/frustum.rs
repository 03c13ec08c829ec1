//! Culling: cells of directions against the pyramid that the picture shows.
//!
//! The pyramid's sides are totally geodesic sheets through the eye: planes through the eye in any
//! view coordinates. The test keeps whatever it cannot rule out.

use glam::DVec3;

use crate::sight::Side;
use crate::{ChartId, Eye, Optics, Projection, SightCell};

/// A cell is divided at most this often before it is taken as seen.
const DIVISIONS: u32 = 2;
/// A cell narrower than this to either side is not divided, in radians.
const NARROW_RAD: f64 = 0.12;

/// Inward unit normals of the sides of the picture's pyramid, in view coordinates.
pub fn side_normals(projection: &Projection) -> [DVec3; 4] {
    let (sx, sy) = (projection.sx, projection.sy);
    [
        DVec3::new(sx, 0.0, -1.0),
        DVec3::new(-sx, 0.0, -1.0),
        DVec3::new(0.0, sy, -1.0),
        DVec3::new(0.0, -sy, -1.0),
    ]
    .map(DVec3::normalize_or_zero)
}

/// The region that the picture shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frustum {
    /// The four sides, by their inward normals.
    sides: [Side; 4],
    /// Nothing farther than this is drawn, in metres of the space.
    limit_m: f64,
}

impl Frustum {
    /// The region that `projection` shows from `eye`, out to `limit_m` metres.
    pub fn new(eye: &Eye, projection: &Projection, limit_m: f64) -> Self {
        Self {
            sides: side_normals(projection).map(|side| Side::new(eye.to_chart(side))),
            limit_m,
        }
    }

    /// Whether anything in the cell may be in the picture. False only where nothing is.
    pub fn sees(&self, cell: &SightCell) -> bool {
        let behind = |side: &Side| cell.greatest(side) < 0.0;
        !cell.is_empty() && cell.nearest_m <= self.limit_m && !self.sides.iter().any(behind)
    }

    /// The cell of the chart box from `min` to `max` metres if anything of the box may be in the
    /// picture. Boxes seen at a wide angle are tried in parts, so that their corners do not count.
    pub fn cell_seen(
        &self,
        space: &dyn Optics,
        eye: &Eye,
        chart: ChartId,
        min: DVec3,
        max: DVec3,
    ) -> Option<SightCell> {
        let cell = space.sight_cell(eye, chart, min, max);
        let corners = [min, max];
        let seen = self.sees(&cell)
            && (cell.half_width_rad < NARROW_RAD
                || self.sees_a_part(space, eye, chart, corners, DIVISIONS));
        seen.then_some(cell)
    }

    fn sees_a_part(
        &self,
        space: &dyn Optics,
        eye: &Eye,
        chart: ChartId,
        [min, max]: [DVec3; 2],
        divisions: u32,
    ) -> bool {
        let half = 0.5 * (max - min);
        (0..4).any(|part| {
            let step = DVec3::new(f64::from(part % 2), 0.0, f64::from(part / 2)) * half;
            let low = min + step;
            let high = DVec3::new(low.x + half.x, max.y, low.z + half.z);
            let cell = space.sight_cell(eye, chart, low, high);
            self.sees(&cell)
                && (divisions == 1
                    || cell.half_width_rad < NARROW_RAD
                    || self.sees_a_part(space, eye, chart, [low, high], divisions - 1))
        })
    }
}
