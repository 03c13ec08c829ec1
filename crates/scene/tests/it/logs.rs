//! Logs and stones: they roll downhill and no farther, strike who stands in the way, are wood to who gathers and posts to who
//! puts them up.

use antipode_geometry::{BodyFrame, ChartPoint, Geometry};
use antipode_scene::{Actions, Hint, Item, Kind, Mode, Scene, Stack, WorldSetup};
use glam::DVec3;

use crate::common::cars::{ahead, car, enter, stand_beside, still};
use crate::common::{LIMIT, scene, setup, steps};

const LOG: Stack = Stack {
    item: Item::Log,
    count: 1,
};

/// A place near the middle from which the ground falls most, but nowhere steeply, and the way down there.
fn slope(scene: &Scene) -> (ChartPoint, DVec3) {
    let feet = scene.feet();
    let height_m = |at: DVec3| scene.field().surface_height(feet.chart, at.x, at.z);
    let ways = (0..8).map(|n| DVec3::new(f64::from(n).cos(), 0.0, f64::from(n).sin()));
    let ways: Vec<_> = ways.collect();
    let mut best = (0.0, feet.pos, DVec3::X);
    for n in 0..900 {
        let at = feet.pos + DVec3::new(f64::from(n % 30) - 14.5, 0.0, f64::from(n / 30) - 14.5);
        for way in &ways {
            let heights = [0.0, 2.0, 4.0, 6.0, 8.0].map(|m| height_m(at + *way * m));
            let falls: Vec<_> = heights.windows(2).map(|it| it[0] - it[1]).collect();
            let least = falls.iter().copied().fold(f64::INFINITY, f64::min);
            let most = falls.iter().copied().fold(0.0, f64::max);
            if most < 1.4 && least > best.0 {
                best = (least, at, *way);
            }
        }
    }
    let (_, at, way) = best;
    let place = ChartPoint::new(feet.chart, at.with_y(height_m(at) + 0.05));
    (place, way)
}

/// Throws what it is, slowly, so that it comes down across the slope.
fn let_roll(scene: &mut Scene, way: DVec3) {
    scene.aim(way.z.atan2(way.x), -0.4);
    steps(scene, 1, &Actions::default());
    scene.throw_away(LOG);
}

#[test]
fn a_log_rolls_down_a_slope_and_comes_to_rest_and_other_things_do_not_roll() {
    for geometry in Geometry::ALL {
        let fallen_m = |stack: Stack| {
            let mut scene = scene(geometry);
            let (top, way) = slope(&scene);
            scene.teleport(top);
            assert!(scene.settle(LIMIT));
            scene.aim(way.z.atan2(way.x), -0.4);
            steps(&mut scene, 1, &Actions::default());
            scene.throw_away(stack);
            steps(&mut scene, 90, &Actions::default());
            let lay = DVec3::from(scene.probe().drops[0].pos);
            steps(&mut scene, 2000, &Actions::default());
            let drops = scene.probe().drops;
            // What lies within reach has been picked up.
            let lies = drops.first().map_or(lay, |it| DVec3::from(it.pos));
            steps(&mut scene, 60, &Actions::default());
            let still = scene.probe().drops.first().map(|it| DVec3::from(it.pos));
            assert!(
                still.is_none_or(|at| at == lies),
                "{geometry:?}: it rolls on"
            );
            (lies - scene.feet().pos).with_y(0.0).length()
        };
        let log_m = fallen_m(LOG);
        let gun_m = fallen_m(Stack {
            item: Item::Gun,
            count: 1,
        });
        assert!(
            log_m > gun_m + 1.0,
            "{geometry:?}: {log_m} m, and {gun_m} m"
        );
    }
}

#[test]
fn a_log_that_rolls_fast_strikes_who_stands_below() {
    let mut scene = scene(Geometry::Euclidean);
    let (top, way) = slope(&scene);
    scene.teleport(top);
    assert!(scene.settle(LIMIT));
    let below = top.pos + way.normalize() * 3.2;
    let y = scene.field().surface_height(top.chart, below.x, below.z);
    let below = ChartPoint::new(top.chart, below.with_y(y + 0.05));
    let id = scene.spawn_bot(below, 0.0, false);
    let health = |scene: &Scene| {
        let bots = scene.bots();
        bots.iter().find(|it| it.bot.id == id).map(|it| it.health)
    };
    let before = health(&scene);
    let_roll(&mut scene, way);
    steps(&mut scene, 120, &Actions::default());
    let after = health(&scene);
    assert!(after < before, "{before:?}, then {after:?}");
    let left = before.zip(after).map(|(before, after)| before - after);
    assert!(
        left.is_some_and(|left| left < 8.0),
        "one blow, not many: {left:?}"
    );
}

