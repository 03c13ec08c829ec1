//! Lamps: put down on the ground, picked up again, and falling when the ground below them goes.

use antipode_geometry::ChartPoint;
use glam::DVec3;

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
use crate::tuning::{LAMP_HEIGHT_M, LAMP_REACH_M, MOST_LAMPS, REACH_M, STEP_S};
use crate::world::World;
use antipode_items::Item;

/// Lamps within this of the player are looked after, in metres: further off nobody changes the ground.
const NEAR_M: f64 = 40.0;
/// How far up a lamp that was built over looks for air, and in what steps, in metres.
const DUG_OUT_M: f64 = 16.0;
const DUG_OUT_STEP_M: f64 = 0.25;
/// How far down a lamp can fall at once, in metres.
const FALLS_M: f64 = 128.0;

/// How far from the ground a lamp's glowing middle is kept, in metres. In the ground it would leave dark what it hangs
/// on; so its globe, 0.14 m in radius, just clears it.
const CLEAR_M: f64 = 0.22;
/// A wall or a ceiling that is no farther than this from the glowing middle holds a lamp, in metres.
const HOLDS_M: f64 = 0.34;
/// Ground with less than this upright in its unit normal is a wall or a ceiling.
const WALL_UP: f32 = 0.6;

/// Radius of the ball that shows where a lamp would hang, in metres: a little more than its globe.
const LAMP_MARKER_M: f64 = 0.2;

/// A lamp that was put down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Its foot.
    pub point: ChartPoint,
    /// The height that it falls to, metres.
    pub(crate) rests_m: f64,
    /// How fast it falls, m/s.
    pub(crate) fall_m_s: f64,
    /// Whether the ground may have changed where it stands.
    unchecked: bool,
}

impl Lamp {
    /// A lamp that stands.
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

    /// The middle of its glass.
    pub fn glow(&self) -> ChartPoint {
        self.point.moved(DVec3::Y * LAMP_HEIGHT_M)
    }
}

/// The left button puts a lamp down where the crosshair meets the ground, the right one picks up the lamp that it
/// covers.
pub(crate) fn use_in_hand(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    if player.inventory.held() != Some(Item::Lamp) {
        return;
    }
    let now = Situation::of(world, actors, player);
    let crosshair = Crosshair::aimed(now);
    if actions.primary && !player.primary_before {
        let place = place_under(world, &crosshair);
        put_down(actors, &mut player.inventory, outbox, place);
    } else if actions.secondary && !player.secondary_before {
        let lamp = crosshair.lamp(REACH_M);
        pick_up(actors, &mut player.inventory, outbox, lamp);
    }
}

/// Where a lamp would be put down: its foot, if there is ground in reach.
fn place_under(world: &World, crosshair: &Crosshair<'_>) -> Option<ChartPoint> {
    let spot = crosshair.ground_or_figure(LAMP_REACH_M);
    let normal = || world.ground.normal(spot.point).as_dvec3();
    spot.hit.then(|| clear_foot(spot.point, normal()))
}

/// Shows where the lamp in hand would be put down.
pub(crate) fn marker(now: Situation<'_>) -> Option<Marker> {
    let is_free = !now.actors.cars.is_driving();
    if !is_free || now.player.inventory.held() != Some(Item::Lamp) {
        return None;
    }
    let place = place_under(now.world, &Crosshair::aimed(now))?;
    Some(Marker {
        point: place.moved(DVec3::Y * LAMP_HEIGHT_M),
        radius_m: LAMP_MARKER_M,
        active: false,
        shape: MarkerShape::Ball,
    })
}

/// Whether the world can have one more.
pub(crate) fn has_room(actors: &Actors) -> bool {
    actors.count::<Lamp>() < MOST_LAMPS
}

fn put_down(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    place: Option<ChartPoint>,
) {
    let Some(place) = place else {
        outbox.hints.push(Hint::NoPlaceForLamp);
        return;
    };
    if !has_room(actors) {
        outbox.hints.push(Hint::TooManyLamps);
        return;
    }
    if inventory.spend(Item::Lamp) {
        actors.enter(Lamp::standing(place));
        outbox.sounds.push(SoundEvent::LampPlaced);
    }
}

/// The last lamp in hand is used up, and an empty hand picks nothing up; so one lamp kept in hand, or any in the
/// hotbar that is selected, is enough.
fn pick_up(
    actors: &mut Actors,
    inventory: &mut Inventory,
    outbox: &mut Outbox,
    lamp: Option<ActorId>,
) {
    let Some(id) = lamp else {
        outbox.hints.push(Hint::NoLampThere);
        return;
    };
    if inventory.give(Item::Lamp, 1) == 0 {
        actors.remove::<Lamp>(id);
        outbox.sounds.push(SoundEvent::LampTaken);
    } else {
        outbox.hints.push(Hint::NoRoom);
    }
}

