//! Caches what neighbouring points have in common: cells of noise, and places in noise space.

use antipode_geometry::{ChartId, ChartPoint, NoiseFrame};
use glam::{DVec3, Vec4};

use crate::field::Field;
use crate::fractal::AXIS_FREQUENCY;
use crate::lattice::{Cell, Lattice, LatticeCoord, SCALE, blend, fade, fades};
use crate::tracts::Spot;

/// Adding this to a small whole number leaves it in the low bits.
const ROUNDS: f32 = 8_388_608.0;
/// Cells that are remembered: those of a slab of a chunk, waves of 2 m by 3.5 m, do not meet.
const CELLS: usize = 64;
/// Points are taken relative to the corner of a cube of this edge, metres of noise space: near
/// enough for `f32`, and the same corner whichever chunk a point is painted for.
const CUBE_M: f64 = 64.0;

/// Noise of two frequencies at many points near each other.
#[derive(Debug)]
pub(crate) struct Waves {
    corner: DVec3,
    waves: [Wave; 2],
}

/// Noise of one frequency within a cube.
#[derive(Debug)]
struct Wave {
    /// Lattice coordinates per metre.
    frequency: DVec3,
    quick: Vec4,
    /// Where the cube's corner lies in the lattice: coordinates below, and what is left.
    low: [u8; 3],
    rest: Vec4,
    keys: [u32; CELLS],
    cells: Box<[Cell; CELLS]>,
}

impl Waves {
    /// The frequencies multiply the axes'.
    pub(crate) fn new(frequencies: [f64; 2]) -> Self {
        Self {
            corner: DVec3::NAN,
            waves: frequencies.map(Wave::new),
        }
    }

    /// Noise in -1..=1 of each frequency at a point of noise space.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    pub(crate) fn at(&mut self, lattice: &Lattice, point: DVec3) -> [f32; 2] {
        let mut local = point - self.corner;
        let within = local.cmpge(DVec3::ZERO) & local.cmplt(DVec3::splat(CUBE_M));
        if !within.all() {
            self.corner = (point / CUBE_M).floor() * CUBE_M;
            local = point - self.corner;
            for wave in &mut self.waves {
                wave.enter(self.corner);
            }
        }
        let local = local.as_vec3().extend(0.0);
        let [a, b] = &mut self.waves;
        let ((c, u), (d, v)) = (a.corners(lattice, local), b.corners(lattice, local));
        let (x, y) = (Vec4::new(u.x, v.x, 0.0, 0.0), Vec4::new(u.y, v.y, 0.0, 0.0));
        let noise = (blend([c, d, c, d], x, y) * SCALE).clamp(Vec4::NEG_ONE, Vec4::ONE);
        [noise.x, noise.y]
    }
}

impl Waves {
    /// [`Self::at`] at a height over a spot of a world in tiles.
    pub(crate) fn over(&mut self, lattice: &Lattice, spot: &Spot, y: f64) -> [f32; 2] {
        let waves = self.waves.each_mut();
        waves.map(|wave| {
            spot.blended(y, |place| wave.noise(lattice, place))
                .clamp(-1.0, 1.0)
        })
    }
}

impl Wave {
    /// Noise, about -1 to 1, at a point of noise space, however far.
    fn noise(&mut self, lattice: &Lattice, point: DVec3) -> f32 {
        let at = (point * self.frequency).to_array();
        let [x, y, z] = at.map(LatticeCoord::new);
        let cell = self.cell(lattice, [x.low, y.low, z.low]);
        let corners = cell.corners(x.part, y.part, z.part, fade(z.part));
        let (u, v) = (Vec4::splat(fade(x.part)), Vec4::splat(fade(y.part)));
        blend([corners; 4], u, v).x * SCALE
    }

    fn new(frequency: f64) -> Self {
        let frequency = AXIS_FREQUENCY * frequency;
        Self {
            frequency,
            quick: frequency.as_vec3().extend(0.0),
            low: [0; 3],
            rest: Vec4::ZERO,
            keys: [u32::MAX; CELLS],
            cells: Box::new([Cell::default(); CELLS]),
        }
    }

    fn enter(&mut self, corner: DVec3) {
        let [x, y, z] = (corner * self.frequency).to_array().map(LatticeCoord::new);
        self.low = [x.low, y.low, z.low];
        self.rest = Vec4::new(x.part, y.part, z.part, 0.0);
    }

