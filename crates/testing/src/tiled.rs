//! Flat space in charts without number: one for each square of 64 m, turned by quarter turns as its place says. What
//! happens in it must be what happens in flat space of one chart; only how it is written differs.

use std::f64::consts::FRAC_PI_2;

use antipode_geometry::{
    Atlas, BoundingCylinder, ChartId, ChartPoint, Crossing, Curvature, Domain, Euclidean, Eye, Map,
    MapShader, Metric, NoiseFrame, Optics, Projection, SightCell, SpaceUniform, SquareFrame,
};
use glam::{DMat4, DVec2, DVec3, DVec4, I64Vec2};

/// Edge of a square, metres.
pub const TILE_M: f64 = 64.0;
/// How far past an edge a body goes before it changes charts, metres.
const HYSTERESIS_M: f64 = 0.2;

/// Flat space in squares.
#[derive(Debug, Clone, Copy, Default)]
pub struct TiledFlat;

impl TiledFlat {
    /// The chart of a square, counted along x and z from the one in the middle.
    pub fn chart(tile: I64Vec2) -> ChartId {
        let half = |index: i64| u128::from(index as u32);
        ChartId::new(half(tile.x) << 32 | half(tile.y))
    }

    /// The square of a chart.
    pub fn tile(chart: ChartId) -> I64Vec2 {
        let number = chart.number();
        let half = |bits: u128| i64::from(bits as u32 as i32);
        I64Vec2::new(half(number >> 32), half(number))
    }

    /// How a chart lies in the flat space of one chart.
    pub fn frame(chart: ChartId) -> SquareFrame {
        let tile = Self::tile(chart);
        // The end of SplitMix64 (Steele, Lea and Flood 2014).
        let mut mixed = (chart.number() as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        SquareFrame {
            // The first chart is that of flat space.
            quarter_turns: if tile == I64Vec2::ZERO {
                0
            } else {
                (mixed >> 62) as u8
            },
            centre_m: tile.as_dvec2() * TILE_M,
        }
    }

    /// A point as flat space of one chart has it.
    pub fn common(point: ChartPoint) -> DVec3 {
        Self::frame(point.chart).placed(point.pos)
    }

    /// A place of flat space in the square that it lies in.
    pub fn at(common: DVec3) -> ChartPoint {
        let tile = (DVec2::new(common.x, common.z) / TILE_M).round();
        let chart = Self::chart(tile.as_i64vec2());
        ChartPoint::new(chart, Self::frame(chart).taken(common))
    }

    fn carried(point: ChartPoint, to: ChartId) -> Crossing {
        if to == point.chart {
            return Crossing::within(point);
        }
        let (from, into) = (Self::frame(point.chart), Self::frame(to));
        let turns = (i32::from(from.quarter_turns) - i32::from(into.quarter_turns)).rem_euclid(4);
        Crossing {
            point: ChartPoint::new(to, into.taken(from.placed(point.pos))),
            turn_rad: f64::from(turns) * FRAC_PI_2,
        }
    }

    /// Where a point is in the eye's chart.
    fn from_eye(eye: &Eye, point: ChartPoint) -> ChartPoint {
        Self::carried(point, eye.point.chart).point
    }

    /// A box of a chart in the eye's.
    fn box_from_eye(eye: &Eye, chart: ChartId, corners: [DVec3; 2]) -> [DVec3; 2] {
        let [a, b] = corners.map(|pos| Self::from_eye(eye, ChartPoint::new(chart, pos)).pos);
        [a.min(b), a.max(b)]
    }
}

impl Atlas for TiledFlat {
    fn domain(&self, _chart: ChartId) -> Domain {
        Domain::Rectangle {
            low: DVec2::splat(-0.5 * TILE_M),
            high: DVec2::splat(0.5 * TILE_M),
        }
    }

    fn has_chart(&self, chart: ChartId) -> bool {
        Self::chart(Self::tile(chart)) == chart
    }

    fn cross(&self, point: ChartPoint) -> Option<Crossing> {
        let at = DVec2::new(point.pos.x, point.pos.z);
        let is_past = self.domain(point.chart).outside_m(at) > HYSTERESIS_M;
        is_past.then(|| Self::carried(point, Self::at(Self::common(point)).chart))
    }

