//! What other figures do in peace, as a player would notice it: in every space, and over the equator.

use crate::common::figures::{SECOND, away_m, beside, bot, look_at, pass, shoot, world};
use crate::common::steps;
use antipode_geometry::{ChartPoint, Eye, Geometry, equilateral_angle_sum_rad};
use antipode_scene::tuning::FULL_HEALTH;
use antipode_scene::{Actions, Hint, Item, Line, NpcMode, Scene, Stack, State, WorldSetup};
use glam::DVec3;

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
                charts.insert(format!("{:?}", view.point.chart));
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
                let field = scene.field().clone();
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
            WorldSetup {
                view_distance: 3,
                ..crate::common::setup(geometry)
            },
            None,
        )
        .unwrap();
        assert!(scene.wait_for_step(crate::common::LIMIT));
        scene.set_npcs(NpcMode::On);
        let most = if geometry == Geometry::Spherical {
            7
        } else {
            9
        };
        // A new world is peaceful for five minutes.
        pass(&mut scene, 20.0);
        let first = scene.bots();
        assert!((2..=most / 2).contains(&first.len()), "{geometry:?}");
        pass(&mut scene, 280.0);
        assert!(scene.bots().iter().all(|view| !view.bot.hostile));
        let mut known: std::collections::BTreeMap<_, _> = scene
            .bots()
            .iter()
            .map(|view| (view.bot.id, view.point))
            .collect();
        for second in 0..75 {
            pass(&mut scene, 1.0);
            scene.set_health(FULL_HEALTH);
            let eye = scene.eye();
            for view in scene.bots() {
                let seen = scene
                    .frame(1.3, 1.7, 1)
                    .view
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
            (2..=3).contains(&hostile),
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

/// How many things are told of a space.
fn lines_in(geometry: Geometry) -> usize {
    if geometry == Geometry::HyperbolicWorld {
        5
    } else {
        3
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
        let count = lines_in(geometry);
        for _ in 0..count {
            let there = bot(&scene, id).point.moved(DVec3::Y * 1.3);
            look_at(&mut scene, there);
            steps(&mut scene, 1, &talk);
            assert_eq!(
                bot(&scene, id).state,
                State::Watch,
                "{geometry:?}: it listens"
            );
            for hint in scene.take_hints() {
                let Hint::Said { greets, line } = hint else {
                    panic!("{geometry:?}: {hint}")
                };
                assert_eq!(greets, lines.is_empty(), "{geometry:?}: once each");
                lines.push(line);
                let speech = scene
                    .speech(&scene.seen(), 1.3)
                    .expect("it is seen to speak");
                assert_eq!(speech.line, line, "{geometry:?}");
                let at = speech.at.expect("it is in the picture");
                let is_over = at.x.abs() < 0.2 && (0.05..0.8).contains(&at.y);
                assert!(is_over, "{geometry:?}: over its head, at {at}");
            }
            pass(&mut scene, 0.5);
        }
        assert_eq!(lines.len(), count, "{geometry:?}");
        let away = scene
            .head()
            .point
            .moved(beside(&scene, -9.0, 0.0).pos - bot(&scene, id).point.pos);
        look_at(&mut scene, away);
        let speech = scene
            .speech(&scene.seen(), 1.3)
            .expect("it goes on behind one's back");
        assert_eq!(speech.at, None, "{geometry:?}");
        pass(&mut scene, 10.0);
        assert_eq!(
            scene.speech(&scene.seen(), 1.3),
            None,
            "{geometry:?}: it is over"
        );
        for line in lines {
            said.push(format!("{geometry:?}: {line}"));
            match line {
                Line::Triangle {
                    side_m,
                    sum_decidegrees,
                    pictured,
                } => {
                    let sighted = sighted_sum_deg(&scene, f64::from(side_m));
                    let told = f64::from(sum_decidegrees) / 10.0;
                    assert!((sighted - told).abs() < 0.1, "{geometry:?}: {sighted}");
                    assert_eq!(sum_decidegrees > 1800, geometry == Geometry::Spherical);
                    assert_eq!(pictured, geometry == Geometry::Hyperbolic);
                    assert_eq!(
                        sum_decidegrees < 1800,
                        geometry == Geometry::HyperbolicWorld
                    );
                }
                Line::Land { within_m, tenths } => {
                    assert_eq!(geometry, Geometry::HyperbolicWorld);
                    assert_eq!(within_m, 250);
                    assert!((20..40).contains(&tenths) || tenths > 300, "{tenths}");
                }
                Line::Square {
                    side_m,
                    gap_decimetres,
                } => {
                    assert_eq!(geometry, Geometry::HyperbolicWorld);
                    let walked_m = walked_square_gap_m(&scene, f64::from(side_m));
                    let told_m = f64::from(gap_decimetres) / 10.0;
                    assert!((walked_m - told_m).abs() < 0.1, "{walked_m} {told_m}");
                }
                Line::Horizon {
                    lower_decidegrees, ..
                } => match geometry {
                    Geometry::Euclidean => assert_eq!(lower_decidegrees, 0),
                    Geometry::Hyperbolic => assert!(lower_decidegrees > 50),
                    Geometry::HyperbolicWorld => assert!(lower_decidegrees > 0),
                    Geometry::Spherical => assert_ne!(lower_decidegrees, 0),
                },
                Line::Home {
                    there_m,
                    round_m,
                    squares,
                } => {
                    assert_eq!(squares.is_some(), geometry == Geometry::HyperbolicWorld);
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

/// The angles between three lamps that are `side_m` metres from one another, each sighted in the picture from the other
/// two, in degrees together: in open worlds as on the land, by the compass.
fn sighted_sum_deg(scene: &Scene, side_m: f64) -> f64 {
    let closed = scene.strategy().is_closed();
    let pictured = scene.lens().strategy();
    let first = scene.head();
    let on_land = |turn: f64| {
        first
            .point
            .moved(DVec3::new(turn.cos(), 0.0, turn.sin()) * side_m)
    };
    let lamps = if closed {
        // Turned by their own angle, two lines of sight that long end as far from each other.
        let sum = equilateral_angle_sum_rad(scene.strategy().curvature().per_m2(), side_m);
        let ends = [-sum / 6.0, sum / 6.0]
            .map(|turn| pictured.along(&first, DVec3::new(turn.sin(), 0.0, -turn.cos()), side_m));
        [first.point, ends[0], ends[1]]
    } else {
        let third = std::f64::consts::FRAC_PI_3;
        [first.point, on_land(0.0), on_land(third)]
    };
    let angle_at = |own: usize| {
        let eye = Eye {
            point: lamps[own],
            pitch: 0.0,
            ..first
        };
        let ways = [1, 2].map(|step| {
            let view = pictured.view_point(&eye, lamps[(own + step) % 3]);
            let way = view.truncate();
            let way = if closed { way } else { way.with_y(0.0) };
            way.normalize()
        });
        ways[0].dot(ways[1]).acos().to_degrees()
    };
    (0..3).map(angle_at).sum()
}

/// How far one ends from where one began who goes so many metres ahead and turns right, four times, at the height of the
/// player's feet, by geodesics of the level below and its metres, of which each is `cosh(y/R)` metres there.
fn walked_square_gap_m(scene: &Scene, side_m: f64) -> f64 {
    let strategy = scene.strategy();
    let feet = scene.feet();
    let share = (feet.pos.y / strategy.radius_m()).cosh();
    let at = |point: ChartPoint| Eye {
        point: ChartPoint::new(point.chart, point.pos.with_y(0.0)),
        ..Eye::default()
    };
    let begin = at(feet);
    let (mut eye, mut ahead) = (begin, DVec3::NEG_Z);
    for _ in 0..4 {
        let end = at(strategy.along(&eye, ahead, side_m / share));
        let back = strategy.view_point(&end, eye.point).truncate().normalize();
        // One faces away from where one came from: right of that is where its left is.
        ahead = DVec3::new(back.z, 0.0, -back.x);
        eye = end;
    }
    let last = strategy.view_point(&begin, eye.point);
    share * strategy.eye_distance_m(&begin, last)
}

#[test]
fn who_stands_four_metres_off_face_to_face_is_talked_to() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 4.0, 0.0);
        let id = scene.spawn_bot(place, std::f64::consts::PI, false);
        let there = bot(&scene, id).point.moved(DVec3::Y * 1.3);
        look_at(&mut scene, there);
        scene.take_hints();
        let talk = Actions {
            talk: true,
            ..Actions::default()
        };
        steps(&mut scene, 1, &talk);
        let hints = scene.take_hints();
        assert!(
            matches!(hints[..], [Hint::Said { greets: true, .. }]),
            "{geometry:?}: {hints:?}"
        );
    }
}

#[test]
fn who_is_shot_while_he_speaks_says_no_more() {
    let mut scene = world(Geometry::Euclidean);
    let place = beside(&scene, 3.0, 0.0);
    let id = scene.spawn_bot(place, 0.0, false);
    let there = bot(&scene, id).point.moved(DVec3::Y * 1.3);
    look_at(&mut scene, there);
    let talk = Actions {
        talk: true,
        ..Actions::default()
    };
    steps(&mut scene, 1, &talk);
    assert!(scene.speech(&scene.seen(), 1.3).is_some());
    shoot(&mut scene, id);
    pass(&mut scene, 0.5);
    assert!(bot(&scene, id).fights);
    assert_eq!(scene.speech(&scene.seen(), 1.3), None);
}

#[test]
fn who_is_called_from_afar_turns_round_and_waits() {
    for geometry in Geometry::ALL {
        let mut scene = world(geometry);
        let place = beside(&scene, 7.0, 0.0);
        // It looks away.
        let id = scene.spawn_bot(place, 0.0, false);
        pass(&mut scene, 0.5);
        let there = bot(&scene, id).point.moved(DVec3::Y * 1.3);
        look_at(&mut scene, there);
        scene.take_hints();
        let talk = Actions {
            talk: true,
            ..Actions::default()
        };
        steps(&mut scene, 1, &talk);
        assert_eq!(scene.take_hints(), [Hint::WaitsToTalk], "{geometry:?}");
        let from = bot(&scene, id).point;
        pass(&mut scene, 5.0);
        let view = bot(&scene, id);
        assert_eq!(view.state, State::Watch, "{geometry:?}");
        assert!((view.point.pos - from.pos).with_y(0.0).length() < 0.3);
        pass(&mut scene, 12.0);
        assert_ne!(bot(&scene, id).state, State::Watch, "{geometry:?}");
    }
}

/// The gun has to be made there, and nobody is shot at before he can shoot.
#[test]
fn in_a_gathering_world_nobody_comes_to_fight_before_one_carries_a_gun() {
    let setup = WorldSetup {
        mode: antipode_scene::Mode::Gathering,
        view_distance: 3,
        ..crate::common::setup(Geometry::Euclidean)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.wait_for_step(crate::common::LIMIT));
    scene.set_npcs(NpcMode::On);
    pass(&mut scene, 345.0);
    let hostile = |scene: &Scene| scene.bots().iter().filter(|it| it.bot.hostile).count();
    assert_eq!(hostile(&scene), 0);
    let gun = Stack {
        item: Item::Gun,
        count: 1,
    };
    scene.inventory_mut().put(4, gun);
    pass(&mut scene, 40.0);
    assert!(hostile(&scene) > 0);
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
