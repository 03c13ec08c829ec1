//! What happens about the tip of a cone, where three charts meet and who goes round is turned: the rules of the world know
//! nothing of it but what the atlas says.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, Eye, Geometry, Metric};
use antipode_scene::probe::BotProbe;
use antipode_scene::{Actions, NpcMode, Scene, WorldSetup};
use antipode_storage::WorldStore;
use antipode_terrain::Field;
use antipode_testing::cone::Cone;
use glam::DVec3;

use crate::common::figures::{SECOND, bot, look_at, shoot};
use crate::common::{LIMIT, setup, steps};

/// All the way round the tip, radians.
const ROUND_RAD: f64 = 3.0 * FRAC_PI_2;
/// Ground is not missed by more than this, metres.
const SUNK_M: f64 = 0.4;

fn open(store: Option<WorldStore>) -> Scene {
    let (setup, store) = (setup(Geometry::Euclidean), store.map(Arc::new));
    let mut scene = Scene::open_in(Arc::new(Cone), setup, store, 2).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// A place so far over the untouched ground.
fn over_ground(angle_rad: f64, away_m: f64, over_m: f64) -> ChartPoint {
    let at = Cone::around(angle_rad, away_m, 0.0);
    let WorldSetup {
        generator, seed, ..
    } = setup(Geometry::Euclidean);
    let field = Field::made_by(generator, seed, Arc::new(Cone));
    let height_m = field.surface_height(at.chart, at.pos.x, at.pos.z);
    at.moved(DVec3::Y * (height_m + over_m))
}

fn stand(scene: &mut Scene, angle_rad: f64, away_m: f64) {
    scene.teleport(over_ground(angle_rad, away_m, 0.2));
    assert!(scene.wait_for_step(LIMIT));
    steps(scene, SECOND / 2, &still());
}

fn still() -> Actions {
    Actions::default()
}

fn apart_m(a: ChartPoint, b: ChartPoint) -> f64 {
    let eye = Eye {
        point: a,
        ..Eye::default()
    };
    Cone.distance_m(a, b, &eye)
}

/// The heading from one place to another, by the shorter side of the tip.
fn facing(from: ChartPoint, to: ChartPoint) -> f64 {
    let way = Cone.carry_near(to, from).unwrap().point.pos - from.pos;
    way.z.atan2(way.x)
}

fn wrap(angle_rad: f64) -> f64 {
    (angle_rad + PI).rem_euclid(2.0 * PI) - PI
}

/// Turned only by what is asked for, the player comes to where he began after three quarters of a turn.
#[test]
fn who_walks_round_the_tip_is_back_after_three_quarters_of_a_turn() {
    for way in [1.0, -1.0] {
        let mut scene = open(None);
        stand(&mut scene, 0.7, 6.0);
        scene.aim(0.7 + way * FRAC_PI_2, 0.0);
        let (mut turned_rad, mut gone_rad, mut charts) = (0.0, 0.0, Vec::new());
        let mut angle_before = 0.7;
        for _ in 0..60 * SECOND {
            let feet = scene.feet();
            let (x, z) = (feet.pos.x, feet.pos.z);
            let own_rad = z.atan2(x);
            let tangent = own_rad + way * FRAC_PI_2;
            // Towards the circle of 6 m.
            let wanted = tangent - way * (0.3 * (6.0 - x.hypot(z))).clamp(-0.8, 0.8);
            let look_yaw = wrap(wanted - scene.head().yaw).clamp(-0.05, 0.05);
            let walk = Actions {
                forward: 1.0,
                jump: true,
                look_yaw,
                ..still()
            };
            steps(&mut scene, 1, &walk);
            turned_rad += look_yaw;
            let feet = scene.feet();
            let angle =
                feet.pos.z.atan2(feet.pos.x) + f64::from(Cone::quarter(feet.chart)) * FRAC_PI_2;
            gone_rad +=
                (angle - angle_before + 0.5 * ROUND_RAD).rem_euclid(ROUND_RAD) - 0.5 * ROUND_RAD;
            angle_before = angle;
            if charts.last() != Some(&feet.chart) {
                charts.push(feet.chart);
            }
            if gone_rad * way >= ROUND_RAD {
                break;
            }
        }
        assert!(gone_rad * way >= ROUND_RAD, "{gone_rad} of {ROUND_RAD}");
        assert_eq!(charts.len(), 4, "{charts:?}");
        assert_eq!(charts.iter().collect::<BTreeSet<_>>().len(), 3);
        let off_rad = (turned_rad * way - ROUND_RAD).abs();
        assert!(off_rad < 0.7, "turned by {turned_rad}, not by {ROUND_RAD}");
    }
}

/// Places about the tip: in every quarter, on every edge, behind and at the tip itself.
fn about_the_tip() -> Vec<(f64, f64)> {
    let ring = |away_m: f64, count: i32| {
        (0..count).map(move |n| (f64::from(n) * ROUND_RAD / f64::from(count), away_m))
    };
    let mut places: Vec<_> = ring(0.05, 3).chain(ring(0.3, 6)).collect();
    places.extend(ring(1.2, 9).chain(ring(2.5, 9)).chain(ring(3.9, 12)));
    places
}

/// The height of what can be touched below a place: down to the first ground that is there, dug or built.
fn floor_m(scene: &mut Scene, angle_rad: f64, away_m: f64) -> f64 {
    scene.set_flying(true);
    scene.teleport(over_ground(angle_rad, away_m, 6.0));
    assert!(scene.wait_for_step(LIMIT));
    steps(scene, 1, &still());
    let floor_m = scene.ground_height().expect("ground below");
    scene.set_flying(false);
    floor_m
}

fn dig_and_build_at_the_tip(scene: &mut Scene) {
    for (angle_rad, build) in [(0.1, false), (1.7, true), (3.4, false)] {
        stand(scene, angle_rad, 2.0);
        look_at(scene, over_ground(angle_rad + 0.4, 1.4, 0.0));
        for step in 0..90 {
            let work = Actions {
                slot: (step == 0).then_some(2),
                primary: !build,
                secondary: build,
                ..still()
            };
            steps(scene, 1, &work);
        }
    }
    assert!(scene.probe().chunks.edited >= 3);
}

#[test]
fn nothing_falls_through_near_the_tip_where_it_was_dug_and_built() {
    let mut scene = open(None);
    dig_and_build_at_the_tip(&mut scene);
    scene.set_npcs(NpcMode::Still);
    let mut floors = Vec::new();
    for (angle_rad, away_m) in about_the_tip() {
        floors.push(floor_m(&mut scene, angle_rad, away_m));
    }
    let mut fallen = [0; 2];
    let lowest_m = floors.iter().copied().fold(f64::MAX, f64::min) - SUNK_M;
    for ((angle_rad, away_m), floor_m) in about_the_tip().into_iter().zip(floors) {
        let at = Cone::around(angle_rad, away_m, floor_m + 2.5);
        scene.teleport(at);
        assert!(scene.wait_for_step(LIMIT));
        scene.throw_bullet(at, DVec3::new(0.4, -12.0, 0.3));
        scene.aim(angle_rad, -1.4);
        let drop = Actions {
            drop_one: true,
            ..still()
        };
        steps(&mut scene, 1, &drop);
        for _ in 0..3 * SECOND {
            steps(&mut scene, 1, &still());
            let feet = scene.feet();
            assert!(feet.pos.y > lowest_m, "{angle_rad} {away_m}: {feet:?}");
            for drop in scene.drops() {
                assert!(drop.point.pos.y > lowest_m, "{angle_rad} {drop:?}");
                fallen[0] += 1;
            }
            for (_, bullet) in scene.projectiles() {
                assert!(bullet.point.pos.y > lowest_m, "{angle_rad} {bullet:?}");
                fallen[1] += 1;
            }
        }
        let (feet, ground_m) = (scene.feet(), scene.ground_height());
        let ground_m = ground_m.expect("ground below the player");
        assert!((feet.pos.y - ground_m).abs() < 1.0, "{feet:?} {ground_m}");
    }
    assert!(fallen.iter().all(|count| *count > 1000), "{fallen:?}");
}

#[test]
fn a_hole_at_the_tip_is_found_from_all_three_charts() {
    let mut scene = open(None);
    stand(&mut scene, 0.8, 1.6);
    look_at(&mut scene, over_ground(0.8, 0.1, -0.5));
    for step in 0..150 {
        let dig = Actions {
            slot: (step == 0).then_some(2),
            primary: true,
            ..still()
        };
        steps(&mut scene, 1, &dig);
    }
    let mut charts = BTreeSet::new();
    for quarter in 0..3 {
        let angle_rad = (f64::from(quarter) + 0.5) * FRAC_PI_2;
        let before_m = over_ground(angle_rad, 0.3, 0.0).pos.y;
        let deep_m = before_m - floor_m(&mut scene, angle_rad, 0.3);
        assert!(deep_m > 0.7, "{quarter}: {deep_m} m");
        charts.insert(scene.feet().chart);
        // A player who comes down there stands in it.
        scene.teleport(Cone::around(angle_rad, 0.3, before_m));
        assert!(scene.wait_for_step(LIMIT));
        steps(&mut scene, 2 * SECOND, &still());
        assert!(scene.feet().pos.y < before_m - 0.4, "{:?}", scene.feet());
    }
    assert_eq!(charts.len(), 3);
}

#[test]
fn figures_that_come_down_near_the_tip_stand_there() {
    let mut scene = open(None);
    dig_and_build_at_the_tip(&mut scene);
    stand(&mut scene, 0.8, 7.0);
    scene.set_npcs(NpcMode::Still);
    let places = about_the_tip();
    for &(angle_rad, away_m) in &places {
        scene.spawn_bot(over_ground(angle_rad, away_m, 3.0), 0.3, false);
    }
    steps(&mut scene, 4 * SECOND, &still());
    let bots = scene.bots();
    assert_eq!(bots.len(), places.len());
    for bot in bots {
        let under = bot.point.moved(DVec3::Y * 0.5);
        scene.set_flying(true);
        scene.teleport(under);
        assert!(scene.wait_for_step(LIMIT));
        let ground_m = scene.ground_height().expect("ground below");
        let sunk_m = ground_m - bot.point.pos.y;
        assert!(sunk_m.abs() < SUNK_M, "{bot:?} {ground_m}");
    }
}

#[test]
fn a_shot_by_either_side_of_the_tip_goes_from_chart_to_chart_and_hits() {
    let places = [(0.3, 1.9), (0.3, -1.9), (2.9, 2.2), (1.5, 0.4), (1.6, -0.2)];
    let straight_and_falling = places.map(|place| [(place, true), (place, false)]).concat();
    for ((from_rad, aside_rad), straight) in straight_and_falling {
        let mut scene = open(None);
        scene.set_npcs(NpcMode::Still);
        scene.set_straight_shots(straight);
        // Over the ground, where no hill is in the way.
        let high_m = 9.0;
        let stands = |scene: &mut Scene, angle_rad: f64| {
            let at = over_ground(angle_rad, 5.0, high_m);
            scene.spawn_bot(at, 0.0, false)
        };
        scene.set_flying(true);
        scene.teleport(over_ground(from_rad, 6.0, high_m));
        assert!(scene.wait_for_step(LIMIT));
        let id = stands(&mut scene, from_rad + aside_rad);
        let before = bot(&scene, id);
        assert_ne!(before.point.chart, scene.feet().chart);
        shoot(&mut scene, id);
        let told = format!("{from_rad} {aside_rad} straight {straight}");
        assert!(scene.struck_s_ago().is_some(), "{told}");
        assert!(bot(&scene, id).health < before.health, "{told}");
    }
}

#[test]
fn who_fights_sees_over_every_edge_and_comes_by_the_shorter_side_of_the_tip() {
    for (player_rad, aside_rad) in [(0.4, -1.8), (0.4, 1.8), (2.0, 1.6), (4.4, 1.9)] {
        let mut scene = open(None);
        stand(&mut scene, player_rad, 7.0);
        scene.set_npcs(NpcMode::On);
        let at = over_ground(player_rad + aside_rad, 9.0, 0.2);
        let id = scene.spawn_bot(at, facing(at, scene.feet()), true);
        let start_m = apart_m(scene.feet(), at);
        let (mut hurt, mut nearest_m, mut charts) = (false, f64::MAX, BTreeSet::new());
        for _ in 0..20 * SECOND {
            hurt |= scene.health() < 20.0;
            scene.set_health(20.0);
            steps(&mut scene, 1, &still());
            let Some(view) = scene.bots().into_iter().find(|view| view.bot.id == id) else {
                break;
            };
            nearest_m = nearest_m.min(apart_m(scene.feet(), view.point));
            charts.insert(view.point.chart);
        }
        assert!(
            hurt || nearest_m < 0.6 * start_m,
            "{player_rad} {aside_rad}: {hurt} {nearest_m} of {start_m} m in {charts:?}"
        );
        assert!(hurt, "{player_rad} {aside_rad}: nobody fired");
    }
}

#[test]
fn a_car_drives_over_every_edge() {
    for edge in 0..3 {
        let angle_rad = f64::from(edge) * FRAC_PI_2 - 0.35;
        let mut scene = open(None);
        let at = over_ground(angle_rad, 14.0, 0.8);
        stand(&mut scene, angle_rad, 14.0 + 2.4);
        let yaw = at.pos.z.atan2(at.pos.x) + FRAC_PI_2;
        assert!(scene.spawn_car(at, yaw));
        steps(&mut scene, 2 * SECOND, &still());
        let car = scene.cars()[0];
        let right = (car.turn * DVec3::Z).with_y(0.0).normalize();
        scene.teleport(car.point.moved(right * 2.0 + DVec3::Y * 0.4));
        assert!(scene.wait_for_step(LIMIT));
        steps(&mut scene, SECOND / 2, &still());
        let roof = scene.cars()[0].point.moved(DVec3::Y * 0.7);
        look_at(&mut scene, roof);
        let enter = Actions {
            enter_car: true,
            ..still()
        };
        steps(&mut scene, 1, &enter);
        assert!(scene.is_driving(), "{:?}", scene.take_hints());
        let mut charts: Vec<ChartId> = vec![scene.cars()[0].point.chart];
        let mut last = scene.cars()[0];
        for _ in 0..6 * SECOND {
            let drive = Actions {
                forward: 0.7,
                ..still()
            };
            steps(&mut scene, 1, &drive);
            let car = scene.cars()[0];
            let jump_m = apart_m(last.point, car.point);
            assert!(jump_m < 0.6, "{jump_m} m in a step");
            let speeds = [last.velocity.length(), car.velocity.length()];
            assert!((speeds[0] - speeds[1]).abs() < 5.0, "{speeds:?}");
            let ground_m = scene.ground_height().expect("ground below the car");
            assert!(car.point.pos.y > ground_m - 1.5, "{car:?} {ground_m}");
            if charts.last() != Some(&car.point.chart) {
                charts.push(car.point.chart);
            }
            last = car;
        }
        assert!(charts.len() > 1, "{edge}: {charts:?}");
        assert_eq!(charts[1], Cone::chart(edge), "{charts:?}");
    }
}

/// A body, a lamp and a thing that lie on the far side of an edge are met and picked up from this one.
#[test]
fn a_lamp_and_a_thing_lie_across_an_edge() {
    let mut scene = open(None);
    for (angle_rad, away_m) in [(FRAC_PI_2, 8.0), (0.0, 3.0), (2.0 * FRAC_PI_2, 1.0)] {
        let across = over_ground(angle_rad + 0.3 / away_m, away_m, 0.05);
        let here = over_ground(angle_rad - 0.5 / away_m, away_m, 0.2);
        assert!(across.chart != here.chart || away_m < 2.0);
        let lamps = scene.lamps().len();
        assert!(scene.spawn_lamp(across));
        assert_eq!(scene.lamps().len(), lamps + 1);
        scene.teleport(here);
        assert!(scene.wait_for_step(LIMIT));
        steps(&mut scene, SECOND, &still());
        let lamp = scene.lamps().remove(lamps);
        assert!(
            apart_m(lamp.foot.point, across) < 1.0,
            "{lamp:?} {across:?}"
        );
        look_at(&mut scene, lamp.glow());
        let take = Actions {
            slot: Some(5),
            secondary: true,
            ..still()
        };
        steps(&mut scene, 2, &take);
        assert_eq!(scene.lamps().len(), lamps, "it is taken up over the edge");
        // What is thrown over the edge lies there and is picked up by coming near.
        look_at(&mut scene, across);
        let drop = Actions {
            slot: Some(5),
            drop_one: true,
            ..still()
        };
        steps(&mut scene, 1, &drop);
        assert_eq!(scene.drops().len(), 1);
        steps(&mut scene, 4 * SECOND, &still());
        let lies = scene.drops();
        if let Some(drop) = lies.first() {
            scene.teleport(drop.point.moved(DVec3::new(0.0, 0.3, 0.0)));
            steps(&mut scene, SECOND, &still());
        }
        assert!(scene.drops().is_empty());
    }
}

#[test]
fn what_was_left_about_the_tip_comes_back_from_its_save() {
    let kept = tempfile::tempdir().unwrap();
    let dir = kept.path().join("world");
    let meta = setup(Geometry::Euclidean).to_meta();
    let mut scene = open(Some(WorldStore::create(&dir, &meta).unwrap()));
    scene.spawn_car(over_ground(1.0, 12.0, 0.6), 1.0);
    scene.spawn_bot(over_ground(3.0, 9.0, 0.2), 1.0, false);
    dig_and_build_at_the_tip(&mut scene);
    stand(&mut scene, 4.0, 3.0);
    assert!(scene.spawn_lamp(over_ground(4.4, 2.0, 0.3)));
    let drop = Actions {
        drop_one: true,
        ..still()
    };
    steps(&mut scene, 1, &drop);
    steps(&mut scene, SECOND, &still());
    let told = |scene: &Scene| {
        let probe = scene.probe();
        // It is searched from the head, to a micrometre.
        let ground_m = probe.terrain.ground_height.map(|it| (it * 1e5).round());
        // What a figure thinks is not saved.
        let bots = probe.bots.into_iter();
        let bots: Vec<_> = bots.map(|it| BotProbe { state: "", ..it }).collect();
        let things = (probe.lamps, probe.drops, bots, probe.cars);
        (probe.player.pos, probe.player.hemisphere, ground_m, things)
    };
    let (before, edited) = (told(&scene), scene.probe().chunks.edited);
    let counts = [before.3.0.len(), before.3.2.len(), before.3.3.len()];
    assert_eq!(counts, [1; 3]);
    scene.close().unwrap();
    let scene = open(Some(WorldStore::open(&dir).unwrap()));
    assert_eq!(told(&scene), before);
    assert_eq!(scene.probe().chunks.edited, edited);
    assert!(edited >= 3 && Cone.has_chart(scene.feet().chart));
}
