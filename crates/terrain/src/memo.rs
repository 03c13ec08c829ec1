//! What neighbouring points have in common: cells of noise, and places in noise space.

use antipode_geometry::{ChartPoint, Hemisphere};
use glam::{DVec3, Vec4};

use crate::field::Field;
use crate::fractal::AXIS_FREQUENCY;
use crate::lattice::{Cell, Lattice, Place, SCALE, blend, fade};

/// Cells that are remembered: those of a slab of a chunk, waves of 2 m by 3.5 m, do not meet.
const CELLS: usize = 64;

/// Noise of one frequency at many points near each other.
#[derive(Debug)]
pub(crate) struct Memo {
    frequency: DVec3,
    keys: [u32; CELLS],
    cells: Box<[Cell]>,
}

impl Memo {
    /// `frequency` multiplies the axes'.
    pub(crate) fn new(frequency: f64) -> Self {
        Self {
            frequency: AXIS_FREQUENCY * frequency,
            keys: [u32::MAX; CELLS],
            cells: vec![Cell::default(); CELLS].into_boxed_slice(),
        }
    }

    /// Noise in -1..=1 of two frequencies at a point of noise space.
    pub(crate) fn noise(memos: &mut [Self; 2], lattice: &Lattice, point: DVec3) -> [f32; 2] {
        let mut corners = [Vec4::ZERO; 4];
        let (mut u, mut v) = (Vec4::ZERO, Vec4::ZERO);
        for (lane, memo) in memos.iter_mut().enumerate() {
            let [x, y, z] = (point * memo.frequency).to_array().map(Place::new);
            let cell = memo.cell(lattice, [x.low, y.low, z.low]);
            corners[lane] = cell.corners(x.part, y.part, z.part, fade(z.part));
            u[lane] = fade(x.part);
            v[lane] = fade(y.part);
        }
        let noise = (blend(corners, u, v) * SCALE).clamp(Vec4::NEG_ONE, Vec4::ONE);
        [noise.x, noise.y]
    }

    #[inline]
    fn cell(&mut self, lattice: &Lattice, low: [u8; 3]) -> &Cell {
        let [x, y, z] = low;
        let at = usize::from(z & 15) | usize::from(y & 3) << 4;
        let key = u32::from_le_bytes([x, y, z, 0]);
        if self.keys[at] != key {
            self.keys[at] = key;
            self.cells[at] = Cell::new(lattice, low);
        }
        &self.cells[at]
    }
}

/// Metres between the ground points of a sphere whose places are worked out, on spheres under 32 m
/// and on larger ones; what is drawn between them is nowhere 2 cm off.
const SPACING_M: [f64; 2] = [1.0, 2.0];
/// Places along x and z that are remembered: those of a chunk all but never meet.
const PLACES: usize = 32;

/// Points of noise space.
#[derive(Debug)]
pub(crate) struct Places {
    /// What a metre of height adds, as a share of the ground point; zero where noise space is
    /// the chart.
    stretch: f64,
    spacing_m: f64,
    keys: Box<[u64]>,
    points: Box<[DVec3]>,
}

impl Places {
    pub(crate) fn new(field: &Field) -> Self {
        let radius_m = field.strategy().radius_m();
        let (stretch, count) = if field.upright() {
            (0.0, 0)
        } else {
            (radius_m.recip(), PLACES * PLACES)
        };
        Self {
            stretch,
            spacing_m: SPACING_M[usize::from(radius_m >= 32.0)],
            keys: vec![u64::MAX; count].into_boxed_slice(),
            points: vec![DVec3::ZERO; count].into_boxed_slice(),
        }
    }

    /// Where the noise of a point is found.
    pub(crate) fn at(&mut self, field: &Field, point: ChartPoint) -> DVec3 {
        if self.stretch == 0.0 {
            return point.pos;
        }
        let (x, z) = (point.pos.x / self.spacing_m, point.pos.z / self.spacing_m);
        let (i, k) = (x.floor(), z.floor());
        let mut node = |i: f64, k: f64| self.node(field, point.hemisphere, i as i32, k as i32);
        let near = node(i, k).lerp(node(i + 1.0, k), x - i);
        let far = node(i, k + 1.0).lerp(node(i + 1.0, k + 1.0), x - i);
        let chord = near.lerp(far, z - k);
        // Out to the sphere again: a step of Newton's towards 1 / |chord|.
        let length = (chord * self.stretch).length_squared();
        chord * ((1.5 - 0.5 * length) * (1.0 + point.pos.y * self.stretch))
    }

    #[inline]
    fn node(&mut self, field: &Field, hemisphere: Hemisphere, i: i32, k: i32) -> DVec3 {
        let wrapped = |n: i32| n.cast_unsigned() as usize % PLACES;
        let at = wrapped(i) * PLACES + wrapped(k);
        let side = u64::from(hemisphere == Hemisphere::B);
        let key = u64::from(i.cast_unsigned()) << 33 | u64::from(k.cast_unsigned()) << 1 | side;
        if self.keys[at] != key {
            let ground = DVec3::new(f64::from(i), 0.0, f64::from(k)) * self.spacing_m;
            let ground = ChartPoint::new(hemisphere, ground);
            self.keys[at] = key;
            self.points[at] = field.strategy().noise_point(ground);
        }
        self.points[at]
    }
}
