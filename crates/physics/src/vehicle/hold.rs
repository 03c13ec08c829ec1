//! Keeps a braked vehicle in its place.
//!
//! The controller's tyres only take speed away, a step after the weight has given it: on a slope a braked vehicle would
//! creep on for ever, 5 cm/s at 17 degrees. Tyres that hold stand off from where they took hold until they pull as much
//! as the weight does, as rubber bends.

use antipode_geometry::Crossing;
use glam::DVec3;

/// How fast tyres go back to where they took hold, for each metre that they are off it, 1/s.
const PULL_PER_S: f64 = 10.0;
/// Farther than this, in metres, they slip and take hold anew: more than their grip can ask for on any slope.
const BENDS_M: f64 = 0.03;

/// Where tyres took hold.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hold {
    anchor: Option<DVec3>,
}

impl Hold {
    /// The velocity by which tyres on ground with these normals are too slow for where they should be, m/s; nothing
    /// while they roll or hang in the air. `place` is the vehicle's, in metres.
    pub fn pull(&mut self, place: DVec3, normals: &[DVec3], holds: bool) -> DVec3 {
        let normal = normals.iter().sum::<DVec3>().try_normalize();
        let Some(normal) = normal.filter(|_| holds) else {
            self.let_go();
            return DVec3::ZERO;
        };
        let off = place - self.anchor.unwrap_or(place);
        let off = (off - normal * off.dot(normal)).clamp_length_max(BENDS_M);
        self.anchor = Some(place - off);
        off * PULL_PER_S
    }

    /// The vehicle, which was at `place` (m), is carried whole: what took hold goes with it.
    pub fn carry(&mut self, place: DVec3, crossing: &Crossing) {
        let carried = |at: DVec3| crossing.point.pos + crossing.turn_vector(at - place);
        self.anchor = self.anchor.map(carried);
    }

    /// The vehicle is elsewhere: they take hold there.
    pub fn let_go(&mut self) {
        self.anchor = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_pulls_back_along_the_ground_and_slips_when_it_is_pushed_far() {
        let (mut hold, level) = (Hold::default(), [DVec3::Y]);
        assert_eq!(hold.pull(DVec3::ONE, &level, true), DVec3::ZERO);
        let near = DVec3::ONE + DVec3::new(0.01, 0.2, 0.0);
        assert!(hold.pull(near, &level, true).distance(DVec3::X * 0.1) < 1e-9);
        let far = DVec3::ONE + DVec3::Z;
        assert!(hold.pull(far, &level, true).distance(DVec3::Z * 0.3) < 1e-9);
        let back = far - DVec3::Z * BENDS_M;
        assert!(hold.pull(back, &level, true).length() < 1e-9);
    }

    #[test]
    fn who_rolls_or_flies_is_not_held() {
        let mut hold = Hold::default();
        for (normals, holds) in [(&[DVec3::Y][..], false), (&[][..], true)] {
            hold.pull(DVec3::ZERO, &[DVec3::Y], true);
            assert_eq!(hold.pull(DVec3::X, normals, holds), DVec3::ZERO);
            assert_eq!(hold.pull(DVec3::ONE, &[DVec3::Y], true), DVec3::ZERO);
        }
    }
}
