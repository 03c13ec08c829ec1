//! What other figures do, as a player would notice it: in every space, and over the equator.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod common;

use antipode_geometry::{ChartPoint, Eye, Geometry, Hemisphere};
use antipode_scene::bot::BotView;
use antipode_scene::tuning::FULL_HEALTH;
use antipode_scene::{Actions, Hint, Line, NpcMode, Scene, State};
use common::{scene, steps};
use glam::DVec3;

/// Steps in a second.
const SECOND: usize = 60;

/// The ground at some metres from the player in the player's chart; over the rim in the other.
fn beside(scene: &Scene, dx: f64, dz: f64) -> ChartPoint {
    let field = antipode_terrain::Field::new(scene.setup().seed, scene.strategy().clone());
    let feet = scene.feet();
    let mut point = feet.moved(DVec3::new(dx, 0.0, dz));
    if let Some(crossing) = scene.strategy().cross(point) {
        point = crossing.point;
    }
    point.pos.y = field.surface_height(point.hemisphere, point.pos.x, point.pos.z) + 0.2;
    point
}

fn bot(scene: &Scene, id: u32) -> BotView {
    let bots = scene.bots();
    *bots
        .iter()
        .find(|view| view.bot.id == id)
        .expect("it lives")
}

fn away_m(scene: &Scene, point: ChartPoint) -> f64 {
    let feet = scene.feet();
    let eye = Eye {
        point: feet,
        ..Eye::default()
    };
    scene.strategy().distance_m(feet, point, &eye)
}

/// Puts the player near the equator of a closed world, in hemisphere A.
fn go_to_equator(scene: &mut Scene) {
    let rim_m = scene.strategy().rim_m().unwrap();
    let field = antipode_terrain::Field::new(scene.setup().seed, scene.strategy().clone());
    let x = rim_m - 4.0;
    let y = field.surface_height(Hemisphere::A, x, 0.0) + 0.2;
    scene.teleport(ChartPoint::a(DVec3::new(x, y, 0.0)));
    steps(scene, SECOND / 2, &Actions::default());
}

/// A world of that kind with the player on the ground, in a closed one by the equator.
fn world(geometry: Geometry) -> Scene {
    let mut scene = scene(geometry);
    steps(&mut scene, SECOND / 2, &Actions::default());
    if scene.strategy().rim_m().is_some() {
        go_to_equator(&mut scene);
    }
    scene
}

fn pass(scene: &mut Scene, seconds: f64) {
    steps(
        scene,
        (seconds * SECOND as f64) as usize,
        &Actions::default(),
    );
}

/// Points the view at a place as the picture shows it.
fn look_at(scene: &mut Scene, point: ChartPoint) {
    let eye = scene.eye();
    let view = scene.frame(1.3, 1.7, 1).strategy.view_point(&eye, point);
    let way = eye.to_chart(view.truncate().normalize());
    scene.aim(way.z.atan2(way.x), way.y.clamp(-1.0, 1.0).asin());
}

/// Fires the gun once at a figure's middle, and waits for the bullet.
fn shoot(scene: &mut Scene, id: u32) {
    let point = bot(scene, id).point.moved(DVec3::Y);
    let gun = Actions {
        slot: Some(0),
        ..Actions::default()
    };
    steps(scene, 1, &gun);
    look_at(scene, point);
    let pull = Actions {
        primary: true,
        ..Actions::default()
    };
    steps(scene, 1, &pull);
    pass(scene, 0.5);
}

