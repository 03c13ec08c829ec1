//! Notices the first time somebody has come all the way round a closed world.
//!
//! The ground of a closed world is a sphere, on which no way winds round anything: one that leads round is told by how
//! it left a place, came near the point opposite, and comes back from the other side. A walker who turns round
//! comes back from the side where he left, however far he was.

use std::f64::consts::TAU;

use antipode_geometry::ChartPoint;
use glam::DVec3;

use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::world::World;

/// The way is kept by places so far apart, as an angle about the world's middle, in radians.
const PACE_RAD: f64 = 3.0 * TAU / 360.0;
/// Farther than this nobody goes in a step: whoever does was put there, in radians.
const LEAP_RAD: f64 = 10.0 * TAU / 360.0;
/// This near a place one is back, in radians.
const BACK_RAD: f64 = 12.0 * TAU / 360.0;
/// From this far on one has left a place, and where that was shows the side, in radians.
const LEFT_RAD: f64 = 40.0 * TAU / 360.0;
/// From this far on one is on the other side of the world, in radians.
const OPPOSITE_RAD: f64 = 140.0 * TAU / 360.0;
/// Angle between the sides of leaving and coming from which on they are opposite, in radians.
const OTHER_SIDE_RAD: f64 = 120.0 * TAU / 360.0;
/// Most places that are kept: twice round.
const MOST: usize = 256;

/// The way of late, until it has led round.
#[derive(Clone, Debug, Default)]
pub(crate) struct Circumnavigation {
    /// Whether it has.
    pub been: bool,
    /// Unit vectors from the world's middle, the oldest first.
    way: Vec<DVec3>,
}

impl Circumnavigation {
    /// Goes on to a place; returns whether that closes a way round.
    fn go_on(&mut self, at: DVec3) -> bool {
        if let Some(last) = self.way.last() {
            let step_rad = last.angle_between(at);
            if step_rad < PACE_RAD {
                return false;
            }
            if step_rad > LEAP_RAD {
                self.way.clear();
            }
        }
        self.way.push(at);
        if self.way.len() > MOST {
            self.way.remove(0);
        }
        leads_round(&self.way, at)
    }
}

/// Whether a way that ends at a place has come back there from the other side, by way of the point opposite, since it
/// was last there.
fn leads_round(way: &[DVec3], at: DVec3) -> bool {
    let away_rad = |place: &&DVec3| at.angle_between(**place);
    let side = |place: &DVec3| (*place - at * at.dot(*place)).normalize_or_zero();
    let came = way.iter().rposition(|place| away_rad(&place) > LEFT_RAD);
    let before = &way[..came.map_or(0, |came| came + 1)];
    let here = before.iter().rposition(|place| away_rad(&place) < BACK_RAD);
    let since = here.map_or(&[][..], |here| &before[here..]);
    let left = since.iter().find(|place| away_rad(place) > LEFT_RAD);
    let (Some(left), Some(came)) = (left, since.last()) else {
        return false;
    };
    side(left).dot(side(came)) < OTHER_SIDE_RAD.cos()
        && since.iter().any(|place| away_rad(&place) > OPPOSITE_RAD)
}

/// Tells the player of the first time round.
pub(crate) fn notice(
    world: &World,
    feet: ChartPoint,
    round: &mut Circumnavigation,
    outbox: &mut Outbox,
) {
    if round.been {
        return;
    }
    let Some(globe) = world.strategy.globe() else {
        return;
    };
    let Some(at) = globe.from_middle_m(feet).try_normalize() else {
        return;
    };
    if round.go_on(at) {
        round.been = true;
        outbox
            .hints
            .push(Hint::BeenRound(globe.round_m().round() as u32));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A walk along longitudes in degrees, at some latitude, and the first place at which it has led round.
    fn walk(ways: &[(i32, i32)], latitude_deg: f64) -> Option<i32> {
        let mut round = Circumnavigation::default();
        for &(from, to) in ways {
            let step = (to - from).signum();
            let mut at = from;
            while at != to {
                at += step;
                let (sin, cos) = f64::from(at).to_radians().sin_cos();
                let (high, level) = latitude_deg.to_radians().sin_cos();
                if round.go_on(DVec3::new(level * cos, high, level * sin)) {
                    return Some(at);
                }
            }
        }
        None
    }

    #[test]
    fn who_walks_straight_on_has_been_round_when_he_is_back() {
        let at = walk(&[(0, 400)], 0.0);
        assert!(at.is_some_and(|at| (345..=360).contains(&at)), "{at:?}");
        assert!(walk(&[(0, -400)], 0.0).is_some_and(|at| at <= -345));
        assert!(walk(&[(0, 400)], 15.0).is_some(), "nor need it be straight");
    }

    #[test]
    fn who_turns_back_has_not_however_far_and_however_often() {
        assert_eq!(walk(&[(0, 180), (180, 0), (0, 40)], 0.0), None);
        assert_eq!(walk(&[(0, 330), (330, 0), (0, 330), (330, 20)], 0.0), None);
        assert_eq!(walk(&[(0, 20), (20, -20), (-20, 20)], 0.0), None);
        assert!(walk(&[(0, 200), (200, 150), (150, 400)], 0.0).is_some());
    }

    #[test]
    fn a_small_circle_and_a_leap_lead_round_nothing() {
        assert_eq!(walk(&[(0, 1500)], 65.0), None);
        let mut round = Circumnavigation::default();
        for degrees in [0, 5, 60, 120, 180, 240, 300, 357, 360] {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            assert!(!round.go_on(DVec3::new(cos, 0.0, sin)), "{degrees}");
        }
    }
}
