//! Lays out what is known of columns as on a map: heights, light on slopes, contour lines, edges of squares.

use std::f64::consts::FRAC_PI_2;
use std::iter;

use antipode_geometry::{ChartPoint, Strategy};
use glam::{DVec2, DVec3, Vec2};

use super::{Extent, PlanNode, Sheet, SurveyMap, column};
use crate::bearings::{Locator, map_eye, on_map_m};
use crate::scene::Scene;

/// Heights between contour lines, metres, as on the land.
const CONTOUR_M: f32 = 8.0;
/// Where the light of the map comes from, in its own axes, and how strongly slopes take it.
const LIGHT: DVec2 = DVec2::new(-0.8, 0.6);
const RELIEF: f32 = 1.4;
/// An edge of a square is drawn in pieces of so many metres of the map, so few at least and so many at most.
const PIECE_M: f64 = 8.0;
const LEAST_PIECES: f64 = 3.0;
const MOST_PIECES: f64 = 8.0;
/// A patch that is smaller on the map tells no slope, square metres: it is held at the edge.
const LEAST_PATCH_M2: f32 = 1.0;

pub(super) fn draw(scene: &Scene, sheet: &Sheet, feet: ChartPoint) -> SurveyMap {
    let eye = map_eye(feet);
    let strategy = &*scene.sim.world.strategy;
    let locator = Locator::new(strategy, &eye);
    let land_m = on_map_m(strategy, sheet.extent.land_m(strategy));
    let (low, high) = scene.sim.world.ground.height_range_m();
    let (low, span) = (low as f32, (high - low).max(1.0) as f32);
    let mut nodes: Vec<PlanNode> = sheet
        .nodes
        .iter()
        .zip(&sheet.columns)
        .map(|(node, known)| {
            let at = locator.on_map(column(*node)).clamp_length_max(land_m);
            PlanNode {
                at: at.as_vec2().to_array(),
                share: ((known.height_m - low) / span).clamp(0.0, 1.0),
                light: 0.0,
                sky: known.sky,
                colours: known.colours,
            }
        })
        .collect();
    let height = |node: u32| sheet.columns[node as usize].height_m;
    let outside = |node: &u32| {
        let [x, z] = nodes[*node as usize].at;
        f64::from(x.hypot(z)) >= land_m - 1e-3
    };
    let patches: Vec<[u32; 4]> = sheet
        .patches
        .iter()
        .filter(|patch| !patch.iter().all(outside))
        .filter(|patch| patch.iter().all(|node| !height(*node).is_nan()))
        .copied()
        .collect();
    shade(&mut nodes, &patches, height, |at| {
        scale(strategy, at.length())
    });
    let contours = contours(&nodes, &patches, height);
    SurveyMap {
        reach_m: sheet.extent.reach_m(strategy),
        nodes,
        patches,
        contours,
        edges: edges(strategy, feet, &locator, sheet.extent),
    }
}

/// The edges of squares within the map's reach. Each is a geodesic, which is straight on no map but through its middle: on
/// the disc it is an arc that meets the rim at a right angle.
fn edges(
    strategy: &dyn Strategy,
    feet: ChartPoint,
    locator: &Locator<'_>,
    extent: Extent,
) -> Vec<[[f32; 2]; 2]> {
    let Some(tiled) = strategy.tiled() else {
        return Vec::new();
    };
    let edges_m = extent.edges_m(strategy);
    let reach_m = extent.reach_m(strategy);
    let charts = tiled.charts_within(feet, edges_m);
    let mut pieces = Vec::new();
    for (index, chart) in charts.iter().enumerate() {
        for side in 0..4u8 {
            let over = tiled.over(*chart, side).map(|(over, _)| over);
            if charts[..index].iter().any(|before| Some(*before) == over) {
                continue;
            }
            let half_m = strategy.domain(*chart).half_width_m();
            let turn = DVec2::from_angle(f64::from(side) * FRAC_PI_2);
            let at = |along: f64| {
                let at = half_m * turn.rotate(DVec2::new(1.0, along));
                locator.on_map(ChartPoint::new(*chart, DVec3::new(at.x, 0.0, at.y)))
            };
            let ends = [-1.0, 1.0].map(at);
            let count = (ends[0].distance(ends[1]) / PIECE_M).ceil();
            let count = count.clamp(LEAST_PIECES, MOST_PIECES) as u32;
            let between = (1..count).map(|it| 2.0 * f64::from(it) / f64::from(count) - 1.0);
            let whole = iter::once(ends[0]).chain(between.map(at));
            let whole: Vec<DVec2> = whole.chain([ends[1]]).collect();
            let near = whole.windows(2).map(|ends| [ends[0], ends[1]]);
            let near = near.filter(|ends| ends.iter().all(|end| end.length() <= reach_m));
            pieces.extend(near.map(|ends| ends.map(|end| end.as_vec2().to_array())));
        }
    }
    pieces
}