    fn carry(&self, point: ChartPoint, to: ChartId) -> Option<Crossing> {
        self.has_chart(to).then(|| Self::carried(point, to))
    }

    fn images(&self, point: ChartPoint, reach_m: f64) -> Vec<Crossing> {
        let common = Self::common(point);
        let at = DVec2::new(common.x, common.z);
        let [low, high] = [at - reach_m, at + reach_m].map(|it| (it / TILE_M).round().as_i64vec2());
        let tiles =
            (low.x..=high.x).flat_map(|x| (low.y..=high.y).map(move |z| I64Vec2::new(x, z)));
        let is_near = |to: &ChartId| {
            let place = Self::frame(*to).taken(common);
            let off_m = self.domain(*to).outside_m(DVec2::new(place.x, place.z));
            *to != point.chart && off_m <= reach_m
        };
        let charts = tiles.map(Self::chart).filter(is_near);
        charts.map(|to| Self::carried(point, to)).collect()
    }

    fn noise_frame(&self, chart: ChartId) -> NoiseFrame {
        NoiseFrame::Square(Self::frame(chart))
    }
}

impl Map for TiledFlat {
    fn view_point(&self, eye: &Eye, point: ChartPoint) -> DVec4 {
        Euclidean.view_point(eye, Self::from_eye(eye, point))
    }

    fn chart_point(&self, eye: &Eye, view: DVec4) -> ChartPoint {
        let pos = Euclidean.chart_point(eye, view).pos;
        Self::at(Self::common(ChartPoint::new(eye.point.chart, pos)))
    }

    fn along(&self, eye: &Eye, direction: DVec3, distance_m: f64) -> ChartPoint {
        self.chart_point(eye, (direction * distance_m).extend(1.0))
    }

    fn curved(&self, _eye: &Eye, point: ChartPoint) -> DVec4 {
        Self::common(point).extend(1.0)
    }

    fn port_normal(&self, eye: &Eye, point: ChartPoint, normal: DVec3) -> DVec3 {
        Euclidean.port_normal(eye, point, normal)
    }
}

impl Metric for TiledFlat {
    fn curvature(&self) -> Curvature {
        Curvature::FLAT
    }

    fn distance_m(&self, a: ChartPoint, b: ChartPoint, _eye: &Eye) -> f64 {
        Self::common(a).distance(Self::common(b))
    }
}

impl Optics for TiledFlat {
    fn trims(&self, _eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> bool {
        let [low, high] = [min, max].map(|corner| DVec2::new(corner.x, corner.z));
        self.domain(chart).most_outside_m(low, high) > 0.0
    }

    fn sight_cell(&self, eye: &Eye, chart: ChartId, min: DVec3, max: DVec3) -> SightCell {
        let [min, max] = Self::box_from_eye(eye, chart, [min, max]);
        Euclidean.sight_cell(eye, eye.point.chart, min, max)
    }

    fn sight_cell_of(&self, eye: &Eye, cylinder: &BoundingCylinder) -> SightCell {
        let [min, max] = cylinder.square(DVec3::new(cylinder.radius_m, 0.0, cylinder.radius_m));
        self.sight_cell(eye, cylinder.chart, min, max)
    }

    fn clip_from_view(&self, eye: &Eye, projection: &Projection, view: DVec4) -> DVec4 {
        Euclidean.clip_from_view(eye, projection, view)
    }

    fn reference(&self, eye: &Eye, chart: ChartId) -> DVec3 {
        Self::carried(eye.point, chart).point.pos
    }

    fn view_matrix(&self, eye: &Eye) -> DMat4 {
        Euclidean.view_matrix(eye) * self.home_matrix(eye.point.chart).transpose()
    }

    fn home_matrix(&self, chart: ChartId) -> DMat4 {
        let frame = Self::frame(chart);
        let [x, y, z] = DVec3::AXES.map(|axis| frame.turned(axis).extend(0.0));
        DMat4::from_cols(x, y, z, DVec4::W)
    }

    fn uniform(&self, eye: &Eye, projection: &Projection) -> SpaceUniform {
        SpaceUniform {
            view: self.view_matrix(eye).as_mat4().to_cols_array_2d(),
            ..Euclidean.uniform(eye, projection)
        }
    }

    fn shader(&self) -> &'static MapShader {
        Euclidean.shader()
    }
}
