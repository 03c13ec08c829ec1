//! The world is a function of save, seed and actions: nothing that the player chooses about the picture has a part in it.
//!
//! `ANTIPODE_TEST_LONG=1` plays ten minutes in place of 45 seconds.

use antipode_geometry::{ChartPoint, Geometry, HyperbolicMap};
use antipode_scene::frame::Quality;
use antipode_scene::probe::ChunkProbe;
use antipode_scene::{Actions, NpcMode, Probe, Scene, Viewing};
use glam::DVec3;

use super::common::cars::{car, enter, stand_beside};
use super::common::figures::beside;
use super::common::{LIMIT, setup};

/// Steps of a round of play.
const ROUND: usize = 45 * 60;
/// Steps between two probes.
const PROBED: usize = 30;

/// How the player sees the world, and how far.
#[derive(Clone, Copy)]
struct How {
    name: &'static str,
    viewing: Viewing,
    quality: Quality,
    lines: u32,
    view_distance: u32,
}

fn usual() -> How {
    How {
        name: "usual",
        viewing: Viewing::default(),
        quality: Quality::Balanced,
        lines: 720,
        view_distance: 4,
    }
}

fn calm() -> How {
    How {
        name: "calm",
        viewing: Viewing {
            fov_y_rad: 0.6,
            contour_bands: true,
            head_dip: false,
            reduced_motion: true,
            safe_marker: true,
        },
        quality: Quality::Fast,
        lines: 240,
        ..usual()
    }
}

fn sharp() -> How {
    How {
        name: "sharp",
        viewing: Viewing {
            fov_y_rad: 1.9,
            ..Viewing::default()
        },
        quality: Quality::Exact,
        lines: 2160,
        ..usual()
    }
}

fn within(view_distance: u32) -> How {
    How {
        name: if view_distance < 4 { "near" } else { "far" },
        view_distance,
        ..usual()
    }
}

fn steps_played() -> usize {
    let long = std::env::var("ANTIPODE_TEST_LONG").is_ok_and(|it| it == "1");
    if long { 600 * 60 } else { ROUND }
}

fn opened(geometry: Geometry, how: &How) -> Scene {
    let mut setup = setup(geometry);
    setup.view_distance = how.view_distance;
    let mut scene = Scene::open(setup, None).unwrap();
    scene.set_viewing(how.viewing);
    scene.set_quality(how.quality);
    scene.set_picture_height_px(how.lines);
    assert!(scene.wait_for_step(LIMIT));
    scene
}

/// A probe without what tells of the picture and of how much land is there.
fn told(scene: &Scene) -> Probe {
    let mut probe = scene.probe();
    probe.quality = "";
    probe.chunks = ChunkProbe {
        resident: 0,
        pending: 0,
        triangles: 0,
        ..probe.chunks
    };
    probe
}

/// Who and what is there to begin with: near, and so far off that a short view does not show it.
fn peopled(scene: &mut Scene) {
    scene.set_npcs(NpcMode::On);
    scene.give_first_car();
    let far = scene.strategy().rim_m().is_none();
    for (away_m, hostile) in [(7.0, false), (-12.0, true), (30.0, false)] {
        let at = beside(scene, away_m, 3.0);
        scene.spawn_bot(at, 0.5, hostile);
    }
    if far {
        for (away_m, aside_m) in [(84.0, 10.0), (105.0, -40.0), (-90.0, 100.0), (150.0, 0.0)] {
            let at = beside(scene, away_m, aside_m);
            scene.spawn_bot(at, 0.5, false);
            scene.spawn_car(at.moved(DVec3::new(5.0, 2.0, 5.0)), 1.0);
        }
    }
}

/// What is done to the world from outside at a step.
fn arrange(scene: &mut Scene, step: usize) {
    let feet = scene.feet();
    match step % ROUND {
        0 if step == 0 => peopled(scene),
        // Bullets go far beyond what a short view shows.
        90 => scene.throw_bullet(feet.moved(DVec3::Y * 9.0), DVec3::new(38.0, 6.0, 4.0)),
        600 => scene.teleport(feet.moved(DVec3::Y * 5.0)),
        1080 => stand_beside(scene, 2.0),
        1740 => {
            if let Some(rim_m) = scene.strategy().rim_m() {
                let field =
                    antipode_terrain::Field::new(scene.setup().seed, scene.strategy().clone());
                let height_m =
                    field.surface_height(antipode_geometry::Hemisphere::A, rim_m - 3.0, 0.0);
                scene.teleport(ChartPoint::a(DVec3::new(rim_m - 3.0, height_m + 0.3, 0.0)));
                scene.aim(0.0, -0.2);
            }
        }
        1980 => {
            let at = beside(scene, 9.0, -4.0);
            scene.spawn_bot(at, 2.0, true);
        }
        _ => return,
    }
    assert!(scene.wait_for_step(LIMIT));
}