/// How many metres of the map a metre of the land is, so far from the map's middle: of `f = 2 R tanh(d / 2 R)` the derivative
/// by `d` is `1 - (f / 2 R)^2`, and as much across, since the disc is conformal.
fn scale(strategy: &dyn Strategy, from_middle_m: f32) -> f32 {
    if strategy.tiled().is_none() {
        return 1.0;
    }
    1.0 - (from_middle_m / on_map_m(strategy, f64::INFINITY) as f32).powi(2)
}

/// Lets the slopes of the patches about each node face the light, or not.
fn shade(
    nodes: &mut [PlanNode],
    patches: &[[u32; 4]],
    height: impl Fn(u32) -> f32,
    scale: impl Fn(Vec2) -> f32,
) {
    let mut sums = vec![(0.0, 0.0); nodes.len()];
    for patch in patches {
        // Both charts of a closed world lie on one map, the other as in a mirror: slopes are told in the map's axes.
        let place = |corner: usize| Vec2::from(nodes[patch[corner] as usize].at);
        let [a, b, c, d] = patch.map(&height);
        let (across, down) = (place(1) - place(0), place(2) - place(0));
        let area = across.perp_dot(down);
        if area.abs() < LEAST_PATCH_M2 {
            continue;
        }
        let rises = [b - a + d - c, c - a + d - b].map(|rise| 0.5 * rise);
        let slope = Vec2::new(
            rises[0] * down.y - rises[1] * across.y,
            rises[1] * across.x - rises[0] * down.x,
        ) / area;
        let light = -slope.dot(LIGHT.as_vec2()) * RELIEF * scale(place(0));
        for node in patch {
            let sum = &mut sums[*node as usize];
            *sum = (sum.0 + light, sum.1 + 1.0);
        }
    }
    for (node, (sum, count)) in nodes.iter_mut().zip(sums) {
        if count > 0.0 {
            let mean: f32 = sum / count;
            node.light = mean.clamp(-1.0, 1.0);
        }
    }
}

/// Lines of equal height, by the two triangles of each patch.
fn contours(
    nodes: &[PlanNode],
    patches: &[[u32; 4]],
    height: impl Fn(u32) -> f32,
) -> Vec<[[f32; 2]; 2]> {
    let mut lines = Vec::new();
    for [a, b, c, d] in patches {
        for triangle in [[*a, *b, *c], [*b, *d, *c]] {
            let heights = triangle.map(&height);
            let low = heights.iter().copied().fold(f32::MAX, f32::min);
            let high = heights.iter().copied().fold(f32::MIN, f32::max);
            let first = (low / CONTOUR_M).floor() as i32 + 1;
            let last = (high / CONTOUR_M).floor() as i32;
            for level in first..=last {
                let level = level as f32 * CONTOUR_M;
                let crossed = |i: usize, j: usize| {
                    let (from, to) = (heights[i], heights[j]);
                    ((from < level) != (to < level)).then(|| {
                        let share = (level - from) / (to - from);
                        let [p, q] = [i, j].map(|end| nodes[triangle[end] as usize].at);
                        [p[0] + (q[0] - p[0]) * share, p[1] + (q[1] - p[1]) * share]
                    })
                };
                let ends: Vec<_> = [(0, 1), (1, 2), (2, 0)]
                    .into_iter()
                    .filter_map(|(i, j)| crossed(i, j))
                    .collect();
                if let [from, to] = ends[..] {
                    lines.push([from, to]);
                }
            }
        }
    }
    lines
}
