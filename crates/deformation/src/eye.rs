//! How high a walker's eye is.

use glam::{DQuat, DVec3};

use crate::gravity::felt_gravity;
use crate::place::Place;
use crate::scene::{SceneQuery, Void};
use crate::space::{Space, Traveller};
use crate::trace::trace;
use crate::tuning::{EYE_CLEAR_M, EYE_GLIDE_S, RIGHTING_S};

/// The felt height of a walker's eye above its middle. A box that is stretched upwards moves the eye in the scene when the
/// middle enters it; the eye stays where it was and glides to its felt height instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EyeHeight {
    /// Felt height where nothing has changed, metres.
    rest_m: f64,
    /// What it is off by, metres, when the glide began.
    off_m: f64,
    /// Of the glide, seconds that are left.
    left_s: f64,
    /// Something is above: no higher than this, metres.
    most_m: f64,
    /// Took felt up to where the eye was, as seen from the middle, when a portal turned the body.
    lean: DQuat,
    /// Of the time in which it is upright again, seconds that are left.
    lean_left_s: f64,
}

impl EyeHeight {
    /// An eye at rest, `rest_m` felt metres above the walker's middle.
    pub fn new(rest_m: f64) -> Self {
        Self {
            rest_m,
            off_m: 0.0,
            left_s: 0.0,
            most_m: f64::INFINITY,
            lean: DQuat::IDENTITY,
            lean_left_s: 0.0,
        }
    }

    /// Felt metres above the middle.
    pub fn height_m(&self) -> f64 {
        // Begins and ends without a jump of speed.
        let share = (self.left_s / EYE_GLIDE_S).clamp(0.0, 1.0);
        let height = self.rest_m + self.off_m * share * share * (3.0 - 2.0 * share);
        height.min(self.most_m)
    }

    /// Looks what is above: an eye that was higher up before its walker came into a box comes down sooner under a lintel.
    pub fn duck(&mut self, space: &Space, scene: &dyn SceneQuery, middle: &Place, up: DVec3) {
        self.most_m = f64::INFINITY;
        let reach = self.height_m() + EYE_CLEAR_M;
        let w = self.way_up(space, middle, up);
        let path = trace(space, middle, w, reach, scene, &Traveller::Body);
        if path.hit().is_some() {
            self.most_m = (path.length - EYE_CLEAR_M).max(0.0);
        }
    }

    /// Time passes.
    pub fn glide(&mut self, time_s: f64) {
        self.left_s = (self.left_s - time_s).max(0.0);
        self.lean_left_s = (self.lean_left_s - time_s).max(0.0);
    }

    /// A portal has turned the body: the eye stays where it was, and glides above the middle. `before` and `after` are the
    /// middle's places just before the portal and behind it.
    pub fn lean(&mut self, space: &Space, (before, after): (&Place, &Place), up: DVec3) {
        let was = self.way_up(space, before, up);
        self.lean = DQuat::from_rotation_arc(felt_up(space, after, up), was);
        self.lean_left_s = RIGHTING_S;
    }

    /// The body's axes are turned so into others.
    pub fn straighten(&mut self, turn: DQuat) {
        self.lean = turn * self.lean * turn.inverse();
    }

    /// It is above the middle at once.
    pub fn right_at_once(&mut self) {
        self.lean_left_s = 0.0;
    }

    /// From the middle to the eye, of length 1, in the body's axes.
    fn way_up(&self, space: &Space, middle: &Place, up: DVec3) -> DVec3 {
        let share = self.lean_left_s / RIGHTING_S;
        let share = share * share * (3.0 - 2.0 * share);
        DQuat::IDENTITY.slerp(self.lean, share) * felt_up(space, middle, up)
    }

    /// The walker's middle came into or out of a box at `middle`, where its eye was at `eye`: the eye stays there.
    pub fn keep(&mut self, space: &Space, middle: &Place, up: DVec3, eye: DVec3) {
        let wanted = (eye - middle.point).dot(up);
        let rise = |felt: f64| {
            let w = self.way_up(space, middle, up);
            let end = trace(space, middle, w, felt, &Void, &Traveller::Body).place;
            (end.point - middle.point).dot(up)
        };
        let (mut low, mut high) = (0.0, 64.0 * self.rest_m.max(0.1));
        for _ in 0..48 {
            let between = 0.5 * (low + high);
            if rise(between) < wanted {
                low = between;
            } else {
                high = between;
            }
        }
        self.off_m = 0.5 * (low + high) - self.rest_m;
        self.left_s = EYE_GLIDE_S;
    }

    /// The place of the eye.
    pub fn place(&self, space: &Space, middle: &Place, up: DVec3) -> Place {
        let w = self.way_up(space, middle, up);
        trace(space, middle, w, self.height_m(), &Void, &Traveller::Body).place
    }
}

/// Against felt gravity in the axes of who is there, of length 1; `up` is the scene's.
fn felt_up(space: &Space, place: &Place, up: DVec3) -> DVec3 {
    let k = space.carry(place, place.turn.inverse() * up, &Traveller::Body);
    felt_gravity(k, up).normalize_or(up)
}
