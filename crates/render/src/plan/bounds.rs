//! Bounds errors in pixels, by measuring the space that is drawn.
//!
//! An edge strays by `bend L^2` (see [`Bend`]), and a first-order frame about the middle of something of diameter L by
//! no more at its ends.

use antipode_frame::{Frame, View};
use antipode_geometry::tiled::as_seen_from;
use antipode_geometry::{
    CHUNK_CELLS, ChartId, ChartPoint, Domain, Eye, Projection, SightCell, Strategy, side_normals,
};
use glam::{DMat3, DVec3, DVec4};

use super::ChunkLand;
use super::bend::{Bend, BendSteps};
use super::quality::Tolerance;

/// What a frame strays by is raised by this, since only some places are looked at.
const MARGIN: f64 = 1.25;
/// In a closed space the bend is measured at steps of this part of its radius: from one to the next it changes by less
/// than it is raised by.
const BEND_STEP: f64 = 1.0 / 64.0;
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

    /// A picture wider by so many pixels on each side: its edges, at tangents of 1 / s, lie px / focal farther out.
    fn widened(&self, projection: &Projection, px: f64) -> Projection {
        let [sx, sy] = [projection.sx, projection.sy].map(|s| s / (1.0 + s * px / self.focal_px));
        Projection {
            sx,
            sy,
            ..*projection
        }
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
        let view = space.viewer(eye);
        let columns = DMat3::IDENTITY.to_cols_array_2d().map(|axis| {
            let step = DVec3::from_array(axis) * step_m;
            let ahead = view(middle.moved(step));
            let behind = view(middle.moved(-step));
            (ahead - behind) / (2.0 * step_m)
        });
        let mut affine = Self {
            base: view(middle),
            columns,
        };
        affine.base = affine.at(origin - middle.pos);
        affine
    }

    /// The same as a picture has it, after its isometry.
    #[must_use]
    pub fn moved(&self, view: &View) -> Self {
        Self {
            base: view.moved(self.base),
            columns: self.columns.map(|column| view.moved(column)),
        }
    }

    /// The same for positions in the common axes, of one for those of a chart.
    ///
    /// A position x there is one of the chart that is turned: with T the turn, columns T^-1 x is x along columns T^T, since
    /// T is orthogonal.
    fn in_common_axes(self, frame: &Frame, chart: ChartId) -> Self {
        let [x, y, z] = DVec3::AXES.map(|axis| frame.view.in_common_axes(chart, axis));
        let turned = DMat3::from_cols(x, y, z);
        let [i, j, k] = self.columns;
        let along = |to: DVec3| i * to.x + j * to.y + k * to.z;
        Self {
            columns: [turned.row(0), turned.row(1), turned.row(2)].map(along),
            ..self
        }
    }

    /// View coordinates at `x` metres from the origin.
    pub fn at(&self, x: DVec3) -> DVec4 {
        let [i, j, k] = self.columns;
        self.base + i * x.x + j * x.y + k * x.z
    }
}

/// The bend of a frame's port.
#[derive(Clone, Debug)]
pub struct Bounds {
    scale: PictureScale,
    /// By how many pixels edges stray.
    pub bend: Bend,
    /// First-order map about the eye, for positions in the common axes. All chunks that are ported as a whole share it, and
    /// so the bits of their borders.
    affine: Affine,
    /// The same for positions in the axes of the eye's chart.
    own_affine: Affine,
    flat: bool,
    /// Whether depth is not linear in the picture.
    pub depth_is_bent: bool,
}

impl Bounds {
    /// Measures the port of a frame.
    pub fn measure(frame: &Frame, scale: PictureScale) -> Self {
        Self::new(frame, scale, Self::measure_bend(frame, scale))
    }

    /// The eye that a frame's bend is measured for, the same for a while as the eye moves. Where it looks does not
    /// matter; nor, in the one chart of an open space, where it stands, since everything there is ported by how it
    /// lies from the eye. In a chart with a rim it is a place near by, rather nearer to the pole.
    pub fn bend_eye(frame: &Frame) -> Eye {
        let mut point = ChartPoint::default();
        if frame.view.strategy.domain(frame.view.eye.point.chart) != Domain::Everywhere {
            let step_m = frame.view.strategy.radius_at_m(&frame.view.eye) * BEND_STEP;
            point = frame.view.eye.point;
            point.pos = (point.pos / step_m).trunc() * step_m;
        }
        Eye {
            point,
            yaw: 0.0,
            pitch: 0.0,
            ..frame.view.eye
        }
    }

