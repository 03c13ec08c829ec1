//! The dip of the head on landing: a critically damped spring, pushed down by the speed of the fall.
//!
//! With the rate w, a push of v sinks the head by v / (w e) after 1 / w seconds, and it comes up without swinging.
//!
//! Who goes through a door to ground that lies higher or lower there is set on it at once; the head follows within 0.3 s.

use crate::tuning::{DIP_FROM_M_S, DIP_PUSH, DIP_PUSH_MOST_M_S, DIP_RATE_PER_S};

/// Below these the head has come to rest, in metres and metres per second.
const REST: (f64, f64) = (1e-4, 1e-3);

/// How far the head is below where it belongs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct HeadDip {
    depth_m: f64,
    speed_m_s: f64,
    /// How far the body was lifted that the head has not followed yet, metres.
    behind_m: f64,
}

/// The share of the way to a body that was lifted that is left after a second is e to the power of minus this.
const FOLLOWS_PER_S: f64 = 11.0;

impl HeadDip {
    /// Metres below where the head belongs; never negative.
    pub fn depth_m(&self) -> f64 {
        self.depth_m
    }

    /// Metres below where the head belongs on a body that was lifted at a door; negative above it.
    pub fn behind_m(&self) -> f64 {
        self.behind_m
    }

    /// The body was lifted by so much at a door, metres.
    pub fn lift(&mut self, by_m: f64) {
        self.behind_m += by_m;
    }

    /// A fall at that speed has ended.
    pub fn land(&mut self, impact_m_s: f64) {
        if impact_m_s >= DIP_FROM_M_S {
            let push = (DIP_PUSH * impact_m_s).min(DIP_PUSH_MOST_M_S);
            self.speed_m_s = self.speed_m_s.max(push);
        }
    }

    /// Puts the head where it belongs at once.
    pub fn rest(&mut self) {
        *self = Self::default();
    }

    /// Lets time pass, by the spring's exact solution.
    pub fn pass(&mut self, dt_s: f64) {
        let (rate, decay) = (DIP_RATE_PER_S, (-DIP_RATE_PER_S * dt_s).exp());
        let rise = self.speed_m_s + rate * self.depth_m;
        let depth_m = (self.depth_m + rise * dt_s) * decay;
        self.speed_m_s = (self.speed_m_s - rate * rise * dt_s) * decay;
        self.depth_m = depth_m.max(0.0);
        self.behind_m *= (-FOLLOWS_PER_S * dt_s).exp();
        if self.behind_m.abs() > REST.0 {
            return;
        }
        self.behind_m = 0.0;
        if self.depth_m < REST.0 && self.speed_m_s.abs() < REST.1 {
            self.rest();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tuning::STEP_S;

    /// The depths of half a second after a landing.
    fn depths(impact_m_s: f64) -> Vec<f64> {
        let mut dip = HeadDip::default();
        dip.land(impact_m_s);
        let mut depth = || {
            dip.pass(STEP_S);
            dip.depth_m()
        };
        (0..90).map(|_| depth()).collect()
    }

    #[test]
    fn a_landing_sinks_the_head_a_little_and_it_comes_back_without_swinging() {
        let depths = depths(5.0);
        let deepest = depths.iter().copied().fold(0.0, f64::max);
        assert!((0.04..0.15).contains(&deepest), "{deepest}");
        let turn = depths
            .iter()
            .position(|depth| *depth == deepest)
            .unwrap_or(0);
        assert!(
            turn < 12 && depths[turn..].is_sorted_by(|a, b| a >= b),
            "{depths:?}"
        );
        assert_eq!(depths.last(), Some(&0.0), "it comes to rest exactly");
    }

    #[test]
    fn steps_do_not_shake_and_no_fall_buries_the_head() {
        assert!(depths(0.5).iter().all(|depth| *depth == 0.0));
        let deepest = depths(200.0).into_iter().fold(0.0, f64::max);
        assert!((0.1..0.3).contains(&deepest), "{deepest}");
    }
}
