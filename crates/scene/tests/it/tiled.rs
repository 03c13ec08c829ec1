//! What happens in a world of many charts is what happens in the same world of one: they cross any number of times, in
//! any order, and turn as they do.

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::sync::Arc;

use antipode_geometry::{ChartId, Geometry};
use antipode_scene::bot::BotView;
use antipode_scene::probe::BotProbe;
use antipode_scene::{Actions, NpcMode, Scene};
use antipode_storage::WorldStore;
use antipode_testing::tiled::TiledFlat;
use glam::DVec3;

use crate::common::figures::SECOND;
use crate::common::twins::{Twins, apart_m};
use crate::common::{LIMIT, setup, steps};

/// How far what walks and lies may be apart, metres.
const ALIKE_M: f64 = 1e-3;
/// How far bullets may be, which bounce: from the second time on they tell the last digits of single numbers. Some meet the
/// ridge between two triangles then and go their own ways; none that are shot here do.
const BULLETS_M: f64 = 1e-2;

fn ahead() -> Actions {
    Actions {
        forward: 1.0,
        ..Actions::default()
    }
}

/// Steps both so many times, and looks at the players after each.
fn pass(twins: &mut Twins, count: usize, actions: impl Fn(usize) -> Actions) -> BTreeSet<ChartId> {
    let mut charts = BTreeSet::new();
    for step in 0..count {
        twins.step(&actions(step));
        let apart_m = twins.apart_m();
        assert!(
            apart_m < ALIKE_M,
            "{apart_m} m after {step} steps: {:?} {:?}",
            twins.one.feet(),
            twins.many.feet()
        );
        charts.insert(twins.many.feet().chart);
    }
    charts
}

#[test]
fn a_walk_of_a_minute_over_edges_and_corners_is_the_same() {
    let mut twins = Twins::new();
    twins.stand(24.0, 26.0, 0.3, -0.1);
    let charts = pass(&mut twins, 60 * SECOND, |step| Actions {
        sprint: step % 300 < 200,
        strafe: if step % 500 > 400 { 0.5 } else { 0.0 },
        jump: step % 90 == 0,
        look_yaw: if step % 240 < 60 { 0.012 } else { -0.004 },
        ..ahead()
    });
    assert!(charts.len() > 5, "{charts:?}");
}

#[test]
fn ground_is_dug_and_built_over_edges_and_a_corner_alike() {
    let mut twins = Twins::new();
    // Where four squares meet, and on an edge.
    for (x, z) in [(31.0, 31.2), (31.4, 5.0), (-33.0, -31.0)] {
        twins.stand(x, z, 0.7, -0.9);
        let before = twins.one.feet();
        pass(&mut twins, 4 * SECOND, |step| Actions {
            slot: (step == 0).then_some(2),
            primary: step < 180,
            look_yaw: 0.01,
            ..Actions::default()
        });
        let down_m = before.pos.y - twins.one.feet().pos.y;
        assert!(down_m > 1.0, "{down_m} m");
        pass(&mut twins, 3 * SECOND, |step| Actions {
            secondary: step % 60 < 20,
            jump: step % 60 < 20,
            ..Actions::default()
        });
        pass(&mut twins, 3 * SECOND, |_| Actions {
            look_yaw: 0.03,
            ..ahead()
        });
    }
}

