//! What is seen at once, what stands still, and what a picture leaves as it is.

use antipode_geometry::{Eye, Geometry};
use antipode_scene::frame::{Frame, ModelId};
use antipode_scene::{Actions, Between, LookTurn, Scene, Shutter, WorldSetup};
use antipode_settings::{Given, MouseButton};
use glam::DVec3;

use super::super::super::pace::Pace;
use super::*;
use crate::pad::Axis;

#[test]
fn a_turn_is_seen_in_the_next_frame_and_the_next_step_turns_as_far() {
    for (geometry, third) in [(Geometry::Euclidean, false), (Geometry::Spherical, true)] {
        let mut film = Film::new(geometry);
        if third {
            input(&mut film.game, Input::Key("Tab"), true);
            film.shoot(2);
        }
        film.at(240);
        let start = film.picture().view.eye;
        // Who walks in a closed world is turned by his way, too.
        input(&mut film.game, AHEAD, geometry == Geometry::Euclidean);
        let rad_per_px = film
            .game
            .options
            .config
            .settings
            .mouse_sensitivity_deg_per_px
            .to_radians();
        let (mut right_px, mut up_px) = (0.0, 0.0);
        for frame in 0..200 {
            let stepped = film.pass();
            let of_step = film.scene().head();
            let turned = (right_px * rad_per_px, up_px * rad_per_px);
            let off = |eye: &Eye, (yaw, pitch): (f64, f64)| {
                let yaw = (eye.yaw - start.yaw - yaw).sin().abs();
                yaw.max((eye.pitch - start.pitch - pitch).abs())
            };
            if stepped {
                assert!(off(&of_step, turned) < 1e-9, "step at frame {frame}");
            }
            let dx = f64::from(frame % 7) - 1.0;
            film.game.motion(dx, 1.0 - dx);
            (right_px, up_px) = (right_px + dx, up_px - 1.0 + dx);
            if up_px.abs() > 200.0 {
                film.game.motion(0.0, up_px);
                up_px = 0.0;
            }
            let seen = film.picture().view.eye;
            let turned = (right_px * rad_per_px, up_px * rad_per_px);
            assert!(
                off(&seen, turned) < 1e-9,
                "{geometry:?} frame {frame}: {seen:?}"
            );
        }
    }
}

#[test]
fn a_stick_turns_the_view_in_every_frame_alike() {
    let mut film = Film::new(Geometry::Euclidean);
    film.game.devices.sticks.set(Axis::RightX, 1.0);
    let speed_deg_s = film.game.options.config.settings.pad_look_speed_deg_per_s;
    for rate in RATES {
        film.at(rate);
        let due_rad = speed_deg_s.to_radians() / f64::from(rate);
        let frames = film.shoot(60);
        for it in frames[1..].windows(2) {
            let turned_rad = (it[1].view.eye.yaw - it[0].view.eye.yaw).sin();
            assert!(
                (turned_rad / due_rad - 1.0).abs() < 0.01,
                "{turned_rad} of {due_rad}"
            );
        }
    }
}

#[test]
fn what_is_dug_stays_under_the_crosshair_of_one_who_walks_and_turns() {
    for geometry in Geometry::ALL {
        let mut film = Film::new(geometry);
        let pickaxe = film.scene().inventory().hotbar().iter().position(|stack| {
            stack.is_some_and(|stack| stack.item.brush_strength_per_s().is_some())
        });
        film.scene().inventory_mut().select(pickaxe.unwrap() as u8);
        let heading = film.scene().eye().yaw;
        film.scene().aim(heading, -0.35);
        film.at(144);
        input(&mut film.game, AHEAD, true);
        input(&mut film.game, Input::Mouse(MouseButton::Left), true);
        film.shoot(6);
        let mut marked = 0;
        for _ in 0..60 {
            film.game.motion(9.0, 0.5);
            film.pass();
            film.game.motion(9.0, 0.5);
            let frame = film.picture();
            let Some(marker) = frame.content.marker else {
                continue;
            };
            let view = frame
                .view
                .strategy
                .view_point(&frame.view.eye, marker.point)
                .truncate();
            let off_rad = view.truncate().length().atan2(-view.z);
            assert!(off_rad < 2e-3, "{geometry:?}: {off_rad} off the crosshair");
            marked += 1;
        }
        assert!(marked > 40, "{geometry:?}: {marked}");
    }
}

