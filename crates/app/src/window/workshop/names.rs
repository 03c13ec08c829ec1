//! What things are called that the workshop puts into a room: in the player's language, numbered where the word is taken.

use antipode_language::Texts;
use antipode_rooms::Room;
use antipode_workshop::Edit;

use super::rows::free_name;

/// A word of the workshop in the player's language.
pub fn word(texts: &Texts, english: &str) -> String {
    let key = english.replace(' ', "-");
    texts.say(&format!("workshop-name-{key}"))
}

/// The word of a name, and the number after it if there is one.
fn parted(name: &str) -> (&str, Option<&str>) {
    match name.rsplit_once(' ') {
        Some((word, number)) if number.parse::<u32>().is_ok() => (word, Some(number)),
        _ => (name, None),
    }
}

/// A name in the player's language.
fn name(texts: &Texts, english: &str) -> String {
    match parted(english) {
        (first, Some(number)) => format!("{} {number}", word(texts, first)),
        (whole, None) => word(texts, whole),
    }
}

/// A part that is put in, called in the player's language. A copy of it in the room makes its names free.
pub fn in_language(edit: Edit, room: &Room, texts: &Texts) -> Edit {
    match edit {
        Edit::Insert(mut object) => {
            object.name = free_name(room, &word(texts, parted(&object.name).0));
            Edit::Insert(object)
        }
        Edit::Paste { clip, by, is_part } => Edit::Paste {
            clip: clip.renamed(|english| name(texts, english)),
            by,
            is_part,
        },
        other => other,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use std::collections::HashSet;

    use antipode_language::Language;
    use antipode_rooms::What;
    use antipode_workshop::Document;
    use glam::DVec3;

    use super::super::kits::{KITS, Site};
    use super::super::parts::{PARTS, put};
    use super::*;

    #[test]
    fn every_part_is_called_in_every_language_and_its_portals_still_lead_to_each_other() {
        for language in Language::ALL {
            let texts = Texts::new(language);
            for id in PARTS.into_iter().chain(KITS.iter().map(|(id, _)| *id)) {
                let mut document = Document::new(Room::new("a"));
                for z in [-4.0, -40.0] {
                    let site = Site {
                        point: DVec3::Z * z,
                        normal: DVec3::Y,
                        front: DVec3::NEG_Z,
                        snap: &f64::round,
                        ground: &|point| Some(DVec3::new(point.x, 0.0, point.z)),
                    };
                    let edit = put(document.room(), id, &site).unwrap();
                    let edit = in_language(edit, document.room(), &texts);
                    document.edit(&edit).unwrap();
                }
                let room = document.room();
                if (language, id) == (Language::German, "house") {
                    let named = ["Haus", "Haus Dach", "Haus 2"];
                    assert!(named.iter().all(|it| room.find(it).is_some()));
                }
                for object in &room.objects {
                    assert!(!object.name.contains("workshop-name"), "{}", object.name);
                    if let What::Portal(it) = &object.what {
                        let partner = room.find(&it.to).unwrap().1;
                        assert!(
                            matches!(&partner.what, What::Portal(back) if back.to == object.name)
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn words_are_those_of_the_language_and_no_two_are_the_same() {
        let english = Texts::new(Language::English);
        let all = KITS
            .iter()
            .flat_map(|(id, _)| super::super::kits::objects(id).unwrap());
        let words: HashSet<String> = all.map(|it| parted(&it.name).0.to_owned()).collect();
        for language in Language::ALL {
            let texts = Texts::new(language);
            let said: HashSet<_> = words.iter().map(|it| word(&texts, it)).collect();
            assert_eq!(said.len(), words.len(), "{language:?}");
        }
        for it in &words {
            assert_eq!(&word(&english, it), it);
        }
        let german = Texts::new(Language::German);
        assert_eq!(name(&german, "portal frame 2"), "Portalrahmen 2");
    }
}
