//! The camera: in the head, or behind and above the shoulder and never inside the ground.

use antipode_geometry::{ChartPoint, Eye};
use antipode_physics::{ChartGround, PhysicsWorld};
use glam::{DMat3, DVec3};

use crate::player::wrap_angle;
use crate::tuning::{
    CAMERA_RADIUS_M, PITCH_LIMIT_RAD, THIRD_PERSON_BACK_M, THIRD_PERSON_RISES_M, THIRD_PERSON_UP_M,
};

/// From where the player sees the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum CameraMode {
    /// From the head.
    #[default]
    First,
    /// From behind.
    Third,
}

impl CameraMode {
    /// The name used by the probe.
    pub fn id(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Third => "third",
        }
    }
}

/// How far the player turns the view.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LookTurn {
    /// Radians to the right.
    pub right_rad: f64,
    /// Radians up.
    pub up_rad: f64,
}

impl LookTurn {
    /// Whether the view stays as it is.
    pub fn is_none(self) -> bool {
        self == Self::default()
    }
}

/// An eye, and how it turns with the player's look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraPose {
    /// The eye.
    pub eye: Eye,
    /// What it goes round, in the eye's chart; the eye itself in first person.
    pub about: ChartPoint,
    /// How far it can still turn down, negative, and up, radians.
    pub room_rad: [f64; 2],
    /// The leaf that the arm leads back through, if it does.
    pub through: Option<usize>,
}

impl CameraPose {
    /// A camera in the head.
    pub fn within(head: Eye) -> Self {
        Self {
            eye: head,
            about: head.point,
            room_rad: [-PITCH_LIMIT_RAD - head.pitch, PITCH_LIMIT_RAD - head.pitch],
            through: None,
        }
    }

    /// Turns with the look. Returns the rotation that everything takes that goes round with it.
    pub fn turn(&mut self, by: LookTurn) -> DMat3 {
        let before = axes(&self.eye);
        let [down_rad, most_rad] = self.room_rad;
        let up_rad = by.up_rad.clamp(down_rad.min(0.0), most_rad.max(0.0));
        self.eye.yaw = wrap_angle(self.eye.yaw + by.right_rad);
        self.eye.pitch += up_rad;
        self.room_rad = self.room_rad.map(|room| room - up_rad);
        let turn = axes(&self.eye) * before.transpose();
        let arm = self.eye.point.pos - self.about.pos;
        self.eye.point.pos = self.about.pos + turn * arm;
        turn
    }
}

/// Right, up and ahead of an eye that does not lean.
fn axes(eye: &Eye) -> DMat3 {
    let upright = Eye { roll: 0.0, ..*eye };
    DMat3::from_cols(upright.right(), upright.up(), upright.front())
}

/// How the head of a player who has died goes down: it lies so far above the feet, metres, on its side by so much,
/// radians, after so long, seconds.
const LIES_M: f64 = 0.35;
const LIES_RAD: f64 = 0.9;
const GOES_DOWN_S: f64 = 0.7;

/// What of the legs the camera behind is to see, metres above the feet.
const SHINS_M: f64 = 0.3;
/// Halvings of the rise that shows them, to end within a centimetre.
const RISE_HALVINGS: u32 = 7;

/// The eye in the head of somebody who died that long ago.
pub fn fallen(head: &Eye, dead_s: f64) -> Eye {
    let share = (dead_s / GOES_DOWN_S).clamp(0.0, 1.0);
    // As what falls does: slowly at first.
    let share = share * share;
    let down_m = share * (head.lift_m - LIES_M).max(0.0);
    Eye {
        point: head.point.moved(DVec3::NEG_Y * down_m),
        lift_m: head.lift_m - down_m,
        roll: share * LIES_RAD,
        ..*head
    }
}

/// The camera that pictures are taken with, given the eye in the player's head.
pub fn place(mode: CameraMode, head: &Eye, physics: &PhysicsWorld) -> CameraPose {
    match mode {
        CameraMode::First => CameraPose::within(*head),
        CameraMode::Third => behind(head, physics.chart(head.point.chart)),
    }
}

/// Brings a camera that has been turned since it was placed out of the ground, along its arm.
///
/// What is about the other end of an arm through a door is not in its way: that is left as it was placed.
pub fn keep_clear(camera: &mut CameraPose, physics: &PhysicsWorld) {
    if camera.through.is_some() {
        return;
    }
    let arm = camera.eye.point.pos - camera.about.pos;
    let Some(way) = arm.try_normalize() else {
        return;
    };
    // What touches from the start is not told from what is in the ground.
    let free_m = physics
        .chart(camera.about.chart)
        .cast_sphere(camera.about.pos, way, CAMERA_RADIUS_M, arm.length())
        .filter(|free_m| *free_m > 0.0);
    if let Some(free_m) = free_m {
        camera.eye.point.pos = camera.about.pos + way * free_m;
    }
}

/// Backs away from the head in two legs, up and then back, each as far as a small sphere finds room.
fn behind(head: &Eye, physics: &ChartGround) -> CameraPose {
    let above = leg(physics, head.point.pos, DVec3::Y, THIRD_PERSON_UP_M);
    let back = leg(physics, above, -head.front(), THIRD_PERSON_BACK_M);
    let shins = head.point.pos - DVec3::Y * (head.lift_m - SHINS_M);
    let back = over_ground(physics, back, shins);
    let point = ChartPoint::new(head.point.chart, back);
    let eye = Eye {
        lift_m: head.lift_m + point.pos.y - head.point.pos.y,
        point,
        ..*head
    };
    CameraPose {
        eye,
        about: ChartPoint::new(head.point.chart, above),
        ..CameraPose::within(*head)
    }
}

/// The eye behind a head as if there were no ground.
pub fn free_behind(head: &Eye) -> Eye {
    let off = DVec3::Y * THIRD_PERSON_UP_M - head.front() * THIRD_PERSON_BACK_M;
    Eye {
        point: head.point.moved(off),
        lift_m: head.lift_m + off.y,
        ..*head
    }
}

/// A place for a camera, or one above it from where a point is seen: the lowest, or as high as the camera may rise.
fn over_ground(physics: &ChartGround, from: DVec3, seen: DVec3) -> DVec3 {
    let at = |rise_m: f64| from + DVec3::Y * rise_m;
    let hides = |rise_m: f64| {
        let way = seen - at(rise_m);
        let hit = physics.cast_ray(at(rise_m), way, way.length());
        hit.is_some()
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
    leg(physics, from, DVec3::Y, high_m)
}

fn leg(physics: &ChartGround, from: DVec3, way: DVec3, length_m: f64) -> DVec3 {
    let free_m = physics
        .cast_sphere(from, way, CAMERA_RADIUS_M, length_m)
        .unwrap_or(length_m);
    from + way * free_m
}
