//! The ground that bodies can reach. The chunk workers keep colliders and samples within it.

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartPoint, Tiled};
use antipode_streaming::Reach;
use antipode_terrain::RIM_REACH_M;
use glam::{DVec2, DVec3};

use crate::world::GROUND_SEARCH_M;

/// Ground within this distance can be touched or asked for by a step, in metres: the tool's reach
/// and the camera behind it.
const STEP_SEES_M: f64 = 30.0;
/// As far up as a body is lifted, and its height, in metres.
const LIFT_SEES_M: f64 = 66.0;
/// Half the width of the column that a body stands in, in metres.
const COLUMN_M: f64 = 1.0;
/// Ground where a body will be so many seconds from now is made solid beforehand.
const AHEAD_S: f64 = 1.0;
/// Around that place, in metres.
const AHEAD_M: f64 = 8.0;
/// Others than the player are looked after by cells of this edge, in metres, with a margin around each; that of bullets.
const OTHERS_CELL_M: f64 = 16.0;
pub(crate) const OTHERS_MARGIN_M: f64 = 2.0;
/// Ground where a bullet will be so many seconds from now is made solid beforehand.
const OTHERS_AHEAD_S: f64 = 0.3;
/// The square of a tile ends short of its edge by so much, metres: what has the edge alone is not its.
const WITHIN_M: f64 = 1e-3;
/// Cells at most: a thousand bullets in all directions must not make the whole world solid.
const MOST_OTHERS: usize = 96;

/// Where the ground around a body with its feet at `feet` must be solid; its velocity in m/s.
pub(crate) fn of_body(strategy: &dyn Atlas, feet: ChartPoint, velocity: DVec3) -> Vec<Reach> {
    let Some(reach_m) = chart_reach_m(strategy, feet.pos.y) else {
        let charts = strategy.all_charts().unwrap_or_default();
        return charts.iter().copied().map(Reach::whole).collect();
    };
    let mut reaches = vec![around_body(feet, reach_m)];
    let ahead = DVec3::from(
        velocity
            .to_array()
            .map(|v| if v.is_finite() { v } else { 0.0 }),
    );
    let way = ahead * AHEAD_S;
    if way.length() > reach_m - AHEAD_M {
        let there = ChartPoint::new(feet.chart, feet.pos + way);
        reaches.extend(everywhere(strategy, swept(feet, there)));
    }
    reaches.push(column(feet));
    for image in strategy.images(feet, reach_m + AHEAD_M) {
        reaches.push(around_body(image.point, reach_m));
        reaches.push(column(image.point));
    }
    if let Some(tiled) = strategy.tiled() {
        reaches.extend(columns_over_edges(strategy, tiled, feet, reach_m));
    }
    reaches
}

/// The columns of chunks of other tiles that come within a distance, metres, as high and low as that: charts are not written so far
/// past their edges that all of these would hold an image of the place.
fn columns_over_edges(
    strategy: &dyn Atlas,
    tiled: &dyn Tiled,
    feet: ChartPoint,
    reach_m: f64,
) -> Vec<Reach> {
    let cell_m = f64::from(CHUNK_CELLS);
    let mut reaches = Vec::new();
    let charts = tiled.charts_within(feet, reach_m).into_iter();
    for chart in charts.filter(|chart| *chart != feet.chart) {
        let half_m = strategy.domain(chart).half_width_m() - WITHIN_M;
        let side = (half_m / cell_m).ceil() as i32;
        for (i, j) in (-side..side).flat_map(|i| (-side..side).map(move |j| (i, j))) {
            let low = DVec2::new(f64::from(i), f64::from(j)) * cell_m;
            let [low, high] =
                [low, low + cell_m].map(|it| it.clamp(DVec2::splat(-half_m), DVec2::splat(half_m)));
            if tiled.away_m(feet, chart, low, high) <= reach_m {
                reaches.push(Reach {
                    chart,
                    min: DVec3::new(low.x, feet.pos.y - reach_m, low.y),
                    max: DVec3::new(high.x, feet.pos.y + reach_m, high.y),
                });
            }
        }
    }
    reaches
}

/// Where the ground around others than the player must be solid, each with its place and velocity in m/s. Those close
/// together share one reach, `margin_m` metres wider than the cells they are in.
pub(crate) fn of_others(
    strategy: &dyn Atlas,
    others: impl Iterator<Item = (ChartPoint, DVec3)>,
    margin_m: f64,
) -> Vec<Reach> {
    let mut cells = std::collections::BTreeSet::new();
    for (point, velocity) in others {
        let there = point.pos + velocity * OTHERS_AHEAD_S;
        for at in [point.pos, there] {
            cells.insert((
                point.chart,
                (at / OTHERS_CELL_M).floor().as_i64vec3().to_array(),
            ));
        }
    }
    let corner = |cell: [i64; 3]| DVec3::from_array(cell.map(|index| index as f64)) * OTHERS_CELL_M;
    cells
        .into_iter()
        .take(MOST_OTHERS)
        .map(|(chart, cell)| Reach {
            chart,
            min: corner(cell) - margin_m,
            max: corner(cell) + OTHERS_CELL_M + margin_m,
        })
        .flat_map(|reach| everywhere(strategy, reach))
        .collect()
}

