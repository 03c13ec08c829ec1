//! The console in a running world: what is typed, by keys, and the mark of worlds in which it cheated.

use egui::{Event, Key, Modifiers};

use super::*;

const BACKQUOTE: Input = Input::Key("Backquote");

/// The game with the console up, and its interface, which remembers from frame to frame.
struct Typing {
    game: Game,
    context: egui::Context,
}

impl Typing {
    fn new(dir: &TempDir) -> Self {
        let mut game = playing(dir);
        input(&mut game, BACKQUOTE, true);
        assert!(game.overlays.is_typing());
        let context = egui::Context::default();
        antipode_ui::apply_theme(&context);
        Self { game, context }
    }

    /// One frame with these events. Returns everything written.
    fn frame(&mut self, events: Vec<Event>) -> String {
        let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(1280.0, 720.0));
        let input = egui::RawInput {
            screen_rect: Some(screen),
            events,
            ..Default::default()
        };
        let game = &mut self.game;
        let output = self
            .context
            .run_pass(input, |context| game.interface(context, None));
        let mut said = String::new();
        for clipped in &output.shapes {
            gather(&clipped.shape, &mut said);
        }
        said
    }

    fn press(&mut self, key: Key) -> String {
        let event = |pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        self.frame(vec![event(true), event(false)]);
        // What is new below is scrolled to in the frame after it was laid out.
        self.frame(Vec::new());
        self.frame(Vec::new())
    }

    fn write(&mut self, text: &str) -> String {
        self.frame(Vec::new());
        self.frame(vec![Event::Text(text.to_owned())]);
        self.frame(Vec::new())
    }

    fn enter(&mut self, line: &str) -> String {
        self.write(line);
        self.press(Key::Enter)
    }

    fn scene(&self) -> &antipode_scene::Scene {
        &self.game.play.phase.session().unwrap().scene
    }
}

fn pass(game: &mut Game, steps: u32) {
    let before = game.play.phase.session().unwrap().scene.simulated_s();
    let wanted = before + f64::from(steps) / 60.0;
    tick_until(game, |game| {
        game.play
            .phase
            .session()
            .is_none_or(|session| session.scene.simulated_s() >= wanted)
    });
}

#[test]
fn the_key_opens_and_closes_it_and_no_key_reaches_the_player_meanwhile() {
    let dir = tempfile::tempdir().unwrap();
    let mut typing = Typing::new(&dir);
    let game = &mut typing.game;
    pass(game, 30);
    let before = game.play.phase.session().unwrap().scene.feet();
    for key in ["KeyW", "KeyP", "F1", "Tab", "Space"] {
        assert!(
            !take_key(game, Input::Key(key), true, false),
            "{key} is for the line"
        );
        input(game, Input::Key(key), true);
    }
    pass(game, 30);
    assert_eq!(game.play.phase.session().unwrap().scene.feet(), before);
    assert!(game.overlays.is_typing() && !game.overlays.is_photographing());
    // Held down it does not flicker.
    assert!(!take_key(game, BACKQUOTE, true, true) && game.overlays.is_typing());
    assert!(take_key(game, BACKQUOTE, true, false) && game.is_playing());
    input(game, BACKQUOTE, true);
    assert!(take_key(game, Input::Key("Escape"), true, false) && game.is_playing());
}

#[test]
fn a_command_that_cheats_marks_the_world_for_ever_and_others_do_not() {
    let dir = tempfile::tempdir().unwrap();
    let mut typing = Typing::new(&dir);
    for line in [
        "aim 10 5",
        "probe",
        "set quality fast",
        "set fly off",
        "give gold 1",
        "help give",
    ] {
        typing.enter(line);
        assert!(!typing.scene().cheated(), "{line}");
    }
    assert!(!typing.frame(Vec::new()).contains("Cheats used"));
    let said = typing.enter("set time 300");
    assert!(
        (typing.scene().time_of_day_s() - 300.0).abs() < 1.0,
        "{said}"
    );
    assert!(
        said.contains("is now marked") && !said.contains("Cheats used"),
        "the display is quiet: {said}"
    );
    let said = typing.enter("set time 100");
    assert_eq!(
        said.matches("is now marked").count(),
        1,
        "told once: {said}"
    );
    typing.game.pause();
    let menu = typing.frame(Vec::new());
    assert!(menu.contains("Cheats used"), "{menu}");
    let mut game = typing.game;
    game.finish();
    let worlds = worlds(dir.path());
    let meta = worlds.list().unwrap().remove(0).meta.unwrap();
    assert!(meta.cheated);
    let again = worlds.load("x").unwrap();
    assert!(again.scene.cheated());
    again.close().unwrap();
}

#[test]
fn each_cheat_marks_and_what_fails_does_not() {
    for line in [
        "teleport 3 200 3",
        "give pickaxe-iron 1",
        "set health 5",
        "set fly on",
    ] {
        let dir = tempfile::tempdir().unwrap();
        let mut game = playing(&dir);
        game.enter("teleport 0 0 0 B");
        assert!(!game.play.phase.session().unwrap().scene.cheated());
        game.enter(line);
        assert!(game.play.phase.session().unwrap().scene.cheated(), "{line}");
    }
}