/// What is in two pictures of the same moment.
fn assert_alike(a: &Frame, b: &Frame) {
    assert_eq!(
        (a.view.eye, a.content.sky, a.content.time_s),
        (b.view.eye, b.content.sky, b.content.time_s)
    );
    assert_eq!(
        (&a.content.figures, &a.content.lights),
        (&b.content.figures, &b.content.lights)
    );
    assert_eq!(
        (a.view.hand, a.content.marker),
        (b.view.hand, b.content.marker)
    );
}

#[test]
fn a_paused_world_stands_still_in_the_middle_of_a_step_and_goes_on_from_there() {
    let mut film = Film::new(Geometry::Spherical);
    input(&mut film.game, AHEAD, true);
    film.shoot(20);
    film.at(240);
    film.shoot(50);
    for ends in ["Escape", "KeyP"] {
        input(&mut film.game, AHEAD, true);
        film.shoot(21);
        // The world is between two steps, and the view has been turned since the last.
        while film.pass() {}
        film.game.motion(31.0, 7.0);
        let last = film.picture();
        assert_ne!(last.view.eye.point, film.scene().eye().point);
        input(&mut film.game, Input::Key(ends), true);
        for _ in 0..50 {
            film.pass();
            let still = film.picture();
            if ends == "Escape" {
                assert_alike(&still, &last);
            } else {
                assert!(film.game.overlays.is_photographing());
                assert_eq!(
                    (still.view.eye, still.content.sky),
                    (last.view.eye, last.content.sky)
                );
            }
        }
        if ends == "Escape" {
            film.game.follow(Intent::Resume);
        } else {
            take_key(&mut film.game, Input::Key("Escape"), true, false);
        }
        assert!(film.game.is_playing());
        assert_alike(&film.picture(), &last);
        input(&mut film.game, AHEAD, true);
        let next = film.shoot(1).remove(0);
        assert!(next.view.eye.point.pos.distance(last.view.eye.point.pos) < 0.05);
        // Two centimetres of a way turn a look by less; what the mouse had turned is a hundred times that.
        assert!((next.view.eye.yaw - last.view.eye.yaw).abs() < 1e-3);
    }
}

#[test]
fn the_rear_mirror_is_there_while_one_drives_and_not_behind_the_menu() {
    let mut film = Film::new(Geometry::Euclidean);
    let settings = &mut film.game.options.config.settings;
    settings.set("rear-mirror", Given::Word("on")).unwrap();
    film.drive();
    if film.scene().camera_mode() == CameraMode::Third {
        film.scene().step(&Actions {
            toggle_camera: true,
            ..Actions::default()
        });
    }
    assert!(film.picture().mirror.is_some());
    input(&mut film.game, Input::Key("Escape"), true);
    assert!(is_paused(&film.game));
    assert!(film.picture().mirror.is_none());
}

#[test]
fn sun_and_dial_move_in_every_frame() {
    let mut film = Film::new(Geometry::Hyperbolic);
    film.at(240);
    film.game.wheel(-3.0);
    let frames = film.shoot(80);
    // The step that turns the wheel begins the glide.
    let gliding = &frames[8..];
    for it in gliding.windows(2) {
        assert!(
            it[1].view.eye.dial < it[0].view.eye.dial,
            "{} {}",
            it[0].view.eye.dial,
            it[1].view.eye.dial
        );
        assert_ne!(
            it[0].content.sky.sun_direction,
            it[1].content.sky.sun_direction
        );
        assert!(it[1].content.time_s > it[0].content.time_s);
    }
}

