//! Fixtures: things that a hand puts down on the ground and takes up again. A fixture stays where it is, falls when the
//! ground below it disappears, and comes up when the player builds over it. All kinds are one component; what a kind does
//! besides is its `Behaviour`.

use antipode_geometry::{ChartPoint, Eye, LevelMap};
use antipode_items::{Item, Stands};
use glam::DVec3;
use hecs::Entity;

use crate::actions::Actions;
use crate::actors::{ActorId, Actors};
use crate::crosshair::Crosshair;
use crate::frame::{Figure, Marker, MarkerShape, Presence};
use crate::ground::{Ground, height_below};
use crate::ground_changed::OnGround;
use crate::inventory::Inventory;
use crate::notice::{Hint, Unfit};
use crate::npc::any_heading;
use crate::outbox::Outbox;
use crate::pick::{over, over_if_near};
use crate::player::Player;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::{FIXTURE_REACH_M, REACH_M, STEP_S};
use crate::world::World;
use crate::{crumb, door_place, felling, flag, lamp};

mod solid;

pub(crate) use solid::Solids;

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

/// Something that was put down. What is said of how it stands is its item's row of `assets/tables/items.ron`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fixture {
    /// What it is in a hand.
    pub item: Item,
    /// How it stands.
    pub(crate) stands: &'static Stands,
    /// Where it stands.
    pub foot: Foot,
    /// How it is turned from looking along +x, radians of its chart.
    pub yaw_rad: f64,
    /// Its name, as of [`flag::tidy_name`]; empty of what has none.
    pub name: String,
}

impl Fixture {
    /// One that stands at a point, turned to there, radians, or as all of its kind; none of what does not stand.
    pub(crate) fn standing(
        world: &World,
        item: Item,
        point: ChartPoint,
        yaw_rad: Option<f64>,
    ) -> Option<Self> {
        let as_all = || any_heading(&*world.strategy, point.chart, 0.0);
        Some(Self {
            item,
            stands: item.stands()?,
            foot: Foot::standing(point),
            yaw_rad: yaw_rad.unwrap_or_else(as_all),
            name: String::new(),
        })
    }

    /// The same of that name, as far as it can be one.
    #[must_use]
    pub(crate) fn named(mut self, name: &str) -> Self {
        self.name = flag::tidy_name(name);
        self
    }

    /// Its middle, from which it shines if it does.
    pub fn glow(&self) -> ChartPoint {
        self.foot.point.moved(DVec3::Y * self.stands.middle_m)
    }
}

/// What a kind does beyond standing where it was put. A new one has a file with its own, and its line in [`behaviour`].
pub(crate) trait Behaviour {
    /// Where its foot is if it is put on ground with this unit normal; none where it would not stay.
    fn foot_on(&self, stands: &Stands, spot: ChartPoint, normal: DVec3) -> Option<ChartPoint> {
        (normal.y >= stands.level_up).then_some(spot)
    }

    /// Whether something else than ground below it holds it.
    fn hangs(&self, _it: &Fixture, _ground: &Ground) -> bool {
        false
    }

    /// Does what the left button does with one that the crosshair covers; false where that is nothing.
    fn touch(&self, _id: ActorId, _outbox: &mut Outbox) -> bool {
        false
    }

    /// Why one cannot be put where it would stand, if there is anything against it.
    fn unfit(&self, _now: Situation<'_>, _it: &Fixture) -> Option<Unfit> {
        None
    }

    /// Whether it is shown as it would stand before it is put down.
    fn is_foreseen(&self) -> bool {
        false
    }

    /// How far from all others one has to be to put down one more at one's feet while the button is held, metres; none of what
    /// is put down one by one.
    fn laid_apart_m(&self) -> Option<f64> {
        None
    }

    /// Whether one more than the world can have moves the oldest, where others are refused.
    fn replaces_oldest(&self) -> bool {
        false
    }
}

/// What does nothing but stand.
struct Plain;

impl Behaviour for Plain {}

/// What those of an item do.
fn behaviour(item: Item) -> &'static dyn Behaviour {
    match item {
        Item::Lamp => &lamp::Clings,
        Item::Flag => &flag::Named,
        Item::Door => &door_place::Paired,
        Item::Crumb => &crumb::Laid,
        _ => &Plain,
    }
}

