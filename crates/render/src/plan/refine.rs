//! What edges near the eye are halved for, and how far off a halving is that was made for another eye.

use std::f64::consts::FRAC_PI_2;

use antipode_frame::{Frame, Quality, View};
use antipode_geometry::ChartPoint;
use glam::{DVec3, Vec3};

use super::bend::{BANDS, BendSteps, band, sines};
use super::bounds::Bounds;
use super::choice::LONGEST_EDGE_M;
use super::land::ChunkLand;
use super::quality::Tolerance;
use super::way::Way;

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
    /// The eyes that it was made for.
    pub way: Way,
    bends: BendSteps,
    quality: Quality,
}

/// Which edges are halved, for one key.
#[derive(Clone, Debug)]
pub struct RefineRules {
    /// What they are for.
    pub key: RefineKey,
    tolerance: Tolerance,
    /// The square of the longest edge that may stay, by distance in [`STEPS_PER_M`] and band of elevation; any may
    /// where it ends.
    longest_square: Vec<[f32; BANDS]>,
}

impl RefineKey {
    /// The key of a frame with these bounds, whose eye goes on by a step in metres.
    pub fn of(frame: &Frame, bounds: &Bounds, step: DVec3) -> Self {
        Self {
            way: Way::new(&frame.view.eye.point, step),
            bends: bounds.steps(),
            quality: frame.view.quality,
        }
    }

    /// Whether a refinement for it is all that a frame asks for, seen from a place.
    pub fn holds(&self, frame: &Frame, bounds: &Bounds, eye: &ChartPoint) -> bool {
        self.bends == bounds.steps() && self.quality == frame.view.quality && self.way.covers(eye)
    }
}

impl RefineRules {
    /// The rules of a frame with these bounds, whose eye goes on by a step in metres.
    pub fn new(frame: &Frame, bounds: &Bounds, step: DVec3) -> Self {
        let key = RefineKey::of(frame, bounds, step);
        let slack_m = key.way.slack_m();
        let tolerance = Tolerance::of(frame.view.quality);
        let farthest_m =
            f64::from(frame.view.fog_distance_m.clamp(0.0, View::NO_FOG_M)) + CHUNK_DIAGONAL_M;
        let reach_m = bounds
            .refine_within_m(&tolerance, COARSEST_EDGE_M)
            .min(farthest_m)
            + slack_m;
        let at = |step: u32| {
            let distance_m = f64::from(step) / f64::from(STEPS_PER_M) - slack_m;
            std::array::from_fn(|band| {
                let sines = about(band, slack_m, distance_m);
                let most = bounds.bend.between(distance_m.max(0.0), sines);
                (tolerance.shape_px / most) as f32
            })
        };
        Self {
            key,
            longest_square: (0..=(reach_m * f64::from(STEPS_PER_M)) as u32)
                .map(at)
                .collect(),
            tolerance,
        }
    }

    /// How far a frame's eye is from those that they are for, metres along their chart.
    pub fn away_m(&self, frame: &Frame) -> f64 {
        self.key
            .way
            .away_m(&*frame.view.strategy, &frame.view.eye.point)
    }

