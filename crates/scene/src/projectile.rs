//! Bullets in flight: they fall or follow the space's geodesics, bounce off the ground, harm whom they strike and are
//! gone after five seconds.

use antipode_geometry::{ChartPoint, Eye, Strategy};
use antipode_physics::{Ball, BallTuning, PhysicsWorld, Touch, Vehicles};
use glam::DVec3;
use hecs::Entity;

use crate::car::tuning::BULLET_BACK;
use crate::pick::over;
use crate::tuning::{
    BULLET, BULLET_HARMS_FROM_M_S, BULLET_LIFE_S, MOST_BULLETS, SAME_BODY_HARMED_AFTER_S, STEP_S,
};

/// What keeps a bullet on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// It falls along the parabola of its chart.
    Falls,
    /// It follows a geodesic of the space as it was seen when the shot was fired.
    Geodesic {
        /// At the start of the geodesic.
        eye: Eye,
        /// Its way there, a unit vector in view coordinates.
        way: DVec3,
        /// How far along it is, metres of the space.
        gone_m: f64,
        /// Metres of the space per second.
        speed_m_s: f64,
    },
}

/// A bullet in flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Projectile {
    /// Its number, never used twice in a session.
    pub id: u32,
    /// Where its centre is.
    pub point: ChartPoint,
    /// Its velocity in its chart, m/s.
    pub velocity: DVec3,
    /// How long it has been flying, seconds.
    pub age_s: f64,
    path: Path,
    /// Who fired it.
    by: Entity,
    /// Whom it has struck last, and when.
    struck: Option<(Entity, f64)>,
}

/// One who can be struck, where it stands in physics space.
pub(crate) struct Standing {
    pub entity: Entity,
    pub feet: DVec3,
    pub height_m: f64,
    pub radius_m: f64,
}

/// A bullet has struck someone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Strike {
    pub entity: Entity,
    pub by: Entity,
    /// The way it flew, in the chart of who was struck.
    pub way: DVec3,
}

/// A bullet has struck a car.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Knock {
    /// The car's number.
    pub car: usize,
    /// Where, in physics space.
    pub at: DVec3,
    /// How fast the bullet was, m/s.
    pub velocity: DVec3,
}

/// What bullets fly through.
pub(crate) struct Air<'a> {
    pub strategy: &'a dyn Strategy,
    /// The space as it is seen, whose geodesics are followed.
    pub pictured: &'a dyn Strategy,
    pub physics: &'a PhysicsWorld,
    pub standing: &'a [Standing],
    pub vehicles: &'a Vehicles,
}

/// What bullets did in a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Hits {
    pub strikes: Vec<Strike>,
    pub knocks: Vec<Knock>,
}

/// All bullets in flight, the oldest first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Projectiles {
    flying: Vec<Projectile>,
    next_id: u32,
}

impl Projectiles {
    /// The oldest first.
    pub fn all(&self) -> &[Projectile] {
        &self.flying
    }

    /// Fires a bullet that falls. The oldest makes room when there are too many.
    pub fn fire(&mut self, point: ChartPoint, velocity: DVec3, by: Entity) {
        self.add(point, velocity, Path::Falls, by);
    }

    /// Fires a bullet along the geodesic from the point of `eye` to `target`.
    pub fn fire_straight(
        &mut self,
        pictured: &dyn Strategy,
        eye: Eye,
        target: ChartPoint,
        speed_m_s: f64,
        by: Entity,
    ) {
        let way = pictured
            .view_point(&eye, target)
            .truncate()
            .normalize_or(DVec3::NEG_Z);
        let velocity = eye.to_chart(way) * speed_m_s;
        let path = Path::Geodesic {
            eye,
            way,
            gone_m: 0.0,
            speed_m_s,
        };
        self.add(eye.point, velocity, path, by);
    }

