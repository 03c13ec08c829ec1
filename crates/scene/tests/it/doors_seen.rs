//! What is seen of doors, and through them.

use antipode_geometry::doorway::{BELOW_FOOT_M, HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{Doorway, Geometry, Leaf};
use antipode_scene::frame::{Figure, ModelId};
use antipode_scene::{Actions, Scene};
use glam::DVec3;

use crate::common::doors::{ahead, before_the_player, ground, local, put_up, still};
use crate::common::{LIMIT, steps};

/// From behind one sees who has gone through a door through that door, from feet to head, however steeply one looks down; and as
/// far back as the arm is long.
#[test]
fn the_camera_behind_looks_back_through_the_door_at_who_has_gone_through() {
    for geometry in Geometry::ALL {
        for pitch in [-0.35, 0.0] {
            let (mut scene, pair) = before_the_player(geometry);
            let [near, far] = pair.leaves;
            let toggle = Actions {
                toggle_camera: true,
                ..still()
            };
            steps(&mut scene, 1, &toggle);
            scene.aim(near.yaw, pitch);
            let mut looked = 0;
            for _ in 0..90 {
                steps(&mut scene, 1, &ahead());
                let walker = local(&scene, &far, scene.feet());
                if walker.length() > 4.0 || !(0.05..1.4).contains(&walker.x) {
                    continue;
                }
                looked += 1;
                let camera = local(&scene, &near, scene.eye().point);
                assert!(
                    camera.x < 0.0 && camera.length() < 7.0,
                    "{geometry} {pitch}: at {walker} beyond the door it is seen from {camera}"
                );
                for up_m in [0.3, 0.9, 1.6] {
                    let seen = walker + DVec3::Y * up_m;
                    let at = camera.lerp(seen, camera.x / (camera.x - seen.x));
                    let is_in =
                        at.z.abs() < HALF_WIDTH_M && (-BELOW_FOOT_M..HEIGHT_M).contains(&at.y);
                    assert!(
                        is_in,
                        "{geometry} {pitch}: {up_m} up of {walker} from {camera} at {at}"
                    );
                }
            }
            assert!(looked > 5, "{geometry} {pitch}");
        }
    }
}

/// What lies behind the far leaf is on another side: ground there keeps no camera from its place.
#[test]
fn ground_behind_the_far_leaf_is_not_in_the_cameras_way() {
    let (mut scene, pair) = before_the_player(Geometry::Euclidean);
    let [near, far] = pair.leaves;
    let stand = near.place(DVec3::X * -1.5);
    let from = far.place(DVec3::X * -8.0);
    scene.teleport(from.moved(DVec3::Y * 0.5));
    assert!(scene.wait_for_step(LIMIT));
    scene.inventory_mut().select(3);
    scene.aim(far.yaw, -0.35);
    let build = Actions {
        secondary: true,
        ..still()
    };
    steps(&mut scene, 150, &build);
    let hill = far.place(DVec3::new(-3.2, 9.0, 0.0));
    scene.teleport(hill);
    let top_m = scene.ground_height().unwrap();
    assert!(top_m > far.foot.pos.y + 2.2, "{top_m} {}", far.foot.pos.y);
    scene.teleport(stand.moved(DVec3::Y * 0.2));
    assert!(scene.wait_for_step(LIMIT));
    let toggle = Actions {
        toggle_camera: true,
        ..still()
    };
    steps(&mut scene, 1, &toggle);
    scene.aim(near.yaw, 0.0);
    while local(&scene, &far, scene.feet()).length() > 1.0 {
        steps(&mut scene, 1, &ahead());
    }
    let camera = local(&scene, &near, scene.eye().point);
    assert!(camera.x < -3.0, "{camera}");
}

/// Where a figure's cut lies, in the axes of each leaf: how far from it.
fn cut_off_m(scene: &Scene, pair: &Doorway, it: &Figure) -> f64 {
    let cut = it.cut.unwrap();
    let way = DVec3::new(cut.heading_rad.cos(), 0.0, cut.heading_rad.sin());
    let at = it.point.moved(way * cut.from_m);
    let off_m = |leaf| local(scene, leaf, at).x.abs();
    off_m(&pair.leaves[0]).min(off_m(&pair.leaves[1]))
}

/// Who stands in a door is seen before the one and behind the other leaf, each time as far as that.
#[test]
fn who_stands_in_a_door_is_shown_on_both_sides_of_it_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let [near, far] = pair.leaves;
        let toggle = Actions {
            toggle_camera: true,
            ..still()
        };
        steps(&mut scene, 1, &toggle);
        let own = |scene: &mut Scene| -> Vec<Figure> {
            let frame = scene.frame(1.2, 1.5, 1);
            let all = frame.content.figures.iter();
            all.filter(|it| it.model == ModelId::Astronaut)
                .copied()
                .collect()
        };
        assert!(own(&mut scene).iter().all(|it| it.cut.is_none()));
        let mut both = [0, 0];
        for _ in 0..60 {
            steps(&mut scene, 1, &ahead());
            let here = local(&scene, &near, scene.feet());
            let there = local(&scene, &far, scene.feet());
            let figures = own(&mut scene);
            if here.length().min(there.length()) > 0.9 {
                continue;
            }
            both[usize::from(there.length() < here.length())] += 1;
            assert_eq!(figures.len(), 2, "{geometry} {here} {there}");
            for it in &figures {
                let off_m = cut_off_m(&scene, &pair, it);
                assert!(off_m < 0.02, "{geometry}: cut {off_m} m from the leaf");
            }
            let at = |leaf| {
                figures
                    .iter()
                    .any(|it| local(&scene, leaf, it.point).length() < 1.2)
            };
            assert!(at(&near) && at(&far), "{geometry}");
        }
        assert!(both[0] > 3 && both[1] > 3, "{geometry}: {both:?}");
    }
}

