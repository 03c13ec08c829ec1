//! Bullets in flight. They fall or follow the space's geodesics, bounce off the ground and damage the bodies that they
//! strike. A bullet disappears some time after it has met something. A falling one meets ground sooner or later, even
//! where none is loaded, and one that follows a geodesic disappears after a certain distance.

use antipode_geometry::{
    Atlas, BodyFrame, ChartId, ChartPoint, Crossing, Doorway, Eye, Map, Strategy,
};
use antipode_physics::{Ball, BallTuning, PhysicsWorld, Touch, VehiclePart, meets_capsule};
use glam::DVec3;
use hecs::Entity;

use crate::actors::{ActorId, Actors, retain};
use crate::car::tuning::BULLET_BACK;
use crate::pick::over;
use crate::tuning::{
    BULLET, BULLET_DAMAGES_FROM_M_S, BULLET_LIES_BELOW_M_S, BULLET_LIES_S, BULLET_STRAIGHT_M,
    MOST_BULLETS, SAME_BODY_DAMAGED_AFTER_S, STEP_S,
};

/// Who or what is written in a chart reaches no farther out of its domain than this, metres: a body that has not crossed
/// yet, or half of a car.
const BEYOND_EDGE_M: f64 = 3.0;

/// What keeps a bullet on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Path {
    /// It falls along the parabola over the level.
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
    /// Where its centre is.
    pub point: ChartPoint,
    /// Its velocity, m/s along the axes of its chart's frame.
    pub velocity: DVec3,
    /// How long ago it was fired, seconds.
    pub age_s: f64,
    /// How long it has lain still, seconds.
    lies_s: f64,
    path: Path,
    /// The shooter.
    by: Entity,
    /// Whom it has struck last, and when.
    struck: Option<(Entity, f64)>,
}

/// One who can be struck, where it stands.
pub(crate) struct Standing {
    pub entity: Entity,
    pub feet: ChartPoint,
    pub height_m: f64,
    pub radius_m: f64,
}

/// A bullet has struck someone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Strike {
    pub entity: Entity,
    pub by: Entity,
    /// The way it flew, in the chart of the body that it struck.
    pub way: DVec3,
}

/// A bullet has struck a car.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Knock {
    pub car: ActorId,
    /// Where, in the chart of the car.
    pub at: DVec3,
    /// How fast the bullet was, m/s, in that chart.
    pub velocity: DVec3,
}

/// What bullets fly through.
pub(crate) struct Air<'a> {
    pub strategy: &'a dyn Strategy,
    /// The space as it is seen, whose geodesics are followed.
    pub pictured: &'a dyn Map,
    pub physics: &'a PhysicsWorld,
    pub standing: &'a [Standing],
    /// What of cars is where.
    pub cars: &'a [(ActorId, VehiclePart)],
    /// Whether a point is in ground that is not there to be touched: too far off to be loaded, or below all ground.
    pub in_far_ground: &'a dyn Fn(ChartPoint) -> bool,
    /// The pair of doors, if there is one.
    pub doors: Option<&'a Doorway>,
}

/// What bullets did in a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Hits {
    pub strikes: Vec<Strike>,
    pub knocks: Vec<Knock>,
    /// Where bullets struck the ground first, its normal, and how fast they were into it, m/s.
    pub grounds: Vec<(ChartPoint, DVec3, f64)>,
}

/// Fires a bullet that falls. The oldest makes room when there are too many.
pub(crate) fn fire(actors: &mut Actors, point: ChartPoint, velocity: DVec3, by: Entity) {
    add(actors, point, velocity, Path::Falls, by);
}

/// Fires a bullet along the geodesic from the point of `eye` to `target`.
pub(crate) fn fire_straight(
    actors: &mut Actors,
    pictured: &dyn Map,
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
    add(actors, eye.point, velocity, path, by);
}

fn add(actors: &mut Actors, point: ChartPoint, velocity: DVec3, path: Path, by: Entity) {
    let flying = actors.all::<Projectile>();
    if let Some((oldest, _)) = flying.first().filter(|_| flying.len() >= MOST_BULLETS) {
        actors.remove::<Projectile>(*oldest);
    }
    actors.enter(Projectile {
        point,
        velocity,
        age_s: 0.0,
        lies_s: 0.0,
        path,
        by,
        struck: None,
    });
}

/// Moves every bullet by one step. Returns who and what was struck.
pub(crate) fn step(ecs: &mut hecs::World, air: &Air<'_>) -> Hits {
    let mut hits = Hits::default();
    retain::<Projectile>(ecs, |bullet| {
        bullet.age_s += STEP_S;
        bullet.fly(air, &mut hits) && bullet.lies_s < BULLET_LIES_S
    });
    hits
}

