//! Which chunks a plan has, and how fine they are.

#![allow(clippy::expect_used, reason = "tests fail by panicking")]

use super::*;
use antipode_geometry::{ChartId, ChartPoint, Euclidean, Geometry, strategy};
use glam::DVec3;

use crate::api::Reach;
use crate::levels::faces;

/// A flat picture with a pixel of that many radians, seen from a point.
#[derive(Debug)]
struct Flat {
    eye: DVec3,
    pixels_per_rad: f64,
    tolerance_px: f64,
}

impl Detail for Flat {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        let nearest = self.eye.clamp(coord.min(), coord.max());
        self.pixels_per_rad / nearest.distance(self.eye).max(1e-6)
    }

    fn span_px(&self, coord: ChunkCoord) -> f64 {
        32.0 * self.pixels_per_metre(coord)
    }

    fn tolerance_px(&self) -> f64 {
        self.tolerance_px
    }
}

fn request(geometry: Geometry, radius_m: f64, flat: Flat, distance: u32) -> (Request, Field) {
    let space = strategy(geometry, radius_m);
    let field = Field::made_by(antipode_terrain::Generator::OneBiome, 11, space.clone());
    let eye = ChartPoint::a(flat.eye);
    let request = Request {
        range: Range::wished(&*space, eye, distance, 0),
        detail: Some(Arc::new(flat)),
        bodies: Reaches::of(&[Reach::around(eye, 30.0)]),
        near_edits: Arc::default(),
        before: Arc::new(Plan::nothing()),
    };
    (request, field)
}

fn eye() -> Flat {
    Flat {
        eye: DVec3::new(16.0, 40.0, 16.0),
        pixels_per_rad: 700.0,
        tolerance_px: 0.5,
    }
}

#[test]
fn levels_grow_coarser_with_distance_and_neighbours_differ_by_one() {
    let (request, field) = request(Geometry::Euclidean, f64::INFINITY, eye(), 16);
    let plan = request.plan(&field).plan;
    let mut counts = [0; 4];
    for (&coord, target) in &plan.targets {
        counts[target.level.index()] += 1;
        for next in faces(&**field.strategy(), coord).filter_map(|next| plan.targets.get(&next)) {
            assert!(next.level.index().abs_diff(target.level.index()) <= 1);
        }
        if request.bodies.wants(coord) {
            assert_eq!(target.level, Level::FULL);
        }
    }
    assert!(counts[0] > 20 && counts[1] > counts[0], "{counts:?}");
}

#[test]
fn sixteen_chunks_of_distance_cost_at_most_twice_as_much_as_six() {
    for seed in 0..5 {
        let cost_at = |distance| {
            let (mut request, _) = request(Geometry::Euclidean, f64::INFINITY, eye(), distance);
            let field = Field::new(seed, strategy(Geometry::Euclidean, 0.0));
            request.near_edits = Arc::default();
            let plan = request.plan(&field).plan;
            let levels = plan
                .targets
                .iter()
                .map(|(&coord, target)| (coord, target.level));
            let wanted = |coord| plan.targets[&coord].wanted;
            (cost(&Euclidean, &levels.collect(), wanted), plan.leniency)
        };
        let ((far, lenient), (near, strict)) = (cost_at(16), cost_at(6));
        assert!(
            far > near && far <= 2.0 * near,
            "seed {seed}: {far} against {near}"
        );
        assert!(
            strict == 1.0 && lenient < 16.0,
            "seed {seed}: {lenient} times"
        );
    }
}

#[test]
fn the_largest_closed_world_stays_within_its_budget() {
    let (request, field) = request(Geometry::Spherical, 256.0, eye(), 6);
    let plan = request.plan(&field).plan;
    let levels = plan
        .targets
        .iter()
        .map(|(&coord, target)| (coord, target.level));
    let cost = cost(&**field.strategy(), &levels.collect(), |_| true);
    assert!(cost <= CLOSED_BUDGET, "{cost} with {} times", plan.leniency);
}

#[test]
fn exact_pictures_and_wishes_without_a_picture_are_full_throughout() {
    let exact = Flat {
        tolerance_px: 0.0,
        ..eye()
    };
    let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, exact, 10);
    let full = |request: &Request| {
        let plan = request.plan(&field).plan;
        plan.targets
            .values()
            .all(|target| target.level == Level::FULL)
    };
    assert!(full(&request));
    request.detail = None;
    assert!(full(&request));
}

#[test]
fn chunks_under_half_a_pixel_are_not_loaded_but_those_near_bodies_are() {
    let tiny = Flat {
        pixels_per_rad: 1.0,
        ..eye()
    };
    let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, tiny, 4);
    let near = |plan: &Plan| {
        let wanted = plan.targets.iter().filter(|(_, target)| target.wanted);
        wanted.map(|(&coord, _)| coord).collect::<ChunkSet>()
    };
    let small = near(&request.plan(&field).plan);
    // 32 m make half a pixel at 64 m.
    assert!(!small.is_empty());
    assert!(small.iter().all(|coord| coord.index.x.abs() <= 3));
    request.bodies = Reaches::of(&[Reach::whole(ChartId::FIRST)]);
    assert!(near(&request.plan(&field).plan).len() > small.len());
}

#[test]
fn edited_chunks_are_as_fine_as_what_may_be_lost_of_them() {
    let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, eye(), 16);
    let plan = request.plan(&field).plan;
    let coarse = plan
        .targets
        .iter()
        .find(|(_, target)| target.level.index() == 1);
    let (&coord, _) = coarse.expect("a coarse chunk");
    request.near_edits = Arc::new(ChunkSet::from_iter([coord]));
    assert_eq!(request.plan(&field).plan.targets[&coord].level, Level::FULL);
}

#[test]
fn a_plan_tells_what_it_changes() {
    let (mut request, field) = request(Geometry::Euclidean, f64::INFINITY, eye(), 8);
    let first = request.plan(&field);
    assert_eq!(first.changed.len(), first.plan.targets.len());
    request.before = Arc::new(first.plan);
    assert!(request.plan(&field).changed.is_empty());
    let moved = ChartPoint::a(eye().eye + DVec3::X * 32.0);
    request.range = Range::wished(&**field.strategy(), moved, 8, 0);
    let second = request.plan(&field);
    assert!(!second.changed.is_empty() && second.changed.len() < second.plan.targets.len());
}

#[test]
fn at_the_rim_both_charts_are_finer() {
    let far = Flat {
        eye: DVec3::new(0.0, 40.0, 0.0),
        ..eye()
    };
    let (request, field) = request(Geometry::Spherical, 256.0, far, 1);
    let space = field.strategy();
    let chunk_at = |x: f64| ChunkCoord::containing(ChartPoint::a(DVec3::new(x, 60.0, 0.0)));
    let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap_or_default();
    assert!(meets_rim(&**space, chunk_at(rim_m)));
    assert!(!meets_rim(&**space, chunk_at(rim_m - 64.0)));
    assert!(
        request.level(&field, chunk_at(rim_m)) <= request.level(&field, chunk_at(rim_m - 64.0))
    );
}
