//! Jumping, falling and sliding: free flight that slides along whatever it meets until it lands.

use glam::DVec3;

use crate::mover::{Mover, clip, level};
use crate::patch::Contact;

/// How often one part of a flight is pushed out of what it overlaps.
const PUSHES: usize = 12;

/// Overlaps deeper than this (m) that remain after all pushes take the part back.
const LEFT_OVER_M: f64 = 0.05;

/// A face's lip carries a landing only when it is at least this far below the ball's middle.
const LEAST_LANDING_LIP_UP: f64 = 0.3;

/// A contact that points down at least this much stops a rise.
const CEILING_UP: f64 = -0.5;

/// Between slopes that face each other, a fall that makes less of its way than this has ended.
const WEDGED_SHARE: f64 = 0.3;

/// Where a flight got to.
#[derive(Clone, Debug)]
pub(crate) struct Flown {
    pub feet: DVec3,
    pub velocity: DVec3,
    pub landed: bool,
    /// Speed of the fall that the landing ended (m/s).
    pub impact_m_s: f64,
    /// The most that slopes too steep to stand on took of it at once (m/s).
    pub scrape_m_s: f64,
}

/// What steep contacts a flight has slid along.
#[derive(Default)]
struct Slides {
    ways: Vec<DVec3>,
}

impl Slides {
    fn note(&mut self, contact: &Contact) {
        if contact.normal.y > 0.0
            && let Some(way) = level(contact.normal).try_normalize()
        {
            self.ways.push(way);
        }
    }

    fn facing(&self) -> bool {
        self.ways
            .iter()
            .enumerate()
            .any(|(i, a)| self.ways[..i].iter().any(|b| a.dot(*b) < 0.0))
    }
}

impl Mover<'_> {
    /// Flies from `feet` with `velocity` under gravity for `dt_s`, to the landing at most.
    pub fn fly_through_air(&self, feet: DVec3, velocity: DVec3, dt_s: f64) -> Flown {
        let gravity = DVec3::NEG_Y * self.tuning.gravity_m_s2;
        let end_y = (velocity.y + gravity.y * dt_s).max(-self.tuning.terminal_speed_m_s);
        // The mean of both ends is exact under constant acceleration: apexes come out as designed.
        let mut way = level(velocity) * dt_s + DVec3::Y * (0.5 * (velocity.y + end_y) * dt_s);
        let mut flown = Flown {
            feet,
            velocity: velocity.with_y(end_y),
            landed: false,
            impact_m_s: 0.0,
            scrape_m_s: 0.0,
        };
        let (parts, wanted_drop) = (self.parts(way), -way.y);
        let mut slides = Slides::default();
        for _ in 0..parts {
            let before = flown.feet;
            flown.feet += way / parts as f64;
            self.leave_contacts(before, &mut flown, &mut way, &mut slides);
            if flown.landed {
                return self.settle(flown);
            }
        }
        let dropped = feet.y - flown.feet.y;
        if wanted_drop > 0.0 && dropped < WEDGED_SHARE * wanted_drop && slides.facing() {
            flown.landed = true;
            flown.impact_m_s = -velocity.y.min(0.0);
            flown.velocity.y = 0.0;
        }
        flown
    }

    fn leave_contacts(
        &self,
        before: DVec3,
        flown: &mut Flown,
        way: &mut DVec3,
        slides: &mut Slides,
    ) {
        for _ in 0..PUSHES {
            let Some(contact) = self.overlap(flown.feet) else {
                return;
            };
            if self.carries(contact.normal.y, contact.face.y, LEAST_LANDING_LIP_UP) {
                flown.feet.y += (contact.depth / contact.normal.y).min(self.capsule.radius_m);
                if flown.velocity.y <= 0.0 {
                    flown.landed = true;
                    flown.impact_m_s = flown.impact_m_s.max(-flown.velocity.y);
                    flown.velocity.y = 0.0;
                    way.y = 0.0;
                }
                continue;
            }
            slides.note(&contact);
            let taken_m_s = fall_taken(flown.velocity, contact.normal);
            flown.scrape_m_s = flown.scrape_m_s.max(taken_m_s);
            flown.feet += contact.normal * contact.depth;
            flown.velocity = slide(flown.velocity, contact.normal);
            *way = slide(*way, contact.normal);
        }
        let left = self.patch.deepest(&self.capsule, flown.feet, LEFT_OVER_M);
        let had = self.patch.deepest(&self.capsule, before, 0.0);
        if left.is_some_and(|left| left.depth > had.map_or(0.0, |had| had.depth)) {
            flown.feet = before;
            flown.velocity = DVec3::ZERO;
            *way = DVec3::ZERO;
        }
    }

    /// After a landing, puts the feet where walking would.
    fn settle(&self, mut flown: Flown) -> Flown {
        let near = 0.5 * self.capsule.radius_m;
        if let Some(y) = self.floor(flown.feet, flown.feet.y, near, near)
            && self.overlap(flown.feet.with_y(y)).is_none()
        {
            flown.feet.y = y;
        }
        flown
    }
}

