//! The day: ten minutes of sun, dusk, moon and dawn, as colours and directions of light.
//!
//! Phases and their times follow the theses' cycle; colours are tuned in linear light.
//! The sun rises at -z, stands overhead at 150 s and sets at +z; the moon crosses from -x, overhead at 450 s.

use std::f64::consts::PI;

use antipode_geometry::{Atlas, ChartPoint, Eye, Strategy};
use glam::Vec3;

use crate::closed_day;
use crate::frame::Sky;
use crate::tuning::DAY_S;

/// Colours of one moment of the day, linear light.
#[derive(Clone, Copy)]
struct Palette {
    at_s: f64,
    top: Vec3,
    horizon: Vec3,
    glare: Vec3,
    stars: f32,
}

const fn moment(
    at_s: f64,
    top: [f32; 3],
    horizon: [f32; 3],
    glare: [f32; 3],
    stars: f32,
) -> Palette {
    Palette {
        at_s,
        top: Vec3::from_array(top),
        horizon: Vec3::from_array(horizon),
        glare: Vec3::from_array(glare),
        stars,
    }
}

/// The moments between which the sky is interpolated; the last wraps round to the first.
const MOMENTS: [Palette; 10] = [
    moment(
        0.0,
        [0.10, 0.26, 0.50],
        [0.78, 0.36, 0.14],
        [1.00, 0.34, 0.08],
        0.25,
    ),
    moment(
        35.0,
        [0.10, 0.27, 0.66],
        [0.56, 0.70, 0.86],
        [1.00, 0.88, 0.68],
        0.0,
    ),
    moment(
        150.0,
        [0.08, 0.25, 0.68],
        [0.52, 0.70, 0.90],
        [1.00, 0.96, 0.88],
        0.0,
    ),
    moment(
        255.0,
        [0.09, 0.25, 0.62],
        [0.60, 0.66, 0.78],
        [1.00, 0.84, 0.58],
        0.0,
    ),
    moment(
        300.0,
        [0.035, 0.055, 0.16],
        [0.80, 0.24, 0.10],
        [1.00, 0.42, 0.10],
        0.2,
    ),
    moment(
        330.0,
        [0.020, 0.018, 0.085],
        [0.20, 0.080, 0.13],
        [0.60, 0.22, 0.16],
        0.6,
    ),
    moment(
        390.0,
        [0.0030, 0.0048, 0.016],
        [0.012, 0.020, 0.046],
        [0.05, 0.05, 0.08],
        1.0,
    ),
    moment(
        510.0,
        [0.0030, 0.0048, 0.016],
        [0.012, 0.020, 0.046],
        [0.05, 0.05, 0.08],
        1.0,
    ),
    moment(
        560.0,
        [0.018, 0.045, 0.15],
        [0.12, 0.12, 0.22],
        [0.50, 0.20, 0.16],
        0.7,
    ),
    moment(
        600.0,
        [0.10, 0.26, 0.50],
        [0.78, 0.36, 0.14],
        [1.00, 0.34, 0.08],
        0.25,
    ),
];

const MOON_COLOUR: Vec3 = Vec3::new(0.30, 0.36, 0.52);

/// How dark shadows by the sun and by the moon are, of all that their light gives.
const SUN_SHADOW: f32 = 1.0;
const MOON_SHADOW: f32 = 0.75;
/// Strength of a light that hardly shows: a third of the moon's.
const FAINT: f32 = 0.2;

/// How dark shadows are where the sun and the moon give so much light. Where one takes over from the other both are as
/// strong, and neither may throw a shadow that comes or goes at once; nor does a light too weak to see.
pub(crate) fn key_shadow(sun: f32, moon: f32) -> f32 {
    let lead = (sun - moon).abs() / sun.max(moon).max(FAINT);
    let darkest = if sun >= moon { SUN_SHADOW } else { MOON_SHADOW };
    darkest * smooth(0.0, 0.6, lead)
}

/// The sky and light at `time_of_day_s` (any value; it wraps at a day's length) for an eye in the given space.
pub fn sky(time_of_day_s: f64, strategy: &dyn Strategy, eye: &Eye) -> Sky {
    match strategy.globe() {
        Some(globe) => closed_day::sky(time_of_day_s, globe, strategy, eye),
        None => dome(time_of_day_s),
    }
}

/// The time of day at a place: as everywhere under one sky, and by where the sun is in a closed world. 0 is sunrise
/// there, a quarter of a day noon, when the sun stands highest; none where that is always as high.
pub fn local_time_s(time_of_day_s: f64, atlas: &dyn Atlas, point: ChartPoint) -> Option<f64> {
    match atlas.globe() {
        Some(globe) => closed_day::local_time_s(time_of_day_s, globe, point),
        None => Some(time_of_day_s.rem_euclid(DAY_S)),
    }
}

/// What a clock of 24 hours shows at a time of day: six at sunrise.
pub fn hour(time_of_day_s: f64) -> f64 {
    (time_of_day_s / DAY_S * 24.0 + 6.0).rem_euclid(24.0)
}

/// Whether it is so late or so early at a time of day, of a place, that the sky gives hardly any light.
pub fn is_night(time_of_day_s: f64) -> bool {
    !(5.0..19.5).contains(&hour(time_of_day_s))
}

