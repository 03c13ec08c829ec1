//! The one routine by which everything moves: light, walkers, cameras, what is thrown, and picks.

use glam::{DMat3, DVec3};

use crate::aberration::Sides;
use crate::event::{crossing_in, crossing_out};
use crate::face::{Crossing, State, cross};
use crate::scene::SceneQuery;
use crate::space::{Space, Traveller};
use crate::stack::Stack;

/// Events after which a path ends.
pub const MAX_EVENTS: usize = 64;
/// Solids that lie on a face belong to the near side: a share of the place's numbers by which one looks beyond it.
const ON_FACE: f64 = 1e-12;
/// And as a length of way at most, metres.
const LONGEST_BEYOND_M: f64 = 1e-6;

/// A point of the scene and the boxes that contain it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Metres of the scene.
    pub point: DVec3,
    /// The boxes.
    pub stack: Stack,
}

impl Place {
    /// The place of a point that nobody has travelled to.
    pub fn at(space: &Space, point: DVec3) -> Self {
        Self {
            point,
            stack: space.stack_at(point),
        }
    }

    /// A place at a share of the straight line from one place to another near by, 0 to 1. A box that only one of them is
    /// in is entered or left where the line meets its faces.
    pub fn between(space: &Space, from: &Self, to: &Self, share: f64) -> Self {
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
        Self { point, stack }
    }
}

/// What kind of thing has happened at a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A box was entered.
    Entered,
    /// A box was left.
    Left,
    /// The path was turned back.
    Reflected,
}

/// Something that happened on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// The aberration's number.
    pub aberration: usize,
    /// Felt metres from the start.
    pub length: f64,
    /// Where, metres of the scene.
    pub point: DVec3,
}

/// What was hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// An object of the scene, and which part of it.
    Object(u32, u32),
    /// The wall of an aberration, by number, across this axis of it.
    Wall(usize, usize),
}

/// A surface that a path has come to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// What it is.
    pub what: What,
    /// Its normal in the scene, of length 1, against the path.
    pub normal: DVec3,
    /// Its felt normal, of length 1, against the path: what light is told by.
    pub felt_normal: DVec3,
}

/// How a path has ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// At a surface.
    Hit(Hit),
    /// It has its whole length.
    Spent,
    /// After as many events as there may be: what is beyond lies in fog.
    TooManyEvents,
}

/// A path that was travelled.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// How it ended.
    pub end: End,
    /// Where.
    pub place: Place,
    /// The felt direction there, of length 1. Only faces of snell and legacy boxes turn it.
    pub w: DVec3,
    /// Felt length, metres.
    pub length: f64,
    /// What happened on the way.
    pub events: Vec<Event>,
}

impl Trace {
    /// The surface that was hit, if one was.
    pub fn hit(&self) -> Option<&Hit> {
        match &self.end {
            End::Hit(hit) => Some(hit),
            _ => None,
        }
    }
}

/// Normal, felt inside of boxes of product K, of a surface of normal n in the scene: tangents of the surface are A t in felt
/// axes, A = K^-1, and K^T n is what has no product with them. Of length 1.
pub fn felt_normal(k: DMat3, n: DVec3) -> DVec3 {
    (k.transpose() * n).normalize()
}

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
    /// The end of the path.
    Spent,
}

/// Travels from a place in felt direction w, of length 1, for at most `longest` felt metres.
pub fn trace(
    space: &Space,
    start: &Place,
    w: DVec3,
    longest: f64,
    scene: &dyn SceneQuery,
    who: &Traveller,
) -> Trace {
    let mut state = begin(space, start, w, who);
    let mut path = Trace {
        end: End::TooManyEvents,
        place: *start,
        w: state.w,
        length: 0.0,
        events: Vec::new(),
    };
    for _ in 0..MAX_EVENTS {
        let k = space.squeeze(&state.stack, state.w, who);
        let v = k * state.w;
        let (time, next) = next_event(
            space,
            &state.stack,
            path.place.point,
            v,
            longest - path.length,
        );
        let beyond = beyond(space, path.place.point, v, next);
        if let Some(hit) = scene.first(path.place.point, v, time + beyond) {
            path.advance(hit.time, v);
            path.end = End::Hit(struck(k, v, hit.normal, What::Object(hit.object, hit.part)));
            break;
        }
        path.advance(time, v);
        let Next::Face {
            number,
            axis,
            enters,
        } = next
        else {
            path.end = End::Spent;
            break;
        };
        match cross(space, &mut state, (number, axis), enters, who) {
            Crossing::Wall => {
                let normal = space.placed()[number].axes.col(axis);
                path.end = End::Hit(struck(k, v, normal, What::Wall(number, axis)));
                break;
            }
            crossing => path.tell(crossing, number, enters),
        }
        (path.place.stack, path.w) = (state.stack, state.w);
    }
    path
}