#[test]
fn bullets_lamps_and_what_is_thrown_away_lie_alike() {
    let mut twins = Twins::new();
    twins.stand(29.0, 30.0, 0.63, 0.1);
    let gun = |step: usize| Actions {
        slot: (step == 0).then_some(0),
        primary: step % 40 == 3,
        look_yaw: 0.02,
        ..Actions::default()
    };
    let mut shots = 0;
    for step in 0..4 * SECOND {
        twins.step(&gun(step));
        let [one, many] = [&twins.one, &twins.many].map(Scene::projectiles);
        assert_eq!(one.len(), many.len(), "step {step}");
        for ((_, a), (_, b)) in one.iter().zip(&many) {
            let apart_m = apart_m(a.point, b.point);
            assert!(apart_m < BULLETS_M, "{apart_m} m");
            shots += 1;
        }
    }
    assert!(shots > 100, "{shots}");
    twins.aim(0.6, -0.7);
    let lamp = |step: usize| Actions {
        slot: (step == 0).then_some(5),
        primary: step % 50 == 5,
        drop_one: step == 170,
        look_yaw: 0.01,
        ..Actions::default()
    };
    pass(&mut twins, 5 * SECOND, lamp);
    let [one, many] = [&twins.one, &twins.many].map(Scene::lamps);
    assert!(one.len() == many.len() && one.len() > 1, "{}", one.len());
    for (a, b) in one.iter().zip(&many) {
        assert!(apart_m(a.foot.point, b.foot.point) < ALIKE_M);
    }
    let [one, many] = [&twins.one, &twins.many].map(Scene::drops);
    assert!(one.len() == many.len() && !one.is_empty(), "{}", one.len());
    for (a, b) in one.iter().zip(&many) {
        assert!(apart_m(a.point, b.point) < ALIKE_M);
    }
}

/// Over ground on which nothing is run into: a crash would tell the last digits of single numbers.
#[test]
fn a_drive_of_five_seconds_over_an_edge_is_the_same() {
    for (x, z, yaw) in [(5.0, -24.0, -1.57), (-26.0, -10.0, 3.3_f64)] {
        let mut twins = Twins::new();
        twins.stand(x, z, yaw, -0.3);
        let (east, north) = (x + 3.0 * yaw.cos(), z + 3.0 * yaw.sin());
        let at = DVec3::new(east, twins.ground_m(east, north) + 0.6, north);
        twins.arrange(at, yaw, |scene, at, yaw| {
            assert!(scene.spawn_car(at, yaw));
        });
        pass(&mut twins, 2 * SECOND, |_| Actions::default());
        twins.step(&Actions {
            enter_car: true,
            ..Actions::default()
        });
        assert!(twins.one.is_driving() && twins.many.is_driving());
        let mut charts = BTreeSet::new();
        let mut fastest_m_s = 0.0_f64;
        for step in 0..5 * SECOND {
            twins.step(&Actions {
                forward: if step < 150 { 0.8 } else { 0.3 },
                strafe: if step > 150 { 0.2 } else { 0.0 },
                ..Actions::default()
            });
            let [one, many] = [&twins.one, &twins.many].map(|it| it.cars()[0]);
            let apart_m = apart_m(one.point, many.point);
            assert!(apart_m < ALIKE_M, "{apart_m} m after {step} steps");
            charts.insert(many.point.chart);
            fastest_m_s = fastest_m_s.max(one.speed_m_s);
        }
        assert!(charts.len() > 1, "{charts:?}");
        assert!(fastest_m_s > 8.0, "{fastest_m_s} m/s");
    }
}

/// Half of it is in the next chart, where nobody walks through it either.
#[test]
fn a_car_that_stands_over_an_edge_is_in_the_way_on_both_sides() {
    for (from_x, yaw) in [(37.0, PI), (26.5, 0.0)] {
        let mut twins = Twins::new();
        let at = DVec3::new(32.05, twins.ground_m(32.05, 4.0) + 0.6, 4.0);
        twins.arrange(at, 0.0, |scene, at, yaw| {
            assert!(scene.spawn_car(at, yaw));
        });
        twins.stand(from_x, 4.0, yaw, 0.0);
        let charts = pass(&mut twins, 75, |_| ahead());
        assert_eq!(charts.len(), 1, "who is stopped does not cross: {charts:?}");
        let gone_m = (twins.one.feet().pos.x - from_x).abs();
        assert!((1.0..4.5).contains(&gone_m), "{gone_m} m");
    }
}

