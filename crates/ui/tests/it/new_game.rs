//! The form for a new world, driven as a player drives it.

use crate::common::{
    Game, SIZES, click, everywhere, focused, intents, painted, press, type_text, window, world,
};
use antipode_language::{Language, Texts};
use antipode_ui::{GeometryChoice, Intent, ModeChoice, Screen};
use egui::{Key, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

fn form(size: Vec2) -> Harness<'static, Game> {
    let mut harness = crate::common::harness(Game::new(), size);
    harness.state_mut().shell.open(Screen::NewGame);
    harness.run();
    harness
}

fn new_game(
    name: &str,
    geometry: GeometryChoice,
    seed: Option<u64>,
    radius_m: Option<f64>,
) -> Intent {
    Intent::NewGame {
        name: name.to_owned(),
        geometry,
        mode: ModeChoice::Creative,
        seed,
        radius_m,
    }
}

fn create_is_disabled(harness: &Harness<'_, Game>) -> bool {
    harness
        .get_by_label("Create")
        .accesskit_node()
        .is_disabled()
}

#[test]
fn a_name_is_judged_while_it_is_typed() {
    let mut harness = window(Game::new());
    click(&mut harness, "New Game");
    assert_eq!(focused(&harness), "Name");
    assert!(!create_is_disabled(&harness), "a name is offered");
    type_text(&mut harness, "Taken");
    harness.get_by_label("There is a world of that name already.");
    assert!(create_is_disabled(&harness));
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), []);
    assert_eq!(focused(&harness), "Name");
    type_text(&mut harness, " not");
    harness.get_by_label("This name is free.");
    click(&mut harness, "Create");
    let expected = new_game("Taken not", GeometryChoice::Hyperbolic, None, None);
    assert_eq!(intents(&mut harness), [expected]);
}

#[test]
fn enter_and_enter_plays_under_a_name_that_is_free_in_every_language() {
    for (language, name) in [
        (Language::English, "World 2"),
        (Language::Polish, "Świat 1"),
        (Language::German, "Welt 1"),
        (Language::Spanish, "Mundo 1"),
        (Language::Chinese, "世界 1"),
    ] {
        let mut game = Game::new();
        game.texts = Texts::new(language);
        game.worlds = vec![world(0), world(1)];
        let mut harness = window(game);
        press(&mut harness, Key::Enter);
        assert_eq!(harness.state().shell.screen(), &Screen::NewGame);
        press(&mut harness, Key::Enter);
        let expected = new_game(name, GeometryChoice::Hyperbolic, None, None);
        assert_eq!(intents(&mut harness), [expected], "{language:?}");
    }
}

#[test]
fn the_name_on_offer_gives_way_to_what_is_typed_and_to_worlds_that_come_to_be_known() {
    let value = |harness: &Harness<'_, Game>| {
        let name = harness.get_by_label("Name").value();
        name.unwrap_or_default()
    };
    let mut harness = form(vec2(1280.0, 720.0));
    assert_eq!(value(&harness), "World 1");
    harness.state_mut().worlds = vec![world(1)];
    harness.run();
    assert_eq!(value(&harness), "World 2", "it is taken by now");
    type_text(&mut harness, "M");
    type_text(&mut harness, "ine");
    assert_eq!(value(&harness), "Mine");
    harness.state_mut().worlds = vec![world(1), world(2)];
    harness.run();
    assert_eq!(value(&harness), "Mine");
}

#[test]
fn a_closed_world_has_a_named_size_or_any_other_and_tells_the_way_round() {
    let mut harness = form(vec2(1280.0, 720.0));
    click(&mut harness, "Spherical");
    harness.get_by_label_contains("Around the world: 628 m, 2.3 minutes");
    let mut sizes = vec![100.0];
    click(&mut harness, "Create");
    for (size, radius_m) in [
        ("Moonlet, 32 m", 32.0),
        ("Planet, 256 m", 256.0),
        ("Moon, 100 m", 100.0),
    ] {
        click(&mut harness, size);
        click(&mut harness, "Create");
        sizes.push(radius_m);
    }
    harness
        .get_by_role(egui::Role::Slider)
        .set_value_accesskit(57.0);
    harness.run();
    harness.get_by_label_contains("Around the world: 358 m");
    click(&mut harness, "Create");
    sizes.push(57.0);
    let round = |radius_m| new_game("World 1", GeometryChoice::Spherical, None, Some(radius_m));
    let expected: Vec<_> = sizes.into_iter().map(round).collect();
    assert_eq!(intents(&mut harness), expected);
}

