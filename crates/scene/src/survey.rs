//! Surveys heights and colours of the land around the player for the map: a few columns at a time. It keeps them and lays
//! them out around the player.
//!
//! This is not part of the simulation. It reads the ground that is loaded and changes nothing.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, Globe, Strategy};
use glam::{DVec3, Vec3Swizzles};

use crate::bearings::{Locator, map_eye};
use crate::pick::over;
use crate::scene::Scene;

mod extent;
mod sheet;

pub use extent::Extent;
use sheet::draw;

/// Distance of columns in the chart, metres.
const NODE_M: f64 = 3.0;
/// Columns within this of the player are surveyed again and again: the brush reaches there, metres.
const CHANGES_M: f64 = 26.0;
/// Columns that are surveyed again for one call that finds nothing new to survey.
const AGAIN: usize = 2;
/// Steps in which a column is searched for ground from above, and halvings of the last one.
const STEP_M: f64 = 1.0;
const HALVINGS: u32 = 5;
/// Heights kept, of places further off too.
const MOST_KEPT: usize = 20_000;

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
    /// Metres of the map from the player along +x and +z of the player's chart.
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
    /// How far it reaches, in its own metres.
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
    extent: Extent,
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
    pub fn look(
        &mut self,
        scene: &Scene,
        world: u64,
        extent: Extent,
        columns: usize,
    ) -> Arc<SurveyMap> {
        if self.world != Some(world) {
            *self = Self {
                world: Some(world),
                ..Self::default()
            };
        }
        let feet = scene.feet();
        let mut sheet = match self.sheet.take() {
            Some(sheet) if sheet.extent == extent && sheet.about == node_of(feet, extent) => sheet,
            _ => {
                self.drawn = None;
                self.sheet_about(&*scene.sim.world.strategy, feet, extent)
            }
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

    fn sheet_about(&mut self, strategy: &dyn Strategy, feet: ChartPoint, extent: Extent) -> Sheet {
        if self.kept.len() > MOST_KEPT {
            self.kept.clear();
        }
        let mut nodes = nodes_about(strategy, feet, extent);
        nodes.sort_by(|a, b| a.1.total_cmp(&b.1));
        let near = nodes.partition_point(|(_, away_m)| *away_m < CHANGES_M);
        let nodes: Vec<Node> = nodes.into_iter().map(|(node, _)| node).collect();
        let columns = nodes
            .iter()
            .map(|node| self.kept.get(node).copied().unwrap_or(Known::NOTHING))
            .collect();
        Sheet {
            extent,
            about: node_of(feet, extent),
            patches: patches_of(strategy, &nodes, extent.step()),
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

/// The nearest column that a map of that extent may have.
fn node_of(point: ChartPoint, extent: Extent) -> Node {
    let step = extent.step();
    let whole = |x: f64| (x / (NODE_M * f64::from(step))).round() as i32 * step;
    Node {
        chart: point.chart,
        at: [whole(point.pos.x), whole(point.pos.z)],
    }
}

fn column(node: Node) -> ChartPoint {
    let [x, z] = node.at.map(f64::from);
    ChartPoint::new(node.chart, DVec3::new(x, 0.0, z) * NODE_M)
}

/// The columns that a map about the feet needs, with how far each is on it.
fn nodes_about(strategy: &dyn Strategy, feet: ChartPoint, extent: Extent) -> Vec<(Node, f64)> {
    let eye = map_eye(feet);
    let locator = Locator::new(strategy, &eye);
    let step = extent.step();
    let margin_m = 1.5 * NODE_M * f64::from(step);
    let reach_m = extent.land_m(strategy) + margin_m;
    let mut found = Vec::new();
    for (middle, around_m) in squares_about(strategy, feet, reach_m, margin_m) {
        let domain = strategy.domain(middle.chart);
        let Node { chart, at: [x, z] } = node_of(middle, extent);
        let around = (around_m / (NODE_M * f64::from(step))).ceil() as i32;
        for i in -around..=around {
            for j in -around..=around {
                let [x, z] = [x.saturating_add(i * step), z.saturating_add(j * step)];
                let node = Node { chart, at: [x, z] };
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
    margin_m: f64,
) -> Vec<(ChartPoint, f64)> {
    if let Some(tiled) = strategy.tiled() {
        let whole = |chart| {
            let half_m = strategy.domain(chart).half_width_m() + margin_m;
            (ChartPoint::new(chart, DVec3::ZERO), half_m)
        };
        let charts = tiled.charts_within(feet, reach_m).into_iter();
        return charts.map(whole).collect();
    }
    let span_m = reach_m * strategy.globe().map_or(1.0, |_| Globe::WIDEST);
    if let Some(globe) = strategy.globe().filter(|globe| reach_m > globe.equator_m()) {
        // It may reach past the middle of the other hemisphere.
        let whole = |chart| {
            (
                ChartPoint::new(chart, DVec3::ZERO),
                globe.equator_m() + margin_m,
            )
        };
        return vec![whole(ChartId::FIRST), whole(ChartId::SECOND)];
    }
    let images = strategy.images(feet, span_m);
    let others = images.iter().map(|image| image.point);
    let all = std::iter::once(feet).chain(others);
    all.map(|middle| (middle, span_m)).collect()
}

/// Squares of four columns that are all there, at least one of them within the chart's domain.
fn patches_of(strategy: &dyn Atlas, nodes: &[Node], step: i32) -> Vec<[u32; 4]> {
    let places: HashMap<Node, u32> = nodes.iter().copied().zip(0..).collect();
    let patch = |node: &Node| {
        let [i, j] = node.at;
        let corner = |di, dj| {
            let at = [i + di, j + dj];
            places.get(&Node { at, ..*node }).copied()
        };
        let [right, below] = [corner(step, 0)?, corner(0, step)?];
        Some([corner(0, 0)?, right, below, corner(step, step)?])
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
