//! The locale files, embedded.

use crate::Language;

macro_rules! files {
    ($id:literal) => {
        files!($id: "menu", "worlds", "settings", "controls", "display", "messages", "devices", "console", "photo", "about", "newcomer", "backpack", "rooms", "workshop")
    };
    ($id:literal: $($area:literal),+) => {
        &[$((
            concat!($id, "/", $area, ".ftl"),
            include_str!(concat!("../../../assets/locales/", $id, "/", $area, ".ftl")),
        )),+]
    };
}

/// Path below `assets/locales` and contents of every file of a language.
pub(crate) fn files(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English => files!("en"),
        Language::Polish => files!("pl"),
        Language::Spanish => files!("es"),
        Language::German => files!("de"),
        Language::Chinese => files!("zh"),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;

    #[test]
    fn every_locale_file_is_embedded() {
        let locales = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/locales");
        let languages = locales.read_dir().unwrap().count();
        assert_eq!(languages, Language::ALL.len());
        for language in Language::ALL {
            let dir = locales.join(language.id());
            let there: BTreeSet<_> = dir
                .read_dir()
                .unwrap()
                .map(|entry| entry.unwrap().file_name().into_string().unwrap())
                .map(|name| format!("{}/{name}", language.id()))
                .collect();
            let embedded: BTreeSet<_> = files(language)
                .iter()
                .map(|(path, _)| (*path).to_owned())
                .collect();
            assert_eq!(there, embedded);
        }
    }
}
