//! What newcomers meet: the about screen, the backdrop, hints, and toasts that keep off dialogs.

use crate::common::{Game, Painted, click, focused, intents, painted, press, window, world};
use antipode_language::{Language, Texts};
use antipode_settings::Value;
use antipode_ui::{
    Backdrop, CurvatureView, DialKind, HintModel, HudModel, Intent, Screen, SlotView, SpeechModel,
    ToastKind, apply_theme, photo_panel, show_hud,
};
use egui::{Key, Pos2, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn says(harness: &Harness<'_, Game>, words: &str) -> bool {
    painted(harness.output())
        .iter()
        .any(|text| text.text.contains(words))
}

#[test]
fn the_about_screen_tells_version_adapter_and_licences_and_escape_leads_back() {
    for language in Language::ALL {
        let mut game = Game::new();
        game.texts = Texts::new(language);
        let label = game.texts.say("menu-about");
        let mut harness = window(game);
        click(&mut harness, &label);
        for words in [
            "0.1.0",
            "Radiant 9000 (Vulkan)",
            "radiant 1.2",
            "egui 0.37",
            "Apache",
        ] {
            assert!(says(&harness, words), "{language:?}: {words}");
        }
        assert!(says(&harness, "wgpu "), "others' work is listed");
        harness.state_mut().shell.escape(false);
        harness.run();
        assert_eq!(harness.state().shell.screen(), &Screen::Main);
    }
}

#[test]
fn the_about_screen_is_read_and_left_by_keyboard() {
    let mut harness = window(Game::new());
    harness.get_by_label("About").focus();
    press(&mut harness, Key::Enter);
    assert_eq!(focused(&harness), "Back");
    let top = |harness: &Harness<'_, Game>| {
        let texts = painted(harness.output());
        let list = texts.iter().find(|text| text.text.contains("wgpu "));
        list.expect("the list of others' work").rect.min.y
    };
    let before = top(&harness);
    press(&mut harness, Key::ArrowDown);
    let after = top(&harness);
    assert!(after < before - 10.0, "{before} {after}");
    assert_eq!(focused(&harness), "Back");
    press(&mut harness, Key::End);
    assert!(top(&harness) < after - 500.0);
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().shell.screen(), &Screen::Main);
}

#[test]
fn the_pause_menu_has_no_about_but_a_way_past_the_hints() {
    let mut game = Game::new();
    game.worlds = vec![world(0)];
    game.running = Some("World 0".to_owned());
    let mut harness = window(game);
    assert!(harness.query_by_label("About").is_none());
    click(&mut harness, "Skip the hints");
    let value = Value::Switch(false);
    assert_eq!(intents(&mut harness), [Intent::Set { id: "hints", value }]);
    harness.run();
    assert!(harness.query_by_label("Skip the hints").is_none());
    harness.state_mut().running = None;
    harness.state_mut().config.settings.hints = true;
    harness.run();
    assert!(
        harness.query_by_label("Skip the hints").is_none(),
        "without a world there are no hints"
    );
}

/// Whether something is painted over the whole window, and how thickly at most, 0 to 255.
fn veil(harness: &Harness<'_, Game>) -> u8 {
    let window = harness.ctx.content_rect();
    let thickness = |shape: &Shape| match shape {
        Shape::Mesh(mesh) if mesh.calc_bounds().contains_rect(window) => 255,
        Shape::Rect(rect) if rect.rect.contains_rect(window) => rect.fill.a(),
        _ => 0,
    };
    let shapes = harness.output().shapes.iter();
    shapes
        .map(|clipped| thickness(&clipped.shape))
        .max()
        .unwrap_or(0)
}

#[test]
fn a_live_world_shows_behind_the_menu_and_fades_to_dark() {
    let mut harness = window(Game::new());
    harness.run();
    assert_eq!(
        veil(&harness),
        255,
        "our own picture, where there is no world"
    );
    for (shade, least, most) in [(0.0, 0, 0), (0.5, 120, 135), (1.0, 255, 255)] {
        harness.state_mut().backdrop = Backdrop { live: true, shade };
        harness.run();
        let veil = veil(&harness);
        assert!((least..=most).contains(&veil), "{shade}: {veil}");
    }
}

