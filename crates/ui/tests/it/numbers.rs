//! Numbers in the manner of the language, wherever there are any.

use crate::common::{Game, painted};
use antipode_language::{Language, Texts};
use antipode_ui::{HudModel, Screen, apply_theme, show_hud};
use egui::vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;

const WITH_COMMA: [Language; 3] = [Language::Polish, Language::Spanish, Language::German];

/// The numbers in a text that have this mark between two digits.
fn marked_by(text: &str, mark: char) -> bool {
    let chars: Vec<char> = text.chars().collect();
    let is_mark =
        |three: &[char]| three[0].is_ascii_digit() && three[1] == mark && three[2].is_ascii_digit();
    chars.windows(3).any(is_mark)
}

fn spoken(harness: &Harness<'_, Game>) -> Vec<String> {
    let nodes = harness.root().children_recursive();
    nodes
        .filter_map(|node| node.accesskit_node().value())
        .collect()
}

#[test]
fn no_screen_has_a_decimal_point_where_the_language_has_a_comma() {
    for language in WITH_COMMA {
        for screen in [
            Screen::Main,
            Screen::NewGame,
            Screen::Load,
            Screen::Settings,
            Screen::Controls,
        ] {
            let mut game = Game::new();
            game.texts = Texts::new(language);
            let spherical = game.texts.say("geometry-spherical");
            game.shell.open(screen.clone());
            let mut harness = crate::common::harness(game, vec2(1280.0, 4000.0));
            harness.run();
            if screen == Screen::NewGame {
                crate::common::click(&mut harness, &spherical);
                let metres = harness
                    .state()
                    .texts
                    .say_with("radius-metres", &[("metres", 32.into())]);
                let shown = painted(harness.output());
                let is_radius = |words: &str| {
                    words.contains(" m") && words.starts_with(|c: char| c.is_ascii_digit())
                };
                assert!(shown.iter().any(|text| is_radius(&text.text)), "{metres}");
            }
            let version = "0.1.0";
            let words = painted(harness.output()).into_iter().map(|text| text.text);
            for words in words.chain(spoken(&harness)) {
                let own = !words.contains(version) && !words.contains("MB");
                assert!(
                    !(own && marked_by(&words, '.')),
                    "“{words}” in {language:?}"
                );
            }
        }
    }
}

#[test]
fn the_display_writes_every_figure_as_the_language_does() {
    let model = HudModel {
        chart: [-12.344, 1.7, 3.0],
        curved: [0.1, -0.2, -3.2e43, 1.066],
        brush_radius_m: Some(2.5),
        // Beside which the coordinates stand.
        figures: Some(antipode_ui::FigureModel::default()),
        ..HudModel::default()
    };
    for language in Language::ALL {
        let texts = Texts::new(language);
        let mut harness = Harness::builder()
            .with_size(vec2(1280.0, 720.0))
            .with_context_setup(apply_theme)
            .build_ui_state(
                move |ui, model: &mut HudModel| {
                    show_hud(ui.ctx(), &texts, model);
                },
                model.clone(),
            );
        harness.run();
        let (own, other) = if WITH_COMMA.contains(&language) {
            (',', '.')
        } else {
            ('.', ',')
        };
        let shown = painted(harness.output());
        assert!(
            !shown.iter().any(|text| marked_by(&text.text, other)),
            "{language:?}"
        );
        let figures = shown.iter().filter(|text| marked_by(&text.text, own));
        assert!(figures.count() > 1, "{language:?}");
    }
}