/// The roles of what bears these labels, and whether each is chosen.
fn cards(harness: &Harness<'_, Game>, labels: [&str; 2]) -> [(egui::Role, bool); 2] {
    labels.map(|label| {
        let node = harness.get_by_label(label).accesskit_node();
        let chosen = node.toggled() == Some(egui::accesskit::Toggled::True);
        (node.role(), chosen)
    })
}

#[test]
fn the_mode_is_asked_for_by_mouse_and_by_keys_and_comes_with_the_world() {
    let radio = egui::Role::RadioButton;
    let modes = ["Creative", "Gathering"];
    let mut harness = form(vec2(1280.0, 720.0));
    assert_eq!(cards(&harness, modes), [(radio, true), (radio, false)]);
    harness.get_by_label("Mode");
    click(&mut harness, "Gathering");
    assert_eq!(cards(&harness, modes), [(radio, false), (radio, true)]);
    click(&mut harness, "Create");
    click(&mut harness, "Creative");
    click(&mut harness, "Create");
    for size in [vec2(1280.0, 720.0), vec2(640.0, 360.0), vec2(320.0, 200.0)] {
        let mut by_keys = form(size);
        for key in [Key::ArrowDown, Key::Tab].into_iter().cycle().take(40) {
            if focused(&by_keys) == "Gathering" {
                break;
            }
            press(&mut by_keys, key);
        }
        press(&mut by_keys, Key::Space);
        assert_eq!(cards(&by_keys, modes)[1], (radio, true), "{size}");
        by_keys.get_by_label("Name").focus();
        by_keys.run();
        press(&mut by_keys, Key::Enter);
        let mut made = intents(&mut by_keys);
        harness.state_mut().intents.append(&mut made);
    }
    let made = intents(&mut harness)
        .into_iter()
        .map(|intent| match intent {
            Intent::NewGame { mode, .. } => mode.id(),
            _ => "none",
        });
    let made: Vec<_> = made.collect();
    let by_keys = ["gathering"; 3];
    assert_eq!(made, [&["gathering", "creative"][..], &by_keys].concat());
}

#[test]
fn every_mode_is_told_in_a_sentence_beside_no_other_words() {
    for (language, size) in everywhere(&SIZES) {
        let mut game = Game::new();
        game.texts = Texts::new(language);
        game.shell.open(Screen::NewGame);
        let told = ModeChoice::ALL.map(|mode| mode.description(&game.texts));
        // As high as the form is long: everything is drawn.
        let mut harness = crate::common::harness(game, size.max(vec2(0.0, 1400.0)));
        harness.run();
        let texts = painted(harness.output());
        for told in told {
            let found = texts.iter().position(|text| text.text == told);
            let found = found.unwrap_or_else(|| panic!("{told} in {language:?} at {size}"));
            let at = texts[found].rect;
            assert!(texts[found].clip.expand(0.5).contains_rect(at), "{told}");
            let others = texts.iter().enumerate().filter(|(n, _)| *n != found);
            for (_, other) in others {
                let apart = !other.rect.shrink(1.0).intersects(at.shrink(1.0));
                assert!(apart, "{told} lies on {} at {size}", other.text);
            }
        }
    }
}

#[test]
fn enter_in_the_name_creates() {
    let mut harness = form(vec2(1280.0, 720.0));
    type_text(&mut harness, "  Foo ");
    press(&mut harness, Key::Enter);
    let expected = new_game("Foo", GeometryChoice::Hyperbolic, None, None);
    assert_eq!(intents(&mut harness), [expected]);
}