/// A reach, and what holds the same place in every other chart whose domain it comes into.
fn everywhere(strategy: &dyn Atlas, reach: Reach) -> Vec<Reach> {
    let middle = ChartPoint::new(reach.chart, reach.min.midpoint(reach.max));
    let half = (reach.max - reach.min) * 0.5;
    let radius_m = half.x.hypot(half.z);
    let mut reaches = vec![reach];
    for image in strategy.images(middle, radius_m) {
        let wide_m = strategy.spread_m(middle, radius_m, RIM_REACH_M);
        let half = DVec3::new(wide_m, half.y, wide_m);
        // Beyond this there is no ground in the chart.
        let edge_m = strategy.domain(image.point.chart).half_width_m() + RIM_REACH_M;
        let far = DVec3::new(edge_m, f64::INFINITY, edge_m);
        reaches.push(Reach {
            chart: image.point.chart,
            min: (image.point.pos - half).max(-far),
            max: (image.point.pos + half).min(far),
        });
    }
    if let Some(tiled) = strategy.tiled() {
        let written: Vec<_> = reaches.iter().map(|it| it.chart).collect();
        let beyond = narrow_tiles(strategy, tiled, middle, radius_m);
        reaches.extend(
            beyond
                .into_iter()
                .filter(|it| !written.contains(&it.chart))
                .map(|tile| Reach {
                    min: tile.min.with_y(reach.min.y),
                    max: tile.max.with_y(reach.max.y),
                    ..tile
                }),
        );
    }
    reaches
}

/// The squares of the tiles that come within a distance, metres, of a world whose tiles are narrower than two chunks: a chart there is
/// not written as far past its edges as a figure asks about ground, so that a place has no images in all of them.
fn narrow_tiles(
    strategy: &dyn Atlas,
    tiled: &dyn Tiled,
    middle: ChartPoint,
    radius_m: f64,
) -> Vec<Reach> {
    let half_m = strategy.domain(middle.chart).half_width_m();
    if half_m >= f64::from(CHUNK_CELLS) {
        return Vec::new();
    }
    let half = DVec3::new(half_m, 0.0, half_m) - WITHIN_M;
    let charts = tiled.charts_within(middle, radius_m).into_iter();
    charts
        .map(|chart| Reach {
            chart,
            min: -half,
            max: half,
        })
        .collect()
}

fn around_body(feet: ChartPoint, reach_m: f64) -> Reach {
    Reach::around(feet, reach_m)
}

fn swept(from: ChartPoint, to: ChartPoint) -> Reach {
    Reach {
        chart: from.chart,
        min: from.pos.min(to.pos) - AHEAD_M,
        max: from.pos.max(to.pos) + AHEAD_M,
    }
}

fn column(feet: ChartPoint) -> Reach {
    Reach {
        chart: feet.chart,
        min: feet.pos - DVec3::new(COLUMN_M, GROUND_SEARCH_M, COLUMN_M),
        max: feet.pos + DVec3::new(COLUMN_M, LIFT_SEES_M, COLUMN_M),
    }
}

