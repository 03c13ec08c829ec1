//! Noise that is broader than a tile: random numbers of the tiles about, by how far they are.
//!
//! Such noise is `sum_t g_t K(W_t) / sqrt(sum_t K(W_t)^2)`, g_t random numbers of variance 1 and W_t the cosine of the distance
//! of a tile's centre from the place. It has variance 1 everywhere, and tiles cannot be seen in it where K is broad. Up to hundreds of
//! tiles count. So in each patch a cubic stands for it, the nearest by squares, whose coefficients are linear in the g_t: by
//! what, is the same for all tiles. Patches are blended by their weights. Of that the standard deviation is
//! within 3.3 % of 1 everywhere, and that of climates within 0.4 %.

use std::sync::Arc;

use antipode_geometry::tiling::quilt::{PATCH_COSH, Patch, Surroundings};
use glam::{DVec2, DVec3, Vec4};

use super::Once;
use crate::fractal::AXIS_FREQUENCY;
use crate::lattice::stirred;

/// Coefficients of a cubic in two variables.
const TERMS: usize = 10;
/// How far in W the tiles of the climates and of octaves count.
const CLIMATE_COSH: f64 = 20.0;
const OCTAVE_COSH: f64 = 3.0;
/// No farther in W than this is a tile from a centre that counts in its patch: `cosh(acosh(20) + acosh(2))`, and to how many
/// steps such tiles are found, among how many.
const MOST_COSH: f64 = 74.7;
const MOST_STEPS: usize = 6;
const MOST_TILES: usize = 1377;
/// Octaves with waves longer than so many radii are broad.
const WIDE_RADII: f64 = 2.0;
/// Frequency of the longest octave of biomes by climate.
const FIRST_FREQUENCY: f64 = 0.05;
/// Where a cubic is compared: places so far apart, radii, and what the weight of each is more than its weight in the patch.
const APART: f64 = 0.15;
const EVEN: f64 = 0.02;

/// How many octaves of biomes by climate are broader than tiles of a radius, metres.
pub(super) fn wide_octaves(radius_m: f64) -> usize {
    let across = AXIS_FREQUENCY * FIRST_FREQUENCY;
    let wave_m = (across.x * across.z).sqrt().recip();
    (0..4)
        .take_while(|n| wave_m * 0.5_f64.powi(*n) > WIDE_RADII * radius_m)
        .count()
}

/// What each tile about adds to the coefficients.
#[derive(Debug)]
pub(super) struct Fit {
    surroundings: Surroundings,
    climate: Vec<[f32; TERMS]>,
    octaves: Vec<[f32; TERMS]>,
}

/// By how much a tile counts at a cosine W.
fn climate_kernel(cosh: f64) -> f64 {
    let t = (1.0 - (cosh - 1.0) / (CLIMATE_COSH - 1.0)).max(0.0);
    t * t * t / (1.0 + cosh).sqrt().sqrt()
}

fn octave_kernel(cosh: f64) -> f64 {
    let t = (1.0 - (cosh - 1.0) / (OCTAVE_COSH - 1.0)).max(0.0);
    t * t * t
}

fn powers(at: DVec2) -> [f64; TERMS] {
    let DVec2 { x, y: z } = at;
    let (xx, zz) = (x * x, z * z);
    [1.0, x, z, xx, x * z, zz, xx * x, xx * z, x * zz, zz * z]
}

impl Fit {
    /// The only one there is.
    pub(super) fn shared() -> Arc<Self> {
        static FIT: Once<Fit> = Once::new();
        FIT.get_or_init(|| Arc::new(Self::new())).clone()
    }

    fn new() -> Self {
        let surroundings = Surroundings::new(MOST_STEPS, MOST_COSH, MOST_TILES);
        // There are as many tiles, whatever happens.
        let surroundings = surroundings.unwrap_or_else(|_| Surroundings::default());
        let places = places();
        let factor = Factor::new(&places);
        let kernel = |kernel: fn(f64) -> f64| factor.rows(&places, surroundings.centres(), kernel);
        Self {
            climate: kernel(climate_kernel),
            octaves: kernel(octave_kernel),
            surroundings,
        }
    }
}

/// A place of a patch: (X, Z, W), the powers of its place there, and what it counts.
struct Place {
    point: DVec3,
    powers: [f64; TERMS],
    weight: f64,
}

/// Places all over a patch.
fn places() -> Vec<Place> {
    let steps = 12;
    let at = |n: i32| f64::from(n) * APART;
    let all = (-steps..=steps).flat_map(|i| (-steps..=steps).map(move |k| [at(i), at(k)]));
    let place = |[x, z]: [f64; 2]| {
        let w = (1.0 + x * x + z * z).sqrt();
        let t = 1.0 - (w - 1.0) / (PATCH_COSH - 1.0);
        (t > 0.0).then(|| Place {
            point: DVec3::new(x, z, w),
            powers: powers(DVec2::new(x, z) * (3.0 / (2.0 + w))),
            weight: EVEN + t * t,
        })
    };
    all.filter_map(place).collect()
}

