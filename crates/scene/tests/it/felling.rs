//! What grows: it stands in the way, is felled by tools and by digging, strikes who is under it, and stays felled.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;
use std::time::Instant;

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_plants::{Age, Species, placed_near};
use antipode_scene::{Actions, Generator, Item, Kind, Mode, Scene, Viewing, WorldSetup};
use antipode_storage::{Batch, FelledRecord, Record, RecordKind, WorldStore};
use glam::DVec3;

use crate::common::{LIMIT, setup, steps};

fn planted(geometry: Geometry) -> WorldSetup {
    WorldSetup {
        generator: Generator::Planted,
        mode: Mode::Gathering,
        radius_m: match geometry {
            Geometry::Euclidean | Geometry::Hyperbolic => 20.0,
            Geometry::Spherical => 64.0,
            Geometry::HyperbolicWorld => 120.61,
        },
        seed: 7,
        ..setup(geometry)
    }
}

fn open(setup: WorldSetup) -> Scene {
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// A grown tree that stands alone near the middle, and how it is called.
fn tree(scene: &Scene) -> (ChartPoint, Species) {
    let field = scene.field();
    let near = |at: ChartPoint, within_m: f64| placed_near(field, at, within_m);
    let middle = ChartPoint::new(ChartId::FIRST, DVec3::ZERO);
    let mut all: Vec<_> = near(middle, 60.0)
        .filter(|(_, species, age)| {
            let stout = species
                .trunk(*age)
                .is_some_and(|trunk| trunk.radius_m > 0.12);
            species.is_tree() && *age == Age::Grown && stout
        })
        .filter(|(root, ..)| near(*root, 4.5).count() == 1)
        .collect();
    all.sort_by(|(a, ..), (b, ..)| a.pos.length().total_cmp(&b.pos.length()));
    let (root, species, _) = *all.first().expect("a tree that stands alone");
    (root, species)
}

/// Puts the player so far from a tree along +x, looking at its trunk.
fn stand_before(scene: &mut Scene, root: ChartPoint, away_m: f64) {
    let feet = root.moved(DVec3::new(away_m, 0.0, 0.0));
    let (chart, x, z) = (feet.chart, feet.pos.x, feet.pos.z);
    let height_m = scene.field().surface_height(chart, x, z);
    scene.teleport(ChartPoint::new(chart, feet.pos.with_y(height_m + 0.05)));
    assert!(scene.settle(LIMIT));
    let rise = root.pos.y + 1.2 - (height_m + 1.62);
    scene.aim(PI, (rise / away_m).atan());
    steps(scene, 2, &Actions::default());
}

fn felled(scene: &Scene) -> (u32, usize) {
    let plants = scene.probe().plants.unwrap();
    (plants.felled, plants.falling)
}

fn wood_m3(scene: &Scene) -> f64 {
    let stock = scene.probe().stock.unwrap();
    stock.get(Kind::Wood.name()).copied().unwrap_or_default()
}

/// Goes to each thing that lies near, as who gathers does.
fn gather(scene: &mut Scene) {
    // Some roll on for a while.
    for _ in 0..40 {
        let Some(drop) = scene.drops().into_iter().next() else {
            return;
        };
        scene.teleport(drop.point.moved(DVec3::Y * 0.3));
        assert!(scene.settle(LIMIT));
        steps(scene, 70, &Actions::default());
    }
    panic!("{:?} are left", scene.probe().drops);
}

fn chop() -> Actions {
    Actions {
        primary: true,
        ..Actions::default()
    }
}

/// Chops until so many are felled and so many of them still fall.
fn chop_until(scene: &mut Scene, wanted: (u32, usize)) {
    for _ in 0..1000 {
        steps(scene, 1, &chop());
        if felled(scene) == wanted {
            return;
        }
    }
    panic!("{:?} and not {wanted:?}", felled(scene));
}

#[test]
fn a_tree_is_felled_by_a_tool_falls_away_from_the_blow_and_gives_its_wood() {
    for geometry in Geometry::ALL {
        let mut scene = open(planted(geometry));
        let (root, species) = tree(&scene);
        stand_before(&mut scene, root, 2.0);
        let ahead = scene.probe().plants.unwrap().ahead;
        assert_eq!(ahead, Some(species.name()), "{geometry:?}");
        let edited = scene.probe().chunks.edited;
        let mut chopped = 0;
        while felled(&scene).0 == 0 && chopped < 600 {
            steps(&mut scene, 1, &chop());
            chopped += 1;
        }
        assert!(
            (20..600).contains(&chopped),
            "{geometry:?}: {chopped} steps"
        );
        assert_eq!(felled(&scene), (1, 1), "{geometry:?}");
        assert_eq!(wood_m3(&scene), 0.0, "it is still in the air");
        steps(&mut scene, 400, &Actions::default());
        assert_eq!(felled(&scene), (1, 0), "{geometry:?}");
        let drops = scene.probe().drops;
        let logs: u32 = drops
            .iter()
            .filter(|it| it.stack.item == Item::Log)
            .map(|it| it.stack.count)
            .sum();
        assert!(
            logs > 0 && drops.iter().any(|it| it.stack.item == Item::Seed),
            "{drops:?}"
        );
        assert_eq!(
            scene.probe().player.health,
            20.0,
            "it falls away from the blow"
        );
        assert_eq!(scene.probe().chunks.edited, edited, "no ground was dug");
        let had_m3 = wood_m3(&scene);
        assert_eq!(scene.probe().plants.unwrap().near.get("stump"), Some(&1));
        assert_eq!(
            scene.probe().plants.unwrap().ahead,
            None,
            "nothing stands there"
        );
        gather(&mut scene);
        let gained_m3 = wood_m3(&scene);
        assert!(
            (gained_m3 - 0.1 * f64::from(logs)).abs() < 1e-9,
            "{geometry:?}: {had_m3}, then {gained_m3} m3 of {logs} logs"
        );
        assert_eq!(
            scene.inventory().count(Item::Log),
            0,
            "it is wood to who gathers"
        );
        assert!(scene.inventory().count(Item::Seed) > 0);
    }
}

/// Whoever turns right round has seen each once; upwards there is none.
#[test]
fn a_probe_tells_how_much_of_what_grows_is_in_view() {
    let mut scene = open(planted(Geometry::Euclidean));
    assert!(scene.settle(LIMIT));
    let mut seen = |yaw: f64, pitch: f64| {
        scene.aim(yaw, pitch);
        steps(&mut scene, 1, &Actions::default());
        scene.probe().plants.unwrap().in_view
    };
    assert_eq!(seen(0.3, 1.5), 0);
    // A picture of 69 degrees by 101: four of them overlap.
    let around: usize = [0.0, FRAC_PI_2, PI, 3.0 * FRAC_PI_2]
        .map(|yaw| seen(yaw, 0.0))
        .iter()
        .sum();
    assert!(around > 150, "{around} of a view distance of two chunks");
}

#[test]
fn a_trunk_stops_who_walks_into_it() {
    for geometry in Geometry::ALL {
        let mut scene = open(planted(geometry));
        let (root, _) = tree(&scene);
        stand_before(&mut scene, root, 3.0);
        let ahead = Actions {
            forward: 1.0,
            ..Actions::default()
        };
        steps(&mut scene, 120, &ahead);
        let feet = scene.feet();
        let past_m = root.pos.x - feet.pos.x;
        let beside_m = (root.pos.z - feet.pos.z).abs();
        assert!(
            past_m < 0.0 || beside_m > 0.3,
            "{geometry:?}: through the trunk to {past_m} m behind it"
        );
    }
}

#[test]
fn what_the_ground_was_dug_away_from_under_falls_and_undoing_leaves_it_felled() {
    let mut scene = open(planted(Geometry::Euclidean));
    let (root, species) = tree(&scene);
    stand_before(&mut scene, root, 4.0);
    // At the ground beside the trunk.
    let eye = scene.head().point.pos;
    let way = root.pos + DVec3::new(1.2, -0.3, 0.6) - eye;
    scene.aim(way.z.atan2(way.x), way.y.atan2(way.x.hypot(way.z)));
    steps(&mut scene, 1, &Actions::default());
    assert_eq!(
        scene.probe().plants.unwrap().ahead,
        None,
        "{species:?} is not aimed at"
    );
    for _ in 0..400 {
        scene.step(&chop());
        // The stroke's work is done when that of what fell is.
        assert!(scene.settle(LIMIT));
        if felled(&scene).0 > 0 {
            break;
        }
    }
    assert!(felled(&scene).0 >= 1, "nothing fell");
    assert_eq!(
        scene.probe().plants.unwrap().near.get("stump"),
        None,
        "its ground is gone"
    );
    steps(&mut scene, 400, &Actions::default());
    assert!(
        scene
            .probe()
            .drops
            .iter()
            .any(|it| it.stack.item == Item::Log)
    );
    let undo = Actions {
        undo: true,
        ..Actions::default()
    };
    let before = felled(&scene).0;
    steps(&mut scene, 1, &undo);
    steps(&mut scene, 30, &Actions::default());
    assert_eq!(felled(&scene), (before, 0));
}

fn health(scene: &Scene, id: u32) -> Option<f64> {
    let bots = scene.bots();
    bots.iter().find(|it| it.bot.id == id).map(|it| it.health)
}

#[test]
fn a_falling_tree_strikes_who_stands_under_it_and_nobody_beside() {
    let mut scene = open(planted(Geometry::Euclidean));
    let (root, _) = tree(&scene);
    stand_before(&mut scene, root, 2.0);
    let beyond = |along: f64, across: f64| {
        let at = root.pos + DVec3::new(-along, 0.0, across);
        let y = scene.field().surface_height(root.chart, at.x, at.z);
        ChartPoint::new(root.chart, at.with_y(y + 0.05))
    };
    let places = (beyond(3.0, 0.0), beyond(3.0, 9.0));
    for _ in 0..600 {
        steps(&mut scene, 1, &chop());
        if felled(&scene).1 > 0 {
            break;
        }
    }
    // Who had come sooner would have walked about.
    let under = scene.spawn_bot(places.0, FRAC_PI_2, false);
    let beside = scene.spawn_bot(places.1, FRAC_PI_2, false);
    let healthy = health(&scene, beside);
    steps(&mut scene, 300, &Actions::default());
    assert_eq!(felled(&scene), (1, 0));
    assert!(health(&scene, under).is_none_or(|left| left <= 0.0));
    assert_eq!(health(&scene, beside), healthy);
}

/// The logs and seeds that lie about.
fn lying(scene: &Scene) -> [u32; 2] {
    let drops = scene.probe().drops;
    [Item::Log, Item::Seed].map(|item| {
        let of_it = drops.iter().filter(|it| it.stack.item == item);
        of_it.map(|it| it.stack.count).sum()
    })
}

#[test]
fn a_tree_that_still_falls_when_the_world_is_left_lies_there_as_logs() {
    let setup = planted(Geometry::Euclidean);
    let fell = |scene: &mut Scene| {
        assert!(scene.wait_for_step(LIMIT));
        let (root, species) = tree(scene);
        stand_before(scene, root, 2.0);
        let before = scene.probe().plants.unwrap().near[species.name()];
        chop_until(scene, (1, 1));
        (root, species, before)
    };
    let mut whole = open(setup.clone());
    fell(&mut whole);
    steps(&mut whole, 400, &Actions::default());
    let wood = lying(&whole);
    assert!(wood[0] > 0);

    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    let (root, species, before) = fell(&mut scene);
    scene.close().unwrap();

    let store = WorldStore::open(&here).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut again = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(again.wait_for_step(LIMIT) && again.settle(LIMIT));
    let plants = again.probe().plants.unwrap();
    let left = plants.near.get(species.name()).copied().unwrap_or_default();
    assert_eq!((plants.felled, plants.falling, left), (1, 0, before - 1));
    assert_eq!(lying(&again), wood, "its wood");
    for drop in again.probe().drops {
        let away = DVec3::from(drop.pos) - root.pos;
        assert!(away.with_y(0.0).length() < 1.0, "{away}");
        assert!(away.y.abs() < 0.8, "{away}");
    }
}

#[test]
fn what_was_felled_stays_so_in_the_save_and_nothing_else_is_kept_of_it() {
    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let setup = planted(Geometry::Euclidean);
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    let (root, species) = tree(&scene);
    stand_before(&mut scene, root, 2.0);
    let before = scene.probe().plants.unwrap().near[species.name()];
    chop_until(&mut scene, (1, 0));
    scene.close().unwrap();

    let store = WorldStore::open(&here).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut again = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(again.wait_for_step(LIMIT) && again.settle(LIMIT));
    let plants = again.probe().plants.unwrap();
    assert_eq!((plants.felled, plants.falling), (1, 0));
    let left = plants.near.get(species.name()).copied().unwrap_or_default();
    assert_eq!(left, before - 1);
    assert_eq!(again.probe().chunks.edited, 0, "no ground was changed");
    assert!(
        again
            .probe()
            .drops
            .iter()
            .any(|it| it.stack.item == Item::Log)
    );
}

#[test]
fn what_was_felled_is_in_the_save_that_succeeds_after_one_that_failed() {
    let dir = tempfile::tempdir().unwrap();
    let (here, elsewhere) = (dir.path().join("world"), dir.path().join("elsewhere"));
    let setup = planted(Geometry::Euclidean);
    let store = WorldStore::create(&here, &setup.to_meta()).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT));
    let (root, _) = tree(&scene);
    stand_before(&mut scene, root, 2.0);
    chop_until(&mut scene, (1, 0));
    std::fs::rename(&here, &elsewhere).unwrap();
    let failure = scene.close().unwrap_err();
    std::fs::rename(&elsewhere, &here).unwrap();
    failure.scene.close().unwrap();
    let store = WorldStore::open(&here).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut again = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(again.wait_for_step(LIMIT));
    assert_eq!(felled(&again).0, 1);
}