/// For how long after an event solids are still met before it: those that lie on its face, to rounding. A face that is grazed
/// is come to that much later, up to a micrometre of way.
pub fn beyond(space: &Space, x: DVec3, v: DVec3, next: Next) -> f64 {
    let near = ON_FACE * (1.0 + x.abs().max_element());
    let across = match next {
        Next::Face { number, axis, .. } => space.placed()[number].axes.col(axis).dot(v).abs(),
        Next::Spent => v.length(),
    };
    (near / across.max(1e-200)).min(LONGEST_BEYOND_M.max(near) / v.length())
}

impl Trace {
    fn advance(&mut self, time: f64, v: DVec3) {
        self.place.point += time * v;
        self.length += time;
    }

    fn tell(&mut self, crossing: Crossing, aberration: usize, enters: bool) {
        let kind = match (crossing, enters) {
            (Crossing::Reflected, _) => EventKind::Reflected,
            (_, true) => EventKind::Entered,
            (_, false) => EventKind::Left,
        };
        self.events.push(Event {
            kind,
            aberration,
            length: self.length,
            point: self.place.point,
        });
    }
}

/// A traveller that sets out. Light of the thesis's rule that begins inside of a box is bent before it does.
fn begin(space: &Space, start: &Place, w: DVec3, who: &Traveller) -> State {
    let mut state = State {
        w,
        stack: start.stack,
        unbent: w,
    };
    if let Traveller::Light(corners) = who {
        for placed in start.stack.iter().map(|number| &space.placed()[number]) {
            if matches!(placed.aberration.sides, Sides::Legacy(_)) && placed.is_felt(w) {
                state.w = corners.bend(state.w, placed.legacy);
            }
        }
    }
    state
}

/// The first of: leaving a box of the stack, entering another, and the end of the path. Of faces that coincide those of
/// boxes that are left come first, the innermost before the others, and of boxes that are entered the outermost: so that
/// they are passed in the opposite order on the way back.
pub fn next_event(space: &Space, stack: &Stack, x: DVec3, v: DVec3, longest: f64) -> (f64, Next) {
    let boxed = |number: usize| {
        let placed = &space.placed()[number];
        let u = placed.axes.transpose() * v;
        (placed.local(x), u, placed.aberration.half)
    };
    let longest = longest.max(0.0);
    let together = ON_FACE * (1.0 + x.abs().max_element()) / v.length();
    let mut first = (longest, Next::Spent);
    for number in stack.iter() {
        let (l, u, h) = boxed(number);
        let (time, axis) = crossing_out(l, u, h);
        let is_tied = first.1 != Next::Spent && time <= first.0 + together;
        if time < first.0 || is_tied {
            let enters = false;
            first = (
                time.min(longest),
                Next::Face {
                    number,
                    axis,
                    enters,
                },
            );
        }
    }
    for number in space
        .entrances(stack)
        .iter()
        .map(|number| usize::from(*number))
    {
        if stack.contains(number) {
            continue;
        }
        let (l, u, h) = boxed(number);
        if let Some((time, axis)) = crossing_in(l, u, h)
            && time
                < first.0
                    - if first.1 == Next::Spent {
                        0.0
                    } else {
                        together
                    }
        {
            let enters = true;
            first = (
                time,
                Next::Face {
                    number,
                    axis,
                    enters,
                },
            );
        }
    }
    first
}

fn struck(k: DMat3, v: DVec3, normal: DVec3, what: What) -> Hit {
    let normal = if normal.dot(v) > 0.0 { -normal } else { normal };
    Hit {
        what,
        normal,
        felt_normal: felt_normal(k, normal),
    }
}

/// Whether the sun, in felt direction `sun` of length 1, is seen from a place: it is the same direction behind every box,
/// since no face turns w. `far` is how far off nothing stands any more, felt metres.
pub fn sun_is_seen(
    space: &Space,
    place: &Place,
    sun: DVec3,
    far: f64,
    scene: &dyn SceneQuery,
) -> bool {
    trace(space, place, sun, far, scene, &Traveller::Body).end == End::Spent
}