#[test]
fn what_was_answered_in_one_world_is_not_told_in_the_next() {
    let dir = tempfile::tempdir().unwrap();
    let mut typing = Typing::new(&dir);
    assert!(typing.enter("list").contains("x (euclidean, seed 7)"));
    typing.enter("new euclidean seed=8 name=y");
    tick_until(&mut typing.game, |game| {
        game.is_playing() && game.play.phase.session().is_some_and(|s| s.slug == "y")
    });
    input(&mut typing.game, BACKQUOTE, true);
    let said = typing.frame(Vec::new());
    assert!(!said.contains("seed 7"), "{said}");
    // What was typed can still be brought back.
    typing.press(Key::ArrowUp);
    assert!(typing.frame(Vec::new()).contains("new euclidean seed=8"));
    typing.game.finish();
}

#[test]
fn mistakes_and_refusals_are_sentences() {
    let dir = tempfile::tempdir().unwrap();
    let mut typing = Typing::new(&dir);
    for (line, words) in [
        ("jump", "There is no command “jump”."),
        ("wait 3", "Time passes by itself"),
        ("perf 1", "Only scripts can measure."),
        (
            "set curvature 5",
            "That cannot be done: this space has no curvature dial.",
        ),
        ("give", "give ITEM|GROUND N"),
        ("make sand", "is not made; there are"),
        ("make lamp", "creative world"),
        ("delete x", "cannot be deleted"),
        ("load nowhere", "nowhere"),
        ("shot a/b.png", "without a folder"),
        ("list", "x (euclidean, seed 7)"),
        ("settle", "land"),
        ("help", "teleport"),
    ] {
        let said = typing.enter(line);
        assert!(said.contains(words), "{line}: {said}");
    }
    assert!(typing.game.overlays.is_typing());
}

#[test]
fn what_is_held_is_let_go_after_its_time() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    game.enter("set fly on");
    game.enter("teleport 0 300 0");
    game.enter("aim 0 0");
    game.enter("hold KeyW 0.5");
    pass(&mut game, 60);
    let far = game.play.phase.session().unwrap().scene.feet().pos.x;
    assert!(far > 1.0, "moved {far} m");
    pass(&mut game, 60);
    let farther = game.play.phase.session().unwrap().scene.feet().pos.x;
    pass(&mut game, 60);
    let end = game.play.phase.session().unwrap().scene.feet().pos.x;
    assert!((end - farther).abs() < 0.05, "{far} {farther} {end}");
}

#[test]
fn lines_come_back_with_the_arrows_and_tab_finishes_words() {
    let dir = tempfile::tempdir().unwrap();
    let mut typing = Typing::new(&dir);
    typing.enter("set time 100");
    typing.enter("set time 200");
    typing.write("aim");
    typing.press(Key::ArrowUp);
    typing.press(Key::ArrowUp);
    typing.press(Key::Enter);
    assert!((typing.scene().time_of_day_s() - 100.0).abs() < 1.0);
    typing.write("set ti");
    typing.press(Key::Tab);
    typing.enter("250");
    assert!((typing.scene().time_of_day_s() - 250.0).abs() < 1.0);
}

#[test]
fn what_was_entered_is_there_in_the_next_run() {
    let dir = tempfile::tempdir().unwrap();
    let album = || crate::screenshots::Album::at(dir.path().join("pictures"));
    let settings = dir.path().join("config").join("settings.ron");
    let mut typing = Typing::new(&dir);
    typing.game.begin_in("", album(), Some(&settings));
    typing.enter("set time 123");
    typing.game.finish();
    let request = Request::Load("x".to_owned());
    let mut game = Game::new(worlds(dir.path()), None, Some(request));
    game.begin_in("", album(), Some(&settings));
    assert_eq!(game.overlays.console.view.history(), ["set time 123"]);
    game.finish();
}

#[test]
fn a_new_world_can_be_made_and_one_gone_back_to() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    input(&mut game, BACKQUOTE, true);
    game.enter("new spherical seed=3 name=Ball");
    assert!(!game.overlays.is_typing());
    tick_until(&mut game, |game| {
        game.is_playing() && game.play.phase.session().unwrap().scene.setup().name == "Ball"
    });
    game.enter("load x");
    tick_until(&mut game, |game| {
        game.is_playing() && game.play.phase.session().unwrap().scene.setup().name == "x"
    });
    game.enter("delete Ball");
    assert_eq!(worlds(dir.path()).list().unwrap().len(), 1);
    game.enter("quit");
    tick_until(&mut game, Game::is_over);
}

#[test]
fn the_console_changes_the_players_own_settings_and_marks_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let mut typing = Typing::new(&dir);
    assert!(!typing.game.options.config.settings.contour_bands);
    typing.enter("set contour-bands on");
    assert!(typing.game.options.config.settings.contour_bands);
    assert!(typing.scene().viewing().contour_bands);
    assert!(!typing.scene().cheated());
    let said = typing.enter("set field-of-view 500");
    assert!(said.contains("from 40 to 110"), "{said}");
}