/// What is made of each that stands, by kinds, and of a kind in the order in which they came.
pub(crate) fn map<R>(actors: &Actors, make: impl Fn(ActorId, &Fixture) -> R) -> Vec<R> {
    let mut query = actors.ecs.query::<(&ActorId, &Fixture)>();
    let mut all: Vec<_> = query.iter().collect();
    all.sort_unstable_by_key(|(id, it)| (it.item, **id));
    all.into_iter().map(|(id, it)| make(*id, it)).collect()
}

/// The same of those of one kind.
pub(crate) fn map_of<R>(
    actors: &Actors,
    item: Item,
    make: impl Fn(ActorId, &Fixture) -> R,
) -> Vec<R> {
    let mut query = actors.ecs.query::<(&ActorId, &Fixture)>();
    let mut own: Vec<_> = query.iter().filter(|(_, it)| it.item == item).collect();
    own.sort_unstable_by_key(|(id, _)| **id);
    own.into_iter().map(|(id, it)| make(*id, it)).collect()
}

/// One of a kind, to be changed.
pub(crate) fn one_mut(actors: &mut Actors, item: Item, id: ActorId) -> Option<&mut Fixture> {
    let all = actors.ecs.query_mut::<(&ActorId, &mut Fixture)>();
    let mut found = all.into_iter().filter(|(_, it)| it.item == item);
    found.find(|(it, _)| **it == id).map(|(_, it)| it)
}

/// The left button puts one down where the crosshair meets the ground, the right one picks up the one that it covers: with
/// one in the hand, and what can be done with one that stands with an empty hand, too, for whoever has put down the last.
pub(crate) fn use_in_hand(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let held = player.inventory.held();
    if held.is_some_and(|item| item.stands().is_none()) {
        return;
    }
    let now = Situation::of(world, actors, player);
    let crosshair = Crosshair::aimed(now);
    let covered = || crosshair.fixture(held, REACH_M);
    if actions.primary && player.primary_before {
        if let Some(it) = held.and_then(|item| laid(now, item)) {
            put_down(actors, &mut player.inventory, outbox, it.item, Some(it));
            if player.inventory.held().is_none() {
                outbox.hints.extend(held.map(Hint::LastLaid));
            }
        }
    } else if actions.primary {
        if covered().is_some_and(|(item, id)| behaviour(item).touch(id, outbox)) {
            return;
        }
        let Some((item, stands)) = held.and_then(|item| Some((item, item.stands()?))) else {
            return;
        };
        match placing(now, &crosshair, item, stands) {
            Some((_, Some(unfit))) => outbox.hints.push(Hint::Unfit(unfit)),
            found => {
                let it = found.map(|(it, _)| it).or_else(|| laid(now, item));
                put_down(actors, &mut player.inventory, outbox, item, it);
            }
        }
    } else if actions.secondary && !player.secondary_before {
        match covered() {
            Some((item, id)) => pick_up(actors, &mut player.inventory, outbox, item, id),
            None => outbox.hints.extend(held.map(Hint::NoneThere)),
        }
    }
}

/// Of two solid things the middle lines are at least this share of both radii apart: so a row of them has no gaps. Nothing is
/// so stout that it reaches farther from its root, metres.
const APART: f64 = 0.75;
const THINGS_M: f64 = 4.0;

/// How one would stand if it were put down, and what is against it; none where no ground is in reach. Through a door it is put
/// on the other side.
fn placing(
    now: Situation<'_>,
    crosshair: &Crosshair<'_>,
    item: Item,
    stands: &Stands,
) -> Option<(Fixture, Option<Unfit>)> {
    let world = now.world;
    let spot = crosshair.ground_or_figure(FIXTURE_REACH_M);
    let normal = || world.ground.normal(spot.point).as_dvec3();
    let foot = || behaviour(item).foot_on(stands, spot.point, normal());
    let foot = spot.hit.then(foot).flatten()?;
    let it = put_at(world, &spot.eye, item, foot).filter(|it| !is_taken(now, it))?;
    let unfit = behaviour(item).unfit(now, &it);
    Some((it, unfit))
}

