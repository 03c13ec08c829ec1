//! What other figures do in a fight, as a player would notice it: in every space, and over the equator.

use crate::common::figures::{
    SECOND, away_m, beside, beside_turned, bot, look_at, open_turns_rad, pass, shoot, world,
};
use crate::common::steps;
use antipode_geometry::Geometry;
use antipode_scene::tuning::FULL_HEALTH;
use antipode_scene::{Actions, Scene, State};

#[test]
fn hostile_ones_notice_come_keep_their_distance_and_hit() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 20.0, 3.0);
        let crosses = place.chart != scene.feet().chart;
        assert_eq!(crosses, geometry == Geometry::Spherical, "over the equator");
        let id = scene.spawn_bot(place, 3.0, true);
        pass(&mut scene, 1.0);
        assert_eq!(bot(&scene, id).state, State::Chase, "{geometry:?}");
        pass(&mut scene, 2.5);
        assert!(
            scene.projectiles().is_empty(),
            "{geometry:?}: it shoots at once"
        );
        for second in 0..20 {
            pass(&mut scene, 1.0);
            let away_m = away_m(&scene, bot(&scene, id).point);
            let keeps = second < 2 || (6.5..13.5).contains(&away_m);
            assert!(keeps, "{geometry:?}: {away_m} m away after {second} s");
        }
        let lost = FULL_HEALTH - scene.health();
        assert!((2.0..18.0).contains(&lost), "{geometry:?}: {lost} lost");
    }
}

#[test]
fn a_hostile_one_backs_off_from_who_comes_too_near() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 3.0, 0.5);
        let id = scene.spawn_bot(place, 3.0, true);
        pass(&mut scene, 4.0);
        let away_m = away_m(&scene, bot(&scene, id).point);
        assert!(away_m > 6.0, "{geometry:?}: only {away_m} m away");
    }
}

#[test]
fn who_runs_across_is_led_and_hit() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 10.0, 0.0);
        let id = scene.spawn_bot(place, 3.0, true);
        pass(&mut scene, 3.5);
        let (mut hits, mut health) = (0, scene.health());
        let mut shots = std::collections::BTreeSet::new();
        for step in 0..60 * SECOND {
            // To and fro across its line of sight, three seconds each way: nobody can lead a turn.
            let there = bot(&scene, id).point;
            look_at(&mut scene, there);
            let side = if (step / (3 * SECOND)).is_multiple_of(2) {
                1.0
            } else {
                -1.0
            };
            let walk = Actions {
                strafe: side,
                ..Actions::default()
            };
            if step % SECOND == 0 {
                scene.set_health(FULL_HEALTH);
                health = FULL_HEALTH;
            }
            steps(&mut scene, 1, &walk);
            shots.extend(scene.projectiles().iter().map(|(id, _)| *id));
            hits += usize::from(scene.health() < health);
            health = scene.health();
        }
        println!("{geometry:?}: {hits} of {}", shots.len());
        assert!(
            shots.len() > 15 && 3 * hits > shots.len(),
            "{geometry:?}: {hits} of {}",
            shots.len()
        );
    }
}

#[test]
fn nobody_is_seen_or_shot_through_the_ground() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let dig = Actions {
            slot: Some(3),
            primary: true,
            ..Actions::default()
        };
        scene.aim(0.0, -1.5);
        steps(&mut scene, 6 * SECOND, &dig);
        let depth_m = beside(&scene, 0.0, 0.0).pos.y - scene.feet().pos.y;
        assert!(depth_m > 6.0, "{geometry:?}: the pit is {depth_m} m deep");
        pass(&mut scene, 2.0);
        let place = beside(&scene, 16.0, 0.0);
        let health = scene.health();
        let id = scene.spawn_bot(place, 3.0, true);
        for _ in 0..20 * SECOND {
            steps(&mut scene, 1, &Actions::default());
            let view = bot(&scene, id);
            if away_m(&scene, view.point) < 14.0 {
                // It came to the brim and may look in.
                break;
            }
            let knows = matches!(view.state, State::Chase | State::Fight | State::Search);
            assert!(!knows, "{geometry:?}: {view:?} sees into the pit");
            assert!(scene.projectiles().is_empty() && scene.health() >= health);
        }
    }
}

