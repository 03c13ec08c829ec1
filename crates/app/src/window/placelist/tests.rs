//! The list with real worlds in a directory of their own.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::fs;
use std::path::PathBuf;

use antipode_geometry::Geometry;
use clap::Parser;
use image::{Rgba, RgbaImage};

use super::*;
use crate::cli::Cli;
use crate::session::{Beginning, NewWorld};

/// A directory with the worlds a, b and c, and the list of them.
fn three() -> (tempfile::TempDir, WorldList) {
    let dir = tempfile::tempdir().unwrap();
    let saves = dir.path().join("saves");
    let path = saves.to_str().unwrap();
    let cli =
        Cli::try_parse_from(["antipode", "--saves-dir", path, "--view-distance", "1"]).unwrap();
    let worlds = Worlds::new(&cli.common);
    for name in ["a", "b", "c"] {
        let made = worlds.create(&NewWorld {
            geometry: Geometry::Euclidean,
            name: Some(name.to_owned()),
            seed: Some(1),
            radius_m: None,
            generator: None,
            mode: if name == "b" {
                antipode_scene::Mode::Gathering
            } else {
                antipode_scene::Mode::Creative
            },
            start: Beginning::Middle,
        });
        let mut session = made.unwrap();
        if name == "a" {
            session.picture = Some(RgbaImage::from_pixel(640, 360, Rgba([200, 10, 10, 255])));
        }
        session.close().unwrap();
    }
    let mut list = WorldList::new(worlds);
    list.locations = list.locations.clone().exporting_to(dir.path());
    list.refresh();
    finish(&mut list);
    (dir, list)
}

fn finish(list: &mut WorldList) {
    while list.task.is_some() || !list.folders.is_empty() || !list.pictures.is_idle() {
        list.poll();
        std::thread::yield_now();
    }
}

fn follow(list: &mut WorldList, intent: WorldsIntent) {
    list.follow(intent);
    finish(list);
}

fn rows(list: &WorldList) -> Vec<WorldRow> {
    list.rows(&Texts::default(), None)
}

fn names(list: &WorldList) -> Vec<String> {
    let mut names: Vec<_> = rows(list).into_iter().map(|row| row.name).collect();
    names.sort();
    names
}

/// What was told last, and whether it tells of a failure.
fn told(list: &mut WorldList) -> Option<(String, bool)> {
    let news = list.take_news(&Texts::default());
    news.map(|(words, kind)| (words, kind == ToastKind::Problem))
}

fn slug(slug: &str) -> String {
    slug.to_owned()
}

#[test]
fn a_world_that_cannot_be_deleted_comes_back_with_the_reason() {
    let (_dir, mut list) = three();
    let held = list.locations.shelf().load("b").unwrap();
    list.delete(slug("b"));
    list.delete(slug("nowhere"));
    list.delete(slug("c"));
    assert_eq!(names(&list), ["a"]);
    finish(&mut list);
    assert_eq!(names(&list), ["a", "b"]);
    for words in ["in use", "nowhere"] {
        let (said, bad) = told(&mut list).unwrap();
        assert!(bad && said.contains(words), "{said}");
    }
    assert_eq!(told(&mut list), None);
    held.close().unwrap();
}

#[test]
fn a_world_is_renamed_and_doubled_and_each_is_told() {
    let (_dir, mut list) = three();
    let rename = WorldsIntent::Rename {
        slug: slug("a"),
        name: "Ähre".to_owned(),
    };
    follow(&mut list, rename);
    follow(&mut list, WorldsIntent::Duplicate { slug: slug("a") });
    assert_eq!(names(&list), ["b", "c", "Ähre", "Ähre 2"]);
    assert_eq!(
        told(&mut list),
        Some(("The world is called “Ähre” now.".to_owned(), false))
    );
    assert_eq!(
        told(&mut list),
        Some(("“Ähre 2” is a copy of the world.".to_owned(), false))
    );
    let taken = WorldsIntent::Rename {
        slug: slug("b"),
        name: "C".to_owned(),
    };
    follow(&mut list, taken);
    assert!(told(&mut list).unwrap().1);
    assert_eq!(names(&list), ["b", "c", "Ähre", "Ähre 2"]);
}