#[test]
fn a_log_is_wood_to_who_gathers_and_itself_elsewhere() {
    for mode in [Mode::Gathering, Mode::Creative] {
        let mut scene = Scene::open(
            WorldSetup {
                mode,
                ..setup(Geometry::Euclidean)
            },
            None,
        )
        .unwrap();
        assert!(scene.wait_for_step(LIMIT));
        let logs = scene.inventory().count(Item::Log);
        scene.aim(0.0, -1.5);
        steps(&mut scene, 1, &Actions::default());
        scene.throw_away(Stack {
            item: Item::Log,
            count: 3,
        });
        steps(&mut scene, 200, &Actions::default());
        assert!(scene.probe().drops.is_empty(), "{mode:?}");
        assert_eq!(scene.health(), 20.0, "nobody strikes himself");
        let wood_m3 = scene.stock().map(|stock| stock.of(Kind::Wood));
        let more = scene.inventory().count(Item::Log) - logs;
        match mode {
            Mode::Gathering => assert!(more == 0 && (wood_m3.unwrap() - 0.3).abs() < 1e-9),
            Mode::Creative => assert!(more == 3 && wood_m3.is_none()),
        }
    }
}

/// A row of logs across the way along +x, so far ahead of the feet, in metres as bodies go.
fn fence(scene: &mut Scene, ahead_m: f64) {
    let feet = scene.feet();
    for n in -30..=30 {
        let off = DVec3::new(ahead_m, 0.0, 0.3 * f64::from(n));
        let at = BodyFrame::step(&**scene.strategy(), feet, off);
        let ChartPoint { chart, pos } = at.point;
        let y = scene.field().surface_height(chart, pos.x, pos.z);
        let foot = ChartPoint::new(chart, pos.with_y(y));
        assert!(scene.put_up(Item::Log, foot, -at.turn_rad, ""));
    }
}

#[test]
fn nobody_walks_through_a_log_that_was_put_up() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        let feet = scene.feet();
        fence(&mut scene, 2.0);
        scene.aim(0.0, 0.0);
        let ahead = Actions {
            forward: 1.0,
            ..Actions::default()
        };
        steps(&mut scene, 120, &ahead);
        let way_m = BodyFrame::way(&**scene.strategy(), feet, scene.feet()).x;
        assert!((0.5..2.0).contains(&way_m), "{geometry:?}: {way_m} m");
    }
}

#[test]
fn no_bullet_flies_through_a_log_that_was_put_up() {
    for geometry in Geometry::ALL {
        let flown_m = |has_fence: bool| {
            let mut scene = scene(geometry);
            let feet = scene.feet();
            if has_fence {
                fence(&mut scene, 3.0);
            }
            let over_m = Item::Log.stands().unwrap().middle_m;
            let y = scene
                .field()
                .surface_height(feet.chart, feet.pos.x + 3.0, feet.pos.z);
            let muzzle = DVec3::new(feet.pos.x + 2.0, y + over_m, feet.pos.z);
            steps(&mut scene, 1, &Actions::default());
            scene.throw_bullet(ChartPoint::new(feet.chart, muzzle), DVec3::X * 40.0);
            steps(&mut scene, 3, &Actions::default());
            scene.probe().projectiles[0].pos[0] - muzzle.x
        };
        assert!(flown_m(false) > 1.5, "{geometry:?}: nothing is in its way");
        assert!(flown_m(true) < 1.0, "{geometry:?}");
    }
}

/// Takes the player to where the ground ahead along +x is the smoothest for a dozen metres, so that no car leaps.
fn go_where_the_way_is_smooth(scene: &mut Scene) {
    let space = scene.strategy().clone();
    let field = scene.field().clone();
    let height_m = |at: ChartPoint| field.surface_height(at.chart, at.pos.x, at.pos.z);
    let rough_m = |from: ChartPoint| {
        let heights = (-3..=11).map(|m| {
            let at = BodyFrame::step(&*space, from, DVec3::X * f64::from(m)).point;
            height_m(at)
        });
        let heights: Vec<_> = heights.collect();
        let bends = heights
            .windows(3)
            .map(|it| (it[0] - 2.0 * it[1] + it[2]).abs());
        let rises = heights.windows(2).map(|it| 0.5 * (it[1] - it[0]).abs());
        bends.chain(rises).fold(0.0, f64::max)
    };
    let feet = scene.feet();
    let starts = (0..625).map(|n| {
        let off = DVec3::new(f64::from(n % 25) - 12.0, 0.0, f64::from(n / 25) - 12.0);
        feet.moved(off)
    });
    let best = starts.min_by(|a, b| rough_m(*a).total_cmp(&rough_m(*b)));
    let at = best.expect("a place among some");
    let foot = ChartPoint::new(at.chart, at.pos.with_y(height_m(at) + 0.1));
    scene.teleport(foot);
    assert!(scene.settle(LIMIT));
    steps(scene, 20, &still());
}

