//! How far straight chart edges are bent by the port, measured on the space at hand.
//!
//! An edge of length L strays from the straight line that is drawn between its ported ends, at its middle, by half the
//! port's second derivative times (L/2)^2: by `bend L^2`. Seen from the eye the bend depends on the distance and on how
//! high above level the edge lies; land, which mostly lies below level, is bent several times less by the horizon map
//! than what stands at the same distance overhead.

use antipode_geometry::{ChartPoint, Eye, Strategy};
use glam::{DVec3, IVec3};

/// Chart distances at which the bend is measured, metres, each twice the one before; beyond the last it only falls.
const DISTANCES_M: [f64; 10] = [0.35, 0.7, 1.4, 2.8, 5.6, 11.2, 22.4, 44.8, 89.6, 179.2];
/// Elevations at which the bend is measured, as sines: what bounds the bands, and nearly so at the ends.
const SINES: [f64; BANDS + 1] = [-0.97, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 0.97];
/// Bands of elevation: equal parts of the sines from -1 to 1.
pub const BANDS: usize = 8;
/// Length of the edges it is measured with, metres.
const EDGE_M: f64 = 0.25;
/// Where a chart is not the same along all azimuths, so many of them are looked at, and only these elevations.
const AZIMUTHS: u32 = 4;
const FEW_SINES: [f64; 3] = [-0.5, -0.05, 0.4];
/// The measured bend is raised by this, since only some places and directions are looked at: 1.45 is what the worst of
/// a million others needed, between two elevations.
const MARGIN: f64 = 1.5;
/// The bend is measured to this part of the sight limit; beyond it the haze hides it.
const MEASURED_TO: f64 = 0.9;
/// Places up to this many times as far from the pole as the rim count: what is measured for one eye holds for others
/// near by, which see places farther out.
const OVER_RIM: f64 = 1.02;
/// Bends are raised to the next of this many steps an octave, so that they stay the same for a while as the eye
/// and the dial move, and what was refined for one stays right.
const STEPS_PER_OCTAVE: f64 = 8.0;

/// The measured bends in steps of an octave: two frames with the same need the same refinement.
pub type BendSteps = [[i16; DISTANCES_M.len()]; SINES.len()];

/// The bend by elevation and distance.
#[derive(Clone, Debug)]
pub struct Bend {
    /// Pixels per square metre at each of the distances, for each of the elevations.
    px: [[f64; DISTANCES_M.len()]; SINES.len()],
    /// The most over all elevations.
    most: [f64; DISTANCES_M.len()],
    steps: BendSteps,
}

impl Bend {
    /// No bend anywhere.
    pub fn none() -> Self {
        Self::raised([[0.0; DISTANCES_M.len()]; SINES.len()])
    }

    /// Measures a curved port; `px` turns angles to pixels where the picture is stretched most.
    pub fn measure(space: &dyn Strategy, eye: &Eye, px: impl Fn(f64) -> f64) -> Self {
        let farthest_m = MEASURED_TO * space.sight_limit_m(eye);
        let at = |distance_m: f64, sine| {
            let bend = bend_at(space, eye, distance_m.min(farthest_m), sine);
            MARGIN * px(bend) / (EDGE_M * EDGE_M)
        };
        if space.keeps_azimuths() {
            return Self::raised(SINES.map(|sine| DISTANCES_M.map(|d| at(d, sine))));
        }
        // Off its pole a chart of the sphere looks different along each azimuth, though less along each elevation.
        let of_few = |d: f64| {
            FEW_SINES
                .map(|sine| at(d, sine))
                .into_iter()
                .fold(0.0, f64::max)
        };
        Self::raised([DISTANCES_M.map(of_few); SINES.len()])
    }

    fn raised(mut px: [[f64; DISTANCES_M.len()]; SINES.len()]) -> Self {
        // What is farther may not be taken for straighter than what is nearer was found to be needed.
        for bend in &mut px {
            for i in (1..bend.len()).rev() {
                bend[i - 1] = f64::max(bend[i - 1], bend[i]);
            }
        }
        let steps = px.map(|bend| bend.map(|bend| (bend.log2() * STEPS_PER_OCTAVE).ceil()));
        let px = steps.map(|bend| bend.map(|step| (step / STEPS_PER_OCTAVE).exp2()));
        let most = |i: usize| px.iter().map(|bend| bend[i]).fold(0.0, f64::max);
        Self {
            px,
            most: std::array::from_fn(most),
            steps: steps.map(|bend| bend.map(|step| step.max(f64::from(i16::MIN)) as i16)),
        }
    }

    /// The bends in steps of an octave.
    pub fn steps(&self) -> BendSteps {
        self.steps
    }