    fn add(&mut self, point: ChartPoint, velocity: DVec3, path: Path, by: Entity) {
        if self.flying.len() >= MOST_BULLETS {
            self.flying.remove(0);
        }
        self.flying.push(Projectile {
            id: self.next_id,
            point,
            velocity,
            age_s: 0.0,
            path,
            by,
            struck: None,
        });
        self.next_id = self.next_id.wrapping_add(1);
    }

    /// Moves every bullet by one step. Returns who and what was struck.
    pub fn step(&mut self, air: &Air<'_>) -> Hits {
        let mut hits = Hits::default();
        self.flying.retain_mut(|bullet| {
            bullet.age_s += STEP_S;
            bullet.age_s < BULLET_LIFE_S && bullet.fly(air, &mut hits)
        });
        hits
    }
}

impl Projectile {
    /// Moves it by one step; returns whether it is still in the world.
    fn fly(&mut self, air: &Air<'_>, hits: &mut Hits) -> bool {
        let origin = air.strategy.chart_origin_m(self.point.hemisphere);
        let before = self.point.pos + origin;
        let (mut ball, goal) = self.start(air, before);
        let gravity_m_s2 = if goal.is_some() {
            0.0
        } else {
            BULLET.gravity_m_s2
        };
        let tuning = BallTuning {
            gravity_m_s2,
            ..BULLET
        };
        let touch = air.physics.throw_ball(&mut ball, &tuning, STEP_S);
        let corner = touch.map_or(ball.centre, |touch| touch.centre);
        for (from, to) in [(before, corner), (corner, ball.centre)] {
            let someone = self.meets(air, from, to);
            let car = air
                .vehicles
                .meets(from, to, BULLET.radius_m)
                .filter(|(share, _)| someone.is_none_or(|(nearer, _)| *share < nearer));
            if let Some((share, car)) = car {
                hits.knocks.push(Knock {
                    car,
                    at: from.lerp(to, share),
                    velocity: ball.velocity,
                });
                ball.centre = from;
                ball.velocity *= -BULLET_BACK;
                self.path = Path::Falls;
                break;
            }
            if let Some((_, entity)) = someone {
                self.struck = Some((entity, self.age_s));
                hits.strikes.push(Strike {
                    entity,
                    by: self.by,
                    way: self.velocity,
                });
                // Who is struck stops the bullet; it drops to the ground.
                ball.centre = from;
                ball.velocity *= -0.1;
                self.path = Path::Falls;
                break;
            }
        }
        match (goal, touch) {
            (Some(goal), None) if self.is_geodesic() => self.point = goal,
            _ => self.follow(air, ball, origin, touch),
        }
        self.cross(air.strategy);
        let limits = air.strategy.limits();
        self.point.pos.is_finite()
            && limits.is_none_or(|limits| self.point.pos.y >= limits.bedrock_m)
    }

    fn is_geodesic(&self) -> bool {
        matches!(self.path, Path::Geodesic { .. })
    }

    /// The ball to throw in this step, and where the geodesic leads if it follows one.
    fn start(&mut self, air: &Air<'_>, centre: DVec3) -> (Ball, Option<ChartPoint>) {
        let Path::Geodesic {
            eye,
            way,
            gone_m,
            speed_m_s,
        } = &mut self.path
        else {
            let velocity = self.velocity;
            return (Ball { centre, velocity }, None);
        };
        *gone_m += *speed_m_s * STEP_S;
        let goal = air.pictured.along(eye, *way, *gone_m);
        let step = over(air.strategy, self.point, goal).pos - self.point.pos;
        self.velocity = step / STEP_S;
        (
            Ball {
                centre,
                velocity: self.velocity,
            },
            Some(goal),
        )
    }

