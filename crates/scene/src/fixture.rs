//! Fixtures: things that a hand puts down on the ground and takes up again. A fixture stays where it is, falls when the
//! ground below it disappears, and comes up when the player builds over it. All kinds are one component; what a kind does
//! besides is its `Behaviour`.

use antipode_geometry::ChartPoint;
use antipode_items::{Item, Stands};
use glam::DVec3;

use crate::actors::{ActorId, Actors};
use crate::ground::{Ground, height_below};
use crate::ground_changed::OnGround;
use crate::notice::Unfit;
use crate::npc::any_heading;
use crate::outbox::Outbox;
use crate::pick::over;
use crate::situation::Situation;
use crate::tuning::STEP_S;
use crate::world::World;
use crate::{crumb, door_place, flag, lamp};

mod hand;
mod solid;

pub(crate) use hand::{against, figure, foreseen, marker, use_in_hand};
pub(crate) use solid::Solids;

/// Those within this of the player are looked after, in metres: further off nobody changes the ground.
const NEAR_M: f64 = 40.0;
/// How far up what was built over looks for air, and in what steps, in metres.
const DUG_OUT_M: f64 = 16.0;
const DUG_OUT_STEP_M: f64 = 0.25;
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

/// Lets one more in, if the world can have it.
pub(crate) fn enter(actors: &mut Actors, it: Fixture) -> Option<ActorId> {
    has_room(actors, &it).then(|| actors.enter_fixture(it))
}

fn has_room(actors: &Actors, it: &Fixture) -> bool {
    let mut all = actors.ecs.query::<&Fixture>();
    let own = all.iter().filter(|other| other.item == it.item);
    own.count() < it.stands.most
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
