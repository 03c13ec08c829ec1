//! The light of lamps, of the flashlight and of cars.

use antipode_geometry::{ChartPoint, Eye, Map};
use glam::{DMat3, DVec3, DVec4};

use crate::aimed::ViewParams;
use crate::car;
use crate::crosshair::Crosshair;
use crate::door_light::light_through;
use crate::frame::{BeamLight, LampLight};
use crate::gun::muzzle_of;
use crate::moment::{Lit, Who};
use crate::scene::Scene;
use crate::situation::Situation;
use crate::{fixture, hand};
use antipode_items::Item;

/// Lamps that a picture shows.
const MOST_LIT: usize = 64;
/// Colour times strength of a lamp: warm.
const LAMP_COLOUR: [f32; 3] = [2.6, 1.9, 1.1];
/// Distance at which a lamp has faded away, metres.
const LAMP_RANGE_M: f64 = 12.0;
/// Colour times strength of the flashlight: nearly white.
const FLASH_COLOUR: [f32; 3] = [6.0, 6.0, 5.6];
/// Distance at which the flashlight has faded away, metres.
const FLASH_RANGE_M: f64 = 40.0;
/// It is dimmed to what is closer than that, metres, and at most to such a share: else a wall before the eyes is white.
const FLASH_FULL_M: f64 = 9.0;
const FLASH_LEAST: f64 = 0.22;
/// Angles from its middle within which it is full, and outside which there is none, radians.
const FLASH_CONE_RAD: (f64, f64) = (0.26, 0.52);
/// The flashlight is held this far below the eye and beside it, metres, so that what it lights has relief.
const FLASH_BESIDE_M: (f64, f64) = (0.22, -0.25);

/// Step of the derivative that tells how a way of the chart is seen, metres.
const STEP_M: f64 = 1e-3;

/// Where a lamp in the hand shines, from the eye: right, up and ahead, metres.
const HELD_LAMP_M: (f64, f64, f64) = (0.3, -0.2, 0.6);

/// The light on what an eye sees: the nearest lamps, and the flashlight.
pub(crate) fn lights(scene: &Scene, eye: &Eye) -> Lit {
    let now = scene.now();
    let strategy = &**scene.lens().strategy();
    let all = fixture::map(now.actors, |id, it| {
        let glow = it.glow();
        let away_m = || strategy.distance_m(eye.point, glow, eye);
        let who = Who::Fixture(it.item, id);
        it.item.shines().then(|| (away_m(), who, glow))
    });
    let mut lamps: Vec<_> = all.into_iter().flatten().collect();
    lamps.sort_by(|a, b| a.0.total_cmp(&b.0));
    let lamp_light = |(_, who, point)| (who, shining(point));
    let of_cars = car::lights::car_lights(now);
    let is_free = !now.actors.cars.is_driving();
    let params = scene.picturing();
    let muzzle = || muzzle_of(now.world, &now.head());
    let shot = hand::shot_light(&scene.shown.hand, muzzle);
    let holds_lamp = is_free && now.player.inventory.held().is_some_and(Item::shines);
    let in_hand = holds_lamp.then(|| shining(held_at(&now.head_through(&params))));
    let flashlight = is_free && now.player.flashlight;
    let beam = flashlight.then(|| (Who::InHand, flash_beam(now, &params, &scene.eye())));
    let mut lit = Lit {
        lamps: shot
            .map(|light| (Who::Shot, light))
            .into_iter()
            .chain(in_hand.map(|light| (Who::InHand, light)))
            .chain(of_cars.lamps)
            .chain(lamps.into_iter().map(lamp_light))
            .take(MOST_LIT)
            .collect(),
        beams: beam.into_iter().chain(of_cars.beams).collect(),
    };
    if let Some(doors) = &now.world.doors {
        let space = &*now.world.strategy;
        let beyond = light_through(space, doors, &lit);
        lit.beams
            .extend(beyond.into_iter().map(|it| (Who::Beyond, it)));
    }
    lit
}

/// The light of a lamp whose glass is there.
fn shining(point: ChartPoint) -> LampLight {
    LampLight {
        point,
        colour: LAMP_COLOUR,
        range_m: LAMP_RANGE_M,
    }
}

/// Where a lamp in the hand shines.
fn held_at(head: &Eye) -> ChartPoint {
    let (right_m, up_m, front_m) = HELD_LAMP_M;
    let off = head.right() * right_m + head.up() * up_m + head.front() * front_m;
    head.point.moved(off)
}

/// The flashlight lights what the crosshair covers, from wherever the picture is taken.
fn flash_beam(now: Situation<'_>, params: &ViewParams, eye: &Eye) -> BeamLight {
    let head = now.head_through(params);
    let (right_m, up_m) = FLASH_BESIDE_M;
    let point = head.point.moved(head.right() * right_m + head.up() * up_m);
    let crosshair = Crosshair::through(now, params.clone());
    let spot = crosshair.ground_or_figure(FLASH_RANGE_M);
    let way = way_toward(&*params.strategy, eye, point, spot.point);
    let near = (spot.distance_m / FLASH_FULL_M).clamp(FLASH_LEAST, 1.0) as f32;
    BeamLight {
        point,
        direction: way.unwrap_or(head.front()),
        colour: FLASH_COLOUR.map(|channel| channel * near),
        range_m: FLASH_RANGE_M,
        cone_rad: FLASH_CONE_RAD,
        behind: None,
    }
}

/// The way at `from`, a unit vector of its chart, in which the geodesic of an eye's picture to `to` sets out.
///
/// Geodesics are straight in `xyz / w` of view coordinates. With P for `from` and T for `to`, the one that passes through
/// both leaves P along `P.w T.xyz - T.w P.xyz`; so do the chart's axes there, with their derivatives for T.
fn way_toward(strategy: &dyn Map, eye: &Eye, from: ChartPoint, to: ChartPoint) -> Option<DVec3> {
    let at = strategy.view_point(eye, from);
    let seen = |toward: DVec4| at.w * toward.truncate() - toward.w * at.truncate();
    let axis = |axis: DVec3| {
        let beyond = |step_m: f64| strategy.view_point(eye, from.moved(axis * step_m));
        seen(beyond(STEP_M) - beyond(-STEP_M))
    };
    let axes = DMat3::from_cols(axis(DVec3::X), axis(DVec3::Y), axis(DVec3::Z));
    let way = axes.inverse() * seen(strategy.view_point(eye, to));
    way.try_normalize()
}
