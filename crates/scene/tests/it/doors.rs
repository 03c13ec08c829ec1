//! Doors: put up in pairs, gone through by everything, kept.

use antipode_geometry::{ChartId, ChartPoint, Doorway, Eye, Geometry, Leaf};
use antipode_items::Item;
use antipode_scene::notice::Hint;
use antipode_scene::{Actions, CarView, NpcMode};
use glam::DVec3;

use crate::common::cars::{car, enter, stand_beside};
use crate::common::doors::{
    ahead, before_the_player, ground, leaf, level_strip, local, press, put_up, still,
};
use crate::common::{LIMIT, scene, steps};

#[test]
fn who_walks_into_one_comes_out_of_the_other_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let [near, far] = pair.leaves;
        let from = local(&scene, &near, scene.feet());
        assert!(from.x < -1.5, "{geometry} {from}");
        let mut steps_before = 0;
        while local(&scene, &near, scene.feet()).x < 0.0
            && local(&scene, &near, scene.feet()).length() < 4.0
        {
            steps(&mut scene, 1, &ahead());
            steps_before += 1;
            assert!(steps_before < 120, "{geometry}");
        }
        let out = local(&scene, &far, scene.feet());
        assert!(
            out.x > 0.0 && out.length() < 0.6,
            "{geometry}: {out} of the far door, {} of the near one",
            local(&scene, &near, scene.feet())
        );
        let yaw = scene.eye().yaw;
        let turned = (yaw - far.yaw).sin();
        assert!(turned.abs() < 0.02, "{geometry}: {yaw} {turned}");
        assert_eq!(scene.eye().pitch, 0.0, "the view stays level");
        // On he goes, away from it, and by turning round back to where he came from.
        steps(&mut scene, 15, &ahead());
        let on = local(&scene, &far, scene.feet());
        assert!(on.x > out.x + 0.5, "{geometry}: {out} {on}");
        scene.aim(scene.eye().yaw + std::f64::consts::PI, 0.0);
        steps(&mut scene, 50, &ahead());
        let back = local(&scene, &near, scene.feet());
        assert!(
            back.x < 0.0 && back.length() < 4.0,
            "{geometry}: {back} of the near door"
        );
    }
}

#[test]
fn a_bullet_a_thing_and_the_crosshair_go_through_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let [near, far] = pair.leaves;
        // A little downwards, so that what is dug lies behind the far door.
        scene.aim(near.yaw, -0.35);
        scene.inventory_mut().select(3);
        steps(&mut scene, 1, &still());
        let mark = scene.probe().marker.pos.unwrap();
        let charts = [near.foot.chart, far.foot.chart];
        let at = |leaf: &Leaf, chart| {
            let point = ChartPoint::new(chart, DVec3::from_array(mark));
            local(&scene, leaf, point)
        };
        let behind_far = charts.iter().map(|chart| at(&far, *chart));
        let found = behind_far.min_by(|a, b| a.length().total_cmp(&b.length()));
        let found = found.unwrap();
        assert!(
            found.x > 0.1 && found.length() < 9.0,
            "{geometry}: the pick marks {found}"
        );

        let muzzle = near.place(DVec3::new(-0.5, 1.2, 0.1));
        scene.throw_bullet(muzzle, near.through() * 40.0);
        steps(&mut scene, 2, &still());
        let bullet = &scene.probe().projectiles[0];
        let point = ChartPoint::new(
            if bullet.hemisphere == "B" {
                ChartId::SECOND
            } else {
                ChartId::FIRST
            },
            DVec3::from_array(bullet.pos),
        );
        let flown = local(&scene, &far, point);
        // As far in the space as it would have flown before the near one, and straight on.
        let sills = [near, far].map(|leaf| leaf.place(DVec3::new(0.0, 1.2, 0.1)));
        let way_m = |a, b| scene.strategy().distance_m(a, b, &Eye::default());
        let metre = if scene.strategy().moves_in_chart() {
            way_m(muzzle, sills[0]) / 0.5
        } else {
            1.0
        };
        let off_m = way_m(muzzle, sills[0]) + way_m(sills[1], point) - metre * 40.0 / 30.0;
        let aside_m = (flown.y - 1.2).hypot(flown.z - 0.1);
        assert!(
            flown.x > 0.0 && off_m.abs().hypot(aside_m) < 0.1,
            "{geometry}: {flown} {off_m}"
        );

        scene.aim(near.yaw, 0.0);
        let drop = Actions {
            drop_one: true,
            ..still()
        };
        steps(&mut scene, 1, &drop);
        steps(&mut scene, 90, &still());
        let drops = scene.probe().drops;
        let lies = drops.iter().any(|it| {
            let chart = if it.hemisphere == "B" {
                ChartId::SECOND
            } else {
                ChartId::FIRST
            };
            let point = ChartPoint::new(chart, DVec3::from_array(it.pos));
            let there = local(&scene, &far, point);
            there.x > 0.0 && there.length() < 5.0
        });
        assert!(lies, "{geometry}: {drops:?}");
    }
}

