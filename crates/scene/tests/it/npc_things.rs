//! What other figures make of what stands on the land: they walk round it, sit on stones, and hide behind trunks.

use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use antipode_plants::{Age, Species, placed, placed_near, top_m};
use antipode_scene::frame::Clip;
use antipode_scene::tuning::{DAY_S, FULL_HEALTH};
use antipode_scene::{Actions, Generator, Scene, State, WorldSetup};
use antipode_storage::WorldStore;
use glam::{DVec3, Vec2, Vec3Swizzles};

use crate::common::figures::{SECOND, bot, pass, shoot};
use crate::common::{LIMIT, setup, steps};

/// A world with things.
fn planted(geometry: Geometry) -> Scene {
    let mut scene = Scene::open(planted_setup(geometry), None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

fn planted_setup(geometry: Geometry) -> WorldSetup {
    WorldSetup {
        generator: Generator::Planted,
        radius_m: match geometry {
            Geometry::Euclidean | Geometry::Hyperbolic => 20.0,
            Geometry::Spherical => 64.0,
            Geometry::HyperbolicWorld => 120.61,
        },
        seed: 7,
        ..setup(geometry)
    }
}

/// Tiles whose things are looked at in a world in tiles: those within so many metres of the middle.
const TILES_WITHIN_M: f64 = 200.0;

/// The roots of things that are wanted and have nothing else within so many metres: those nearest to the middle first, in a
/// closed world those nearest to the equator. In a world in tiles those of the first come before those of the tiles about it.
fn alone(
    scene: &Scene,
    room_m: f64,
    is_wanted: impl Fn(Species, Age) -> bool,
) -> Vec<(ChartPoint, f64)> {
    let field = scene.field();
    let strategy = scene.strategy();
    let rim_m = strategy.domain(ChartId::FIRST).radius_m();
    let tiles = strategy
        .tiled()
        .map(|tiled| tiled.charts_within(ChartPoint::a(DVec3::ZERO), TILES_WITHIN_M));
    let mut found = Vec::new();
    for chart in tiles.unwrap_or_else(|| vec![ChartId::FIRST]) {
        let domain = strategy.domain(chart);
        let middle = ChartPoint::new(chart, DVec3::ZERO);
        let mut all: Vec<_> = placed_near(field, middle, domain.half_width_m().min(140.0))
            .filter(|(_, species, age)| is_wanted(*species, *age))
            .filter(|(root, ..)| placed_near(field, *root, room_m).count() == 1)
            .filter_map(|(root, species, age)| Some((root, species.trunk(age)?.radius_m)))
            .collect();
        // What stands over an edge is another tile's.
        let is_inside = |root: &ChartPoint| domain.outside_m(root.pos.xz()) < -room_m;
        all.retain(|(root, _)| strategy.tiled().is_none() || is_inside(root));
        let away_m = |root: &ChartPoint| {
            let from_middle_m = root.pos.with_y(0.0).length();
            rim_m.map_or(from_middle_m, |rim_m| rim_m - from_middle_m)
        };
        all.sort_by(|(a, _), (b, _)| away_m(a).total_cmp(&away_m(b)));
        found.extend(all);
    }
    found
}

/// The ground at some metres from a root, away from the middle and to the right: in closed worlds over the equator soon.
fn about(scene: &Scene, root: ChartPoint, out_m: f64, aside_m: f64) -> ChartPoint {
    let out = root.pos.with_y(0.0).normalize();
    ground(
        scene,
        root,
        out * out_m + DVec3::new(-out.z, 0.0, out.x) * aside_m,
    )
}

/// The ground at some metres from a place, in the chart that it belongs to.
fn ground(scene: &Scene, from: ChartPoint, by: DVec3) -> ChartPoint {
    let at = from.moved(by);
    let at = scene.strategy().cross(at).map_or(at, |it| it.point);
    let y = scene.field().surface_height(at.chart, at.pos.x, at.pos.z);
    ChartPoint::new(at.chart, at.pos.with_y(y + 0.05))
}

fn put_player(scene: &mut Scene, there: ChartPoint) {
    scene.teleport(there);
    assert!(scene.settle(LIMIT));
    // In a closed world noon is not everywhere at once.
    for sixteenth in 0..16 {
        scene.set_time_of_day_s(f64::from(sixteenth) * DAY_S / 16.0);
        if scene
            .probe()
            .hour
            .is_some_and(|hour| (10.0..14.0).contains(&hour))
        {
            break;
        }
    }
}

/// From one place to another in the chart of the first, over the level.
fn level(scene: &Scene, from: ChartPoint, to: ChartPoint) -> DVec3 {
    let there = scene.strategy().carry_near(to, from);
    let there = there.map_or(to, |it| it.point);
    (there.pos - from.pos).with_y(0.0)
}

fn perches(scene: &mut Scene, at: ChartPoint) -> bool {
    let figures = scene.frame(1.3, 1.7, 1);
    let figures = &figures.content.figures;
    let there = |it: &&antipode_scene::frame::Figure| it.point.pos.distance(at.pos) < 0.05;
    let figure = figures.iter().find(there);
    figure.is_some_and(|it| it.posture.share(Clip::Perch) > 0.99)
}

/// How high what is seen of the thing with that root is over a place of its side, metres of the chart.
fn seat_m(scene: &Scene, root: ChartPoint, out: DVec3) -> Option<f64> {
    let coord = ChunkCoord::containing(root);
    let things = placed(scene.field(), coord);
    let local = (root.pos - coord.origin()).as_vec3();
    let thing = things.iter().find(|it| it.root.distance(local) < 0.01)?;
    let at = Vec2::new(out.x as f32, out.z as f32) * 0.17;
    Some(root.pos.y + f64::from(top_m(thing, at)?))
}

#[test]
fn in_peace_by_day_they_sit_on_stones_for_a_while_and_go_on() {
    for geometry in Geometry::ALL {
        let young = |species, age| species == Species::Boulder && age == Age::Young;
        let stones = alone(&planted(geometry), 3.0, young);
        let (mut sat, mut tried, mut crossed) = (0, 0, 0);
        for (root, _) in stones.into_iter().take(6) {
            let mut scene = planted(geometry);
            tried += 1;
            let place = about(&scene, root, -11.0, 6.0);
            put_player(&mut scene, place);
            let place = about(&scene, root, 4.0, 2.0);
            let id = scene.spawn_bot(place, 0.0, false);
            let mut seconds = 0;
            let sits = |scene: &Scene| bot(scene, id).state == State::Sit;
            while seconds < 120 && !sits(&scene) {
                pass(&mut scene, 1.0);
                seconds += 1;
            }
            pass(&mut scene, 6.0);
            if sits(&scene) && check_seat(&mut scene, geometry, root, id) {
                sat += 1;
                crossed += usize::from(place.chart != root.chart);
            }
            if sat > 1 {
                break;
            }
        }
        println!("{geometry:?}: {sat} of {tried} stones, {crossed} over the equator");
        assert!(sat > 1, "{geometry:?}: {sat} of {tried} stones");
        assert!(crossed > 0 || geometry != Geometry::Spherical);
    }
}

/// Checks one who sits: on that stone, or on another one near by, when it returns false.
fn check_seat(scene: &mut Scene, geometry: Geometry, root: ChartPoint, id: u32) -> bool {
    let view = bot(scene, id);
    let out = level(scene, root, view.point);
    if out.length() > 2.0 {
        return false;
    }
    assert!((0.35..0.5).contains(&out.length()), "{geometry:?}: {out}");
    let top_m = seat_m(scene, root, out.normalize()).expect("stone is under him");
    let high_m = top_m - view.point.pos.y;
    println!("{geometry:?}: sits {high_m:.2} m over the ground by {root:?}");
    assert!((0.33..0.53).contains(&high_m), "{geometry:?}: {high_m} m");
    let feet = ground(scene, root, out.normalize() * 0.62);
    let off_m = view.point.pos.y - feet.pos.y + 0.05;
    assert!(off_m.abs() < 0.08, "{geometry:?}: feet {off_m} m over");
    assert!(perches(scene, view.point), "{geometry:?}: he stands");
    let looks = DVec3::new(view.yaw.cos(), 0.0, view.yaw.sin());
    assert!(looks.dot(out.normalize()) > 0.95, "{geometry:?}: {looks}");
    let mut stays_s = 6;
    while bot(scene, id).state == State::Sit {
        let still = bot(scene, id).point;
        assert!(still.pos.distance(view.point.pos) < 0.02, "he slides");
        pass(scene, 1.0);
        stays_s += 1;
        assert!(stays_s < 62, "{geometry:?}: he never gets up");
    }
    assert!(stays_s > 17, "{geometry:?}: {stays_s} s");
    pass(scene, 15.0);
    let gone_m = level(scene, root, bot(scene, id).point).length();
    assert!(gone_m > 1.2, "{geometry:?}: he cannot get away, {gone_m} m");
    true
}

/// A kept world in which somebody sits on a stone: its root, his number, and where it is kept.
fn sitting() -> (Scene, ChartPoint, u32, tempfile::TempDir) {
    let geometry = Geometry::Euclidean;
    let young = |species, age| species == Species::Boulder && age == Age::Young;
    let stones = alone(&planted(geometry), 3.0, young);
    stones
        .into_iter()
        .take(4)
        .find_map(|(root, _)| {
            let dir = tempfile::tempdir().unwrap();
            let setup = planted_setup(geometry);
            let store = WorldStore::create(&dir.path().join("world"), &setup.to_meta()).unwrap();
            let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
            assert!(scene.wait_for_step(LIMIT));
            let place = about(&scene, root, -7.0, 4.0);
            put_player(&mut scene, place);
            let place = about(&scene, root, 4.0, 2.0);
            let id = scene.spawn_bot(place, 0.0, false);
            let sits = (0..240).any(|_| {
                pass(&mut scene, 0.5);
                let at = bot(&scene, id).point;
                perches(&mut scene, at) && level(&scene, root, at).length() < 0.5
            });
            sits.then_some((scene, root, id, dir))
        })
        .expect("somebody sits")
}

#[test]
fn who_sits_is_saved_standing() {
    let (scene, root, id, dir) = sitting();
    scene.close().unwrap();
    let store = WorldStore::open(&dir.path().join("world")).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut again = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(again.wait_for_step(LIMIT));
    let away_m = level(&again, root, bot(&again, id).point).length();
    assert!(away_m > 0.7, "he begins within the stone, {away_m} m");
}

#[test]
fn who_sits_and_is_shot_gets_up_to_fight() {
    let (mut scene, root, id, _dir) = sitting();
    shoot(&mut scene, id);
    pass(&mut scene, 0.5);
    let hit = bot(&scene, id);
    assert!(hit.fights && hit.health < 3.0, "{hit:?}");
    pass(&mut scene, 4.0);
    let at = bot(&scene, id).point;
    assert!(!perches(&mut scene, at), "he still sits");
    let away_m = level(&scene, root, at).length();
    assert!(away_m > 0.7, "he is stuck in the stone, {away_m} m");
}

/// Puts the player before a tree and fells it; whether that left a stump.
fn fell(scene: &mut Scene, root: ChartPoint) -> bool {
    let place = ground(scene, root, DVec3::X * 2.0);
    put_player(scene, place);
    let rise_m = root.pos.y + 1.2 - scene.head().point.pos.y;
    scene.aim(std::f64::consts::PI, (rise_m / 2.0).atan());
    let chop = Actions {
        slot: Some(1),
        primary: true,
        ..Actions::default()
    };
    let left = |scene: &Scene| {
        scene
            .probe()
            .plants
            .is_some_and(|it| it.near.contains_key("stump"))
    };
    for _ in 0..20 {
        steps(scene, SECOND, &chop);
        if left(scene) {
            break;
        }
    }
    pass(scene, 5.0);
    left(scene)
}

#[test]
fn the_stump_of_a_felled_tree_is_sat_on() {
    let geometry = Geometry::Euclidean;
    let stout = |species: Species, age| {
        let trunk = species.trunk(age);
        species.is_tree() && trunk.is_some_and(|it| (0.27..0.31).contains(&it.radius_m))
    };
    let trees = alone(&planted(geometry), 4.0, stout);
    let sat = trees.into_iter().take(5).any(|(root, _)| {
        let mut scene = planted(geometry);
        assert!(fell(&mut scene, root), "it stands");
        let place = about(&scene, root, -9.0, 4.0);
        put_player(&mut scene, place);
        let place = about(&scene, root, 4.0, 2.0);
        let id = scene.spawn_bot(place, 0.0, false);
        (0..60).any(|_| {
            pass(&mut scene, 2.0);
            let view = bot(&scene, id);
            let is_on = level(&scene, root, view.point).length() < 0.5;
            is_on && view.state == State::Sit && perches(&mut scene, view.point)
        })
    });
    assert!(sat, "nobody sat on any of them");
}

/// How much of some seconds trunks and boulders hide a fighter's middle from the player's head, who shoots at him beside one of
/// them or does not, and whether he fights on.
fn hidden_share(geometry: Geometry, root: ChartPoint, shoots: bool) -> (f64, bool) {
    let scene = &mut planted(geometry);
    let player = about(scene, root, 9.5, 2.0);
    put_player(scene, player);
    let place = about(scene, root, 1.0, -5.0);
    let there = level(scene, place, player);
    let id = scene.spawn_bot(place, there.z.atan2(there.x), true);
    pass(scene, 1.5);
    if shoots {
        shoot(scene, id);
    }
    // He goes behind whichever is nearest to him.
    let near = placed_near(scene.field(), root, 16.0);
    let solid = near.filter_map(|(root, species, age)| Some((root, species.trunk(age)?.radius_m)));
    let solid: Vec<_> = solid.collect();
    let (mut hidden, steps) = (0, 8 * SECOND);
    for _ in 0..steps {
        crate::common::steps(scene, 1, &Actions::default());
        scene.set_health(FULL_HEALTH);
        let to_him = level(scene, scene.feet(), bot(scene, id).point);
        let hides = |(root, radius_m): &(ChartPoint, f64)| {
            let to_it = level(scene, scene.feet(), *root);
            let along_m = to_it.dot(to_him.normalize());
            let across_m = to_it.cross(to_him.normalize()).length();
            (0.0..to_him.length()).contains(&along_m) && across_m < *radius_m
        };
        hidden += usize::from(solid.iter().any(hides));
    }
    let mut fought = false;
    for _ in 0..100 {
        pass(scene, 0.1);
        scene.set_health(FULL_HEALTH);
        let state = bot(scene, id).state;
        fought |= matches!(state, State::Fight | State::Chase);
    }
    (hidden as f64 / steps as f64, fought)
}

/// Fighters beside the first four of some things are hidden a good part of the time when they are shot at, and hardly else.
fn hide_behind(geometry: Geometry, things: &[(ChartPoint, f64)]) {
    let shares = |shoots: bool| -> Vec<f64> {
        let all = things.iter().take(4).map(|(root, _)| {
            let (share, fought) = hidden_share(geometry, *root, shoots);
            assert!(fought || !shoots, "{geometry:?}: it hides for ever");
            share
        });
        all.collect()
    };
    let (shot, calm) = (shares(true), shares(false));
    println!("{geometry:?}: hidden {shot:.2?} under fire, {calm:.2?} else");
    assert!(
        shot.len() == 4 && shot.iter().all(|it| *it > 0.3),
        "{geometry:?}: {shot:?}"
    );
    let mean = |all: &[f64]| all.iter().sum::<f64>() / 4.0;
    assert!(mean(&shot) > 3.0 * mean(&calm), "{geometry:?}: {calm:?}");
}

#[test]
fn fighters_under_fire_hide_behind_boulders_and_fight_on() {
    for geometry in Geometry::ALL {
        let high = |species: Species, age| {
            let solid = species.trunk(age);
            species == Species::Boulder && solid.is_some_and(|it| it.height_m > 1.8)
        };
        hide_behind(geometry, &alone(&planted(geometry), 4.0, high));
    }
}

#[test]
fn fighters_under_fire_hide_behind_trunks_and_fight_on() {
    for geometry in Geometry::ALL {
        let scene = planted(geometry);
        let stout = |species: Species, age| {
            let trunk = species.trunk(age);
            species.is_tree() && trunk.is_some_and(|it| it.radius_m > 0.24 && it.height_m > 2.0)
        };
        let trunks = alone(&scene, 5.0, stout);
        let is_over = |root: ChartPoint| about(&scene, root, 9.5, 2.0).chart != root.chart;
        let crosses = trunks.iter().take(4).any(|(root, _)| is_over(*root));
        assert_eq!(crosses, geometry == Geometry::Spherical, "the equator");
        hide_behind(geometry, &trunks);
    }
}

#[test]
fn who_is_on_his_way_goes_round_trunks_and_boulders() {
    for geometry in Geometry::ALL {
        let mut scene = planted(geometry);
        let wide = |species: Species, age| {
            let trunk = species.trunk(age);
            trunk.is_some_and(|it| it.radius_m > 0.85 && it.height_m > 0.9)
        };
        let trees = |species: Species, age| species.is_tree() && age != Age::Young;
        let mut all = alone(&scene, 4.0, trees);
        all.truncate(2);
        all.extend(alone(&scene, 4.0, wide).into_iter().take(2));
        for (root, radius_m) in all {
            // It has heard a shot from beyond, and goes to look.
            let player = about(&scene, root, 18.0, 0.0);
            put_player(&mut scene, player);
            let place = about(&scene, root, -6.0, 0.0);
            let out = root.pos.with_y(0.0).normalize();
            let id = scene.spawn_bot(place, std::f64::consts::PI, true);
            pass(&mut scene, 0.3);
            // Not at him, or he would take cover.
            scene.aim(1.0, 1.4);
            let fire = Actions {
                slot: Some(0),
                primary: true,
                ..Actions::default()
            };
            steps(
                &mut scene,
                1,
                &Actions {
                    primary: false,
                    ..fire
                },
            );
            steps(&mut scene, 1, &fire);
            let (mut last, mut still, mut longest) = (bot(&scene, id).point, 0, 0);
            let mut passed = false;
            for _ in 0..6 * SECOND {
                steps(&mut scene, 1, &Actions::default());
                let now = bot(&scene, id).point;
                passed |= level(&scene, root, now).dot(out) > radius_m;
                let walks = level(&scene, last, now).length() > 0.01;
                still = if walks || passed { 0 } else { still + 1 };
                longest = longest.max(still);
                last = now;
            }
            println!("{geometry:?}: {radius_m} m, still for {longest} steps");
            assert!(passed, "{geometry:?}: held up by {radius_m} m");
            assert!(longest < SECOND / 5, "{geometry:?}: it ran into it");
            scene = planted(geometry);
        }
    }
}
