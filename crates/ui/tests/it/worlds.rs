//! One world's page, what is asked before one is deleted, and worlds from files: by pointer and by keys.

use crate::common::{Game, click, focused, intents, painted, press, type_text, window, world};
use antipode_language::{Language, Texts};
use antipode_ui::{ArchiveRow, FolderRow, Intent, Screen, WorldsIntent};
use egui::{Key, Modifiers, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn with_worlds(count: usize) -> Game {
    let mut game = Game::new();
    game.worlds = (0..count).map(world).collect();
    game.shell.open(Screen::Load);
    game
}

/// The page of world 1, by a click.
fn page() -> Harness<'static, Game> {
    let mut harness = window(with_worlds(3));
    click(&mut harness, "Manage “World 1”");
    let slug = "world-1".to_owned();
    assert_eq!(
        intents(&mut harness),
        [Intent::Worlds(WorldsIntent::LookAt { slug })]
    );
    harness
}

fn says(harness: &Harness<'_, Game>, words: &str) -> bool {
    painted(harness.output())
        .iter()
        .any(|text| text.text.contains(words))
}

fn replace_text(harness: &mut Harness<'_, Game>, text: &str) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    type_text(harness, text);
}

#[test]
fn a_worlds_page_is_reached_by_keys_and_left_by_escape() {
    let mut harness = window(with_worlds(3));
    assert_eq!(focused(&harness), "Load “World 0”");
    press(&mut harness, Key::ArrowRight);
    assert_eq!(focused(&harness), "Manage “World 0”");
    press(&mut harness, Key::ArrowDown);
    assert_eq!(focused(&harness), "Manage “World 1”");
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness).len(), 1);
    for words in [
        "World 1",
        "Spherical  ·  Gathering  ·  played 12 min",
        "/home/me/saves/world-1",
    ] {
        assert!(says(&harness, words), "{words}");
    }
    // The column beside it has a Load and a Delete of its own, so they are reached by keys here.
    assert_eq!(focused(&harness), "Load");
    let mut passed = vec![focused(&harness)];
    for _ in 0..5 {
        press(&mut harness, Key::Tab);
        passed.push(focused(&harness));
    }
    assert_eq!(
        passed,
        [
            "Load",
            "Rename",
            "Duplicate",
            "Export",
            "Open folder",
            "Delete"
        ]
    );
    harness.state_mut().shell.escape(false);
    harness.run();
    harness.get_by_label("Manage “World 1”");
    assert_eq!(harness.state().shell.screen(), &Screen::Load);
    harness.state_mut().shell.escape(false);
    assert_eq!(harness.state().shell.screen(), &Screen::Main);
}

#[test]
fn enter_on_a_worlds_page_loads_it() {
    let mut harness = page();
    harness.state_mut().shell.escape(false);
    harness.run();
    click(&mut harness, "Manage “World 2”");
    intents(&mut harness);
    press(&mut harness, Key::Enter);
    let slug = "world-2".to_owned();
    assert_eq!(intents(&mut harness), [Intent::Load { slug }]);
}

#[test]
fn a_name_is_checked_while_it_is_typed_and_enter_takes_it() {
    let mut harness = page();
    click(&mut harness, "Rename");
    assert_eq!(focused(&harness), "New name");
    replace_text(&mut harness, "taken");
    assert!(says(&harness, "There is a world of that name already."));
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), []);
    harness.get_by_label("New name").focus();
    harness.run();
    replace_text(&mut harness, "  Other ");
    assert!(says(&harness, "This name can be used."));
    press(&mut harness, Key::Enter);
    let renamed = WorldsIntent::Rename {
        slug: "world-1".to_owned(),
        name: "Other".to_owned(),
    };
    assert_eq!(intents(&mut harness), [Intent::Worlds(renamed)]);
    harness.get_by_label("Duplicate");
}

#[test]
fn the_name_it_has_changes_nothing() {
    let mut harness = page();
    click(&mut harness, "Rename");
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), []);
    harness.get_by_label("Duplicate");
    click(&mut harness, "Rename");
    harness.state_mut().shell.escape(false);
    harness.run();
    harness.get_by_label("Duplicate");
}

#[test]
fn a_world_is_doubled_exported_and_its_folder_opened() {
    let mut harness = page();
    let slug = || "world-1".to_owned();
    click(&mut harness, "Duplicate");
    click(&mut harness, "Open folder");
    click(&mut harness, "Export");
    assert!(says(&harness, "/home/me/world-1.antipode-world"));
    press(&mut harness, Key::Enter);
    let export = WorldsIntent::Export {
        slug: slug(),
        file: "/home/me/world-1.antipode-world".to_owned(),
    };
    let asked = [
        WorldsIntent::Duplicate { slug: slug() },
        WorldsIntent::OpenFolder { slug: slug() },
        looks_in("/home/me"),
        export,
    ];
    assert_eq!(intents(&mut harness), asked.map(Intent::Worlds));
    click(&mut harness, "Export");
    click(&mut harness, "Cancel");
    harness.get_by_label("Open folder");
    assert_eq!(
        intents(&mut harness),
        [Intent::Worlds(looks_in("/home/me"))]
    );
}

