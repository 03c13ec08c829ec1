//! Finds the settings that a search means: those whose texts contain every word of it.

use antipode_language::Texts;
use antipode_settings::{Field, Kind, fields};

/// The ids of the settings that a search means; an empty one means all.
pub(super) fn found(texts: &Texts, search: &str) -> Vec<&'static str> {
    let meant = fields()
        .iter()
        .filter(|field| matches(texts, field, &texts.say(field.group.id()), search));
    meant.map(|field| field.id).collect()
}

/// Whether the search means this field under that heading.
fn matches(texts: &Texts, field: &Field, heading: &str, search: &str) -> bool {
    let search = search.to_lowercase();
    if search.trim().is_empty() {
        return true;
    }
    let id = field.id;
    let mut words = vec![
        heading.to_owned(),
        id.to_owned(),
        texts.say(&format!("setting-{id}")),
        texts.say(&format!("setting-{id}-about")),
    ];
    if let Kind::Choice { options } = field.kind {
        words.extend(
            options
                .iter()
                .map(|option| texts.say(&format!("setting-{id}-{option}"))),
        );
    }
    let words = words.join("\n").to_lowercase();
    search.split_whitespace().all(|word| words.contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(search: &str) -> Vec<&'static str> {
        super::found(&Texts::default(), search)
    }

    #[test]
    fn all_words_must_occur_in_any_order_and_case() {
        assert_eq!(found("").len(), fields().len());
        assert_eq!(found("  ").len(), fields().len());
        assert_eq!(found("SENSITIVITY mouse"), ["mouse-sensitivity"]);
        assert!(found("polski").contains(&"language"), "an option's word");
        assert!(found("mouse polski").is_empty());
    }
}
