//! The gun: from the muzzle to what the crosshair covers.

use antipode_geometry::{ChartPoint, ChunkCoord, Eye};
use glam::DVec3;

use crate::actions::Actions;
use crate::actors::ActorId;
use crate::aim::aim;
use crate::aimed::Optics;
use crate::item::Item;
use crate::notice::Hint;
use crate::npc::Event;
use crate::pick::{Pick, pick_among};
use crate::projectile::{self, Air, Projectile, Standing};
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::{AIM_REACH_M, BULLET, BULLET_SPEED_M_S, MUZZLE_M, SHOT_EVERY_S, STEP_S};

/// The share of the way to the muzzle that is left when a wall is nearer.
const SHORT_OF_WALL: f64 = 0.9;
/// A bullet so far below the lowest ground, in metres, has missed what was solid and is gone.
const DEEPEST_HOLE_M: f64 = 256.0;

impl Scene {
    /// Bullets in flight, the oldest first.
    pub fn projectiles(&self) -> Vec<(ActorId, Projectile)> {
        self.actors.all()
    }

    /// Puts a bullet in flight that nobody's gun has fired: it harms everyone but the player, as the player's own do at
    /// first. `point` is its middle, `velocity` in metres a second of the chart.
    pub fn throw_bullet(&mut self, point: ChartPoint, velocity: DVec3) {
        let by = self.actors.player;
        projectile::fire(&mut self.actors, point, velocity, by);
    }

    /// Whether bullets follow the space's geodesics instead of falling in its chart.
    pub fn set_straight_shots(&mut self, straight: bool) {
        self.player.straight_shots = straight;
    }

    /// Whether bullets follow the space's geodesics.
    pub fn straight_shots(&self) -> bool {
        self.player.straight_shots
    }

    /// Fires when the button goes down with the gun in hand, if there is a bullet.
    pub(crate) fn use_gun(&mut self, actions: &Actions) {
        self.player.gun_rests_s = (self.player.gun_rests_s - STEP_S).max(0.0);
        let pulled = actions.primary && !self.player.primary_before;
        if !pulled
            || self.player.gun_rests_s > 0.0
            || self.player.inventory.held() != Some(Item::Gun)
        {
            return;
        }
        self.player.gun_rests_s = SHOT_EVERY_S;
        if !self.player.inventory.spend(Item::Bullet) {
            self.outbox.hints.push(Hint::NoBullets);
            self.outbox.sounds.push(SoundEvent::Clicked);
            return;
        }
        self.outbox.sounds.push(SoundEvent::Shot);
        self.actors.npcs.events.push(Event::Shot(self.feet()));
        self.player.condition.spared_s = 0.0;
        self.shown.hand.fire();
        let target = self.covered(AIM_REACH_M).point;
        let muzzle = self.muzzle();
        let by = self.actors.player;
        let optics = self.aiming();
        if optics.straight_shots {
            let eye = Eye {
                point: muzzle,
                dial: optics.dial,
                lift_m: self.head().lift_m + muzzle.pos.y - self.head().point.pos.y,
                ..self.head()
            };
            let pictured = &*optics.strategy;
            let actors = &mut self.actors;
            projectile::fire_straight(actors, pictured, eye, target, BULLET_SPEED_M_S, by);
        } else {
            let velocity = aim(
                &*self.world.strategy,
                muzzle,
                target,
                BULLET_SPEED_M_S,
                BULLET.gravity_m_s2,
            );
            projectile::fire(&mut self.actors, muzzle, velocity, by);
        }
    }

    /// Moves the bullets by one step.
    pub(crate) fn step_projectiles(&mut self) {
        if self.actors.count::<Projectile>() == 0 {
            return;
        }
        let standing = self.standing();
        let lowest_m = self.world.ground.height_range_m().0 - DEEPEST_HOLE_M;
        // More bullets than ground is made solid for end where the land is, as those beyond where bodies move do.
        let in_far_ground = |point: ChartPoint| {
            let coord = ChunkCoord::containing(point);
            let is_bare = !self.world.lets_move(coord) || !self.world.ground.is_touchable(coord);
            point.pos.y < lowest_m || is_bare && self.world.ground.untouched_density(point) < 0.0
        };
        let optics = self.aiming();
        let air = Air {
            strategy: &*self.world.strategy,
            pictured: &*optics.strategy,
            physics: &self.world.physics,
            standing: &standing,
            vehicles: self.actors.cars.vehicles(),
            in_far_ground: &in_far_ground,
        };
        let hits = projectile::step(&mut self.actors.ecs, &air);
        self.take_strikes(hits.strikes);
        self.take_knocks(&hits.knocks);
    }

    /// What the crosshair covers, of the ground and of others, within `reach_m` metres beyond the head.
    pub(crate) fn covered(&self, reach_m: f64) -> Pick {
        self.covered_through(&self.aiming(), reach_m)
    }

    /// What the crosshair covers for who looks through that.
    pub(crate) fn covered_through(&self, optics: &Optics, reach_m: f64) -> Pick {
        let strategy = &*optics.strategy;
        let eye = self.camera_through(optics).eye;
        let past_head_m = self.past_head_m(optics, &eye);
        let others: Vec<Standing> = self
            .standing()
            .into_iter()
            .filter(|it| it.entity != self.actors.player)
            .collect();
        let meets = |a: ChartPoint, b: ChartPoint| {
            let origin = self.world.strategy.chart_origin_m(a.hemisphere);
            others
                .iter()
                .filter_map(|it| {
                    antipode_physics::meets_capsule(
                        a.pos + origin,
                        b.pos + origin,
                        0.0,
                        it.feet,
                        it.height_m,
                        it.radius_m,
                    )
                })
                .reduce(f64::min)
        };
        pick_among(
            strategy,
            &self.world.physics,
            &meets,
            &eye,
            past_head_m,
            reach_m,
        )
    }

    /// The gun's muzzle; short of a wall that one stands close to.
    pub(crate) fn muzzle(&self) -> ChartPoint {
        self.muzzle_of(&self.head())
    }

    /// The muzzle of a gun held by someone with that eye.
    pub(crate) fn muzzle_of(&self, head: &Eye) -> ChartPoint {
        let (right, up, ahead) = MUZZLE_M;
        let way = head.right() * right + head.up() * up + head.front() * ahead;
        let from = head.point.pos + self.world.strategy.chart_origin_m(head.point.hemisphere);
        let length_m = way.length();
        let free = self
            .world
            .physics
            .cast_sphere(from, way, BULLET.radius_m, length_m)
            .map_or(1.0, |free_m| SHORT_OF_WALL * free_m / length_m);
        let muzzle = head.point.moved(way * free);
        self.world
            .strategy
            .cross(muzzle)
            .map_or(muzzle, |crossing| crossing.point)
    }
}
