//! What a place of a picture shows, found by the path that its light has taken.

use antipode_deformation::{
    Chain, EventKind, Place, SceneHit, SceneQuery, Solids, Trace, Traveller, trace,
};
use antipode_rays::Eye;
use glam::{DVec2, DVec3};

use crate::scene::RoomScene;
use crate::tuning::PICK_M;

/// From so high above a point the ground below it is looked for, and so far down, metres.
const ABOVE_M: f64 = 1.0;
const DOWN_M: f64 = 4.0;

/// An eye and the shape of its picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint {
    /// The eye.
    pub eye: Eye,
    /// Width over height.
    pub aspect: f64,
}

impl Viewpoint {
    /// The felt direction of a place of the picture, of length 1.
    pub fn direction(&self, at: DVec2) -> DVec3 {
        self.eye.direction(at.x, at.y, self.aspect)
    }

    /// Where the light of a place of the picture comes in.
    pub fn start(&self, at: DVec2) -> Place {
        self.eye.start(at.x, at.y, self.aspect)
    }

    /// Where in the picture a way from the eye would end, felt metres; none behind the eye.
    pub fn place_of(&self, w: DVec3) -> Option<DVec2> {
        if let Some(half) = self.eye.parallel_m {
            let at = DVec2::new(self.eye.right.dot(w) / self.aspect, self.eye.up.dot(w));
            return (self.eye.front.dot(w) > 0.0).then(|| at / half);
        }
        let depth = self.eye.front.dot(w);
        let half = (0.5 * self.eye.fov_y_rad).tan();
        let at = DVec2::new(self.eye.right.dot(w) / self.aspect, self.eye.up.dot(w));
        (depth > 1e-9 * w.length()).then(|| at / (depth * half))
    }

    /// How far apart two places of the picture are, in its half heights.
    pub fn apart(&self, a: DVec2, b: DVec2) -> f64 {
        self.spread(a - b).length()
    }

    /// A way in the picture in its half heights along both axes.
    pub(super) fn spread(&self, way: DVec2) -> DVec2 {
        DVec2::new(way.x * self.aspect, way.y)
    }

    /// How far a place of the picture is from a line of straight pieces, in half heights.
    pub fn distance_to_line(&self, at: DVec2, points: &[DVec2]) -> f64 {
        let pieces = points.windows(2).map(|piece| {
            let (a, way) = (self.spread(at - piece[0]), self.spread(piece[1] - piece[0]));
            let share = (a.dot(way) / way.length_squared().max(1e-18)).clamp(0.0, 1.0);
            (a - way * share).length()
        });
        pieces.fold(f64::INFINITY, f64::min)
    }
}

/// What is seen at a place of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Sight {
    /// The object, by its place among all.
    pub object: usize,
    /// Where it is seen, metres of the scene.
    pub place: Place,
    /// Its normal there in the scene, of length 1, towards the eye.
    pub normal: DVec3,
    /// How far off it feels, metres.
    pub felt_m: f64,
    /// What the light has come through.
    pub chain: Chain,
}

/// Solids without some of the objects.
struct Beside<'a> {
    solids: &'a Solids,
    hidden: &'a [usize],
}

impl SceneQuery for Beside<'_> {
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let takes = |object: u32| !self.hidden.contains(&(object as usize));
        self.solids.first_of(x, v, longest, takes)
    }

    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        self.solids.near(low, high, show);
    }
}

impl RoomScene {
    /// What is seen at a place of the picture; none where that is the sky.
    pub fn seen(&self, view: &Viewpoint, at: DVec2) -> Option<Sight> {
        let path = self.path_of(view, at);
        let hit = path.hit()?;
        Some(Sight {
            object: self.object_of(hit.what)?,
            place: path.place,
            normal: hit.normal,
            felt_m: path.length,
            chain: Chain::of(&self.space, &view.start(at), &path),
        })
    }

    /// The same as if these objects were not there, by their places among all.
    pub fn seen_beside(&self, view: &Viewpoint, at: DVec2, hidden: &[usize]) -> Option<Sight> {
        let solids = Beside {
            solids: &self.solids,
            hidden,
        };
        let start = &view.start(at);
        let who = Traveller::Body;
        let w = view.direction(at);
        let path = trace(&self.space, start, w, PICK_M, &solids, &who);
        let hit = path.hit()?;
        Some(Sight {
            object: self.object_of(hit.what)?,
            place: path.place,
            normal: hit.normal,
            felt_m: path.length,
            chain: Chain::of(&self.space, start, &path),
        })
    }

    /// The ground below a point of the scene; none where there is none near by.
    pub fn ground_below(&self, point: DVec3) -> Option<DVec3> {
        let from = Place::at(&self.space, point + DVec3::Y * ABOVE_M);
        let who = Traveller::Body;
        let path = trace(&self.space, &from, DVec3::NEG_Y, DOWN_M, &self.solids, &who);
        path.hit().map(|_| path.place.point)
    }

    /// All that can be meant by a place of the picture, by their places among the objects: what is seen, then the aberrations
    /// and portals that its light has come through, the last first.
    pub fn meant(&self, view: &Viewpoint, at: DVec2) -> Vec<usize> {
        let path = self.path_of(view, at);
        let seen = path.hit().and_then(|hit| self.object_of(hit.what));
        let through = path.events.iter().rev().map(|event| match event.kind {
            EventKind::Passed => self.portals[event.number],
            _ => self.boxes[event.number],
        });
        let mut all = Vec::new();
        for object in seen.into_iter().chain(through) {
            if !all.contains(&object) {
                all.push(object);
            }
        }
        all
    }

    fn path_of(&self, view: &Viewpoint, at: DVec2) -> Trace {
        let w = view.direction(at);
        let who = Traveller::Body;
        trace(&self.space, &view.start(at), w, PICK_M, &self.solids, &who)
    }
}