#[test]
fn names_are_checked_against_the_other_worlds() {
    let (_dir, list) = three();
    let texts = Texts::default();
    assert!(list.check_name(&texts, "A").is_err());
    assert_eq!(list.check_rename(&texts, "a", "A"), Ok(()));
    assert!(list.check_rename(&texts, "b", "A").is_err());
    assert!(list.check_rename(&texts, "b", " ").is_err());
}

#[test]
fn an_exported_world_is_found_and_comes_back_under_another_name() {
    let (dir, mut list) = three();
    follow(&mut list, WorldsIntent::LookAt { slug: slug("a") });
    let row = rows(&list).into_iter().find(|row| row.slug == "a").unwrap();
    assert_eq!(row.edits, Some(0));
    assert_eq!(PathBuf::from(&row.path), dir.path().join("saves/a"));
    let file = row.export_to.clone();
    assert_eq!(PathBuf::from(&file), dir.path().join("a.antipode-world"));
    follow(
        &mut list,
        WorldsIntent::Export {
            slug: slug("a"),
            file: file.clone(),
        },
    );
    assert_eq!(
        told(&mut list),
        Some((format!("The world was exported to {file}."), false))
    );
    follow(
        &mut list,
        WorldsIntent::Export {
            slug: slug("b"),
            file,
        },
    );
    let (said, bad) = told(&mut list).unwrap();
    assert!(bad && said.contains("a.antipode-world"), "{said}");

    follow(&mut list, WorldsIntent::FindArchives);
    let files = list.files(&Texts::default());
    assert_eq!(files.archives.len(), 1);
    assert_eq!(files.archives[0].name, "a.antipode-world");
    let file = files.archives[0].file.clone();
    follow(&mut list, WorldsIntent::Import { file });
    assert_eq!(
        told(&mut list),
        Some(("“a 2” was imported.".to_owned(), false))
    );
    assert_eq!(names(&list), ["a", "a 2", "b", "c"]);
    // The next export of it gets a name of its own.
    follow(&mut list, WorldsIntent::LookAt { slug: slug("a") });
    let row = rows(&list).into_iter().find(|row| row.slug == "a").unwrap();
    assert!(
        row.export_to.ends_with("a-2.antipode-world"),
        "{}",
        row.export_to
    );
}

/// The row of a world as it is now.
fn row_of(list: &WorldList, slug: &str) -> WorldRow {
    let row = rows(list).into_iter().find(|row| row.slug == slug);
    row.unwrap_or_else(|| panic!("{slug} is not listed"))
}

#[test]
fn the_list_says_in_which_worlds_one_gathers() {
    let (_dir, list) = three();
    let modes = ["a", "b", "c"].map(|slug| row_of(&list, slug).mode);
    assert_eq!(modes, ["", "Gathering", ""]);
}

#[test]
fn where_an_export_was_to_go_is_kept_until_it_is_there() {
    let (dir, mut list) = three();
    follow(&mut list, WorldsIntent::LookAt { slug: slug("a") });
    let export = |file: &str| WorldsIntent::Export {
        slug: slug("a"),
        file: file.to_owned(),
    };
    let nowhere = dir.path().join("nowhere/mine.antipode-world");
    let nowhere = nowhere.to_str().unwrap();
    follow(&mut list, export(nowhere));
    assert!(told(&mut list).unwrap().1);
    follow(&mut list, WorldsIntent::LookAt { slug: slug("a") });
    assert_eq!(row_of(&list, "a").export_to, nowhere);
    let there = dir.path().join("mine.antipode-world");
    follow(&mut list, export(there.to_str().unwrap()));
    assert!(!told(&mut list).unwrap().1);
    let next = dir.path().join("a.antipode-world");
    assert_eq!(PathBuf::from(row_of(&list, "a").export_to), next);
}

