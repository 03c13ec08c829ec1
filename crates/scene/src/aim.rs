//! Aims a shot so that it goes from the muzzle through a given point.

use antipode_geometry::{ChartPoint, Strategy};
use antipode_physics::Ball;
use glam::{DVec2, DVec3};

use crate::pick::over;
use crate::tuning::STEP_S;

/// Rounds of Newton's method over the equator; three suffice where the first guess is near.
const ROUNDS: usize = 12;
/// A shot that passes this near (m) is good.
const NEAR_M: f64 = 0.005;
/// By how much (rad) a direction is turned to see how the miss changes.
const NUDGE_RAD: f64 = 1e-4;
/// Largest turn (rad) of one round.
const LARGEST_TURN_RAD: f64 = 0.3;
/// Longest flight (s) that is looked at.
const LONGEST_S: f64 = 3.0;

/// The velocity in m/s, of length `speed_m_s`, with which a ball that falls at `gravity_m_s2` leaves `from` to go
/// through `to`. Where it cannot reach that far it goes straight at it.
///
/// Within one chart the lower of the two arcs solves `g x^2 t^2 - 2 v^2 x t + g x^2 + 2 v^2 y = 0` for the tangent t of
/// the elevation, x being the level distance and y the rise. Over the equator the arc continues in the other chart;
/// the solution of the chart it began in is mended by Newton's method on the miss.
pub fn aim(
    strategy: &dyn Strategy,
    from: ChartPoint,
    to: ChartPoint,
    speed_m_s: f64,
    gravity_m_s2: f64,
) -> DVec3 {
    let way = over(strategy, from, to).pos - from.pos;
    let first = lower_arc(way, speed_m_s, gravity_m_s2);
    if from.chart == to.chart {
        return first;
    }
    let shot = Shot {
        strategy,
        from,
        to,
        gravity_m_s2,
    };
    shot.mend(first)
}

fn lower_arc(way: DVec3, speed_m_s: f64, gravity_m_s2: f64) -> DVec3 {
    let level = DVec3::new(way.x, 0.0, way.z);
    let (x, y, v2) = (level.length(), way.y, speed_m_s * speed_m_s);
    let straight = way.normalize_or(DVec3::Y) * speed_m_s;
    let under_root = v2 * v2 - gravity_m_s2 * (gravity_m_s2 * x * x + 2.0 * y * v2);
    if x < 1e-6 || under_root < 0.0 || gravity_m_s2 <= 0.0 {
        return straight;
    }
    // (v^2 - root) / (g x), without the difference of two numbers that are nearly the same.
    let tangent = (gravity_m_s2 * x * x + 2.0 * y * v2) / (x * (v2 + under_root.sqrt()));
    (level / x + DVec3::Y * tangent).normalize() * speed_m_s
}

/// A shot over the equator.
struct Shot<'a> {
    strategy: &'a dyn Strategy,
    from: ChartPoint,
    to: ChartPoint,
    gravity_m_s2: f64,
}

