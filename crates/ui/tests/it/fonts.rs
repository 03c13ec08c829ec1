//! Every character that a language is written in can be shown.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use antipode_language::Language;
use antipode_ui::apply_theme;
use egui::{Context, FontId, RawInput};

/// Those of the characters that neither words nor figures could be shown with.
fn without_glyph(characters: &BTreeSet<char>) -> Vec<char> {
    let context = Context::default();
    apply_theme(&context);
    let mut missing = Vec::new();
    let _ = context.run_pass(RawInput::default(), |context| {
        context.fonts_mut(|fonts| {
            let fonts_of_game = [FontId::proportional(16.0), FontId::monospace(13.0)];
            let mut is_missing = |c| fonts_of_game.iter().any(|font| !fonts.has_glyph(font, c));
            missing = characters
                .iter()
                .copied()
                .filter(|c| is_missing(*c))
                .collect();
        });
    });
    missing
}

#[test]
fn every_character_of_every_locale_file_has_a_glyph() {
    let locales = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/locales");
    for language in Language::ALL {
        let files = locales.join(language.id()).read_dir().unwrap();
        let sources = files.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
        let characters: BTreeSet<char> = sources
            .flat_map(|source| source.chars().collect::<Vec<_>>())
            .chain(language.own_name().chars())
            .filter(|c| *c != '\n')
            .collect();
        assert!(characters.len() > 50, "{language:?}");
        let missing = without_glyph(&characters);
        assert!(
            missing.is_empty(),
            "{language:?} lacks {missing:?}: run assets/fonts/subset.py"
        );
    }
}

#[test]
fn names_that_players_type_in_chinese_can_be_shown() {
    // The first and the last of the commonest characters of GB 2312, and of those after them.
    let characters = BTreeSet::from(['啊', '座', '亍', '齄', '，', '。', '！', '？', '：']);
    assert_eq!(without_glyph(&characters), []);
}

#[test]
fn a_character_without_a_glyph_is_found() {
    assert_eq!(
        without_glyph(&BTreeSet::from(['a', '\u{12345}'])),
        ['\u{12345}']
    );
}