#[test]
fn they_do_not_shoot_through_one_another() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        // One behind the other, all with the player in sight over the shoulders before them.
        let ids = [9.0, 11.0, 13.0, 15.0, 17.0].map(|x| {
            let place = beside(&scene, x, 0.1 * x);
            scene.spawn_bot(place, 3.0, true)
        });
        let (mut shots, mut hurt) = (std::collections::BTreeSet::new(), 0);
        let mut health = [3.0; 5];
        for _ in 0..25 * SECOND {
            steps(&mut scene, 1, &Actions::default());
            scene.set_health(FULL_HEALTH);
            shots.extend(scene.projectiles().iter().map(|(id, _)| *id));
            for (id, last) in ids.iter().zip(&mut health) {
                let now = bot(&scene, *id).health;
                hurt += usize::from(now < *last);
                *last = now;
            }
        }
        println!("{geometry:?}: {hurt} of {} met a friend", shots.len());
        assert!(
            shots.len() > 20 && 20 * hurt < shots.len(),
            "{geometry:?}: {hurt} of {}",
            shots.len()
        );
    }
}

#[test]
fn a_peaceful_one_that_is_hit_and_a_friend_who_sees_it_fight_back_and_calm_down() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let turn_rad = open_turns_rad(&scene, 9.0)[0];
        let at = |x, z| beside_turned(&scene, turn_rad, x, z);
        let [a, b, far] = [(9.0, 0.0), (9.0, 3.0), (-34.0, 20.0)].map(|(x, z)| at(x, z));
        let [hit, friend, stranger] =
            [a, b, far].map(|place| scene.spawn_bot(place, 3.0 + turn_rad, false));
        pass(&mut scene, 0.2);
        shoot(&mut scene, hit);
        assert!(bot(&scene, hit).health < 3.0, "{geometry:?}");
        assert!(
            bot(&scene, hit).fights && bot(&scene, friend).fights,
            "{geometry:?}"
        );
        assert!(!bot(&scene, stranger).fights, "{geometry:?}");
        pass(&mut scene, 12.0);
        assert!(
            scene.health() < FULL_HEALTH,
            "{geometry:?}: they shoot back"
        );
        scene.set_health(FULL_HEALTH);
        for _ in 0..35 {
            pass(&mut scene, 1.0);
            scene.set_health(FULL_HEALTH);
        }
        assert!(!bot(&scene, friend).fights, "{geometry:?}: it calms down");
        let state = bot(&scene, friend).state;
        assert!(!matches!(state, State::Fight | State::Chase), "{state:?}");
    }
}

#[test]
fn with_little_health_one_flees_and_comes_back_healed() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let turn_rad = open_turns_rad(&scene, 9.0)[0];
        let place = beside_turned(&scene, turn_rad, 9.0, 0.0);
        let id = scene.spawn_bot(place, 3.0 + turn_rad, true);
        pass(&mut scene, 0.5);
        for _ in 0..6 {
            if bot(&scene, id).health > 1.0 {
                shoot(&mut scene, id);
            }
        }
        assert_eq!(
            bot(&scene, id).health.to_bits(),
            1.0_f64.to_bits(),
            "{geometry:?}"
        );
        let before_m = away_m(&scene, bot(&scene, id).point);
        pass(&mut scene, 4.0);
        let view = bot(&scene, id);
        assert_eq!(view.state, State::Flee, "{geometry:?}");
        let after_m = away_m(&scene, view.point);
        assert!(
            after_m > before_m + 5.0,
            "{geometry:?}: {before_m} to {after_m} m"
        );
        pass(&mut scene, 30.0);
        assert!(bot(&scene, id).health > 2.0, "{geometry:?}");
    }
}

