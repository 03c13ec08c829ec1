//! A camera that flies: no solid and no wall stops it, and faces and portals take it where they lead.

use antipode_deformation::{Place, SceneQuery as _, Space, Traveller, Void, trace};
use antipode_rays::Eye;
use antipode_rooms::bounds::FARTHEST_M;
use antipode_rooms::{Room, direction};
use glam::{DQuat, DVec2, DVec3};

use super::sight::Viewpoint;
use crate::moment::Moment;
use crate::scene::RoomScene;
use crate::tuning::{EYE_M, PITCH_LIMIT_RAD};

/// How far ahead a new camera finds what it turns about, felt metres.
const PIVOT_M: f64 = 6.0;
/// How far behind a wall it goes on, metres of the scene.
const BEHIND_WALL_M: f64 = 1e-3;
/// Where nobody is seen who does not walk while a room is changed, metres.
const AWAY_M: f32 = -5000.0;
/// Most walls that one flight goes through.
const MOST_WALLS: u32 = 16;

/// A camera that flies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeCamera {
    /// Where it is, metres of the scene. In which boxes that is, is looked up whenever it is asked: a room changes about its camera.
    pub point: DVec3,
    /// Where it looks: (yaw, pitch), degrees.
    pub aim_deg: DVec2,
    /// Felt metres ahead to what it turns about.
    pub pivot_m: f64,
    /// Where all is seen along parallel lines: how far from the origin anything of the room is, metres. None where the lines meet in
    /// an eye.
    pub parallel: Option<f64>,
}

/// A side from which a room is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// From above; -z is up in the picture.
    Top,
    /// From the front: along -z.
    Front,
    /// From the side: along -x.
    Side,
}

impl Facing {
    /// Where one looks then: (yaw, pitch), degrees.
    pub fn aim_deg(self) -> DVec2 {
        match self {
            Self::Top => DVec2::new(-90.0, -90.0),
            Self::Front => DVec2::new(-90.0, 0.0),
            Self::Side => DVec2::new(180.0, 0.0),
        }
    }
}

impl FreeCamera {
    /// A camera where an eye is.
    pub fn of(eye: &Eye) -> Self {
        let mut place = eye.place;
        let turn = place.straighten();
        let front = turn * eye.front;
        Self {
            point: place.point,
            aim_deg: aim(front),
            pivot_m: PIVOT_M,
            parallel: None,
        }
    }

    /// A camera where one begins in a room, looking as one does then.
    pub fn at_start(room: &Room) -> Self {
        Self {
            point: room.spawn.at + DVec3::Y * EYE_M,
            aim_deg: room.spawn.look,
            pivot_m: PIVOT_M,
            parallel: None,
        }
    }

    fn place(&self, space: &Space) -> Place {
        Place::at(space, self.point)
    }

    /// Into the picture, to its right and to its top, of length 1.
    pub fn axes(&self) -> (DVec3, DVec3, DVec3) {
        let front = direction(self.aim_deg);
        let right = front.cross(DVec3::Y).normalize_or(DVec3::X);
        (front, right, right.cross(front))
    }

    /// The eye of its pictures. Along parallel lines it shows as much as it would see of a plane through what it turns about, from
    /// so far off that all of the room is before it.
    pub fn eye(&self, space: &Space, fov_y_rad: f64) -> Eye {
        let (front, _, _) = self.axes();
        let Some(radius_m) = self.parallel else {
            return Eye::looking(self.place(space), front, DVec3::Y, fov_y_rad);
        };
        let (pivot, _) = go(space, &self.place(space), front, self.pivot_m);
        let half_m = self.pivot_m * (0.5 * fov_y_rad).tan();
        let away_m = radius_m + pivot.point.length() + 1.0;
        let place = Place::at(space, pivot.point - front * away_m);
        // An eye there that saw as much would have this angle: by it pixels are as wide as they are.
        let narrow_rad = 2.0 * (half_m / away_m).atan();
        Eye {
            parallel_m: Some(half_m),
            ..Eye::looking(place, front, DVec3::Y, narrow_rad)
        }
    }

    /// Turns it where it is, radians to the right and upwards.
    pub fn look(&mut self, right_rad: f64, up_rad: f64) {
        self.aim_deg.x += right_rad.to_degrees();
        self.aim_deg.y = pitch(self.aim_deg.y + up_rad.to_degrees());
    }

    /// Flies by so many felt metres along its axes: ahead, to the right, up in its picture.
    pub fn fly(&mut self, space: &Space, by: DVec3) {
        let (front, right, up) = self.axes();
        let way = front * by.x + right * by.y + up * by.z;
        let Some(w) = way.try_normalize() else { return };
        let (place, turn) = go(space, &self.place(space), w, way.length());
        self.point = place.point;
        self.aim_deg = aim(turn * front);
    }

    /// Goes about what it turns about, radians to the right and upwards.
    pub fn orbit(&mut self, space: &Space, right_rad: f64, up_rad: f64) {
        let (pivot, turn) = go(space, &self.place(space), self.axes().0, self.pivot_m);
        self.aim_deg = aim(turn * self.axes().0);
        self.look(right_rad, up_rad);
        self.stand_off(space, &pivot, self.pivot_m);
    }

    /// Nearer by a factor to what it turns about, or farther off.
    pub fn zoom(&mut self, space: &Space, factor: f64) {
        let pivot_m = (self.pivot_m * factor).clamp(0.05, 2000.0);
        self.fly(space, DVec3::new(self.pivot_m - pivot_m, 0.0, 0.0));
        self.pivot_m = pivot_m;
    }