    /// The places of the eye from a chunk's corner; none where they have none in its chart. They are whole parts of a
    /// metre and corners whole metres, so differences from them are exact, and come out the same in every chunk.
    pub fn eyes_from(&self, frame: &Frame, chunk: &ChunkLand) -> Vec<Vec3> {
        let chart = chunk.coord.chart;
        let places = self.key.way.places();
        let eyes = places.filter_map(|eye| frame.view.strategy.carry(eye, chart));
        eyes.map(|eye| (eye.point.pos - chunk.coord.origin()).as_vec3())
            .collect()
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

    /// By what multiple of the tolerance an edge strays from its true picture at most, seen from any of these eyes, given
    /// the square of its length and where its middle lies.
    #[inline]
    pub fn strays(&self, length_square: f32, middle: Vec3, eyes: &[Vec3]) -> f32 {
        let strays = |eye: &Vec3| self.strays_from(length_square, middle - *eye);
        eyes.iter().map(strays).fold(0.0, f32::max)
    }

    #[inline]
    fn strays_from(&self, length_square: f32, from_eye: Vec3) -> f32 {
        let distance = from_eye.length();
        match self.longest_square.get((distance * STEPS_PER_M) as usize) {
            Some(longest_square) => length_square / longest_square[band(from_eye.y / distance)],
            None => 0.0,
        }
    }

    /// The square of the longest edge that may stay at a distance, at elevations between two sines.
    fn longest_square(&self, distance_m: f64, sines: [f64; 2]) -> f64 {
        let Some(row) = self
            .longest_square
            .get((distance_m * f64::from(STEPS_PER_M)) as usize)
        else {
            return f64::INFINITY;
        };
        let [first, last] = sines.map(|sine| band(sine as f32));
        row[first..=last].iter().copied().fold(0.0, f32::max).into()
    }

    /// The most that the edges of a chunk stray now, in pixels, though they were halved by these rules, when the
    /// largest stray left was `error_px`. None of them is nearer to the eye than `near_m`.
    ///
    /// An edge at a distance d from the eye of now was at most at d + m from the nearest eye of then, if that stood m
    /// away, and so is no longer than was let pass there, at the elevations where it may have been.
    pub fn stale_error_px(
        &self,
        error_px: f64,
        frame: &Frame,
        now: &Bounds,
        chunk: &ChunkLand,
        near_m: f64,
    ) -> f64 {
        let carried = frame
            .view
            .strategy
            .carry(frame.view.eye.point, self.key.way.chart());
        let Some(eye) = carried.map(|crossing| crossing.point) else {
            return unhalved_error_px(frame, now, chunk);
        };
        let places = self.key.way.places();
        let moved_m = places
            .map(|place| place.pos.distance(eye.pos))
            .fold(f64::INFINITY, f64::min);
        let is_here = eye.chart == chunk.coord.chart;
        let heights = is_here.then_some([chunk.min.y - eye.pos.y, chunk.max.y - eye.pos.y]);
        let left = (error_px / self.tolerance.shape_px).max(1.0);
        let longest_square = chunk.longest_edge_m().powi(2);
        let far_m = near_m + (chunk.max - chunk.min).length();
        let mut worst: f64 = 0.0;
        let mut from_m = near_m.max(0.05);
        while from_m < far_m {
            let to_m = from_m * LOOK_RATIO;
            let seen = heights.map_or([-1.0, 1.0], |heights| {
                sines_between(heights, [from_m, to_m])
            });
            for now_in in (0..BANDS).filter(|&band| overlap(sines(band), seen)) {
                let passed = self.longest_square(to_m + moved_m, about(now_in, moved_m, from_m));
                let most = now.bend.between(from_m, sines(now_in));
                worst = worst.max(most * (passed * left).min(longest_square));
            }
            from_m = to_m;
        }
        worst
    }
}

/// The most that the edges of a chunk stray as they are, in pixels.
pub fn unhalved_error_px(frame: &Frame, bounds: &Bounds, chunk: &ChunkLand) -> f64 {
    let near_m = Bounds::nearest_chart_m(frame, chunk);
    let sines = if frame.view.eye.point.chart == chunk.coord.chart {
        let heights = [chunk.min.y, chunk.max.y].map(|y| y - frame.view.eye.point.pos.y);
        let far_m = near_m + (chunk.max - chunk.min).length();
        sines_between(heights, [near_m.max(0.05), far_m])
    } else {
        [-1.0, 1.0]
    };
    bounds.bend.between(near_m, sines) * chunk.longest_edge_m().powi(2)
}

/// The sines of elevation at which something in a band, a distance from an eye, may lie from another eye `away_m` from
/// the first: a step m turns the direction to what is at a distance d by an angle whose sine is at most m / d.
fn about(band: usize, away_m: f64, distance_m: f64) -> [f64; 2] {
    let [low, high] = sines(band);
    if distance_m <= away_m {
        return [-1.0, 1.0];
    }
    let turn = (away_m / distance_m).asin();
    let turned = |sine: f64, by: f64| (sine.asin() + by).clamp(-FRAC_PI_2, FRAC_PI_2).sin();
    [turned(low, -turn), turned(high, turn)]
}

/// The sines of elevation at which something between two heights over an eye lies, at distances between two.
fn sines_between([low, high]: [f64; 2], [near_m, far_m]: [f64; 2]) -> [f64; 2] {
    [
        (low / near_m).min(low / far_m).max(-1.0),
        (high / near_m).max(high / far_m).min(1.0),
    ]
}

fn overlap(a: [f64; 2], b: [f64; 2]) -> bool {
    a[0] <= b[1] && b[0] <= a[1]
}
