//! How particles move: chips and spray as bullets that fall do, dust as the air lets it.

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_physics::{Ball, BallTuning};
use glam::DVec3;

use super::{Particle, Sort};
use crate::tuning::{BULLET, STEP_S};
use crate::world::World;

/// How a chip meets the ground; its radius is its own.
const CHIP: BallTuning = BallTuning {
    radius_m: 0.02,
    gravity_m_s2: BULLET.gravity_m_s2,
    bounce: 0.3,
    slide: 0.55,
};
/// A chip that has touched the ground and is slower than this lies, m/s.
const LIES_BELOW_M_S: f64 = 0.5;
/// Ground is met exactly within so many metres of where the field says that it is: it rises by about a metre a metre.
const NEAR_M: f64 = 0.6;
/// What is so deep in ground has none to meet, metres.
const LOST_M: f64 = 1.0;
/// The share of its speed that dust loses in a second, as a rate.
const DRAG_PER_S: f64 = 3.2;
/// Dust falls or rises at this speed in the end, m/s.
const RISES_M_S: f64 = 0.10;
/// Dust is pushed out of the ground to this share of its radius above it.
const RIDES: f64 = 0.25;

/// Moves all particles by a step, and lets those go that are at their end.
pub(super) fn step(pool: &mut Vec<Particle>, world: &World) {
    pool.retain_mut(|it| {
        it.age_s += STEP_S;
        it.age_s < it.life_s && it.fly(world)
    });
}

impl Particle {
    /// Moves it by a step; returns whether it is still there.
    fn fly(&mut self, world: &World) -> bool {
        if self.lies {
            return true;
        }
        let is_there = match self.sort {
            Sort::Dust => self.drift(world),
            Sort::Spray | Sort::Chip => self.fall(world),
        };
        if let Some(crossing) = world.strategy.cross(self.point) {
            self.point = crossing.point;
            self.velocity = crossing.turn_vector(self.velocity);
            self.up = crossing.turn_vector(self.up);
        }
        is_there && self.point.pos.is_finite()
    }

    fn fall(&mut self, world: &World) -> bool {
        let mut ball = Ball {
            centre: self.point.pos,
            velocity: self.velocity,
        };
        let density = density(world, self.point);
        if density < -LOST_M {
            return false;
        }
        let tuning = BallTuning {
            radius_m: 0.6 * self.radius_m[0],
            ..CHIP
        };
        let ground = world.physics.for_bodies(&*world.strategy, self.point.chart);
        let touch = if density > NEAR_M + self.velocity.length() * STEP_S {
            ground.fall(&mut ball, tuning.gravity_m_s2, STEP_S);
            None
        } else {
            ground.throw_ball(&mut ball, &tuning, STEP_S).touch
        };
        self.point.pos = ball.centre;
        self.velocity = ball.velocity;
        self.turned_m += self.velocity.length() * STEP_S;
        self.height_m = density.max(0.0);
        let Some(touch) = touch else { return true };
        self.up = touch.normal;
        if self.velocity.length() < LIES_BELOW_M_S {
            self.velocity = DVec3::ZERO;
            self.lies = true;
        }
        self.sort == Sort::Chip
    }

    fn drift(&mut self, world: &World) -> bool {
        let kept = (-DRAG_PER_S * STEP_S).exp();
        let wind = DVec3::Y * RISES_M_S;
        self.velocity = wind + (self.velocity - wind) * kept;
        let velocity = world.strategy.in_chart(self.point, self.velocity);
        self.point.pos += velocity * STEP_S;
        self.height_m = density(world, self.point);
        let rides_m = RIDES * self.radius_m[0];
        if self.height_m < rides_m {
            self.point.pos += self.up * (rides_m - self.height_m).min(0.1);
            let into = self.velocity.dot(self.up).min(0.0);
            self.velocity -= self.up * into;
        }
        self.height_m > -LOST_M
    }
}

/// The field at a place, about the metres to the ground; where none is loaded there is none.
fn density(world: &World, point: ChartPoint) -> f64 {
    if world.ground.is_touchable(ChunkCoord::containing(point)) {
        f64::from(world.ground.density(point))
    } else {
        f64::INFINITY
    }
}
