//! Seeds: the hand puts one into soft ground, and it becomes a tree of the land there (`planted.rs`).

use antipode_geometry::ChartPoint;
use antipode_items::Item;
use antipode_plants::tree_at;
use antipode_streaming::BELOW_ROOT_M;
use glam::DVec3;

use crate::actions::Actions;
use crate::actors::Actors;
use crate::crosshair::Crosshair;
use crate::felling;
use crate::frame::{Marker, MarkerShape};
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::player::Player;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::FIXTURE_REACH_M;
use crate::world::World;

/// Ground is level enough for a tree where its unit normal has so much upright.
const LEVEL: f64 = 0.8;
/// No other trunk is so near, metres.
const APART_M: f64 = 1.2;
/// So high above it there is to be air, metres, looked for at each of them.
const AIR_M: [f64; 3] = [1.0, 2.0, 3.0];
/// Ground is so much deeper than what a tree goes with, metres: else the next dig near by would fell it.
const DEEPER_M: f64 = 0.2;
/// Radius of the ball that shows where a seed would go, metres.
const MARKER_M: f64 = 0.08;

/// Where the seed in hand would go, and whether one would grow there; none where no ground is in reach.
fn bed(now: Situation<'_>) -> Option<(ChartPoint, bool)> {
    let world = now.world;
    let spot = Crosshair::aimed(now).ground(FIXTURE_REACH_M);
    if !spot.hit {
        return None;
    }
    let crossing = world.strategy.cross(spot.point);
    let point = crossing.map_or(spot.point, |crossing| crossing.point);
    let is_solid = |up_m: f64| world.ground.is_solid(point.moved(DVec3::Y * up_m));
    let is_level = f64::from(world.ground.normal(point).y) >= LEVEL;
    let is_soft = world.ground.kind(point).hardness() == 0;
    // Not on something that was put up.
    let is_deep =
        is_solid(-DEEPER_M) && is_solid(-BELOW_ROOT_M) && is_solid(-BELOW_ROOT_M - DEEPER_M);
    let has_air = AIR_M.iter().all(|up_m| !is_solid(*up_m));
    let is_alone = felling::solids_near(world, point, APART_M).is_empty()
        && !world.planted.is_near(world, point, APART_M);
    Some((point, is_level && is_soft && is_deep && has_air && is_alone))
}

fn is_in_hand(now: Situation<'_>) -> bool {
    now.player.inventory.held() == Some(Item::Seed) && !now.actors.cars.is_driving()
}

/// Shows where the seed in hand would go.
pub(crate) fn marker(now: Situation<'_>) -> Option<Marker> {
    let (point, _) = is_in_hand(now).then(|| bed(now)).flatten()?;
    Some(Marker {
        point,
        radius_m: MARKER_M,
        active: false,
        shape: MarkerShape::Ball,
        ground: None,
    })
}

/// The left button puts the seed in hand into the ground under the crosshair, where it becomes a tree of that land.
pub(crate) fn use_in_hand(
    world: &mut World,
    actors: &Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let now = Situation::of(world, actors, player);
    if !actions.primary || player.primary_before || !is_in_hand(now) {
        return;
    }
    let Some((point, true)) = bed(now) else {
        outbox.hints.push(Hint::NoPlaceFor(Item::Seed));
        return;
    };
    let share = (point.pos.x * 0.37 + point.pos.z * 0.61).rem_euclid(1.0);
    let species = tree_at(world.ground.field(), point, share as f32);
    let (id, now_s) = (world.planted.number(), world.simulated_s);
    let added = world
        .planted
        .add((id, point, species), (now_s, None), now_s);
    let Some((coord, thing)) = added else {
        outbox.hints.push(Hint::TooMany(Item::Seed));
        return;
    };
    player.inventory.spend(Item::Seed);
    world.streamer.plant(coord, thing);
    outbox.sounds.push(SoundEvent::PutDown(Item::Seed));
}

/// Lets what was planted grow.
pub(crate) fn step(world: &mut World) {
    let now_s = world.simulated_s;
    world
        .planted
        .grow(&mut world.streamer, &world.ground, now_s);
}