    /// Measures the bend alone.
    pub fn measure_bend(frame: &Frame, scale: PictureScale) -> Bend {
        let (space, eye) = (frame.view.strategy.as_ref(), Self::bend_eye(frame));
        if space.radius_at_m(&eye).is_finite() {
            Bend::measure(space, &eye, |angle_rad| scale.widest_px(angle_rad))
        } else {
            Bend::none()
        }
    }

    /// The bounds of a frame whose bend is known.
    pub fn new(frame: &Frame, scale: PictureScale, bend: Bend) -> Self {
        let (space, eye) = (frame.view.strategy.as_ref(), &frame.view.eye);
        let flat = !space.radius_at_m(eye).is_finite();
        let origin = space.reference(eye, eye.point.chart);
        let own_affine = Affine::about(space, eye, eye.point, origin, 1.0);
        Self {
            flat,
            affine: own_affine.in_common_axes(frame, eye.point.chart),
            own_affine,
            scale,
            bend,
            depth_is_bent: !flat && space.shader().bends_depth,
        }
    }

    /// Pixels per square metre by which edges stray at a chart distance from the eye.
    pub fn bend_px(&self, distance_m: f64) -> f64 {
        self.bend.at(distance_m)
    }

    /// How many pixels a metre takes that is a metre off, in the middle of the picture.
    pub fn near_px(&self) -> f64 {
        self.scale.focal_px
    }

    /// How many pixels a metre takes at a place, were it in the middle of the picture: the longest of three that lie along the
    /// axes.
    pub fn metre_px_at(&self, frame: &Frame, place: ChartPoint) -> f64 {
        let view = frame.view.strategy.viewer(&frame.view.eye);
        let direction = |by: DVec3| view(place.moved(by)).truncate().normalize_or_zero();
        let angle = |axis: DVec3| direction(0.5 * axis).distance(direction(-0.5 * axis));
        let most_rad = DVec3::AXES.map(angle).into_iter().fold(0.0, f64::max);
        most_rad * self.scale.focal_px
    }

    /// How many pixels a metre of a chunk takes at most, in the mean over its side.
    pub fn metre_px(&self, cell: &SightCell) -> f64 {
        self.scale.spans_px(cell) / f64::from(CHUNK_CELLS)
    }

    /// Edges of the land up to so long that are farther than this keep to the tolerance as they are, metres along
    /// the chart.
    pub fn refine_within_m(&self, tolerance: &Tolerance, longest_edge_m: f64) -> f64 {
        self.bend
            .strays_within_m(longest_edge_m, tolerance.shape_px)
    }

    /// Chart distance from the eye to the nearest corner, edge or face of a chunk's land, metres.
    pub fn nearest_chart_m(frame: &Frame, chunk: &ChunkLand) -> f64 {
        let middle = ChartPoint::new(chunk.coord.chart, 0.5 * (chunk.min + chunk.max));
        let eye = as_seen_from(&*frame.view.strategy, middle, frame.view.eye.point);
        eye.map_or(f64::INFINITY, |eye| {
            eye.distance(eye.clamp(chunk.min, chunk.max))
        })
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
        if chunk.coord.chart != frame.view.eye.point.chart {
            return None;
        }
        let tolerance_px = CRACK_SHARE * tolerance_px;
        let [low, high] = chunk.whole;
        let size = high - low;
        let guess = self.bend_px(Self::nearest_chart_m(frame, chunk)) * size.length_squared();
        if guess > FRAME_WORTH_TRYING * tolerance_px {
            return None;
        }
        let middle = ChartPoint::new(chunk.coord.chart, 0.5 * (low + high));
        let origin = frame
            .view
            .strategy
            .reference(&frame.view.eye, chunk.coord.chart);
        let framed = |point: ChartPoint| self.own_affine.at(point.pos - origin);
        let error_px = self.strays_px(frame, framed, middle, 0.5 * size)?;
        (error_px <= tolerance_px).then_some((self.affine, error_px))
    }

