//! Breadcrumbs: laid along a way, to be followed back.

use antipode_items::Item;
use glam::DVec2;

use crate::actors::{ActorId, Actors};
use crate::bearings::{FlagWay, Locator, map_eye};
use crate::fixture::{Behaviour, map_of};
use crate::world::World;

/// With the button held one is put at one's feet wherever the others are so far off, metres.
const APART_M: f64 = 7.0;
/// Who goes back is led to the place that is so far ahead of him along the way, metres: nearer ones sway with every step, and
/// farther ones cut corners.
const AHEAD_M: f64 = 3.0;
/// Who is so near the first one has come to the end, metres: it may lie on something that he stands before.
const REACHED_M: f64 = 5.0;
/// From farther off the way is not told, metres: one has lost it.
const FOUND_M: f64 = 120.0;
/// Two that were laid one after the other are no farther apart, metres, where nobody went back between.
const NEXT_M: f64 = 2.0 * APART_M;
/// Farther from all that were laid before another way begins, metres.
const ONE_WAY_M: f64 = 40.0;

/// What is laid along a way.
pub(crate) struct Laid;

impl Behaviour for Laid {
    fn laid_apart_m(&self) -> Option<f64> {
        Some(APART_M)
    }

    fn replaces_oldest(&self) -> bool {
        true
    }
}

/// A place of a way, on the stretch that ends at one of those that were laid.
#[derive(Clone, Copy)]
struct Place {
    to: usize,
    at: DVec2,
}

/// The way back along breadcrumbs: to where their way is nearest, and from there on along it, to those that were laid before.
/// None where none is about, or the way's first one is reached.
pub(crate) fn way_back(world: &World, actors: &Actors) -> Option<FlagWay> {
    let eye = map_eye(actors.feet());
    let locator = Locator::new(&*world.strategy, &eye);
    let laid = map_of(actors, Item::Crumb, |id, it| {
        (id, locator.at(it.foot.point))
    });
    let place = (0..laid.len()).map(|from| nearest(&laid, from));
    let place = place.min_by(|a, b| a.at.length().total_cmp(&b.at.length()))?;
    let away_m = place.at.length();
    if away_m > FOUND_M {
        return None;
    }
    let Place { to, at } = if away_m > AHEAD_M {
        place
    } else {
        ahead(&laid, place)
    };
    let (id, next) = laid[to];
    let is_first = nearest(&laid, to).to == to;
    if is_first && next.length() < REACHED_M {
        return None;
    }
    Some(FlagWay {
        distance_m: next.length(),
        ..FlagWay::to(id, String::new(), at)
    })
}

fn nearest(laid: &[(ActorId, DVec2)], from: usize) -> Place {
    let own = laid[from].1;
    let Some(to) = before(laid, from) else {
        return Place { to: from, at: own };
    };
    let way = laid[to].1 - own;
    let share = -own.dot(way) / way.length_squared().max(f64::MIN_POSITIVE);
    let at = own + share.clamp(0.0, 1.0) * way;
    Place { to, at }
}

/// The one that a way came from: the one that was laid just before where that is next to it, and else, where somebody has gone back
/// along his way and left it elsewhere, the nearest that was laid before. None where that is far: another way begins.
fn before(laid: &[(ActorId, DVec2)], from: usize) -> Option<usize> {
    let away_m = |to: &usize| laid[*to].1.distance(laid[from].1);
    let last = from.checked_sub(1)?;
    if away_m(&last) <= NEXT_M {
        return Some(last);
    }
    let nearest = (0..from).min_by(|a, b| away_m(a).total_cmp(&away_m(b)));
    nearest.filter(|to| away_m(to) <= ONE_WAY_M)
}

/// The place that is [`AHEAD_M`] farther along the way.
fn ahead(laid: &[(ActorId, DVec2)], place: Place) -> Place {
    let Place { mut at, mut to } = place;
    let mut left_m = AHEAD_M;
    loop {
        let there = laid[to].1;
        let gap_m = there.distance(at);
        if gap_m >= left_m {
            let at = at + (there - at) * (left_m / gap_m);
            return Place { to, at };
        }
        let next = nearest(laid, to).to;
        if next == to {
            return Place { to, at: there };
        }
        (at, to, left_m) = (there, next, left_m - gap_m);
    }
}