/// How far in the chart a step sees at a height of `y_m` metres; `None` for any distance.
fn chart_reach_m(atlas: &dyn Atlas, y_m: f64) -> Option<f64> {
    atlas.globe().map_or(Some(STEP_SEES_M), |globe| {
        globe.reach_in_chart_m(y_m, STEP_SEES_M)
    })
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, ChunkCoord, Geometry, strategy};

    use super::*;
    use crate::ground::chunks_near;

    fn has(reaches: &[Reach], point: ChartPoint) -> bool {
        reaches.iter().any(|reach| {
            reach.chart == point.chart
                && point.pos.cmpge(reach.min).all()
                && point.pos.cmple(reach.max).all()
        })
    }

    #[test]
    fn what_a_fast_body_comes_to_within_a_second_is_within_reach() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let feet = ChartPoint::a(DVec3::new(5.0, 100.0, -7.0));
        for velocity in [DVec3::NEG_Y * 60.0, DVec3::new(60.0, 0.0, 0.0), DVec3::ZERO] {
            let reaches = of_body(&*space, feet, velocity);
            for share in 0..=10 {
                let at = feet.pos + velocity * (f64::from(share) / 10.0);
                for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z] {
                    assert!(
                        has(&reaches, ChartPoint::a(at + side * 4.0)),
                        "{velocity} {share}"
                    );
                }
            }
        }
    }

    #[test]
    fn everything_a_pick_may_follow_on_a_sphere_is_within_reach() {
        for radius_m in [16.0, 32.0, 64.0, 128.0, 256.0] {
            let space = strategy(Geometry::Spherical, radius_m);
            let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap_or_default();
            for (far, high) in [(0.0, 0.3), (0.5, 0.2), (0.97, 0.4), (1.0, 0.5), (0.6, 1.1)] {
                let feet = ChartPoint::a(DVec3::new(far * rim_m, high * radius_m, 0.0));
                let reaches = of_body(&*space, feet, DVec3::ZERO);
                let eye = antipode_geometry::Eye {
                    point: ChartPoint::a(feet.pos + DVec3::Y * 1.6),
                    ..Default::default()
                };
                for turn in 0..200 {
                    let z = f64::from(turn) / 100.0 - 0.995;
                    let angle = f64::from(turn) * 2.4;
                    let level = (1.0 - z * z).sqrt();
                    let way = DVec3::new(level * angle.cos(), level * angle.sin(), z);
                    for distance_m in [5.0, 15.0, 27.5] {
                        let end = space.along(&eye, way, distance_m);
                        let limits = space.limits().map(|l| (l.bedrock_m, l.ceiling_m));
                        let (low, top) = limits.unwrap_or_default();
                        let there = end.pos.y > low && end.pos.y < top;
                        let other = space
                            .images(end, f64::INFINITY)
                            .pop()
                            .map_or(end, |over| over.point);
                        assert!(
                            !there || has(&reaches, end) || has(&reaches, other),
                            "{radius_m} {far} {high}: {end:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn everything_a_pick_may_follow_over_edges_of_squares_is_within_reach() {
        for radius_m in antipode_geometry::HyperbolicWorld::RADII_M {
            let space = strategy(Geometry::HyperbolicWorld, radius_m);
            let half_m = space.domain(ChartId::FIRST).half_width_m();
            for (x, z) in [
                (0.0, 0.0),
                (0.4, 0.1),
                (0.7, -0.6),
                (0.98, 0.97),
                (0.2, 0.9),
            ] {
                let feet = ChartPoint::a(DVec3::new(x * half_m, 12.0, z * half_m));
                let reaches = of_body(&*space, feet, DVec3::ZERO);
                let eye = antipode_geometry::Eye {
                    point: ChartPoint::a(feet.pos + DVec3::Y * 1.6),
                    ..Default::default()
                };
                for turn in 0..60 {
                    let angle = f64::from(turn) * 2.4;
                    let way = DVec3::new(0.98 * angle.cos(), -0.2, 0.98 * angle.sin());
                    for distance_m in [5.0, 15.0, 22.5, 29.0] {
                        let end = space.along(&eye, way.normalize(), distance_m);
                        assert!(
                            has(&reaches, end),
                            "{radius_m} {feet:?} {distance_m}: {end:?}"
                        );
                    }
                }
            }
        }
    }

    /// Else he would wait for ever.
    #[test]
    fn all_that_a_plan_waits_for_is_made_solid_for_who_makes_it() {
        let margin_m = crate::npc::ASKS_M;
        for radius_m in antipode_geometry::HyperbolicWorld::RADII_M {
            let space = strategy(Geometry::HyperbolicWorld, radius_m);
            let half_m = space.domain(ChartId::FIRST).half_width_m();
            for n in 0..400 {
                let [x, z] = [n % 20, n / 20].map(|n| (f64::from(n) / 9.5 - 1.0) * half_m);
                let at = ChartPoint::a(DVec3::new(x, 12.0, z));
                let reaches = of_others(&*space, std::iter::once((at, DVec3::ZERO)), margin_m);
                let is_made = |coord: ChunkCoord| {
                    reaches.iter().any(|it| {
                        it.chart == coord.chart
                            && it.min.cmplt(coord.max()).all()
                            && it.max.cmpge(coord.min()).all()
                    })
                };
                let mut waited = chunks_near(&*space, at, margin_m);
                waited.retain(|coord| !is_made(*coord));
                assert!(waited.is_empty(), "{radius_m} {at:?}: {waited:?}");
            }
        }
    }

    #[test]
    fn velocities_that_are_no_numbers_reach_no_farther() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let feet = ChartPoint::a(DVec3::ZERO);
        let still = of_body(&*space, feet, DVec3::ZERO);
        assert_eq!(of_body(&*space, feet, DVec3::splat(f64::NAN)), still);
        assert_eq!(of_body(&*space, feet, DVec3::splat(f64::INFINITY)), still);
    }
}
