//! Where things stand on land that nobody has touched: a pure function of its field.
//!
//! The plan is cut into cells of [`CELL_M`], each shifted by half a cell from row to row. In each a number of its own says
//! where in it a thing may stand, whether one does by how dense the groves of the biome are there, and which. What stands on
//! a chunk is what has its root there, whatever level its mesh is of. Where charts are square with the space of the noise
//! cells are that space's, so that they are the same however the charts are cut; elsewhere each chart has cells of its own,
//! of which it keeps what stands in its domain.

use std::f32::consts::TAU;

use antipode_geometry::{CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, NoiseFrame, SquareFrame};
use antipode_terrain::{Field, Footing, Thing};
use glam::{DVec2, DVec3, IVec2, Vec3};

use crate::corner::{Corner, SLOT, corners};
use crate::habitat::Habitat;
use crate::noise::{Draw, grove};
use crate::species::{Age, Species};

/// Width of a cell, metres.
const CELL_M: f64 = 4.0;
/// Cells along an edge of a chunk that may have something there: one more where borders fall on cells', and one for the shift.
const ACROSS: i32 = (CHUNK_CELLS as f64 / CELL_M) as i32 + 3;
/// The share of a cell, about its middle, in which its thing stands.
const JITTER: f64 = 0.55;
/// Nothing stands so near to the middle of the first chart, where worlds begin that have no view to begin with, metres.
const CLEAR_M: f64 = 10.0;
/// Nothing grows farther out, metres.
const FARTHEST_M: f64 = 1e9;
const _: () = assert!(ACROSS * ACROSS <= SLOT as i32, "cells have numbers below");
/// How far about a place borders of biomes are looked for, so that they are ragged, metres.
const RAGGED_M: f64 = 9.0;
/// The least upright part of a normal on which trees, bushes and boulders stand.
const LEVEL: [f32; 3] = [0.80, 0.72, 0.60];
/// Shares of all trees that are young, and that are not old.
const YOUNG: f32 = 0.24;
const NOT_OLD: f32 = 0.82;

/// What stands on a chunk, in the order of its cells.
pub fn placed(field: &Field, coord: ChunkCoord) -> Vec<Thing> {
    let (origin, side) = (coord.origin(), f64::from(CHUNK_CELLS));
    let is_in = |x: f64| (0.0..side).contains(&x);
    let is_own = |pos: DVec3| is_in(pos.x - origin.x) && is_in(pos.z - origin.z);
    let from_corner = |(root, thing): (DVec3, Thing)| {
        let root = root - origin;
        is_in(root.y).then(|| Thing {
            root: root.as_vec3(),
            ..thing
        })
    };
    let plan = Plan::of(field, coord.chart);
    let all = plan.things([origin, origin + side], is_own);
    all.filter_map(from_corner).collect()
}

/// The roots of what stands within so many metres of a place of the plan of a chart, as far as that is in its domain, and
/// what stands there.
pub fn placed_near(
    field: &Field,
    point: ChartPoint,
    within_m: f64,
) -> impl Iterator<Item = (ChartPoint, Species, Age)> {
    let ChartPoint { chart, pos } = point;
    let is_near = move |at: DVec3| (at - pos).with_y(0.0).length() <= within_m;
    let plan = Plan::of(field, chart);
    let found: Vec<_> = plan
        .things([pos - within_m, pos + within_m], is_near)
        .collect();
    let known = move |(root, thing): (DVec3, Thing)| {
        let (species, age) = (Species::of_byte(thing.species)?, Age::of_byte(thing.age)?);
        Some((ChartPoint::new(chart, root), species, age))
    };
    found.into_iter().filter_map(known)
}

/// The tree at a share, 0 to 1, of all that grow in the land about a place; an oak where that bears none.
pub fn tree_at(field: &Field, point: ChartPoint, share: f32) -> Species {
    let habitat = Habitat::of(field.biome_at(point).name());
    habitat
        .and_then(|it| it.tree(share))
        .unwrap_or(Species::Oak)
}

/// The plan of a chart.
struct Plan<'a> {
    field: &'a Field,
    chart: ChartId,
    /// How the space of the noise lies in the chart, where they are square with each other.
    frame: Option<SquareFrame>,
    /// Where nothing grows for the stones there.
    corners: Vec<Corner>,
}

impl<'a> Plan<'a> {
    fn of(field: &'a Field, chart: ChartId) -> Self {
        let frame = match field.strategy().noise_frame(chart) {
            NoiseFrame::Square(frame) => Some(frame),
            NoiseFrame::Radial { .. } | NoiseFrame::Upright => None,
        };
        Self {
            field,
            chart,
            frame,
            corners: corners(&**field.strategy(), chart),
        }
    }

