//! The peer comparison: representations of the hyperbolic plane, by HyperRogue's published tests.
//!
//! The tests are those of Celińska-Kopczyńska and Kopczyński, "Numerical Aspects of Hyperbolic
//! Geometry", arXiv 2404.09039, on the order-7 heptagrid {7,3}, as HyperRogue's program has them;
//! none of its code is here. Each is run from a fixed set of seeds; its result is the first
//! distance or step at which the error passes a tolerance, 0.1 or 1e-3, and the table shows the
//! median. An error that is not a number is a failure.
//!
//! - `loop_iso`: the identity is carried along a random path of tiles, out until d tiles away and
//!   home by another way, one composition per turn and push; d from 0 to 99 tiles. The error is
//!   how far it moves the origin.
//! - `loop_any`: the same with a point. The paper's own description of a test of this name was
//!   not at hand; HyperRogue's program has this one under another name.
//! - `angledist`: the centre of a tile d tiles away is carried along a random path to the first;
//!   d from 1 to 999 tiles in growing strides. The errors are those of its distance and angle,
//!   judged by a product along a shortest path in double precision with a shared exponent,
//!   where the program has a number type of many digits.
//! - `similarity`, `dissimilarity`: two points on a circle of radius d, at angles `exp(-d)` or
//!   `pi + exp(-d)` from each other, in a random direction; d from 1 to 999 radii. The error is
//!   that of their distance, judged by a closed form.
//! - `walk`: two walkers on one straight line, half a step of 1/16 apart, each in the frame of its
//!   nearest tile, up to 10000 steps. The published test ends when their tiles are three apart,
//!   whatever the tolerance; `walk (distance)`, our addition, when their distance is wrong by the
//!   tolerance. The program also stops a walker that stays on one tile; here that is no failure,
//!   but a pose that is not finite is.
//! - `close`: a point beside the first tile's centre is seen from a tile that comes and goes, out
//!   to d tiles and straight home, for 1000 moves. It fails when it is not at its distance or
//!   angle on coming home. The program counts such failures in 10000 moves at each d; here the
//!   result is the smallest d, from 1 to 20 tiles, that has one, so that more is better as in the
//!   other tests.
//! - `count`: machine operations of each kind behind each operation of the representation.
//!
//! Distances are taken from `asinh` of a chord, where the program has `acosh`, which reads small
//! distances as none; one row keeps that.
//!
//! The **camera-relative rule** is the game's: a place is the name of a tile, which is exact, and
//! coordinates within it; only what is seen is worked out, from a shortest path to the camera or,
//! for a pair, from the angle between the two, so no coordinate is ever far. The rule changes the
//! question that the other representations are asked, and that is its point: most of what the
//! tests measure need not be computed.

pub mod chart;
pub mod disk;
pub mod halfplane;
pub mod linear;
pub mod model;
pub mod number;
pub mod outcome;
mod plots;
pub mod polar;
pub mod published;
pub mod reference;
pub mod suite;
mod tables;
pub mod tiling;
pub mod trials;
pub mod walkers;
pub mod wander;

use crate::{Effort, Section};
use tables::{Measured, TOLERANCES};

/// Seeds of a quick run: odd, so that the median is one of the runs.
const QUICK_SEEDS: u64 = 11;
/// Seeds of a full run.
const FULL_SEEDS: u64 = 101;

/// Runs every test for every representation.
pub fn run(effort: Effort) -> Section {
    let seeds = if effort.quick {
        QUICK_SEEDS
    } else {
        FULL_SEEDS
    };
    let measured: Vec<_> = suite::subjects()
        .into_iter()
        .map(|subject| Measured {
            medians: subject.medians(TOLERANCES, seeds),
            subject,
        })
        .collect();
    Section::new(
        "peers",
        "Peer comparison",
        method(seeds),
        [
            tables::published(&measured),
            tables::medians(&measured, 0),
            tables::medians(&measured, 1),
            tables::ours(&measured),
            tables::counts(&measured),
        ],
    )
    .with([plots::loops(), plots::medians(&measured)])
}

fn method(seeds: u64) -> Vec<String> {
    vec![
        format!(
            "HyperRogue's published tests of representations (Celińska-Kopczyńska and Kopczyński, \
             arXiv 2404.09039) on the order-7 heptagrid, in single and double precision. Each \
             figure is the median over {seeds} seeds of the first distance or step at which the \
             error passes the tolerance; more is better. \"> n\" means that the median run had \
             not failed at n, the farthest tried. What is not a number is a failure. \"count\" is \
             the number of machine operations in one composition; less is better."
        ),
        "A published median is reproduced if it lies between ours at the two tolerances, give or \
         take one tile or radius, or one step in twenty of a walk. Both tolerances count, because \
         which one the published linear medians were taken with is not known here: those of \
         loop_iso and similarity agree with ours at 1e-3, those of the half-plane at 0.1. The \
         published walk of the linear representation is that of matrices made orthogonal after \
         each product; left alone, they come half as far."
            .to_owned(),
        "The disk keeps pairs of complex numbers with a shared exponent and is the type in which \
         the camera-relative rows multiply; without the rule it fails like its peers, and only \
         overflow is spared. The exponential chart is the port's own closed form with places far \
         from the eye, as the game never has them."
            .to_owned(),
        "The camera-relative rows keep a place as a tile, which is exact, and coordinates within \
         it. A loop comes home to the same tile, so there is nothing to multiply; a far tile is \
         seen along a shortest path; the direction that two points share drops out before any \
         coordinate is made, and what fails in the end is the range of exp(-d), the angle given. \
         In the walk the second walker is kept relative to the first; they share a heading, so \
         the turn between them is none and stays none. Kept apart, each rounding for itself, two \
         walkers part in any representation after about 16 steps for every \
         factor e of precision, and that is no fault of theirs: it is what curvature does to two \
         headings that differ in the last bit."
            .to_owned(),
        "The last table but one sets the rule beside the best of the others, published or \
         measured here, in each test at each tolerance."
            .to_owned(),
    ]
}
