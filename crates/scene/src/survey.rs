//! Surveys heights and colours of the land around the player for the map: a few columns at a time. It keeps them and lays
//! them out around the player.
//!
//! This is not part of the simulation. It reads the ground that is loaded and changes nothing.

use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, Globe, Strategy};
use glam::{DVec2, DVec3, Vec2, Vec3Swizzles};

use crate::bearings::{Locator, map_eye};
use crate::pick::over;
use crate::scene::Scene;

/// Distance of columns in the chart, metres.
const NODE_M: f64 = 3.0;
/// How far a map reaches, metres of the space; in a small closed world less, so that nothing is shown twice.
const REACH_M: f64 = 45.0;
/// Share of the way to the equator and back that a map of a closed world reaches at most.
const CLOSED_SHARE: f64 = 0.8;
/// Columns within this of the player are surveyed again and again: the brush reaches there, metres.
const CHANGES_M: f64 = 26.0;
/// Columns that are surveyed again for one call that finds nothing new to survey.
const AGAIN: usize = 2;
/// Steps in which a column is searched for ground from above, and halvings of the last one.
const STEP_M: f64 = 1.0;
const HALVINGS: u32 = 5;
/// Heights between contour lines, metres, as on the land.
const CONTOUR_M: f32 = 8.0;
/// Heights kept, of places further off too.
const MOST_KEPT: usize = 20_000;
/// Where the light of the map comes from, in its own axes, and how strongly slopes take it.
const LIGHT: DVec2 = DVec2::new(-0.8, 0.6);
const RELIEF: f32 = 1.4;
/// Pieces in which an edge of a square is drawn.
const EDGE_PIECES: u32 = 8;
/// A patch that is smaller on the map tells no slope, square metres: it is held at the edge.
const LEAST_PATCH_M2: f32 = 1.0;

/// A column of the chart, by whole multiples of [`NODE_M`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Node {
    chart: ChartId,
    /// Whole steps along x and z.
    at: [i32; 2],
}

/// A column as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanNode {
    /// Metres from the player along +x and +z of the player's chart, as on the map.
    pub at: [f32; 2],
    /// Height of the ground, 0 where this world's is lowest to 1 where it is highest.
    pub share: f32,
    /// How much the slope faces the map's light, -1 to 1.
    pub light: f32,
    /// How much of the sky is left where the ground lies below untouched land, as in the mouth of a cave, 0 to 1.
    pub sky: f32,
    /// Colours of low, middle and high ground there, sRGB.
    pub colours: [[u8; 3]; 3],
}

/// The land about the player as on a map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurveyMap {
    /// How far it reaches, metres.
    pub reach_m: f64,
    /// Columns, of which patches tell by their place in this list.
    pub nodes: Vec<PlanNode>,
    /// Four columns each: corners of what is filled, in the order of a Z.
    pub patches: Vec<[u32; 4]>,
    /// Lines of equal height, each from one place to another.
    pub contours: Vec<[[f32; 2]; 2]>,
    /// Pieces of the edges of squares, in a world that is in squares.
    pub edges: Vec<[[f32; 2]; 2]>,
}

/// What is known of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Known {
    /// Height of its ground, metres; NaN where it is not known yet.
    height_m: f32,
    sky: f32,
    colours: [[u8; 3]; 3],
}

impl Known {
    const NOTHING: Self = Self {
        height_m: f32::NAN,
        sky: 1.0,
        colours: [[0; 3]; 3],
    };

    fn of(scene: &Scene, node: Node) -> Self {
        let column = column(node);
        let height_m = top_m(scene, column);
        let top = column.moved(DVec3::Y * height_m);
        let field = scene.field();
        Self {
            height_m: height_m as f32,
            sky: field.sky_left(top),
            colours: field.ground_colours(top),
        }
    }
}

/// The columns of a map about a place.
#[derive(Debug)]
struct Sheet {
    about: Node,
    /// The nearest first.
    nodes: Vec<Node>,
    columns: Vec<Known>,
    patches: Vec<[u32; 4]>,
    /// So many of the first ones are surveyed again and again.
    near: usize,
    /// All before this are known.
    known: usize,
    /// The next to be surveyed again.
    again: usize,
}

/// What is known of the columns of one world.
#[derive(Debug, Default)]
pub struct Survey {
    world: Option<u64>,
    kept: HashMap<Node, Known>,
    sheet: Option<Sheet>,
    drawn: Option<(ChartPoint, Arc<SurveyMap>)>,
}

impl Survey {
    /// Surveys at most `columns` new ones about the player of a world, by its number, and gives the map of what is
    /// known. Cheap where nobody moves.
    pub fn look(&mut self, scene: &Scene, world: u64, columns: usize) -> Arc<SurveyMap> {
        if self.world != Some(world) {
            *self = Self {
                world: Some(world),
                ..Self::default()
            };
        }
        let feet = scene.feet();
        let mut sheet = match self.sheet.take() {
            Some(sheet) if sheet.about == node_of(feet) => sheet,
            _ => self.sheet_about(&*scene.sim.world.strategy, feet),
        };
        let changed = self.measure(scene, &mut sheet, columns);
        let plan = match self.drawn.take() {
            Some((about, plan)) if about == feet && !changed => plan,
            _ => Arc::new(draw(scene, &sheet, feet)),
        };
        self.sheet = Some(sheet);
        self.drawn = Some((feet, Arc::clone(&plan)));
        plan
    }