    /// Takes over where a ball has come to; after a touch a geodesic begins anew.
    fn follow(&mut self, air: &Air<'_>, ball: Ball, origin: DVec3, touch: Option<Touch>) {
        self.point.pos = ball.centre - origin;
        self.velocity = ball.velocity;
        let Path::Geodesic {
            eye,
            way,
            gone_m,
            speed_m_s,
        } = &mut self.path
        else {
            return;
        };
        if touch.is_none() {
            return;
        }
        let share = if self.velocity == DVec3::ZERO {
            0.0
        } else {
            BULLET.bounce.max(BULLET.slide)
        };
        *eye = Eye {
            point: self.point,
            ..*eye
        };
        let ahead = ChartPoint::new(
            self.point.hemisphere,
            self.point.pos + self.velocity.normalize_or(DVec3::Y) * 1e-3,
        );
        *way = air
            .pictured
            .view_point(eye, ahead)
            .truncate()
            .normalize_or(DVec3::NEG_Z);
        *gone_m = 0.0;
        *speed_m_s *= share;
    }

    fn cross(&mut self, strategy: &dyn Strategy) {
        if let Some(crossing) = strategy.cross(self.point) {
            self.point = crossing.point;
            self.velocity = crossing.turn_vector(self.velocity);
        }
    }

