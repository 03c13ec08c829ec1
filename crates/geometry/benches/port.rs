//! Time to port one point, per space: view coordinates from chart coordinates.

use antipode_geometry::{ChartPoint, Eye, Geometry, Strategy, strategy};
use divan::{Bencher, black_box, counter::ItemsCount};
use glam::DVec3;

const POINTS: usize = 1024;

fn main() {
    divan::main();
}

fn scene(geometry: Geometry) -> (std::sync::Arc<dyn Strategy>, Eye, Vec<ChartPoint>) {
    let eye = Eye {
        point: ChartPoint::a(DVec3::new(3.0, 9.0, -2.0)),
        yaw: 0.7,
        pitch: -0.3,
        roll: 0.0,
        dial: 10.0,
        lift_m: 1.62,
    };
    let points = (0..POINTS as u32)
        .map(|i| {
            let (angle, r) = (f64::from(i) * 2.4, f64::from(i) * 0.05);
            ChartPoint::a(DVec3::new(r * angle.cos(), 5.0 + r * 0.1, r * angle.sin()))
        })
        .collect();
    (strategy(geometry, 32.0), eye, points)
}

#[divan::bench(args = Geometry::ALL)]
fn view_point(bencher: Bencher<'_, '_>, geometry: Geometry) {
    let (space, eye, points) = scene(geometry);
    bencher.counter(ItemsCount::new(POINTS)).bench_local(|| {
        for point in &points {
            black_box(space.view_point(black_box(&eye), *point));
        }
    });
}

#[divan::bench(args = Geometry::ALL)]
fn chart_point(bencher: Bencher<'_, '_>, geometry: Geometry) {
    let (space, eye, points) = scene(geometry);
    let views: Vec<_> = points.iter().map(|p| space.view_point(&eye, *p)).collect();
    bencher.counter(ItemsCount::new(POINTS)).bench_local(|| {
        for view in &views {
            black_box(space.chart_point(black_box(&eye), *view));
        }
    });
}

#[divan::bench(args = Geometry::ALL)]
fn sight_cell(bencher: Bencher<'_, '_>, geometry: Geometry) {
    let (space, eye, points) = scene(geometry);
    bencher.counter(ItemsCount::new(POINTS)).bench_local(|| {
        for point in &points {
            let max = point.pos + 32.0;
            black_box(space.sight_cell(black_box(&eye), point.chart, point.pos, max));
        }
    });
}
