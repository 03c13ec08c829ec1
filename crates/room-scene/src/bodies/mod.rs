//! What is loose in a room: crates, balls and the like, that fall, roll, are pushed, carried and thrown, through faces and portals.
//!
//! A body belongs to the place of its middle, and keeps its felt size. In the chart of that place (`frame.rs`) it is rigid, so
//! rapier moves it there: nothing is squashed but the geometry around it. How far it has come goes by `trace`, as for all that moves,
//! so it enters boxes and passes portals as who walks does. Bodies that reach into each other's surroundings through a portal
//! or a face are laid out in one chart together (`relate.rs`) for as long as they do, and so are the solids of both sides
//! (`ground.rs`): who stands astride is met on both sides, and there is one body of it, with one momentum.
//!
//! Between steps of rapier gravity acts by halves before and after (leapfrog): from u, u + a t/2 for the time t goes
//! u t + a t^2/2 far, the parabola's own way, and (u + a t)^2/2 - a (u t + a t^2/2) = u^2/2: in free flight energy is kept exactly.

mod frame;
mod ground;
mod make;
mod port;
mod relate;
mod shown;
mod who;

use antipode_deformation::{Place, SceneQuery, Space, Traveller, felt_gravity};
use antipode_physics::{LooseBodies, LooseBody, LooseMotion};
use antipode_rooms::{Object, Room, poses};
use glam::{DMat3, DQuat, DVec3};

use crate::tuning::{PARTS, STEP_S};
use frame::Frame;
use ground::Region;
use make::{made, middle, surface};

pub use shown::{LooseSolids, Solid};

/// Who is slower than this, felt metres per second, feels boxes of one way as it did before.
const HEADING_FROM_M_S: f64 = 0.05;

/// What surrounds all bodies.
#[derive(Clone, Copy)]
pub struct Around<'a> {
    pub space: &'a Space,
    pub solids: &'a dyn SceneQuery,
    /// Gravity of the scene, m/s^2.
    pub g: DVec3,
}

/// Something loose.
#[derive(Clone, Debug)]
pub struct Body {
    /// The place of its object among all.
    pub object: usize,
    /// Where its file puts it.
    home: Home,
    made: LooseBody,
    /// Its centre of mass, which its place is that of, in metres of its own size about its object's middle.
    middle: DVec3,
    /// Triangles of its surface about that, metres of its own size.
    surface: Vec<[DVec3; 3]>,
    /// From its middle to its farthest corner, metres of its own size.
    pub reach_m: f64,
    /// Where its middle is.
    pub place: Place,
    /// How it is turned, as it feels, in the axes of the scene.
    pub turn: DQuat,
    /// Felt velocity, metres of its own size per second.
    pub velocity: DVec3,
    /// Angular velocity, radians per second.
    pub spin: DVec3,
    /// K of the boxes that it is in.
    pub squeeze: DMat3,
    /// Where it was, and how it was turned, before the last step.
    was: (Place, DQuat),
    /// From its chart to that in which rapier has it.
    frame: Frame,
    /// Where rapier has it; none if it is elsewhere now.
    laid: Option<DVec3>,
    region: Option<Region>,
    /// Whether it lies still.
    pub rests: bool,
    /// Whether it is who walks, whom no blow moves: that is for the walker to say.
    driven: bool,
    /// Whether who walks holds it, so that it does not fall.
    pub held: bool,
}

/// All that is loose in a room.
#[derive(Default)]
pub struct Bodies {
    all: Vec<Body>,
    solver: LooseBodies,
    /// Blows of the last step: the body, and the change of its felt speed, metres per second.
    blows: Vec<(usize, f64)>,
}

impl Clone for Bodies {
    fn clone(&self) -> Self {
        let mut all = self.all.clone();
        all.iter_mut().for_each(Body::lift);
        Self::of(all)
    }
}

impl std::fmt::Debug for Bodies {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.debug_tuple("Bodies").field(&self.all).finish()
    }
}

impl Bodies {
    /// What is loose in a room, where its file says.
    pub fn new(room: &Room, space: &Space) -> Self {
        let poses = poses(room);
        let body = |(index, object, mass): (usize, &Object, f64)| {
            let made = made(&object.what, mass)?;
            let (_, turn, at) = poses[index].to_scale_rotation_translation();
            Some(Body::new(
                index,
                object,
                made,
                (Place::at(space, at), turn),
                space,
            ))
        };
        Self::of(room.loose().filter_map(body).collect())
    }

    fn of(all: Vec<Body>) -> Self {
        let mut solver = LooseBodies::default();
        for body in &all {
            solver.add(body.made.clone(), body.place.scale, &body.motion());
        }
        Self {
            all,
            solver,
            blows: Vec::new(),
        }
    }

    /// The room has changed: what lay may fall, and places are in the boxes that there are now.
    pub fn changed(&mut self, room: &Room, space: &Space) {
        let mut new = Self::new(room, space);
        for body in &mut new.all {
            let object = &room.objects[body.object];
            let like = |it: &&Body| it.object == body.object && it.made == body.made;
            if let Some(old) = self.all.iter().find(like)
                && old.home == object_home(object)
            {
                let place = Place {
                    scale: old.place.scale,
                    ..Place::at(space, old.place.point)
                };
                (body.turn, body.velocity, body.spin) = (old.turn, old.velocity, old.spin);
                body.stand(place, space);
            }
        }
        *self = new;
    }

