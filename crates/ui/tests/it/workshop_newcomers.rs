//! What newcomers meet in the workshop: its words in every language, the lesson, the page of examples, and all of it by keys.

use antipode_language::{Language, Texts};
use antipode_ui::workshop::{
    Amount, ChooserEntry, ChooserModel, ChooserWish, ExampleRow, FieldKind, LessonChoice,
    LessonModel, LessonTarget, Unit, WorkshopWish,
};
use egui::{Event, Key, Modifiers, PointerButton, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use crate::common::painted;
use crate::workshop::{Bench, asked, bench, button, field, harness, wide};

/// What the panes show where there is most to show, in that language.
fn full(language: Language, size: Vec2) -> Harness<'static, Bench> {
    let mut bench = bench(language, size.x);
    let texts = Texts::new(language);
    let amount = |value: f64| Amount {
        value: Some(value),
        range: (-1000.0, 1000.0),
    };
    let numbers = |unit| FieldKind::Numbers([-10.25, 2.125, -3.25].map(amount).to_vec(), unit);
    let say = |word: &str| texts.say(&format!("workshop-field-{word}"));
    let option = |word: &str| {
        (
            word.to_owned(),
            texts.say(&format!("workshop-choice-{word}")),
        )
    };
    let options = ["sides-walls", "sides-soft", "sides-snell", "sides-legacy"].map(option);
    bench.fields = vec![
        field("at", &say("at"), numbers(Unit::Metres)),
        field("turn", &say("turn"), numbers(Unit::Degrees)),
        field(
            "times-all",
            &say("times-all"),
            FieldKind::Stretch(Some(5.0)),
        ),
        field(
            "sides",
            &say("sides"),
            FieldKind::Choice(options.to_vec(), Some(3)),
        ),
        field("outline", &say("outline"), FieldKind::Switch(Some(false))),
    ];
    bench.lesson = Some(LessonModel {
        number: 4,
        of: 5,
        text: texts.say("workshop-lesson-stretch"),
        target: LessonTarget::Field("times-all".to_owned()),
    });
    bench.examples = [
        "tunnel-longer",
        "tunnel-shorter",
        "house",
        "portals",
        "portals-of-size",
        "falling-loop",
    ]
    .map(|id| ExampleRow {
        id: id.to_owned(),
        label: texts.say(&format!("workshop-example-{id}")),
        about: texts.say(&format!("workshop-example-{id}-about")),
        picture: None,
    })
    .to_vec();
    let mut harness = harness(bench, size);
    harness.run();
    harness
}

/// What of the words on the screen is cut off or ended by an ellipsis, but for names of things, which may be as long as their
/// makers like, and for what can be scrolled to.
fn cut(harness: &Harness<'_, Bench>, size: Vec2) -> Vec<String> {
    let texts = painted(harness.output()).into_iter();
    let is_cut = |it: &crate::common::Painted| {
        let seen = it.rect.intersect(it.clip);
        let is_seen = seen.is_positive() && seen.height() > 4.0;
        let beside =
            it.rect.min.x < it.clip.min.x - 1.0 || it.rect.max.x > it.clip.max.x.min(size.x) + 1.0;
        is_seen && (it.elided || beside)
    };
    texts.filter(is_cut).map(|it| it.text).collect()
}

#[test]
fn no_words_are_cut_in_any_language_at_any_size() {
    for language in Language::ALL {
        for size in [
            vec2(800.0, 600.0),
            vec2(1280.0, 720.0),
            vec2(1920.0, 1080.0),
        ] {
            let id = language.id();
            let mut harness = full(language, size);
            assert_eq!(cut(&harness, size), Vec::<String>::new(), "{id} {size}");
            let texts = Texts::new(language);
            for menu in ["edit", "view", "help"] {
                let label = texts.say(&format!("workshop-menu-{menu}"));
                // A pane may be called as a menu is; the bar comes first.
                let found = harness.query_all_by_label(&label).next();
                found.unwrap().click();
                harness.run();
                assert_eq!(
                    cut(&harness, size),
                    Vec::<String>::new(),
                    "{id} {size} {menu}"
                );
                harness.key_press(Key::Escape);
                harness.run();
            }
            let help = texts.say("workshop-menu-help");
            harness.get_by_label(&help).click();
            harness.run();
            harness
                .get_by_label(&texts.say("workshop-do-examples"))
                .click();
            harness.run();
            assert_eq!(
                cut(&harness, size),
                Vec::<String>::new(),
                "{id} {size} page"
            );
            let close = harness
                .get_by_label(&texts.say("workshop-examples-close"))
                .rect();
            assert!(close.max.y < size.y, "{id} {size}: {close}");
            harness.key_press(Key::Escape);
            harness.run();
            harness.state_mut().chooser = Some(folder(&texts));
            harness.run();
            let found = cut(&harness, size);
            assert_eq!(found, Vec::<String>::new(), "{id} {size} files");
            let close = texts.say("workshop-chooser-close");
            let close = harness.get_by_label(&close).rect();
            assert!(close.max.y < size.y, "{id} {size}: {close}");
        }
    }
}