    /// What the corners of a point's cell contribute, and its weights over the axes.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn corners(&mut self, lattice: &Lattice, local: Vec4) -> (Vec4, Vec4) {
        let place = local * self.quick + self.rest;
        let whole = place.floor();
        let part = place - whole;
        let weights = fades(part);
        let [x, y, z, _] = whole.to_array();
        let [a, b, c] = self.low;
        // The coordinates above are in 0..=32.
        let index = |low: u8, above: f32| low.wrapping_add((above + ROUNDS).to_bits() as u8);
        let cell = self.cell(lattice, [index(a, x), index(b, y), index(c, z)]);
        (cell.corners(part.x, part.y, part.z, weights.z), weights)
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

/// The key of a place so far off that nothing is painted there.
const NO_PLACE: u64 = 0x8000_0000_8000_0000;

/// Points of noise space.
#[derive(Debug)]
pub(crate) struct Places {
    /// What a metre of height adds, as a share of the ground point.
    stretch: f64,
    spacing_m: f64,
    /// The chart of the last point, and how noise space lies in it.
    frame: Option<(ChartId, NoiseFrame)>,
    keys: Box<[u64]>,
    points: Box<[Vec4]>,
    /// The square that the last point was in, and its corners.
    last: Option<(ChartId, f64, f64)>,
    corners: [Vec4; 4],
}

impl Places {
    pub(crate) fn new() -> Self {
        Self {
            stretch: 0.0,
            frame: None,
            spacing_m: SPACING_M[0],
            keys: Box::default(),
            points: Box::default(),
            last: None,
            corners: [Vec4::ZERO; 4],
        }
    }

    /// Where the noise of a point is found.
    #[inline]
    pub(crate) fn at(&mut self, field: &Field, point: ChartPoint) -> DVec3 {
        let frame = match self.frame {
            Some((chart, frame)) if chart == point.chart => frame,
            _ => self.enter(field, point.chart),
        };
        match frame {
            NoiseFrame::Square(frame) => return frame.placed(point.pos),
            NoiseFrame::Upright => return field.strategy().noise_point(point),
            NoiseFrame::Radial { .. } => {}
        }
        let (x, z) = (point.pos.x / self.spacing_m, point.pos.z / self.spacing_m);
        let (i, k) = (x.floor(), z.floor());
        let square = Some((point.chart, i, k));
        if self.last != square {
            self.last = square;
            self.corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)]
                .map(|(a, b)| self.node(field, point.chart, (i + a) as i32, (k + b) as i32));
        }
        let [a, b, c, d] = self.corners;
        let (u, w) = ((x - i) as f32, (z - k) as f32);
        let (near, far) = (a.lerp(b, u), c.lerp(d, u));
        let chord = near.lerp(far, w);
        // Out to the sphere again: a step of Newton's towards 1 / |chord|.
        let stretch = self.stretch as f32;
        let length = chord.length_squared() * (stretch * stretch);
        let place = chord * ((1.5 - 0.5 * length) * (1.0 + point.pos.y as f32 * stretch));
        place.truncate().as_dvec3()
    }

    /// Forgets the places of another chart.
    fn enter(&mut self, field: &Field, chart: ChartId) -> NoiseFrame {
        let frame = field.strategy().noise_frame(chart);
        self.frame = Some((chart, frame));
        if let NoiseFrame::Radial { radius_m } = frame {
            self.stretch = radius_m.recip();
            self.spacing_m = SPACING_M[usize::from(radius_m >= 32.0)];
            self.last = None;
            self.keys = vec![NO_PLACE; PLACES * PLACES].into_boxed_slice();
            self.points = vec![Vec4::ZERO; PLACES * PLACES].into_boxed_slice();
        }
        frame
    }

    fn node(&mut self, field: &Field, chart: ChartId, i: i32, k: i32) -> Vec4 {
        let wrapped = |n: i32| n.cast_unsigned() as usize % PLACES;
        let at = wrapped(i) * PLACES + wrapped(k);
        let key = u64::from(i.cast_unsigned()) << 32 | u64::from(k.cast_unsigned());
        if self.keys[at] != key {
            let ground = DVec3::new(f64::from(i), 0.0, f64::from(k)) * self.spacing_m;
            let place = field.strategy().noise_point(ChartPoint::new(chart, ground));
            self.keys[at] = key;
            self.points[at] = place.as_vec3().extend(0.0);
        }
        self.points[at]
    }
}
