//! From where one sees a room: from the head, or from behind. The camera goes by `trace` as everything does, so that it is as
//! far behind as it feels, and never behind a wall.

use antipode_deformation::{Place, Traveller, Void, trace};
use antipode_rays::Eye;
use glam::DVec3;

use crate::scene::RoomScene;
use crate::tuning::{
    CAMERA_RADIUS_M, FIGURE_SEEN_FROM_M, RADIUS_M, SHINS_M, THIRD_PERSON_BACK_M,
    THIRD_PERSON_RISES_M, THIRD_PERSON_UP_M,
};
use crate::walk::Look;

/// Halvings of the rise that shows the legs, to end within a centimetre or two.
const RISE_HALVINGS: u32 = 7;

/// A camera: its place, the felt direction into its picture by the axes of who is there, and how far behind the head it feels.
struct Camera {
    place: Place,
    front: DVec3,
    behind_m: f64,
}

impl RoomScene {
    /// Whether one sees who walks from behind.
    pub fn third_person(&self) -> bool {
        self.third_person
    }

    /// Looks from behind, or from the head.
    pub fn set_third_person(&mut self, third_person: bool) {
        self.third_person = third_person;
    }

    /// The eye of the picture: in the head of who walks, or behind it.
    pub fn eye(&self) -> Eye {
        self.eye_between(1.0)
    }

    /// The eye at a share of the way of the last step, 0 at its beginning and 1 at its end, along the way that was gone.
    pub fn eye_between(&self, share: f64) -> Eye {
        self.eye_at(share, &self.look.between(&self.looked, share))
    }

    /// The same of who looks so by now.
    pub(crate) fn eye_at(&self, share: f64, look: &Look) -> Eye {
        let mut camera = self.camera(share, look);
        let mut eye = Eye::looking(camera.place, camera.front, DVec3::Y, self.viewing.fov_y_rad);
        // Beyond a portal the axes of the scene are others.
        let turn = camera.place.straighten();
        let (sin, cos) = self.righting.roll_rad().sin_cos();
        let (right, up) = (turn * eye.right, turn * eye.up);
        eye.place = camera.place;
        eye.front = turn * eye.front;
        eye.right = right * cos - up * sin;
        eye.up = up * cos + right * sin;
        eye
    }

    /// Whether the eye is far enough from who walks to see them.
    pub(crate) fn sees_who_walks(&self, share: f64) -> bool {
        let look = self.look.between(&self.looked, share);
        self.camera(share, &look).behind_m >= FIGURE_SEEN_FROM_M
    }

    fn camera(&self, share: f64, look: &Look) -> Camera {
        let (head, middle) = self.walker.between(&self.space, self.up(), share);
        let front = look.front();
        if !self.third_person {
            return Camera {
                place: head,
                front,
                behind_m: 0.0,
            };
        }
        let (above, _, _) = self.leg(&head, self.felt_up(&head), THIRD_PERSON_UP_M);
        let longest_m = self.free_behind(&above, front);
        let (place, back, behind_m) = self.leg(&above, -front, longest_m);
        let shins = self.above(&middle, SHINS_M - RADIUS_M);
        let place = self.over_ground(place, &shins);
        // What it sees in its middle comes by the way that it went.
        Camera {
            place,
            front: -back,
            behind_m,
        }
    }

    /// How far behind a place a camera may be that keeps off what stands beside its way: nearer by, that would fill the picture.
    fn free_behind(&self, from: &Place, front: DVec3) -> f64 {
        let right = front.cross(self.felt_up(from)).normalize_or_zero();
        let beside = |way: DVec3| {
            let (place, _, _) = self.leg(from, way, CAMERA_RADIUS_M);
            // By another way round it would look at something else.
            let is_same = place.stack == from.stack && place.passage == from.passage;
            let who = Traveller::Body;
            let go = || {
                let solids = self.all_solids();
                trace(
                    &self.space,
                    &place,
                    -front,
                    THIRD_PERSON_BACK_M,
                    &solids,
                    &who,
                )
            };
            let path = is_same.then(go);
            let hit = path.filter(|path| path.hit().is_some());
            hit.map_or(THIRD_PERSON_BACK_M, |path| {
                (path.length - CAMERA_RADIUS_M).max(0.0)
            })
        };
        beside(right).min(beside(-right))
    }

    /// A place for a camera, or one above it from where another is seen: the lowest, or as high as the camera may rise. It stays
    /// where faces lie between them: what it sees in its middle would not be who walks any more.
    fn over_ground(&self, from: Place, seen: &Place) -> Place {
        let up = self.felt_up(&from);
        let body = Traveller::Body;
        let hides = |rise_m: f64| {
            let at = trace(&self.space, &from, up, rise_m, &Void, &body).place;
            if at.stack != seen.stack || at.passage != seen.passage {
                return false;
            }
            let k = self.space.carry(&at, up, &body);
            let way = k.inverse() * (seen.point - at.point);
            let length_m = way.length();
            let w = way.normalize_or(up);
            let path = trace(&self.space, &at, w, length_m, &self.all_solids(), &body);
            path.hit().is_some()
        };
        if !hides(0.0) {
            return from;
        }
        let (mut low_m, mut high_m) = (0.0, THIRD_PERSON_RISES_M);
        for _ in 0..RISE_HALVINGS {
            let middle_m = f64::midpoint(low_m, high_m);
            if hides(middle_m) {
                low_m = middle_m;
            } else {
                high_m = middle_m;
            }
        }
        self.leg(&from, up, high_m).0
    }

    /// Goes on for a felt length and stops short of what is in the way: where that is, the direction there, and how far it was.
    fn leg(&self, from: &Place, way: DVec3, length_m: f64) -> (Place, DVec3, f64) {
        let go = |longest: f64| {
            let who = Traveller::Body;
            trace(&self.space, from, way, longest, &self.all_solids(), &who)
        };
        let path = go(length_m + CAMERA_RADIUS_M);
        let free_m = path.hit().map_or(length_m, |hit| {
            // A ball touches a plane that it goes towards at that angle so much sooner.
            let cosine = hit.felt_normal.dot(path.w).abs().max(0.2);
            (path.length - CAMERA_RADIUS_M / cosine).clamp(0.0, length_m)
        });
        let path = go(free_m);
        (path.place, path.w, free_m)
    }
}