fn dome(time_of_day_s: f64) -> Sky {
    let time_s = time_of_day_s.rem_euclid(DAY_S);
    let now = palette_at(time_s);
    let angle = time_s / (DAY_S / 2.0) * PI;
    let sun = Vec3::new(0.28, angle.sin() as f32, -angle.cos() as f32).normalize();
    let moon_angle = angle - PI;
    let moon = Vec3::new(-moon_angle.cos() as f32, moon_angle.sin() as f32, 0.25).normalize();
    // Each light fades as it nears the horizon, so the hand-over between sun and moon shows no step.
    let sunlight = smooth(-0.05, 0.18, sun.y);
    let moonlight = smooth(-0.02, 0.25, moon.y) * (1.0 - sunlight);
    let sun_colour = now.glare * (1.8 * sunlight);
    let moon_colour = MOON_COLOUR * (0.9 * moonlight);
    let (sun_strength, moon_strength) = (sun_colour.length(), moon_colour.length());
    let (key_direction, key_colour) = if sun_strength >= moon_strength {
        (sun, sun_colour)
    } else {
        (moon, moon_colour)
    };
    let ring = all_round(now.horizon);
    let ambient_sky = now.top * 0.55 + ring * 0.35 + Vec3::new(0.034, 0.040, 0.064);
    let ambient_ground = ring * 0.22 + Vec3::new(0.026, 0.024, 0.027);
    Sky {
        top: now.top.into(),
        horizon: now.horizon.into(),
        glare: now.glare.into(),
        stars: now.stars,
        sun_direction: sun.into(),
        moon_direction: moon.into(),
        key_direction: key_direction.into(),
        key_shadow: key_shadow(sun_strength, moon_strength),
        key_colour: key_colour.into(),
        moon_colour: MOON_COLOUR.into(),
        ambient_sky: ambient_sky.into(),
        ambient_ground: ambient_ground.into(),
        dome: true,
        clouds: clouds(time_s),
        drift: (time_s / DAY_S) as f32,
        orbs: None,
    }
}

/// The mean of the sky's edge all round, given its colour towards the sun: a low sun reddens its own side alone, and
/// land that is lit by all of the sky is not red.
fn all_round(horizon: Vec3) -> Vec3 {
    let warmth = (horizon.x - horizon.z).max(0.0);
    horizon + warmth * Vec3::new(-0.10, 0.26, 0.42)
}

/// Clouds gather in the afternoon and are fewest before sunrise.
fn clouds(time_s: f64) -> f32 {
    (0.5 - 0.18 * (time_s / DAY_S * 2.0 * PI + 0.4).cos()) as f32
}

fn palette_at(time_s: f64) -> Palette {
    let after = MOMENTS
        .iter()
        .position(|m| m.at_s > time_s)
        .unwrap_or(MOMENTS.len() - 1)
        .max(1);
    let (a, b) = (MOMENTS[after - 1], MOMENTS[after]);
    let t = (((time_s - a.at_s) / (b.at_s - a.at_s)) as f32).clamp(0.0, 1.0);
    Palette {
        at_s: time_s,
        top: a.top.lerp(b.top, t),
        horizon: a.horizon.lerp(b.horizon, t),
        glare: a.glare.lerp(b.glare, t),
        stars: a.stars + (b.stars - a.stars) * t,
    }
}

fn smooth(from: f32, to: f32, x: f32) -> f32 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartPoint, Geometry, strategy};
    use glam::DVec3;

    use super::*;

    fn at(time_s: f64) -> Sky {
        let eye = Eye {
            point: ChartPoint::a(DVec3::ZERO),
            yaw: 0.0,
            pitch: 0.0,
            roll: 0.0,
            dial: 0.0,
            lift_m: 0.0,
        };
        sky(time_s, &*strategy(Geometry::Euclidean, 0.0), &eye)
    }

    #[test]
    fn the_sun_stands_overhead_at_noon_and_the_moon_at_midnight() {
        assert!(at(150.0).sun_direction[1] > 0.95);
        assert!(at(450.0).moon_direction[1] > 0.95);
        assert!(at(450.0).sun_direction[1] < -0.95);
    }

    #[test]
    fn the_sky_changes_without_a_step_all_day_and_over_midnight() {
        for tick in 0..6000 {
            let (a, b) = (at(f64::from(tick) * 0.1), at(f64::from(tick + 1) * 0.1));
            for (x, y) in a.horizon.iter().zip(b.horizon) {
                assert!(
                    (x - y).abs() < 0.01,
                    "horizon jumps at {} s",
                    f64::from(tick) * 0.1
                );
            }
            for (x, y) in a.ambient_sky.iter().zip(b.ambient_sky) {
                assert!((x - y).abs() < 0.01);
            }
        }
    }

    #[test]
    fn shadows_fade_where_sun_and_moon_take_turns_and_change_without_a_step() {
        let mut turns = 0;
        for tick in 0..6000 {
            let (a, b) = (at(f64::from(tick) * 0.1), at(f64::from(tick + 1) * 0.1));
            assert!((a.key_shadow - b.key_shadow).abs() < 0.1, "{tick}");
            let along: f32 = (0..3)
                .map(|i| a.key_direction[i] * b.key_direction[i])
                .sum();
            if along < 0.9 {
                turns += 1;
                assert!(a.key_shadow.max(b.key_shadow) < 0.1, "{tick}");
            }
        }
        assert_eq!(turns, 2);
        assert!(at(450.0).key_shadow < at(150.0).key_shadow);
    }

    #[test]
    fn no_moment_is_without_light() {
        for tick in 0..600 {
            let sky = at(f64::from(tick));
            assert!(
                sky.ambient_sky.iter().all(|c| *c > 0.01),
                "black at {tick} s"
            );
        }
    }
}
