//! The day of a closed world, where no sky is seen: a sun and a moon go round over the land, so that morning and night
//! sweep round the world.
//!
//! The land of the three-sphere is a shell about the great sphere y = 0, and the free room over it a ball about the
//! pole (0, 1, 0, 0). Each body keeps to one height in that room, on opposite sides of it, and their feet run along a
//! great circle over the centre of A at noon and over that of B at midnight. Distances in the space decide how much
//! light arrives: on the far side light would come together again, as everything does at an antipode, and there would
//! be no night; so it is taken to fade in the haze on its way.

use std::f64::consts::{PI, TAU};

use antipode_geometry::{ChartPoint, Eye, Globe, Map, Metric, Strategy};
use glam::{DVec3, Vec3};

use crate::day::key_shadow;
use crate::frame::{Orbs, Sky};
use crate::tuning::DAY_S;

/// Heights of sun and moon, radii: over the highest land, at 0.5, and within the room below the pole, at 1.57. They
/// differ, so that neither hides the other where one stands overhead and the other beyond it.
const SUN_HEIGHT: f64 = 0.85;
const MOON_HEIGHT: f64 = 1.05;
/// Their size, radii.
const SIZE: f64 = 0.045;
/// Cosines of the distance from the sun, in radii, past which it is night and within which it is full day.
const NIGHT_AND_DAY: [f32; 2] = [-0.08, 0.48];
/// The haze by day, and what is left of it by night.
const DAY_HAZE: Vec3 = Vec3::new(0.50, 0.62, 0.74);
/// As `haze_before` of worlds/closed.wgsl.
const NIGHT_HAZE: Vec3 = Vec3::new(0.055, 0.065, 0.10);
/// So near to a pole of the sun's way, in radians, no moment is noon: the sun goes round at one height.
const TIMELESS: f64 = 0.05;
const SUN_COLOUR: Vec3 = Vec3::new(1.21, 1.13, 1.02);
const MOON_COLOUR: Vec3 = Vec3::new(0.17, 0.22, 0.34);

/// Sky and light at a time of day, as seen by an eye in a closed world.
pub fn sky(time_of_day_s: f64, globe: Globe, strategy: &dyn Strategy, eye: &Eye) -> Sky {
    let radius_m = strategy.radius_m();
    let turn = time_of_day_s.rem_euclid(DAY_S) / (DAY_S / 2.0) * PI;
    let orbs = Orbs {
        sun: globe.over_poles(turn, SUN_HEIGHT * radius_m),
        moon: globe.over_poles(turn + PI, MOON_HEIGHT * radius_m),
        radius_m: SIZE * radius_m,
    };
    let day = daylight(strategy, orbs.sun, eye);
    let haze = DAY_HAZE * NIGHT_HAZE.lerp(Vec3::ONE, day);
    let sun_strength = day * SUN_COLOUR.length();
    let moon_strength = (1.0 - day) * daylight(strategy, orbs.moon, eye) * MOON_COLOUR.length();
    let sun = toward(strategy, eye, orbs.sun);
    let moon = toward(strategy, eye, orbs.moon);
    Sky {
        top: haze.into(),
        horizon: DAY_HAZE.into(),
        glare: [1.0, 0.93, 0.80],
        stars: 1.0 - day,
        sun_direction: sun.into(),
        moon_direction: moon.into(),
        key_direction: if sun_strength >= moon_strength {
            sun
        } else {
            moon
        }
        .into(),
        key_shadow: key_shadow(sun_strength, moon_strength),
        key_colour: SUN_COLOUR.into(),
        moon_colour: MOON_COLOUR.into(),
        ambient_sky: [0.26, 0.32, 0.40],
        ambient_ground: [0.17, 0.16, 0.15],
        dome: false,
        clouds: 0.0,
        drift: 0.0,
        orbs: Some(orbs),
    }
}

