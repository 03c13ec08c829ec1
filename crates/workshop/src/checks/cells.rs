//! The ground in cells: an approximate cell decomposition (J.-C. Latombe, Robot Motion Planning, 1991) by a quadtree. A cell is free
//! where somebody fits wherever one stands in it, on a level floor without holes. So one is anywhere in a free cell who is in
//! it at all, and comes from it to all free cells beside it, whatever their sizes: of a wide lawn few are looked at.
//!
//! Cells are squares of felt metres, level as it feels: a box with more room inside has more of them. What is free is told by the
//! triangles that are near rather than by rays, so that nothing is too small to be met.

use std::cell::RefCell;
use std::collections::HashMap;

use antipode_deformation::{Place, PlacedPortal, SceneQuery, Stack, Traveller};
use glam::{DMat3, DQuat, DVec3, IVec3};

use super::area::{Area, clipped};
use super::ground::Ground;

/// The edge of the least cells, and the height of all, felt metres. The height is no round number, so that floors, which are at
/// round ones, do not come to lie between two cells.
pub(crate) const CELL_M: f64 = 0.5;
const CELL_HIGH_M: f64 = 0.9871;
/// How often the edge of the least cells is doubled for the greatest.
const TOP: u32 = 8;
/// Steps of sizes to a doubling: who is as large to a step has the same cells.
const SIZES: f64 = 8.0;
/// How much a floor may rise or sink to count as level, felt metres.
const LEVEL_M: f64 = 0.02;
const LEVEL: DVec3 = DVec3::new(0.0, LEVEL_M, 0.0);
/// Of a floor without holes so much may be missing in a cell, square metres: a small share of what somebody takes up.
const MOST_OPEN_M2: f64 = 0.01;
/// What a place may be off by rounding, metres.
const ROUNDING_M: f64 = 1e-6;

/// A cell, by the boxes around it, the size of who is there, how often its edge was doubled, and its numbers. Where portals stand in
/// it, it is parted by their planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Cell {
    boxes: u128,
    size: i32,
    level: u32,
    at: IVec3,
    /// A bit for each of these portals before whose front it is.
    before: u64,
}

/// What is in a cell, and so near to it that it is in the way there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    /// A level floor and nothing else: somebody can stand anywhere.
    Free,
    /// Solids are in the way, or there are holes.
    Mixed,
    /// There are faces of boxes, or portals.
    Faced,
}

/// How who is at a place feels the scene: straight axes with y upwards, felt metres.
pub(crate) struct Frame {
    /// Turns felt directions so that up is y.
    pub upright: DQuat,
    /// From the scene to these axes, and back.
    pub felt: DMat3,
    pub scene: DMat3,
    /// Metres of these axes for a felt one: 1 but for a fraction of a step of sizes.
    pub scale: f64,
    stack: Stack,
    size: i32,
}

/// The cells that were looked at.
pub(crate) struct Cells<'a> {
    pub ground: &'a Ground<'a>,
    /// What is in them, with the height of the floor for which that was told.
    known: RefCell<HashMap<Cell, (Kind, f64)>>,
}

impl Frame {
    /// That of a place at which nobody is turned.
    pub fn of(ground: &Ground<'_>, place: &Place) -> Self {
        let size = (place.scale.log2() * SIZES).round();
        let scale = (size / SIZES).exp2();
        let k = ground
            .space
            .squeeze(&place.stack, DVec3::ZERO, &Traveller::Body)
            * scale;
        let upright = DQuat::from_rotation_arc(ground.up(place), DVec3::Y);
        let felt = DMat3::from_quat(upright) * k.inverse();
        Self {
            upright,
            felt,
            scene: felt.inverse(),
            scale: place.scale / scale,
            stack: place.stack,
            size: size as i32,
        }
    }

    /// The least cell in which a point of these axes is.
    fn least_cell(&self, felt: DVec3) -> Cell {
        let edges = DVec3::new(CELL_M, CELL_HIGH_M, CELL_M);
        let hash = |so_far: u128, it| so_far.wrapping_mul(257).wrapping_add(it as u128 + 1);
        Cell {
            boxes: self.stack.iter().fold(0, hash),
            size: self.size,
            level: 0,
            before: 0,
            at: (felt / edges + DVec3::Y / 2.0).floor().as_ivec3(),
        }
    }
}

impl Cell {
    /// That cell of a level in which this is.
    fn within(&self, level: u32) -> Self {
        let by = level - self.level;
        let at = IVec3::new(self.at.x >> by, self.at.y, self.at.z >> by);
        Self { level, at, ..*self }
    }

    /// Its edge, felt metres.
    pub fn edge_m(&self) -> f64 {
        CELL_M * f64::from(1 << self.level)
    }

    /// Its least and greatest corner at these heights, in the axes of its frame.
    pub fn corners(&self, low: f64, high: f64) -> (DVec3, DVec3) {
        let edge = self.edge_m();
        let (x, z) = (f64::from(self.at.x) * edge, f64::from(self.at.z) * edge);
        (DVec3::new(x, low, z), DVec3::new(x + edge, high, z + edge))
    }
}

