//! All aberrations and portals of a scene, checked, and what is worked out of them once.

use glam::{DMat3, DVec3};

use crate::aberration::{Aberration, Sides, Ways};
use crate::error::SpaceError;
use crate::legacy::PictureCorners;
use crate::overlap::{Bounds, too_deep};
use crate::place::Place;
use crate::portal::{PlacedPortal, Portal};
use crate::portal_check::place_portals;
use crate::stack::Stack;

/// Aberrations that a space has at most.
pub const MAX_ABERRATIONS: usize = 256;
/// Aberrations that have a place in common at most.
pub const MAX_DEPTH: usize = 8;
/// Least and greatest stretch.
const STRETCHES: (f64, f64) = (1.0 / 32.0, 32.0);
/// Longest number of metres that a place or an edge has, and shortest edge.
const LONGEST_M: f64 = 1e6;
const SHORTEST_M: f64 = 1e-3;

/// An aberration with what is worked out of it.
#[derive(Clone, Debug)]
pub struct Placed {
    /// As it was given, its turn made exactly one of length 1.
    pub aberration: Aberration,
    /// Its axes as columns: takes the box's coordinates to the scene's.
    pub axes: DMat3,
    /// K: takes felt displacements inside to those of the scene.
    pub squeeze: DMat3,
    /// d = 1/s - 1, for the thesis's rule.
    pub legacy: DVec3,
    /// Boxes that have more than a face in common with it, outer ones first; only they can be entered from within it.
    pub neighbours: Vec<u8>,
    /// Where it stands on a stack: outer boxes have lower ranks.
    pub rank: usize,
}

/// Who travels: only the thesis's rule treats light and bodies differently.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Traveller {
    /// Light of a picture whose corners these are.
    Light(PictureCorners),
    /// A body, a camera, or light that belongs to no picture.
    Body,
}

/// A scene's aberrations and portals.
#[derive(Clone, Debug, Default)]
pub struct Space {
    placed: Vec<Placed>,
    outermost: Vec<u8>,
    portals: Vec<PlacedPortal>,
}

impl Space {
    /// Checks the aberrations and works out what travellers need.
    ///
    /// # Errors
    /// When there are too many, numbers are out of range, boxes overlap in part without parallel axes or lie too deep
    /// within each other, or walls leave no door.
    pub fn new(aberrations: Vec<Aberration>) -> Result<Self, SpaceError> {
        if aberrations.len() > MAX_ABERRATIONS {
            return Err(SpaceError::TooMany {
                found: aberrations.len(),
                most: MAX_ABERRATIONS,
            });
        }
        aberrations.iter().try_for_each(check)?;
        let bounds: Vec<_> = aberrations.iter().map(bounds_of).collect();
        check_overlaps(&aberrations, &bounds)?;
        let mut placed: Vec<_> = aberrations
            .into_iter()
            .enumerate()
            .map(|(number, aberration)| place(number, aberration, &bounds))
            .collect();
        // Outer boxes first: of faces that coincide theirs are entered first.
        let ranks: Vec<_> = placed.iter().map(|placed| placed.rank).collect();
        let by_rank = |number: &u8| ranks[usize::from(*number)];
        for one in &mut placed {
            one.neighbours.sort_by_key(by_rank);
        }
        Ok(Self {
            outermost: outermost(&bounds),
            placed,
            portals: Vec::new(),
        })
    }

    /// The same with portals.
    ///
    /// # Errors
    /// Those of [`Self::new`]; and when portals are too many, no convex polygons, without a partner that leads back, not similar to
    /// it as they feel, or touch each other or a side of a box.
    pub fn with_portals(
        aberrations: Vec<Aberration>,
        portals: Vec<Portal>,
    ) -> Result<Self, SpaceError> {
        let mut space = Self::new(aberrations)?;
        space.portals = place_portals(&space, portals)?;
        Ok(space)
    }

    /// The portals, by number.
    pub fn portals(&self) -> &[PlacedPortal] {
        &self.portals
    }

