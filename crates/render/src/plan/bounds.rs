//! How large errors come out in pixels, measured on the space at hand.
//!
//! The port bends a straight chart edge of length L away from the straight edge that is drawn between its
//! ported ends, at its middle, by half the port's second derivative times (L/2)^2. That second derivative,
//! seen as an angle and turned to pixels, is all that the choices need: an edge strays by `bend L^2`, and a
//! first-order frame about the middle of something of diameter L by no more at its ends.

use antipode_geometry::{ChartPoint, Eye, Geometry, Projection, SightCell, Strategy};
use antipode_scene::frame::Frame;
use glam::{DMat3, DVec3, DVec4};

use super::ChunkLand;
use super::quality::Tolerance;

/// Chart distances at which the bend is measured, metres, each twice the one before; beyond the last it only falls.
const DISTANCES_M: [f64; 10] = [0.35, 0.7, 1.4, 2.8, 5.6, 11.2, 22.4, 44.8, 89.6, 179.2];
/// Length of the edges it is measured with, metres.
const EDGE_M: f64 = 0.25;
/// Elevations of the places looked at, as sines.
const ELEVATIONS: [f64; 5] = [-0.95, -0.5, -0.05, 0.4, 0.9];
/// Azimuths looked at where the chart is not the same along all.
const AZIMUTHS: u32 = 4;
/// The measured bend is raised by this, since only some places and directions are looked at.
const MARGIN: f64 = 1.25;
/// The bend is measured to this part of the sight limit; beyond it the haze hides it.
const MEASURED_TO: f64 = 0.9;
/// Bends are raised to the next of this many steps an octave, so that they stay the same for a while as the eye
/// and the dial move, and what was refined for one stays right.
const STEPS_PER_OCTAVE: f64 = 8.0;
/// A frame is looked at closely where the bend allows for this many times the tolerance.
const FRAME_WORTH_TRYING: f64 = 4.0;
/// Frames of neighbouring chunks part at their border by up to twice their errors: they may take up no more than
/// this part of the tolerance, or the crack would show.
const CRACK_SHARE: f64 = 0.1;

/// Pixels per radian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureScale {
    /// In the middle of the picture.
    focal_px: f64,
    /// In its corners, as a multiple of that.
    stretch: f64,
}

impl PictureScale {
    /// The scale of a picture `height_px` pixels high.
    pub fn new(projection: &Projection, height_px: u32) -> Self {
        Self {
            focal_px: projection.sy * 0.5 * f64::from(height_px),
            stretch: 1.0 + projection.sx.powi(-2) + projection.sy.powi(-2),
        }
    }

    /// What an angle comes to in pixels where the picture is stretched most.
    pub fn widest_px(&self, angle_rad: f64) -> f64 {
        angle_rad * self.focal_px * self.stretch
    }

    /// What a cell of directions spans at most, in pixels.
    pub fn spans_px(&self, cell: &SightCell) -> f64 {
        let upright_rad = cell.slope[1].atan() - cell.slope[0].atan();
        self.widest_px(upright_rad.max(2.0 * cell.half_width_rad))
    }
}

/// The port's first-order map about a point: view coordinates of `origin + x` are `base + columns x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// View coordinates of the origin.
    pub base: DVec4,
    /// View coordinates per chart metre along x, y and z.
    pub columns: [DVec4; 3],
}

impl Affine {
    /// About `middle`, for positions relative to `origin`, both in chart metres.
    fn about(
        space: &dyn Strategy,
        eye: &Eye,
        middle: ChartPoint,
        origin: DVec3,
        step_m: f64,
    ) -> Self {
        let columns = DMat3::IDENTITY.to_cols_array_2d().map(|axis| {
            let step = DVec3::from_array(axis) * step_m;
            let ahead = space.view_point(eye, middle.moved(step));
            let behind = space.view_point(eye, middle.moved(-step));
            (ahead - behind) / (2.0 * step_m)
        });
        let mut affine = Self {
            base: space.view_point(eye, middle),
            columns,
        };
        affine.base = affine.at(origin - middle.pos);
        affine
    }

    /// View coordinates at `x` metres from the origin.
    pub fn at(&self, x: DVec3) -> DVec4 {
        let [i, j, k] = self.columns;
        self.base + i * x.x + j * x.y + k * x.z
    }
}

/// The measured bends in steps of an octave: two frames with the same need the same refinement.
pub type BendSteps = [i16; DISTANCES_M.len()];

