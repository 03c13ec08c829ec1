//! The shapes by which things are hit and stand on the ground, as a list to be drawn.

use antipode_geometry::ChartPoint;
use antipode_physics::Character;
use glam::{DQuat, DVec3};
use hecs::Entity;

use crate::camera::CameraMode;
use crate::ground::chunks_near;
use crate::lamp::Lamp;
use crate::player::{Body, Health, Position};
use crate::scene::Scene;
use crate::tuning::{BULLET, DROP, LAMP_TARGET_M};

/// Slower than this a body is at rest, in metres per second.
const RESTS_M_S: f64 = 0.02;
/// A body whose ground within this distance is not there waits for it, in metres.
const GROUND_WITHIN_M: f64 = 2.0;

/// What kind of shape, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HitForm {
    /// An upright capsule, about the middle of its foot.
    Capsule {
        /// From foot to crown, metres; at least twice the radius.
        height_m: f64,
        /// Radius, metres.
        radius_m: f64,
    },
    /// A ball about its middle.
    Ball {
        /// Radius, metres.
        radius_m: f64,
    },
    /// A box about its middle.
    Box {
        /// Half of its sides, metres.
        half_m: DVec3,
    },
}

/// A shape in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitShape {
    /// Kind and size.
    pub form: HitForm,
    /// Where it is.
    pub point: ChartPoint,
    /// How it is turned in the chart.
    pub turn: DQuat,
    /// Whether it moves: what rests, or waits for the ground below it, does not.
    pub awake: bool,
}

impl HitShape {
    fn upright(form: HitForm, point: ChartPoint, awake: bool) -> Self {
        Self {
            form,
            point,
            turn: DQuat::IDENTITY,
            awake,
        }
    }
}

impl Scene {
    /// Everything that can be hit or stands on the ground; in first person without the player's own body, inside of
    /// which one looks.
    pub fn hit_shapes(&self) -> Vec<HitShape> {
        let mut shapes = self.bodies();
        let lamp = |lamp: &Lamp| {
            let form = HitForm::Ball {
                radius_m: LAMP_TARGET_M,
            };
            HitShape::upright(form, lamp.glow(), lamp.falls())
        };
        shapes.extend(self.lamps().iter().map(lamp));
        let ball =
            |radius_m, point, awake| HitShape::upright(HitForm::Ball { radius_m }, point, awake);
        let bullets = self.projectiles().into_iter();
        shapes.extend(bullets.map(|(_, it)| {
            let flies = it.velocity.length() > RESTS_M_S;
            ball(BULLET.radius_m, it.point, flies)
        }));
        let drops = self.drops();
        let drops = drops.iter();
        shapes.extend(drops.map(|it| ball(DROP.radius_m, it.point, it.is_awake(self.feet()))));
        shapes
    }

    /// Everyone alive, in the order in which they came.
    fn bodies(&self) -> Vec<HitShape> {
        let sees_own = self.shown.camera != CameraMode::First && !self.player.flying;
        let mut bodies: Vec<_> = self
            .actors
            .ecs
            .query::<(Entity, &Position, &Body, &Health)>()
            .iter()
            .filter(|(entity, _, _, health)| {
                health.0 > 0.0 && (*entity != self.actors.player || sees_own)
            })
            .map(|(entity, position, body, _)| {
                let is_there = chunks_near(&*self.world.strategy, position.0, GROUND_WITHIN_M)
                    .into_iter()
                    .all(|coord| self.world.is_firm(coord));
                let form = HitForm::Capsule {
                    height_m: self.actors.tuning.height_m,
                    radius_m: self.actors.tuning.radius_m,
                };
                let awake = is_there && moves(&body.0);
                (entity.id(), HitShape::upright(form, position.0, awake))
            })
            .collect();
        bodies.sort_unstable_by_key(|(id, _)| *id);
        bodies.into_iter().map(|(_, shape)| shape).collect()
    }
}

fn moves(body: &Character) -> bool {
    !body.grounded || body.velocity.length() > RESTS_M_S
}