    /// The first whom it meets between two points of physics space, and the share of the way to there, if that one can
    /// be harmed by it now.
    fn meets(&self, air: &Air<'_>, from: DVec3, to: DVec3) -> Option<(f64, Entity)> {
        if self.velocity.length() < BULLET_HARMS_FROM_M_S {
            return None;
        }
        let may_strike = |entity: Entity| {
            let just_fired = entity == self.by && self.age_s < SAME_BODY_HARMED_AFTER_S;
            let just_struck = self.struck.is_some_and(|(last, at_s)| {
                last == entity && self.age_s - at_s < SAME_BODY_HARMED_AFTER_S
            });
            !just_fired && !just_struck
        };
        let share = |it: &Standing| {
            antipode_physics::meets_capsule(
                from,
                to,
                BULLET.radius_m,
                it.feet,
                it.height_m,
                it.radius_m,
            )
        };
        air.standing
            .iter()
            .filter(|it| may_strike(it.entity))
            .filter_map(|it| share(it).map(|share| (share, it.entity)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
    use antipode_geometry::{Geometry, Hemisphere, strategy};

    use super::*;

    fn entity(ecs: &mut hecs::World) -> Entity {
        ecs.spawn(())
    }

    fn fly(
        space: &dyn Strategy,
        bullets: &mut Projectiles,
        standing: &[Standing],
        steps: usize,
    ) -> Vec<Strike> {
        let physics = PhysicsWorld::new();
        let vehicles = Vehicles::default();
        let air = Air {
            strategy: space,
            pictured: space,
            physics: &physics,
            standing,
            vehicles: &vehicles,
        };
        (0..steps)
            .flat_map(|_| bullets.step(&air).strikes)
            .collect()
    }

    #[test]
    fn a_bullet_falls_lives_five_seconds_and_room_is_made_for_the_next() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let mut ecs = hecs::World::new();
        let by = entity(&mut ecs);
        let mut bullets = Projectiles::default();
        bullets.fire(ChartPoint::a(DVec3::Y * 500.0), DVec3::X * 40.0, by);
        fly(&*space, &mut bullets, &[], 60);
        let at = bullets.all()[0].point.pos;
        assert!(
            (at - DVec3::new(40.0, 500.0 - 0.5 * BULLET.gravity_m_s2, 0.0)).length() < 1e-6,
            "{at}"
        );
        fly(&*space, &mut bullets, &[], 239);
        assert!(bullets.all().len() == 1);
        fly(&*space, &mut bullets, &[], 2);
        assert!(bullets.all().is_empty());
        for _ in 0..MOST_BULLETS + 7 {
            bullets.fire(ChartPoint::a(DVec3::ZERO), DVec3::ZERO, by);
        }
        assert_eq!(bullets.all().len(), MOST_BULLETS);
        assert_eq!(bullets.all()[0].id, 8);
    }

    #[test]
    fn over_the_equator_a_bullet_keeps_its_way() {
        let space = strategy(Geometry::Spherical, 32.0);
        let mut ecs = hecs::World::new();
        let by = entity(&mut ecs);
        let rim_m = space.rim_m().unwrap();
        let mut bullets = Projectiles::default();
        let start = ChartPoint::a(DVec3::new(rim_m - 2.0, 10.0, 0.0));
        bullets.fire(start, DVec3::new(40.0, 6.0, 0.0), by);
        fly(&*space, &mut bullets, &[], 12);
        let bullet = &bullets.all()[0];
        assert_eq!(bullet.point.hemisphere, Hemisphere::B);
        assert!((bullet.point.pos.x.hypot(bullet.point.pos.z) - (rim_m - 6.0)).abs() < 0.01);
        assert!((bullet.velocity.with_y(0.0).length() - 40.0).abs() < 1e-9);
    }

    #[test]
    fn along_a_geodesic_a_bullet_goes_straight_through_what_was_aimed_at() {
        for geometry in [
            Geometry::Hyperbolic,
            Geometry::Spherical,
            Geometry::Euclidean,
        ] {
            let space = strategy(geometry, 32.0);
            let mut ecs = hecs::World::new();
            let by = entity(&mut ecs);
            let eye = Eye {
                point: ChartPoint::a(DVec3::new(1.0, 12.0, -3.0)),
                dial: 15.0,
                lift_m: 1.62,
                ..Eye::default()
            };
            let target = ChartPoint::a(DVec3::new(16.0, 9.0, 8.0));
            let mut bullets = Projectiles::default();
            bullets.fire_straight(&*space, eye, target, 40.0, by);
            let mut nearest = f64::MAX;
            let mut last = eye.point.pos;
            for _ in 0..60 {
                fly(&*space, &mut bullets, &[], 1);
                // Nothing stops it, and below all ground it is gone.
                let Some(bullet) = bullets.all().first() else {
                    break;
                };
                let at = bullet.point.pos;
                let way = at - last;
                let share = ((target.pos - last).dot(way) / way.length_squared()).clamp(0.0, 1.0);
                nearest = nearest.min((last + way * share).distance(target.pos));
                last = at;
            }
            assert!(nearest < 0.02, "{geometry:?} {nearest}");
        }
    }

    #[test]
    fn who_stands_in_the_way_is_struck_once_and_the_shooter_is_not_at_first() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let mut ecs = hecs::World::new();
        let (by, other) = (entity(&mut ecs), entity(&mut ecs));
        let stands = |entity, x: f64| Standing {
            entity,
            feet: DVec3::new(x, 99.0, 0.0),
            height_m: 1.8,
            radius_m: 0.35,
        };
        let mut bullets = Projectiles::default();
        bullets.fire(ChartPoint::a(DVec3::Y * 100.0), DVec3::X * 40.0, by);
        let strikes = fly(
            &*space,
            &mut bullets,
            &[stands(by, 0.2), stands(other, 12.0)],
            60,
        );
        assert!(
            matches!(strikes[..], [strike] if strike.entity == other && strike.by == by && strike.way.x > 30.0),
            "{strikes:?}"
        );
        assert!(bullets.all()[0].point.pos.x < 12.5, "it drops there");
    }

    #[test]
    fn a_bullet_that_someone_has_stopped_harms_nobody_any_more() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let mut ecs = hecs::World::new();
        let (by, other) = (entity(&mut ecs), entity(&mut ecs));
        let stands = |entity, x: f64| Standing {
            entity,
            feet: DVec3::new(x, 99.0, 0.0),
            height_m: 1.8,
            radius_m: 0.35,
        };
        let near = [stands(by, -0.7), stands(other, 2.3)];
        let mut bullets = Projectiles::default();
        for height_m in [99.6, 100.0, 100.4] {
            bullets.fire(ChartPoint::a(DVec3::Y * height_m), DVec3::X * 40.0, by);
        }
        let strikes = fly(&*space, &mut bullets, &near, 200);
        assert_eq!(strikes.len(), 3, "{strikes:?}");
        assert!(strikes.iter().all(|strike| strike.entity == other));
    }
}
