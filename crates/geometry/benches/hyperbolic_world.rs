//! Time to see, cross and carry in the hyperbolic world, by how far from the root: in radii, about 2300 m being 38.

use antipode_geometry::tiling::{Frame, Side};
use antipode_geometry::{
    Atlas, BodyChart, ChartId, ChartPoint, ChunkCoord, ChunkCube, Eye, HyperbolicWorld, Map, Optics,
};
use divan::{Bencher, black_box, counter::ItemsCount};
use glam::DVec3;

const RADII: [f64; 3] = [0.0, 16.0, 38.0];

fn main() {
    divan::main();
}

/// A chart so far out, and those within five steps over one side after another.
fn charts(radii: f64) -> Vec<ChartId> {
    let mut frame = Frame::ROOT;
    let mut side = 0;
    while frame.to_root().distance() < radii {
        let next = frame.neighbour(Side::new(side % 4)).ok();
        frame = next
            .filter(|it| it.back == Side::PARENT)
            .map_or(frame, |it| it.frame);
        side += 1;
    }
    let near = antipode_geometry::tiling::rings(&frame, 4, 200).unwrap_or_default();
    let number = |frame: &Frame| {
        frame
            .path()
            .map_or(ChartId::FIRST, |it| ChartId::new(it.number()))
    };
    near.iter().flatten().map(number).collect()
}

fn scene(radii: f64) -> (HyperbolicWorld, Eye, Vec<ChartPoint>) {
    let charts = charts(radii);
    let at = |chart: &ChartId, i: u32| {
        let (angle, r) = (f64::from(i) * 2.4, 31.0);
        ChartPoint::new(*chart, DVec3::new(r * angle.cos(), 5.0, r * angle.sin()))
    };
    let points = charts
        .iter()
        .flat_map(|chart| (0..10).map(|i| at(chart, i)))
        .collect();
    let eye = Eye {
        point: at(&charts[0], 3),
        yaw: 0.7,
        ..Eye::default()
    };
    (HyperbolicWorld::new(60.305), eye, points)
}

fn each(bencher: Bencher<'_, '_>, points: &[ChartPoint], act: impl Fn(ChartPoint)) {
    bencher
        .counter(ItemsCount::new(points.len()))
        .bench_local(|| {
            for point in points {
                act(black_box(*point));
            }
        });
}

#[divan::bench(args = RADII)]
fn view_point(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, eye, points) = scene(radii);
    each(bencher, &points, |point| {
        black_box(world.view_point(&eye, point));
    });
}

#[divan::bench(args = RADII)]
fn viewer(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, eye, points) = scene(radii);
    let viewer = world.viewer(&eye);
    each(bencher, &points, |point| {
        black_box(viewer(point));
    });
}

#[divan::bench(args = RADII)]
fn chart_point(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, eye, points) = scene(radii);
    each(bencher, &points[..40], |point| {
        let view = world.view_point(&eye, point);
        black_box(world.chart_point(&eye, view));
    });
}

#[divan::bench(args = RADII)]
fn cross(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, _, points) = scene(radii);
    each(bencher, &points, |point| {
        black_box(world.cross(point.moved(DVec3::new(2.0, 0.0, 3.0))));
    });
}

#[divan::bench(args = RADII)]
fn carry(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, eye, points) = scene(radii);
    each(bencher, &points, |point| {
        black_box(world.carry(point, eye.point.chart));
    });
}

#[divan::bench(args = RADII)]
fn images(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, _, points) = scene(radii);
    each(bencher, &points, |point| {
        black_box(world.images(point, 8.0));
    });
}

#[divan::bench(args = RADII)]
fn step_of_a_body(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, _, points) = scene(radii);
    each(bencher, &points, |point| {
        black_box(BodyChart::step(&world, point, DVec3::new(0.05, 0.0, 0.05)));
    });
}

#[divan::bench(args = RADII)]
fn of_a_new_world(bencher: Bencher<'_, '_>, radii: f64) {
    let (_, eye, points) = scene(radii);
    bencher
        .with_inputs(|| HyperbolicWorld::new(60.305))
        .counter(ItemsCount::new(109_u32))
        .bench_local_values(|world| {
            for point in points.iter().step_by(10) {
                black_box(world.view_point(&eye, *point));
            }
            world
        });
}

/// The cube about a chunk, by its reach: what bodies need, and views of 4, 8 and 16 chunks.
#[divan::bench(args = [4, 5, 9, 17], consts = [30, 60, 120])]
fn chunk_cube<const RADIUS_M: u32>(bencher: Bencher<'_, '_>, reach: u16) {
    let world = HyperbolicWorld::new(f64::from(RADIUS_M));
    let centre = ChunkCoord::containing(ChartPoint::a(DVec3::ONE));
    bencher.bench_local(|| ChunkCube::about(&world, black_box(centre), reach, 8.0));
}

#[divan::bench(args = RADII)]
fn sight_cell(bencher: Bencher<'_, '_>, radii: f64) {
    let (world, eye, points) = scene(radii);
    each(bencher, &points, |point| {
        let low = point.pos.min(DVec3::ZERO);
        black_box(world.sight_cell(&eye, point.chart, low, low + 20.0));
    });
}