/// What the player does in a step.
fn deeds(step: usize) -> Actions {
    let at = step % ROUND;
    let once = |moment: usize| at == moment;
    let mut now = Actions {
        look_yaw: if at.is_multiple_of(40) { 0.05 } else { 0.0 },
        ..Actions::default()
    };
    match at {
        0..120 | 1740..1900 => (now.forward, now.sprint) = (1.0, true),
        120..540 => {
            now.slot = once(120).then_some(2);
            now.look_pitch = if at < 150 { -0.02 } else { 0.0 };
            now.primary = at < 400;
            now.jump = at.is_multiple_of(70);
            now.secondary = at > 450;
            // The picture glides while ground is dug.
            now.turn_map = once(260);
            now.dial = if (300..306).contains(&at) { 2.0 } else { 0.0 };
        }
        600..720 => now.primary = true,
        720..900 => {
            now.slot = once(720).then_some(0);
            now.look_pitch = if at < 740 { 0.02 } else { 0.0 };
            now.primary = at.is_multiple_of(20);
            now.look_yaw = 0.02;
        }
        900..1020 => {
            now.toggle_camera = once(900) || once(1010);
            now.slot = once(901).then_some(2);
            now.primary = true;
        }
        1081 => now = enter(),
        1090..1500 => {
            now.forward = 1.0;
            now.strafe = if at < 1300 { 0.3 } else { -0.3 };
            now.toggle_camera = once(1200);
        }
        1500..1680 => now.jump = true,
        1690 => now.leave_car = true,
        1980..2400 => {
            now.slot = once(1980).then_some(0);
            now.turn_map = once(2000);
            now.dial = if (2010..2030).contains(&at) {
                -1.0
            } else {
                0.0
            };
            now.primary = at.is_multiple_of(35);
            now.look_yaw = 0.01;
        }
        2400..2700 => {
            now.slot = once(2400).then_some(5);
            now.primary = at.is_multiple_of(50);
            now.drop_one = once(2510);
            now.talk = once(2520);
            now.toggle_light = once(2530);
        }
        _ => {}
    }
    now
}

/// Plays the round of a space; probes each half second, and what was done as it is recorded.
fn played(geometry: Geometry, how: &How) -> (Vec<Probe>, Vec<Actions>) {
    let mut scene = opened(geometry, how);
    let (mut probes, mut record) = (Vec::new(), Vec::new());
    let mut drove = false;
    for step in 0..steps_played() {
        arrange(&mut scene, step);
        let aimed = Some(scene.aim_of_picture());
        record.push(Actions {
            aimed,
            ..deeds(step)
        });
        scene.step(&deeds(step));
        assert!(scene.wait_for_step(LIMIT));
        drove |= scene.is_driving() && car(&scene).speed_m_s > 3.0;
        if step.is_multiple_of(PROBED) {
            probes.push(told(&scene));
        }
    }
    assert!(drove, "{geometry}: nobody drove");
    (probes, record)
}

fn assert_same(geometry: Geometry, name: &str, before: &[Probe], now: &[Probe]) {
    assert_eq!(before.len(), now.len());
    for (one, other) in before.iter().zip(now) {
        // The shortest text of a number is of that number alone.
        let (told, tells) = (format!("{one:#?}"), format!("{other:#?}"));
        let mut lines = told.lines().zip(tells.lines());
        let differs = lines.find(|(before, now)| before != now);
        assert_eq!(
            (differs, told.len()),
            (None, tells.len()),
            "{geometry} {name} at {} s",
            one.t
        );
    }
}

fn is_the_same_however_it_is_seen(geometry: Geometry) {
    let (before, _) = played(geometry, &usual());
    for how in [calm(), sharp(), within(2), within(8)] {
        let (now, _) = played(geometry, &how);
        assert_same(geometry, how.name, &before, &now);
    }
}

#[test]
fn a_flat_world_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::Euclidean);
}

#[test]
fn a_hyperbolic_world_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::Hyperbolic);
}

#[test]
fn a_closed_world_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::Spherical);
}

/// Plays again what was recorded; `bent` has another picture from the beginning.
fn replayed(geometry: Geometry, record: &[Actions], bent: bool) -> Vec<Probe> {
    let mut scene = opened(geometry, &usual());
    if bent && geometry == Geometry::Hyperbolic {
        assert!(scene.set_map(HyperbolicMap::Horizon) && scene.set_curvature(17.0));
    } else if bent {
        assert!(scene.set_bend(12.0));
    }
    let mut probes = Vec::new();
    for (step, actions) in record.iter().enumerate() {
        arrange(&mut scene, step);
        scene.step(actions);
        assert!(scene.wait_for_step(LIMIT));
        if step.is_multiple_of(PROBED) {
            let mut probe = told(&scene);
            // Which picture was asked for.
            (probe.map, probe.curvature, probe.bend) = (None, None, None);
            probes.push(probe);
        }
    }
    probes
}

#[test]
fn recorded_actions_make_the_same_world_through_whatever_picture_they_are_played_again() {
    for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
        let (_, record) = played(geometry, &calm());
        let before = replayed(geometry, &record, false);
        let now = replayed(geometry, &record, true);
        assert_same(geometry, "another picture", &before, &now);
    }
}
