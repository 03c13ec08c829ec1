//! A small ball thrown through the terrain: it falls, bounces and slides; and the first of many upright capsules that
//! its way meets.

use glam::DVec3;
use rapier3d::math::Pose;
use rapier3d::parry::query::details::ShapeCastOptions;
use rapier3d::parry::query::{DefaultQueryDispatcher, QueryDispatcher, Ray, RayCast, ShapeCastHit};
use rapier3d::parry::shape::{Ball as BallShape, Capsule as CapsuleShape};

use crate::body_ground::{arrival, turned};
use crate::{BodyGround, ChartGround};

/// A ball stays this far (m) off what it has touched, so that the next cast does not begin in it.
const SKIN_M: f64 = 1e-3;
/// Touches followed within one move; what is left of the move after them is given up.
const MOST_TOUCHES: usize = 4;

/// How a ball moves.
#[derive(Clone, Debug, PartialEq)]
pub struct BallTuning {
    /// Its radius.
    pub radius_m: f64,
    /// Downward acceleration; zero flies straight.
    pub gravity_m_s2: f64,
    /// Share of the speed into the ground that comes back out of it, 0 to 1.
    pub bounce: f64,
    /// Share of the speed along the ground that a touch leaves, 0 to 1.
    pub slide: f64,
}

/// A ball in a chart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// Its centre, metres of the chart.
    pub centre: DVec3,
    /// Its velocity (m/s of the space, along the axes of the chart's frame there).
    pub velocity: DVec3,
}

/// A touch of the terrain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Where the ball's centre was, metres of the chart.
    pub centre: DVec3,
    /// Unit normal of the ground, towards the ball, along the axes of the chart's frame there.
    pub normal: DVec3,
    /// Speed into the ground (m/s).
    pub speed_m_s: f64,
}

/// What a ball did in a move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thrown {
    /// The first touch.
    pub touch: Option<Touch>,
    /// By how many radians its way has turned in the chart's frames, as the turn of a [`antipode_geometry::Crossing`]: its
    /// velocity has taken it, and what else has a direction is to. 0 where bodies move in the chart.
    pub turn_rad: f64,
}

impl Ball {
    /// Where the ball would be after `dt_s` seconds if nothing were in its way, and how fast.
    /// In a chart in which bodies move.
    #[must_use]
    pub fn fallen(self, gravity_m_s2: f64, dt_s: f64) -> Self {
        let (way, velocity) = self.falls(gravity_m_s2, dt_s);
        Self {
            centre: self.centre + way,
            velocity,
        }
    }

    /// The way that it would make in `dt_s` seconds, and how fast it would be.
    fn falls(self, gravity_m_s2: f64, dt_s: f64) -> (DVec3, DVec3) {
        let fall = DVec3::NEG_Y * gravity_m_s2 * dt_s;
        ((self.velocity + 0.5 * fall) * dt_s, self.velocity + fall)
    }
}

impl BodyGround<'_> {
    /// Moves a ball by `dt_s` seconds of free fall, off all ground in its way.
    ///
    /// Each stretch between touches is followed along the chord of its parabola, which at 1/60 s strays from the arc
    /// by `g dt^2 / 8`, a third of a millimetre; in a chart in which bodies do not move, the chord is straight in it between
    /// its true ends, 1 cm off the true way over a metre and a half where R = 32 m. There the ball is as wide as so many metres
    /// of the chart.
    pub fn throw_ball(&self, ball: &mut Ball, tuning: &BallTuning, dt_s: f64) -> Thrown {
        let mut thrown = Thrown::default();
        let mut left_s = dt_s;
        for _ in 0..MOST_TOUCHES {
            let mut free = *ball;
            let turn_rad = self.fall(&mut free, tuning.gravity_m_s2, left_s);
            let way = free.centre - ball.centre;
            let hit = self.ground.ball_hit(ball.centre, way, tuning.radius_m);
            let Some((share, normal)) = hit else {
                thrown.turn_rad += turn_rad;
                *ball = free;
                return thrown;
            };
            thrown.turn_rad += self.fall(ball, tuning.gravity_m_s2, share * left_s);
            ball.centre += normal * SKIN_M;
            let normal = match self.frame(ball.centre) {
                Some(frame) => frame.normal(normal),
                None => normal,
            };
            let into = -ball.velocity.dot(normal);
            if into > 0.0 {
                let along = ball.velocity + normal * into;
                ball.velocity = along * tuning.slide + normal * (into * tuning.bounce);
            }
            thrown.touch = thrown.touch.or(Some(Touch {
                centre: ball.centre,
                normal,
                speed_m_s: into.max(0.0),
            }));
            left_s *= 1.0 - share;
        }
        thrown
    }

    /// Moves a ball by `dt_s` seconds of free fall through whatever is there; returns by how many radians its way has turned, as
    /// in [`Thrown`].
    pub fn fall(&self, ball: &mut Ball, gravity_m_s2: f64, dt_s: f64) -> f64 {
        let (way, velocity) = ball.falls(gravity_m_s2, dt_s);
        let frame = self.frame(ball.centre);
        let (centre, turn_rad) = arrival(frame.as_ref(), ball.centre, way);
        let velocity = turned(velocity, turn_rad);
        *ball = Ball { centre, velocity };
        turn_rad
    }
}