#[test]
fn digging_through_a_door_digs_on_the_other_side() {
    let (mut scene, pair) = before_the_player(Geometry::Euclidean);
    let [near, far] = pair.leaves;
    scene.aim(near.yaw, -0.35);
    scene.inventory_mut().select(3);
    steps(&mut scene, 1, &still());
    let before = scene.probe().marker.pos.unwrap();
    let dig = Actions {
        primary: true,
        ..still()
    };
    steps(&mut scene, 90, &dig);
    let after = scene.probe().marker.pos.unwrap();
    let at = |pos: [f64; 3]| far.local(DVec3::from_array(pos));
    assert!(
        at(after).x > at(before).x + 0.3,
        "{} {}",
        at(before),
        at(after)
    );
}

#[test]
fn a_click_puts_up_the_first_and_the_second_and_a_third_moves_the_older() {
    let mut scene = scene(Geometry::Euclidean);
    // There is to be room for it in the hotbar.
    assert!(scene.inventory_mut().take_from(8, true).is_some());
    assert_eq!(scene.inventory_mut().give(Item::Door, 1), 0);
    let slots = scene.inventory().slots();
    let is_door = |slot: &Option<antipode_scene::Stack>| {
        slot.is_some_and(|it| it.item == Item::Door && it.count == 2)
    };
    let slot = slots.iter().position(is_door).unwrap();
    scene.inventory_mut().select(slot as u8);
    scene.take_hints();
    let mut last = Vec::new();
    for (yaw, count) in [(0.3, 1), (1.4, 2)] {
        scene.aim(yaw, -0.5);
        press(&mut scene, true);
        last = scene.probe().doors;
        assert_eq!(last.len(), count, "{:?}", scene.take_hints());
        // Its front looks back at who put it up.
        let off = (last[count - 1].yaw.to_radians() - yaw - std::f64::consts::PI).sin();
        assert!(off.abs() < 1e-9, "{off}");
    }
    let left = scene.inventory().count(Item::Door);
    let slots = scene.inventory().slots();
    let is_door =
        |slot: &Option<antipode_scene::Stack>| slot.is_some_and(|it| it.item == Item::Door);
    let slot = slots.iter().position(is_door).unwrap();
    scene.inventory_mut().select(slot as u8);
    scene.aim(0.2, -0.5);
    press(&mut scene, true);
    let now = scene.probe().doors;
    assert_eq!(now.len(), 2);
    assert_eq!(now[0], last[1], "the newer is the older now");
    assert!(scene.take_hints().contains(&Hint::MovedOldest(Item::Door)));
    assert_eq!(scene.inventory().count(Item::Door), left);
    assert_eq!(scene.door_ways().len(), 2);
    // The one before the player is taken up again.
    press(&mut scene, false);
    assert_eq!(scene.probe().doors, now[..1]);
    assert_eq!(scene.inventory().count(Item::Door), left + 1);
}

#[cfg(unix)]
#[test]
fn doors_are_kept_with_the_way_that_they_look() {
    let (kept, mut scene) = crate::common::kept::Kept::new();
    let feet = scene.feet();
    for (x, yaw) in [(3.0, 1.25), (-4.0, -2.5)] {
        let at = feet.moved(DVec3::new(x, 0.0, 1.0));
        assert!(scene.put_up(Item::Door, at, yaw, ""));
    }
    assert!(!scene.put_up(Item::Door, feet, 0.0, ""), "one pair a world");
    let before = scene.probe().doors;
    assert_eq!(before.len(), 2);
    scene.close().unwrap();
    let scene = kept.open();
    assert_eq!(scene.probe().doors, before);
    scene.close().unwrap();
}

#[test]
fn a_far_door_has_its_land_and_its_ground() {
    let mut scene = scene(Geometry::Euclidean);
    let feet = scene.feet();
    let near = leaf(&scene, feet.chart, feet.pos.x + 2.0, feet.pos.z, 0.0);
    let far = leaf(&scene, feet.chart, feet.pos.x + 900.0, feet.pos.z, 0.0);
    put_up(&mut scene, [near, far]);
    assert!(scene.settle(LIMIT));
    scene.aim(0.0, 0.0);
    steps(&mut scene, 45, &ahead());
    let out = far.local(scene.feet().pos);
    assert!(out.x > 0.0 && out.length() < 4.0, "{out}");
    assert!(scene.probe().player.grounded, "{out}");
}

#[test]
fn a_figure_goes_through_as_the_player_does() {
    let (mut scene, pair) = before_the_player(Geometry::Euclidean);
    let [near, far] = pair.leaves;
    scene.set_npcs(NpcMode::On);
    // It makes room for the player, who stands close behind it.
    let at = near.place(DVec3::new(-0.15, 0.0, 0.0));
    scene.spawn_bot(at, near.yaw, false);
    let behind = near.place(DVec3::new(-0.6, 0.2, 0.0));
    scene.teleport(behind);
    let mut came = false;
    for _ in 0..240 {
        steps(&mut scene, 1, &still());
        let bots = scene.probe().bots;
        came |= bots.iter().any(|bot| {
            let there = far.local(DVec3::from_array(bot.pos));
            there.x > 0.0 && there.length() < 3.0
        });
    }
    assert!(came, "{:?}", scene.probe().bots);
}

