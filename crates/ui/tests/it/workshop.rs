//! The panes of the workshop: clicked, typed in, dragged, and read in every language and size.

use antipode_language::{Language, Texts};
use antipode_ui::apply_theme;
use antipode_ui::workshop::{
    Amount, BarModel, ChooserModel, ExampleRow, FieldKind, FieldRow, HistoryRow, LessonModel,
    LessonTarget, MessageRow, ObjectRow, PartRow, ToolChoice, Unit, ViewEvent, WorkshopModel,
    WorkshopPanes, WorkshopWish,
};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use crate::common::painted;

pub struct Bench {
    pub texts: Texts,
    pub panes: WorkshopPanes,
    pub objects: Vec<ObjectRow>,
    pub fields: Vec<FieldRow>,
    pub bar: BarModel,
    pub lesson: Option<LessonModel>,
    pub examples: Vec<ExampleRow>,
    pub chooser: Option<ChooserModel>,
    pub wishes: Vec<WorkshopWish>,
}

fn object(name: &str, depth: usize, is_group: bool) -> ObjectRow {
    ObjectRow {
        name: name.to_owned(),
        kind: if is_group { "group" } else { "box" }.to_owned(),
        depth,
        is_group,
        ..ObjectRow::default()
    }
}

pub fn field(key: &str, label: &str, kind: FieldKind) -> FieldRow {
    FieldRow {
        key: key.to_owned(),
        label: label.to_owned(),
        about: String::new(),
        kind,
        is_default: false,
    }
}

fn fields() -> Vec<FieldRow> {
    let amount = |value: f64| Amount {
        value: Some(value),
        range: (-1000.0, 1000.0),
    };
    let place = [1.5, 2.0, -3.25].map(amount).to_vec();
    vec![
        field("at", "Place", FieldKind::Numbers(place, Unit::Metres)),
        field("times", "Stretch", FieldKind::Stretch(Some(5.0))),
        field("outline", "Edges are seen", FieldKind::Switch(Some(false))),
        field(
            "told",
            "",
            FieldKind::Words("It is 79 m long.".to_owned(), false),
        ),
    ]
}

pub fn bench(language: Language, width: f32) -> Bench {
    Bench {
        texts: Texts::new(language),
        panes: WorkshopPanes::new("", width),
        objects: vec![
            object("floor", 0, false),
            object("house", 0, true),
            object("wall", 1, false),
        ],
        fields: fields(),
        bar: BarModel {
            can_undo: true,
            has_chosen: true,
            snaps: true,
            grid_m: 0.25,
            ..BarModel::default()
        },
        lesson: None,
        examples: Vec::new(),
        chooser: None,
        wishes: Vec::new(),
    }
}

fn show(context: &egui::Context, bench: &mut Bench) {
    let texts = &bench.texts;
    let part = PartRow {
        id: "box".to_owned(),
        label: texts.say("workshop-part-box"),
        about: texts.say("workshop-about-box"),
        picture: None,
    };
    let model = WorkshopModel {
        texts,
        room: "My room",
        older: None,
        objects: &bench.objects,
        chosen: "wall (box)",
        fields: &bench.fields,
        parts: &[part],
        messages: &[MessageRow {
            text: "One begins in the air.".to_owned(),
            is_grave: false,
        }],
        history: &[HistoryRow {
            text: "Add “wall”".to_owned(),
        }],
        done: 1,
        bar: bench.bar,
        lines: &[],
        status: "",
        lesson: bench.lesson.as_ref(),
        examples: &bench.examples,
        chooser: bench.chooser.as_ref(),
    };
    let wishes = bench.panes.show(context, &model);
    bench.wishes.extend(wishes);
}

pub fn harness(bench: Bench, size: Vec2) -> Harness<'static, Bench> {
    Harness::builder()
        .with_size(size)
        .with_max_steps(8)
        .allow_missing_glyphs()
        .with_context_setup(apply_theme)
        .build_ui_state(|ui, bench: &mut Bench| show(ui.ctx(), bench), bench)
}

pub fn wide() -> Harness<'static, Bench> {
    let mut harness = harness(bench(Language::English, 1280.0), vec2(1280.0, 720.0));
    harness.run();
    harness.state_mut().wishes.clear();
    harness
}

/// What was asked for since, but for where the pointer is.
pub fn asked(harness: &mut Harness<'_, Bench>) -> Vec<WorkshopWish> {
    let mut wishes = std::mem::take(&mut harness.state_mut().wishes);
    wishes.retain(|it| !matches!(it, WorkshopWish::View(ViewEvent::Hover(_))));
    wishes
}