#[test]
fn no_car_drives_through_a_log_that_was_put_up() {
    for geometry in Geometry::ALL {
        let driven_m = |has_fence: bool| {
            let mut scene = scene(geometry);
            go_where_the_way_is_smooth(&mut scene);
            let feet = scene.feet();
            if has_fence {
                fence(&mut scene, 8.0);
            }
            let start = feet.moved(DVec3::new(-1.0, 0.3, 0.0));
            assert!(scene.spawn_car(start, 0.0));
            steps(&mut scene, 90, &still());
            stand_beside(&mut scene, 2.2);
            steps(&mut scene, 1, &enter());
            assert!(scene.is_driving(), "{:?}", scene.take_hints());
            let from = car(&scene).point;
            steps(&mut scene, 300, &ahead());
            // In metres of the space, as the way may lead over an edge of the charts.
            BodyFrame::way(&**scene.strategy(), from, car(&scene).point).x
        };
        let (free_m, stopped_m) = (driven_m(false), driven_m(true));
        assert!(free_m > 10.0, "{geometry:?}: {free_m} m");
        assert!(stopped_m < 8.0, "{geometry:?}: {stopped_m} m");
    }
}

fn take_in_hand(scene: &mut Scene) {
    assert_eq!(scene.inventory_mut().give(Item::Log, 5), 0);
    let slots = scene.inventory().slots();
    let is_log = |it: &Option<Stack>| it.is_some_and(|it| it.item == Item::Log);
    let slot = slots.iter().position(is_log).unwrap();
    scene.inventory_mut().select(slot as u8);
}

/// Puts up a log where one looks, or does not; how many stand.
fn put_where_one_looks(scene: &mut Scene, pitch: f64) -> (usize, Vec<Hint>) {
    scene.aim(0.0, pitch);
    steps(scene, 1, &Actions::default());
    scene.take_hints();
    let press = Actions {
        primary: true,
        ..Actions::default()
    };
    steps(scene, 1, &press);
    steps(scene, 1, &Actions::default());
    let stand = scene.probe().fixtures.len();
    (stand, scene.take_hints())
}

#[test]
fn a_log_is_put_up_beside_another_and_not_into_it() {
    let mut scene = scene(Geometry::Euclidean);
    let feet = scene.feet();
    let x = feet.pos.x + 3.0;
    let y = scene.field().surface_height(feet.chart, x, feet.pos.z);
    let foot = ChartPoint::new(feet.chart, DVec3::new(x, y, feet.pos.z));
    assert!(scene.put_up(Item::Log, foot, 0.0, ""));
    take_in_hand(&mut scene);
    let eye_m = scene.head().point.pos.y - y;
    let pitch = |up_m: f64, x_m: f64| -(eye_m - up_m).atan2(x_m);
    let (stand, hints) = put_where_one_looks(&mut scene, pitch(0.6, 3.0));
    assert!(
        stand == 1 && hints.contains(&Hint::NoPlaceFor(Item::Log)),
        "{hints:?}"
    );
    let (stand, hints) = put_where_one_looks(&mut scene, pitch(0.0, 2.4));
    assert_eq!(stand, 2, "{hints:?}");
}

#[test]
fn what_lies_on_logs_falls_when_they_are_taken_up() {
    let mut scene = scene(Geometry::Euclidean);
    let feet = scene.feet();
    for n in 0..36 {
        let by = DVec3::new(
            1.2 + 0.26 * f64::from(n % 6),
            0.0,
            0.26 * f64::from(n / 6) - 0.65,
        );
        let at = feet.pos + by;
        let y = scene.field().surface_height(feet.chart, at.x, at.z);
        let at = ChartPoint::new(feet.chart, at.with_y(y));
        assert!(scene.put_up(Item::Log, at, 0.0, ""));
    }
    steps(&mut scene, 1, &Actions::default());
    let flag = Stack {
        item: Item::Flag,
        count: 1,
    };
    // The highest of all.
    let up_m = |scene: &Scene| {
        let drops = scene.probe().drops;
        let up = drops.iter().map(|it| {
            let [x, y, z] = it.pos;
            y - scene.field().surface_height(feet.chart, x, z)
        });
        up.fold(0.0, f64::max)
    };
    for pitch in [0.6, 0.8, 1.0, 1.2] {
        scene.aim(0.0, pitch);
        steps(&mut scene, 1, &Actions::default());
        scene.throw_away(flag);
    }
    steps(&mut scene, 240, &Actions::default());
    assert!(up_m(&scene) > 1.0, "one lies on them: {}", up_m(&scene));
    take_in_hand(&mut scene);
    let press = Actions {
        secondary: true,
        ..Actions::default()
    };
    for _ in 0..80 {
        let Some(log) = scene.probe().fixtures.first().map(|it| DVec3::from(it.pos)) else {
            break;
        };
        let way = log + DVec3::Y * 0.6 - scene.head().point.pos;
        scene.aim(way.z.atan2(way.x), way.y.atan2(way.x.hypot(way.z)));
        steps(&mut scene, 1, &press);
        steps(&mut scene, 1, &Actions::default());
    }
    assert_eq!(scene.probe().fixtures.len(), 0);
    steps(&mut scene, 240, &Actions::default());
    assert!(up_m(&scene) < 0.4, "{} m up in the air", up_m(&scene));
}
