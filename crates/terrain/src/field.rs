//! The scalar field of a world's untouched ground.
//!
//! `value = y + sum_i (noise_i - 0.5) a_i - relief`, solid below zero, with noise in 0..=1
//! and `relief = sum_i a_i / 2`: ground lies between 0 and twice the relief. On the sphere
//! the sum is squeezed, smoothly and strictly, between the space's lowest and highest ground.
//!
//! Values are held to [`FIELD_BAND_M`] on either side of the surface. That changes no surface,
//! and it lets a pickaxe work at any depth: the unheld field grows with depth without bound,
//! and neither patience nor a bounded edit would ever catch up with it.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, ChunkCoord, Hemisphere, Strategy};
use glam::DVec3;

use crate::biome::Biome;
use crate::fractal::{Column, Lattice, Octave};
use crate::samples::{SAMPLES, Samples};

/// Field values lie within this of zero, metres.
pub const FIELD_BAND_M: f32 = 8.0;
/// Ground is meshed this far past a hemisphere's rim, metres, for colliders.
pub const RIM_REACH_M: f64 = 8.0;
/// How much the squeezed noise of a sphere is steepened: fractal noise rarely comes near its
/// bounds, and would leave most of the allowed heights unused.
const SPHERE_GAIN: f32 = 2.2;
/// Share of the sphere's range of heights that ground may use.
const SPHERE_SHARE: f64 = 0.98;

/// The ground of a world before any edit: a pure function of seed and space.
#[derive(Debug, Clone)]
pub struct Field {
    strategy: Arc<dyn Strategy>,
    lattice: Arc<Lattice>,
    biome: &'static Biome,
    octaves: Vec<Octave>,
    relief_m: f32,
    /// Middle and half range of ground, metres, where the space bounds it.
    squeeze: Option<(f64, f64)>,
}

impl Field {
    /// The field of the world with this seed in this space.
    pub fn new(seed: u64, strategy: Arc<dyn Strategy>) -> Self {
        let biome = Biome::from_seed(seed);
        let squeeze = strategy.limits().map(|limits| {
            let middle = f64::midpoint(limits.ground_min_m, limits.ground_max_m);
            let half = (limits.ground_max_m - limits.ground_min_m) / 2.0;
            (middle, half * SPHERE_SHARE)
        });
        Self {
            lattice: Arc::new(Lattice::new(seed)),
            octaves: biome.octaves(),
            relief_m: biome.max_amplitude_m() as f32,
            biome,
            squeeze,
            strategy,
        }
    }

    /// The biome, chosen by the seed.
    pub fn biome(&self) -> &'static Biome {
        self.biome
    }

    /// The space this field lives in.
    pub fn strategy(&self) -> &Arc<dyn Strategy> {
        &self.strategy
    }

    pub(crate) fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    pub(crate) fn rim_m(&self) -> Option<f64> {
        self.strategy.rim_m()
    }

    /// Lowest and highest height that untouched ground can have, metres.
    pub fn ground_range_m(&self) -> (f64, f64) {
        match self.squeeze {
            Some((middle, half)) => (middle - half, middle + half),
            None => (0.0, 2.0 * f64::from(self.relief_m)),
        }
    }

    /// The field at a point: below zero is solid, within [`FIELD_BAND_M`] of zero, and finite
    /// wherever the point is.
    pub fn sample(&self, point: ChartPoint) -> f32 {
        let column = self.column(point.hemisphere, point.pos.x, point.pos.z);
        let mut out = [0.0];
        self.fill(&column, point.pos.y, &mut out);
        out[0]
    }

    /// The field over a chunk and its border.
    pub fn samples(&self, coord: ChunkCoord) -> Samples {
        let mut samples = Samples::empty(editable_y_m(&*self.strategy));
        let first = coord.origin() - 1.0;
        for i in 0..SAMPLES {
            for k in 0..SAMPLES {
                let (x, z) = (first.x + i as f64, first.z + k as f64);
                let column = self.column(coord.hemisphere, x, z);
                self.fill(&column, first.y, samples.column_mut(i, k));
            }
        }
        samples
    }

    /// Height of the topmost surface of untouched ground over `(x, z)`, metres.
    pub fn surface_height(&self, hemisphere: Hemisphere, x: f64, z: f64) -> f64 {
        const STEP_M: f64 = 0.5;
        const HALVINGS: u32 = 24;
        let at = |y| self.sample(ChartPoint::new(hemisphere, DVec3::new(x, y, z)));
        let (low, high) = self.ground_range_m();
        let mut air = high + STEP_M;
        while air > low && at(air - STEP_M) >= 0.0 {
            air -= STEP_M;
        }
        let mut ground = air - STEP_M;
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(air, ground);
            if at(middle) < 0.0 {
                ground = middle;
            } else {
                air = middle;
            }
        }
        air
    }

    /// Noise space along a column of the chart. Every space's noise point is affine in the
    /// height, so two heights give all.
    fn column(&self, hemisphere: Hemisphere, x: f64, z: f64) -> Column {
        let at = |y| {
            let point = ChartPoint::new(hemisphere, DVec3::new(x, y, z));
            self.strategy.noise_point(point)
        };
        let base = at(0.0);
        let slope = at(1.0) - base;
        Column { base, slope }
    }

    /// The field up a column, at heights `first_m`, `first_m + 1`, ...
    fn fill(&self, column: &Column, first_m: f64, out: &mut [f32]) {
        out.fill(0.0);
        for &octave in &self.octaves {
            self.lattice.add_octave(octave, column, first_m, out);
        }
        for (step, value) in out.iter_mut().enumerate() {
            let y = first_m + step as f64;
            let height = match self.squeeze {
                Some((middle, half)) => middle - half * f64::from(self.squeezed(*value)),
                None => f64::from(self.relief_m - *value),
            };
            *value = banded((y - height) as f32);
        }
    }

    /// A sum of noise brought smoothly and strictly between -1 and 1.
    fn squeezed(&self, sum: f32) -> f32 {
        let t = SPHERE_GAIN * sum / self.relief_m;
        t / (1.0 + t * t).sqrt()
    }
}

/// A value held to the band. A place that is not a number is solid, not contagious.
fn banded(value: f32) -> f32 {
    if value.is_nan() {
        -FIELD_BAND_M
    } else {
        value.clamp(-FIELD_BAND_M, FIELD_BAND_M)
    }
}

/// Lowest and highest height of samples that edits change. One sample inside the limits:
/// the surface between the last solid sample and the first that can be dug then lies above
/// bedrock, wherever between them it is.
pub(crate) fn editable_y_m(strategy: &dyn Strategy) -> (f64, f64) {
    strategy
        .limits()
        .map_or((f64::NEG_INFINITY, f64::INFINITY), |limits| {
            (limits.bedrock_m + 1.0, limits.ceiling_m - 1.0)
        })
}
