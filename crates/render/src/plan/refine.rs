//! What edges near the eye are halved for, and how far off a halving is that was made for another eye.

use antipode_geometry::{ChartPoint, Hemisphere};
use antipode_scene::frame::{Frame, Quality};
use glam::{IVec3, Vec3};

use super::bounds::{BendSteps, Bounds};
use super::choice::LONGEST_EDGE_M;
use super::land::ChunkLand;
use super::quality::Tolerance;

/// Edges are halved for an eye anywhere in a cell of this grid, metres: walking does not rebuild them at every
/// step.
const EYE_GRID_M: f64 = 0.5;
/// No eye is farther than this from the middle of its cell, metres.
const EYE_SLACK_M: f64 = 0.5 * 1.733 * EYE_GRID_M;
/// Steps of distance in which the longest edge that may stay is looked up, per metre.
const STEPS_PER_M: f32 = 4.0;
/// Beyond the fog nothing is seen; chunks that begin before it end within this, metres.
const CHUNK_DIAGONAL_M: f64 = 56.0;
/// Longest edge of the coarsest level, metres.
const COARSEST_EDGE_M: f64 = 8.0 * LONGEST_EDGE_M;
/// Ratio of the distances at which a stale halving is looked at.
const LOOK_RATIO: f64 = 1.12;

/// What a refinement was made for; another key asks for another. Together with the mesh it determines the
/// refinement, so that two chunks with the same key agree on the edges they share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RefineKey {
    hemisphere: Hemisphere,
    eye: IVec3,
    bends: BendSteps,
    quality: Quality,
}

/// Which edges are halved, for one key.
#[derive(Clone, Debug)]
pub struct RefineRules {
    /// What they are for.
    pub key: RefineKey,
    bounds: Bounds,
    tolerance: Tolerance,
    /// The square of the longest edge that may stay, by distance in [`STEPS_PER_M`]; any may where it ends.
    longest_square: Vec<f32>,
}

impl RefineKey {
    /// The key of a frame with these bounds.
    pub fn of(frame: &Frame, bounds: &Bounds) -> Self {
        let eye = &frame.eye.point;
        Self {
            hemisphere: eye.hemisphere,
            eye: (eye.pos / EYE_GRID_M).round().as_ivec3(),
            bends: bounds.steps(),
            quality: frame.quality,
        }
    }

    /// How far an eye is from the one that it was made for, metres along the chart; 0 in another chart.
    pub fn away_m(&self, eye: &ChartPoint) -> f64 {
        if eye.hemisphere == self.hemisphere {
            self.eye().pos.distance(eye.pos)
        } else {
            0.0
        }
    }

    /// The middle of the eye's cell.
    fn eye(&self) -> ChartPoint {
        ChartPoint::new(self.hemisphere, self.eye.as_dvec3() * EYE_GRID_M)
    }
}

impl RefineRules {
    /// The rules of a frame with these bounds.
    pub fn new(frame: &Frame, bounds: &Bounds) -> Self {
        let tolerance = Tolerance::of(frame.quality);
        let farthest_m = f64::from(frame.fog_distance_m.max(0.0)) + CHUNK_DIAGONAL_M;
        let reach_m = bounds
            .refine_within_m(&tolerance, COARSEST_EDGE_M)
            .min(farthest_m)
            + EYE_SLACK_M;
        let at = |step: u32| {
            let distance_m = f64::from(step) / f64::from(STEPS_PER_M) - EYE_SLACK_M;
            (tolerance.shape_px / bounds.bend_px(distance_m.max(0.0))) as f32
        };
        Self {
            key: RefineKey::of(frame, bounds),
            longest_square: (0..=(reach_m * f64::from(STEPS_PER_M)) as u32)
                .map(at)
                .collect(),
            bounds: bounds.clone(),
            tolerance,
        }
    }

    /// The eye from a chunk's corner, where it has a place in its chart. Eyes stand on a grid and corners in whole
    /// metres, so differences from it are exact, and come out the same in every chunk.
    pub fn eye_from(&self, frame: &Frame, chunk: &ChunkLand) -> Option<Vec3> {
        let mut eye = self.key.eye();
        if eye.hemisphere != chunk.coord.hemisphere {
            eye = frame.strategy.carry(eye)?.point;
        }
        Some((eye.pos - chunk.coord.origin()).as_vec3())
    }

    /// How often an edge may be halved.
    pub fn halvings(&self) -> u32 {
        self.tolerance.halvings
    }

    /// What edges may stray by, pixels.
    pub fn shape_px(&self) -> f64 {
        self.tolerance.shape_px
    }

    /// No edge that is farther than this from the eye needs halving, metres.
    pub fn reach_m(&self) -> f32 {
        self.longest_square.len() as f32 / STEPS_PER_M
    }

    /// By what multiple of the tolerance an edge strays from its true picture at most, given the squares of its
    /// length and of its middle's distance from the eye.
    #[inline]
    pub fn strays(&self, length_square: f32, distance_square: f32) -> f32 {
        let step = distance_square.sqrt() * STEPS_PER_M;
        match self.longest_square.get(step as usize) {
            Some(longest_square) => length_square / longest_square,
            None => 0.0,
        }
    }

    /// The most that the edges of a chunk stray now, in pixels, though they were halved by these rules, when the
    /// largest stray left was `error_px`.
    ///
    /// An edge at a distance d from the eye of now was at most at d + m from the eye of then, if that stood m away,
    /// and so is no longer than was let pass there.
    pub fn stale_error_px(
        &self,
        error_px: f64,
        frame: &Frame,
        now: &Bounds,
        chunk: &ChunkLand,
    ) -> f64 {
        let mut eye = frame.eye.point;
        if eye.hemisphere != self.key.hemisphere {
            match frame.strategy.carry(eye) {
                Some(crossing) => eye = crossing.point,
                None => return unhalved_error_px(frame, now, chunk),
            }
        }
        let moved_m = eye.pos.distance(self.key.eye().pos);
        let left = (error_px / self.tolerance.shape_px).max(1.0) * self.tolerance.shape_px;
        let longest_square = chunk.longest_edge_m().powi(2);
        let near_m = Bounds::nearest_chart_m(frame, chunk);
        let far_m = near_m + (chunk.max - chunk.min).length();
        let mut worst: f64 = 0.0;
        let mut from_m = near_m.max(0.05);
        while from_m < far_m {
            let to_m = from_m * LOOK_RATIO;
            let then_m = (to_m + moved_m - EYE_SLACK_M).max(0.0);
            let square = (left / self.bounds.bend_px(then_m)).min(longest_square);
            worst = worst.max(now.bend_px(from_m) * square);
            from_m = to_m;
        }
        worst
    }
}

/// The most that the edges of a chunk stray as they are, in pixels.
pub fn unhalved_error_px(frame: &Frame, bounds: &Bounds, chunk: &ChunkLand) -> f64 {
    let near_m = Bounds::nearest_chart_m(frame, chunk);
    bounds.bend_px(near_m) * chunk.longest_edge_m().powi(2)
}
