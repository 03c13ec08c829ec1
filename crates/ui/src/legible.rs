//! Names that players gave to things, as far as they can be shown. The fonts lack most scripts and some emoji, which would
//! come out as boxes, and words that run from right to left would come out in the wrong order.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::LazyLock;

use egui::FontFamily;
use egui::epaint::text::{Fonts, TextOptions};

use crate::fonts;

/// What stands for characters that cannot be shown.
const GAP: char = '…';

/// The characters that both words and figures can be written with.
static GLYPHS: LazyLock<BTreeSet<char>> = LazyLock::new(|| {
    let mut fonts = Fonts::new(TextOptions::default(), fonts::definitions());
    let mut fonts = fonts.with_pixels_per_point(1.0);
    let [words, figures] = [FontFamily::Proportional, FontFamily::Monospace].map(|family| {
        fonts
            .characters(&family)
            .keys()
            .copied()
            .collect::<BTreeSet<_>>()
    });
    words.intersection(&figures).copied().collect()
});

/// A name as it can be shown: whole, or with a mark for what cannot, and then what it is known by elsewhere beside it, as
/// the name of a world's folder.
pub fn legible_name<'a>(name: &'a str, known_by: &str) -> Cow<'a, str> {
    match legible(name) {
        Cow::Owned(part) if !known_by.is_empty() => Cow::Owned(format!("{part} ({known_by})")),
        shown => shown,
    }
}

/// A name as far as it can be shown, with a mark for each part that cannot.
pub fn legible(name: &str) -> Cow<'_, str> {
    if !is_partly_shown(name) {
        return Cow::Borrowed(name);
    }
    let mut shown = String::new();
    for word in name.split_whitespace() {
        let mut part = String::new();
        for c in word.chars() {
            if is_shown(c) {
                part.push(c);
            } else if !part.ends_with(GAP) {
                part.push(GAP);
            }
        }
        // One mark for words that are missing in a row.
        let missing = part.chars().all(|c| c == GAP || is_joiner(c));
        if missing && shown.ends_with(GAP) {
            continue;
        }
        if !shown.is_empty() {
            shown.push(' ');
        }
        shown.push_str(if missing { "…" } else { &part });
    }
    Cow::Owned(shown)
}

/// Whether some of a name cannot be shown.
pub(crate) fn is_partly_shown(name: &str) -> bool {
    !name.chars().all(is_shown)
}

/// Whether there is a glyph, and it stands where it should.
fn is_shown(c: char) -> bool {
    (GLYPHS.contains(&c) || is_joiner(c)) && !runs_left(c)
}

/// What joins characters or chooses between their forms, and is not seen itself.
fn is_joiner(c: char) -> bool {
    matches!(c, '\u{200c}' | '\u{200d}' | '\u{fe00}'..='\u{fe0f}')
}

/// Letters of scripts that are written from right to left: the blocks that Unicode keeps for those (DerivedBidiClass,
/// R and AL).
fn runs_left(c: char) -> bool {
    matches!(c, '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{fefe}'
        | '\u{10800}'..='\u{10fff}' | '\u{1e800}'..='\u{1efff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_be_written_is_shown_as_it_is() {
        for name in [
            "My world",
            "Żółw 7",
            "Мир №1",
            "Ωμέγα",
            "世界",
            "a/b “c”",
            "",
        ] {
            assert_eq!(legible_name(name, "folder"), name);
        }
    }

    #[test]
    fn what_cannot_be_written_is_marked_and_the_folder_stands_beside_it() {
        for (name, shown) in [
            ("عالمي الجديد", "… (world-2)"),
            ("שלום", "… (world-2)"),
            ("Base קטן 7", "Base … 7 (world-2)"),
            ("a\u{1fae0}b", "a…b (world-2)"),
            ("नमस्ते दुनिया", "… (world-2)"),
            ("한국", "… (world-2)"),
        ] {
            assert_eq!(legible_name(name, "world-2"), shown);
        }
        assert_eq!(legible_name("שלום", ""), "…");
        assert_eq!(legible("שלום x"), "… x");
    }
}