impl Shot<'_> {
    fn mend(&self, first: DVec3) -> DVec3 {
        let mut best = (f64::INFINITY, first);
        let mut velocity = first;
        for _ in 0..ROUNDS {
            let miss = self.miss(velocity);
            if miss.length() < best.0 {
                best = (miss.length(), velocity);
            }
            if miss.length() < NEAR_M {
                break;
            }
            let right = velocity.cross(DVec3::Y).normalize_or(DVec3::X);
            let up = right.cross(velocity).normalize();
            let speed = velocity.length();
            let turned = |turn: DVec2| {
                (velocity + (right * turn.x + up * turn.y) * speed).normalize() * speed
            };
            let by_right = (self.miss(turned(DVec2::X * NUDGE_RAD)) - miss) / NUDGE_RAD;
            let by_up = (self.miss(turned(DVec2::Y * NUDGE_RAD)) - miss) / NUDGE_RAD;
            let determinant = by_right.perp_dot(by_up);
            if determinant.abs() < 1e-9 {
                break;
            }
            let turn = DVec2::new(-miss.perp_dot(by_up), -by_right.perp_dot(miss)) / determinant;
            velocity = turned(turn.clamp_length_max(LARGEST_TURN_RAD));
        }
        best.1
    }

    /// How far (m) the flight passes from the target, across its way and upwards.
    fn miss(&self, velocity: DVec3) -> DVec2 {
        let mut point = self.from;
        let mut ball = Ball {
            centre: point.pos,
            velocity,
        };
        let mut nearest = (f64::INFINITY, DVec2::ZERO);
        for _ in 0..(LONGEST_S / STEP_S) as usize {
            let after = ball.fallen(self.gravity_m_s2, STEP_S);
            let target = over(self.strategy, point, self.to).pos;
            let way = after.centre - ball.centre;
            let share = ((target - ball.centre).dot(way) / way.length_squared()).clamp(0.0, 1.0);
            let off = ball.centre + way * share - target;
            if off.length() < nearest.0 {
                let across = way.cross(DVec3::Y).normalize_or(DVec3::X);
                let up = across.cross(way).normalize_or(DVec3::Y);
                nearest = (off.length(), DVec2::new(off.dot(across), off.dot(up)));
            }
            ball = after;
            point.pos = ball.centre;
            if let Some(crossing) = self.strategy.cross(point) {
                point = crossing.point;
                ball = Ball {
                    centre: point.pos,
                    velocity: crossing.turn_vector(ball.velocity),
                };
            }
        }
        nearest.1
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};
    use proptest::{prop_assert, proptest};

    use super::*;

    const SPEED_M_S: f64 = 40.0;
    const GRAVITY_M_S2: f64 = 9.81;

    /// The least distance (m) between a shot's flight and its target.
    fn passes(space: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> f64 {
        let velocity = aim(space, from, to, SPEED_M_S, GRAVITY_M_S2);
        assert!((velocity.length() - SPEED_M_S).abs() < 1e-9);
        let shot = Shot {
            strategy: space,
            from,
            to,
            gravity_m_s2: GRAVITY_M_S2,
        };
        shot.miss(velocity).length()
    }

    proptest! {
        #[test]
        fn a_shot_within_thirty_metres_goes_through_what_was_aimed_at(
            yaw in 0.0f64..std::f64::consts::TAU, rise in -12.0f64..12.0, level in 2.0f64..27.0,
        ) {
            let space = strategy(Geometry::Euclidean, 0.0);
            let from = ChartPoint::a(DVec3::new(100.0, 20.0, -7.0));
            let to = from.moved(DVec3::new(level * yaw.cos(), rise, level * yaw.sin()));
            prop_assert!(passes(&*space, from, to) < 0.02, "{}", passes(&*space, from, to));
        }

        #[test]
        fn over_the_equator_too(
            around in 0.0f64..std::f64::consts::TAU, aside in -0.5f64..0.5, radius_m in 24.0f64..200.0,
            before in 0.5f64..12.0, beyond in 0.5f64..12.0, rise in -3.0f64..3.0,
        ) {
            let space = strategy(Geometry::Spherical, radius_m);
            let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap_or(0.0);
            let height_m = 0.3 * radius_m;
            let at = |chart, angle: f64, level_m: f64, y: f64| {
                ChartPoint::new(chart, DVec3::new(level_m * angle.cos(), y, level_m * angle.sin()))
            };
            let from = at(ChartId::FIRST, around, rim_m - before, height_m);
            // The same place of the equator is at the mirrored angle in the other chart.
            let turned = std::f64::consts::PI - around - aside * 10.0 / rim_m;
            let to = at(ChartId::SECOND, turned, rim_m - beyond, height_m + rise);
            prop_assert!(passes(&*space, from, to) < 0.02, "{}", passes(&*space, from, to));
        }
    }

    #[test]
    fn what_is_too_far_is_aimed_at_straight_and_nothing_is_no_number() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let from = ChartPoint::a(DVec3::ZERO);
        let far = aim(
            &*space,
            from,
            ChartPoint::a(DVec3::X * 1e4),
            SPEED_M_S,
            GRAVITY_M_S2,
        );
        assert!((far - DVec3::X * SPEED_M_S).length() < 1e-9);
        for to in [
            from,
            from.moved(DVec3::Y * 5.0),
            from.moved(DVec3::NEG_Y * 5.0),
        ] {
            assert!(aim(&*space, from, to, SPEED_M_S, GRAVITY_M_S2).is_finite());
        }
    }
}