impl ChartGround {
    /// The share of `way` that a ball can go before it touches terrain, and the terrain's normal there.
    fn ball_hit(&self, centre: DVec3, way: DVec3, radius_m: f64) -> Option<(f64, DVec3)> {
        let length_m = way.length();
        if !(centre.is_finite() && length_m.is_finite() && length_m > 1e-9) {
            return None;
        }
        let options = ShapeCastOptions::with_max_time_of_impact(length_m as f32);
        let ball = BallShape::new(radius_m as f32);
        let ahead = way / length_m;
        let goal = centre + way;
        let (min, max) = (centre.min(goal) - radius_m, centre.max(goal) + radius_m);
        let mut first: Option<ShapeCastHit> = None;
        // Block by block in their order: of two that are met at once, a tree's order of arrival would choose.
        for ground in self.grounds_in(min, max) {
            let from = Pose::from_translation((centre - ground.origin).as_vec3());
            let shape = &*ground.block.shape;
            let hit =
                DefaultQueryDispatcher.cast_shapes(&from, ahead.as_vec3(), shape, &ball, options);
            let is_sooner = |hit: &ShapeCastHit| {
                first.is_none_or(|first| hit.time_of_impact < first.time_of_impact)
            };
            first = hit.ok().flatten().filter(is_sooner).or(first);
        }
        let hit = first?;
        let normal = hit.normal1.as_dvec3().normalize_or(-ahead);
        // The ground has two sides; the ball is on the one that it comes from.
        let normal = if normal.dot(ahead) > 0.0 {
            -normal
        } else {
            normal
        };
        let share = f64::from(hit.time_of_impact) / length_m;
        Some((share.clamp(0.0, 1.0), normal))
    }
}