#[test]
fn peaceful_ones_walk_about_and_get_on_in_every_space_and_over_the_equator() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let ids = [(12.0, 0.0), (-8.0, 9.0), (3.0, -14.0), (-6.0, -7.0)].map(|(x, z)| {
            let place = beside(&scene, x, z);
            scene.spawn_bot(place, 0.0, false)
        });
        let mut gone_m = [0.0; 4];
        let mut at = ids.map(|id| bot(&scene, id).point);
        let mut still_s = [0; 4];
        let mut charts = std::collections::BTreeSet::new();
        for _ in 0..60 {
            pass(&mut scene, 1.0);
            for (index, id) in ids.into_iter().enumerate() {
                let view = bot(&scene, id);
                charts.insert(format!("{:?}", view.point.hemisphere));
                let eye = Eye {
                    point: at[index],
                    ..Eye::default()
                };
                let step_m = scene.strategy().distance_m(at[index], view.point, &eye);
                gone_m[index] += step_m;
                at[index] = view.point;
                let waits = view.state == State::Wander && step_m < 0.3;
                still_s[index] = if waits { still_s[index] + 1 } else { 0 };
                assert!(
                    still_s[index] < 5,
                    "{geometry:?}: {id} is stuck at {view:?}"
                );
                assert!(!view.fights && scene.projectiles().is_empty());
                let field =
                    antipode_terrain::Field::new(scene.setup().seed, scene.strategy().clone());
                let middle = view.point.moved(DVec3::Y);
                assert!(field.sample(middle) > 0.0, "{geometry:?}: {id} is in rock");
            }
        }
        assert!(
            gone_m.iter().all(|gone_m| *gone_m > 15.0),
            "{geometry:?}: they went {gone_m:?} m in a minute"
        );
        if geometry == Geometry::Spherical {
            assert_eq!(charts.len(), 2, "in both hemispheres");
        }
    }
}

#[test]
fn hostile_ones_notice_come_keep_their_distance_and_hit() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 20.0, 3.0);
        let crosses = place.hemisphere != scene.feet().hemisphere;
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
        for step in 0..20 * SECOND {
            // To and fro across its line of sight, a second and a half each way.
            let there = bot(&scene, id).point;
            look_at(&mut scene, there);
            let side = if (step / 90) % 2 == 0 { 1.0 } else { -1.0 };
            let walk = Actions {
                strafe: side,
                ..Actions::default()
            };
            steps(&mut scene, 1, &walk);
            shots.extend(scene.projectiles().iter().map(|bullet| bullet.id));
            hits += usize::from(scene.health() < health);
            health = scene.health();
        }
        println!("{geometry:?}: {hits} of {}", shots.len());
        assert!(
            shots.len() > 5 && 3 * hits > shots.len(),
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
            if !scene.projectiles().is_empty() {
                // It came to the brim and looks in.
                assert!(away_m(&scene, view.point) < 14.0);
                break;
            }
            assert!(scene.health() >= health);
        }
    }
}

#[test]
fn a_peaceful_one_that_is_hit_and_a_friend_who_sees_it_fight_back_and_calm_down() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let (a, b) = (beside(&scene, 9.0, 0.0), beside(&scene, 9.0, 3.0));
        let (hit, friend) = (
            scene.spawn_bot(a, 3.0, false),
            scene.spawn_bot(b, 3.0, false),
        );
        let far = beside(&scene, -34.0, 20.0);
        let stranger = scene.spawn_bot(far, 3.0, false);
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
        let place = beside(&scene, 9.0, 0.0);
        let id = scene.spawn_bot(place, 3.0, true);
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
fn the_same_world_and_the_same_play_give_the_same_figures() {
    let play = || {
        let mut scene = world(Geometry::Spherical);
        for (x, z, hostile) in [(14.0, 2.0, true), (-9.0, 4.0, false), (5.0, 9.0, false)] {
            let place = beside(&scene, x, z);
            scene.spawn_bot(place, 1.0, hostile);
        }
        pass(&mut scene, 15.0);
        (scene.bots(), scene.health().to_bits())
    };
    assert_eq!(play(), play());
}

