//! Chooses how one chunk is drawn: port, trimming, refinement and depth, from the frame's bounds.

use antipode_frame::Frame;

use super::bounds::{Affine, Bounds};
use super::quality::Tolerance;
use super::{Candidate, ChunkLand};

/// Longest edge of the land's triangles at full resolution, metres: the diagonal of a cell.
pub const LONGEST_EDGE_M: f64 = 1.733;

/// Measured beside L^2 k / 8: the most that depth strays in hyperbolic pictures, and in bent ones that close,
/// where it grows towards the far side.
const OPEN_DEPTH: f64 = 1.25;
const CLOSED_DEPTH: f64 = 4.0;

/// How vertices are carried into the space.
#[derive(Clone, Debug, PartialEq)]
pub enum Port {
    /// Each by the full port.
    Vertex,
    /// All by the port's first-order map about the chunk's middle.
    Frame(Affine),
}

/// Where depth comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthMethod {
    /// The triangle's corners, and straight between them.
    Vertex,
    /// Each fragment's own place.
    Fragment,
}

/// How a chunk is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct ChunkChoice {
    /// Its place in the list that was planned.
    pub place: usize,
    /// No point of it is nearer to the eye, metres of the space.
    pub distance_m: f64,
    /// How its vertices are ported.
    pub port: Port,
    /// Whether its land is drawn, too; else only what stands on it rises over nearer land.
    pub shows_land: bool,
    /// Whether it reaches beyond what its chart shows.
    pub trimmed: bool,
    /// Whether edges of it may stray by more than the tolerance, so that each is looked at.
    pub refine: bool,
    /// Where its depth comes from.
    pub depth: DepthMethod,
    /// The error of its frame or of its straight edges, pixels; 0 where that is found edge by edge.
    pub error_px: f64,
}

impl ChunkChoice {
    /// What is no chunk: carried vertex by vertex, and whole.
    pub const LOOSE: Self = Self {
        place: usize::MAX,
        distance_m: 0.0,
        port: Port::Vertex,
        shows_land: true,
        trimmed: false,
        refine: false,
        depth: DepthMethod::Vertex,
        error_px: 0.0,
    };
}

/// Chooses for one chunk.
pub fn choose(
    frame: &Frame,
    chunk: &ChunkLand,
    candidate: &Candidate,
    bounds: &Bounds,
    tolerance: &Tolerance,
) -> ChunkChoice {
    let trimmed =
        frame
            .view
            .strategy
            .trims(&frame.view.eye, chunk.coord.chart, chunk.min, chunk.max);
    let affine = bounds
        .affine(frame, chunk, tolerance.shape_px)
        .filter(|_| !trimmed);
    let near_m = Bounds::nearest_chart_m(frame, chunk);
    let longest_m = chunk.longest_edge_m();
    let refine = candidate.shows_land
        && affine.is_none()
        && near_m < bounds.refine_within_m(tolerance, longest_m);
    let (port, error_px) = match affine {
        Some((affine, error_px)) => (Port::Frame(affine), error_px),
        // Of refined chunks each edge is looked at.
        None if refine => (Port::Vertex, 0.0),
        None => (Port::Vertex, bounds.bend_px(near_m) * longest_m * longest_m),
    };
    ChunkChoice {
        place: candidate.place,
        distance_m: candidate.cell.nearest_m,
        shows_land: candidate.shows_land,
        refine,
        depth: match port {
            Port::Vertex => depth_method(frame, bounds, tolerance),
            Port::Frame(_) => DepthMethod::Vertex,
        },
        port,
        trimmed,
        error_px,
    }
}

/// Depth strays inside a triangle by at most the sag of its longest edge, L^2 k / 8: all of the hyperbolic
/// depth `(coth d - 1) / cos` but the last term is linear in the picture.
fn depth_method(frame: &Frame, bounds: &Bounds, tolerance: &Tolerance) -> DepthMethod {
    let radius_m = frame.view.strategy.radius_at_m(&frame.view.eye);
    let closed =
        frame.view.strategy.sight_limit_m(&frame.view.eye) < std::f64::consts::PI * radius_m;
    let margin = if closed { CLOSED_DEPTH } else { OPEN_DEPTH };
    let sag_m = margin * LONGEST_EDGE_M * LONGEST_EDGE_M / (8.0 * radius_m);
    if bounds.depth_is_bent && sag_m > tolerance.depth_m {
        DepthMethod::Fragment
    } else {
        DepthMethod::Vertex
    }
}