/// A fight goes by its events: where each is, what it does, who is hurt and when. It ends before somebody steps into what
/// lies about and rolls: that tells the last digits of single numbers.
#[test]
fn a_fight_over_a_corner_goes_the_same_way() {
    let mut twins = Twins::new();
    twins.stand(30.0, 30.0, 0.8, 0.0);
    for scene in [&mut twins.one, &mut twins.many] {
        scene.set_npcs(NpcMode::On);
    }
    for (x, z, hostile) in [(40.0, 37.0, true), (27.0, 44.0, true), (36.0, 24.0, false)] {
        let at = DVec3::new(x, twins.ground_m(x, z) + 0.2, z);
        twins.arrange(at, 2.0, |scene, at, yaw| {
            scene.spawn_bot(at, yaw, hostile);
        });
    }
    let mut hurt = BTreeSet::new();
    let mut charts = BTreeSet::new();
    for step in 0..9 * SECOND {
        twins.step(&Actions {
            slot: (step == 0).then_some(0),
            primary: step % 30 == 4,
            look_yaw: 0.004,
            strafe: if step % 200 < 100 { 0.6 } else { -0.6 },
            ..Actions::default()
        });
        let told = |scene: &Scene| {
            let does = |view: &BotView| (view.bot.id, view.health, view.state.name(), view.fights);
            let bots: Vec<_> = scene.bots().iter().map(does).collect();
            (scene.health(), bots)
        };
        let (one, many) = (told(&twins.one), told(&twins.many));
        assert_eq!(one, many, "step {step}");
        for (a, b) in twins.one.bots().iter().zip(&twins.many.bots()) {
            let apart_m = apart_m(a.point, b.point);
            assert!(
                apart_m < ALIKE_M,
                "{} at step {step}: {apart_m} m",
                a.bot.id
            );
            charts.insert(b.point.chart);
        }
        hurt.insert(one.0.to_bits());
    }
    assert!(hurt.len() > 2, "nobody was hurt");
    assert!(charts.len() > 3, "{charts:?}");
}

/// What was dug, built, put down and left in many charts is there when the world is opened again.
#[test]
fn a_world_of_many_charts_comes_back_from_its_save() {
    let kept = tempfile::tempdir().unwrap();
    let setup = setup(Geometry::Euclidean);
    let dir = kept.path().join("world");
    let open = |store: WorldStore| {
        let store = Some(Arc::new(store));
        let mut scene = Scene::open_in(Arc::new(TiledFlat), setup.clone(), store, 2).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        scene
    };
    let mut scene = open(WorldStore::create(&dir, &setup.to_meta()).unwrap());
    scene.spawn_car(TiledFlat::at(DVec3::new(100.0, 30.0, -60.0)), 1.0);
    scene.spawn_bot(TiledFlat::at(DVec3::new(40.0, 30.0, 37.0)), 1.0, false);
    scene.teleport(TiledFlat::at(DVec3::new(97.0, 40.0, 96.5)));
    assert!(scene.wait_for_step(LIMIT));
    scene.aim(0.4, -1.2);
    for step in 0..3 * SECOND {
        let dig = Actions {
            slot: (step == 0).then_some(2),
            primary: true,
            look_yaw: 0.02,
            ..Actions::default()
        };
        steps(&mut scene, 1, &dig);
    }
    assert!(scene.spawn_lamp(TiledFlat::at(DVec3::new(92.0, 40.0, 101.0))));
    let drop = Actions {
        drop_one: true,
        ..Actions::default()
    };
    steps(&mut scene, 1, &drop);
    steps(&mut scene, SECOND, &Actions::default());
    let told = |scene: &Scene| {
        let probe = scene.probe();
        let counts = [probe.lamps.len(), probe.drops.len(), probe.bots.len()];
        assert_eq!(counts, [1; 3]);
        let ground_m = probe.terrain.ground_height;
        // What a figure thinks is not saved.
        let bots = probe
            .bots
            .into_iter()
            .map(|it| BotProbe { state: "", ..it });
        let bots: Vec<_> = bots.collect();
        let things = (probe.lamps, probe.drops, bots, probe.cars);
        (probe.player.pos, probe.player.hemisphere, ground_m, things)
    };
    let before = told(&scene);
    assert!(before.1.starts_with("0x"), "{}", before.1);
    let edited = scene.probe().chunks.edited;
    assert!(edited > 4, "{edited}");
    scene.close().unwrap();
    let scene = open(WorldStore::open(&dir).unwrap());
    assert_eq!(told(&scene), before);
    assert_eq!(scene.probe().chunks.edited, edited);
}
