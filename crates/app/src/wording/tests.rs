//! Failures in the player's words.
#![allow(clippy::panic, reason = "tests fail by panicking")]

use std::path::PathBuf;
use std::sync::Arc;

use antipode_language::Language;

use super::*;

fn common() -> Vec<StorageError> {
    let path = PathBuf::from("saves/x");
    let world = "Ziemia".to_owned();
    vec![
        StorageError::InUse {
            world: world.clone(),
        },
        StorageError::Busy { dir: path.clone() },
        StorageError::Newer { world, found: 99 },
        StorageError::Unreadable {
            path: path.clone(),
            reason: "an English reason".to_owned(),
        },
        StorageError::DiskFull {
            what: "saves/x".to_owned(),
        },
        StorageError::NotWritable { path: path.clone() },
        StorageError::Archive {
            path: path.clone(),
            reason: "an English reason".to_owned(),
        },
        StorageError::NotReadable { path: path.clone() },
        StorageError::Vanished { path },
    ]
}

#[test]
fn common_failures_are_told_wholly_in_the_players_language() {
    for language in Language::ALL {
        let texts = Texts::new(language);
        for error in common() {
            let said = storage(&texts, &error, &[]);
            let named = said.contains("Ziemia") || said.contains("saves/x");
            assert!(named && !said.contains("English"), "{said}");
            let english = storage(&Texts::default(), &error, &[]);
            assert_eq!(said == english, language == Language::English, "{said}");
        }
    }
}

#[test]
fn every_item_that_can_be_put_down_has_words_for_why_it_is_not_in_every_language() {
    let profiles = Profiles::default();
    for language in Language::ALL {
        let texts = Texts::new(language);
        for item in Item::ALL {
            if item.stands().is_none() {
                continue;
            }
            for why in [Hint::NoPlaceFor, Hint::NoneThere, Hint::TooMany] {
                let said = hint(&texts, &profiles, why(item));
                assert!(!said.contains("hint-"), "{language:?}: {said}");
            }
            for key in ["no-place-for", "none-there", "too-many"] {
                let key = format!("hint-{key}-{}", item.id());
                assert!(texts.has_own(&key), "{language:?} lacks {key}");
            }
        }
    }
}

#[test]
fn a_name_that_cannot_be_shown_has_its_folder_beside_it_in_every_failure() {
    let texts = Texts::default();
    let world = "שלום".to_owned();
    let listed = WorldSummary {
        slug: "world-2".to_owned(),
        meta: Some(antipode_storage::WorldMeta {
            name: world.clone(),
            ..antipode_storage::WorldMeta::default()
        }),
        size_bytes: 0,
        thumbnail: None,
        in_use: false,
        problem: None,
        error: None,
    };
    let full = StorageError::DiskFull {
        what: format!("\"{world}\" (saves/world-2)"),
    };
    let unknown = SceneError::UnknownGeometry {
        name: world.clone(),
        geometry: "odd".to_owned(),
    };
    for failed in [
        full.into(),
        StorageError::InUse {
            world: world.clone(),
        }
        .into(),
        StorageError::Newer { world, found: 99 }.into(),
        Failure::Scene(unknown),
    ] {
        let said = failure(&texts, &failed, std::slice::from_ref(&listed));
        assert!(
            said.contains('…') && said.contains("world-2") && !said.contains('ש'),
            "{said}"
        );
    }
}

#[test]
fn a_failed_save_says_why_in_the_players_language_through_every_layer() {
    let texts = Texts::new(Language::Polish);
    for error in common() {
        let why = storage(&texts, &error, &[]);
        let cause: Cause = Arc::new(error);
        let told = notice(&texts, &Notice::NotSaved(Cause::clone(&cause)));
        let asked = streaming(&texts, &StreamingError::NotSaved(cause));
        assert!(
            told.ends_with(&why) && asked.ends_with(&why),
            "{told} {asked}"
        );
    }
}

#[test]
fn what_failed_of_the_graphics_is_told_in_the_players_language() {
    let refused = RenderError::Shader("expected one of".to_owned());
    for language in Language::ALL {
        let texts = Texts::new(language);
        let english = Texts::default();
        for failed in [&refused, &RenderError::Lost("gone".to_owned())] {
            let Some(why) = Trouble::of(failed) else {
                panic!("{failed} is told to nobody");
            };
            let said = trouble(&texts, &why);
            let same = said == trouble(&english, &why);
            assert_eq!(same, language == Language::English, "{said}");
        }
        assert!(render(&texts, &refused).contains("expected one of"));
    }
}

#[test]
fn what_is_rare_keeps_its_details() {
    let texts = Texts::new(Language::Polish);
    let said = failure(&texts, &Failure::Runtime("Odd details.".to_owned()), &[]);
    assert!(said.ends_with("Odd details.") && said.len() > 20, "{said}");
}