    /// The measured bends in steps of an octave.
    pub fn steps(&self) -> BendSteps {
        self.bend.steps()
    }

    /// The sides of the picture's pyramid, wider by so many pixels, by their inward normals in view coordinates: what
    /// is farther out by more than it strays is not in the picture.
    pub fn sides(&self, frame: &Frame, px: f64) -> [DVec3; 4] {
        side_normals(&self.scale.widened(&frame.view.projection, px))
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
        let affine = Affine::about(
            frame.view.strategy.as_ref(),
            &frame.view.eye,
            middle,
            feet.pos,
            0.1,
        );
        let framed = |point: ChartPoint| affine.at(point.pos - feet.pos);
        let error_px = self.strays_px(frame, framed, middle, half)?;
        (error_px <= tolerance_px).then_some((affine, error_px))
    }

    /// The largest angle between port and frame over the box, in pixels; `None` where a frame cannot be
    /// used: at the eye itself.
    fn strays_px(
        &self,
        frame: &Frame,
        framed: impl Fn(ChartPoint) -> DVec4,
        middle: ChartPoint,
        half: DVec3,
    ) -> Option<f64> {
        let mut worst: f64 = 0.0;
        let view = frame.view.strategy.viewer(&frame.view.eye);
        for i in 0..27 {
            let place = DVec3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)) - 1.0;
            let point = middle.moved(place * half);
            let truth = view(point).truncate();
            let framed = framed(point).truncate();
            let angle = truth.cross(framed).length().atan2(truth.dot(framed));
            worst = worst.max(angle);
        }
        (worst < 0.1).then(|| MARGIN * self.scale.widest_px(worst))
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::ChartId;

    use super::super::bend::off_line;
    use super::super::testing::{Numbers, frame, spaces};
    use super::*;

    /// The bend is measured for another eye than the frame's.
    #[test]
    fn a_bend_holds_wherever_it_is_used() {
        let mut numbers = Numbers::new(3);
        let scale = PictureScale {
            focal_px: 1.0,
            stretch: 1.0,
        };
        for (name, space, dials) in spaces() {
            for _ in 0..150 {
                let reach_m = space.domain(ChartId::FIRST).radius_m().unwrap_or(900.0);
                let level = numbers.turn() * numbers.between(0.0, reach_m);
                let limits = space.limits();
                let (low, high) = limits.map_or((-50.0, 50.0), |l| (l.bedrock_m, l.ceiling_m));
                let mut frame = frame(&space);
                frame.view.eye.point.pos = DVec3::new(level.x, numbers.between(low, high), level.y);
                frame.view.eye.point.chart = match space.domain(ChartId::FIRST).radius_m() {
                    Some(_) if numbers.between(0.0, 1.0) > 0.5 => ChartId::SECOND,
                    _ => ChartId::FIRST,
                };
                frame.view.eye.yaw = numbers.between(-3.0, 3.0);
                frame.view.eye.dial = numbers.between(dials[0], dials[1]);
                let used = Bounds::measure(&frame, scale).bend;
                if !space.radius_at_m(&frame.view.eye).is_finite() {
                    continue;
                }
                let view = space.viewer(&frame.view.eye);
                for _ in 0..40 {
                    let mut way =
                        || DVec3::from_array([(); 3].map(|()| numbers.between(-1.0, 1.0)));
                    let (toward, along) = (way().normalize(), 0.125 * way().normalize());
                    let distance_m = 0.4 * 40.0_f64.powf(numbers.between(0.0, 1.0));
                    let middle = frame.view.eye.point.moved(toward * distance_m);
                    let is_seen = distance_m < 0.9 * space.sight_limit_m(&frame.view.eye);
                    if is_seen && middle.pos.x.hypot(middle.pos.z) <= reach_m {
                        let ends = [along, -along].map(|half| view(middle.moved(half)).truncate());
                        let strays = off_line(view(middle).truncate(), ends) / 0.25_f64.powi(2);
                        let told = used.between(distance_m, [toward.y; 2]);
                        let at = format!("{name} {:?} {toward} {distance_m}", frame.view.eye);
                        assert!(strays <= told, "{at}: {strays} {told}");
                    }
                }
            }
        }
    }
}
