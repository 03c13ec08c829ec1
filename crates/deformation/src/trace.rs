//! The one routine by which everything moves: light, walkers, cameras, what is thrown, and picks.

use glam::{DMat3, DVec3};

use crate::aberration::Sides;
use crate::face::{Crossing, State, cross};
use crate::next::{Next, first_solid, next_event};
use crate::place::Place;
use crate::scene::SceneQuery;
use crate::space::{Space, Traveller};

/// Events after which a path ends.
pub const MAX_EVENTS: usize = 64;

/// What kind of thing has happened at a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A box was entered.
    Entered,
    /// A box was left.
    Left,
    /// The path was turned back.
    Reflected,
    /// A portal was passed.
    Passed,
}

/// Something that happened on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// The aberration's number, or the portal's that was gone into.
    pub number: usize,
    /// Felt metres from the start.
    pub length: f64,
    /// Where, metres of the scene.
    pub point: DVec3,
    /// Where the path goes on: behind a portal elsewhere.
    pub onward: DVec3,
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
    /// Its felt normal, of length 1, against the path and in the traveller's axes: what light is told by.
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
    /// The felt direction there in the traveller's own axes, of length 1. Only faces of snell and legacy boxes turn it;
    /// `place.turn` takes it to the axes of the scene.
    pub w: DVec3,
    /// Felt length, metres of the traveller's own size.
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

/// Travels from a place in felt direction w of the traveller's own axes, of length 1, for at most `longest` felt metres.
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
        w: start.turn.inverse() * state.w,
        length: 0.0,
        events: Vec::new(),
    };
    for _ in 0..MAX_EVENTS {
        let own = DMat3::from_quat(path.place.turn);
        let k = space.squeeze(&state.stack, state.w, who) * path.place.scale;
        let v = k * state.w;
        let (time, next) = next_event(space, &path.place, v, longest - path.length);
        if let Some(hit) = first_solid(space, &path.place, v, (time, next), scene) {
            path.advance(hit.time, v);
            let what = What::Object(hit.object, hit.part);
            path.end = End::Hit(struck(k * own, v, hit.normal, what));
            break;
        }
        path.advance(time, v);
        match next {
            Next::Spent => {
                path.end = End::Spent;
                break;
            }
            Next::Portal { number, front } => path.pass(space, &mut state, number, front),
            Next::Face {
                number,
                axis,
                enters,
            } => match cross(space, &mut state, (number, axis), enters, who) {
                Crossing::Wall => {
                    let normal = space.placed()[number].axes.col(axis);
                    let what = What::Wall(number, axis);
                    path.end = End::Hit(struck(k * own, v, normal, what));
                    break;
                }
                crossing => path.tell(crossing, number, enters),
            },
        }
        path.place.stack = state.stack;
        path.w = path.place.turn.inverse() * state.w;
    }
    path
}

impl Trace {
    fn advance(&mut self, time: f64, v: DVec3) {
        self.place.point += time * v;
        self.length += time;
    }

    fn pass(&mut self, space: &Space, state: &mut State, number: usize, front: bool) {
        let point = self.place.point;
        state.pass(space, &mut self.place, number, front);
        self.events.push(Event {
            kind: EventKind::Passed,
            number,
            length: self.length,
            point,
            onward: self.place.point,
        });
    }

    fn tell(&mut self, crossing: Crossing, number: usize, enters: bool) {
        let kind = match (crossing, enters) {
            (Crossing::Reflected, _) => EventKind::Reflected,
            (_, true) => EventKind::Entered,
            (_, false) => EventKind::Left,
        };
        self.events.push(Event {
            kind,
            number,
            length: self.length,
            point: self.place.point,
            onward: self.place.point,
        });
    }
}

/// A traveller that sets out. Light of the thesis's rule that begins inside of a box is bent before it does.
fn begin(space: &Space, start: &Place, w: DVec3, who: &Traveller) -> State {
    let w = start.turn * w;
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

/// A surface that was hit by who is carried by `k` at velocity v.
pub fn struck(k: DMat3, v: DVec3, normal: DVec3, what: What) -> Hit {
    let normal = if normal.dot(v) > 0.0 { -normal } else { normal };
    Hit {
        what,
        normal,
        felt_normal: felt_normal(k, normal),
    }
}
