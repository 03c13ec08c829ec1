//! Which tile a point lies in.

use glam::DVec4;

use super::{EDGE_TANH, Frame, Isometry, Side, TilingError};

/// How far past an edge, in X/W, a point still counts as being this side of it. A point on an edge may lie past it by a
/// rounding as seen from either tile, and would go to and fro.
const MARGIN: f64 = 1e-14;
/// W of the farthest point whose tile is looked for: 13.8 radii away, where a coordinate's last place is 1e-4 radii.
const FARTHEST_W: f64 = 5e5;
/// More steps than lead to any point as near as that: each tile crossed is nearer to the point, and there are not so many
/// beside the line to it.
const MOST_STEPS: usize = 128;

/// The tile that a point lies in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The tile.
    pub frame: Frame,
    /// From coordinates in the tile asked to those in that tile, exactly: for the point, and for directions there.
    pub way: Isometry,
    /// The point in that tile's frame, (X, Y, Z, W) in radii.
    pub point: DVec4,
}

impl Frame {
    /// The tile that a point lies in, from its (X, Y, Z, W) in radii in the frame of this one. Its height does not matter.
    ///
    /// A point on an edge or a corner, to 1e-14 radii, is in each of the tiles that meet there: it is found in this one if
    /// it is one of them, and else in the first that the steps lead to, which go over the edge that the point is farthest
    /// past, over the one of the least number if past two alike.
    ///
    /// # Errors
    /// [`TilingError::NoPoint`] for what is no point of the space; [`TilingError::OutOfReach`] for one more than 13.8
    /// radii away, or where there is no tile any more.
    pub fn place(&self, point: DVec4) -> Result<Place, TilingError> {
        let level = point.x.hypot(point.z);
        if !point.is_finite() || level >= point.w {
            return Err(TilingError::NoPoint);
        }
        if point.w > FARTHEST_W {
            return Err(TilingError::OutOfReach);
        }
        let mut place = Place {
            frame: *self,
            way: Isometry::IDENTITY,
            point,
        };
        for _ in 0..MOST_STEPS {
            let Some(side) = over(place.point) else {
                return Ok(place);
            };
            let next = place.frame.neighbour(side)?;
            let crossing = Isometry::crossing(next.back, side)?;
            // Step by step: what is over an edge by more than roundings is within it in the next tile.
            place = Place {
                frame: next.frame,
                way: crossing.times(&place.way)?,
                point: crossing.lorentz() * place.point,
            };
        }
        Err(TilingError::NoPoint)
    }
}

/// The side that a point is past, if any.
fn over(point: DVec4) -> Option<Side> {
    let along = [point.x, point.z, -point.x, -point.z];
    let most = along.into_iter().fold(f64::NEG_INFINITY, f64::max);
    if most <= (EDGE_TANH + MARGIN) * point.w {
        return None;
    }
    let number = along.iter().position(|it| *it == most)?;
    Side::ALL.get(number).copied()
}