/// The bend of a frame's port.
#[derive(Clone, Debug)]
pub struct Bounds {
    scale: PictureScale,
    /// Pixels per square metre at each of the distances.
    bend: [f64; DISTANCES_M.len()],
    /// The same in steps of an octave.
    steps: BendSteps,
    /// First-order map about the eye. All chunks that are ported as a whole share it, and so the bits of their
    /// borders.
    affine: Affine,
    flat: bool,
    /// Whether depth is not linear in the picture.
    pub depth_is_bent: bool,
}

impl Bounds {
    /// Measures the port of a frame.
    pub fn measure(frame: &Frame, scale: PictureScale) -> Self {
        let (space, eye) = (frame.strategy.as_ref(), &frame.eye);
        let flat = !space.radius_at_m(eye).is_finite();
        let mut bend = [0.0; DISTANCES_M.len()];
        if !flat {
            let farthest_m = MEASURED_TO * space.sight_limit_m(eye);
            let distances = DISTANCES_M.map(|distance_m| distance_m.min(farthest_m));
            for (bend, distance_m) in bend.iter_mut().zip(distances) {
                *bend =
                    MARGIN * scale.widest_px(bend_at(space, eye, distance_m)) / (EDGE_M * EDGE_M);
            }
        }
        // What is farther may not be taken for straighter than what is nearer was found to be needed.
        for i in (1..bend.len()).rev() {
            bend[i - 1] = f64::max(bend[i - 1], bend[i]);
        }
        let steps = bend.map(|bend| (bend.log2() * STEPS_PER_OCTAVE).ceil());
        let bend = steps.map(|step| (step / STEPS_PER_OCTAVE).exp2());
        let affine = Affine::about(
            space,
            eye,
            eye.point,
            space.reference(eye, eye.point.hemisphere),
            1.0,
        );
        Self {
            flat,
            affine,
            scale,
            bend,
            steps: steps.map(|step| step.max(f64::from(i16::MIN)) as i16),
            depth_is_bent: !flat && space.geometry() != Geometry::Spherical,
        }
    }

    /// Pixels per square metre by which edges stray at a chart distance from the eye.
    pub fn bend_px(&self, distance_m: f64) -> f64 {
        // Nearer than the first distance the bend goes on as 1/d.
        if distance_m < DISTANCES_M[0] {
            return self.bend[0] * DISTANCES_M[0] / distance_m.max(0.05);
        }
        let last = DISTANCES_M.len() - 1;
        let place = (distance_m / DISTANCES_M[0]).log2().clamp(0.0, last as f64);
        let step = (place as usize).min(last - 1);
        // Along straight lines over the logarithm of the distance: the bend is convex there.
        let part = place - step as f64;
        self.bend[step] + (self.bend[step + 1] - self.bend[step]) * part
    }

    /// Edges of the land up to so long that are farther than this keep to the tolerance as they are, metres along
    /// the chart.
    pub fn refine_within_m(&self, tolerance: &Tolerance, longest_edge_m: f64) -> f64 {
        let longest = longest_edge_m.powi(2);
        let strays = |bend: &f64| bend * longest > tolerance.shape_px;
        let Some(step) = self.bend.iter().rposition(strays) else {
            return 0.0;
        };
        let Some(next) = self.bend.get(step + 1) else {
            return f64::INFINITY;
        };
        let level = tolerance.shape_px / longest;
        let part = (self.bend[step] - level) / (self.bend[step] - next);
        DISTANCES_M[step] * part.exp2()
    }

    /// Chart distance from the eye to the nearest corner, edge or face of a chunk's land, metres.
    pub fn nearest_chart_m(frame: &Frame, chunk: &ChunkLand) -> f64 {
        let mut eye = frame.eye.point;
        if eye.hemisphere != chunk.coord.hemisphere {
            match frame.strategy.carry(eye) {
                Some(crossing) => eye = crossing.point,
                None => return f64::INFINITY,
            }
        }
        eye.pos.distance(eye.pos.clamp(chunk.min, chunk.max))
    }

