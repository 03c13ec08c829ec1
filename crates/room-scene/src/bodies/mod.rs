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

mod doors;
mod energy;
mod frame;
mod ground;
mod load;
mod make;
mod owner;
mod port;
mod relate;
mod shown;
mod thrown;
mod who;

use antipode_deformation::{Place, SceneQuery, Space, Traveller, felt_gravity};
use antipode_physics::{LooseBodies, LooseBody, LooseMotion};
use antipode_rooms::{Object, Room};
use glam::{DAffine3, DMat3, DQuat, DVec3};

use crate::tuning::{PARTS, STEP_S};
use frame::Frame;
use ground::Region;
use make::{made, middle, surface};

pub use load::Load;
pub use owner::Owner;
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
    /// Whose it is.
    pub owner: Owner,
    /// Where its file puts it, if that is from where it is.
    home: Option<Home>,
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
    /// The energy of its turning for each kilogram of its own size, J.
    turns: f64,
    /// Whether who walks holds it, so that it does not fall.
    pub held: bool,
    /// Whether it has left their hands and is not clear of them yet: till then it does not meet them.
    pub leaves: bool,
    load: Option<Load>,
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
        Self::with(all)
    }
}

impl std::fmt::Debug for Bodies {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.debug_tuple("Bodies").field(&self.all).finish()
    }
}

impl Bodies {
    /// What is loose in a room whose objects have these poses, where its file says.
    pub fn new((room, poses): (&Room, &[DAffine3]), space: &Space) -> Self {
        let body = |(index, object, mass): (usize, &Object, f64)| {
            let made = made(&object.what, mass)?;
            let (_, turn, at) = poses[index].to_scale_rotation_translation();
            let mut body = Body::new(
                Owner::Object(index),
                made,
                surface(&object.what),
                (at, turn),
            );
            body.home = Some(object_home(object));
            body.hang(middle(&object.what), space);
            Some(body)
        };
        Self::with(room.loose().filter_map(body).collect())
    }

    fn with(all: Vec<Body>) -> Self {
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
    pub fn changed(&mut self, room: (&Room, &[DAffine3]), space: &Space) {
        let mut new = Self::new(room, space);
        for body in &mut new.all {
            let like =
                |it: &&Body| it.owner == body.owner && it.made == body.made && it.home == body.home;
            if let Some(old) = self.all.iter().find(like) {
                let place = Place {
                    scale: old.place.scale,
                    ..Place::at(space, old.place.point)
                };
                (body.turn, body.velocity, body.spin) = (old.turn, old.velocity, old.spin);
                body.stand(place, space);
            }
        }
        for mut body in self.thrown().cloned().collect::<Vec<_>>() {
            let place = Place {
                scale: body.place.scale,
                ..Place::at(space, body.place.point)
            };
            body.stand(place, space);
            new.put(body);
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

    fn put(&mut self, body: Body) {
        self.solver
            .add(body.made.clone(), body.place.scale, &body.motion());
        self.all.push(body);
    }

    /// Takes out those of which that is true.
    fn take_out(&mut self, is_out: impl Fn(&Body) -> bool) {
        for number in (0..self.all.len()).rev() {
            if is_out(&self.all[number]) {
                self.all.remove(number);
                self.solver.remove(number);
            }
        }
    }

    /// What is loose: the room's objects in their order, and then what was thrown, the oldest first.
    pub fn loose(&self) -> impl Iterator<Item = &Body> {
        self.all.iter().filter(|it| it.owner != Owner::Walker)
    }

    /// The body of somebody or something.
    pub fn of(&mut self, owner: Owner) -> Option<&mut Body> {
        self.all.iter_mut().find(|it| it.owner == owner)
    }

    /// Whether anything loose is elsewhere, or turned otherwise, than before the last step.
    pub fn have_moved(&self) -> bool {
        self.loose().any(|it| it.was != (it.place, it.turn))
    }

    /// Where something was struck in the last step, and by how much its felt speed changed, metres per second.
    pub fn blows(&self) -> impl Iterator<Item = (Place, f64)> {
        self.blows
            .iter()
            .map(|(number, by)| (self.all[*number].place, *by))
    }

    /// What has its middle at such a place is where the room's file puts it again; what was thrown is gone.
    /// Whether anything was lost.
    pub fn find_again(
        &mut self,
        room: (&Room, &[DAffine3]),
        space: &Space,
        is_lost: impl Fn(DVec3) -> bool,
    ) -> bool {
        let is_lost = |it: &Body| it.owner != Owner::Walker && is_lost(it.place.point);
        if !self.all.iter().any(is_lost) {
            return false;
        }
        let at_home = Self::new(room, space);
        for body in self.all.iter_mut().filter(|it| is_lost(it)) {
            if let Some(new) = at_home.all.iter().find(|it| it.owner == body.owner) {
                *body = new.clone();
            }
        }
        self.take_out(is_lost);
        true
    }

    fn part(&mut self, around: &Around<'_>, time: f64) {
        let meetings = self.lay_out(around, time);
        for (number, body) in self.all.iter().enumerate().filter(|(_, it)| !it.rests) {
            let velocity = body.velocity + body.falls(around.g) * (0.5 * time);
            let in_chart = velocity * body.place.scale;
            self.solver.set_velocity(number, body.frame.way(in_chart));
        }
        self.weigh(around);
        let had = self.have(around.g);
        self.solver.step(time, &meetings);
        for number in 0..self.all.len() {
            if self.all[number].owner == Owner::Walker {
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
            let turns = self.solver.turning(number);
            let body = &mut self.all[number];
            let scale = body.place.scale * body.frame.scale;
            let struck = body.go(&motion, around, time);
            body.turns = turns / (scale * scale);
            self.blows.push((number, struck));
        }
        self.spend(&had, &meetings, around.g);
    }
}

impl Body {
    /// One at rest, its centre of mass at a place of the scene; its surface is about that.
    fn new(
        owner: Owner,
        made: LooseBody,
        surface: Vec<[DVec3; 3]>,
        (at, turn): (DVec3, DQuat),
    ) -> Self {
        let place = Place {
            point: at,
            ..Place::default()
        };
        Self {
            owner,
            home: None,
            reach_m: 0.0,
            made,
            middle: DVec3::ZERO,
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
            turns: 0.0,
            held: false,
            leaves: false,
            load: None,
        }
    }

    /// Its centre of mass is there about the middle of its surface, which it was about so far.
    fn hang(&mut self, middle: DVec3, space: &Space) {
        let far = self.surface.iter().flatten().map(|it| it.distance(middle));
        self.reach_m = far.fold(0.0, f64::max);
        self.middle = middle;
        let at = self.place.point + self.turn * middle;
        self.stand(Place::at(space, at), space);
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
        if self.owner == Owner::Walker || self.held {
            return DVec3::ZERO;
        }
        felt_gravity(self.squeeze, g)
    }

    /// Its energy for each kilogram of its own size, J: kept between portals by what does not move.
    pub fn energy(&self, g: DVec3) -> f64 {
        let falls = g.dot(self.place.point) / self.place.scale;
        0.5 * self.velocity.length_squared() + self.turns - falls
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