fn looks_in(folder: &str) -> WorldsIntent {
    WorldsIntent::FindIn {
        folder: folder.to_owned(),
    }
}

#[test]
fn the_folder_of_an_export_is_chosen_by_a_click_and_what_cannot_be_read_is_said() {
    let mut harness = page();
    harness.state_mut().files.folders = vec![FolderRow {
        path: "/home/me/stick".to_owned(),
        name: Some("stick".to_owned()),
    }];
    click(&mut harness, "Export");
    click(&mut harness, "stick (folder)");
    assert_eq!(
        intents(&mut harness),
        ["/home/me", "/home/me/stick"].map(|it| Intent::Worlds(looks_in(it)))
    );
    let problem = "/home/me/stick cannot be read.";
    harness.state_mut().files.problem = Some(problem.to_owned());
    harness.run();
    assert!(says(&harness, problem));
    harness.get_by_label("File").focus();
    harness.run();
    press(&mut harness, Key::Enter);
    let export = WorldsIntent::Export {
        slug: "world-1".to_owned(),
        file: "/home/me/stick/world-1.antipode-world".to_owned(),
    };
    assert_eq!(intents(&mut harness), [Intent::Worlds(export)]);
}

#[test]
fn the_question_shows_everything_that_would_be_gone() {
    let mut harness = window(with_worlds(2));
    harness.state_mut().shell.open(Screen::Delete);
    harness.run();
    click(&mut harness, "Delete “World 1”");
    let slug = "world-1".to_owned();
    assert_eq!(
        intents(&mut harness),
        [Intent::Worlds(WorldsIntent::LookAt { slug: slug.clone() })]
    );
    assert!(says(&harness, "counting the changed chunks"));
    harness.state_mut().worlds[1].edits = Some(34);
    harness.run();
    for words in [
        "Delete “World 1”?",
        "Spherical",
        "played 12 min",
        "1.2 MB",
        "34 changed chunks",
        "/home/me/saves/world-1",
        "cannot be undone",
    ] {
        assert!(says(&harness, words), "{words}");
    }
    assert_eq!(focused(&harness), "Keep");
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), []);
    click(&mut harness, "Delete “World 1”");
    intents(&mut harness);
    click(&mut harness, "Delete");
    assert_eq!(intents(&mut harness), [Intent::Delete { slug }]);
}

#[test]
fn a_world_is_deleted_from_its_page_by_keys_alone() {
    let mut harness = page();
    for _ in 0..5 {
        press(&mut harness, Key::Tab);
    }
    assert_eq!(focused(&harness), "Delete");
    press(&mut harness, Key::Enter);
    assert_eq!(focused(&harness), "Keep");
    press(&mut harness, Key::ArrowLeft);
    assert_eq!(focused(&harness), "Delete");
    press(&mut harness, Key::Enter);
    let slug = "world-1".to_owned();
    assert_eq!(intents(&mut harness), [Intent::Delete { slug }]);
    harness.get_by_label("Manage “World 1”");
}

#[test]
fn a_running_world_is_not_changed() {
    let mut game = with_worlds(2);
    game.worlds[1].running = true;
    game.running = Some("World 1".to_owned());
    let mut harness = window(game);
    click(&mut harness, "Manage “World 1”");
    intents(&mut harness);
    assert!(says(&harness, "Save and quit to the menu first"));
    for label in ["Rename", "Duplicate", "Export"] {
        click(&mut harness, label);
    }
    assert_eq!(intents(&mut harness), []);
    harness.get_by_label("Open folder");
    click(&mut harness, "Open folder");
    assert_eq!(intents(&mut harness).len(), 1);
}

#[test]
fn a_world_that_vanishes_takes_its_page_along() {
    let mut harness = page();
    harness.state_mut().worlds.remove(1);
    harness.run();
    harness.get_by_label("Manage “World 0”");
    click(&mut harness, "Manage “World 2”");
    let rename = harness.get_by_label("Rename");
    rename.click();
    harness.run();
    harness.state_mut().worlds.clear();
    harness.run();
    assert!(says(&harness, "There are no worlds yet"));
}