#[test]
fn they_come_out_of_sight_and_go_far_off_out_of_sight_never_too_many() {
    for geometry in Geometry::ALL {
        let mut scene = Scene::open(
            antipode_scene::WorldSetup {
                view_distance: 3,
                ..common::setup(geometry)
            },
            None,
        )
        .unwrap();
        assert!(scene.wait_for_step(common::LIMIT));
        scene.set_npcs(NpcMode::On);
        let most = if geometry == Geometry::Spherical {
            7
        } else {
            9
        };
        let mut known = std::collections::BTreeMap::new();
        for second in 0..30 {
            pass(&mut scene, 1.0);
            scene.set_health(FULL_HEALTH);
            let eye = scene.eye();
            for view in scene.bots() {
                let seen = scene
                    .frame(1.3, 1.7, 1)
                    .strategy
                    .view_point(&eye, view.point);
                let behind = -seen.z / seen.truncate().length() < 0.5;
                if known.insert(view.bot.id, view.point).is_none() {
                    let away_m = away_m(&scene, view.point);
                    assert!(behind, "{geometry:?}: {view:?} comes in sight");
                    assert!((30.0..60.0).contains(&away_m), "{geometry:?}: {away_m} m");
                }
            }
            assert!(scene.bots().len() <= most, "{geometry:?} {second}");
        }
        let bots = scene.bots();
        let hostile = bots.iter().filter(|view| view.bot.hostile).count();
        assert!(bots.len() + 1 >= most, "{geometry:?}: {} live", bots.len());
        assert!(
            (2..=5).contains(&hostile),
            "{geometry:?}: {hostile} hostile"
        );
        if geometry == Geometry::Spherical {
            continue;
        }
        let far = beside(&scene, 300.0, 0.0);
        scene.teleport(far);
        pass(&mut scene, 2.0);
        let left = scene.bots();
        let stayed = left.iter().filter(|view| known.contains_key(&view.bot.id));
        assert!(
            stayed.count() <= 5,
            "{geometry:?}: those not in view are gone"
        );
        assert!(!left.is_empty());
    }
}

#[test]
fn who_is_talked_to_says_what_is_true_of_the_place() {
    let mut said = Vec::new();
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let talk = Actions {
            talk: true,
            ..Actions::default()
        };
        scene.take_hints();
        steps(&mut scene, 1, &talk);
        assert_eq!(scene.take_hints(), [Hint::NobodyToTalkTo]);
        let place = beside(&scene, 3.0, 0.0);
        let id = scene.spawn_bot(place, 0.0, false);
        let mut lines = Vec::new();
        for _ in 0..3 {
            let there = bot(&scene, id).point.moved(DVec3::Y * 1.3);
            look_at(&mut scene, there);
            steps(&mut scene, 1, &talk);
            assert_eq!(
                bot(&scene, id).state,
                State::Watch,
                "{geometry:?}: it listens"
            );
            for hint in scene.take_hints() {
                let Hint::Said(line) = hint else {
                    panic!("{geometry:?}: {hint}")
                };
                lines.push(line);
            }
            pass(&mut scene, 0.5);
        }
        assert_eq!(lines.len(), 3, "{geometry:?}");
        for line in lines {
            said.push(format!("{geometry:?}: {line}"));
            match line {
                Line::Triangle {
                    sum_decidegrees, ..
                } => {
                    assert_eq!(
                        sum_decidegrees.cmp(&1800),
                        match geometry {
                            Geometry::Euclidean => std::cmp::Ordering::Equal,
                            Geometry::Hyperbolic => std::cmp::Ordering::Less,
                            Geometry::Spherical => std::cmp::Ordering::Greater,
                        }
                    );
                }
                Line::Horizon {
                    lower_decidegrees, ..
                } => match geometry {
                    Geometry::Euclidean => assert_eq!(lower_decidegrees, 0),
                    Geometry::Hyperbolic => assert!(lower_decidegrees > 50),
                    Geometry::Spherical => assert_ne!(lower_decidegrees, 0),
                },
                Line::Home { there_m, round_m } => {
                    assert_eq!(round_m.is_some(), geometry == Geometry::Spherical);
                    if let Some(round_m) = round_m {
                        // The player stands four metres before the equator, the home is the pole; round the sphere
                        // on ground that lies about 11 m high it is 2 pi 32 cos(11/32) m.
                        assert!(
                            (183..194).contains(&(there_m + round_m)),
                            "{there_m} {round_m}"
                        );
                        assert!((40..46).contains(&there_m), "{there_m}");
                    }
                }
            }
        }
    }
    println!("{}", said.join("\n"));
}

