//! Tests of what keys, buttons and the mouse become.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_settings::MouseButton;

use super::*;

const LEFT: Input = Input::Mouse(MouseButton::Left);
const RIGHT: Input = Input::Mouse(MouseButton::Right);

fn key(controls: &mut Controls, name: &str, pressed: bool) -> Option<Action> {
    controls.input(Input::key(name).unwrap(), pressed)
}

#[test]
fn a_held_key_acts_until_it_is_let_go() {
    let mut c = Controls::default();
    key(&mut c, "KeyW", true);
    assert_eq!(c.take().forward, 1.0);
    assert_eq!(c.take().forward, 1.0);
    key(&mut c, "KeyS", true);
    assert_eq!(c.take().forward, 0.0);
    key(&mut c, "KeyW", false);
    assert_eq!(c.take().forward, -1.0);
}

/// How often something is so in the steps that follow, where it was not so in the one before.
fn times(c: &mut Controls, is_so: impl Fn(&Actions) -> bool) -> usize {
    let seen: Vec<_> = (0..20).map(|_| is_so(&c.take())).collect();
    let first = usize::from(seen[0]);
    first + seen.windows(2).filter(|it| it[1] && !it[0]).count()
}

#[test]
fn every_press_within_a_slow_frame_counts() {
    let mut c = Controls::default();
    for name in ["KeyH", "Tab", "KeyQ"] {
        for _ in 0..3 {
            key(&mut c, name, true);
            key(&mut c, name, false);
        }
    }
    let steps: Vec<_> = (0..20).map(|_| c.take()).collect();
    let count = |is_so: fn(&Actions) -> bool| steps.iter().filter(|it| is_so(it)).count();
    assert_eq!(count(|it| it.turn_map), 3);
    assert_eq!(count(|it| it.toggle_camera), 3);
    assert_eq!(count(|it| it.drop_one), 3);
    for (button, is_so) in [
        (LEFT, (|it| it.primary) as fn(&Actions) -> bool),
        (RIGHT, |it| it.secondary),
    ] {
        for _ in 0..3 {
            c.input(button, true);
            c.input(button, false);
        }
        assert_eq!(times(&mut c, is_so), 3, "{button:?}");
        // One that is down is let go and pressed again within a step.
        c.input(button, true);
        assert!(is_so(&c.take()));
        c.input(button, false);
        c.input(button, true);
        assert!(!is_so(&c.take()), "it comes up");
        assert!(is_so(&c.take()) && is_so(&c.take()), "and stays down");
        c.input(button, false);
        assert!(!is_so(&c.take()));
    }
}

#[test]
fn an_event_happens_once_however_many_steps_a_frame_has() {
    let mut c = Controls::default();
    key(&mut c, "Tab", true);
    key(&mut c, "KeyH", true);
    c.motion(10.0, -5.0);
    let first = c.take();
    assert!(first.turn_map);
    assert!(first.toggle_camera && first.look_yaw > 0.0 && first.look_pitch > 0.0);
    assert_eq!(c.take(), Actions::default());
}

#[test]
fn the_wheel_turns_curvature_where_there_is_some_and_slots_elsewhere() {
    let mut c = Controls::default();
    c.wheel(2.0, true);
    assert_eq!(c.take().dial, 2.0);
    c.wheel(1.0, false);
    assert_eq!(c.take().slot_step, -1);
    key(&mut c, "AltLeft", true);
    c.wheel(-1.0, true);
    let actions = c.take();
    assert_eq!((actions.dial, actions.slot_step), (0.0, 1));
}

#[test]
fn while_the_key_of_shapes_or_kinds_is_held_the_wheel_goes_through_them() {
    for (name, step) in [
        ("KeyB", (|it| it.shape_step) as fn(&Actions) -> i32),
        ("KeyV", |it| it.kind_step),
    ] {
        for has_dial in [false, true] {
            let mut c = Controls::default();
            key(&mut c, name, true);
            assert_eq!(step(&c.take()), 1, "{name} by itself");
            c.wheel(-2.5, has_dial);
            c.wheel(-0.5, has_dial);
            let actions = c.take();
            assert_eq!(step(&actions), 3);
            assert_eq!((actions.dial, actions.slot_step), (0.0, 0));
            c.wheel(1.0, has_dial);
            assert_eq!(step(&c.take()), -1);
            key(&mut c, name, false);
            c.wheel(1.0, has_dial);
            assert_eq!(step(&c.take()), 0, "let go");
        }
    }
}