    /// Goes on by a step of [`STEP_S`].
    pub fn step(&mut self, around: &Around<'_>) {
        self.blows.clear();
        for body in &mut self.all {
            body.was = (body.place, body.turn);
        }
        if self.loose().next().is_none() {
            return;
        }
        for _ in 0..PARTS {
            self.part(around, STEP_S / f64::from(PARTS));
        }
    }

    /// What is loose, in the order of the room's objects.
    pub fn loose(&self) -> impl Iterator<Item = &Body> {
        self.all.iter().filter(|it| !it.driven)
    }

    /// That of an object.
    pub fn of_object(&mut self, object: usize) -> Option<&mut Body> {
        let mut all = self.all.iter_mut();
        all.find(|it| it.object == object && !it.driven)
    }

    /// Where something was struck in the last step, and by how much its felt speed changed, metres per second.
    pub fn blows(&self) -> impl Iterator<Item = (Place, f64)> {
        self.blows
            .iter()
            .map(|(number, by)| (self.all[*number].place, *by))
    }

    /// Those whose middle is at such a place.
    pub fn lost(&self, is_lost: impl Fn(DVec3) -> bool) -> Vec<usize> {
        let all = self.loose().enumerate();
        let lost = all.filter(|(_, it)| is_lost(it.place.point));
        lost.map(|(number, _)| number).collect()
    }

    /// These are as they are in another list of the same bodies.
    pub fn begin_anew(&mut self, which: &[usize], mut like: Self) {
        for number in which {
            std::mem::swap(&mut self.all[*number], &mut like.all[*number]);
        }
    }

    fn part(&mut self, around: &Around<'_>, time: f64) {
        let meetings = self.lay_out(around, time);
        for (number, body) in self.all.iter().enumerate().filter(|(_, it)| !it.rests) {
            let velocity = body.velocity + body.falls(around.g) * (0.5 * time);
            let in_chart = velocity * body.place.scale;
            self.solver.set_velocity(number, body.frame.way(in_chart));
        }
        self.solver.step(time, &meetings);
        for number in 0..self.all.len() {
            if self.all[number].driven {
                self.hold_still(number);
                continue;
            }
            self.all[number].rests = self.solver.sleeps(number);
            if self.all[number].rests {
                let body = &mut self.all[number];
                (body.velocity, body.spin) = (DVec3::ZERO, DVec3::ZERO);
                continue;
            }
            let Some(motion) = self.solver.motion(number) else {
                // No longer a number: it stays where it was.
                self.all[number].stop();
                continue;
            };
            let struck = self.all[number].go(&motion, around, time);
            self.blows.push((number, struck));
        }
    }
}

impl Body {
    fn new(
        index: usize,
        object: &Object,
        made: LooseBody,
        (place, turn): (Place, DQuat),
        space: &Space,
    ) -> Self {
        let surface = surface(&object.what);
        let middle = middle(&object.what);
        let far = surface.iter().flatten().map(|it| it.distance(middle));
        let place = Place::at(space, place.point + turn * middle);
        let mut body = Self {
            object: index,
            home: object_home(object),
            reach_m: far.fold(0.0, f64::max),
            made,
            middle,
            surface,
            place,
            turn,
            velocity: DVec3::ZERO,
            spin: DVec3::ZERO,
            squeeze: DMat3::IDENTITY,
            was: (place, turn),
            frame: Frame::default(),
            laid: None,
            region: None,
            rests: false,
            driven: false,
            held: false,
        };
        body.stand(place, space);
        body
    }

    /// Is at another place.
    fn stand(&mut self, place: Place, space: &Space) {
        self.place = place;
        self.squeeze = space.squeeze(&place.stack, self.velocity, &Traveller::Body);
        self.was = (place, self.turn);
        self.lift();
    }

    /// Is put anew where rapier has it.
    fn lift(&mut self) {
        (self.laid, self.region, self.rests) = (None, None, false);
    }

    fn stop(&mut self) {
        (self.velocity, self.spin) = (DVec3::ZERO, DVec3::ZERO);
        self.lift();
    }

    /// How it moves, in its chart.
    fn motion(&self) -> LooseMotion {
        LooseMotion {
            place: self.squeeze.inverse() * self.place.point,
            turn: self.turn,
            velocity: self.velocity * self.place.scale,
            spin: self.spin,
        }
    }

    /// Felt acceleration of its own size.
    fn falls(&self, g: DVec3) -> DVec3 {
        if self.driven || self.held {
            return DVec3::ZERO;
        }
        felt_gravity(self.squeeze, g)
    }

    /// Its mass where it is now, kilograms.
    pub fn mass_kg(&self) -> f64 {
        self.made.mass_kg * self.place.scale.powi(3)
    }

    /// From its own axes and sizes to the scene.
    pub fn out(&self) -> DMat3 {
        self.squeeze * self.place.scale
    }

    /// Strikes it at a place of the scene so that its felt velocity changes by `by` if that is its middle; by what is struck
    /// off the middle it turns.
    pub fn strike(&mut self, at: DVec3, by: DVec3) {
        self.velocity += by;
        let arm = self.out().inverse() * (at - self.place.point);
        let gyration = (0.4 * self.reach_m * self.reach_m).max(1e-6);
        self.spin += arm.cross(by) / gyration;
        (self.laid, self.rests) = (None, false);
    }
}

/// Where and what an object is by its file.
type Home = (DVec3, DVec3, Option<String>);

fn object_home(object: &Object) -> Home {
    (object.at, object.turn, object.group.clone())
}