#[test]
fn a_shot_out_of_sight_is_heard_and_looked_into() {
    let mut scene = world(Geometry::Euclidean);
    let place = beside(&scene, 28.0, 0.0);
    // It looks away, so it does not see the player.
    let id = scene.spawn_bot(place, 0.0, true);
    pass(&mut scene, 0.5);
    assert!(matches!(bot(&scene, id).state, State::Idle | State::Wander));
    let fire = Actions {
        slot: Some(0),
        primary: true,
        ..Actions::default()
    };
    scene.aim(3.0, 1.2);
    steps(
        &mut scene,
        1,
        &Actions {
            primary: false,
            ..fire
        },
    );
    steps(&mut scene, 1, &fire);
    pass(&mut scene, 1.5);
    let state = bot(&scene, id).state;
    assert!(matches!(state, State::Search | State::Chase), "{state:?}");
}

#[test]
fn the_dead_leave_bullets_that_can_be_picked_up() {
    let mut scene = world(Geometry::Euclidean);
    let place = beside(&scene, 6.0, 0.0);
    let id = scene.spawn_bot(place, 3.0, true);
    pass(&mut scene, 0.2);
    let bullets = |scene: &Scene| {
        let probe = scene.probe();
        let of = |id: &str| {
            let slots = probe.inventory.iter().filter(|it| it.stack.item.id() == id);
            slots.map(|it| it.stack.count).sum::<u32>()
        };
        of("bullet")
    };
    let mut last = place;
    for _ in 0..8 {
        if let Some(view) = scene.bots().iter().find(|view| view.bot.id == id)
            && view.health > 0.0
        {
            last = view.point;
            shoot(&mut scene, id);
        }
    }
    let dead = bot(&scene, id);
    assert_eq!(dead.state, State::Dead);
    assert_eq!(scene.drops().len(), 1);
    let left = scene.drops()[0].stack.count;
    assert!((4..=8).contains(&left), "{left}");
    pass(&mut scene, 4.0);
    assert!(scene.bots().is_empty(), "it is gone");
    let before = bullets(&scene);
    for _ in 0..8 * SECOND {
        let drop = scene.drops().first().map(|drop| drop.point);
        look_at(&mut scene, drop.unwrap_or(last));
        let walk = Actions {
            forward: f64::from(u8::from(drop.is_some())),
            ..Actions::default()
        };
        steps(&mut scene, 1, &walk);
    }
    assert!(scene.drops().is_empty(), "picked up");
    assert_eq!(bullets(&scene), before + left);
}

#[test]
fn who_stands_up_again_is_invulnerable_for_some_seconds_unless_he_shoots() {
    for shoots in [false, true] {
        let mut scene = world(Geometry::Euclidean);
        let place = beside(&scene, 10.0, 0.0);
        scene.spawn_bot(place, 3.0, true);
        scene.set_health(1.0);
        for _ in 0..60 {
            pass(&mut scene, 0.5);
            if scene.is_dead() {
                break;
            }
        }
        assert!(scene.is_dead(), "nobody shot");
        while scene.is_dead() {
            pass(&mut scene, 0.1);
        }
        assert!(scene.bots().is_empty(), "who killed is gone");
        // The next one.
        let place = beside(&scene, 10.0, 0.0);
        let id = scene.spawn_bot(place, 3.0, true);
        pass(&mut scene, 0.5);
        let fights = |scene: &Scene| matches!(bot(scene, id).state, State::Chase | State::Fight);
        if shoots {
            shoot(&mut scene, id);
            pass(&mut scene, 3.0);
            assert!(fights(&scene), "{:?}", bot(&scene, id).state);
        } else {
            for _ in 0..12 {
                pass(&mut scene, 0.5);
                assert!(!fights(&scene));
            }
            assert!(scene.health() >= FULL_HEALTH);
            pass(&mut scene, 10.0);
            assert!(fights(&scene), "never again: {:?}", bot(&scene, id).state);
        }
    }
}