/// By what share the speed of a car in the space changed in a step besides what it changed in the one before, in which it was
/// driven alike; and by how many radians its way did besides the doors' own turn.
fn changes(pair: &Doorway, [first, before, after]: [&CarView; 3]) -> [f64; 2] {
    let [near, far] = pair.leaves;
    let [a, b, c] = [first, before, after].map(|car| car.velocity.length());
    let turned = after.yaw() - before.yaw() - (far.yaw - near.yaw);
    [(c / b - b / a).abs(), turned.sin().abs()]
}

/// A car is driven into one door and out of the other, which stands behind its start and looks the same way but for a little,
/// a hundred times round.
#[test]
fn a_car_goes_through_a_hundred_times_and_keeps_its_speed_and_its_way() {
    const HALF_M: f64 = 6.0;
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        scene.set_npcs(NpcMode::Still);
        let (at, yaw) = level_strip(&scene, scene.feet(), 14.0, HALF_M + 1.0);
        assert!(scene.spawn_car(at, yaw));
        steps(&mut scene, 150, &still());
        stand_beside(&mut scene, 2.2);
        steps(&mut scene, 1, &enter());
        assert!(scene.is_driving(), "{geometry}: {:?}", scene.take_hints());
        let start = car(&scene);
        let (middle, yaw) = (start.point.pos, start.yaw());
        let way = DVec3::new(yaw.cos(), 0.0, yaw.sin());
        let [near, far] = [HALF_M, -HALF_M].map(|m| {
            let at = middle + way * m;
            leaf(&scene, start.point.chart, at.x, at.z, yaw)
        });
        let pair = put_up(&mut scene, [near, far]);
        let (mut passed, mut worst, mut idle) = (0, [0.0f64; 2], 0);
        let mut first = start;
        while passed < 100 {
            let before = car(&scene);
            let at = near.local(before.point.pos);
            let off_rad = (before.yaw() - near.yaw).sin();
            let speed_m_s = before.velocity.length();
            let coasts = at.x.abs() < 0.8 && speed_m_s > 2.5 || speed_m_s > 5.0;
            let wish = Actions {
                forward: if coasts { 0.0 } else { 1.0 },
                strafe: (-0.8 * at.z - 2.5 * off_rad).clamp(-1.0, 1.0),
                ..still()
            };
            steps(&mut scene, 1, &wish);
            let now = car(&scene);
            idle += 1;
            if now.point.pos.distance(before.point.pos) > HALF_M {
                let changed = changes(&pair, [&first, &before, &now]);
                worst = [worst[0].max(changed[0]), worst[1].max(changed[1])];
                (passed, idle) = (passed + 1, 0);
            }
            first = before;
            assert!(
                idle < 900,
                "{geometry}: stuck in drive {passed} at {at}, {now:?}"
            );
        }
        assert!(worst[0] < 0.01 && worst[1] < 0.01, "{geometry}: {worst:?}");
    }
}

/// Where a metre of the chart is up to 1.45 of the space's a door is as wide as elsewhere, and leads on as straight.
#[test]
fn near_a_corner_of_squares_one_walks_through_as_far_from_the_post_and_not_beside_it() {
    for (aside_m, passes) in [(0.6, true), (-0.6, true), (1.5, false), (-1.5, false)] {
        for yaw in [0.8, -0.8, 2.4] {
            let mut scene = scene(Geometry::HyperbolicWorld);
            scene.set_npcs(NpcMode::Still);
            let leaves = [(27.0, 28.0, yaw), (-12.0, 5.0, 0.3)];
            let leaves = leaves.map(|(x, z, yaw)| leaf(&scene, ChartId::FIRST, x, z, yaw));
            let [near, far] = put_up(&mut scene, leaves).leaves;
            let at = near.place(DVec3::new(-1.0, 0.0, aside_m));
            scene.teleport(ground(&scene, at.chart, at.pos.x, at.pos.z).moved(DVec3::Y * 0.05));
            assert!(scene.settle(LIMIT));
            scene.aim(yaw, 0.0);
            steps(&mut scene, 40, &ahead());
            let told = format!("{yaw} {aside_m}");
            let reached = scene.strategy().carry_near(scene.feet(), far.foot);
            let reached = reached.map(|it| far.local(it.point.pos));
            let is_beyond = reached.filter(|it| it.length() < 4.0);
            assert_eq!(is_beyond.is_some(), passes, "{told}: {reached:?}");
            if let Some(it) = is_beyond {
                assert!(it.x > 0.0 && (it.z - aside_m).abs() < 0.1, "{told}: {it}");
            }
        }
    }
}
