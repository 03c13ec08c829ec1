//! What hides what in a world in tiles, looked for along rays.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, HyperbolicWorld};
use glam::Vec3Swizzles;

use super::*;

/// Rays are looked along in steps so long, metres.
const STEP_M: f64 = 0.2;

/// Level ground of some height over each column of the charts within a distance, metres.
fn plateaus(
    space: &dyn Strategy,
    from: ChartPoint,
    reach_m: f64,
    height_m: &mut dyn FnMut() -> f64,
) -> BTreeMap<(ChartId, [i32; 2]), f64> {
    let tiled = space.tiled();
    let charts = tiled.map_or_else(Vec::new, |it| it.charts_within(from, reach_m));
    let side = space.domain(ChartId::FIRST).side_chunks(0.0);
    let mut heights = BTreeMap::new();
    for chart in charts {
        for (x, z) in (-side..side).flat_map(|x| (-side..side).map(move |z| (x, z))) {
            heights.insert((chart, [x, z]), height_m());
        }
    }
    heights
}

/// Whether a ray meets ground on its way to a place, but for that of the place's own column.
fn meets_ground(
    space: &dyn Strategy,
    eye: &Eye,
    heights: &BTreeMap<(ChartId, [i32; 2]), f64>,
    to: ChartPoint,
) -> bool {
    let ahead = space.view_point(eye, to).truncate().normalize();
    let own = ChunkCoord::containing(to);
    let steps = (space.distance_m(eye.point, to, eye) / STEP_M) as u32;
    (1..steps).any(|step| {
        let at = space.along(eye, ahead, f64::from(step) * STEP_M);
        let coord = ChunkCoord::containing(at);
        let height_m = heights.get(&(at.chart, [coord.index.x, coord.index.z]));
        let is_own = (coord.chart, coord.index.xz()) == (own.chart, own.index.xz());
        !is_own && height_m.is_some_and(|height_m| at.pos.y < *height_m)
    })
}

/// Nine places of a chunk's top, a little below it: what rises over the skyline by less than a pixel is left out, too.
fn tops(chunk: &ChunkLand) -> impl Iterator<Item = ChartPoint> {
    let [low, high] = [chunk.min + 0.5, chunk.max - 0.5];
    let shares = (0..9).map(|n| DVec3::new(f64::from(n % 3), 2.0, f64::from(n / 3)) / 2.0);
    let chart = chunk.coord.chart;
    shares.map(move |share| ChartPoint::new(chart, low + share * (high - low)))
}

#[test]
fn what_land_hides_over_the_edges_of_tiles_no_ray_reaches() {
    let mut numbers = Numbers::new(5);
    for radius_m in [60.305, 120.61] {
        let space: Arc<dyn Strategy> = Arc::new(HyperbolicWorld::new(radius_m));
        let mut frame = frame(&space);
        let mut hidden = 0;
        for _ in 0..12 {
            let half_m = 0.5 * space.domain(ChartId::FIRST).half_width_m();
            let place = numbers.turn() * numbers.between(0.0, half_m);
            let point = ChartPoint::a(DVec3::new(place.x, 24.0, place.y));
            frame.view.eye.point = point;
            frame.view.eye.yaw = numbers.between(-3.2, 3.2);
            let eye = frame.view.eye;
            let mut height_m = || numbers.between(3.0, 32.0);
            let mut heights = plateaus(&*space, point, 2.2 * radius_m, &mut height_m);
            let own = ChunkCoord::containing(point).index;
            heights.remove(&(point.chart, [own.x, own.z]));
            let land = heights.iter().filter_map(|((chart, [x, z]), height_m)| {
                let coord = ChunkCoord::new(*chart, IVec3::new(*x, 0, *z));
                chunk_of(coord, |_, _| *height_m)
            });
            let land: Vec<_> = land.collect();
            let planned = plan(&frame, HEIGHT_PX, &land);
            let drawn: HashSet<_> = planned.chunks.iter().map(|it| it.place).collect();
            let frustum = space.frustum(&eye, &frame.view.projection);
            for (place, chunk) in land.iter().enumerate() {
                let [low, high] = chunk.whole;
                let cell = frustum.cell_seen(&*space, &eye, chunk.coord.chart, low, high);
                if drawn.contains(&place) || cell.is_none() {
                    continue;
                }
                hidden += 1;
                for to in tops(chunk) {
                    assert!(
                        meets_ground(&*space, &eye, &heights, to),
                        "{radius_m}: {:?} from {point:?}",
                        chunk.coord
                    );
                }
            }
        }
        assert!(hidden > 40, "{radius_m}: {hidden}");
    }
}
