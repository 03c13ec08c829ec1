//! The name of a flag: asked for by a click on it, typed, and left with Escape.

use antipode_settings::MouseButton;
use egui::{Event, Key, Modifiers, Pos2};

use super::*;

/// The game, and its interface, which remembers from frame to frame.
struct Naming {
    game: Game,
    context: egui::Context,
    now: Instant,
}

impl Naming {
    /// Before a flag that was planted.
    fn new(dir: &TempDir) -> Self {
        let game = playing(dir);
        let context = egui::Context::default();
        antipode_ui::apply_theme(&context);
        let now = Instant::now() + Duration::from_secs(1);
        let mut naming = Self { game, context, now };
        let scene = &mut naming.game.play.phase.session_mut().unwrap().scene;
        scene.inventory_mut().select(6);
        scene.aim(0.0, -0.9);
        naming.click();
        assert_eq!(naming.names(), [""]);
        assert!(naming.game.is_playing());
        naming
    }

    fn click(&mut self) {
        for down in [true, false] {
            input(&mut self.game, Input::Mouse(MouseButton::Left), down);
        }
        self.now += Duration::from_millis(200);
        self.game.tick(self.now);
        self.frame(Vec::new());
    }

    fn frame(&mut self, events: Vec<Event>) {
        let screen = egui::Rect::from_min_size(Pos2::ZERO, egui::vec2(800.0, 600.0));
        let input = egui::RawInput {
            screen_rect: Some(screen),
            events,
            ..Default::default()
        };
        let game = &mut self.game;
        let _ = self
            .context
            .run_pass(input, |context| game.interface(context, None));
    }

    fn answer(&mut self, text: &str) {
        self.frame(vec![Event::Text(text.to_owned())]);
        self.tap(Key::Enter);
    }

    fn tap(&mut self, key: Key) {
        let event = |pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        self.frame(vec![event(true)]);
        self.frame(vec![event(false)]);
    }

    fn names(&self) -> Vec<String> {
        let scene = &self.game.play.phase.session().unwrap().scene;
        scene.flag_ways().into_iter().map(|way| way.name).collect()
    }
}

#[test]
fn a_click_on_a_flag_asks_for_its_name_and_what_is_typed_moves_nobody() {
    let dir = tempfile::tempdir().unwrap();
    let mut naming = Naming::new(&dir);
    naming.click();
    assert!(naming.game.overlays.is_naming() && !naming.game.is_playing());
    let feet = |naming: &Naming| naming.game.play.phase.session().unwrap().scene.feet();
    let before = feet(&naming);
    // The key by which one walks there is held, and the system tells it again: it is no letter of the name.
    assert!(take_key(&mut naming.game, Input::Key("KeyW"), true, true));
    assert!(!take_key(&mut naming.game, Input::Key("KeyW"), true, false));
    assert!(!take_key(&mut naming.game, Input::Key("KeyW"), true, true));
    naming.now += Duration::from_millis(200);
    naming.game.tick(naming.now);
    take_key(&mut naming.game, Input::Key("KeyW"), false, false);
    assert_eq!(feet(&naming), before);
    naming.answer("Home");
    assert_eq!(naming.names(), ["Home"]);
    assert!(naming.game.is_playing());
    naming.game.finish();
    let again = worlds(dir.path()).load("x").unwrap();
    assert_eq!(again.scene.flag_ways()[0].name, "Home");
    again.close().unwrap();
}

#[test]
fn escape_leaves_a_flag_its_name() {
    let dir = tempfile::tempdir().unwrap();
    let mut naming = Naming::new(&dir);
    naming.click();
    naming.frame(vec![Event::Text("Not so".to_owned())]);
    let escape = Press::of(Input::Key("Escape"), true);
    assert!(!naming.game.press(&escape).is_heard());
    naming.frame(Vec::new());
    assert!(!naming.game.overlays.is_naming() && naming.game.is_playing());
    assert_eq!(naming.names(), [""]);
    naming.game.finish();
}

#[test]
fn what_is_asked_of_a_flag_goes_when_the_world_is_left() {
    let dir = tempfile::tempdir().unwrap();
    let mut naming = Naming::new(&dir);
    naming.click();
    naming.game.pause();
    naming.frame(Vec::new());
    assert!(!naming.game.overlays.is_naming());
    naming.game.finish();
}

#[test]
fn both_buttons_are_pressed_by_keys() {
    let dir = tempfile::tempdir().unwrap();
    let mut naming = Naming::new(&dir);
    for (tabs, name) in [(2, ""), (1, "Here")] {
        naming.click();
        assert!(naming.game.overlays.is_naming());
        naming.frame(vec![Event::Text("Here".to_owned())]);
        for _ in 0..tabs {
            naming.tap(Key::Tab);
        }
        naming.tap(Key::Enter);
        naming.frame(Vec::new());
        assert!(!naming.game.overlays.is_naming(), "{tabs}");
        assert_eq!(naming.names(), [name], "{tabs}");
    }
    naming.game.finish();
}
