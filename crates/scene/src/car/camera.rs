//! The driver's camera: behind the car on a spring, or on the bonnet.

use antipode_geometry::{Atlas, ChartPoint, Crossing, Eye};
use antipode_physics::{ChartGround, PhysicsWorld};
use glam::DVec3;

use super::CarView;
use super::tuning::{
    BONNET_M, CHASE_BACK_M, CHASE_LOOKS_UP_M, CHASE_OVER_GROUND_M, CHASE_RATE_PER_S, CHASE_RISES_M,
    CHASE_TURN_PER_S, CHASE_UP_M, EYES_UP_M, LOOK_MOST_RAD, LOOK_RETURNS_PER_S, LOOK_STAYS_S,
    SEAT_M, STANDS_M_S,
};
use crate::aimed::ViewParams;
use crate::camera::{CameraMode, CameraPose, LookTurn};
use crate::player::wrap_angle;
use crate::situation::Situation;
use crate::tuning::CAMERA_RADIUS_M;

/// The camera's spring is stretched no farther than this, in metres.
const SPRING_MOST_M: f64 = 1.5;
/// A car that looks more steeply than this up or down, as the level share of where it looks, keeps the camera's heading.
const LEVEL_LEAST: f64 = 0.3;
/// The view from the bonnet is eased at this rate, per second.
const BONNET_RATE_PER_S: f64 = 14.0;
/// The view from the bonnet leans no farther with the car, radians: nobody drives by a picture on its side.
const LEAN_MOST_RAD: f64 = 0.6;

/// A camera that follows a car.
#[derive(Clone, Debug)]
pub(crate) struct Chase {
    /// What it follows: the car's place, on a spring.
    point: ChartPoint,
    velocity: DVec3,
    /// The heading behind which it is, radians.
    yaw: f64,
    /// How the bonnet lies, eased.
    bonnet: Bonnet,
    /// How far the player looks aside, radians to the right and up.
    aside: (f64, f64),
    since_look_s: f64,
}

/// How a car's bonnet lies, radians.
#[derive(Clone, Copy, Debug)]
struct Bonnet {
    yaw: f64,
    pitch: f64,
    /// Positive with the right side down; of a car on its roof 0, as of a level one.
    roll: f64,
}

impl Bonnet {
    fn of(car: &CarView) -> Self {
        let (ahead, right) = (car.turn * DVec3::X, car.turn * DVec3::Z);
        // Pitched by p and rolled by r, what was level to the right has -cos(p) sin(r) of height.
        let level = ahead.with_y(0.0).length().max(LEVEL_LEAST);
        Self {
            yaw: car.yaw(),
            pitch: ahead.y.clamp(-1.0, 1.0).asin(),
            roll: -(right.y / level).clamp(-1.0, 1.0).asin(),
        }
    }

    /// Goes a share of the way to another one; its heading at once, which bumps do not shake and a turn would leave
    /// behind.
    fn ease(&mut self, to: Self, share: f64) {
        if to.pitch.cos() > LEVEL_LEAST {
            self.yaw = to.yaw;
        }
        self.pitch += (to.pitch - self.pitch) * share;
        self.roll += (to.roll - self.roll) * share;
    }
}

impl Chase {
    /// A camera that begins where its spring is at rest behind a car.
    pub fn behind(car: &CarView) -> Self {
        Self {
            point: car.point,
            velocity: car.level.in_chart(car.velocity),
            yaw: car.yaw(),
            bonnet: Bonnet::of(car),
            aside: (0.0, 0.0),
            since_look_s: 0.0,
        }
    }

    /// Looks that way from now on, radians.
    pub fn aim(&mut self, yaw: f64, pitch: f64) {
        let most = LOOK_MOST_RAD;
        self.aside = (
            wrap_angle(yaw - self.yaw),
            (pitch - rest_pitch()).clamp(-most.0, most.1),
        );
        self.since_look_s = 0.0;
    }

    /// Follows the car, whose velocity in its chart is `along` (m/s of the chart), for a step, in which the player has turned the view.
    pub fn pass(&mut self, car: &CarView, along: DVec3, turned: LookTurn, dt_s: f64) {
        let stretch = car.point.pos - self.point.pos;
        // Critically damped against the car's own level speed, so that only what changes is felt.
        let level = along.with_y(0.0);
        let pull = stretch * (CHASE_RATE_PER_S * CHASE_RATE_PER_S)
            + (level - self.velocity) * (2.0 * CHASE_RATE_PER_S);
        self.velocity += pull * dt_s;
        self.point.pos += self.velocity * dt_s;
        let stretch = self.point.pos - car.point.pos;
        if stretch.length() > SPRING_MOST_M {
            self.point.pos = car.point.pos + stretch.clamp_length_max(SPRING_MOST_M);
        }
        let ahead = car.turn * DVec3::X;
        if ahead.with_y(0.0).length() > LEVEL_LEAST {
            let behind = wrap_angle(car.yaw() - self.yaw);
            self.yaw = wrap_angle(self.yaw + behind * (CHASE_TURN_PER_S * dt_s).min(1.0));
        }
        let share = (BONNET_RATE_PER_S * dt_s).min(1.0);
        self.bonnet.ease(Bonnet::of(car), share);
        self.look_aside(turned, car.velocity.length(), dt_s);
    }

    fn look_aside(&mut self, turned: LookTurn, speed_m_s: f64, dt_s: f64) {
        self.since_look_s += dt_s;
        if !turned.is_none() {
            self.since_look_s = 0.0;
            let (down, up) = LOOK_MOST_RAD;
            self.aside.0 = wrap_angle(self.aside.0 + turned.right_rad);
            self.aside.1 = (self.aside.1 + turned.up_rad).clamp(-down, up);
        }
        if self.since_look_s > LOOK_STAYS_S && speed_m_s > STANDS_M_S {
            let kept = (-LOOK_RETURNS_PER_S * dt_s).exp();
            self.aside = (self.aside.0 * kept, self.aside.1 * kept);
        }
    }