    /// Pixels per square metre by which edges stray at a chart distance from the eye, at any elevation.
    pub fn at(&self, distance_m: f64) -> f64 {
        along(&self.most, distance_m)
    }

    /// The most of the same over elevations whose sines lie between two.
    pub fn between(&self, distance_m: f64, [low, high]: [f64; 2]) -> f64 {
        // Whole bands: what lies in one is bent by no more than its borders.
        let first = (((low.max(-1.0) + 1.0) * HALF_BANDS) as usize).min(BANDS - 1);
        let last = (((high.min(1.0) + 1.0) * HALF_BANDS) as usize).clamp(first, BANDS - 1);
        let found = self.px[first..=last + 1]
            .iter()
            .map(|bend| along(bend, distance_m));
        found.fold(0.0, f64::max)
    }

    /// Edges up to so long that are farther than this stray by less than so many pixels, metres along the chart.
    pub fn strays_within_m(&self, longest_edge_m: f64, px: f64) -> f64 {
        let longest = longest_edge_m.powi(2);
        let strays = |bend: &f64| bend * longest > px;
        let Some(step) = self.most.iter().rposition(strays) else {
            return 0.0;
        };
        let Some(next) = self.most.get(step + 1) else {
            return f64::INFINITY;
        };
        let level = px / longest;
        let part = (self.most[step] - level) / (self.most[step] - next);
        DISTANCES_M[step] * part.exp2()
    }
}

const HALF_BANDS: f64 = 0.5 * BANDS as f64;

/// The band that a sine of the elevation lies in.
#[inline]
pub fn band(sine: f32) -> usize {
    // Saturates: no number lies in the first band.
    (((sine + 1.0) * HALF_BANDS as f32) as usize).min(BANDS - 1)
}

/// The sines between which a band lies.
pub fn sines(band: usize) -> [f64; 2] {
    [band, band + 1].map(|border| border as f64 / HALF_BANDS - 1.0)
}

fn along(bend: &[f64; DISTANCES_M.len()], distance_m: f64) -> f64 {
    // Nearer than the first distance the bend goes on as 1/d.
    if distance_m < DISTANCES_M[0] {
        return bend[0] * DISTANCES_M[0] / distance_m.max(0.05);
    }
    let last = DISTANCES_M.len() - 1;
    let place = (distance_m / DISTANCES_M[0]).log2().clamp(0.0, last as f64);
    let step = (place as usize).min(last - 1);
    // Along straight lines over the logarithm of the distance: the bend is convex there.
    let part = place - step as f64;
    bend[step] + (bend[step + 1] - bend[step]) * part
}

/// The largest angle by which the middle of a chart edge of [`EDGE_M`], that far from the eye, lies off the
/// geodesic between its ends, as seen from the eye. Places are turned about the upright, which all maps look the same
/// along.
fn bend_at(space: &dyn Strategy, eye: &Eye, distance_m: f64, sine: f64) -> f64 {
    let azimuths = if space.keeps_azimuths() { 1 } else { AZIMUTHS };
    let level = (1.0_f64 - sine * sine).sqrt();
    let mut worst: f64 = 0.0;
    for azimuth in 0..azimuths {
        let turn = f64::from(azimuth) * std::f64::consts::TAU / f64::from(azimuths);
        let toward = DVec3::new(level * turn.cos(), sine, level * turn.sin());
        let middle = eye.point.moved(toward * distance_m);
        let edge_m = space.domain(middle.chart).half_width_m();
        if middle.pos.x.hypot(middle.pos.z) <= OVER_RIM * edge_m {
            let expansion = Expansion::new(space, eye, middle);
            // Of one azimuth the middle lies in the plane z = 0, and on both sides of it all looks the same.
            let ways = edge_ways().filter(|way| azimuths > 1 || way.z > 0.0);
            worst = ways.map(|way| expansion.bend(way)).fold(worst, f64::max);
        }
    }
    worst
}

/// The view point of a place, expanded about it to second order along the axes.
struct Expansion {
    seen: DVec3,
    /// Half the edge along each axis.
    slope: [DVec3; 3],
    /// Half the second differences: along each axis, and along y and z, z and x, x and y together.
    bend: [DVec3; 6],
}