#[test]
fn a_press_shorter_than_a_step_still_acts_in_one() {
    let mut c = Controls::default();
    c.input(LEFT, true);
    c.input(LEFT, false);
    assert!(c.take().primary);
    assert!(!c.take().primary);
    key(&mut c, "Space", true);
    key(&mut c, "Space", false);
    c.release_all();
    assert!(!c.take().jump);
}

#[test]
fn both_buttons_pressed_in_one_slow_frame_act_one_after_the_other() {
    for (first, second) in [(LEFT, RIGHT), (RIGHT, LEFT)] {
        let mut c = Controls::default();
        for button in [first, second] {
            c.input(button, true);
            c.input(button, false);
        }
        let steps = [c.take(), c.take(), c.take()].map(|it| (it.primary, it.secondary));
        let left_first = [(true, false), (false, true), (false, false)];
        let right_first = [(false, true), (true, false), (false, false)];
        assert_eq!(
            steps,
            if first == LEFT {
                left_first
            } else {
                right_first
            }
        );
    }
}

#[test]
fn fractions_of_a_notch_add_up() {
    let mut c = Controls::default();
    for _ in 0..5 {
        c.wheel(0.25, false);
    }
    assert_eq!(c.take().slot_step, -1);
    c.wheel(0.75, false);
    assert_eq!(c.take().slot_step, -1);
    c.wheel(-0.5, false);
    c.wheel(-0.5, false);
    assert_eq!(c.take().slot_step, 1);
}

#[test]
fn letting_go_of_everything_leaves_no_stuck_key_and_no_late_click() {
    let mut c = Controls::default();
    key(&mut c, "KeyW", true);
    c.input(LEFT, true);
    c.motion(500.0, 0.0);
    c.release_all();
    assert_eq!(c.take(), Actions::default());
}

#[test]
fn the_menu_key_is_handed_to_the_shell_on_the_way_down_only() {
    let mut c = Controls::default();
    assert_eq!(key(&mut c, "Escape", true), Some(Action::Menu));
    assert_eq!(key(&mut c, "Escape", false), None);
    assert_eq!(key(&mut c, "F4", true), Some(Action::FrameFigures));
}

#[test]
fn the_mouse_goes_by_the_settings() {
    let turned = |settings: &dyn Fn(&mut Settings)| {
        let mut config = Config::default();
        settings(&mut config.settings);
        let mut c = Controls::default();
        c.set_config(&config);
        c.motion(100.0, 100.0);
        let actions = c.take();
        (
            actions.look_yaw.to_degrees(),
            actions.look_pitch.to_degrees(),
        )
    };
    let near =
        |(a, b): (f64, f64), (x, y): (f64, f64)| (a - x).abs() < 1e-9 && (b - y).abs() < 1e-9;
    assert!(near(turned(&|_| {}), (12.0, -12.0)));
    assert!(near(
        turned(&|own| own.mouse_sensitivity_deg_per_px = 0.5),
        (50.0, -50.0)
    ));
    assert!(near(turned(&|own| own.invert_look = true), (12.0, 12.0)));
}

#[test]
fn the_dial_goes_by_its_step() {
    let mut config = Config::default();
    config.settings.curvature_step = 0.25;
    let mut c = Controls::default();
    c.set_config(&config);
    c.wheel(-2.0, true);
    assert_eq!(c.take().dial, -0.5);
}

#[test]
fn bindings_change_at_once_and_two_keys_of_an_action_do_not_disturb_each_other() {
    let mut config = Config::default();
    let own = config.profiles.chosen_mut();
    own.bind(Action::Forward, Input::key("KeyI").unwrap())
        .unwrap();
    own.bind(Action::Jump, Input::WheelUp).unwrap();
    own.rebind(Action::DialUp, Input::WheelUp, Input::key("KeyR").unwrap())
        .unwrap();
    let mut c = Controls::default();
    key(&mut c, "KeyW", true);
    c.set_config(&config);
    assert_eq!(c.take().forward, 0.0, "what was held is let go");
    key(&mut c, "KeyW", true);
    key(&mut c, "KeyI", true);
    key(&mut c, "KeyW", false);
    assert_eq!(c.take().forward, 1.0, "the other key is still held");
    c.wheel(1.0, true);
    let first = c.take();
    assert!(
        first.jump && first.slot_step == -1 && first.dial == 0.0,
        "{first:?}"
    );
    assert!(!c.take().jump, "a notch is no hold");
    key(&mut c, "KeyR", true);
    assert_eq!(c.take().dial, 1.0);
}
