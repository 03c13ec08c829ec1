//! Eyes, points and spaces that the tests share.

use std::sync::Arc;

use antipode_geometry::{
    ChartId, ChartPoint, Domain, Eye, Geometry, HyperbolicWorld, Projection, Strategy, strategy,
};
use glam::{DVec2, DVec3, DVec4};
use proptest::prelude::{ProptestConfig, Strategy as Generator, any, prop};
use proptest::test_runner::RngSeed;

/// That many cases, the same on every run.
pub fn cases(count: u32) -> ProptestConfig {
    ProptestConfig {
        cases: count,
        rng_seed: RngSeed::Fixed(20),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Height of the tests' picture in pixels.
pub const PICTURE_HEIGHT_PX: f64 = 720.0;

/// The tests' camera: 16:9, 0.05 m near.
pub fn projection() -> Projection {
    Projection::new(1.2, 16.0 / 9.0, 0.05)
}

/// The spaces that worlds are of one or two charts in, at their default sizes.
pub fn spaces() -> Vec<Arc<dyn Strategy>> {
    let spaces = [
        (Geometry::Euclidean, 20.0),
        (Geometry::Hyperbolic, 20.0),
        (Geometry::Spherical, 32.0),
    ];
    let made = |(geometry, radius_m)| strategy(geometry, radius_m);
    spaces.into_iter().map(made).collect()
}

/// The same, and the hyperbolic world in each of its sizes.
pub fn all_spaces() -> Vec<Arc<dyn Strategy>> {
    let mut all = spaces();
    for radius_m in HyperbolicWorld::RADII_M {
        all.push(Arc::new(HyperbolicWorld::new(radius_m)));
    }
    all
}

/// A point's place in the picture in pixels from its middle; `None` behind the eye.
pub fn pixel(space: &dyn Strategy, eye: &Eye, view: DVec4) -> Option<DVec2> {
    let clip = space.clip_from_view(eye, &projection(), view);
    let screen = Projection::screen(clip)?;
    Some(screen * DVec2::new(16.0 / 9.0, 1.0) * (0.5 * PICTURE_HEIGHT_PX))
}

/// A chart point of either hemisphere; level distance up to `range_m`, height 2 to 38 m.
pub fn chart_point(range_m: f64) -> impl Generator<Value = ChartPoint> {
    let angle = -3.2..3.2_f64;
    (any::<bool>(), 0.0..range_m, 2.0..38.0_f64, angle).prop_map(|(b, r, y, angle)| {
        let chart = if b { ChartId::SECOND } else { ChartId::FIRST };
        ChartPoint::new(chart, DVec3::new(r * angle.cos(), y, r * angle.sin()))
    })
}

/// An eye at any chart point, heading, pitch, roll and dial.
pub fn eye(range_m: f64) -> impl Generator<Value = Eye> {
    (
        chart_point(range_m),
        -9.0..9.0_f64,
        -1.57..1.57_f64,
        -0.7..0.7_f64,
        0.0..20.0_f64,
    )
        .prop_map(|(point, yaw, pitch, roll, dial)| Eye {
            point,
            yaw,
            pitch,
            roll,
            dial,
            lift_m: 1.62,
        })
}

/// A vector with coordinates between `-range` and `range`.
pub fn vector(range: f64) -> impl Generator<Value = DVec3> {
    prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
}

/// The point in chart A, where the space has no other; in the chart that it belongs to, where charts are squares.
pub fn in_space(space: &dyn Strategy, point: ChartPoint) -> ChartPoint {
    let domain = space.domain(ChartId::FIRST);
    if let Domain::Rectangle { low, high } = domain {
        let level = DVec2::new(point.pos.x, point.pos.z).clamp(1.4 * low, 1.4 * high);
        let point = ChartPoint::new(point.chart, DVec3::new(level.x, point.pos.y, level.y));
        return space.cross(point).map_or(point, |it| it.point);
    }
    match domain.radius_m() {
        Some(_) => point,
        None => ChartPoint::a(point.pos),
    }
}