impl Projectile {
    /// Moves it by one step; returns whether it is still in the world.
    fn fly(&mut self, air: &Air<'_>, hits: &mut Hits) -> bool {
        let dt_s = self.go_through(air);
        let before = self.point;
        let (mut ball, goal) = self.start(air, before.pos, dt_s);
        let gravity_m_s2 = if goal.is_some() {
            0.0
        } else {
            BULLET.gravity_m_s2
        };
        let tuning = BallTuning {
            gravity_m_s2,
            ..BULLET
        };
        let ground = air.physics.for_bodies(air.strategy, before.chart);
        let touch = ground.throw_ball(&mut ball, &tuning, dt_s).touch;
        if let Some(touch) = touch.filter(|touch| touch.speed_m_s >= BULLET_DAMAGES_FROM_M_S) {
            let at = ChartPoint::new(before.chart, touch.centre);
            hits.grounds.push((at, touch.normal, touch.speed_m_s));
        }
        let is_still = ball.velocity.length() < BULLET_LIES_BELOW_M_S;
        self.lies_s = if is_still { self.lies_s + STEP_S } else { 0.0 };
        let corner = touch.map_or(ball.centre, |touch| touch.centre);
        self.hit(air, [before.pos, corner], &mut ball, hits);
        match (goal, touch) {
            (Some(goal), None) if self.is_geodesic() => self.point = goal,
            _ => self.follow(air, ball, touch),
        }
        self.cross(air.strategy);
        let limits = air.strategy.limits();
        self.point.pos.is_finite()
            && limits.is_none_or(|limits| self.point.pos.y >= limits.bedrock_m)
            && !(air.in_far_ground)(self.point)
            && !self.has_gone_far()
    }

    /// Goes through a door if this step leads into one before it meets anything else; returns what is left of the step, seconds.
    fn go_through(&mut self, air: &Air<'_>) -> f64 {
        let (before, path) = (self.point, self.path);
        let (ball, goal) = self.start(air, before.pos, STEP_S);
        self.path = path;
        let end = goal.unwrap_or_else(|| {
            let mut fallen = ball;
            let ground = air.physics.for_bodies(air.strategy, before.chart);
            ground.fall(&mut fallen, BULLET.gravity_m_s2, STEP_S);
            ChartPoint::new(before.chart, fallen.centre)
        });
        let met = air.doors.and_then(|doors| {
            let by = doors.met(air.strategy, before, end)?;
            Some((doors, by))
        });
        let Some((doors, by)) = met else {
            return STEP_S;
        };
        let end = over(air.strategy, before, end).pos;
        let sill = before.pos.lerp(end, by.share);
        let ways = ways(air.strategy, before, sill);
        let way = sill - before.pos;
        let ground = air.physics.chart(before.chart);
        let is_stopped = self.meets(air, &ways).is_some()
            || meets_car(air, &ways).is_some()
            || ground.cast_ray(before.pos, way, way.length()).is_some();
        let out = doors.pass(air.strategy, by, ChartPoint::new(before.chart, sill));
        let Some(out) = out.filter(|_| !is_stopped) else {
            return STEP_S;
        };
        let gone_s = by.share * STEP_S;
        if let Path::Geodesic {
            eye,
            gone_m,
            speed_m_s,
            ..
        } = &mut self.path
        {
            *eye = doors.eye(air.pictured, by.leaf, eye);
            *gone_m += *speed_m_s * gone_s;
        } else {
            self.velocity.y -= BULLET.gravity_m_s2 * gone_s;
        }
        self.velocity = out.turn_vector(self.velocity);
        self.point = out.point;
        STEP_S - gone_s
    }

    /// Strikes who or what is first in its way from a place over a corner to where the ball has come, and falls there.
    fn hit(
        &mut self,
        air: &Air<'_>,
        [before, corner]: [DVec3; 2],
        ball: &mut Ball,
        hits: &mut Hits,
    ) {
        for (from, to) in [(before, corner), (corner, ball.centre)] {
            let ways = ways(air.strategy, ChartPoint::new(self.point.chart, from), to);
            let someone = self.meets(air, &ways);
            let car = meets_car(air, &ways)
                .filter(|(share, ..)| someone.is_none_or(|(nearer, ..)| *share < nearer));
            if let Some((share, (car, part), way)) = car {
                let velocity = way.crossing.turn_vector(ball.velocity);
                let (at, velocity) = part.taken_home(way.from.lerp(way.to, share), velocity);
                let car = *car;
                hits.knocks.push(Knock { car, at, velocity });
                ball.centre = from;
                ball.velocity *= -BULLET_BACK;
                self.path = Path::Falls;
                break;
            }
            if let Some((_, entity, way)) = someone {
                self.struck = Some((entity, self.age_s));
                hits.strikes.push(Strike {
                    entity,
                    by: self.by,
                    way: way.crossing.turn_vector(self.velocity),
                });
                // The body stops the bullet, which drops to the ground.
                ball.centre = from;
                ball.velocity *= -0.1;
                self.path = Path::Falls;
                break;
            }
        }
    }