/// Speed of a fall that a slope takes, m/s: what goes into it, `-v.n`, so that sliding on along it costs nothing, but no
/// more than the fall alone has of that, so that running into it costs nothing either.
fn fall_taken(velocity: DVec3, normal: DVec3) -> f64 {
    let into = -velocity.dot(normal);
    into.min((-velocity.y).max(0.0) * normal.y).max(0.0)
}

/// What is left of a motion along a contact that does not carry. A run against a steep slope is
/// stopped before it can turn into a climb, and a ceiling stops a rise.
fn slide(motion: DVec3, normal: DVec3) -> DVec3 {
    let mut motion = motion;
    if normal.y < CEILING_UP {
        motion.y = motion.y.min(0.0);
    } else if normal.y > 0.0
        && let Some(way) = level(normal).try_normalize()
    {
        motion = clip(motion, way);
    }
    clip(motion, normal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_against_a_steep_slope_does_not_climb() {
        let normal = DVec3::new(-55f64.to_radians().sin(), 55f64.to_radians().cos(), 0.0);
        let after = slide(DVec3::new(6.0, 0.0, 1.0), normal);
        assert!(after.y <= 1e-12, "{after}");
        assert!(
            (after.z - 1.0).abs() < 1e-12,
            "along the slope it goes on: {after}"
        );
    }

    #[test]
    fn a_fall_onto_a_steep_slope_slides_down_along_it() {
        let normal = DVec3::new(-0.8, 0.6, 0.0);
        let after = slide(DVec3::new(0.0, -5.0, 0.0), normal);
        assert!(
            after.dot(normal).abs() < 1e-12 && after.y < -1.0 && after.x < -1.0,
            "{after}"
        );
    }

    #[test]
    fn a_steep_slope_takes_the_part_of_a_fall_that_goes_into_it() {
        let normal = DVec3::new(-0.8, 0.6, 0.0);
        let fall = DVec3::new(0.0, -20.0, 0.0);
        assert!((fall_taken(fall, normal) - 12.0).abs() < 1e-12);
        let slid = slide(fall, normal);
        assert!(fall_taken(slid, normal) < 1e-12, "the slide is free");
        let run = DVec3::new(8.0, -0.5, 0.0);
        assert!((fall_taken(run, normal) - 0.3).abs() < 1e-12);
        assert!(
            fall_taken(DVec3::new(3.0, 4.0, 0.0), DVec3::NEG_Y) < 1e-12,
            "a ceiling"
        );
    }

    #[test]
    fn a_ceiling_stops_a_rise_but_not_a_run() {
        let after = slide(DVec3::new(3.0, 4.0, 0.0), DVec3::NEG_Y);
        assert_eq!(after, DVec3::new(3.0, 0.0, 0.0));
        let under_a_slant = slide(
            DVec3::new(0.0, 4.0, 0.0),
            DVec3::new(0.5, -0.75f64.sqrt(), 0.0),
        );
        assert!(under_a_slant.y <= 0.0, "{under_a_slant}");
    }
}