/// Whether something solid stands where one would come to rest: for what is solid itself trunks and boulders, too.
fn is_taken(now: Situation<'_>, it: &Fixture) -> bool {
    let (ground, own) = (&now.world.ground, it.stands);
    if behaviour(it.item).hangs(it, ground) {
        return false;
    }
    let mut foot = it.foot.point;
    if it.foot.unchecked {
        foot.pos.y = rest(ground, it);
    }
    let is_in = |root: ChartPoint, radius_m: f64, height_m: f64| {
        let root = over(&*now.world.strategy, foot, root);
        let by = root.pos - foot.pos;
        let apart_m = if own.is_solid {
            APART * (own.radius_m + radius_m)
        } else {
            radius_m
        };
        let heights_m = -height_m..own.heights_m[1];
        let is_beside = by.with_y(0.0).length() >= apart_m || !heights_m.contains(&by.y);
        root.chart == foot.chart && !is_beside
    };
    let mut others = now.actors.ecs.query::<&Fixture>();
    let is_other = |other: &Fixture| {
        let stands = other.stands;
        stands.is_solid && is_in(other.foot.point, stands.radius_m, stands.heights_m[1])
    };
    let is_thing = |thing: &felling::Standing| {
        let solid = thing.solid_m();
        solid.is_some_and(|(radius_m, high_m)| is_in(thing.root(), radius_m, high_m))
    };
    let things = || felling::solids_near(now.world, foot, THINGS_M);
    others.iter().any(is_other) || own.is_solid && things().iter().any(is_thing)
}

/// One of what is laid along a way, at the feet of who has left the others behind.
fn laid(now: Situation<'_>, item: Item) -> Option<Fixture> {
    let apart_m = behaviour(item).laid_apart_m()?;
    let feet = now.feet();
    let strategy = &*now.world.strategy;
    let level = |point: ChartPoint| ChartPoint::new(point.chart, point.pos.with_y(0.0));
    let eye = Eye {
        point: level(feet),
        ..Eye::default()
    };
    // Level: what is laid in the air falls. A metre of the space is no longer than one of a chart.
    let is_near = |other: &Fixture| {
        let there = over_if_near(strategy, feet, other.foot.point, apart_m);
        there.is_some_and(|there| {
            let by = level(there).pos.distance(eye.point.pos);
            there.chart == feet.chart
                && by < apart_m
                && strategy.distance_m(eye.point, level(there), &eye) < apart_m
        })
    };
    let mut others = now.actors.ecs.query::<&Fixture>();
    if others.iter().any(|it| it.item == item && is_near(it)) {
        return None;
    }
    drop(others);
    let mut it = Fixture::standing(now.world, item, feet, None)?;
    it.foot.unchecked = true;
    Some(it).filter(|it| !is_taken(now, it))
}

/// The same of what is in a free hand.
fn placing_held(now: Situation<'_>) -> Option<(Fixture, Option<Unfit>)> {
    if now.actors.cars.is_driving() {
        return None;
    }
    let item = now.player.inventory.held()?;
    placing(now, &Crosshair::aimed(now), item, item.stands()?)
}

/// Shows where the one in hand would be put down.
pub(crate) fn marker(now: Situation<'_>) -> Option<Marker> {
    let is_foreseen = |item| behaviour(item).is_foreseen();
    if now.player.inventory.held().is_some_and(is_foreseen) {
        return None;
    }
    let (it, _) = placing_held(now)?;
    Some(Marker {
        point: it.glow(),
        radius_m: it.stands.marker_m,
        active: false,
        shape: MarkerShape::Ball,
        ground: None,
    })
}

/// Shows how the one in hand would stand, of what is shown so.
pub(crate) fn foreseen(now: Situation<'_>) -> Option<Figure> {
    let held = now.player.inventory.held()?;
    if !behaviour(held).is_foreseen() {
        return None;
    }
    let (it, unfit) = placing_held(now)?;
    Some(Figure {
        presence: if unfit.is_none() {
            Presence::Possible
        } else {
            Presence::Barred
        },
        ..figure(now, &it)
    })
}

/// How one stands in a picture.
pub(crate) fn figure(now: Situation<'_>, it: &Fixture) -> Figure {
    let level = match it.item {
        // As what leads on from it.
        Item::Door => LevelMap::at(&*now.world.strategy, it.foot.point),
        _ => LevelMap::SAME,
    };
    Figure {
        level,
        ..Figure::standing(it.item.into(), it.foot.point, it.yaw_rad)
    }
}

/// What is against putting the one in hand where the crosshair is, of what is shown as it would stand.
pub(crate) fn against(now: Situation<'_>) -> Option<Unfit> {
    let held = now.player.inventory.held()?;
    if !behaviour(held).is_foreseen() {
        return None;
    }
    placing_held(now)?.1
}