    fn sheet_about(&mut self, strategy: &dyn Strategy, feet: ChartPoint) -> Sheet {
        if self.kept.len() > MOST_KEPT {
            self.kept.clear();
        }
        let mut nodes = nodes_about(strategy, feet);
        nodes.sort_by(|a, b| a.1.total_cmp(&b.1));
        let near = nodes.partition_point(|(_, away_m)| *away_m < CHANGES_M);
        let nodes: Vec<Node> = nodes.into_iter().map(|(node, _)| node).collect();
        let columns = nodes
            .iter()
            .map(|node| self.kept.get(node).copied().unwrap_or(Known::NOTHING))
            .collect();
        Sheet {
            about: node_of(feet),
            patches: patches_of(strategy, &nodes),
            nodes,
            columns,
            near,
            known: 0,
            again: 0,
        }
    }

    /// Surveys; tells whether a height is new or another.
    fn measure(&mut self, scene: &Scene, sheet: &mut Sheet, columns: usize) -> bool {
        let mut changed = false;
        let mut left = columns;
        while sheet.known < sheet.nodes.len() && left > 0 {
            if sheet.columns[sheet.known].height_m.is_nan() {
                left -= 1;
                changed |= self.measure_one(scene, sheet, sheet.known);
            }
            sheet.known += 1;
        }
        for _ in 0..AGAIN.min(left).min(sheet.near) {
            sheet.again = (sheet.again + 1) % sheet.near;
            changed |= self.measure_one(scene, sheet, sheet.again);
        }
        changed
    }

    fn measure_one(&mut self, scene: &Scene, sheet: &mut Sheet, index: usize) -> bool {
        let node = sheet.nodes[index];
        let known = Known::of(scene, node);
        let before = std::mem::replace(&mut sheet.columns[index], known);
        self.kept.insert(node, known);
        before != known
    }
}

fn node_of(point: ChartPoint) -> Node {
    let whole = |x: f64| (x / NODE_M).round() as i32;
    Node {
        chart: point.chart,
        at: [whole(point.pos.x), whole(point.pos.z)],
    }
}

fn column(node: Node) -> ChartPoint {
    let [x, z] = node.at.map(f64::from);
    ChartPoint::new(node.chart, DVec3::new(x, 0.0, z) * NODE_M)
}

fn reach_m(strategy: &dyn Atlas) -> f64 {
    // Half way round lies what is on the other side of the world.
    let farthest_m = strategy
        .globe()
        .map_or(f64::INFINITY, |globe| 0.5 * globe.round_m());
    REACH_M.min(farthest_m * CLOSED_SHARE)
}

/// The columns that a map about the feet needs, with how far each is on it.
fn nodes_about(strategy: &dyn Strategy, feet: ChartPoint) -> Vec<(Node, f64)> {
    let eye = map_eye(feet);
    let locator = Locator::new(strategy, &eye);
    let margin_m = 1.5 * NODE_M;
    let reach_m = reach_m(strategy) + margin_m;
    let mut found = Vec::new();
    for (middle, around_m) in squares_about(strategy, feet, reach_m) {
        let domain = strategy.domain(middle.chart);
        let Node { chart, at: [x, z] } = node_of(middle);
        let around = (around_m / NODE_M).ceil() as i32;
        for i in x.saturating_sub(around)..=x.saturating_add(around) {
            for j in z.saturating_sub(around)..=z.saturating_add(around) {
                let node = Node { chart, at: [i, j] };
                let point = column(node);
                if domain.outside_m(point.pos.xz()) > margin_m {
                    continue;
                }
                let away_m = locator.at(point).length();
                if away_m <= reach_m {
                    found.push((node, away_m));
                }
            }
        }
    }
    found
}

/// Of each chart that comes so near a square that holds all of it that does: its middle and half its side, metres.
fn squares_about(
    strategy: &dyn Strategy,
    feet: ChartPoint,
    reach_m: f64,
) -> Vec<(ChartPoint, f64)> {
    if let Some(tiled) = strategy.tiled() {
        let whole = |chart| {
            let half_m = strategy.domain(chart).half_width_m() + NODE_M;
            (ChartPoint::new(chart, DVec3::ZERO), half_m)
        };
        let charts = tiled.charts_within(feet, reach_m).into_iter();
        return charts.map(whole).collect();
    }
    let span_m = reach_m * strategy.globe().map_or(1.0, |_| Globe::WIDEST);
    let images = strategy.images(feet, span_m);
    let others = images.iter().map(|image| image.point);
    let all = std::iter::once(feet).chain(others);
    all.map(|middle| (middle, span_m)).collect()
}