#[test]
fn the_lesson_points_to_its_pane_and_can_be_skipped_and_ended() {
    let size = vec2(800.0, 600.0);
    let mut harness = full(Language::English, size);
    // In a narrow window parts lie behind the list.
    assert!(harness.query_by_label("Box").is_none());
    harness.state_mut().lesson.as_mut().unwrap().target = LessonTarget::Part("box".to_owned());
    harness.run();
    harness.get_by_label("Box");
    asked(&mut harness);
    harness.get_by_label("Skip this step").click();
    harness.run();
    assert_eq!(asked(&mut harness), [WorkshopWish::SkipStep]);
    harness.get_by_label("End the lesson").click();
    harness.run();
    assert_eq!(asked(&mut harness), [WorkshopWish::EndLesson]);
    harness.get_by_label("Help").click();
    harness.run();
    harness.get_by_label("Take the lesson").click();
    harness.run();
    assert_eq!(
        asked(&mut harness),
        [WorkshopWish::BeginLesson(LessonChoice::House)]
    );
}

#[test]
fn an_example_is_copied_into_the_room_by_a_click_and_the_page_goes() {
    let mut harness = full(Language::English, vec2(1280.0, 720.0));
    harness.get_by_label("Help").click();
    harness.run();
    harness.get_by_label("What is possible").click();
    harness.run();
    // Keys of the panes beneath do nothing meanwhile.
    asked(&mut harness);
    harness.key_press(Key::Delete);
    harness.run();
    assert_eq!(asked(&mut harness), []);
    harness
        .get_by_label("Copy “A fall without end” into the room")
        .click();
    harness.run();
    let put = WorkshopWish::Put("falling-loop".to_owned());
    assert_eq!(asked(&mut harness), [put]);
    harness.run();
    assert!(harness.query_by_label("Close").is_none());
}

#[test]
fn what_is_held_counts_at_the_moment_of_a_click_and_a_key_after_it_is_done_after_it() {
    let mut harness = wide();
    let at = harness.get_by_label("wall box").rect().center();
    harness.event(Event::PointerMoved(at));
    harness.run_steps(1);
    // All of it comes in one slow frame, at the end of which Ctrl is down.
    harness.event(button(at, true, PointerButton::Primary));
    harness.event(button(at, false, PointerButton::Primary));
    harness.event(Event::Copy);
    harness.event(Event::ModifiersChanged(Modifiers::COMMAND));
    harness.run_steps(1);
    let chosen = WorkshopWish::Choose {
        name: "wall".to_owned(),
        adds: false,
    };
    assert_eq!(asked(&mut harness), [chosen, WorkshopWish::Copy]);
}

#[test]
fn all_panes_are_walked_through_by_tab() {
    use egui_kittest::kittest::NodeT as _;
    let mut harness = wide();
    let mut found: Vec<String> = Vec::new();
    for _ in 0..80 {
        harness.key_press(Key::Tab);
        harness.run();
        let nodes = harness.root().children_recursive();
        let focused = nodes
            .map(|node| node.accesskit_node())
            .find(|node| node.is_focused() && node.role() != egui::Role::Window);
        let label = focused.and_then(|node| node.label()).unwrap_or_default();
        found.push(label);
    }
    for wanted in [
        "Play",
        "Undo",
        "Edit",
        "View",
        "Help",
        "Search",
        "wall box",
        "Box",
        "History",
        "Place x",
        "Stretch",
        "One begins in the air.",
        "Hide “floor”",
    ] {
        assert!(found.iter().any(|it| it == wanted), "{wanted}: {found:?}");
    }
}

/// A folder to choose a file from, with all that may be said of it.
fn folder(texts: &Texts) -> ChooserModel {
    let entry = |name: &str, is_folder| ChooserEntry {
        name: name.to_owned(),
        is_folder,
        about: texts.say("workshop-chooser-folder"),
    };
    let path = "/home/somebody/pictures";
    let values = [
        ("path", path.into()),
        ("reason", "Permission denied (os error 13)".into()),
    ];
    ChooserModel {
        folder: path.to_owned(),
        entries: vec![entry("zoo", true), entry("a.png", false)],
        problem: Some(texts.say_with("workshop-chooser-unread", &values)),
        is_reading: false,
    }
}

#[test]
fn a_file_is_chosen_by_keys_alone_and_what_they_else_do_waits() {
    let mut harness = wide();
    let texts = Texts::new(Language::English);
    harness.get_by_label("Model or picture from a file").click();
    harness.run();
    assert_eq!(asked(&mut harness), [WorkshopWish::ChooseFile]);
    harness.state_mut().chooser = Some(folder(&texts));
    harness.run();
    harness.key_press(Key::Delete);
    harness.key_press(Key::Enter);
    harness.run();
    let wish = |wish| [WorkshopWish::Chooser(wish)];
    let zoo = ChooserWish::Open("zoo".to_owned());
    assert_eq!(asked(&mut harness), wish(zoo));
    harness.key_press(Key::ArrowDown);
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    let picture = ChooserWish::Open("a.png".to_owned());
    assert_eq!(asked(&mut harness), wish(picture));
    harness.get_by_label("Path").focus();
    harness.run();
    harness.event(Event::Text("/x".to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    let [WorkshopWish::Chooser(ChooserWish::Go(typed))] = &asked(&mut harness)[..] else {
        panic!("it does not go there")
    };
    assert!(typed.contains("/x"), "{typed}");
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(asked(&mut harness), wish(ChooserWish::Close));
}

#[test]
fn parts_stand_side_by_side_with_their_words_below_and_are_put_in_by_a_key() {
    let mut harness = wide();
    let card = harness.get_by_label("Box").rect();
    assert!(card.height() > 80.0, "there is room for a picture: {card}");
    harness.get_by_label("Box").focus();
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(asked(&mut harness), [WorkshopWish::Put("box".to_owned())]);
}