    /// The chunk's frame and its error in pixels, if it stays within the tolerance.
    pub fn affine(
        &self,
        frame: &Frame,
        chunk: &ChunkLand,
        tolerance_px: f64,
    ) -> Option<(Affine, f64)> {
        if self.flat {
            return Some((self.affine, 0.0));
        }
        if chunk.coord.hemisphere != frame.eye.point.hemisphere {
            return None;
        }
        let tolerance_px = CRACK_SHARE * tolerance_px;
        let size = chunk.max - chunk.min;
        let guess = self.bend_px(Self::nearest_chart_m(frame, chunk)) * size.length_squared();
        if guess > FRAME_WORTH_TRYING * tolerance_px {
            return None;
        }
        let middle = ChartPoint::new(chunk.coord.hemisphere, 0.5 * (chunk.min + chunk.max));
        let origin = frame.strategy.reference(&frame.eye, chunk.coord.hemisphere);
        let error_px = self.strays_px(frame, &self.affine, middle, origin, 0.5 * size)?;
        (error_px <= tolerance_px).then_some((self.affine, error_px))
    }

    /// The measured bends in steps of an octave.
    pub fn steps(&self) -> BendSteps {
        self.steps
    }

    /// The frame of something that stands at `feet` and fits a box of `half` metres about `middle`.
    pub fn object(
        &self,
        frame: &Frame,
        feet: ChartPoint,
        middle: ChartPoint,
        half: DVec3,
        tolerance_px: f64,
    ) -> Option<(Affine, f64)> {
        let affine = Affine::about(frame.strategy.as_ref(), &frame.eye, middle, feet.pos, 0.1);
        let error_px = self.strays_px(frame, &affine, middle, feet.pos, half)?;
        (error_px <= tolerance_px).then_some((affine, error_px))
    }

    /// The largest angle between port and frame over the box, in pixels; `None` where a frame cannot be
    /// used: at the eye itself.
    fn strays_px(
        &self,
        frame: &Frame,
        affine: &Affine,
        middle: ChartPoint,
        origin: DVec3,
        half: DVec3,
    ) -> Option<f64> {
        let mut worst: f64 = 0.0;
        for i in 0..27 {
            let place = DVec3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)) - 1.0;
            let point = middle.moved(place * half);
            let truth = frame.strategy.view_point(&frame.eye, point).truncate();
            let framed = affine.at(point.pos - origin).truncate();
            let angle = truth.cross(framed).length().atan2(truth.dot(framed));
            worst = worst.max(angle);
        }
        (worst < 0.1).then(|| MARGIN * self.scale.widest_px(worst))
    }
}

/// The largest angle by which the middle of a chart edge of [`EDGE_M`], that far from the eye, lies off the
/// geodesic between its ends, as seen from the eye. Places and edges are turned about the upright, which all
/// maps look the same along.
fn bend_at(space: &dyn Strategy, eye: &Eye, distance_m: f64) -> f64 {
    let azimuths = if space.keeps_azimuths() { 1 } else { AZIMUTHS };
    // Off its pole a chart of the sphere looks different along each azimuth, though less along each elevation.
    let elevations = if azimuths == 1 {
        &ELEVATIONS[..]
    } else {
        &ELEVATIONS[1..4]
    };
    let mut worst: f64 = 0.0;
    for azimuth in 0..azimuths {
        let turn = f64::from(azimuth) * std::f64::consts::TAU / f64::from(azimuths);
        for sine in elevations {
            let level = (1.0_f64 - sine * sine).sqrt();
            let toward = DVec3::new(level * turn.cos(), *sine, level * turn.sin());
            let middle = eye.point.moved(toward * distance_m);
            let in_chart = |rim_m: f64| middle.pos.x.hypot(middle.pos.z) <= rim_m;
            if space.rim_m().is_none_or(in_chart) {
                worst = worst.max(bend_about(space, eye, middle));
            }
        }
    }
    worst
}

/// The same about one place.
fn bend_about(space: &dyn Strategy, eye: &Eye, middle: ChartPoint) -> f64 {
    let seen = space.view_point(eye, middle).truncate();
    let mut worst: f64 = 0.0;
    for way in edge_ways() {
        let half = way * (0.5 * EDGE_M);
        let a = space.view_point(eye, middle.moved(half)).truncate();
        let b = space.view_point(eye, middle.moved(-half)).truncate();
        let across = a.cross(b);
        let off = across.dot(seen) / (across.length() * seen.length());
        if off.is_finite() && across.length() > 1e-6 * a.length() * b.length() {
            worst = worst.max(off.abs().min(1.0).asin());
        }
    }
    worst
}

/// Thirteen directions that differ by at most 45 degrees: the axes and diagonals of a cube.
fn edge_ways() -> impl Iterator<Item = DVec3> {
    (14..27)
        .map(|i| DVec3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)) - 1.0)
        .map(DVec3::normalize)
}