/// A lamp before one leaf lights what is behind the other: a beam comes out of that, as wide as the opening.
#[test]
fn a_lamp_before_a_door_shines_out_of_the_other_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let [near, far] = pair.leaves;
        let beams = |scene: &mut Scene| scene.frame(1.2, 1.5, 1).content.lights.beams.clone();
        assert!(beams(&mut scene).is_empty(), "{geometry}");
        assert!(scene.spawn_lamp(near.place(DVec3::new(-1.5, 0.0, 0.2))));
        steps(&mut scene, 1, &still());
        let beams = beams(&mut scene);
        assert_eq!(beams.len(), 1, "{geometry}");
        let beam = beams[0];
        let from = local(&scene, &far, beam.point);
        assert!(
            (from.x + 1.5).abs() < 0.1 && from.length() < 2.0,
            "{geometry}: {from}"
        );
        assert_eq!(beam.behind, Some((far, true)), "{geometry}");
        // Its axis leads through the opening.
        let ahead = local(&scene, &far, beam.point.moved(beam.direction));
        let at = from.lerp(ahead, from.x / (from.x - ahead.x));
        assert!(
            at.z.abs() < 0.1 && (0.8..1.4).contains(&at.y),
            "{geometry}: {at}"
        );
        // A lamp that is farther off than its light reaches sends none.
        assert!(scene.spawn_lamp(near.place(DVec3::new(-14.0, 0.0, 0.0))));
        steps(&mut scene, 1, &still());
        assert_eq!(
            scene.frame(1.2, 1.5, 1).content.lights.beams.len(),
            1,
            "{geometry}"
        );
    }
}

/// An opening begins where the ground of the other side does.
#[test]
fn an_opening_begins_at_the_ground_of_the_other_side_in_every_space() {
    for geometry in Geometry::ALL {
        let (scene, pair) = before_the_player(geometry);
        let openings = scene.frame(1.2, 1.5, 1).openings;
        for (opening, far) in openings.iter().zip(pair.leaves.iter().rev()) {
            let last = (opening.sill_m.len() - 1) as f64;
            for (column, sill_m) in opening.sill_m.iter().enumerate() {
                let z = (2.0 * column as f64 / last - 1.0) * HALF_WIDTH_M;
                let under = far.place(DVec3::new(0.0, 0.0, z));
                let found = ground(&scene, under.chart, under.pos.x, under.pos.z);
                let found_m = local(&scene, far, found).y;
                assert!(
                    (sill_m - found_m).abs() < 0.08,
                    "{geometry} {column}: {sill_m} m, not {found_m} m"
                );
            }
        }
        assert_eq!(openings.len(), 2, "{geometry}");
    }
}