#[test]
fn only_spherical_worlds_have_a_radius() {
    let mut harness = form(vec2(1280.0, 720.0));
    type_text(&mut harness, "Ball");
    assert!(harness.query_by_role(egui::Role::Slider).is_none());
    click(&mut harness, "Spherical");
    harness
        .get_by_role(egui::Role::Slider)
        .set_value_accesskit(48.0);
    harness.run();
    click(&mut harness, "Create");
    click(&mut harness, "Euclidean");
    assert!(harness.query_by_role(egui::Role::Slider).is_none());
    click(&mut harness, "Create");
    let round = new_game("Ball", GeometryChoice::Spherical, None, Some(48.0));
    let flat = new_game("Ball", GeometryChoice::Euclidean, None, None);
    assert_eq!(intents(&mut harness), [round, flat]);
}

#[test]
fn a_bad_seed_is_said_and_stops_creation() {
    let mut harness = form(vec2(1280.0, 720.0));
    type_text(&mut harness, "Foo");
    harness.get_by_label("Seed (optional)").focus();
    harness.run();
    type_text(&mut harness, "99999999999999999999");
    harness.get_by_label_contains("Too large");
    harness.get_by_label("Needs a valid seed");
    assert!(create_is_disabled(&harness));
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), []);
}

#[test]
fn a_seed_reaches_the_intent() {
    let mut harness = form(vec2(1280.0, 720.0));
    type_text(&mut harness, "Foo");
    harness.get_by_label("Seed (optional)").focus();
    harness.run();
    type_text(&mut harness, "77");
    harness.get_by_label("The seed is 77.");
    press(&mut harness, Key::Enter);
    let expected = new_game("Foo", GeometryChoice::Hyperbolic, Some(77), None);
    assert_eq!(intents(&mut harness), [expected]);
}

#[test]
fn arrows_and_enter_alone_reach_every_part() {
    for size in [vec2(1280.0, 720.0), vec2(640.0, 360.0)] {
        let mut harness = form(size);
        type_text(&mut harness, "Keys");
        let mut reached = Vec::new();
        for _ in 0..12 {
            press(&mut harness, Key::Tab);
            reached.push(focused(&harness));
        }
        for part in [
            "Hyperbolic lens",
            "Hyperbolic world",
            "Euclidean",
            "Spherical",
            "Creative",
            "Gathering",
            "Seed (optional)",
            "Create",
            "Back",
        ] {
            assert!(
                reached.iter().any(|name| name == part),
                "{part} in {reached:?} at {size}"
            );
        }
        harness.get_by_label("Name").focus();
        harness.run();
        press(&mut harness, Key::ArrowDown);
        let card = focused(&harness);
        assert!(
            GeometryChoice::ALL
                .iter()
                .any(|choice| choice.label(&harness.state().texts) == card),
            "{card} at {size}"
        );
        press(&mut harness, Key::ArrowUp);
        assert_eq!(focused(&harness), "Name");
    }
}

#[test]
fn the_form_is_fresh_each_time_but_survives_a_message() {
    let mut harness = form(vec2(1280.0, 720.0));
    type_text(&mut harness, "Kept");
    let shell = &mut harness.state_mut().shell;
    shell.open(Screen::Busy {
        title: "Making it".to_owned(),
        progress: Some(0.1),
        detail: String::new(),
    });
    shell.open(Screen::Message {
        title: "No".to_owned(),
        text: "The disk is full.".to_owned(),
    });
    harness.run();
    click(&mut harness, "OK");
    assert_eq!(harness.state().shell.screen(), &Screen::NewGame);
    assert_eq!(
        harness.get_by_label("Name").value().as_deref(),
        Some("Kept")
    );
    click(&mut harness, "Back");
    click(&mut harness, "New Game");
    assert_eq!(
        harness.get_by_label("Name").value().as_deref(),
        Some("World 1")
    );
}