    fn has_gone_far(&self) -> bool {
        matches!(self.path, Path::Geodesic { gone_m, .. } if gone_m >= BULLET_STRAIGHT_M)
    }

    fn is_geodesic(&self) -> bool {
        matches!(self.path, Path::Geodesic { .. })
    }

    /// The ball to throw in this step, and where the geodesic leads if it follows one.
    fn start(&mut self, air: &Air<'_>, centre: DVec3, dt_s: f64) -> (Ball, Option<ChartPoint>) {
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
        *gone_m += *speed_m_s * dt_s;
        let goal = air.pictured.along(eye, *way, *gone_m);
        let step = BodyFrame::way(air.strategy, self.point, goal);
        self.velocity = step / dt_s.max(1e-6);
        (
            Ball {
                centre,
                velocity: self.velocity,
            },
            Some(goal),
        )
    }

    /// Takes over where a ball has come to; after a touch a geodesic begins anew.
    fn follow(&mut self, air: &Air<'_>, ball: Ball, touch: Option<Touch>) {
        self.point.pos = ball.centre;
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
        let way_on = self.velocity.normalize_or(DVec3::Y) * 1e-3;
        let ahead = self.point.moved(air.strategy.in_chart(self.point, way_on));
        *way = air
            .pictured
            .view_point(eye, ahead)
            .truncate()
            .normalize_or(DVec3::NEG_Z);
        *gone_m = 0.0;
        *speed_m_s *= share;
    }

    fn cross(&mut self, strategy: &dyn Atlas) {
        if let Some(crossing) = strategy.cross(self.point) {
            self.point = crossing.point;
            self.velocity = crossing.turn_vector(self.velocity);
        }
    }

    /// The first whom it meets on a way, with the share of it and the way as that one's chart has it, if that one can be
    /// harmed by it now.
    fn meets<'w>(&self, air: &Air<'_>, ways: &'w [Way]) -> Option<(f64, Entity, &'w Way)> {
        if self.velocity.length() < BULLET_DAMAGES_FROM_M_S {
            return None;
        }
        let may_strike = |entity: Entity| {
            let just_fired = entity == self.by && self.age_s < SAME_BODY_DAMAGED_AFTER_S;
            let just_struck = self.struck.is_some_and(|(last, at_s)| {
                last == entity && self.age_s - at_s < SAME_BODY_DAMAGED_AFTER_S
            });
            !just_fired && !just_struck
        };
        let met = |it: &Standing| {
            let way = within(ways, it.feet.chart)?;
            let share = it.meets(way.from, way.to, BULLET.radius_m)?;
            Some((share, it.entity, way))
        };
        air.standing
            .iter()
            .filter(|it| may_strike(it.entity))
            .filter_map(met)
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

impl Standing {
    /// The share of a way between two places of the chart at which something so wide meets the body.
    pub fn meets(&self, from: DVec3, to: DVec3, radius_m: f64) -> Option<f64> {
        let feet = self.feet.pos;
        meets_capsule(from, to, radius_m, feet, self.height_m, self.radius_m)
    }
}

/// A straight way as a chart has it that it comes near.
pub(crate) struct Way {
    crossing: Crossing,
    pub from: DVec3,
    pub to: DVec3,
}

/// A way in its own chart, and in all others that reach to where it begins: who stands beyond an edge is met there.
pub(crate) fn ways(strategy: &dyn Atlas, from: ChartPoint, to: DVec3) -> Vec<Way> {
    let reach_m = from.pos.distance(to) + BEYOND_EDGE_M;
    let written = |crossing: Crossing| Way {
        from: crossing.point.pos,
        to: crossing.point.pos + crossing.turn_vector(to - from.pos),
        crossing,
    };
    let own = Way {
        crossing: Crossing::within(from),
        from: from.pos,
        to,
    };
    let others = strategy.images(from, reach_m).into_iter().map(written);
    std::iter::once(own).chain(others).collect()
}

/// The way in a chart.
pub(crate) fn within(ways: &[Way], chart: ChartId) -> Option<&Way> {
    ways.iter().find(|way| way.crossing.point.chart == chart)
}

/// The first car that a bullet meets on a way, and what of it, with the share of the way and the way as its chart has it.
fn meets_car<'w>(
    air: &Air<'w>,
    ways: &'w [Way],
) -> Option<(f64, &'w (ActorId, VehiclePart), &'w Way)> {
    let meets = |it: &'w (ActorId, VehiclePart)| {
        let way = within(ways, it.1.motion().chart)?;
        let share = it.1.meets(way.from, way.to, BULLET.radius_m)?;
        Some((share, it, way))
    };
    air.cars
        .iter()
        .filter_map(meets)
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

#[cfg(test)]
mod tests;
