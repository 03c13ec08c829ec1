//! Handles for moving, turning and sizing: lines in the room, and where they are seen through a chain. They are as large in the
//! picture wherever they are, and bent as what stands there is.

use std::f64::consts::TAU;

use glam::{DMat3, DVec2, DVec3};

use super::sight::Viewpoint;
use super::through::Through;

/// How long handles are in the picture, in its half heights.
const REACH: f64 = 0.26;
/// Points of a straight handle, and of a ring.
const POINTS: (usize, usize) = (9, 49);
/// Where arrows that move begin, as a share of the reach: at the middle what is held is taken by itself, however small it is.
const ARROW_FROM: f64 = 0.25;
/// Where the squares that move across an axis begin and end, as shares of the reach.
const SQUARE: (f64, f64) = (0.28, 0.48);

/// What handles do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// They move things.
    #[default]
    Move,
    /// They turn things.
    Turn,
    /// They make things larger and smaller.
    Scale,
}

/// One handle, by the axis that it belongs to: 0, 1 or 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// Moves along an axis.
    Along(usize),
    /// Moves across an axis, in the plane of the others.
    Across(usize),
    /// Turns about an axis.
    About(usize),
    /// Makes larger along an axis.
    Size(usize),
    /// Makes an aberration feel longer along an axis.
    Felt(usize),
    /// The thing itself, which is moved along the ground.
    Body,
}

/// A handle as it is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct HandleLine {
    /// Which.
    pub handle: Handle,
    /// Its corners in the picture.
    pub points: Vec<DVec2>,
}

/// What handles are for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Where they begin, metres of the scene.
    pub origin: DVec3,
    /// Their axes, of length 1.
    pub axes: DMat3,
    /// Half sizes of what is held along them, metres.
    pub half: DVec3,
    /// How far against each axis the side lies that stays where it is while what is held grows along that, metres.
    pub stays_m: DVec3,
    /// The axis along which a held aberration may feel longer.
    pub felt: Option<usize>,
}

/// All handles of what is held, as they are seen through a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Handles {
    /// What for.
    pub held: Held,
    /// Where its origin is seen.
    pub at: DVec2,
    /// How long handles are, metres of the scene.
    pub reach_m: f64,
    /// Those of the tool.
    pub lines: Vec<HandleLine>,
}

impl Handles {
    /// The handles of a tool for what is held, whose origin is seen at about `at`. None where it is not seen.
    pub fn of(through: &Through<'_>, at: DVec2, held: Held, tool: Tool) -> Option<Self> {
        let at = through.seen_at(held.origin, at)?;
        let reach_m = REACH * through.metres_across(held.origin, at)?;
        let mut handles = Self {
            held,
            at,
            reach_m,
            lines: Vec::new(),
        };
        for axis in 0..3 {
            match tool {
                Tool::Move => {
                    handles.add_line(through, Handle::Along(axis), axis, (ARROW_FROM, 1.0));
                    handles.add_square(through, axis);
                }
                Tool::Turn => handles.add_ring(through, axis),
                Tool::Scale => handles.add_line(through, Handle::Size(axis), axis, (0.1, 1.0)),
            }
        }
        if let Some(axis) = held.felt {
            let from = held.half[axis] / reach_m + 0.05;
            handles.add_line(through, Handle::Felt(axis), axis, (from, from + 0.5));
            handles.add_line(through, Handle::Felt(axis), axis, (-from, -from - 0.5));
        }
        Some(handles)
    }

    fn axis(&self, axis: usize) -> DVec3 {
        self.held.axes.col(axis) * self.reach_m
    }

    fn add_line(
        &mut self,
        through: &Through<'_>,
        handle: Handle,
        axis: usize,
        (from, to): (f64, f64),
    ) {
        let way = self.axis(axis);
        let points = (0..POINTS.0).map(|it| {
            let share = it as f64 / (POINTS.0 - 1) as f64;
            way * (from + (to - from) * share)
        });
        self.add(through, handle, &points.collect::<Vec<_>>());
    }

    fn add_square(&mut self, through: &Through<'_>, axis: usize) {
        let (a, b) = (self.axis((axis + 1) % 3), self.axis((axis + 2) % 3));
        let (near, far) = SQUARE;
        let corners = [
            (near, near),
            (far, near),
            (far, far),
            (near, far),
            (near, near),
        ];
        let points = corners.map(|(x, y)| a * x + b * y);
        self.add(through, Handle::Across(axis), &points);
    }

    fn add_ring(&mut self, through: &Through<'_>, axis: usize) {
        let (a, b) = (self.axis((axis + 1) % 3), self.axis((axis + 2) % 3));
        let points = (0..POINTS.1).map(|it| {
            let (sin, cos) = (TAU * it as f64 / (POINTS.1 - 1) as f64).sin_cos();
            (a * cos + b * sin) * 0.9
        });
        self.add(through, Handle::About(axis), &points.collect::<Vec<_>>());
    }

    /// Adds what of a line is seen, each point sought from the one before.
    fn add(&mut self, through: &Through<'_>, handle: Handle, ways: &[DVec3]) {
        let mut from = self.at;
        let mut points = Vec::with_capacity(ways.len());
        for way in ways {
            if let Some(at) = through.seen_at(self.held.origin + *way, from) {
                points.push(at);
                from = at;
            }
        }
        if points.len() > 1 {
            self.lines.push(HandleLine { handle, points });
        }
    }

    /// The handle that is nearest to a place of the picture, within so many of its half heights.
    pub fn under(&self, view: &Viewpoint, at: DVec2, within: f64) -> Option<Handle> {
        let near = self.lines.iter().filter_map(|line| {
            let away = view.distance_to_line(at, &line.points);
            (away < within).then_some((away, line.handle))
        });
        let found = near.min_by(|a, b| a.0.total_cmp(&b.0));
        found.map(|(_, handle)| handle)
    }
}
