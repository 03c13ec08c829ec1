//! The gun: from the muzzle to what the crosshair covers.

use antipode_geometry::{ChartPoint, ChunkCoord, Eye};
use glam::DVec3;

use crate::actions::Actions;
use crate::aim::aim;
use crate::camera::CameraMode;
use crate::item::Item;
use crate::notice::Hint;
use crate::npc::Event;
use crate::pick::{Pick, pick_among};
use crate::projectile::{Air, Projectile, Standing};
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::{AIM_REACH_M, BULLET, BULLET_SPEED_M_S, MUZZLE_M, SHOT_EVERY_S, STEP_S};

/// The share of the way to the muzzle that is left when a wall is nearer.
const SHORT_OF_WALL: f64 = 0.9;
/// A bullet so far below the lowest ground, in metres, has missed what was solid and is gone.
const DEEPEST_HOLE_M: f64 = 256.0;

impl Scene {
    /// Bullets in flight, the oldest first.
    pub fn projectiles(&self) -> &[Projectile] {
        self.projectiles.all()
    }

    /// Puts a bullet in flight that nobody's gun has fired: it harms everyone but the player, as the player's own do at
    /// first. `point` is its middle, `velocity` in metres a second of the chart.
    pub fn throw_bullet(&mut self, point: ChartPoint, velocity: DVec3) {
        self.projectiles.fire(point, velocity, self.player);
    }

    /// Whether bullets follow the space's geodesics instead of falling in its chart.
    pub fn set_straight_shots(&mut self, straight: bool) {
        self.straight_shots = straight;
    }

    /// Whether bullets follow the space's geodesics.
    pub fn straight_shots(&self) -> bool {
        self.straight_shots
    }

    /// Fires when the button goes down with the gun in hand, if there is a bullet.
    pub(crate) fn use_gun(&mut self, actions: &Actions) {
        self.gun_rests_s = (self.gun_rests_s - STEP_S).max(0.0);
        let pulled = actions.primary && !self.primary_before;
        if !pulled || self.gun_rests_s > 0.0 || self.inventory.held() != Some(Item::Gun) {
            return;
        }
        self.gun_rests_s = SHOT_EVERY_S;
        if !self.inventory.spend(Item::Bullet) {
            self.hints.push(Hint::NoBullets);
            self.sounds.push(SoundEvent::Clicked);
            return;
        }
        self.sounds.push(SoundEvent::Shot);
        self.npcs.events.push(Event::Shot(self.feet()));
        self.condition.spared_s = 0.0;
        self.hand.fire();
        let target = self.covered(AIM_REACH_M).point;
        let muzzle = self.muzzle();
        if self.straight_shots {
            let eye = Eye {
                point: muzzle,
                dial: self.lens.value(),
                lift_m: self.head().lift_m + muzzle.pos.y - self.head().point.pos.y,
                ..self.head()
            };
            let pictured = &**self.lens.strategy();
            self.projectiles
                .fire_straight(pictured, eye, target, BULLET_SPEED_M_S, self.player);
        } else {
            let velocity = aim(
                &*self.strategy,
                muzzle,
                target,
                BULLET_SPEED_M_S,
                BULLET.gravity_m_s2,
            );
            self.projectiles.fire(muzzle, velocity, self.player);
        }
    }

    /// Moves the bullets by one step.
    pub(crate) fn step_projectiles(&mut self) {
        if self.projectiles.all().is_empty() {
            return;
        }
        let standing = self.standing();
        let lowest_m = self.ground.height_range_m().0 - DEEPEST_HOLE_M;
        // More bullets than ground is made solid for end where the land is, as those beyond the view do.
        let in_far_ground = |point: ChartPoint| {
            let coord = ChunkCoord::containing(point);
            let is_bare = !self.streamer.is_wanted(coord) || self.ground.is_only_shown(coord);
            point.pos.y < lowest_m || is_bare && self.ground.untouched_density(point) < 0.0
        };
        let air = Air {
            strategy: &*self.strategy,
            pictured: &**self.lens.strategy(),
            physics: &self.physics,
            standing: &standing,
            vehicles: self.cars.vehicles(),
            in_far_ground: &in_far_ground,
        };
        let hits = self.projectiles.step(&air);
        self.take_strikes(hits.strikes);
        self.take_knocks(&hits.knocks);
    }

    /// What the crosshair covers, of the ground and of others, within `reach_m` metres beyond the head.
    pub(crate) fn covered(&self, reach_m: f64) -> Pick {
        let strategy = &**self.lens.strategy();
        let eye = self.eye();
        let past_head_m = match self.camera {
            CameraMode::First => 0.0,
            CameraMode::Third => strategy.distance_m(eye.point, self.head().point, &eye),
        };
        let others: Vec<Standing> = self
            .standing()
            .into_iter()
            .filter(|it| it.entity != self.player)
            .collect();
        let meets = |a: ChartPoint, b: ChartPoint| {
            let origin = self.strategy.chart_origin_m(a.hemisphere);
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
        pick_among(strategy, &self.physics, &meets, &eye, past_head_m, reach_m)
    }

    /// The gun's muzzle; short of a wall that one stands close to.
    pub(crate) fn muzzle(&self) -> ChartPoint {
        self.muzzle_of(&self.head())
    }

    /// The muzzle of a gun held by someone with that eye.
    pub(crate) fn muzzle_of(&self, head: &Eye) -> ChartPoint {
        let (right, up, ahead) = MUZZLE_M;
        let way = head.right() * right + head.up() * up + head.front() * ahead;
        let from = head.point.pos + self.strategy.chart_origin_m(head.point.hemisphere);
        let length_m = way.length();
        let free = self
            .physics
            .cast_sphere(from, way, BULLET.radius_m, length_m)
            .map_or(1.0, |free_m| SHORT_OF_WALL * free_m / length_m);
        let muzzle = head.point.moved(way * free);
        self.strategy
            .cross(muzzle)
            .map_or(muzzle, |crossing| crossing.point)
    }
}