#[test]
fn a_failed_export_keeps_its_folder_and_goes_by_the_worlds_new_name() {
    let (dir, mut list) = three();
    let folder = dir.path().join("nowhere");
    fs::write(dir.path().join("moon-2.antipode-world"), b"").unwrap();
    for (called, name, then) in [
        ("a.antipode-world", "Moon 1", "moon-1.antipode-world"),
        ("mine.antipode-world", "Moon 2", "mine.antipode-world"),
        // As it is offered where there is one of that name.
        ("moon-2-2.antipode-world", "Moon 3", "moon-3.antipode-world"),
    ] {
        follow(&mut list, WorldsIntent::LookAt { slug: slug("a") });
        let export = WorldsIntent::Export {
            slug: slug("a"),
            file: folder.join(called).display().to_string(),
        };
        follow(&mut list, export);
        assert!(told(&mut list).unwrap().1);
        let rename = WorldsIntent::Rename {
            slug: slug("a"),
            name: name.to_owned(),
        };
        follow(&mut list, rename);
        assert!(!told(&mut list).unwrap().1);
        let row = row_of(&list, "a");
        assert_eq!(PathBuf::from(row.export_to), folder.join(then));
    }
}

#[test]
fn an_export_is_called_as_the_world_is_called_now() {
    let (dir, mut list) = three();
    follow(&mut list, WorldsIntent::LookAt { slug: slug("a") });
    let rename = |name: &str| WorldsIntent::Rename {
        slug: slug("a"),
        name: name.to_owned(),
    };
    for (name, file) in [
        ("My moon", "my-moon.antipode-world"),
        ("שלום", "world.antipode-world"),
    ] {
        follow(&mut list, rename(name));
        let row = row_of(&list, "a");
        assert_eq!(PathBuf::from(row.export_to), dir.path().join(file));
        assert_eq!(row.edits, Some(0), "it is known as before");
    }
}

#[test]
fn a_name_that_cannot_be_shown_has_its_folder_beside_it_wherever_it_is_told() {
    let (_dir, mut list) = three();
    let texts = Texts::default();
    let name = "שלום".to_owned();
    let rename = WorldsIntent::Rename {
        slug: slug("a"),
        name: name.clone(),
    };
    follow(&mut list, rename);
    let row = row_of(&list, "a");
    assert_eq!((row.name.as_str(), &row.full_name), ("… (a)", &name));
    assert_eq!(
        told(&mut list).unwrap().0,
        "The world is called “… (a)” now."
    );
    follow(&mut list, WorldsIntent::Duplicate { slug: slug("a") });
    let said = told(&mut list).unwrap().0;
    assert_eq!(said, "“… 2 (2)” is a copy of the world.");
    let taken = list.check_name(&texts, &name).unwrap_err();
    assert!(taken.contains("“… (a)”"), "{taken}");
}

#[test]
fn a_file_that_is_no_world_changes_nothing_and_says_why() {
    let (dir, mut list) = three();
    fs::write(
        dir.path().join("x.antipode-world"),
        b"rubbish, but long enough to be read",
    )
    .unwrap();
    follow(
        &mut list,
        WorldsIntent::Import {
            file: "~/x.antipode-world".to_owned(),
        },
    );
    let (said, bad) = told(&mut list).unwrap();
    assert!(bad && said.contains("x.antipode-world"), "{said}");
    assert_eq!(names(&list), ["a", "b", "c"]);
}

#[test]
fn files_are_taken_as_players_write_them() {
    let (dir, list) = three();
    let meant = |written: &str| list.locations.meant_by(written);
    assert_eq!(meant(" /x/y "), PathBuf::from("/x/y"));
    assert_eq!(meant("\"/x y/z\""), PathBuf::from("/x y/z"));
    assert_eq!(meant("'/x'"), PathBuf::from("/x"));
    assert_eq!(meant("~/w"), dir.path().join("w"));
    assert_eq!(meant("~"), dir.path());
    assert_eq!(meant("~other/w"), PathBuf::from("~other/w"));
    assert_eq!(meant("\""), PathBuf::from("\""));
}