/// Lets one more in, if the world can have it.
pub(crate) fn enter(actors: &mut Actors, it: Fixture) -> Option<ActorId> {
    has_room(actors, &it).then(|| actors.enter_fixture(it))
}

fn has_room(actors: &Actors, it: &Fixture) -> bool {
    let mut all = actors.ecs.query::<&Fixture>();
    let own = all.iter().filter(|other| other.item == it.item);
    own.count() < it.stands.most
}

/// One that is put at a place. On somebody's shoulders it falls in the next step.
fn put_at(world: &World, eye: &Eye, item: Item, place: ChartPoint) -> Option<Fixture> {
    let crossing = world.strategy.carry(eye.point, place.chart);
    let turn_rad = crossing.map_or(0.0, |crossing| crossing.turn_rad);
    let turned_deg = item.stands()?.turned_deg;
    let yaw_rad = turned_deg.map(|own_deg| eye.yaw - turn_rad + own_deg.to_radians());
    let mut it = Fixture::standing(world, item, place, yaw_rad)?;
    let below = place.moved(DVec3::NEG_Y * STANDS_OVER_M);
    it.foot.unchecked = !world.ground.is_solid(below);
    Some(it)
}

fn put_down(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    item: Item,
    it: Option<Fixture>,
) {
    let Some(it) = it else {
        outbox.hints.push(Hint::NoPlaceFor(item));
        return;
    };
    if !has_room(actors, &it) {
        if behaviour(item).replaces_oldest() {
            move_oldest(actors, outbox, it);
        } else {
            outbox.hints.push(Hint::TooMany(item));
        }
        return;
    }
    if inventory.spend(item) {
        actors.enter_fixture(it);
        outbox.sounds.push(SoundEvent::PutDown(item));
    }
}

/// Has the oldest of its kind stand there, as the newest; none is spent.
fn move_oldest(actors: &mut Actors, outbox: &mut Outbox, it: Fixture) {
    let item = it.item;
    let all = map_of(actors, item, |id, _| id);
    if let Some(oldest) = all.into_iter().min() {
        remove(actors, item, oldest);
    }
    actors.enter_fixture(it);
    outbox.hints.push(Hint::MovedOldest(item));
    outbox.sounds.push(SoundEvent::PutDown(item));
}

fn pick_up(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    item: Item,
    id: ActorId,
) {
    if inventory.give(item, 1) == 0 {
        remove(actors, item, id);
        outbox.sounds.push(SoundEvent::TakenUp(item));
    } else {
        outbox.hints.push(Hint::NoRoom);
    }
}

fn remove(actors: &mut Actors, item: Item, id: ActorId) {
    let mut all = actors.ecs.query::<(Entity, &ActorId, &Fixture)>();
    let mut own = all
        .iter()
        .filter(|(_, own, it)| it.item == item && **own == id);
    let found = own.next().map(|(entity, ..)| entity);
    drop(all);
    if let Some(entity) = found {
        // It was there a moment ago.
        let _ = actors.ecs.despawn(entity);
    }
}

/// Lets those fall whose ground is gone, and those that ground was built over come up.
pub(crate) fn step(world: &World, actors: &mut Actors) {
    let feet = actors.feet();
    for it in actors.ecs.query_mut::<&mut Fixture>() {
        // What is known of ground further off leaves out what once was changed there.
        let is_near = || {
            let there = over(&*world.strategy, feet, it.foot.point);
            there.chart != feet.chart || there.pos.distance(feet.pos) < NEAR_M
        };
        if it.foot.unchecked && is_near() {
            it.foot.rests_m = rest(&world.ground, it);
            it.foot.unchecked = false;
        }
        it.foot.fall(actors.tuning.gravity_m_s2);
    }
}

impl OnGround for Fixture {
    fn stands_at(&self) -> ChartPoint {
        self.foot.point
    }

    fn is_falling(&self) -> bool {
        self.foot.falls()
    }

    fn wake(&mut self) {
        self.foot.unchecked = true;
    }
}

/// The height at which one comes to rest: where it hangs, on the first ground below it, or above what was built over it.
fn rest(ground: &Ground, it: &Fixture) -> f64 {
    let point = it.foot.point;
    if behaviour(it.item).hangs(it, ground) {
        return point.pos.y;
    }
    let middle = it.glow();
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
mod tests;