impl Expansion {
    fn new(space: &dyn Strategy, eye: &Eye, middle: ChartPoint) -> Self {
        let at = |x: f64, y: f64, z: f64| {
            let step = DVec3::new(x, y, z) * (0.5 * EDGE_M);
            space.view_point(eye, middle.moved(step)).truncate()
        };
        let seen = at(0.0, 0.0, 0.0);
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|way| {
            let [ahead, behind] = [1.0, -1.0].map(|by| at(by * way.x, by * way.y, by * way.z));
            (0.5 * (ahead - behind), 0.5 * (ahead + behind) - seen)
        });
        // f(y + z) = f + f_y + f_z + f_yy + f_zz + f_yz.
        let both = |corner: DVec3, a: (DVec3, DVec3), b: (DVec3, DVec3)| {
            corner - seen - a.0 - b.0 - a.1 - b.1
        };
        Self {
            bend: [
                x.1,
                y.1,
                z.1,
                both(at(0.0, 1.0, 1.0), y, z),
                both(at(1.0, 0.0, 1.0), z, x),
                both(at(1.0, 1.0, 0.0), x, y),
            ],
            slope: [x.0, y.0, z.0],
            seen,
        }
    }

    /// The angle of an edge along a direction.
    fn bend(&self, way: DVec3) -> f64 {
        let [x, y, z] = self.slope;
        let along = x * way.x + y * way.y + z * way.z;
        let [xx, yy, zz, yz, zx, xy] = self.bend;
        let off = xx * (way.x * way.x) + yy * (way.y * way.y) + zz * (way.z * way.z);
        let off = off + yz * (way.y * way.z) + zx * (way.z * way.x) + xy * (way.x * way.y);
        let middle = self.seen + off;
        off_line(self.seen, [middle + along, middle - along])
    }
}

/// The angle between a direction and the plane of two others; 0 where they span none.
pub(super) fn off_line(seen: DVec3, [a, b]: [DVec3; 2]) -> f64 {
    let across = a.cross(b);
    let off = across.dot(seen) / (across.length() * seen.length());
    if off.is_finite() && across.length() > 1e-6 * a.length() * b.length() {
        off.abs().min(1.0).asin()
    } else {
        0.0
    }
}

/// Directions of edges, of which opposite ones are the same: those from the middle of a cube to the crossings of a grid
/// of four by four cells on its faces, at most 27 degrees apart.
fn edge_ways() -> impl Iterator<Item = DVec3> {
    (63..125).filter_map(|i| {
        let way = IVec3::new(i % 5, i / 5 % 5, i / 25) - 2;
        (way.abs().max_element() == 2).then(|| way.as_dvec3().normalize())
    })
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{Geometry, HyperbolicMap, picture};

    use super::*;

    /// The same numbers on every run, between -1 and 1.
    fn numbers() -> impl FnMut() -> f64 {
        let mut state: u64 = 7;
        move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    #[test]
    fn no_edge_anywhere_strays_by_more_than_its_band_says() {
        let mut number = numbers();
        for (geometry, map, bent) in [
            (Geometry::Hyperbolic, HyperbolicMap::Raised, false),
            (Geometry::Hyperbolic, HyperbolicMap::Horizon, false),
            (Geometry::Euclidean, HyperbolicMap::Raised, true),
            (Geometry::Spherical, HyperbolicMap::Raised, false),
        ] {
            let space = picture(geometry, 32.0, map, bent);
            for dial in [1.0, 10.0, 20.0] {
                let eye = Eye {
                    point: ChartPoint::a(DVec3::new(3.0, 5.0, -2.0)),
                    dial,
                    lift_m: 1.62,
                    ..Eye::default()
                };
                let bend = Bend::measure(space.as_ref(), &eye, |angle| angle);
                let mut tightest: f64 = 0.0;
                for _ in 0..20_000 {
                    let toward = DVec3::new(number(), number(), number()).normalize();
                    let distance_m = 0.4 * 40.0_f64.powf(0.5 + 0.5 * number());
                    let middle = eye.point.moved(toward * distance_m);
                    let way = DVec3::new(number(), number(), number()).normalize();
                    let ends = [0.125, -0.125]
                        .map(|half| space.view_point(&eye, middle.moved(way * half)).truncate());
                    let seen = space.view_point(&eye, middle).truncate();
                    let strays = off_line(seen, ends) / (EDGE_M * EDGE_M);
                    let told = bend.between(distance_m, [toward.y; 2]);
                    assert!(
                        strays <= told,
                        "{geometry:?} {map:?} {dial}: {toward} at {distance_m} m along {way}: {strays} {told}"
                    );
                    tightest = tightest.max(strays / told);
                }
                assert!(tightest > 0.5, "{geometry:?} {map:?} {dial}: {tightest}");
            }
        }
    }

    #[test]
    fn sines_lie_in_the_band_that_says_so() {
        for sine in [-1.0, -0.99, -0.5, -0.2, 0.0, 0.3, 0.999, 1.0] {
            let [low, high] = sines(band(sine));
            assert!(
                (low..=high).contains(&f64::from(sine)),
                "{sine} {low} {high}"
            );
        }
        assert_eq!(band(f32::NAN), 0);
    }
}
