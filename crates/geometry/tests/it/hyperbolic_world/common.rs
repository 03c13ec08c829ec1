//! Worlds, charts near and far, and places in them.

use antipode_geometry::tiling::{Frame, Side, TilePath};
use antipode_geometry::{Atlas, ChartId, ChartPoint, Eye, HyperbolicWorld, Metric};
use glam::DVec3;
use proptest::prelude::{Strategy as Generator, any, prop};

pub use crate::tiling::common::{outward, sides};

/// The three sizes.
pub fn worlds() -> [HyperbolicWorld; 3] {
    HyperbolicWorld::RADII_M.map(HyperbolicWorld::new)
}

pub fn chart(frame: &Frame) -> ChartId {
    ChartId::new(frame.path().unwrap().number())
}

pub fn frame(chart: ChartId) -> Frame {
    TilePath::from_number(chart.number())
        .unwrap()
        .frame()
        .unwrap()
}

/// A chart up to 60 radii from the root.
pub fn charts() -> impl Generator<Value = ChartId> {
    (sides(60), 0.0..60.0_f64).prop_map(|(drawn, radii)| chart(&outward(&drawn, radii)))
}

/// The chart over some sides of another.
pub fn beyond(from: ChartId, over: &[Side]) -> ChartId {
    let step = |at: Frame, side: &Side| at.neighbour(*side).unwrap().frame;
    chart(&over.iter().fold(frame(from), step))
}

/// Up to so many sides to go over.
pub fn steps(most: usize) -> impl Generator<Value = Vec<Side>> {
    prop::collection::vec(any::<u8>().prop_map(Side::new), 0..most)
}

/// A place of a chart by shares of half its square's width, -10 m to 40 m high.
pub fn place(world: &HyperbolicWorld, chart: ChartId, share: DVec3) -> ChartPoint {
    let half_m = world.domain(chart).half_width_m();
    let pos = DVec3::new(share.x * half_m, 15.0 + 25.0 * share.y, share.z * half_m);
    ChartPoint::new(chart, pos)
}

/// An eye there.
pub fn looking(point: ChartPoint, [yaw, pitch, roll]: [f64; 3]) -> Eye {
    Eye {
        point,
        yaw,
        pitch,
        roll,
        ..Eye::default()
    }
}

pub fn angles() -> impl Generator<Value = [f64; 3]> {
    (-3.2..3.2_f64, -1.5..1.5_f64, -0.7..0.7_f64).prop_map(|(a, b, c)| [a, b, c])
}

/// Metres between two points.
pub fn apart_m(world: &HyperbolicWorld, a: ChartPoint, b: ChartPoint) -> f64 {
    world.distance_m(a, b, &Eye::default())
}