/// Lets lamps fall whose ground is gone, and those that ground was built over come up.
pub(crate) fn step(world: &World, actors: &mut Actors) {
    let feet = actors.feet();
    for lamp in actors.ecs.query_mut::<&mut Lamp>() {
        // What is known of ground further off leaves out what once was changed there.
        let there = over(&*world.strategy, feet, lamp.point);
        let is_near = there.chart != feet.chart || there.pos.distance(feet.pos) < NEAR_M;
        if lamp.unchecked && is_near {
            lamp.rests_m = rest(&world.ground, lamp);
            lamp.unchecked = false;
        }
        lamp.fall(actors.tuning.gravity_m_s2);
    }
}

impl OnGround for Lamp {
    fn stands_at(&self) -> ChartPoint {
        self.point
    }

    fn is_falling(&self) -> bool {
        self.falls()
    }

    fn wake(&mut self) {
        self.unchecked = true;
    }
}

/// Where the foot of a lamp stands that is put on ground with this unit normal: there if it is level enough, and out from
/// a wall or down from a ceiling.
fn clear_foot(point: ChartPoint, normal: DVec3) -> ChartPoint {
    point.moved(normal * (CLEAR_M - LAMP_HEIGHT_M * normal.y).max(0.0))
}

/// Whether a lamp hangs on a wall or a ceiling.
fn hangs(ground: &Ground, lamp: &Lamp) -> bool {
    let glow = lamp.glow();
    let normal = ground.normal(glow);
    normal.y < WALL_UP
        && !ground.is_solid(glow)
        && ground.is_solid(glow.moved(normal.as_dvec3() * -HOLDS_M))
}

/// The height at which a lamp comes to rest: where it hangs, on the first ground below it, or above what was built over
/// it.
fn rest(ground: &Ground, lamp: &Lamp) -> f64 {
    if hangs(ground, lamp) {
        return lamp.point.pos.y;
    }
    let glow = lamp.glow();
    let is_solid = |point: ChartPoint| ground.is_solid(point);
    let steps = (DUG_OUT_M / DUG_OUT_STEP_M) as u32;
    let above = (0..steps).map(|step| glow.moved(DVec3::Y * (f64::from(step) * DUG_OUT_STEP_M)));
    let free = above
        .into_iter()
        .find(|point| !is_solid(*point))
        .unwrap_or(glow);
    height_below(free, FALLS_M, is_solid).unwrap_or(lamp.point.pos.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lamp_falls_to_its_rest_and_comes_up_at_once() {
        let mut lamp = Lamp::standing(ChartPoint::a(DVec3::new(3.0, 10.0, 4.0)));
        lamp.fall(20.0);
        assert_eq!(
            lamp,
            Lamp::standing(ChartPoint::a(DVec3::new(3.0, 10.0, 4.0)))
        );
        lamp.rests_m = 5.0;
        let mut steps = 0;
        while lamp.point.pos.y > 5.0 {
            lamp.fall(20.0);
            steps += 1;
        }
        // Five metres at 20 m/s^2 take 0.71 s.
        assert!((40..46).contains(&steps), "{steps}");
        assert_eq!(lamp.point.pos, DVec3::new(3.0, 5.0, 4.0));
        lamp.rests_m = 7.0;
        lamp.fall(20.0);
        assert_eq!(lamp.point.pos.y.to_bits(), 7.0f64.to_bits());
    }

    #[test]
    fn a_lamp_stands_on_level_ground_and_its_light_keeps_clear_of_walls_and_ceilings() {
        let spot = ChartPoint::a(DVec3::new(3.0, 10.0, 4.0));
        assert_eq!(clear_foot(spot, DVec3::new(0.6, 0.8, 0.0)), spot);
        for degrees in [0.0, 45.0, 70.0, 90.0, 120.0, 180.0_f64] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let normal = DVec3::new(sine, cosine, 0.0);
            let lamp = Lamp::standing(clear_foot(spot, normal));
            let clear = (lamp.glow().pos - spot.pos).dot(normal);
            assert!(clear > CLEAR_M - 1e-9, "{degrees}: {clear} m");
            let off = lamp.point.pos.distance(spot.pos);
            assert!(off < CLEAR_M + LAMP_HEIGHT_M + 1e-9, "{degrees}: {off} m");
        }
    }
}