/// Squares of four columns that are all there, at least one of them within the chart's domain.
fn patches_of(strategy: &dyn Atlas, nodes: &[Node]) -> Vec<[u32; 4]> {
    let places: HashMap<Node, u32> = nodes.iter().copied().zip(0..).collect();
    let patch = |node: &Node| {
        let [i, j] = node.at;
        let corner = |di, dj| {
            let at = [i + di, j + dj];
            places.get(&Node { at, ..*node }).copied()
        };
        Some([corner(0, 0)?, corner(1, 0)?, corner(0, 1)?, corner(1, 1)?])
    };
    nodes
        .iter()
        .filter_map(patch)
        .filter(|patch| {
            patch.iter().any(|node| {
                let point = column(nodes[*node as usize]);
                strategy.domain(point.chart).outside_m(point.pos.xz()) <= 0.0
            })
        })
        .collect()
}

/// Height of the topmost ground of a column, metres; of untouched ground where no body is near. What is thinner than
/// a step may be missed.
fn top_m(scene: &Scene, column: ChartPoint) -> f64 {
    let (mut low, mut high) = scene.sim.world.ground.height_range_m();
    let feet = scene.feet();
    let there = over(&**scene.strategy(), feet, column);
    let touched =
        there.chart == feet.chart && (there.pos - feet.pos).with_y(0.0).length() < 2.0 * CHANGES_M;
    if touched {
        low = low.min(feet.pos.y - CHANGES_M);
        high = high.max(feet.pos.y + CHANGES_M);
    }
    let is_solid = |y: f64| scene.sim.world.ground.is_solid(column.moved(DVec3::Y * y));
    let mut air = high + STEP_M;
    while air > low && !is_solid(air - STEP_M) {
        air -= STEP_M;
    }
    let mut ground = air - STEP_M;
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(air, ground);
        if is_solid(middle) {
            ground = middle;
        } else {
            air = middle;
        }
    }
    f64::midpoint(air, ground)
}

fn draw(scene: &Scene, sheet: &Sheet, feet: ChartPoint) -> SurveyMap {
    let eye = map_eye(feet);
    let strategy = &*scene.sim.world.strategy;
    let locator = Locator::new(strategy, &eye);
    let reach_m = reach_m(strategy);
    let (low, high) = scene.sim.world.ground.height_range_m();
    let (low, span) = (low as f32, (high - low).max(1.0) as f32);
    let mut nodes: Vec<PlanNode> = sheet
        .nodes
        .iter()
        .zip(&sheet.columns)
        .map(|(node, known)| {
            let at = locator.at(column(*node)).clamp_length_max(reach_m);
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
        f64::from(x.hypot(z)) >= reach_m - 1e-3
    };
    let patches: Vec<[u32; 4]> = sheet
        .patches
        .iter()
        .filter(|patch| !patch.iter().all(outside))
        .filter(|patch| patch.iter().all(|node| !height(*node).is_nan()))
        .copied()
        .collect();
    shade(&mut nodes, &patches, height);
    let contours = contours(&nodes, &patches, height);
    SurveyMap {
        reach_m,
        nodes,
        patches,
        contours,
        edges: edges(strategy, feet, &locator),
    }
}

/// The edges of squares within the map's reach. Each is a geodesic, which is straight on no map but through its middle.
fn edges(strategy: &dyn Strategy, feet: ChartPoint, locator: &Locator<'_>) -> Vec<[[f32; 2]; 2]> {
    let Some(tiled) = strategy.tiled() else {
        return Vec::new();
    };
    let reach_m = reach_m(strategy);
    let charts = tiled.charts_within(feet, reach_m);
    let mut pieces = Vec::new();
    for (index, chart) in charts.iter().enumerate() {
        for side in 0..4u8 {
            let over = tiled.over(*chart, side).map(|(over, _)| over);
            if charts[..index].iter().any(|before| Some(*before) == over) {
                continue;
            }
            let half_m = strategy.domain(*chart).half_width_m();
            let turn = DVec2::from_angle(f64::from(side) * FRAC_PI_2);
            let at = |piece: u32| {
                let along = 2.0 * f64::from(piece) / f64::from(EDGE_PIECES) - 1.0;
                let at = half_m * turn.rotate(DVec2::new(1.0, along));
                locator.at(ChartPoint::new(*chart, DVec3::new(at.x, 0.0, at.y)))
            };
            let near = (0..EDGE_PIECES).map(|piece| [piece, piece + 1].map(at));
            let near = near.filter(|ends| ends.iter().all(|end| end.length() <= reach_m));
            pieces.extend(near.map(|ends| ends.map(|end| end.as_vec2().to_array())));
        }
    }
    pieces
}

/// Lets the slopes of the patches about each node face the light, or not.
fn shade(nodes: &mut [PlanNode], patches: &[[u32; 4]], height: impl Fn(u32) -> f32) {
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
        let light = -slope.dot(LIGHT.as_vec2()) * RELIEF;
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