#[test]
fn who_is_put_elsewhere_is_seen_there_and_nowhere_between() {
    let mut film = Film::new(Geometry::Euclidean);
    film.at(240);
    input(&mut film.game, Input::Key("Tab"), true);
    film.shoot(8);
    let feet = film.scene().feet();
    film.scene().set_flying(true);
    film.scene()
        .teleport(feet.moved(DVec3::new(12.0, 9.0, 0.0)));
    for frame in film.shoot(12) {
        let own = frame
            .content
            .figures
            .iter()
            .find(|it| it.model == ModelId::Astronaut);
        for at in [
            own.unwrap().point,
            frame.view.eye.point.moved(frame.view.eye.front() * 5.2),
        ] {
            let way_m = at.pos.x - feet.pos.x;
            assert!((way_m - 12.0).abs() < 0.5, "{way_m} m");
        }
    }
}

/// A world by itself.
fn world(geometry: Geometry) -> Scene {
    let setup = WorldSetup {
        name: "Test".to_owned(),
        seed: 3,
        geometry,
        radius_m: RADIUS_M,
        generator: antipode_scene::Generator::OneBiome,
        mode: antipode_scene::Mode::default(),
        view_distance: 1,
    };
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.settle(LIMIT) && scene.wait_for_step(LIMIT));
    scene
}

/// What a player does in a step.
fn deeds(step: u32) -> Actions {
    Actions {
        forward: 1.0,
        look_yaw: 0.02 * f64::from(step % 5) - 0.03,
        look_pitch: if step < 30 { -0.02 } else { 0.005 },
        jump: step % 50 == 10,
        slot: (step == 0).then_some(2),
        primary: step % 40 > 25,
        toggle_camera: step % 60 == 45,
        toggle_light: step == 5,
        drop_one: step == 70,
        dial: if step == 20 { -2.0 } else { 0.0 },
        ..Actions::default()
    }
}

/// A probe once all land is there.
fn settled(scene: &mut Scene) -> String {
    assert!(scene.settle(LIMIT));
    format!("{:?}", scene.probe())
}

#[test]
fn however_many_pictures_are_taken_the_world_goes_the_same_way() {
    const STEPS: u32 = 150;
    for geometry in Geometry::ALL {
        let mut alone = world(geometry);
        for step in 0..STEPS {
            alone.step(&deeds(step));
            assert!(alone.wait_for_step(LIMIT));
        }
        let expected = settled(&mut alone);
        for rate in [20, 60, 144, 240] {
            let (mut scene, mut between, mut pace) =
                (world(geometry), Between::default(), Pace::default());
            let mut step = 0;
            while step < STEPS {
                let due = pace.steps(Duration::from_secs(1) / rate).min(STEPS - step);
                for left in (0..due).rev() {
                    between.step(&mut scene, &deeds(step), left == 0);
                    assert!(scene.wait_for_step(LIMIT));
                    step += 1;
                }
                let next = deeds(step);
                let shutter = Shutter {
                    share: pace.share(),
                    turned: LookTurn {
                        right_rad: next.look_yaw * pace.share(),
                        up_rad: next.look_pitch * pace.share(),
                    },
                };
                let _ = between.frame(&mut scene, shutter, 1.2, 1.5, 1);
            }
            assert_eq!(settled(&mut scene), expected, "{geometry:?} at {rate}");
        }
    }
}

#[test]
fn all_of_a_step_is_the_picture_of_the_scene_itself() {
    for geometry in Geometry::ALL {
        let (mut scene, mut between) = (world(geometry), Between::default());
        for step in 0..90 {
            between.step(&mut scene, &deeds(step), true);
            assert!(scene.wait_for_step(LIMIT));
            let shutter = Shutter {
                share: 1.0,
                turned: LookTurn::default(),
            };
            let whole = between.frame(&mut scene, shutter, 1.2, 1.5, 1);
            assert_alike(&whole, &scene.frame(1.2, 1.5, 1));
        }
    }
}