    /// The aberrations, by number.
    pub fn placed(&self) -> &[Placed] {
        &self.placed
    }

    /// The boxes that contain a point of the scene; a point on a face is outside.
    pub fn stack_at(&self, point: DVec3) -> Stack {
        let mut stack = Stack::default();
        for (number, placed) in self.placed.iter().enumerate() {
            let inside = placed.local(point).abs().cmplt(placed.aberration.half);
            if inside.all() {
                self.push(&mut stack, number);
            }
        }
        stack
    }

    /// Enters a box.
    pub(crate) fn push(&self, stack: &mut Stack, number: usize) {
        stack.insert(number, |other| self.placed[other].rank);
    }

    /// Boxes that can be entered next from where `stack` says that one is.
    pub fn entrances(&self, stack: &Stack) -> &[u8] {
        match stack.innermost() {
            Some(number) => &self.placed[number].neighbours,
            None => &self.outermost,
        }
    }

    /// K of all boxes of a stack for a traveller of felt direction w: their product, the innermost to the left.
    pub fn squeeze(&self, stack: &Stack, w: DVec3, who: &Traveller) -> DMat3 {
        stack.iter().fold(DMat3::IDENTITY, |outer, number| {
            self.placed[number].squeeze_for(w, who) * outer
        })
    }

    /// Shows the walls of boxes that may reach into the box between two corners, as triangles in metres of the scene.
    pub fn walls_near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        for placed in &self.placed {
            let aberration = &placed.aberration;
            let reach = placed.axes.abs() * aberration.half;
            let (from, to) = (aberration.centre - reach, aberration.centre + reach);
            if aberration.sides == Sides::Walls && from.cmple(high).all() && to.cmpge(low).all() {
                placed.show_walls(show);
            }
        }
    }

    /// The velocity in the scene of a felt direction or velocity w.
    pub fn velocity(&self, stack: &Stack, w: DVec3, who: &Traveller) -> DVec3 {
        self.squeeze(stack, w, who) * w
    }

    /// Takes felt displacements of a traveller at a place, in its own axes and sizes, to those of the scene: its scale times
    /// K times its turn. `w` is its felt direction in its own axes.
    pub fn carry(&self, place: &Place, w: DVec3, who: &Traveller) -> DMat3 {
        let turn = DMat3::from_quat(place.turn);
        self.squeeze(&place.stack, turn * w, who) * turn * place.scale
    }
}

impl Placed {
    /// A point of the scene in the box's own coordinates, from its middle.
    pub fn local(&self, point: DVec3) -> DVec3 {
        self.axes.transpose() * (point - self.aberration.centre)
    }

    fn show_walls(&self, show: &mut dyn FnMut([DVec3; 3])) {
        for axis in (0..3).filter(|axis| self.aberration.is_wall(*axis)) {
            for side in [-1.0, 1.0] {
                let corner = |b: f64, c: f64| {
                    let mut local = DVec3::ZERO;
                    local[axis] = side;
                    local[(axis + 1) % 3] = b;
                    local[(axis + 2) % 3] = c;
                    self.aberration.centre + self.axes * (local * self.aberration.half)
                };
                let corners = [
                    corner(-1.0, -1.0),
                    corner(1.0, -1.0),
                    corner(1.0, 1.0),
                    corner(-1.0, 1.0),
                ];
                show([corners[0], corners[1], corners[2]]);
                show([corners[0], corners[2], corners[3]]);
            }
        }
    }

    /// Whether it is felt by who goes in felt direction w.
    pub fn is_felt(&self, w: DVec3) -> bool {
        match self.aberration.ways {
            Ways::Both => true,
            Ways::Along(axis) => self.axes.col(usize::from(axis)).dot(w) > 0.0,
        }
    }

