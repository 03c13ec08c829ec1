//! The backpack in a running world: keys, pointer, and that nothing is ever lost, whatever is done to it.

use antipode_scene::{Inventory, Item, Stack};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, pos2};
use proptest::prelude::*;

use super::*;

const KEY_E: Input = Input::Key("KeyE");

/// The game, and its interface, which remembers from frame to frame.
struct Packing {
    game: Game,
    context: egui::Context,
}

impl Packing {
    fn new(dir: &TempDir) -> Self {
        let mut game = playing(dir);
        input(&mut game, KEY_E, true);
        assert!(game.overlays.is_packing() && !game.is_playing());
        let context = egui::Context::default();
        antipode_ui::apply_theme(&context);
        let mut packing = Self { game, context };
        packing.frame(Vec::new());
        packing
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

    fn bag(&self) -> &Inventory {
        self.game.play.phase.session().unwrap().scene.inventory()
    }

    /// Everything that was there in the beginning is carried or lies about.
    fn is_all_there(&self) {
        let scene = &self.game.play.phase.session().unwrap().scene;
        for item in Item::ALL {
            let about = scene.drops().into_iter().map(|drop| drop.stack);
            let about: u32 = about.filter(|s| s.item == item).map(|s| s.count).sum();
            let all = scene.inventory().count(item) + about;
            assert_eq!(all, item.at_start(), "{item:?}");
        }
    }
}

fn button(pos: Pos2, button: PointerButton, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

#[test]
fn the_world_goes_on_behind_it_and_no_key_reaches_the_player() {
    let dir = tempfile::tempdir().unwrap();
    let mut packing = Packing::new(&dir);
    let game = &mut packing.game;
    let scene = |game: &Game| {
        let scene = &game.play.phase.session().unwrap().scene;
        (scene.feet(), scene.simulated_s())
    };
    tick_until(game, |game| scene(game).1 > 0.8);
    let (feet, before) = scene(game);
    for key in ["KeyW", "KeyP", "Backquote", "Space"] {
        assert!(!take_key(game, Input::Key(key), true, false), "{key}");
        input(game, Input::Key(key), true);
    }
    game.motion(50.0, 50.0);
    tick_until(game, |game| scene(game).1 > before + 0.5);
    assert_eq!(scene(game).0, feet);
    assert!(!game.overlays.is_photographing() && !game.overlays.is_typing());
    assert!(take_key(game, KEY_E, true, false) && game.is_playing());
    input(game, KEY_E, true);
    game.escape();
    assert!(game.is_playing(), "Esc closes it and nothing else");
}

#[test]
fn it_opens_neither_in_the_photo_mode_nor_in_menus() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = playing(&dir);
    input(&mut game, Input::Key("KeyP"), true);
    assert!(game.overlays.is_photographing());
    take_key(&mut game, KEY_E, true, false);
    input(&mut game, KEY_E, true);
    assert!(!game.overlays.is_packing());
    game.escape();
    game.pause();
    take_key(&mut game, KEY_E, true, false);
    input(&mut game, KEY_E, true);
    assert!(!game.overlays.is_packing() && is_paused(&game));
}

#[test]
fn numbers_swap_and_q_throws_one_of_what_is_pointed_at() {
    let dir = tempfile::tempdir().unwrap();
    let mut packing = Packing::new(&dir);
    let key = |key| Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    // The second slot is in hand and has the focus; four to the right lie the lamps.
    for _ in 0..4 {
        packing.frame(vec![key(Key::ArrowRight)]);
        packing.frame(Vec::new());
    }
    let lamps = |count| {
        Some(Stack {
            item: Item::Lamp,
            count,
        })
    };
    assert_eq!(packing.bag().slots()[5], lamps(10));
    let seeds = packing.bag().slots()[8];
    assert!(take_key(
        &mut packing.game,
        Input::Key("Digit9"),
        true,
        false
    ));
    packing.frame(Vec::new());
    assert_eq!(
        (packing.bag().slots()[5], packing.bag().slots()[8]),
        (seeds, lamps(10))
    );
    assert!(take_key(
        &mut packing.game,
        Input::Key("Digit6"),
        true,
        false
    ));
    packing.frame(Vec::new());
    assert_eq!(packing.bag().slots()[5], seeds, "swapped with itself");
    assert!(take_key(
        &mut packing.game,
        Input::Key("Digit9"),
        true,
        false
    ));
    packing.frame(Vec::new());
    assert!(take_key(&mut packing.game, Input::Key("KeyQ"), true, false));
    packing.frame(Vec::new());
    assert_eq!(packing.bag().slots()[5], lamps(9));
    packing.is_all_there();
}

#[test]
fn whatever_ends_it_puts_back_what_was_at_the_pointer() {
    let ends: [fn(&mut Game); 4] = [
        |game| game.escape(),
        |game| {
            game.focus(true);
            game.focus(false);
        },
        |game| game.pause(),
        |game| {
            take_key(game, KEY_E, true, false);
        },
    ];
    for end in ends {
        let dir = tempfile::tempdir().unwrap();
        let mut packing = Packing::new(&dir);
        let session = packing.game.play.phase.session_mut().unwrap();
        session.scene.inventory_mut().click(5);
        packing.frame(Vec::new());
        end(&mut packing.game);
        assert!(!packing.game.overlays.is_packing());
        assert_eq!(packing.bag().carried(), None);
        assert_eq!(packing.bag().slots()[5].map(|stack| stack.count), Some(10));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, failure_persistence: None, ..ProptestConfig::default() })]

    /// However the pointer runs over it, everything is carried or lies about, before and after it is closed and when
    /// the world is there again.
    #[test]
    fn nothing_is_lost(moves in prop::collection::vec((0f32..800.0, 0f32..600.0, any::<bool>(), any::<bool>()), 1..120)) {
        let dir = tempfile::tempdir().unwrap();
        let mut packing = Packing::new(&dir);
        for (x, y, other, pressed) in moves {
            let at = pos2(x, y);
            let by = if other { PointerButton::Secondary } else { PointerButton::Primary };
            packing.frame(vec![Event::PointerMoved(at), button(at, by, pressed)]);
            packing.is_all_there();
        }
        if packing.game.overlays.is_packing() {
            take_key(&mut packing.game, KEY_E, true, false);
        }
        prop_assert_eq!(packing.bag().carried(), None);
        packing.is_all_there();
        let kept: Vec<_> = packing.bag().slots().to_vec();
        packing.game.finish();
        let again = worlds(dir.path()).load("x").unwrap();
        prop_assert_eq!(again.scene.inventory().slots(), kept.as_slice());
        again.close().unwrap();
    }
}
