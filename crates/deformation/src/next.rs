//! What comes next on a straight path: a face of a box, a portal, a solid, or its end.

use glam::DVec3;

use crate::aberration::Aberration;
use crate::event::{crossing_in, crossing_out};
use crate::place::Place;
use crate::scene::{SceneHit, SceneQuery};
use crate::space::Space;
use crate::stack::Stack;

/// Solids that lie on a face belong to the near side: a share of the place's numbers by which one looks beyond it.
const ON_FACE: f64 = 1e-12;
/// And as a length of way at most, metres.
const LONGEST_BEYOND_M: f64 = 1e-6;
/// A ball about a box is larger by this, far more than any rounding, metres.
const BALL_SLACK_M: f64 = 1e-3;

/// What comes next on a path, if no surface does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Next {
    /// A face of box `number` across its axis `axis`.
    Face {
        /// The box.
        number: usize,
        /// The axis.
        axis: usize,
        /// Whether it is entered.
        enters: bool,
    },
    /// Portal `number`.
    Portal {
        /// The portal.
        number: usize,
        /// Whether it is gone into before its front.
        front: bool,
    },
    /// The end of the path.
    Spent,
}

/// The first of: leaving a box of the stack, entering another, a portal, and the end of the path. Of faces that coincide those of
/// boxes that are left come first, the innermost before the others, and of boxes that are entered the outermost: so that
/// they are passed in the opposite order on the way back.
pub fn next_event(space: &Space, place: &Place, v: DVec3, longest: f64) -> (f64, Next) {
    let (stack, x) = (&place.stack, place.point);
    let longest = longest.max(0.0);
    let together = ON_FACE * (1.0 + x.abs().max_element()) / v.length();
    let mut first = next_face(space, stack, x, v, (longest, together));
    for (number, portal) in space.portals().iter().enumerate() {
        if let Some((time, front)) = portal.meets(number, x, v, place.passage)
            && time < first.0
        {
            first = (time, Next::Portal { number, front });
        }
    }
    first
}

/// The same of faces alone; of events that come within `together` of each other it is not times that decide.
fn next_face(
    space: &Space,
    stack: &Stack,
    x: DVec3,
    v: DVec3,
    (longest, together): (f64, f64),
) -> (f64, Next) {
    let boxed = |number: usize| {
        let placed = &space.placed()[number];
        let u = placed.axes.transpose() * v;
        (placed.local(x), u, placed.aberration.half)
    };
    let face = |number: usize, axis: usize, enters: bool| Next::Face {
        number,
        axis,
        enters,
    };
    let mut first = (longest, Next::Spent);
    for number in stack.iter() {
        let (l, u, h) = boxed(number);
        let (time, axis) = crossing_out(l, u, h);
        let is_tied = first.1 != Next::Spent && time <= first.0 + together;
        if time < first.0 || is_tied {
            first = (time.min(longest), face(number, axis, false));
        }
    }
    let entrances = space.entrances(stack).iter();
    for number in entrances.map(|number| usize::from(*number)) {
        if stack.contains(number) || misses(&space.placed()[number].aberration, x, v, first.0) {
            continue;
        }
        let (l, u, h) = boxed(number);
        let sooner = if first.1 == Next::Spent {
            0.0
        } else {
            together
        };
        if let Some((time, axis)) = crossing_in(l, u, h)
            && time < first.0 - sooner
        {
            first = (time, face(number, axis, true));
        }
    }
    first
}

/// Whether a path stays out of the ball about a box up to a time: so it does of most boxes of a large room.
fn misses(it: &Aberration, x: DVec3, v: DVec3, longest: f64) -> bool {
    let away = it.centre - x;
    let nearest = (away.dot(v) / v.length_squared()).clamp(0.0, longest);
    let radius = it.half.length() + BALL_SLACK_M;
    (away - v * nearest).length_squared() > radius * radius
}

/// What a path at velocity v meets before the next event. What lies in a portal's plane is hidden by it from either side.
pub fn first_solid(
    space: &Space,
    place: &Place,
    v: DVec3,
    (time, next): (f64, Next),
    scene: &dyn SceneQuery,
) -> Option<SceneHit> {
    let from = hidden(space, place, v);
    let to = time + beyond(space, place.point, v, next) - from;
    if to < 0.0 {
        return None;
    }
    let hit = scene.first(place.point + v * from, v, to)?;
    Some(SceneHit {
        time: hit.time + from,
        ..hit
    })
}

/// For how long after a portal nothing is met.
fn hidden(space: &Space, place: &Place, v: DVec3) -> f64 {
    let passage = &place.passage;
    match space.portals().get(usize::from(passage.portal)) {
        Some(portal) if passage.count > 0 && portal.is_on(place.point) => {
            portal.hidden(place.point, v)
        }
        _ => 0.0,
    }
}

/// For how long after an event solids are still met before it: those that lie on its face, to rounding. A face that is grazed
/// is come to that much later, up to a micrometre of way.
pub fn beyond(space: &Space, x: DVec3, v: DVec3, next: Next) -> f64 {
    let near = ON_FACE * (1.0 + x.abs().max_element());
    let across = match next {
        Next::Face { number, axis, .. } => space.placed()[number].axes.col(axis).dot(v).abs(),
        Next::Portal { number, .. } => return -space.portals()[number].hidden(x, v),
        Next::Spent => v.length(),
    };
    (near / across.max(1e-200)).min(LONGEST_BEYOND_M.max(near) / v.length())
}