pub fn button(at: Pos2, pressed: bool, button: PointerButton) -> Event {
    Event::PointerButton {
        pos: at,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

pub fn drag(harness: &mut Harness<'_, Bench>, from: Pos2, way: Vec2, with: PointerButton) {
    harness.event(Event::PointerMoved(from));
    harness.run_steps(1);
    harness.event(button(from, true, with));
    harness.run_steps(1);
    for share in [0.5, 1.0] {
        harness.event(Event::PointerMoved(from + way * share));
        harness.run_steps(1);
    }
    harness.event(button(from + way, false, with));
    harness.run_steps(1);
}

#[test]
fn things_are_chosen_hidden_locked_and_found_in_the_list() {
    let mut harness = wide();
    harness.get_by_label("wall box").click();
    harness.run();
    let chosen = |name: &str| WorkshopWish::Choose {
        name: name.to_owned(),
        adds: false,
    };
    assert_eq!(asked(&mut harness), [chosen("wall")]);
    harness.get_by_label("Hide “floor”").click();
    harness.get_by_label("Lock “house”").click();
    harness.run();
    assert_eq!(
        asked(&mut harness),
        [
            WorkshopWish::Hide("floor".to_owned(), true),
            WorkshopWish::Lock("house".to_owned(), true),
        ]
    );
    harness.get_by_label("Search").click();
    harness.run();
    harness.event(Event::Text("hou".to_owned()));
    harness.run();
    assert!(harness.query_by_label("wall box").is_none());
    harness.get_by_label("house group");
}

#[test]
fn a_group_is_folded_and_unfolds_for_what_the_lesson_points_to_in_it() {
    let mut harness = wide();
    let is_listed =
        |harness: &Harness<'_, Bench>| harness.query_by_label_contains("wall").is_some();
    // The step of the history and what is chosen name it, too.
    let named = |harness: &Harness<'_, Bench>| harness.query_all_by_label_contains("wall").count();
    let before = named(&harness);
    harness.get_by_label("Fold “house”").click();
    harness.run();
    assert!(named(&harness) < before && is_listed(&harness));
    // Search looks into it.
    harness.get_by_label("Search").click();
    harness.run();
    harness.event(Event::Text("wall".to_owned()));
    harness.run();
    assert_eq!(named(&harness), before);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.key_press(Key::Backspace);
    harness.run();
    assert!(named(&harness) < before);
    harness.state_mut().lesson = Some(LessonModel {
        number: 3,
        of: 5,
        text: "Choose it.".to_owned(),
        target: LessonTarget::Object("wall".to_owned()),
    });
    harness.run();
    assert_eq!(named(&harness), before);
}

#[test]
fn the_room_is_saved_and_left_by_its_menu() {
    let mut harness = wide();
    for (line, wish) in [
        ("Save now", WorkshopWish::Keep),
        ("Leave the room", WorkshopWish::Leave),
    ] {
        harness.get_by_label("Room").click();
        harness.run();
        harness.get_by_label_contains(line).click();
        harness.run();
        assert_eq!(asked(&mut harness), [wish]);
    }
}

#[test]
fn a_click_in_the_view_a_drag_and_a_look_around_are_told_apart() {
    let mut harness = wide();
    let middle = harness.state().panes.view_rect().center();
    drag(&mut harness, middle, Vec2::ZERO, PointerButton::Primary);
    let told = asked(&mut harness);
    assert!(
        matches!(
            told[..],
            [
                WorkshopWish::View(ViewEvent::Grab([x, y])),
                WorkshopWish::View(ViewEvent::Let { is_click: true, .. })
            ] if x.abs() < 1e-6 && y.abs() < 1e-6
        ),
        "{told:?}"
    );
    drag(
        &mut harness,
        middle,
        vec2(60.0, 30.0),
        PointerButton::Primary,
    );
    let told = asked(&mut harness);
    let half = harness.state().panes.view_rect().size() / 2.0;
    let last_pull = told.iter().rev().find_map(|it| match it {
        WorkshopWish::View(ViewEvent::Pull { at, free: false }) => Some(*at),
        _ => None,
    });
    let [x, y] = last_pull.unwrap();
    assert!((x - f64::from(60.0 / half.x)).abs() < 1e-6, "{told:?}");
    assert!((y + f64::from(30.0 / half.y)).abs() < 1e-6, "{told:?}");
    drag(
        &mut harness,
        middle,
        vec2(40.0, -10.0),
        PointerButton::Secondary,
    );
    let turned: f64 = asked(&mut harness)
        .iter()
        .map(|it| match it {
            WorkshopWish::View(ViewEvent::Look([x, _])) => *x,
            other => panic!("{other:?}"),
        })
        .sum();
    assert_eq!(turned, 40.0);
}

#[test]
fn every_command_has_a_key_and_keys_do_nothing_while_one_types() {
    let mut harness = wide();
    for (key, wish) in [
        (Key::Num2, WorkshopWish::Tool(ToolChoice::Turn)),
        (Key::F, WorkshopWish::Focus),
        (Key::N, WorkshopWish::Snaps(false)),
        (Key::Delete, WorkshopWish::Delete),
    ] {
        harness.key_press(key);
        harness.run();
        assert_eq!(asked(&mut harness), [wish]);
    }
    let ctrl = Modifiers::COMMAND;
    for (held, key, wish) in [
        (ctrl, Key::Z, WorkshopWish::Undo),
        (ctrl | Modifiers::SHIFT, Key::Z, WorkshopWish::Redo),
        (ctrl, Key::D, WorkshopWish::Duplicate),
        (ctrl, Key::G, WorkshopWish::Group),
        (ctrl | Modifiers::SHIFT, Key::G, WorkshopWish::Ungroup),
    ] {
        harness.key_press_modifiers(held, key);
        harness.run();
        assert_eq!(asked(&mut harness), [wish]);
    }
    harness.get_by_label("Search").click();
    harness.run();
    harness.key_press(Key::F);
    harness.run();
    assert_eq!(asked(&mut harness), []);
}

#[test]
fn the_view_has_the_keyboard_at_first_and_arrows_move_by_steps() {
    let mut harness = wide();
    for (key, way) in [
        (Key::ArrowLeft, [-1, 0, 0]),
        (Key::ArrowUp, [0, 0, -1]),
        (Key::PageUp, [0, 1, 0]),
    ] {
        harness.key_press(key);
        harness.run();
        assert_eq!(asked(&mut harness), [WorkshopWish::Nudge(way)]);
    }
}

#[test]
fn what_is_chosen_in_the_view_comes_into_view_in_the_list() {
    let mut harness = wide();
    let name = |it: usize| format!("thing {it}");
    harness.state_mut().objects = (0..90).map(|it| object(&name(it), 0, false)).collect();
    harness.run();
    let is_listed = |harness: &Harness<'_, Bench>, it: usize| {
        harness
            .query_by_label_contains(&format!("thing {it} "))
            .is_some()
            || harness.query_by_label_contains(&name(it)).is_some()
    };
    assert!(!is_listed(&harness, 77));
    harness.state_mut().objects[77].selected = true;
    harness.run();
    assert!(is_listed(&harness, 77));
}

#[test]
fn panes_lie_as_they_were_left() {
    let lies = "row(0.300 tabs(view* list inspector parts messages) 0.700 tabs(history*))";
    let mut kept = bench(Language::English, 1280.0);
    kept.panes = WorkshopPanes::new(lies, 1280.0);
    let mut harness = harness(kept, vec2(1280.0, 720.0));
    harness.run();
    assert_eq!(harness.state().panes.layout(), lies);
    let view = harness.state().panes.view_rect();
    assert!((view.width() - 0.3 * 1280.0).abs() < 8.0, "{view}");
}

/// A tab that is brought back to the front stays there.
#[test]
fn panes_that_are_put_back_as_they_were_are_kept_so() {
    let first = "row(0.500 view* 0.500 tabs(parts* history))".replace("view*", "tabs(view*)");
    let mut kept = bench(Language::English, 1280.0);
    kept.panes = WorkshopPanes::new(&first, 1280.0);
    let mut harness = harness(kept, vec2(1280.0, 720.0));
    harness.run();
    let begun = harness.state().panes.layout();
    assert_eq!(harness.state().panes.changed_layout(), None);
    for tab in ["History", "Parts"] {
        harness.get_by_label(tab).click();
        harness.run();
        let told = harness.state().panes.changed_layout();
        assert_eq!(told, Some(harness.state().panes.layout()), "{tab}");
    }
    assert_eq!(harness.state().panes.changed_layout(), Some(begun));
}

#[test]
fn it_fits_every_language_and_size_and_leaves_the_view_most_of_the_room() {
    for language in Language::ALL {
        for size in [
            vec2(800.0, 600.0),
            vec2(1280.0, 720.0),
            vec2(2560.0, 1440.0),
        ] {
            let mut harness = harness(bench(language, size.x), size);
            harness.run();
            let view = harness.state().panes.view_rect();
            let share = view.area() / (size.x * size.y);
            assert!(share > 0.35, "{}: {size}: {share}", language.id());
            for text in painted(harness.output()) {
                let seen = text.rect.intersect(text.clip);
                let is_out = seen.is_positive() && seen.max.x > size.x + 0.5;
                assert!(!is_out, "{}: {size}: {}", language.id(), text.text);
            }
        }
    }
    let _ = pos2(0.0, 0.0);
}
