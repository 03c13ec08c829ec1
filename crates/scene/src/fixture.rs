//! Fixtures: things that a hand puts down on the ground and takes up again. A fixture stays where it is, falls when the
//! ground below it disappears, and comes up when the player builds over it.

use antipode_geometry::{ChartPoint, Eye};
use antipode_items::Item;
use glam::DVec3;
use hecs::Component;

use crate::actions::Actions;
use crate::actors::{ActorId, Actors};
use crate::crosshair::Crosshair;
use crate::frame::{Marker, MarkerShape};
use crate::ground::{Ground, height_below};
use crate::ground_changed::OnGround;
use crate::inventory::Inventory;
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::pick::over;
use crate::player::Player;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::{FIXTURE_REACH_M, REACH_M, STEP_S};
use crate::world::World;

/// Those within this of the player are looked after, in metres: further off nobody changes the ground.
const NEAR_M: f64 = 40.0;
/// How far up what was built over looks for air, and in what steps, in metres.
const DUG_OUT_M: f64 = 16.0;
const DUG_OUT_STEP_M: f64 = 0.25;
/// Ground that is no farther below a foot than this carries it, in metres.
const STANDS_OVER_M: f64 = 0.15;
/// How far down it can fall at once, in metres.
const FALLS_M: f64 = 128.0;

/// Where it stands, and how it falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// Where its foot is.
    pub point: ChartPoint,
    /// The height that it falls to, metres.
    pub(crate) rests_m: f64,
    /// How fast it falls, m/s.
    fall_m_s: f64,
    /// Whether the ground may have changed where it stands.
    unchecked: bool,
}

impl Foot {
    /// One that stands.
    pub fn standing(point: ChartPoint) -> Self {
        Self {
            point,
            rests_m: point.pos.y,
            fall_m_s: 0.0,
            unchecked: false,
        }
    }

    /// Moves it by one step towards its rest: down like all that falls, up at once.
    fn fall(&mut self, gravity_m_s2: f64) {
        let y = &mut self.point.pos.y;
        if *y <= self.rests_m {
            *y = self.rests_m;
            self.fall_m_s = 0.0;
            return;
        }
        self.fall_m_s += gravity_m_s2 * STEP_S;
        *y = (*y - self.fall_m_s * STEP_S).max(self.rests_m);
    }

    /// Whether it falls.
    pub(crate) fn falls(&self) -> bool {
        self.point.pos.y > self.rests_m
    }
}

/// The upright capsule within which the crosshair covers one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    /// From where to where it reaches, metres over the foot.
    pub heights_m: [f64; 2],
    pub radius_m: f64,
}

/// What the player is told of where nothing comes of a click.
pub(crate) struct Refusals {
    /// There is no ground for it in reach.
    pub no_place: Hint,
    /// The crosshair covers none.
    pub none_there: Hint,
    /// The world has as many as it can have.
    pub too_many: Hint,
}

/// A kind of what is put down.
pub(crate) trait Fixture: Component + Clone {
    /// What it is in a hand.
    const ITEM: Item;
    /// So many stand in a world at most.
    const MOST: usize;
    const TARGET: Target;
    /// A place over its foot that must be free of ground, metres.
    const MIDDLE_M: f64;
    /// Radius of the ball about that which shows where it would be put, metres.
    const MARKER_M: f64;
    const REFUSALS: Refusals;

    /// One that a player who looks along `yaw`, radians of that place's chart, has put there.
    fn put(foot: Foot, yaw: f64) -> Self;

    fn foot(&self) -> &Foot;

    fn foot_mut(&mut self) -> &mut Foot;

    /// Where its foot is if it is put on ground with this unit normal; none where it would not stay.
    fn foot_on(spot: ChartPoint, normal: DVec3) -> Option<ChartPoint>;

    /// Whether something else than ground below it holds it.
    fn hangs(&self, _ground: &Ground) -> bool {
        false
    }

    /// Does what the left button does with one that the crosshair covers; false where that is nothing.
    fn touch(_id: ActorId, _outbox: &mut Outbox) -> bool {
        false
    }
}

/// The left button puts one down where the crosshair meets the ground, the right one picks up the one that it covers: with
/// one in the hand, and what can be done with one that stands with an empty hand, too, for whoever has put down the last.
pub(crate) fn use_in_hand<T: Fixture>(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let held = player.inventory.held();
    if held.is_some_and(|it| it != T::ITEM) {
        return;
    }
    let now = Situation::of(world, actors, player);
    let crosshair = Crosshair::aimed(now);
    if actions.primary && !player.primary_before {
        let covered = crosshair.fixture::<T>(REACH_M);
        if covered.is_some_and(|id| T::touch(id, outbox)) {
            return;
        }
        if held.is_none() {
            return;
        }
        let place = place_under::<T>(world, &crosshair);
        let it = place.map(|place| put_at::<T>(world, &now.head(), place));
        put_down(actors, &mut player.inventory, outbox, it);
    } else if actions.secondary && !player.secondary_before {
        let covered = crosshair.fixture::<T>(REACH_M);
        if held.is_none() && covered.is_none() {
            return;
        }
        pick_up::<T>(actors, &mut player.inventory, outbox, covered);
    }
}