/// What is built at the other leaf, and carries that leaf up with it, is where the opening begins.
#[test]
fn an_opening_begins_at_what_was_built_at_the_other_leaf_in_every_space() {
    for geometry in Geometry::ALL {
        let (mut scene, pair) = before_the_player(geometry);
        let before = scene.frame(1.2, 1.5, 1).openings[0].sill_m;
        scene.inventory_mut().select(3);
        let build = Actions {
            secondary: true,
            ..still()
        };
        // Through the near leaf: at the ground half a metre before it.
        scene.teleport(pair.leaves[0].place(DVec3::new(-3.5, 1.0, 0.0)));
        assert!(scene.wait_for_step(LIMIT));
        steps(&mut scene, 40, &still());
        scene.aim(pair.leaves[0].yaw, -(1.6_f64 / 3.0).atan());
        steps(&mut scene, 45, &build);
        assert!(scene.settle(LIMIT));
        steps(&mut scene, 2, &still());
        let openings = scene.frame(1.2, 1.5, 1).openings;
        let (sills_m, far) = (openings[0].sill_m, openings[1].leaf);
        let last = (sills_m.len() - 1) as f64;
        for (column, sill_m) in sills_m.into_iter().enumerate() {
            let z = (2.0 * column as f64 / last - 1.0) * HALF_WIDTH_M;
            scene.teleport(far.place(DVec3::new(0.0, 7.0, z)));
            let found_m = scene.ground_height().unwrap() - far.foot.pos.y;
            let found_m = found_m.max(-BELOW_FOOT_M);
            assert!(
                (sill_m - found_m).abs() < 0.02,
                "{geometry} {column}: {sill_m} m, not {found_m} m"
            );
        }
        let most = before.iter().zip(sills_m).map(|(a, b)| (a - b).abs());
        let most_m = most.fold(0.0, f64::max);
        assert!(most_m > 0.2, "{geometry}: {most_m}");
    }
}

/// Where the ground lies lower behind the far leaf the body is on it at once, and the eye comes after it: the picture does not jump.
#[test]
fn the_eye_follows_a_body_that_a_door_has_set_lower() {
    let (scene, pair) = before_the_player(Geometry::Euclidean);
    let near = pair.leaves[0];
    // The far leaf floats over the ground.
    let far = Leaf {
        foot: pair.leaves[1].foot.moved(DVec3::Y * 0.5),
        ..pair.leaves[1]
    };
    let mut scene = {
        let feet = scene.feet();
        let yaw = scene.eye().yaw;
        let mut fresh = crate::common::scene(Geometry::Euclidean);
        fresh.set_npcs(antipode_scene::NpcMode::Still);
        fresh.teleport(feet.moved(DVec3::Y * 0.1));
        assert!(fresh.wait_for_step(LIMIT));
        steps(&mut fresh, 20, &still());
        fresh.aim(yaw, 0.0);
        put_up(&mut fresh, [near, far]);
        fresh
    };
    let up_m = |scene: &Scene, leaf: &Leaf| local(scene, leaf, scene.eye().point).y;
    let mut last_m = up_m(&scene, &near);
    let (mut worst_m, mut after) = (0.0f64, 0);
    while after < 40 {
        steps(&mut scene, 1, &ahead());
        let is_through = local(&scene, &far, scene.feet()).length() < 6.0;
        let now_m = up_m(&scene, if is_through { &far } else { &near });
        worst_m = worst_m.max((now_m - last_m).abs());
        (last_m, after) = (now_m, after + usize::from(is_through));
    }
    assert!(worst_m < 0.12, "{worst_m}");
    assert!(
        (last_m - 1.12).abs() < 0.25,
        "it has come down with the body: {last_m}"
    );
}
