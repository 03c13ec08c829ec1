//! Numbers by chance, and slow noise: both are whole numbers stirred, the same on every machine.

use antipode_geometry::ChartPoint;
use antipode_terrain::Field;
use glam::{DVec3, IVec2, IVec3, Vec3};

/// Groves and glades are about so wide, metres; and the finer of two waves.
const GROVE_M: [f64; 2] = [74.0, 23.0];
/// How much the wider wave counts.
const WIDE: f32 = 0.66;
/// Noise between which groves thin out.
const EDGES: (f32, f32) = (0.34, 0.56);
/// Plants are by other numbers than the land.
const OTHER_SEED: u64 = 0x706c_616e_7473;

/// Stirs a number so that each bit depends on all (Steele, Lea and Flood, "Fast splittable pseudorandom number generators",
/// 2014: the finaliser of `SplitMix64`).
fn stirred(n: u64) -> u64 {
    let n = n.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let n = (n ^ (n >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let n = (n ^ (n >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    n ^ (n >> 31)
}

/// The upper bits as a share, 0 to below 1.
fn share_of(n: u64) -> f32 {
    (n >> 40) as f32 / (1_u64 << 24) as f32
}

/// One number after another.
#[derive(Debug)]
pub(crate) struct Draw(u64);

impl Draw {
    /// Those of a cell of a chart.
    pub(crate) fn of(seed: u64, chart: u64, cell: IVec2) -> Self {
        let [x, z] = cell.to_array().map(|c| u64::from(c.cast_unsigned()));
        Self(stirred(
            stirred(seed ^ OTHER_SEED ^ chart.rotate_left(17)) ^ (x << 32 | z),
        ))
    }

    /// The next, 0 to below 1.
    pub(crate) fn share(&mut self) -> f32 {
        self.0 = stirred(self.0);
        share_of(self.0)
    }
}

/// How dense the groves are at a point, 0 in glades to 1.
pub(crate) fn grove(seed: u64, field: &Field, point: ChartPoint) -> f32 {
    let x = field.blended(point, 0.5, |place| {
        let [wide, fine] = GROVE_M.map(|wide_m| value_noise(seed ^ OTHER_SEED, place / wide_m));
        WIDE * wide + (1.0 - WIDE) * fine
    });
    let share = ((x - EDGES.0) / (EDGES.1 - EDGES.0)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Value noise on the whole lattice, 0 to 1.
fn value_noise(seed: u64, place: DVec3) -> f32 {
    let low = place.floor();
    let part = (place - low).as_vec3();
    let s = part * part * (Vec3::splat(3.0) - 2.0 * part);
    let corner = low.as_ivec3();
    let at = |x: i32, y: i32, z: i32| {
        let [x, y, z] = (corner + IVec3::new(x, y, z)).to_array();
        let [x, y, z] = [x, y, z].map(|c| u64::from(c.cast_unsigned()));
        share_of(stirred(stirred(seed ^ x) ^ (y << 32 | z)))
    };
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    let row = |y: i32, z: i32| mix(at(0, y, z), at(1, y, z), s.x);
    let layer = |z: i32| mix(row(0, z), row(1, z), s.y);
    mix(layer(0), layer(1), s.z)
}