/// Where one would be put down: its foot, if there is ground for it in reach.
fn place_under<T: Fixture>(world: &World, crosshair: &Crosshair<'_>) -> Option<ChartPoint> {
    let spot = crosshair.ground_or_figure(FIXTURE_REACH_M);
    let normal = || world.ground.normal(spot.point).as_dvec3();
    spot.hit.then(|| T::foot_on(spot.point, normal())).flatten()
}

/// Shows where the one in hand would be put down.
pub(crate) fn marker<T: Fixture>(now: Situation<'_>) -> Option<Marker> {
    let is_free = !now.actors.cars.is_driving();
    if !is_free || now.player.inventory.held() != Some(T::ITEM) {
        return None;
    }
    let place = place_under::<T>(now.world, &Crosshair::aimed(now))?;
    Some(Marker {
        point: place.moved(DVec3::Y * T::MIDDLE_M),
        radius_m: T::MARKER_M,
        active: false,
        shape: MarkerShape::Ball,
    })
}

/// Lets one more in where a foot is put, if the world can have it.
pub(crate) fn enter<T: Fixture>(actors: &mut Actors, it: T) -> Option<ActorId> {
    has_room::<T>(actors).then(|| actors.enter(it))
}

fn has_room<T: Fixture>(actors: &Actors) -> bool {
    actors.count::<T>() < T::MOST
}

/// One that is put at a place. On somebody's shoulders it falls in the next step.
fn put_at<T: Fixture>(world: &World, head: &Eye, place: ChartPoint) -> T {
    let below = place.moved(DVec3::NEG_Y * STANDS_OVER_M);
    let foot = Foot {
        unchecked: !world.ground.is_solid(below),
        ..Foot::standing(place)
    };
    let crossing = world.strategy.carry(head.point, place.chart);
    let turn_rad = crossing.map_or(0.0, |crossing| crossing.turn_rad);
    T::put(foot, head.yaw - turn_rad)
}

fn put_down<T: Fixture>(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    it: Option<T>,
) {
    let Some(it) = it else {
        outbox.hints.push(T::REFUSALS.no_place);
        return;
    };
    if !has_room::<T>(actors) {
        outbox.hints.push(T::REFUSALS.too_many);
        return;
    }
    if inventory.spend(T::ITEM) {
        actors.enter(it);
        outbox.sounds.push(SoundEvent::PutDown(T::ITEM));
    }
}

fn pick_up<T: Fixture>(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    covered: Option<ActorId>,
) {
    let Some(id) = covered else {
        outbox.hints.push(T::REFUSALS.none_there);
        return;
    };
    if inventory.give(T::ITEM, 1) == 0 {
        actors.remove::<T>(id);
        outbox.sounds.push(SoundEvent::TakenUp(T::ITEM));
    } else {
        outbox.hints.push(Hint::NoRoom);
    }
}

/// Lets those fall whose ground is gone, and those that ground was built over come up.
pub(crate) fn step<T: Fixture>(world: &World, actors: &mut Actors) {
    let feet = actors.feet();
    for it in actors.ecs.query_mut::<&mut T>() {
        // What is known of ground further off leaves out what once was changed there.
        let there = over(&*world.strategy, feet, it.foot().point);
        let is_near = there.chart != feet.chart || there.pos.distance(feet.pos) < NEAR_M;
        if it.foot().unchecked && is_near {
            let rests_m = rest(&world.ground, it);
            let foot = it.foot_mut();
            foot.rests_m = rests_m;
            foot.unchecked = false;
        }
        it.foot_mut().fall(actors.tuning.gravity_m_s2);
    }
}

impl<T: Fixture> OnGround for T {
    fn stands_at(&self) -> ChartPoint {
        self.foot().point
    }

    fn is_falling(&self) -> bool {
        self.foot().falls()
    }

    fn wake(&mut self) {
        self.foot_mut().unchecked = true;
    }
}

/// The height at which one comes to rest: where it hangs, on the first ground below it, or above what was built over it.
fn rest<T: Fixture>(ground: &Ground, it: &T) -> f64 {
    let point = it.foot().point;
    if it.hangs(ground) {
        return point.pos.y;
    }
    let middle = point.moved(DVec3::Y * T::MIDDLE_M);
    let is_solid = |point: ChartPoint| ground.is_solid(point);
    let steps = (DUG_OUT_M / DUG_OUT_STEP_M) as u32;
    let above = (0..steps).map(|step| middle.moved(DVec3::Y * (f64::from(step) * DUG_OUT_STEP_M)));
    let free = above
        .into_iter()
        .find(|point| !is_solid(*point))
        .unwrap_or(middle);
    height_below(free, FALLS_M, is_solid).unwrap_or(point.pos.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_falls_to_its_rest_and_comes_up_at_once() {
        let mut foot = Foot::standing(ChartPoint::a(DVec3::new(3.0, 10.0, 4.0)));
        foot.fall(20.0);
        assert_eq!(
            foot,
            Foot::standing(ChartPoint::a(DVec3::new(3.0, 10.0, 4.0)))
        );
        foot.rests_m = 5.0;
        let mut steps = 0;
        while foot.point.pos.y > 5.0 {
            foot.fall(20.0);
            steps += 1;
        }
        // Five metres at 20 m/s^2 take 0.71 s.
        assert!((40..46).contains(&steps), "{steps}");
        assert_eq!(foot.point.pos, DVec3::new(3.0, 5.0, 4.0));
        foot.rests_m = 7.0;
        foot.fall(20.0);
        assert_eq!(foot.point.pos.y.to_bits(), 7.0f64.to_bits());
    }
}