/// A kept world with so many columns of chunks far off of which 64 trees each were felled; when it was begun, loaded and saved
/// again, seconds.
fn kept_with_felled(columns: i32) -> (u32, [f64; 2]) {
    let dir = tempfile::tempdir().unwrap();
    let here = dir.path().join("world");
    let store = WorldStore::create(&here, &planted(Geometry::Euclidean).to_meta()).unwrap();
    let record = |n: i32| {
        let record = FelledRecord {
            chart: 0,
            x: 1000 + n % 40,
            z: n / 40,
            slots: [u64::MAX, 0],
        };
        let key = RecordKind::Felled.numbered(n as u32 + 1);
        (key, Some(Record::Felled(record)))
    };
    let batch = Batch {
        records: (0..columns).map(record).collect(),
        ..Batch::default()
    };
    store.commit(&batch).unwrap();
    drop(store);

    let began = Instant::now();
    let store = WorldStore::open(&here).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(scene.wait_for_step(LIMIT) && scene.settle(LIMIT));
    let loaded_s = began.elapsed().as_secs_f64();
    let (root, _) = tree(&scene);
    stand_before(&mut scene, root, 2.0);
    let before = felled(&scene).0;
    chop_until(&mut scene, (before + 1, 0));
    let began = Instant::now();
    scene.close().unwrap();
    let saved_s = began.elapsed().as_secs_f64();

    let store = WorldStore::open(&here).unwrap();
    let setup = WorldSetup::from_meta(&store.meta(), 2).unwrap();
    let mut again = Scene::open(setup, Some(Arc::new(store))).unwrap();
    assert!(again.wait_for_step(LIMIT));
    (felled(&again).0, [loaded_s, saved_s])
}

