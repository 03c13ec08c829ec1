//! Land about the tip of a cone: continuous over all three edges, dug alike in every chart, of one surface.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, ChunkCoord, Eye, Metric, Strategy};
use antipode_terrain::{EDIT_STEP, Field, RIM_REACH_M, Stroke, march};
use antipode_testing::cone::Cone;
use glam::{DVec2, DVec3};

use crate::common::{Random, World, chunk};

fn cone() -> Arc<dyn Strategy> {
    Arc::new(Cone)
}

fn outside_m(point: ChartPoint) -> f64 {
    let at = DVec2::new(point.pos.x, point.pos.z);
    Cone.domain(point.chart).outside_m(at)
}

/// The same place in the chart whose own it is.
fn home(point: ChartPoint) -> ChartPoint {
    let charts = (0..3).map(|quarter| Cone.carry(point, Cone::chart(quarter)).unwrap().point);
    let own = charts.min_by(|a, b| outside_m(*a).total_cmp(&outside_m(*b)));
    own.unwrap()
}

/// The samples of the land within some metres of a chart's domain, near the tip.
fn samples_at(chart: ChartId, reach: i32) -> impl Iterator<Item = ChartPoint> {
    let heights = (-8..24).step_by(3);
    let columns = (-7..reach).flat_map(move |x| (-7..reach).map(move |z| (x, z)));
    columns.flat_map(move |(x, z)| {
        let at = move |y| DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        heights
            .clone()
            .map(move |y| ChartPoint::new(chart, at(y)))
            .filter(|point| outside_m(*point) <= RIM_REACH_M)
    })
}

#[test]
fn what_a_chart_writes_beyond_its_edges_and_behind_the_tip_is_the_others_land_to_the_bit() {
    let field = Field::new(3, cone());
    for quarter in 0..3 {
        let (mut beyond, mut solid) = (0, 0);
        for point in samples_at(Cone::chart(quarter), 12) {
            let here = field.sample(point);
            let images = Cone.images(point, 0.0);
            for image in &images {
                assert_eq!(here, field.sample(image.point), "{point:?} {image:?}");
            }
            beyond += images.len();
            solid += usize::from(here < 0.0);
        }
        assert!(beyond > 1000 && solid > 500, "{beyond} {solid}");
        for (x, z) in [(0, 0), (-1, 0), (0, -1), (-1, -1), (2, 0)] {
            let coord = chunk(Cone::chart(quarter), x, 0, z);
            let samples = field.samples(coord);
            let mut random = Random(7);
            for _ in 0..400 {
                let [i, j, k] = [(); 3].map(|()| (random.unit() * 34.0) as usize);
                let local = DVec3::new(i as f64, j as f64, k as f64) - 1.0;
                let point = ChartPoint::new(coord.chart, coord.origin() + local);
                assert_eq!(samples.get(i, j, k), field.sample(point), "{point:?}");
            }
        }
    }
}

#[test]
fn the_land_goes_on_over_the_edges_without_a_step() {
    let field = Field::new(3, cone());
    let height_m = |point: ChartPoint| field.surface_height(point.chart, point.pos.x, point.pos.z);
    let mut heights = Vec::new();
    for ring in 1..40 {
        let away_m = f64::from(ring) * 1.3;
        for edge in 0..3 {
            let angle_rad = f64::from(edge) * FRAC_PI_2;
            let at = |aside_rad: f64| height_m(Cone::around(angle_rad + aside_rad, away_m, 0.0));
            let (before, after) = (at(-1e-4 / away_m), at(1e-4 / away_m));
            assert!((before - after).abs() < 1e-2, "{before} {after}");
            heights.push(before);
        }
    }
    let (low, high) = (heights.iter().copied(), heights.iter().copied());
    let rise_m = high.fold(f64::MIN, f64::max) - low.fold(f64::MAX, f64::min);
    assert!(rise_m > 2.0, "flat land has no steps: {rise_m} m");
}

/// On an edge, beside the tip on either side of the line behind it, at the tip, and away from all of them.
fn strokes() -> Vec<Stroke> {
    let places = [
        (0.02, 14.0, 4.0),
        (FRAC_PI_2 + 0.3, 3.0, 6.0),
        (0.1, 1.0, 5.0),
        (2.9 * FRAC_PI_2, 2.5, 4.0),
        (1.0, 0.1, 7.0),
        (2.2 * FRAC_PI_2, 11.0, 10.0),
        (0.8, 60.0, 6.0),
    ];
    let stroke = |(angle_rad, away_m, radius_m): (f64, f64, f64)| Stroke {
        centre: Cone::around(angle_rad, away_m, 6.0),
        radius_m,
        amount: if radius_m > 5.0 { 2.0 } else { -1.5 },
        part: antipode_terrain::Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    };
    places.into_iter().map(stroke).collect()
}

