//! Where a traveller is, and what portals have made of it.

use glam::{DQuat, DVec3};

use crate::event::crossing_out;
use crate::space::Space;
use crate::stack::Stack;

/// Which portal a traveller has come out of last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Passage {
    /// How many it has passed.
    pub count: u32,
    /// The number of that which it came out of.
    pub portal: u8,
    /// Whether before its front.
    pub front: bool,
}

impl Passage {
    /// Whether it is this portal that was come out of.
    pub(crate) fn is_out_of(self, number: usize) -> bool {
        self.count > 0 && usize::from(self.portal) == number
    }
}

/// A point of the scene, the boxes that contain it, and what portals have made of who is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Metres of the scene.
    pub point: DVec3,
    /// The boxes.
    pub stack: Stack,
    /// How many times larger than at first the traveller is: the product of the q of the portals that it passed.
    pub scale: f64,
    /// Turns the traveller's own axes into the scene's: the product of the O of these portals, the last to the left.
    pub turn: DQuat,
    /// The portal that it has passed last.
    pub passage: Passage,
}

impl Default for Place {
    fn default() -> Self {
        Self {
            point: DVec3::ZERO,
            stack: Stack::default(),
            scale: 1.0,
            turn: DQuat::IDENTITY,
            passage: Passage::default(),
        }
    }
}

impl Place {
    /// The place of a point that nobody has travelled to.
    pub fn at(space: &Space, point: DVec3) -> Self {
        Self {
            point,
            stack: space.stack_at(point),
            ..Self::default()
        }
    }

    /// Takes the axes of the scene for one's own again, and returns the turn that takes directions from one's axes of before
    /// to these.
    pub fn straighten(&mut self) -> DQuat {
        std::mem::replace(&mut self.turn, DQuat::IDENTITY)
    }

    /// A place at a share of the straight line from one place to another near by, 0 to 1. A box that only one of them is
    /// in is entered or left where the line meets its faces. Of places that a portal parts it is the nearer.
    pub fn between(space: &Space, from: &Self, to: &Self, share: f64) -> Self {
        if from.passage != to.passage {
            return if share < 0.5 { *from } else { *to };
        }
        let way = to.point - from.point;
        let point = from.point + way * share;
        if from.stack == to.stack {
            return Self { point, ..*from };
        }
        if share <= 0.0 || share >= 1.0 {
            return if share <= 0.0 { *from } else { *to };
        }
        let mut stack = from.stack;
        let crossed = |number: usize, place: &Self, way: DVec3| {
            let placed = &space.placed()[number];
            let u = placed.axes.transpose() * way;
            let leaves = crossing_out(placed.local(place.point), u, placed.aberration.half).0;
            leaves.min(1.0)
        };
        for number in from.stack.iter().filter(|it| !to.stack.contains(*it)) {
            if share >= crossed(number, from, way) {
                stack.remove(number);
            }
        }
        for number in to.stack.iter().filter(|it| !from.stack.contains(*it)) {
            // Entered on the way there is left on the way back.
            if 1.0 - share < crossed(number, to, -way) {
                space.push(&mut stack, number);
            }
        }
        Self {
            point,
            stack,
            ..*from
        }
    }
}