fn dialogs() -> Vec<Screen> {
    let text = "The disk is full and so nothing more can be written. ".to_owned();
    vec![
        Screen::Message {
            title: "The world could not be opened".to_owned(),
            text: text.repeat(3),
        },
        Screen::Message {
            title: "Oh".to_owned(),
            text: text.repeat(40),
        },
        Screen::Unsaved {
            text: text.repeat(2),
        },
        Screen::Busy {
            title: "Saving".to_owned(),
            progress: Some(0.5),
            detail: String::new(),
        },
    ]
}

/// Texts of toasts, and of everything else, in the order in which they were painted.
fn apart(harness: &Harness<'_, Game>) -> (Vec<Painted>, Vec<Painted>) {
    let all = painted(harness.output()).into_iter();
    all.partition(|text| text.text.starts_with("Toast"))
}

#[test]
fn a_toast_never_lies_on_a_dialog() {
    for size in [
        vec2(800.0, 600.0),
        vec2(640.0, 360.0),
        vec2(1280.0, 720.0),
        vec2(427.0, 240.0),
    ] {
        for screen in dialogs() {
            let mut game = Game::new();
            game.shell.open(screen.clone());
            for number in 0..4 {
                let words = format!("Toast {number}: something that takes a whole line to say.");
                game.shell.toast(words, ToastKind::Problem);
            }
            let mut harness = crate::common::harness(game, size);
            harness.run_steps(2);
            let (toasts, others) = apart(&harness);
            for toast in &toasts {
                for other in &others {
                    let lies = toast.rect.intersects(other.rect.intersect(other.clip));
                    assert!(!lies, "“{}” lies on “{}” at {size}", toast.text, other.text);
                }
                let whole = Rect::from_min_size(Pos2::ZERO, size);
                assert!(whole.contains_rect(toast.rect), "{} at {size}", toast.text);
            }
        }
    }
}

#[test]
fn a_toast_never_lies_on_the_panel_of_the_photo_mode() {
    for size in [vec2(960.0, 540.0), vec2(640.0, 360.0), vec2(427.0, 240.0)] {
        let panel = photo_panel(Rect::from_min_size(Pos2::ZERO, size));
        let mut game = Game::new();
        game.shell.open(Screen::Hidden);
        game.running = Some("World 0".to_owned());
        game.shell.keep_toasts_off(Some(panel));
        let words = "Toast 0: something that takes a whole line to say.";
        game.shell.toast(words, ToastKind::Info);
        let mut harness = crate::common::harness(game, size);
        harness.run_steps(2);
        let (toasts, _) = apart(&harness);
        let rect = toasts[0].rect;
        assert!(
            rect.min.x >= 0.0 && rect.max.x <= panel.min.x,
            "{rect} at {size}"
        );
    }
}

#[test]
fn nothing_lies_on_the_dial_in_windows_of_any_size() {
    for size in [
        vec2(1280.0, 720.0),
        vec2(800.0, 450.0),
        vec2(640.0, 360.0),
        vec2(533.0, 300.0),
        vec2(427.0, 240.0),
        vec2(400.0, 225.0),
    ] {
        let mut game = Game::new();
        game.shell.open(Screen::Hidden);
        game.running = Some("World 0".to_owned());
        let toast = "Toast 0: something that takes a whole line to say.";
        game.shell.toast(toast, ToastKind::Info);
        let speech = SpeechModel {
            text: "Word: ".repeat(12),
            at: Some([0.9 * size.x / size.y, -0.2]),
        };
        let model = HudModel {
            slots: vec![SlotView::default(); 10],
            curvature: Some(CurvatureView {
                kind: DialKind::Raised,
                value: 10.0,
                min: 0.0,
                max: 20.0,
            }),
            speech: Some(speech),
            ..HudModel::default()
        };
        let texts = Texts::default();
        let mut harness = Harness::builder()
            .with_size(size)
            .with_context_setup(apply_theme)
            .build_ui_state(
                move |ui, (game, dial): &mut (Game, Rect)| {
                    *dial = show_hud(ui.ctx(), &texts, &model);
                    game.shell.keep_toasts_above(*dial);
                    game.show(ui.ctx());
                },
                (game, Rect::NOTHING),
            );
        harness.run_steps(2);
        let dial = harness.state().1;
        assert!(dial.is_positive(), "the dial is there at {size}");
        let over = painted(harness.output()).into_iter();
        let mut over = over.filter(|it| {
            ["Toast", "Word"]
                .iter()
                .any(|it_is| it.text.starts_with(it_is))
        });
        let (one, other) = (over.next(), over.next());
        for said in [one, other] {
            let said = said.unwrap_or_else(|| panic!("a message is missing at {size}"));
            assert!(
                !said.rect.intersects(dial),
                "“{}” {} {dial} at {size}",
                said.text,
                said.rect
            );
        }
    }
}

