//! The console as it is drawn and typed in.

use crate::common::painted;
use antipode_language::{Language, Texts};
use antipode_ui::{Completion, Console, LineKind, apply_theme};
use egui::{Key, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

#[derive(Default)]
struct Typed {
    texts: Texts,
    console: Console,
    entered: Vec<String>,
}

fn typed(size: Vec2) -> Harness<'static, Typed> {
    let mut typed = Typed::default();
    typed.console.open();
    Harness::builder()
        .with_size(size)
        .with_max_steps(8)
        .allow_missing_glyphs()
        .with_context_setup(apply_theme)
        .build_ui_state(
            |ui, typed: &mut Typed| {
                let complete = |line: &str| Completion {
                    line: format!("{line}port "),
                    options: vec!["A".to_owned(), "B".to_owned()],
                };
                let entered = typed.console.show(ui.ctx(), &typed.texts, &complete);
                typed.entered.extend(entered);
            },
            typed,
        )
}

fn write(harness: &mut Harness<'_, Typed>, text: &str) {
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
}

fn press(harness: &mut Harness<'_, Typed>, key: Key) {
    harness.key_press(key);
    harness.run();
}

fn said(harness: &Harness<'_, Typed>) -> String {
    let texts: Vec<_> = painted(harness.output())
        .into_iter()
        .map(|text| text.text)
        .collect();
    texts.join("\n")
}

#[test]
fn a_fast_hand_enters_whole_lines_however_slow_the_frames_are() {
    let mut typed = typed(vec2(800.0, 600.0));
    typed.run();
    let text = |text: &str| egui::Event::Text(text.to_owned());
    let key = |key| egui::Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: egui::Modifiers::NONE,
    };
    // All within one frame.
    for event in [
        text("set time 4"),
        text("50"),
        key(Key::Enter),
        text("probe"),
        key(Key::Enter),
        text("tele"),
        key(Key::Tab),
        text("1 2"),
    ] {
        typed.event(event);
    }
    typed.run();
    press(&mut typed, Key::Enter);
    assert_eq!(
        typed.state().entered,
        ["set time 450", "probe", "teleport 1 2"]
    );
}

#[test]
fn a_line_is_typed_finished_entered_and_answered() {
    let mut harness = typed(vec2(1280.0, 720.0));
    harness.run();
    harness.get_by_label("Command");
    write(&mut harness, "tele");
    press(&mut harness, Key::Tab);
    assert!(said(&harness).contains("A   B"));
    write(&mut harness, "1 2 3");
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().entered, ["teleport 1 2 3"]);
    harness
        .state_mut()
        .console
        .say("Done\nwell", LineKind::Answer);
    harness.run();
    let all = said(&harness);
    assert!(
        all.contains("> teleport 1 2 3") && all.contains("Done\n"),
        "{all}"
    );
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().entered.len(), 1, "an empty line is none");
}

#[test]
fn the_arrows_go_through_what_was_entered_and_back_to_what_was_being_typed() {
    let mut harness = typed(vec2(1280.0, 720.0));
    let earlier = ["one", "two"].map(str::to_owned);
    harness.state_mut().console.remember(earlier);
    harness.run();
    write(&mut harness, "thr");
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::ArrowDown);
    write(&mut harness, "ee");
    press(&mut harness, Key::Enter);
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::ArrowUp);
    write(&mut harness, "!");
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().entered, ["three", "two!"]);
    assert_eq!(
        harness.state().console.history(),
        ["one", "two", "three", "two!"]
    );
}

#[test]
fn much_that_is_said_scrolls_and_the_last_is_in_view_at_every_size() {
    for size in [vec2(1280.0, 720.0), vec2(640.0, 360.0), vec2(320.0, 200.0)] {
        let mut harness = typed(size);
        for line in 0..600 {
            let words = format!(
                "line {line} with words that are far too many for one row of a narrow window"
            );
            harness.state_mut().console.say(&words, LineKind::Problem);
        }
        harness.run_steps(4);
        let texts = painted(harness.output());
        let last = texts
            .iter()
            .find(|text| text.text.starts_with("line 599"))
            .unwrap();
        assert!(
            last.rect.max.y <= last.clip.max.y + 1.0,
            "{size}: {:?}",
            last.rect
        );
        for text in &texts {
            assert!(text.rect.max.x <= size.x + 1.0, "{size}: {}", text.text);
        }
        assert!(
            !texts.iter().any(|text| text.text.starts_with("line 1 ")),
            "all are kept"
        );
    }
}

#[test]
fn it_speaks_every_language() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        for key in [
            "console-entry",
            "console-hint",
            "cheats-used",
            "action-console",
        ] {
            assert!(texts.has_own(key), "{key} in {}", language.id());
        }
    }
}
