//! Aims a shot so that it goes from the muzzle through a given point.

use antipode_geometry::{BodyFrame, ChartPoint, Strategy};
use glam::DVec3;

use crate::tuning::STEP_S;

/// Rounds in which the elevation is mended where lengths differ with the height; three suffice within thirty metres.
const ROUNDS: usize = 6;
/// A shot that passes this near (m) is good.
const NEAR_M: f64 = 0.001;
/// Longest flight (s) that is looked at.
const LONGEST_S: f64 = 3.0;

/// The velocity in m/s, of length `speed_m_s`, with which a ball that falls at `gravity_m_s2` leaves `from` to go
/// through `to`. Where it cannot reach that far it goes straight at it.
///
/// A flight keeps to the shortest level way. The lower of the two arcs solves `g x^2 t^2 - 2 v^2 x t + g x^2 + 2 v^2 y = 0` for
/// the tangent t of the elevation, x being the level distance and y the rise. Where a level metre is another one higher up, what
/// that shot passes over or under its target is aimed lower or higher, until it goes through.
pub fn aim(
    strategy: &dyn Strategy,
    from: ChartPoint,
    to: ChartPoint,
    speed_m_s: f64,
    gravity_m_s2: f64,
) -> DVec3 {
    let way = BodyFrame::way(strategy, from, to);
    let first = lower_arc(way, speed_m_s, gravity_m_s2);
    let Some(frame) = BodyFrame::of(strategy, from) else {
        return first;
    };
    let mut aimed = way;
    for _ in 0..ROUNDS {
        let velocity = lower_arc(aimed, speed_m_s, gravity_m_s2);
        let passes = passes_over_m(&frame, velocity, way, gravity_m_s2);
        let Some(over_m) = passes.filter(|it| it.abs() > NEAR_M) else {
            break;
        };
        aimed.y -= over_m;
    }
    lower_arc(aimed, speed_m_s, gravity_m_s2)
}

/// How far a shot passes over a target, metres, by the steps in which it will fly; none if it does not come so far.
fn passes_over_m(
    frame: &BodyFrame<'_>,
    velocity: DVec3,
    target: DVec3,
    gravity_m_s2: f64,
) -> Option<f64> {
    let level = velocity.with_y(0.0).length();
    let (mut gone_m, mut y, mut rise_m_s) = (0.0, 0.0, velocity.y);
    let goal_m = target.with_y(0.0).length();
    for _ in 0..(LONGEST_S / STEP_S) as usize {
        let step_m = level * STEP_S * frame.level_share(y);
        let up_m = (rise_m_s - 0.5 * gravity_m_s2 * STEP_S) * STEP_S;
        if gone_m + step_m >= goal_m {
            let share = if step_m > 0.0 {
                (goal_m - gone_m) / step_m
            } else {
                0.0
            };
            return Some(y + up_m * share - target.y);
        }
        gone_m += step_m;
        y += up_m;
        rise_m_s -= gravity_m_s2 * STEP_S;
    }
    None
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

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};
    use antipode_physics::{Ball, PhysicsWorld};
    use proptest::{prop_assert, proptest};

    use super::*;

    const SPEED_M_S: f64 = 40.0;
    const GRAVITY_M_S2: f64 = 9.81;

    /// The least distance (m) between a shot's flight and its target.
    fn passes(space: &dyn Strategy, from: ChartPoint, to: ChartPoint) -> f64 {
        let velocity = aim(space, from, to, SPEED_M_S, GRAVITY_M_S2);
        assert!((velocity.length() - SPEED_M_S).abs() < 1e-9);
        let nothing = PhysicsWorld::new();
        let (mut at, mut velocity) = (from, velocity);
        let mut nearest_m = f64::INFINITY;
        for _ in 0..180 {
            let mut ball = Ball {
                centre: at.pos,
                velocity,
            };
            let ground = nothing.for_bodies(space, at.chart);
            ground.fall(&mut ball, GRAVITY_M_S2, STEP_S);
            let next = ChartPoint::new(at.chart, ball.centre);
            let [way, there] = [next, to].map(|it| BodyFrame::way(space, at, it));
            let share = (there.dot(way) / way.length_squared()).clamp(0.0, 1.0);
            nearest_m = nearest_m.min(there.distance(way * share));
            (at, velocity) = (next, ball.velocity);
            if let Some(crossing) = space.cross(at) {
                (at, velocity) = (crossing.point, crossing.turn_vector(velocity));
            }
        }
        nearest_m
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

        /// Anywhere on a sphere, over the equator too.
        #[test]
        fn on_a_sphere_too(
            around in 0.0f64..std::f64::consts::TAU, far in 0.0f64..1.0, yaw in 0.0f64..std::f64::consts::TAU,
            radius_m in 16.0f64..200.0, level in 2.0f64..27.0, rise in -3.0f64..3.0,
        ) {
            let space = strategy(Geometry::Spherical, radius_m);
            let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap_or(0.0);
            let level_m = far * rim_m;
            let from = ChartPoint::a(DVec3::new(level_m * around.cos(), 0.3 * radius_m, level_m * around.sin()));
            let way = DVec3::new(yaw.cos(), 0.0, yaw.sin()) * level;
            let to = BodyFrame::step(&*space, from, way.with_y(rise)).point;
            let to = space.cross(to).map_or(to, |it| it.point);
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