#[test]
fn a_toast_never_lies_on_the_crosshair() {
    for size in [vec2(800.0, 600.0), vec2(400.0, 300.0), vec2(640.0, 360.0)] {
        let mut game = Game::new();
        game.shell.open(Screen::Hidden);
        game.running = Some("World 0".to_owned());
        for number in 0..2 {
            let words = format!("Toast {number}: something that takes a whole line to say.");
            game.shell.toast(words, ToastKind::Info);
        }
        let mut harness = crate::common::harness(game, size);
        harness.run_steps(2);
        let (toasts, _) = apart(&harness);
        assert_eq!(toasts.len(), 2);
        let middle = Rect::from_center_size((size / 2.0).to_pos2(), vec2(24.0, 24.0));
        for toast in toasts {
            assert!(!toast.rect.expand(8.0).intersects(middle), "at {size}");
        }
    }
}

#[test]
fn a_toast_without_room_beside_a_dialog_waits_for_its_end() {
    let mut game = Game::new();
    let tall = dialogs().swap_remove(1);
    game.shell.open(tall);
    game.shell.toast(
        "Toast: something that takes a whole line to say.",
        ToastKind::Info,
    );
    let mut harness = crate::common::harness(game, vec2(800.0, 600.0));
    // A step is a quarter of a second: longer than a toast stays.
    harness.run_steps(40);
    assert!(apart(&harness).0.is_empty());
    harness.state_mut().shell.escape(false);
    harness.run_steps(2);
    assert_eq!(apart(&harness).0.len(), 1, "it is still to be read");
    harness.run_steps(40);
    assert!(apart(&harness).0.is_empty());
}

fn hud_with(hint: HintModel, size: Vec2) -> Harness<'static, HudModel> {
    let model = HudModel {
        chart: [-12.344, 1.7, 3.0],
        curved: [0.1, -0.2, 0.3, 1.066],
        hint: Some(hint),
        show_crosshair: true,
        ..HudModel::default()
    };
    let texts = Texts::default();
    let mut harness = Harness::builder()
        .with_size(size)
        .with_context_setup(apply_theme)
        .build_ui_state(
            move |ui, model: &mut HudModel| {
                show_hud(ui.ctx(), &texts, model);
            },
            model,
        );
    harness.run();
    harness
}

#[test]
fn a_hint_is_shown_whole_and_never_on_the_crosshair() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        let keys = [
            ("up", "Wheel turned upwards".into()),
            ("down", "Wheel turned downwards".into()),
        ];
        let footer = [("step", 6.into()), ("count", 7.into()), ("key", "N".into())];
        let hint = HintModel {
            text: texts.say_with("hints-curve", &keys),
            footer: texts.say_with("hints-footer", &footer),
        };
        // 800 by 600 pixels at scales 1 and 2, and more.
        for size in [
            (800.0, 600.0),
            (400.0, 300.0),
            (1280.0, 720.0),
            (640.0, 360.0),
        ] {
            let size = Vec2::from(size);
            let harness = hud_with(hint.clone(), size);
            let middle = Rect::from_center_size((size / 2.0).to_pos2(), vec2(24.0, 24.0));
            for words in [&hint.text, &hint.footer] {
                let texts = painted(harness.output());
                let text = texts.iter().find(|text| text.text == **words);
                let text = text.unwrap_or_else(|| panic!("“{words}” is missing at {size}"));
                assert!(!text.rect.intersects(middle), "“{words}” at {size}");
                assert!(Rect::from_min_size(Pos2::ZERO, size).contains_rect(text.rect));
            }
        }
    }
}