#[test]
fn at_dusk_they_sit_down_by_a_lamp_and_get_up_again() {
    let mut scene = world(Geometry::Euclidean);
    let lamp = beside(&scene, 8.0, 4.0);
    assert!(scene.spawn_lamp(lamp));
    let ids = [(12.0, 0.0), (3.0, 9.0)].map(|(x, z)| {
        let place = beside(&scene, x, z);
        scene.spawn_bot(place, 0.0, false)
    });
    pass(&mut scene, 15.0);
    assert!(
        ids.iter().all(|id| bot(&scene, *id).state != State::Sit),
        "not by day"
    );
    scene.set_time_of_day_s(300.0);
    pass(&mut scene, 40.0);
    for id in ids {
        let view = bot(&scene, id);
        assert_eq!(view.state, State::Sit, "{:?}", view.point);
        assert!((view.point.pos - lamp.pos).length() < 3.5);
    }
    scene.set_time_of_day_s(450.0);
    pass(&mut scene, 2.0);
    assert!(ids.iter().all(|id| bot(&scene, *id).state != State::Sit));
}

#[test]
fn a_peaceful_one_looks_at_who_comes_and_makes_room() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 7.0, 0.0);
        let id = scene.spawn_bot(place, std::f64::consts::PI, false);
        let mut states = std::collections::BTreeSet::new();
        let mut nearest_m = f64::INFINITY;
        for _ in 0..4 * SECOND {
            let view = bot(&scene, id);
            states.insert(view.state.name());
            let there = view.point.moved(DVec3::Y * 1.5);
            if away_m(&scene, view.point) > 2.5 {
                look_at(&mut scene, there);
            }
            let walk = Actions {
                forward: 1.0,
                ..Actions::default()
            };
            steps(&mut scene, 1, &walk);
            nearest_m = nearest_m.min(away_m(&scene, bot(&scene, id).point));
        }
        assert!(states.contains("watch"), "{geometry:?}: {states:?}");
        assert!(states.contains("aside"), "{geometry:?}: {states:?}");
        assert!(
            nearest_m > 0.35,
            "{geometry:?}: walked through, {nearest_m} m"
        );
    }
}

#[test]
fn a_horn_scares_peaceful_ones_away() {
    let mut scene = world(Geometry::Euclidean);
    let place = beside(&scene, 7.0, 0.0);
    let id = scene.spawn_bot(place, 0.0, false);
    pass(&mut scene, 0.2);
    let feet = scene.feet();
    scene.scare(feet, 15.0);
    pass(&mut scene, 3.0);
    assert_eq!(bot(&scene, id).state, State::Flee);
    assert!(away_m(&scene, bot(&scene, id).point) > 14.0);
}

#[test]
fn who_was_built_over_comes_out_of_the_ground() {
    let mut scene = world(Geometry::Euclidean);
    scene.set_npcs(NpcMode::Still);
    let place = beside(&scene, 7.0, 0.0);
    let id = scene.spawn_bot(place, 0.0, false);
    pass(&mut scene, 0.5);
    let build = Actions {
        slot: Some(3),
        secondary: true,
        ..Actions::default()
    };
    let foot = bot(&scene, id).point;
    look_at(&mut scene, foot);
    steps(&mut scene, 2 * SECOND, &build);
    pass(&mut scene, 3.0);
    let view = bot(&scene, id);
    assert!(
        view.point.pos.y > place.pos.y + 1.0,
        "no hill was built: {:?}",
        view.point
    );
    scene.set_npcs(NpcMode::Off);
    pass(&mut scene, 15.0);
    let gone_m = (bot(&scene, id).point.pos - view.point.pos).length();
    assert!(gone_m > 1.0, "it is stuck there");
}
