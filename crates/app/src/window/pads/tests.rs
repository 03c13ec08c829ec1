//! Playing and finding one's way through the menus with a gamepad.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

use antipode_audio::PlayState;
use antipode_geometry::Geometry;
use antipode_scene::{Item, Kind, Mode, Scene};
use antipode_ui::Screen;
use clap::Parser;
use tempfile::TempDir;

use super::*;
use crate::cli::Cli;
use crate::pad::Axis;
use crate::session::{Beginning, NewWorld, Worlds};
use crate::window::phase::Request;

/// A pad whose events a test hands in.
#[derive(Clone, Default)]
struct Hand(Rc<RefCell<VecDeque<PadEvent>>>);

impl PadSource for Hand {
    fn next(&mut self) -> Option<PadEvent> {
        self.0.borrow_mut().pop_front()
    }
}

struct Play {
    game: Game,
    pads: Pads,
    hand: Hand,
    now: Instant,
    _saves: TempDir,
}

impl Play {
    fn in_menu() -> Self {
        Self::begin(None)
    }

    fn in_world() -> Self {
        Self::in_world_of(Mode::Creative)
    }

    fn in_world_of(mode: Mode) -> Self {
        let mut play = Self::begin(Some(Request::New(NewWorld {
            geometry: Geometry::Euclidean,
            name: Some("x".to_owned()),
            seed: Some(7),
            radius_m: None,
            generator: None,
            mode,
            start: Beginning::Middle,
        })));
        for _ in 0..1_000_000 {
            if play.game.is_playing() {
                return play;
            }
            play.game.tick(play.now);
            play.game.play.drawn(true);
            std::thread::yield_now();
        }
        panic!("the world never began");
    }

    fn begin(first: Option<Request>) -> Self {
        let saves = tempfile::tempdir().unwrap();
        let dir = saves.path().to_str().unwrap();
        let cli = Cli::try_parse_from(["antipode", "--saves-dir", dir, "--view-distance", "1"]);
        let worlds = Worlds::new(&cli.unwrap().common);
        let hand = Hand::default();
        Self {
            game: Game::new(worlds, None, first),
            pads: Pads::new(Box::new(hand.clone())),
            hand,
            now: Instant::now(),
            _saves: saves,
        }
    }

    /// Lets milliseconds pass, and events come. Returns the keys for the menus that went down.
    fn pass(&mut self, ms: u64, events: &[PadEvent]) -> Vec<Key> {
        self.now += Duration::from_millis(ms);
        self.hand.0.borrow_mut().extend(events.iter().cloned());
        let keys = self.pads.poll(&mut self.game, self.now);
        self.game.tick(self.now);
        let down = keys.iter().filter_map(|event| match event {
            Event::Key {
                key, pressed: true, ..
            } => Some(*key),
            _ => None,
        });
        down.collect()
    }

    /// Presses a button and lets go; its keys go to the interface, which has some frames to follow.
    fn press(&mut self, context: &egui::Context, which: PadButton) {
        let keys = self.pass(16, &[button(which, true)]);
        self.pass(16, &[button(which, false)]);
        let mut events = Vec::new();
        for key in keys {
            tap(key, Modifiers::NONE, &mut events);
        }
        for _ in 0..3 {
            let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(800.0, 600.0));
            let input = egui::RawInput {
                screen_rect: Some(screen),
                events: std::mem::take(&mut events),
                ..Default::default()
            };
            let game = &mut self.game;
            let _ = context.run_pass(input, |context| game.interface(context, None));
        }
    }

    fn scene(&mut self) -> &mut Scene {
        &mut self.game.play.phase.session_mut().unwrap().scene
    }

    fn feet(&mut self) -> glam::DVec3 {
        self.scene().feet().pos
    }
}

fn button(button: PadButton, pressed: bool) -> PadEvent {
    PadEvent::Button { button, pressed }
}

fn stick(axis: Axis, value: f32) -> PadEvent {
    PadEvent::Stick { axis, value }
}

#[test]
fn the_left_stick_walks_and_a_pad_that_goes_stops_walking() {
    let mut play = Play::in_world();
    let start = play.feet();
    play.pass(16, &[stick(Axis::LeftY, 1.0)]);
    for _ in 0..40 {
        play.pass(20, &[]);
    }
    let there = play.feet();
    assert!(
        (there - start).with_y(0.0).length() > 1.0,
        "{start} {there}"
    );
    let name = "Mock".to_owned();
    play.pass(20, &[PadEvent::Disconnected { name }]);
    for _ in 0..40 {
        play.pass(20, &[]);
    }
    let stopped = play.feet();
    for _ in 0..10 {
        play.pass(20, &[]);
    }
    assert!((play.feet() - stopped).length() < 1e-3);
    play.game.finish();
}

#[test]
fn steps_taken_with_a_pad_can_be_heard() {
    let mut play = Play::in_world();
    play.pass(16, &[stick(Axis::LeftY, 1.0)]);
    for _ in 0..60 {
        play.pass(20, &[]);
    }
    let heard = play.game.play.take_heard();
    assert_eq!(heard.play_state, PlayState::World);
    assert!(!heard.events.is_empty() && heard.surroundings.is_some());
    assert!(
        play.game.play.take_heard().events.is_empty(),
        "each is heard once"
    );
    play.pass(16, &[button(PadButton::Start, true)]);
    assert_eq!(play.game.play.take_heard().play_state, PlayState::Paused);
    play.game.finish();
}