impl<'a> Cells<'a> {
    /// None of which anything is known.
    pub fn new(ground: &'a Ground<'a>) -> Self {
        let known = RefCell::default();
        Self { ground, known }
    }

    /// The greatest free cell around who stands there, or else the least of all, and what is in it.
    pub fn find(&self, knee: &Place) -> (Cell, Kind) {
        let frame = Frame::of(self.ground, knee);
        self.around(&frame, frame.felt * knee.point)
    }

    /// The same of who stands at a point of a frame.
    pub fn around(&self, frame: &Frame, knee: DVec3) -> (Cell, Kind) {
        let least = frame.least_cell(knee);
        let floor = knee.y - self.ground.knee_m() * frame.scale;
        let mut kind = Kind::Mixed;
        for level in (0..=TOP).rev() {
            let cell = least.within(level);
            let known = self.known.borrow().get(&cell).copied();
            let told = known.unwrap_or_else(|| {
                let told = (self.look(frame, &cell, floor), floor);
                self.known.borrow_mut().insert(cell, told);
                told
            });
            kind = told.0;
            if kind == Kind::Free && (told.1 - floor).abs() <= 2.0 * LEVEL_M {
                return (cell, kind);
            }
        }
        if kind != Kind::Faced {
            return (least, Kind::Mixed);
        }
        let point = frame.scene * knee;
        let near = self.portals_near(frame, self.bodies(frame, &least, floor));
        let fronts = near.filter(|it| it.1.before(point) > 0.0);
        let before = fronts.fold(0, |bits, it| bits | 1 << it.0);
        (Cell { before, ..least }, kind)
    }

    /// Where bodies are that stand in a cell: its least and greatest corner.
    fn bodies(&self, frame: &Frame, cell: &Cell, floor: f64) -> (DVec3, DVec3) {
        let shape = &self.ground.shape;
        let (low, high) = cell.corners(floor, floor + shape.height_m * frame.scale);
        let about = DVec3::new(1.0, 0.0, 1.0) * shape.radius_m * frame.scale;
        (low - about, high + about)
    }

    fn look(&self, frame: &Frame, cell: &Cell, floor: f64) -> Kind {
        let bodies = self.bodies(frame, cell, floor);
        if self.has_faces(frame, bodies) || self.portals_near(frame, bodies).next().is_some() {
            Kind::Faced
        } else if self.is_free(frame, bodies, cell.corners(floor, floor)) {
            Kind::Free
        } else {
            Kind::Mixed
        }
    }

    /// Whether a face of a box may reach into a box of the frame.
    fn has_faces(&self, frame: &Frame, (low, high): (DVec3, DVec3)) -> bool {
        let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
        let mut all = self.ground.space.placed().iter().enumerate();
        all.any(|(number, placed)| {
            let it = &placed.aberration;
            if frame.stack.contains(number) {
                let away = placed.local(frame.scene * middle).abs();
                let reach = (placed.axes.transpose() * frame.scene).abs() * half;
                return (away + reach).cmpgt(it.half + ROUNDING_M).any();
            }
            let at = frame.felt * it.centre;
            let reach = (frame.felt * placed.axes).abs() * it.half;
            touch((at - reach, at + reach), (low - LEVEL, high))
        })
    }

    /// The portals that may reach into a box of the frame.
    fn portals_near<'b>(
        &'b self,
        frame: &'b Frame,
        (low, high): (DVec3, DVec3),
    ) -> impl Iterator<Item = (usize, &'b PlacedPortal)> {
        let all = self.ground.space.portals().iter().enumerate();
        all.filter(move |(_, portal)| {
            let corners = portal.corners.iter().map(|it| frame.felt * *it);
            let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let reach = corners.fold(none, |(a, b), it| (a.min(it), b.max(it)));
            touch(reach, (low - LEVEL, high))
        })
    }

    /// Whether no solid is where bodies would be, and all of a cell has a floor.
    fn is_free(&self, frame: &Frame, bodies: (DVec3, DVec3), cell: (DVec3, DVec3)) -> bool {
        let mut open = Area::rectangle(cell.0, cell.1);
        let mut is_free = true;
        let mut show = |corners: [DVec3; 3]| {
            let felt = corners.map(|it| frame.felt * it);
            is_free = is_free && clipped(&felt, bodies.0 + LEVEL, bodies.1).is_empty();
            if is_free {
                is_free = open.take_away(&clipped(&felt, cell.0 - LEVEL, cell.1 + LEVEL));
            }
        };
        let (low, high) = (bodies.0 - LEVEL, bodies.1);
        let middle = frame.scene * ((low + high) / 2.0);
        let reach = frame.scene.abs() * ((high - low) / 2.0);
        let solids = self.ground.solids;
        solids.near(middle - reach, middle + reach, &mut show);
        is_free && open.m2() <= MOST_OPEN_M2
    }
}

/// Whether two boxes, each by its least and greatest corner, have a place in common.
fn touch(one: (DVec3, DVec3), other: (DVec3, DVec3)) -> bool {
    one.0.cmple(other.1).all() && one.1.cmpge(other.0).all()
}