/// By how much edits have changed a sample.
fn delta(world: &World, point: ChartPoint) -> f32 {
    let coord = ChunkCoord::containing(point);
    let at = point.pos - coord.origin();
    let edits = world.edits.get(&coord);
    edits.map_or(0.0, |it| {
        it.delta(at.x as usize, at.y as usize, at.z as usize)
    })
}

#[test]
fn each_sample_is_changed_by_what_is_near_on_the_cone_in_every_chart_that_has_it() {
    for stroke in strokes() {
        let mut world = World::new(3, cone());
        world.apply(&stroke);
        let (mut changed, mut shared) = (0, 0);
        for chart in (0..3).map(Cone::chart) {
            for point in samples_at(chart, 30) {
                let own = home(point);
                let here = delta(&world, point);
                let apart = here - delta(&world, own);
                assert!(apart.abs() <= EDIT_STEP, "{stroke:?} {point:?} {apart}");
                let away_m = Cone.distance_m(stroke.centre, own, &Eye::default());
                let is_in = away_m < stroke.radius_m - 1e-6;
                let is_out = away_m > stroke.radius_m + 1e-6;
                assert!(!is_out || here == 0.0, "{stroke:?} {point:?} {here}");
                assert!(
                    !is_in || here != 0.0 || away_m > 0.9 * stroke.radius_m,
                    "{point:?}"
                );
                changed += usize::from(here != 0.0);
                shared += usize::from(here != 0.0 && own.chart != chart);
            }
        }
        let is_far = stroke.centre.pos.x > 30.0;
        assert!(is_far || changed > 40 && shared > 10, "{changed} {shared}");
    }
}

/// A vertex on an edge: along it and up, in units of the mesh.
type OnEdge = BTreeMap<(i32, i32), usize>;

/// The vertices that a chart's meshes have on the edge where its x or its z is zero.
fn on_edge(world: &mut World, chart: ChartId, on_x: bool) -> OnEdge {
    let mut found = OnEdge::new();
    for (along, y) in (0..2).flat_map(|along| (-1..=1).map(move |y| (along, y))) {
        // The chunks on either side of the edge, that of the chart's own quarter alone has what is drawn there.
        let (x, z) = if on_x { (0, along) } else { (along, 0) };
        let coord = chunk(chart, x, y, z);
        let samples = world.samples(coord);
        let mesh = march(&samples, &world.field, coord);
        for vertex in &mesh.vertices {
            let pos = coord.origin() + vertex.position().as_dvec3();
            let (across, along) = if on_x { (pos.x, pos.z) } else { (pos.z, pos.x) };
            if across == 0.0 && along > 0.0 && along < 60.0 {
                let key = [along, pos.y].map(|at| (at * 2048.0).round() as i32);
                *found.entry((key[0], key[1])).or_default() += 1;
            }
        }
    }
    found
}

#[test]
fn meshes_agree_to_the_bit_on_every_edge_also_where_it_was_dug() {
    let mut world = World::new(3, cone());
    for dug in [false, true] {
        if dug {
            for angle_rad in [0.05, 1.5, 3.2] {
                let place = Cone::around(angle_rad, 5.0, 0.0);
                let at = world
                    .field
                    .surface_height(place.chart, place.pos.x, place.pos.z);
                world.apply(&Stroke {
                    centre: place.moved(DVec3::Y * at),
                    radius_m: 4.0,
                    amount: 3.0,
                    part: antipode_terrain::Part::Whole,
                    kind: None,
                    shape: antipode_terrain::Shape::Ball,
                    power: None,
                });
            }
        }
        for quarter in 0..3 {
            let here = on_edge(&mut world, Cone::chart(quarter), true);
            let next = on_edge(&mut world, Cone::chart(quarter + 1), false);
            assert!(here.len() > 60, "{quarter}: {}", here.len());
            let (here, next): (Vec<_>, Vec<_>) = (here.keys().collect(), next.keys().collect());
            assert_eq!(here, next, "{quarter} {dug}");
        }
    }
}