#[test]
fn start_pauses_and_starts_again() {
    let mut play = Play::in_world();
    play.pass(
        16,
        &[
            button(PadButton::Start, true),
            button(PadButton::Start, false),
        ],
    );
    assert!(!play.game.is_playing());
    play.pass(
        16,
        &[
            button(PadButton::Start, true),
            button(PadButton::Start, false),
        ],
    );
    assert!(play.game.is_playing());
    play.game.finish();
}

#[test]
fn in_the_backpack_sticks_move_the_focus_and_not_the_player() {
    let mut play = Play::in_world();
    let press = |which| [button(which, true), button(which, false)];
    play.pass(16, &press(PadButton::RightStick));
    assert!(play.game.overlays.is_packing());
    let start = play.feet();
    assert_eq!(play.pass(16, &[stick(Axis::LeftX, 0.9)]), [Key::ArrowRight]);
    for _ in 0..30 {
        play.pass(20, &[]);
    }
    assert!((play.feet() - start).with_y(0.0).length() < 1e-3);
    play.pass(16, &[stick(Axis::LeftX, 0.0)]);
    assert_eq!(play.pass(16, &press(PadButton::South)), [Key::Enter]);
    assert_eq!(play.pass(16, &press(PadButton::West)), [Key::Enter]);
    play.pass(16, &press(PadButton::East));
    assert!(play.game.is_playing());
    play.pass(16, &press(PadButton::RightStick));
    play.pass(16, &press(PadButton::RightStick));
    assert!(play.game.is_playing(), "what opens it closes it");
    play.game.finish();
}

#[test]
fn what_can_be_made_is_found_and_made_by_a_pad() {
    let mut play = Play::in_world_of(Mode::Gathering);
    for kind in [Kind::Coal, Kind::Slate] {
        assert!(play.scene().give_ground(kind, 1.5));
    }
    let context = egui::Context::default();
    antipode_ui::apply_theme(&context);
    let before = play.scene().inventory().count(Item::Lamp);
    let to_the_page = [PadButton::RightStick, PadButton::Down, PadButton::South];
    for which in to_the_page {
        play.press(&context, which);
    }
    assert_eq!(play.scene().inventory().count(Item::Lamp), before);
    // What can be made has the focus.
    for _ in 0..2 {
        play.press(&context, PadButton::South);
        let lamps = play.scene().inventory().count(Item::Lamp);
        assert_eq!(lamps, before + 4, "and there is enough for no more");
    }
    play.game.finish();
}

#[test]
fn in_menus_the_cross_and_the_stick_move_and_buttons_press_and_lead_back() {
    let mut play = Play::in_menu();
    assert_eq!(
        play.pass(16, &[button(PadButton::Down, true)]),
        [Key::ArrowDown]
    );
    assert_eq!(play.pass(300, &[]), [], "not yet");
    assert_eq!(play.pass(150, &[]), [Key::ArrowDown], "held, it goes on");
    assert_eq!(play.pass(120, &[]), [Key::ArrowDown]);
    assert_eq!(play.pass(500, &[button(PadButton::Down, false)]), []);
    assert_eq!(play.pass(16, &[stick(Axis::LeftX, 0.9)]), [Key::ArrowRight]);
    assert_eq!(play.pass(16, &[stick(Axis::LeftX, 0.1)]), []);
    assert_eq!(
        play.pass(16, &[button(PadButton::South, true)]),
        [Key::Enter]
    );
    assert_eq!(
        play.pass(16, &[button(PadButton::RightBumper, true)]),
        [Key::Tab]
    );
    play.game.menus.shell.open(Screen::Controls);
    assert_eq!(play.pass(16, &[button(PadButton::East, true)]), []);
    assert_eq!(play.game.menus.shell.screen(), &Screen::Main);
}

#[test]
fn while_another_window_has_the_keyboard_a_pad_does_nothing() {
    let mut play = Play::in_menu();
    play.game.focus(true);
    play.game.focus(false);
    let held = [button(PadButton::Down, true), stick(Axis::LeftY, -1.0)];
    assert_eq!(play.pass(16, &held), []);
    assert_eq!(play.pass(1000, &[]), []);
    assert_eq!(play.game.devices.sticks, Sticks::default());
    play.game.focus(true);
    assert_eq!(
        play.pass(16, &[]),
        [],
        "what was pressed elsewhere is not held here"
    );
}

#[test]
fn coming_and_going_is_told() {
    let mut play = Play::in_menu();
    let name = || "Mock pad 3".to_owned();
    play.pass(16, &[PadEvent::Connected { name: name() }]);
    assert!(words(&mut play.game).contains("Gamepad connected: Mock pad 3"));
    play.pass(16, &[PadEvent::Disconnected { name: name() }]);
    assert!(words(&mut play.game).contains("Gamepad disconnected: Mock pad 3"));
}

/// Everything that the menus write.
fn words(game: &mut Game) -> String {
    fn gather(shape: &egui::Shape, into: &mut String) {
        match shape {
            egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, into)),
            egui::Shape::Text(text) => *into += text.galley.text(),
            _ => {}
        }
    }
    let context = egui::Context::default();
    antipode_ui::apply_theme(&context);
    let mut said = String::new();
    // A toast is laid out in one pass and seen in the next.
    for _ in 0..2 {
        let size = egui::vec2(1280.0, 720.0);
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
            ..Default::default()
        };
        let output = context.run_pass(input, |context| game.interface(context, None));
        said.clear();
        for clipped in &output.shapes {
            gather(&clipped.shape, &mut said);
        }
    }
    said
}