#[test]
fn a_world_is_imported_from_what_was_found_from_what_was_typed_and_from_what_was_dropped() {
    let mut game = with_worlds(1);
    game.files.dir = "/home/me/Documents".to_owned();
    let mut harness = window(game);
    let import = |file: &str| {
        let file = file.to_owned();
        Intent::Worlds(WorldsIntent::Import { file })
    };
    click(&mut harness, "Import");
    assert_eq!(
        intents(&mut harness),
        [Intent::Worlds(WorldsIntent::FindArchives)]
    );
    assert!(says(
        &harness,
        "There are no exported worlds in /home/me/Documents."
    ));
    harness.state_mut().files.archives = vec![ArchiveRow {
        file: "/home/me/Documents/foo.antipode-world".to_owned(),
        name: "foo.antipode-world".to_owned(),
        size: "0.3 MB".to_owned(),
    }];
    harness.run();
    assert_eq!(focused(&harness), "File");
    press(&mut harness, Key::ArrowDown);
    assert_eq!(focused(&harness), "foo.antipode-world (0.3 MB)");
    press(&mut harness, Key::Enter);
    assert_eq!(
        intents(&mut harness),
        [import("/home/me/Documents/foo.antipode-world")]
    );

    click(&mut harness, "Import");
    intents(&mut harness);
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), [], "nothing was typed");
    harness.get_by_label("File").focus();
    harness.run();
    type_text(&mut harness, " ~/bar.antipode-world ");
    press(&mut harness, Key::Enter);
    assert_eq!(intents(&mut harness), [import("~/bar.antipode-world")]);

    click(&mut harness, "Import");
    intents(&mut harness);
    let folder = "/home/me".to_owned();
    harness.state_mut().files.folders = vec![FolderRow {
        path: folder.clone(),
        name: None,
    }];
    harness.run();
    click(&mut harness, "Folder above");
    assert_eq!(
        intents(&mut harness),
        [Intent::Worlds(WorldsIntent::FindIn { folder })]
    );
    harness.state_mut().files.problem = Some("That cannot be read.".to_owned());
    harness.run();
    assert!(says(&harness, "That cannot be read."));
    assert!(!says(&harness, "There are no exported worlds"));
}

#[test]
fn the_pages_fit_every_window_in_any_language() {
    const SIZES: [Vec2; 5] = [
        vec2(320.0, 200.0),
        vec2(427.0, 240.0),
        vec2(640.0, 360.0),
        vec2(1280.0, 720.0),
        vec2(700.0, 1400.0),
    ];
    let steps: [&[&str]; 5] = [
        &["worlds-manage"],
        &["worlds-manage", "worlds-rename"],
        &["worlds-manage", "worlds-export"],
        &["worlds-manage", "worlds-delete"],
        &["worlds-import"],
    ];
    for language in Language::ALL {
        let texts = Texts::new(language);
        for (size, keys) in SIZES
            .into_iter()
            .flat_map(|size| steps.map(|keys| (size, keys)))
        {
            let mut harness = crate::common::harness(long_words(&texts), size);
            harness.run();
            for key in keys {
                let label = texts.say_with(key, &[("name", "World 0".into())]);
                // The column beside the page has a Delete of its own.
                harness.get_all_by_label(&label).last().unwrap().focus();
                harness.run();
                press(&mut harness, Key::Enter);
            }
            assert_whole(&harness, size, &format!("{keys:?} in {language:?}"));
        }
    }
}

fn long_words(texts: &Texts) -> Game {
    let mut game = with_worlds(3);
    game.texts = texts.clone();
    game.worlds[0].problem = Some("Its file ends too early. ".repeat(6));
    game.worlds[0].path = format!("/home/{}/saves/world-0", "x".repeat(150));
    game.files.dir = game.worlds[0].path.clone();
    game
}

fn assert_whole(harness: &Harness<'_, Game>, size: Vec2, place: &str) {
    let window = Rect::from_min_size(Pos2::ZERO, size);
    for text in painted(harness.output()) {
        let seen = text.clip.intersect(window).expand(0.5).x_range();
        let whole = seen.contains(text.rect.min.x) && seen.contains(text.rect.max.x);
        let in_field = text.text.starts_with("/home/me");
        assert!(
            whole || in_field,
            "“{}” is cut off after {place} at {size}",
            text.text
        );
    }
}

/// Whoever goes by keys stays where he is while lines and rows come up and go above him.
#[test]
fn the_focus_stays_where_it_is_while_something_is_done_with_the_saves() {
    let working = || Some("Copying “World 1”".to_owned());
    let mut harness = page();
    press(&mut harness, Key::Tab);
    press(&mut harness, Key::Tab);
    for work in [None, working(), None] {
        harness.state_mut().files.work = work;
        harness.run();
        assert_eq!(focused(&harness), "Duplicate");
    }

    let mut harness = window(with_worlds(3));
    press(&mut harness, Key::ArrowDown);
    for work in [None, working(), None] {
        harness.state_mut().files.work = work;
        harness.run();
        assert_eq!(focused(&harness), "Load “World 1”");
    }
    harness.state_mut().worlds.insert(0, world(7));
    harness.run();
    assert_eq!(focused(&harness), "Load “World 1”");

    let mut harness = window(with_worlds(3));
    click(&mut harness, "Import");
    press(&mut harness, Key::Tab);
    let before = focused(&harness);
    let found = ArchiveRow {
        file: "/home/me/a.antipode".to_owned(),
        name: "a.antipode".to_owned(),
        size: "1 MB".to_owned(),
    };
    harness.state_mut().files.archives.insert(0, found);
    harness.run();
    assert_eq!(focused(&harness), before);
}
