//! What plans of a world in tiles have, and what they cost beside flat ones.

use std::time::Instant;

use antipode_geometry::{ChartId, ChartPoint, Euclidean, HyperbolicWorld, Strategy};
use antipode_terrain::Generator;
use glam::DVec3;

use super::*;
use crate::api::Reach;

/// What a metre takes of a picture at the nearest place of a chunk: `1/(R sinh(d/R))` of a radian at a distance d, and in tiles up to
/// 1.45 metres of the chart.
#[derive(Debug)]
struct Seen {
    space: Arc<dyn Strategy>,
    eye: ChartPoint,
}

impl Detail for Seen {
    fn pixels_per_metre(&self, coord: ChunkCoord) -> f64 {
        let (low, high) = (coord.min(), coord.max());
        let curvature_m = self.space.radius_m();
        let up_m = (self.eye.pos.y - self.eye.pos.y.clamp(low.y, high.y)).abs();
        let (away_m, stretch) = match self.space.tiled() {
            Some(tiled) => {
                let away_m = tiled.away_m(self.eye, coord.chart, low.xz(), high.xz());
                (curvature_m * (away_m / curvature_m).sinh(), 1.45)
            }
            None => (
                self.eye
                    .pos
                    .xz()
                    .distance(self.eye.pos.xz().clamp(low.xz(), high.xz())),
                1.0,
            ),
        };
        700.0 * stretch / away_m.hypot(up_m).max(1e-6)
    }

    fn span_px(&self, coord: ChunkCoord) -> f64 {
        32.0 * self.pixels_per_metre(coord)
    }

    fn tolerance_px(&self) -> f64 {
        0.5
    }
}

struct Planner {
    field: Field,
    request: Request,
    view: u32,
}

impl Planner {
    fn new(space: Arc<dyn Strategy>, view: u32) -> Self {
        let field = Field::made_by(Generator::Planted, 11, space.clone());
        let height_m = field.surface_height(ChartId::FIRST, 3.0, 4.0) + 2.0;
        let eye = ChartPoint::a(DVec3::new(3.0, height_m, 4.0));
        let request = Request {
            range: Range::wished(&*space, eye, view, 4),
            detail: Some(Arc::new(Seen { space, eye })),
            bodies: Reaches::of(&[Reach::around(eye, 30.0)]),
            near_edits: Arc::default(),
            before: Arc::new(Plan::nothing()),
        };
        Self {
            field,
            request,
            view,
        }
    }

    /// Chunks that are loaded, their cost in chunks of full level, and the plan's leniency.
    fn cost(&self) -> (usize, f64, f64) {
        let plan = self.request.plan(&self.field).plan;
        let wanted: ChunkMap<_> = plan
            .targets
            .iter()
            .filter(|(_, target)| target.wanted)
            .map(|(&coord, target)| (coord, target.level))
            .collect();
        let atlas = &**self.field.strategy();
        (wanted.len(), cost(atlas, &wanted, |_| true), plan.leniency)
    }
}

/// Triangles of all meshes, and how many have any.
fn triangles(planner: &Planner) -> (usize, usize) {
    let plan = planner.request.plan(&planner.field).plan;
    let mut mesher = antipode_terrain::Mesher::default();
    let wanted = plan.targets.iter().filter(|(_, target)| target.wanted);
    let counts = wanted.map(|(&coord, target)| {
        let samples = planner.field.samples_at(coord, target.level);
        mesher.march(&samples, &planner.field, coord).indices.len() / 3
    });
    counts.fold((0, 0), |(sum, some), n| {
        (sum + n, some + usize::from(n > 0))
    })
}

fn tiles(radius_m: f64) -> Arc<HyperbolicWorld> {
    Arc::new(HyperbolicWorld::new(radius_m))
}

#[test]
#[ignore = "prints what plans take"]
fn print_costs() {
    for view in [6, 10, 16] {
        let mut spaces: Vec<Arc<dyn Strategy>> = vec![Arc::new(Euclidean)];
        for radius_m in HyperbolicWorld::RADII_M {
            spaces.push(tiles(radius_m));
        }
        for space in spaces {
            let planner = Planner::new(space.clone(), view);
            let begun = Instant::now();
            let range = Range::wished(&*space, ChartPoint::a(DVec3::ZERO), view, 4);
            let range_ms = begun.elapsed().as_secs_f64() * 1e3;
            let kept = range.kept().len();
            let _ = planner.cost();
            let begun = Instant::now();
            let (chunks, cost, leniency) = planner.cost();
            let plan_ms = begun.elapsed().as_secs_f64() * 1e3;
            let again = Instant::now();
            drop(Range::wished(&*space, ChartPoint::a(DVec3::ZERO), view, 4));
            let again_ms = again.elapsed().as_secs_f64() * 1e3;
            let (triangles, some) = triangles(&planner);
            println!(
                "triangles {triangles}, meshes {some}, range again {again_ms:.2} ms; view {} R {:7.2}: range {range_ms:6.2} ms, kept {kept:6}, plan {plan_ms:7.1} ms, loaded {chunks:5}, cost {cost:6.1}, leniency {leniency:.2}",
                planner.view,
                space.radius_m(),
            );
        }
    }
}

#[test]
fn tiles_cost_about_twice_what_a_flat_view_of_the_same_distance_does_at_most() {
    for view in [6, 10] {
        let (_, flat, _) = Planner::new(Arc::new(Euclidean), view).cost();
        for radius_m in HyperbolicWorld::RADII_M {
            let (chunks, cost, leniency) = Planner::new(tiles(radius_m), view).cost();
            // By chunks that may hold ground, of which more than in flat land hold none: in triangles it is 1.7 times at most.
            // Tiles of 32 m are meshed past their edges as far as within, and are rims throughout: they cost more.
            let is_narrow = radius_m < 40.0;
            let most = if is_narrow { 3.1 } else { 2.1 };
            assert!(
                cost <= most * flat && (is_narrow || leniency < 8.0),
                "view {view}, radius {radius_m}: {chunks} chunks, {cost} against {flat}, {leniency} times"
            );
        }
    }
}

/// Over edges, too, levels differ by one at most; and far land is there in fewer triangles than near.
#[test]
fn levels_over_edges_differ_by_one_at_most() {
    for radius_m in HyperbolicWorld::RADII_M {
        let planner = Planner::new(tiles(radius_m), 8);
        let plan = planner.request.plan(&planner.field).plan;
        let atlas = &**planner.field.strategy();
        let mut counts = [0; Level::ALL.len()];
        let mut over = 0;
        for (&coord, target) in &plan.targets {
            counts[target.level.index()] += 1;
            for next in crate::levels::faces(atlas, coord) {
                let Some(beside) = plan.targets.get(&next) else {
                    continue;
                };
                let apart = beside.level.index().abs_diff(target.level.index());
                assert!(apart <= 1, "{coord:?} {next:?}");
                over += usize::from(next.chart != coord.chart && apart == 1);
            }
        }
        assert!(over > 20 && counts[1] > 20, "{over} {counts:?}");
    }
}
