//! Where a door can stand: on ground that its posts reach, that leads on before and behind it, and with room there.

use antipode_geometry::{ChartPoint, Leaf};
use antipode_items::{Item, Stands};
use glam::DVec3;

use crate::door::leaf_of;
use crate::fixture::{self, Behaviour, Fixture};
use crate::notice::Unfit;
use crate::pick::over;
use crate::situation::Situation;

/// How far aside of the foot the posts stand, metres.
const POST_M: f64 = 1.04;
/// So far before and behind it there is to be room, metres.
const ROOM_M: f64 = 1.0;
/// Heights over the ground that are to be free there, and how far aside, metres.
const FREE_UP_M: [f64; 2] = [1.0, 1.8];
const FREE_ASIDE_M: f64 = 0.6;
/// The other door is farther off than this, metres.
const APART_M: f64 = 2.4;
/// Halvings by which the height of the ground is found, within centimetres.
const HALVINGS: usize = 6;

/// How steep ground may be.
#[derive(Clone, Copy, Debug)]
struct Rule {
    /// How far the ground below the posts may lie above or below the foot, metres: they reach so far into the ground.
    uneven_m: f64,
    /// How far it may rise or fall over [`ROOM_M`] before and behind the door, metres: no more than one can walk up.
    step_m: f64,
}

const RULE: Rule = Rule {
    uneven_m: 1.1,
    step_m: 1.15,
};

/// What stands in pairs.
pub(crate) struct Paired;

impl Behaviour for Paired {
    /// On any ground: what is against it is told by [`Paired::unfit`].
    fn foot_on(&self, _: &Stands, spot: ChartPoint, _: DVec3) -> Option<ChartPoint> {
        Some(spot)
    }

    fn unfit(&self, now: Situation<'_>, it: &Fixture) -> Option<Unfit> {
        let leaf = leaf_of(&*now.world.strategy, it);
        let solid = |at: ChartPoint| now.world.ground.is_solid(at);
        let unfit = ground_against(&solid, &leaf, &RULE);
        unfit.or_else(|| is_crowded(now, &leaf).then_some(Unfit::Crowded))
    }

    fn is_foreseen(&self) -> bool {
        true
    }

    fn replaces_oldest(&self) -> bool {
        true
    }
}

/// What of the ground is against a leaf.
fn ground_against(solid: &dyn Fn(ChartPoint) -> bool, leaf: &Leaf, rule: &Rule) -> Option<Unfit> {
    let is_solid = |x: f64, y: f64, z: f64| solid(leaf.place(DVec3::new(x, y, z)));
    // The height of ground within a span of the foot's: rock at its lower end and air at its upper one.
    let height_m = |x: f64, z: f64, span_m: f64| {
        let (mut low, mut high) = (-span_m, span_m);
        if !is_solid(x, low, z) || is_solid(x, high, z) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if is_solid(x, middle, z) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(high)
    };
    let posts = [-POST_M, 0.0, POST_M].map(|z| height_m(0.0, z, rule.uneven_m));
    if posts.contains(&None) {
        return Some(Unfit::Steep);
    }
    for x in [-ROOM_M, -0.5 * ROOM_M, 0.5 * ROOM_M, ROOM_M] {
        let Some(ground_m) = height_m(x, 0.0, rule.step_m) else {
            let is_walled = is_solid(x, FREE_UP_M[1], 0.0);
            return Some(if is_walled {
                Unfit::Walled
            } else {
                Unfit::Steep
            });
        };
        let is_in_the_way = |up_m: &f64| {
            let asides = [-FREE_ASIDE_M, 0.0, FREE_ASIDE_M];
            asides.iter().any(|z| is_solid(x, ground_m + up_m, *z))
        };
        if FREE_UP_M.iter().any(is_in_the_way) {
            return Some(Unfit::Walled);
        }
    }
    None
}

/// Whether the door that stays when one more is put up is too close to it.
fn is_crowded(now: Situation<'_>, leaf: &Leaf) -> bool {
    let others = fixture::map_of(now.actors, Item::Door, |_, it| it.foot.point);
    let stays = others.last();
    stays.is_some_and(|other| {
        let there = over(&*now.world.strategy, leaf.foot, *other);
        there.chart == leaf.foot.chart && there.pos.distance(leaf.foot.pos) < APART_M
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use std::f64::consts::{FRAC_PI_4, PI, TAU};

    use antipode_geometry::{ChartId, Geometry, strategy};
    use antipode_terrain::Field;

    use super::*;

    /// Places at random, always the same ones.
    struct Dice(u64);

    impl Dice {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    /// In how many of twenty places at random of closed worlds a door could be put, whichever way it looks.
    fn possible(radius_m: f64, rule: &Rule) -> usize {
        let mut dice = Dice(23);
        let places = (0..20).map(|place| {
            let space = strategy(Geometry::Spherical, radius_m);
            let field = Field::new(place / 5, space.clone());
            let (out, round) = (dice.next().sqrt(), TAU * dice.next());
            let chart = if dice.next() < 0.5 {
                ChartId::FIRST
            } else {
                ChartId::SECOND
            };
            let level = DVec3::new(round.cos(), 0.0, round.sin()) * (out * 0.5 * PI * radius_m);
            let solid = |at: ChartPoint| field.sample(at) < 0.0;
            let at = |y: f64| ChartPoint::new(chart, level.with_y(y));
            let highest_m = 1.2 * radius_m;
            let heights = (0..).map(|step| highest_m - 0.05 * f64::from(step));
            let ground = heights.map(at).find(|at| solid(*at)).unwrap();
            (0..8).any(|turn| {
                let yaw = FRAC_PI_4 * f64::from(turn);
                let leaf = Leaf::at(&*space, ground, yaw);
                ground_against(&solid, &leaf, rule).is_none()
            })
        });
        places.filter(|is_possible| *is_possible).count()
    }

    #[test]
    fn in_most_places_of_closed_worlds_a_door_can_be_put() {
        let narrow = Rule {
            uneven_m: 0.55,
            step_m: 0.85,
        };
        let counts = [32.0, 64.0, 128.0]
            .map(|radius_m| [narrow, RULE].map(|rule| possible(radius_m, &rule)));
        println!("of twenty places, with posts 0.6 m deep and as they are: {counts:?}");
        assert!(counts.iter().all(|[_, now]| *now >= 15), "{counts:?}");
    }
}