#[test]
fn pictures_are_shown_once_read_and_again_when_they_change() {
    let (dir, mut list) = three();
    let context = egui::Context::default();
    let picture = |list: &WorldList, slug: &str| {
        rows(list)
            .into_iter()
            .find(|row| row.slug == slug)
            .unwrap()
            .picture
    };
    assert_eq!(picture(&list, "a"), None);
    list.show_pictures(&context);
    let first = picture(&list, "a");
    assert!(first.is_some());
    assert_eq!(picture(&list, "b"), None);
    // What has not changed is not read again.
    list.refresh();
    finish(&mut list);
    list.show_pictures(&context);
    assert_eq!(picture(&list, "a"), first);
    let saves = dir.path().join("saves");
    RgbaImage::new(16, 9)
        .save(saves.join("b/thumbnail.png"))
        .unwrap();
    fs::write(saves.join("a/thumbnail.png"), b"no picture").unwrap();
    list.refresh();
    finish(&mut list);
    list.show_pictures(&context);
    assert_eq!(picture(&list, "a"), None);
    assert!(picture(&list, "b").is_some());
}

#[test]
fn a_folder_that_is_gone_is_told_by_its_path() {
    let (dir, mut list) = three();
    fs::remove_dir_all(dir.path().join("saves/b")).unwrap();
    follow(&mut list, WorldsIntent::OpenFolder { slug: slug("b") });
    let (said, bad) = told(&mut list).unwrap();
    let path = dir.path().join("saves/b");
    assert!(bad && said.contains(path.to_str().unwrap()), "{said}");
}

#[test]
fn archives_are_looked_for_in_other_folders_and_back() {
    let (dir, mut list) = three();
    let file = dir.path().join("a.antipode-world");
    fs::write(&file, "x").unwrap();
    fs::create_dir(dir.path().join(".hidden")).unwrap();
    follow(&mut list, WorldsIntent::FindArchives);
    let files = |list: &WorldList| list.files(&Texts::default());
    let row = |list: &WorldList, name: Option<&str>| {
        let mut rows = files(list).folders.into_iter();
        rows.find(|it| it.name.as_deref() == name).map(|it| it.path)
    };
    assert_eq!(row(&list, Some(".hidden")), None);
    let folder = row(&list, Some("saves")).unwrap();
    follow(&mut list, WorldsIntent::FindIn { folder });
    assert!(files(&list).archives.is_empty());
    let folder = row(&list, None).unwrap();
    follow(&mut list, WorldsIntent::FindIn { folder });
    assert_eq!(files(&list).archives[0].file, file.display().to_string());
}

#[test]
fn a_folder_that_cannot_be_read_is_told_and_leads_on() {
    let (dir, mut list) = three();
    let gone = dir.path().join("nowhere");
    let folder = gone.display().to_string();
    follow(&mut list, WorldsIntent::FindIn { folder });
    let files = list.files(&Texts::default());
    let said = files.problem.unwrap();
    assert!(said.contains("nowhere cannot be read"), "{said}");
    let above = dir.path().display().to_string();
    assert_eq!(files.folders[0].path, above);
    follow(&mut list, WorldsIntent::FindIn { folder: above });
    assert_eq!(list.files(&Texts::default()).problem, None);
    // Where one has looked last one looks again, and not where the first look was.
    let folder = dir.path().join("archives").display().to_string();
    fs::create_dir(&folder).unwrap();
    follow(
        &mut list,
        WorldsIntent::FindIn {
            folder: folder.clone(),
        },
    );
    follow(&mut list, WorldsIntent::FindArchives);
    assert_eq!(list.files(&Texts::default()).dir, folder);
}
