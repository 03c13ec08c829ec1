//! The gun as a player has it: what the crosshair covers in the curved picture is hit.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::common::{scene, steps};
use antipode_geometry::{ChartId, ChartPoint, Geometry, HyperbolicMap};
use antipode_scene::tuning::BOT_HEALTH;
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

/// Targets in each space.
const TARGETS: usize = 50;
/// Slots of the gun and of a pickaxe.
const GUN: u8 = 0;
const PICKAXE: u8 = 1;

fn slot(slot: u8) -> Actions {
    Actions {
        slot: Some(slot),
        ..Actions::default()
    }
}

/// Looks at a point as the picture shows it, and returns how far it is in the space.
fn look_at(scene: &mut Scene, point: ChartPoint) -> f64 {
    let mut away_m = 0.0;
    // In third person the camera would move with the look; a second round would then be needed.
    for _ in 0..2 {
        let eye = scene.eye();
        let strategy = scene.frame(1.3, 1.7, 1).view.strategy;
        let view = strategy.view_point(&eye, point);
        away_m = strategy.eye_distance_m(&eye, view);
        let way = eye.to_chart(view.truncate().normalize());
        scene.aim(way.z.atan2(way.x), way.y.clamp(-1.0, 1.0).asin());
    }
    away_m
}

/// Whether no ground is before a point: a pickaxe shows how far the view goes.
fn is_in_sight(scene: &mut Scene, point: ChartPoint) -> bool {
    let away_m = look_at(scene, point);
    steps(scene, 1, &slot(PICKAXE));
    let eye = scene.eye();
    let strategy = scene.frame(1.3, 1.7, 1).view.strategy;
    let seen_m = scene.marker().map_or(f64::INFINITY, |marker| {
        strategy.distance_m(eye.point, marker.point, &eye)
    });
    seen_m + 0.5 > away_m.min(antipode_scene::tuning::REACH_M)
}

/// Fires once at what is looked at, and waits until the bullet has flown; returns whether the last bot was hit.
fn fire_hits(scene: &mut Scene, id: u32) -> bool {
    steps(scene, 1, &slot(GUN));
    let pull = Actions {
        primary: true,
        ..Actions::default()
    };
    steps(scene, 1, &pull);
    for _ in 0..90 {
        let bots = scene.bots();
        let bot = bots.iter().find(|view| view.bot.id == id).unwrap();
        if bot.health < BOT_HEALTH {
            return true;
        }
        steps(scene, 1, &Actions::default());
    }
    false
}

/// Places around a spectator, by golden angles, each at its own distance, on the ground of whatever chart it is in.
fn places(scene: &Scene, around: ChartPoint, toward: impl Fn(usize) -> f64) -> Vec<ChartPoint> {
    let field = scene.field().clone();
    (0..8 * TARGETS)
        .map(|n| {
            let angle = toward(n);
            let level_m = 7.0 + 17.0 * ((n as f64) * 0.754_877_666).fract();
            let way = DVec3::new(angle.cos(), 0.0, angle.sin());
            let moved = around.moved(way * level_m);
            let place = scene.strategy().cross(moved).map_or(moved, |it| it.point);
            let y = field.surface_height(place.chart, place.pos.x, place.pos.z);
            ChartPoint::new(place.chart, place.pos.with_y(y + 0.1))
        })
        .collect()
}

/// Hovers at a place over the ground and shoots at one target after another; returns hits and shots.
fn hits(scene: &mut Scene, at: ChartPoint, toward: impl Fn(usize) -> f64) -> (usize, usize) {
    scene.set_npcs(NpcMode::Still);
    let field = scene.field().clone();
    let y = field.surface_height(at.chart, at.pos.x, at.pos.z) + 5.0;
    let stand = ChartPoint::new(at.chart, at.pos.with_y(y));
    scene.set_flying(true);
    scene.teleport(stand);
    steps(scene, 30, &Actions::default());
    let mut shots = 0;
    let mut hits = 0;
    for place in places(scene, stand, toward) {
        if shots == TARGETS {
            break;
        }
        let middle = place.moved(DVec3::Y * 0.9);
        if !is_in_sight(scene, middle) {
            continue;
        }
        let id = scene.spawn_bot(place, 0.0, false);
        steps(scene, 20, &Actions::default());
        let stands = scene
            .bots()
            .iter()
            .find(|it| it.bot.id == id)
            .unwrap()
            .point;
        let middle = stands.moved(DVec3::Y * 0.9);
        if is_in_sight(scene, middle) {
            look_at(scene, middle);
            scene.inventory_mut().give(antipode_scene::Item::Bullet, 1);
            shots += 1;
            let hit = fire_hits(scene, id);
            if !hit {
                eprintln!("missed {middle:?} from {:?}", scene.eye());
            }
            hits += usize::from(hit);
        }
    }
    (hits, shots)
}

fn golden(n: usize) -> f64 {
    (n as f64 * 0.618_033_988_75).fract() * TAU - PI
}

#[test]
fn every_target_under_the_crosshair_is_hit_in_flat_space() {
    let mut scene = scene(Geometry::Euclidean);
    let at = scene.feet();
    assert_eq!(hits(&mut scene, at, golden), (TARGETS, TARGETS));
}

#[test]
fn every_target_under_the_crosshair_is_hit_over_a_curved_horizon() {
    for map in [HyperbolicMap::Raised, HyperbolicMap::Horizon] {
        let mut scene = scene(Geometry::Hyperbolic);
        scene.set_map(map);
        scene.set_curvature(12.0);
        let at = scene.feet();
        assert_eq!(hits(&mut scene, at, golden), (TARGETS, TARGETS), "{map:?}");
    }
}

#[test]
fn every_target_under_the_crosshair_is_hit_on_a_sphere_and_over_its_equator() {
    let mut scene = scene(Geometry::Spherical);
    let at = scene.feet();
    assert_eq!(hits(&mut scene, at, golden), (TARGETS, TARGETS));
    let rim_m = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap();
    let angle = 0.7;
    let way = DVec3::new(f64::cos(angle), 0.0, f64::sin(angle));
    let before = ChartPoint::new(ChartId::FIRST, way * (rim_m - 4.0));
    let over = |n: usize| angle + (golden(n) / PI) * (FRAC_PI_2 * 0.55);
    assert_eq!(hits(&mut scene, before, over), (TARGETS, TARGETS));
}

#[test]
fn a_hit_is_told_at_once_and_a_miss_is_not() {
    let mut scene = scene(Geometry::Hyperbolic);
    steps(&mut scene, 30, &Actions::default());
    scene.aim(0.0, 1.2);
    let miss = slot(GUN);
    steps(&mut scene, 1, &miss);
    let pull = Actions {
        primary: true,
        ..Actions::default()
    };
    steps(&mut scene, 1, &pull);
    steps(&mut scene, 60, &Actions::default());
    assert_eq!(scene.struck_s_ago(), None);
    let at = scene.feet().moved(DVec3::new(3.0, 1.0, 0.0));
    let id = scene.spawn_bot(at, 0.0, false);
    steps(&mut scene, 60, &Actions::default());
    let stands = |scene: &Scene| {
        let bots = scene.bots();
        bots.iter().find(|it| it.bot.id == id).unwrap().point
    };
    let middle = stands(&scene).moved(DVec3::Y * 0.9);
    look_at(&mut scene, middle);
    assert!(fire_hits(&mut scene, id));
    assert!(scene.struck_s_ago().is_some_and(|ago_s| ago_s < 0.1));
}