    /// K of this box alone for a traveller of felt direction w.
    fn squeeze_for(&self, w: DVec3, who: &Traveller) -> DMat3 {
        match (self.aberration.sides, who) {
            _ if !self.is_felt(w) => DMat3::IDENTITY,
            // The thesis bends light once and leaves it alone, and speeds bodies up along the scene's axes.
            (Sides::Legacy(_), Traveller::Light(_)) => DMat3::IDENTITY,
            (Sides::Legacy(_), Traveller::Body) => {
                DMat3::from_diagonal(self.aberration.stretch.recip())
            }
            _ => self.squeeze,
        }
    }
}

fn check(aberration: &Aberration) -> Result<(), SpaceError> {
    let name = || aberration.name.clone();
    let refuse = |what| Err(SpaceError::Number { name: name(), what });
    let within = |v: DVec3, low: f64, high: f64| {
        v.is_finite() && v.min_element() >= low && v.max_element() <= high
    };
    if !within(aberration.centre, -LONGEST_M, LONGEST_M) {
        return refuse("a place");
    }
    if !within(aberration.half, SHORTEST_M / 2.0, LONGEST_M) {
        return refuse("an edge");
    }
    if !within(aberration.stretch, STRETCHES.0, STRETCHES.1) {
        return refuse("a stretch");
    }
    let length = aberration.turn.length();
    if !(length.is_finite() && (length - 1.0).abs() < 1e-3) {
        return refuse("a turn");
    }
    if matches!(aberration.ways, Ways::Along(axis) if axis > 2) {
        return refuse("a way");
    }
    if (0..3).all(|axis| aberration.is_wall(axis)) {
        return Err(SpaceError::NoDoor { name: name() });
    }
    Ok(())
}

fn bounds_of(aberration: &Aberration) -> Bounds {
    Bounds {
        centre: aberration.centre,
        axes: DMat3::from_quat(aberration.turn.normalize()),
        half: aberration.half,
    }
}

fn check_overlaps(aberrations: &[Aberration], bounds: &[Bounds]) -> Result<(), SpaceError> {
    let name = |number: usize| aberrations[number].name.clone();
    for (second, b) in bounds.iter().enumerate() {
        for (first, a) in bounds[..second].iter().enumerate() {
            let is_nested = || a.contains(b) || b.contains(a);
            if !a.is_parallel(b) && a.overlaps(b) && !is_nested() {
                return Err(SpaceError::Overlap {
                    first: name(first),
                    second: name(second),
                });
            }
        }
    }
    match too_deep(bounds, MAX_DEPTH) {
        Ok(None) => Ok(()),
        Ok(Some(chain)) => Err(SpaceError::TooDeep {
            first: name(chain[0]),
            second: name(chain[chain.len() - 1]),
            others: chain.len() - 2,
            most: MAX_DEPTH,
        }),
        Err(number) => Err(SpaceError::TooTangled { name: name(number) }),
    }
}

fn place(number: usize, aberration: Aberration, bounds: &[Bounds]) -> Placed {
    let own = &bounds[number];
    let aberration = Aberration {
        turn: aberration.turn.normalize(),
        ..aberration
    };
    let others = || (0..bounds.len()).filter(|other| *other != number);
    // Of two equal boxes the one that is first in the list is the outer one.
    let containers = others().filter(|other| {
        let is_twin = own.contains(&bounds[*other]);
        bounds[*other].contains(own) && (!is_twin || *other < number)
    });
    Placed {
        axes: own.axes,
        squeeze: aberration.squeeze(),
        legacy: aberration.stretch.recip() - DVec3::ONE,
        neighbours: others()
            .filter(|other| own.overlaps(&bounds[*other]))
            .map(|other| other as u8)
            .collect(),
        rank: containers.count() * MAX_ABERRATIONS + number,
        aberration,
    }
}

/// Boxes that can be entered from outside of all: those that lie in no other. Of twins the first will do.
fn outermost(bounds: &[Bounds]) -> Vec<u8> {
    let is_inner = |number: usize| {
        let own = &bounds[number];
        bounds.iter().enumerate().any(|(other, b)| {
            other != number && b.contains(own) && (!own.contains(b) || other < number)
        })
    };
    (0..bounds.len())
        .filter(|number| !is_inner(*number))
        .map(|number| number as u8)
        .collect()
}