/// The share of the way from `from` to `to` (m) at which a ball first meets an upright capsule that stands at `feet`;
/// `None` when it passes. A ball that begins inside meets it at once.
///
/// A ball and a capsule meet where the ball's centre meets a capsule that is wider by the ball's radius.
pub fn meets_capsule(
    from: DVec3,
    to: DVec3,
    ball_radius_m: f64,
    feet: DVec3,
    height_m: f64,
    radius_m: f64,
) -> Option<f64> {
    let middle = feet + DVec3::Y * (0.5 * height_m);
    let way = to - from;
    // Most are far away; with hundreds of balls and capsules this is what counts.
    let reach_m = way.length() + (0.5 * height_m).max(radius_m) + ball_radius_m;
    if (from - middle).length_squared() > reach_m * reach_m {
        return None;
    }
    let straight_m = (0.5 * height_m - radius_m).max(0.0);
    let capsule = CapsuleShape::new_y(straight_m as f32, (radius_m + ball_radius_m) as f32);
    if !(way.is_finite() && (from - middle).is_finite()) {
        return None;
    }
    // In the ray's own units a share of 1 is its end.
    let ray = Ray::new((from - middle).as_vec3(), way.as_vec3());
    capsule
        .cast_local_ray(&ray, 1.0, true)
        .map(|share| f64::from(share).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::{ChartId, ChunkCoord};
    use glam::IVec3;

    use super::*;
    use crate::TerrainCollider;

    const TUNING: BallTuning = BallTuning {
        radius_m: 0.1,
        gravity_m_s2: 10.0,
        bounce: 0.5,
        slide: 0.8,
    };

    /// A floor at the height of 4 m.
    fn floor() -> ChartGround {
        let positions = [
            [0.0, 4.0, 0.0],
            [0.0, 4.0, 32.0],
            [32.0, 4.0, 0.0],
            [32.0, 4.0, 32.0],
        ];
        let collider = TerrainCollider::build(&positions, &[[1, 3, 2], [0, 1, 2]]).unwrap();
        let mut world = ChartGround::new();
        let coord = ChunkCoord::new(ChartId::FIRST, IVec3::ZERO);
        world.set_terrain(coord, DVec3::ZERO, Some(collider));
        world
    }

    #[test]
    fn a_ball_falls_by_the_parabola_while_nothing_is_in_its_way() {
        let mut ball = Ball {
            centre: DVec3::new(0.0, 100.0, 0.0),
            velocity: DVec3::new(3.0, 4.0, 0.0),
        };
        let world = ChartGround::new();
        for _ in 0..60 {
            assert_eq!(
                world.in_chart().throw_ball(&mut ball, &TUNING, 1.0 / 60.0),
                Thrown::default()
            );
        }
        assert!((ball.centre - DVec3::new(3.0, 99.0, 0.0)).length() < 1e-9);
        assert!((ball.velocity - DVec3::new(3.0, -6.0, 0.0)).length() < 1e-9);
    }

    #[test]
    fn a_ball_bounces_off_the_floor_loses_speed_and_never_goes_through() {
        let world = floor();
        let mut ball = Ball {
            centre: DVec3::new(8.0, 9.1, 8.0),
            velocity: DVec3::new(1.0, 0.0, 0.0),
        };
        let (mut touches, mut lowest, mut highest_after) = (0, f64::MAX, f64::MIN);
        for _ in 0..600 {
            touches += usize::from(
                world
                    .in_chart()
                    .throw_ball(&mut ball, &TUNING, 1.0 / 60.0)
                    .touch
                    .is_some(),
            );
            lowest = lowest.min(ball.centre.y);
            if touches > 0 {
                highest_after = highest_after.max(ball.centre.y);
            }
        }
        assert!(touches > 3, "{touches}");
        assert!(lowest > 4.09, "{lowest}");
        // Half of the speed comes back, so a quarter of the five metres' height.
        assert!((highest_after - 5.35).abs() < 0.1, "{highest_after}");
        assert!(ball.velocity.x < 0.2, "it comes to rest: {}", ball.velocity);
    }

    #[test]
    fn however_fast_a_ball_is_it_does_not_pass_the_floor() {
        let world = floor();
        let mut ball = Ball {
            centre: DVec3::new(8.0, 30.0, 8.0),
            velocity: DVec3::new(0.0, -4000.0, 0.0),
        };
        let touch = world
            .in_chart()
            .throw_ball(&mut ball, &TUNING, 1.0 / 60.0)
            .touch
            .unwrap();
        assert!((touch.normal - DVec3::Y).length() < 1e-3, "{touch:?}");
        assert!(ball.centre.y > 4.1 && ball.velocity.y > 0.0, "{ball:?}");
    }

    #[test]
    fn a_capsule_is_met_where_its_side_is_and_passed_beside_it() {
        let meets = |z: f64, y: f64| {
            let from = DVec3::new(-5.0, y, z);
            meets_capsule(from, from + DVec3::X * 10.0, 0.1, DVec3::ZERO, 1.8, 0.35)
        };
        let share = meets(0.0, 0.9).unwrap();
        assert!((share - 0.455).abs() < 1e-4, "{share}");
        assert!(meets(0.44, 0.9).is_some() && meets(0.46, 0.9).is_none());
        assert!(meets(0.0, 1.89).is_some() && meets(0.0, 1.91).is_none());
        assert!(meets(0.0, -0.11).is_none());
        let within = meets_capsule(DVec3::Y, DVec3::Y * 1.1, 0.1, DVec3::ZERO, 1.8, 0.35);
        assert_eq!(within, Some(0.0));
    }
}