    /// Goes over the equator with the car: what it follows keeps its own place in the space.
    pub fn carry(&mut self, strategy: &dyn Atlas, crossing: &Crossing) {
        let over = strategy
            .carry_near(self.point, crossing.point)
            .unwrap_or(*crossing);
        self.point = over.point;
        self.velocity = over.turn_vector(self.velocity);
        self.yaw = wrap_angle(self.yaw - crossing.turn_rad);
        self.bonnet.yaw = wrap_angle(self.bonnet.yaw - crossing.turn_rad);
    }

    /// Where it looks, radians: heading and elevation.
    pub fn look(&self, mode: CameraMode) -> (f64, f64) {
        match mode {
            CameraMode::First => (
                self.bonnet.yaw + self.aside.0,
                self.bonnet.pitch + self.aside.1,
            ),
            CameraMode::Third => (self.yaw + self.aside.0, rest_pitch() + self.aside.1),
        }
    }

    /// How far the view from the bonnet leans with the car, radians: less the farther the player looks aside, where
    /// the same lean is a slope ahead.
    fn lean(&self) -> f64 {
        self.bonnet.roll.clamp(-LEAN_MOST_RAD, LEAN_MOST_RAD) * self.aside.0.cos()
    }

    /// How far the player can still look down, negative, and up, radians.
    fn room_rad(&self) -> [f64; 2] {
        let (down, up) = LOOK_MOST_RAD;
        [-down - self.aside.1, up - self.aside.1]
    }

    /// The camera behind the car, as far back as a small sphere finds room.
    fn pose(&self, car: &CarView, head: &Eye, physics: &PhysicsWorld) -> CameraPose {
        let (yaw, pitch) = self.look(CameraMode::Third);
        let seen = Eye {
            yaw,
            pitch,
            ..*head
        };
        let physics = physics.chart(car.point.chart);
        let from = car.place(SEAT_M + DVec3::Y * EYES_UP_M).pos;
        let looked_at = self.point.pos + DVec3::Y * CHASE_LOOKS_UP_M;
        let length_m = CHASE_BACK_M.hypot(CHASE_UP_M - CHASE_LOOKS_UP_M);
        let rests = looked_at - seen.front() * length_m;
        let room = |to: DVec3| {
            let way = to - from;
            let way_m = way.length();
            let free_m = physics
                .cast_sphere(from, way, CAMERA_RADIUS_M, way_m)
                .unwrap_or(way_m);
            (free_m, from + way.normalize_or_zero() * free_m)
        };
        // Under a roof what lies over the camera is no ground to rise above.
        let rise = over_ground(physics, rests);
        let (straight, risen) = (room(rests), room(rests + rise));
        let (pos, pitch) = if risen.0 < straight.0 {
            (straight.1, pitch)
        } else {
            // From higher up it looks down on what it looked at before.
            let down = looked_at - (rests + rise);
            let down_rad = down.y.atan2(down.with_y(0.0).length());
            (risen.1, if rise.y > 0.0 { down_rad } else { pitch })
        };
        CameraPose {
            eye: Eye {
                point: ChartPoint::new(car.point.chart, pos),
                pitch,
                lift_m: pos.y - car.point.pos.y,
                ..seen
            },
            about: ChartPoint::new(car.point.chart, looked_at),
            room_rad: self.room_rad(),
            through: None,
        }
    }
}

/// How far up a place is to be moved to be well over the ground.
fn over_ground(physics: &ChartGround, place: DVec3) -> DVec3 {
    let top = place + DVec3::Y * CHASE_RISES_M;
    let reach_m = CHASE_RISES_M + CHASE_OVER_GROUND_M;
    let hit = physics.cast_ray(top, DVec3::NEG_Y, reach_m);
    DVec3::Y * hit.map_or(0.0, |hit| reach_m - hit.distance_m)
}

/// How far down the camera behind a car looks of itself, radians.
fn rest_pitch() -> f64 {
    -(CHASE_UP_M - CHASE_LOOKS_UP_M).atan2(CHASE_BACK_M)
}

/// The driver's own eyes.
pub(crate) fn driver_head(now: Situation<'_>, params: &ViewParams) -> Option<Eye> {
    let car = now.actors.driven_car()?;
    let driving = now.actors.cars.driving.as_ref()?;
    let (yaw, pitch) = driving.chase.look(now.player.gaze.camera);
    let point = car.place(SEAT_M + DVec3::Y * EYES_UP_M);
    Some(Eye {
        point,
        yaw,
        pitch,
        roll: 0.0,
        dial: params.dial,
        lift_m: point.pos.y - car.point.pos.y,
    })
}

/// The camera that a driver's picture is taken with.
pub(crate) fn driver_camera(now: Situation<'_>, params: &ViewParams) -> Option<CameraPose> {
    let head = driver_head(now, params)?;
    let car = now.actors.driven_car()?;
    let chase = &now.actors.cars.driving.as_ref()?.chase;
    match now.player.gaze.camera {
        CameraMode::First => {
            let point = car.place(BONNET_M);
            let eye = Eye {
                point,
                roll: if params.reduced_motion {
                    0.0
                } else {
                    chase.lean()
                },
                lift_m: point.pos.y - car.point.pos.y,
                ..head
            };
            Some(CameraPose {
                room_rad: chase.room_rad(),
                ..CameraPose::within(eye)
            })
        }
        CameraMode::Third => Some(chase.pose(&car, &head, &now.world.physics)),
    }
}