    /// Looks from outside at what is about a point of the scene and reaches so far from it, metres.
    pub fn focus(&mut self, space: &Space, point: DVec3, reach_m: f64, fov_y_rad: f64) {
        self.pivot_m = (1.3 * reach_m / (0.5 * fov_y_rad).sin()).clamp(0.2, 2000.0);
        // All of it is within that ball, so its own stretched space and its own portal do not count: who goes back from the middle of
        // a long tunnel would not come out of it.
        let out_m = reach_m.min(self.pivot_m);
        let outside = Place::at(space, point - self.axes().0 * out_m);
        self.stand_off(space, &outside, self.pivot_m - out_m);
    }

    /// Looks from that side at what it turns about.
    pub fn face(&mut self, space: &Space, facing: Facing) {
        let (pivot, _) = go(space, &self.place(space), self.axes().0, self.pivot_m);
        self.aim_deg = facing.aim_deg();
        self.stand_off(space, &pivot, self.pivot_m);
    }

    /// Goes back from a place, against where it looks.
    fn stand_off(&mut self, space: &Space, from: &Place, length_m: f64) {
        let front = self.axes().0;
        let (place, turn) = go(space, from, -front, length_m);
        self.point = place.point;
        // Who looks straight down looks to no side, so nothing but a turn by portals gives them another.
        if turn != DQuat::IDENTITY {
            self.aim_deg = aim(turn * front);
        }
    }
}

/// Flies from a place in felt direction w of the scene's axes; the end in these axes, and the turn that portals have made.
fn go(space: &Space, from: &Place, w: DVec3, length_m: f64) -> (Place, DQuat) {
    let (mut place, mut w, mut left_m) = (*from, w, length_m);
    let mut turn = DQuat::IDENTITY;
    for _ in 0..MOST_WALLS {
        let path = trace(space, &place, w, left_m, &Void, &Traveller::Body);
        left_m -= path.length;
        let ahead = path.place.turn * path.w;
        place = path.place;
        turn = place.straighten() * turn;
        place.scale = 1.0;
        w = ahead;
        if path.hit().is_none() || left_m <= 0.0 {
            break;
        }
        let v = space.carry(&place, w, &Traveller::Body) * w;
        let beyond = place.point + v.normalize_or(w) * BEHIND_WALL_M;
        place = Place::at(space, beyond);
    }
    (place, turn)
}

fn aim(front: DVec3) -> DVec2 {
    let yaw = front.z.atan2(front.x).to_degrees();
    DVec2::new(yaw, pitch(front.y.clamp(-1.0, 1.0).asin().to_degrees()))
}

fn pitch(degrees: f64) -> f64 {
    let most = PITCH_LIMIT_RAD.to_degrees();
    degrees.clamp(-most, most)
}

impl RoomScene {
    /// The space of its aberrations and portals.
    pub fn space(&self) -> &Space {
        &self.space
    }

    /// From where a free camera sees it, in pictures of that width over height.
    pub fn viewpoint(&self, camera: &FreeCamera, aspect: f64) -> Viewpoint {
        Viewpoint {
            eye: camera.eye(&self.space, self.viewing.fov_y_rad),
            aspect,
        }
    }

    /// How far from the origin anything of it is, metres.
    pub fn radius_m(&self) -> f64 {
        let corners = self
            .meshes
            .iter()
            .chain(&self.loose_meshes)
            .flat_map(|mesh| {
                let all = mesh.shape.positions.iter();
                all.map(|it| mesh.pose.transform_point3(*it).length())
            });
        let of_space = self.space.placed().iter().map(|placed| {
            let it = &placed.aberration;
            it.centre.length() + it.half.length()
        });
        let of_portals = self.space.portals().iter().flat_map(|portal| {
            let corners = portal.corners.iter();
            corners.map(|corner| corner.length())
        });
        let all = corners.chain(of_space).chain(of_portals);
        all.fold(1.0, f64::max)
    }

    /// What pictures show while it is changed: what stands in it, and nobody who walks.
    pub fn still(&self, eye: &Eye) -> Moment {
        let mut figure = self.figure_between(1.0);
        figure.pose.translation = glam::Vec3A::new(0.0, AWAY_M, 0.0);
        figure.unseen_by_eye = true;
        Moment {
            eye: *eye,
            figure,
            hand: None,
            things: Vec::new(),
            lamps: self.own_lamps(),
        }
    }

    /// Puts who walks where a free camera is, so that they look as it does; on the ground where that is nearer than they are tall, or
    /// where the camera is in it.
    pub fn walk_from(&mut self, camera: &FreeCamera) {
        let (eye_m, who) = (EYE_M, Traveller::Body);
        let eye = camera.place(&self.space);
        let above = self.solids.first(eye.point, DVec3::Y, 2.0 * FARTHEST_M);
        // Who looks up out of a solid sees its surface from within.
        let feet = if let Some(hit) = above.filter(|hit| hit.normal.y > 0.0) {
            eye.point + DVec3::Y * hit.time
        } else {
            let down = trace(&self.space, &eye, DVec3::NEG_Y, eye_m, &self.solids, &who);
            let free = || go(&self.space, &eye, DVec3::NEG_Y, eye_m).0;
            down.hit().map_or_else(free, |_| down.place).point
        };
        self.stand_at(feet);
        self.aim(camera.aim_deg.x, camera.aim_deg.y);
    }
}