/// The time of day at a place, by how far round the poles of its way the sun is from there; none at those poles, where
/// +x and -x meet the equator.
///
/// A body that has turned by t since it was over the equator at -z has its feet at `(0, -cos t, sin t)` of the great
/// sphere y = 0, of which the axes are x, z and the centre of A.
pub fn local_time_s(time_of_day_s: f64, globe: Globe, point: ChartPoint) -> Option<f64> {
    let [to_a, along_z] = globe.along_poles(point);
    let noon = to_a.atan2(-along_z);
    let local_s = time_of_day_s + (0.25 - noon / TAU) * DAY_S;
    (to_a.hypot(along_z) >= TIMELESS.sin()).then(|| local_s.rem_euclid(DAY_S))
}

/// How much of a body's light there is at an eye, 0 to 1: of the sun's, `daylight_at` of worlds/closed.wgsl.
fn daylight(strategy: &dyn Metric, sun: ChartPoint, eye: &Eye) -> f32 {
    let away = strategy.distance_m(eye.point, sun, eye) / strategy.radius_m();
    let [night, day] = NIGHT_AND_DAY;
    let t = ((away.cos() as f32 - night) / (day - night)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The chart direction, at the eye, in which a point is seen.
fn toward(strategy: &dyn Map, eye: &Eye, point: ChartPoint) -> Vec3 {
    let view = strategy.view_point(eye, point).truncate();
    let seen = eye.right() * view.x + eye.up() * view.y - eye.front() * view.z;
    seen.normalize_or(DVec3::Y).as_vec3()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;
    use crate::day::{local_time_s, sky};

    const RADIUS_M: f64 = 64.0;

    fn eye(chart: ChartId, x: f64, z: f64) -> Eye {
        let pos = DVec3::new(x, 0.3 * RADIUS_M, z);
        Eye {
            point: ChartPoint::new(chart, pos),
            yaw: 0.4,
            pitch: 0.1,
            roll: 0.0,
            dial: 0.0,
            lift_m: 0.0,
        }
    }

    fn day_at(time_s: f64, eye: &Eye) -> f32 {
        1.0 - sky(time_s, &*strategy(Geometry::Spherical, RADIUS_M), eye).stars
    }

    #[test]
    fn noon_at_the_centre_of_one_hemisphere_is_midnight_at_that_of_the_other() {
        let (a, b) = (
            eye(ChartId::FIRST, 0.0, 0.0),
            eye(ChartId::SECOND, 0.0, 0.0),
        );
        assert_eq!((day_at(150.0, &a), day_at(150.0, &b)), (1.0, 0.0));
        assert_eq!((day_at(450.0, &a), day_at(450.0, &b)), (0.0, 1.0));
        let noon = sky(150.0, &*strategy(Geometry::Spherical, RADIUS_M), &a);
        assert!(noon.sun_direction[1] > 0.999, "{:?}", noon.sun_direction);
    }

    #[test]
    fn morning_sweeps_round_the_world() {
        let rim_m = FRAC_PI_2 * RADIUS_M;
        let places = [-0.9, -0.45, 0.0, 0.45, 0.9].map(|z| eye(ChartId::FIRST, 0.0, z * rim_m));
        let dawns = places.map(|place| {
            let dark_s = (0..DAY_S as u32).rfind(|s| day_at(f64::from(*s), &place) == 0.0);
            let dark_s = f64::from(dark_s.unwrap_or_default());
            let light = (0..DAY_S as u32).find(|s| {
                let before = day_at(f64::from(*s) + dark_s, &place);
                before > 0.5
            });
            (dark_s + f64::from(light.unwrap_or_default())).rem_euclid(DAY_S)
        });
        let first = dawns[0];
        let after = dawns.map(|dawn| (dawn - first).rem_euclid(DAY_S));
        assert!(after.is_sorted() && after[4] > 200.0, "{dawns:?}");
    }

    #[test]
    fn light_changes_without_a_step_all_day_and_on_a_walk_over_the_equator() {
        let place = eye(ChartId::FIRST, 12.0, 40.0);
        for tick in 0..6000 {
            let at = f64::from(tick) * 0.1;
            let (a, b) = (day_at(at, &place), day_at(at + 0.1, &place));
            assert!((a - b).abs() < 0.003, "{a} and {b} at {at} s");
        }
        let space = strategy(Geometry::Spherical, RADIUS_M);
        let rim = eye(ChartId::FIRST, 0.0, FRAC_PI_2 * RADIUS_M);
        let carried = space
            .images(rim.point, f64::INFINITY)
            .pop()
            .map(|crossing| crossing.point);
        let other = Eye {
            point: carried.unwrap_or(rim.point),
            ..rim
        };
        assert_ne!(other.point.chart, rim.point.chart);
        assert!((day_at(260.0, &rim) - day_at(260.0, &other)).abs() < 1e-6);
    }
    /// The point of the ground at an angle from the centre of A and at a heading from +x there.
    fn place(from_centre: f64, heading: f64) -> Eye {
        let (chart, away, mirrored) = if from_centre > FRAC_PI_2 {
            (ChartId::SECOND, PI - from_centre, -1.0)
        } else {
            (ChartId::FIRST, from_centre, 1.0)
        };
        let away_m = away * RADIUS_M;
        eye(
            chart,
            mirrored * away_m * heading.cos(),
            away_m * heading.sin(),
        )
    }

    proptest::proptest! {
        #[test]
        fn at_the_clocks_noon_the_light_is_highest_and_its_day_hours_are_lit(
            from_centre in 0.0..PI, heading in 0.0..TAU, time_s in 0.0..DAY_S,
        ) {
            let space = strategy(Geometry::Spherical, RADIUS_M);
            let here = place(from_centre, heading);
            // What the light goes by, and does not stop at full day as it does.
            let sun_away_m = |time_s: f64| {
                let turn = time_s / DAY_S * TAU;
                space.globe().map_or(f64::NAN, |globe| {
                    let sun = globe.over_poles(turn, SUN_HEIGHT * RADIUS_M);
                    space.distance_m(here.point, sun, &here)
                })
            };
            let Some(local_s) = local_time_s(time_s, &*space, here.point) else {
                let [noon, night] = [0.0, 150.0].map(sun_away_m);
                proptest::prop_assert!((noon - night).abs() < 0.1 * RADIUS_M);
                return Ok(());
            };
            let at = |clock_s: f64| (time_s + clock_s - local_s).rem_euclid(DAY_S);
            let highest_m = sun_away_m(at(150.0));
            for tick in 0..60 {
                let clock_s = f64::from(tick) * 10.0;
                proptest::prop_assert!(sun_away_m(at(clock_s)) > highest_m - 1e-6);
                let light = day_at(at(clock_s), &here);
                let dawn = day_at(at(0.0), &here);
                let lighter = if clock_s <= 300.0 {
                    light - dawn
                } else {
                    dawn - light
                };
                proptest::prop_assert!(lighter > -1e-4, "{} {}", clock_s, light);
                // Where one can see it: between nine and three.
                let is_bright = (75.0..=225.0).contains(&clock_s) && sun_away_m(at(450.0)) > 1.3 * highest_m;
                proptest::prop_assert!(!is_bright || light > 0.5, "{} {}", clock_s, light);
            }
        }
    }

    #[test]
    fn the_poles_of_the_suns_way_have_no_hour() {
        let space = strategy(Geometry::Spherical, RADIUS_M);
        let at = |x: f64| local_time_s(77.0, &*space, eye(ChartId::FIRST, x, 0.0).point);
        let rim_m = FRAC_PI_2 * RADIUS_M;
        assert_eq!((at(rim_m), at(-rim_m)), (None, None));
        assert!(at(rim_m - 4.0).is_some() && at(4.0 - rim_m).is_some());
        let middle = local_time_s(77.0, &*space, eye(ChartId::FIRST, 0.0, 0.0).point);
        assert!(middle.is_some_and(|local_s| (local_s - 77.0).abs() < 1e-9));
        let other = local_time_s(77.0, &*space, eye(ChartId::SECOND, 0.0, 0.0).point);
        assert!(other.is_some_and(|local_s| (local_s - 377.0).abs() < 1e-9));
    }
}