/// What a world with a hundred thousand felled trees takes beside one with none, by turns: the medians tell what disks' waits
/// hide in one try.
#[test]
#[ignore = "prints numbers"]
fn print_what_a_hundred_thousand_felled_trees_take() {
    const ROUNDS: usize = 41;
    let mut all = [const { [const { Vec::new() }; 2] }; 2];
    for _ in 0..ROUNDS {
        for (columns, rows) in [0, 1563].into_iter().zip(&mut all) {
            let (_, took_s) = kept_with_felled(columns);
            for (row, took_s) in rows.iter_mut().zip(took_s) {
                row.push(took_s);
            }
        }
    }
    for (what, n) in [("loaded", 0), ("saved", 1)] {
        let [without_ms, with_ms] = [0, 1].map(|m: usize| {
            let row: &mut Vec<f64> = &mut all[m][n];
            row.sort_by(f64::total_cmp);
            1000.0 * row[ROUNDS / 2]
        });
        let times = with_ms / without_ms;
        println!("{what}: {without_ms:.2} ms without, {with_ms:.2} ms with, {times:.2} times");
    }
}

#[test]
fn a_world_with_a_hundred_thousand_felled_trees_is_kept_as_one_with_none() {
    let (none, without_s) = kept_with_felled(0);
    let (all, with_s) = kept_with_felled(1563);
    println!("loaded and saved in {without_s:.3?} s without, {with_s:.3?} s with");
    assert_eq!((none, all), (1, 64 * 1563 + 1));
}

#[test]
fn leaves_sway_as_time_goes_by_unless_a_setting_stills_them() {
    let mut scene = open(planted(Geometry::Euclidean));
    let wind = |scene: &mut Scene| scene.frame(1.2, 1.5, 360).view.wind;
    let first = wind(&mut scene).unwrap();
    steps(&mut scene, 30, &Actions::default());
    let later = wind(&mut scene).unwrap();
    assert!(
        (later[0] - first[0] - 0.45).abs() < 1e-3,
        "{first:?} {later:?}"
    );
    let before = scene.viewing();
    for (wind_blows, reduced_motion) in [(false, false), (true, true)] {
        scene.set_viewing(Viewing {
            wind: wind_blows,
            reduced_motion,
            ..before
        });
        assert_eq!(wind(&mut scene), None);
    }
}