/// The lower triangle L of `L L^T = sum weight powers powers^T` (Cholesky).
struct Factor([[f64; TERMS]; TERMS]);

impl Factor {
    fn new(places: &[Place]) -> Self {
        let mut low = [[0.0; TERMS]; TERMS];
        for i in 0..TERMS {
            for j in 0..=i {
                let term = |it: &Place| it.weight * it.powers[i] * it.powers[j];
                let mut sum: f64 = places.iter().map(term).sum();
                let known = low[i].iter().zip(&low[j]).take(j);
                sum -= known.map(|(a, b)| a * b).sum::<f64>();
                low[i][j] = if i == j { sum.sqrt() } else { sum / low[j][j] };
            }
        }
        Self(low)
    }

    fn solved(&self, mut right: [f64; TERMS]) -> [f64; TERMS] {
        let low = &self.0;
        for i in 0..TERMS {
            for k in 0..i {
                right[i] -= low[i][k] * right[k];
            }
            right[i] /= low[i][i];
        }
        for i in (0..TERMS).rev() {
            for k in i + 1..TERMS {
                right[i] -= low[k][i] * right[k];
            }
            right[i] /= low[i][i];
        }
        right
    }

    /// What a random number of each centre adds to the coefficients.
    fn rows(
        &self,
        places: &[Place],
        centres: &[DVec3],
        kernel: fn(f64) -> f64,
    ) -> Vec<[f32; TERMS]> {
        let counted = |place: &Place| {
            let at = place.point;
            let cosh = |it: &DVec3| it.z * at.z - it.x * at.x - it.y * at.y;
            let counts: Vec<f64> = centres.iter().map(|it| kernel(cosh(it))).collect();
            let squares: f64 = counts.iter().map(|it| it * it).sum();
            let per = place.weight / squares.sqrt();
            counts.into_iter().map(|it| it * per).collect::<Vec<_>>()
        };
        let counts: Vec<_> = places.iter().map(counted).collect();
        let row = |n: usize| {
            let mut right = [0.0; TERMS];
            for (place, counts) in places.iter().zip(&counts) {
                for (right, power) in right.iter_mut().zip(place.powers) {
                    *right += counts[n] * power;
                }
            }
            self.solved(right).map(|it| it as f32)
        };
        (0..centres.len()).map(row).collect()
    }
}

/// The broad noise of a tile's patch: heat, humidity, how high land lies and the longest octave; then the other octaves.
#[derive(Debug)]
pub(super) struct Broad([[Vec4; 2]; TERMS]);

impl Broad {
    /// With as many octaves as are wide.
    pub(super) fn new(fit: &Fit, patch: &Patch, seed: u64, wide: usize) -> Self {
        let mut terms = [[Vec4::ZERO; 2]; TERMS];
        let keys = patch.keys_around(&fit.surroundings);
        for ((key, climate), octaves) in keys.zip(&fit.climate).zip(&fit.octaves) {
            let key = stirred(key ^ seed);
            let climates = Vec4::new(number(key, 0), number(key, 1), number(key, 2), 0.0);
            let mut numbers = [0.0; 4];
            if octaves.iter().any(|by| by.abs() > f32::EPSILON) {
                for (n, out) in (3..).zip(numbers.iter_mut().take(wide)) {
                    *out = number(key, n);
                }
            }
            let [longest, rest @ ..] = numbers;
            let [longest, rest] = [Vec4::W * longest, Vec4::new(rest[0], rest[1], rest[2], 0.0)];
            for (term, (by, by_octave)) in terms.iter_mut().zip(climate.iter().zip(octaves)) {
                term[0] += climates * *by + longest * *by_octave;
                term[1] += rest * *by_octave;
            }
        }
        Self(terms)
    }

    /// Adds the noise at a place of the patch, radii, so many times; more octaves than the longest where they are asked for.
    #[inline]
    pub(super) fn add(&self, place: DVec2, weight: f32, more: bool, sums: &mut [Vec4; 2]) {
        let powers = powers(place).map(|power| weight * power as f32);
        for (term, by) in self.0.iter().zip(powers) {
            sums[0] += term[0] * by;
        }
        if more {
            for (term, by) in self.0.iter().zip(powers) {
                sums[1] += term[1] * by;
            }
        }
    }

    /// The noise at the centre of the patch.
    pub(super) fn middle(&self) -> [Vec4; 2] {
        self.0[0]
    }
}

/// A random number of variance 1 by a key, each number another: all within a range as likely.
fn number(key: u64, n: u64) -> f32 {
    const ROOT_OF_THREE: f32 = 1.732_050_8;
    let share = (stirred(key ^ n.wrapping_mul(0x2545_f491_4f6c_dd1d)) >> 40) as f32;
    (share * (2.0 / (1_u64 << 24) as f32) - 1.0) * ROOT_OF_THREE
}