    /// The cells that come into a rectangle of the plan, each with its number among those of a chunk.
    fn cells(&self, corners: [DVec3; 2]) -> impl Iterator<Item = (IVec2, u8)> + use<> {
        let [a, b] = corners.map(|at| self.frame.map_or(at, |frame| frame.placed(at)));
        let cell = |at: DVec3| (DVec2::new(at.x, at.z) / CELL_M).floor().as_ivec2();
        // A row may be shifted by half a cell.
        let (low, high) = (cell(a.min(b)) - IVec2::X, cell(a.max(b)));
        let all =
            (low.x..=high.x).flat_map(move |x| (low.y..=high.y).map(move |z| IVec2::new(x, z)));
        all.map(move |cell| {
            let [x, z] = (cell - low).to_array();
            (cell, (x * ACROSS + z) as u8)
        })
    }

    /// What stands in a rectangle of the plan, where that is wanted: the roots in the chart, and all else of each thing.
    fn things(
        &self,
        corners: [DVec3; 2],
        is_wanted: impl Fn(DVec3) -> bool + Copy,
    ) -> impl Iterator<Item = (DVec3, Thing)> {
        let far_m = corners.map(|at| at.abs().max_element());
        // Nobody comes there, and cells have their numbers.
        let is_far = far_m[0].max(far_m[1]) > FARTHEST_M;
        let grows = self.field.generator().has_things() && !is_far;
        let cells = grows.then(|| self.cells(corners)).into_iter().flatten();
        let grown = cells.filter_map(move |(cell, slot)| {
            let (root, thing) = self.thing(cell, is_wanted)?;
            Some((root, Thing { slot, ..thing }))
        });
        let corners = self.corners.iter().filter(move |_| grows);
        grown.chain(corners.filter_map(move |it| it.own_stone(self.field, self.chart, is_wanted)))
    }

    /// The thing of a cell, if it has one and that is wanted where it stands.
    fn thing(&self, cell: IVec2, is_wanted: impl Fn(DVec3) -> bool) -> Option<(DVec3, Thing)> {
        let number = self.frame.map_or(self.chart.number() as u64, |_| 0);
        let mut draw = Draw::of(self.field.seed(), number, cell);
        let shift = 0.5 * f64::from(cell.y.rem_euclid(2));
        let mut within = || 0.5 + JITTER * (f64::from(draw.share()) - 0.5);
        let at = DVec2::new(
            f64::from(cell.x) + shift + within(),
            f64::from(cell.y) + within(),
        );
        let place = DVec3::new(at.x * CELL_M, 0.0, at.y * CELL_M);
        let pos = self.frame.map_or(place, |frame| frame.taken(place));
        let domain = self.field.strategy().domain(self.chart);
        let is_middle = number == 0 && DVec2::new(place.x, place.z).length() < CLEAR_M;
        if is_middle || !is_wanted(pos) || domain.outside_m(DVec2::new(pos.x, pos.z)) > 0.0 {
            return None;
        }
        let (species, age) = self.grows(pos, &mut draw)?;
        let footing = self.field.footing(self.chart, pos.x, pos.z)?;
        let turned = self.frame.map_or(0, |frame| frame.quarter_turns);
        let thing = Thing {
            root: Vec3::ZERO,
            slot: 0,
            species: species.byte(),
            age: age.byte(),
            turn_rad: TAU * (draw.share() - 0.25 * f32::from(turned)),
            scale: 0.86 + 0.28 * draw.share(),
        };
        let reach_m = species.radius_m(age) * f64::from(thing.scale);
        let at = DVec2::new(pos.x, pos.z);
        let leaves_corners = self.corners.iter().all(|it| it.leaves(at, reach_m));
        (leaves_corners && holds(species, &footing))
            .then_some((pos.with_y(footing.height_m), thing))
    }

    /// What would grow at a place, by its biome and its groves.
    fn grows(&self, pos: DVec3, draw: &mut Draw) -> Option<(Species, Age)> {
        let way = TAU * draw.share();
        let away_m = RAGGED_M * f64::from(draw.share());
        let by = DVec3::new(f64::from(way.cos()), 0.0, f64::from(way.sin())) * away_m;
        let by = self.frame.map_or(by, |frame| frame.turned_back(by));
        let asked = ChartPoint::new(self.chart, pos + by);
        let habitat = Habitat::of(self.field.biome_at(asked).name())?;
        let point = ChartPoint::new(self.chart, pos);
        let (most, least) = habitat.trees;
        let dense = least + (1.0 - least) * grove(self.field.seed(), self.field, point);
        let age = age_of(draw.share());
        if draw.share() < most * dense {
            return Some((habitat.tree(draw.share())?, age));
        }
        if draw.share() < habitat.bushes {
            return Some((Species::Bush, age));
        }
        (draw.share() < habitat.boulders).then_some((Species::Boulder, age))
    }
}

/// The age at a share of all.
fn age_of(share: f32) -> Age {
    if share < YOUNG {
        Age::Young
    } else if share < NOT_OLD {
        Age::Grown
    } else {
        Age::Old
    }
}

/// Whether land is level enough for a kind.
fn holds(species: Species, footing: &Footing) -> bool {
    let [tree, bush, boulder] = LEVEL;
    let least = match species {
        Species::Bush => bush,
        Species::Boulder => boulder,
        _ => tree,
    };
    footing.normal.y >= least
}
