//! What is played for the tests of purity: who is there, what is done from outside and by the player, and how the player
//! sees it.

use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::frame::Quality;
use antipode_scene::probe::ChunkProbe;
use antipode_scene::{Actions, NpcMode, Probe, Scene, Viewing};
use glam::DVec3;

use crate::common::cars::{car, enter, go_beside, look_at_car};
use crate::common::figures::beside;
use crate::common::{LIMIT, setup};

/// Steps of a round of play.
const ROUND: usize = 45 * 60;
/// Steps between two probes.
const PROBED: usize = 30;

/// How the player sees the world, how far, and what makes its land.
#[derive(Clone, Copy)]
pub struct How {
    pub name: &'static str,
    pub viewing: Viewing,
    pub quality: Quality,
    pub lines: u32,
    pub view_distance: u32,
    pub workers: usize,
}

pub fn usual() -> How {
    How {
        name: "usual",
        viewing: Viewing::default(),
        quality: Quality::Balanced,
        lines: 720,
        view_distance: 4,
        workers: 1,
    }
}

pub fn calm() -> How {
    How {
        name: "calm",
        viewing: Viewing {
            fov_y_rad: 0.6,
            contour_bands: true,
            wind: false,
            head_dip: false,
            reduced_motion: true,
            safe_marker: true,
        },
        quality: Quality::Fast,
        lines: 240,
        ..usual()
    }
}

pub fn sharp() -> How {
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

pub fn within(view_distance: u32, name: &'static str) -> How {
    How {
        name,
        view_distance,
        ..usual()
    }
}

pub fn worked_by(workers: usize, name: &'static str) -> How {
    How {
        name,
        workers,
        ..usual()
    }
}

/// Whether ten minutes are played.
pub fn is_long() -> bool {
    std::env::var("ANTIPODE_TEST_LONG").is_ok_and(|it| it == "1")
}

fn steps_played() -> usize {
    if is_long() { 600 * 60 } else { ROUND }
}

/// What was played.
#[derive(Default)]
pub struct Played {
    /// Probes of each half second.
    pub probes: Vec<Probe>,
    /// What was done in each step.
    pub record: Vec<Actions>,
    /// Steps in which the picture hid somebody who could shoot.
    pub hidden: usize,
    /// Steps at the wheel of a car that went.
    drove: usize,
}

impl Played {
    /// Takes a step, after what is done from outside.
    fn step(&mut self, scene: &mut Scene, actions: &Actions) {
        let step = self.record.len();
        scene.step(actions);
        assert!(scene.wait_for_step(LIMIT));
        self.record.push(*actions);
        self.hidden += usize::from(!scene.hidden_foes().is_empty());
        self.drove += usize::from(scene.is_driving() && car(scene).speed_m_s > 3.0);
        if step.is_multiple_of(PROBED) {
            self.probes.push(told(scene));
        }
    }
}

/// Plays a world; `aimed`: as the window does, whose actions tell what they were aimed by.
pub fn played(geometry: Geometry, how: &How, aimed: bool) -> Played {
    let mut scene = opened(geometry, how);
    let mut played = Played::default();
    for step in 0..steps_played() {
        arrange(&mut scene, step);
        let actions = Actions {
            aimed: aimed.then(|| scene.aim_of_picture()),
            ..deeds(step)
        };
        played.step(&mut scene, &actions);
    }
    assert!(played.drove > 60, "{geometry}: nobody drove");
    played
}

/// Plays again what was recorded, in a world that `pictured` gives another picture first.
pub fn replayed(
    geometry: Geometry,
    how: &How,
    record: &[Actions],
    pictured: impl Fn(&mut Scene),
) -> Played {
    let mut scene = opened(geometry, how);
    pictured(&mut scene);
    let mut played = Played::default();
    for (step, actions) in record.iter().enumerate() {
        arrange(&mut scene, step);
        played.step(&mut scene, actions);
    }
    played
}

/// A world that nobody has played, its ground loaded, seen so.
pub fn opened(geometry: Geometry, how: &How) -> Scene {
    let mut setup = setup(geometry);
    setup.view_distance = how.view_distance;
    let mut scene = Scene::open_with(setup, None, how.workers).unwrap();
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

/// The figures and things that are there to begin with: near, and so far off that a short view does not show it.
fn peopled(scene: &mut Scene) {
    scene.set_npcs(NpcMode::On);
    scene.give_first_car();
    let far = !scene.strategy().is_closed();
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

/// What is done to the world from outside before a step. It takes none: each that is played is recorded.
fn arrange(scene: &mut Scene, step: usize) {
    let feet = scene.feet();
    match step % ROUND {
        0 if step == 0 => peopled(scene),
        // Bullets go far beyond what a short view shows.
        90 => scene.throw_bullet(feet.moved(DVec3::Y * 9.0), DVec3::new(38.0, 6.0, 4.0)),
        600 => scene.teleport(feet.moved(DVec3::Y * 5.0)),
        1080 => go_beside(scene, 2.0),
        1140 => look_at_car(scene),
        1740 => {
            if let Some(rim_m) = scene.strategy().domain(ChartId::FIRST).radius_m() {
                let field = scene.field().clone();
                let height_m = field.surface_height(ChartId::FIRST, rim_m - 3.0, 0.0);
                scene.teleport(ChartPoint::a(DVec3::new(rim_m - 3.0, height_m + 0.3, 0.0)));
                scene.aim(0.0, -0.2);
            }
        }
        1980 => {
            for (away_m, aside_m) in [(9.0, -4.0), (-11.0, 3.0)] {
                let at = beside(scene, away_m, aside_m);
                scene.spawn_bot(at, 2.0, true);
            }
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
        1141 => now = enter(),
        1150..1500 => {
            now.forward = 1.0;
            now.strafe = if at < 1330 { 0.3 } else { -0.3 };
            now.toggle_camera = once(1230);
        }
        1500..1680 => now.jump = true,
        1690 => now.leave_car = true,
        // Through a strong picture of each kind, somebody is hidden.
        1980..2400 => {
            now.slot = once(1980).then_some(0);
            now.turn_map = once(2000) || once(2180);
            now.dial = match at {
                2010..2030 => -1.0,
                2190..2200 => 2.0,
                _ => 0.0,
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
