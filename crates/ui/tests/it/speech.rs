//! Where the display puts what others say.

use crate::common::{SIZES, painted};
use antipode_language::{Language, Texts};
use antipode_ui::{HudModel, SpeechModel, apply_theme, show_hud};
use egui::{Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;

#[test]
fn words_stand_over_who_says_them_and_never_outside_of_the_picture() {
    let said = |at| HudModel {
        speech: Some(SpeechModel {
            text: "Home is 42 m that way, or 159 m the other way round.".to_owned(),
            at,
        }),
        ..HudModel::default()
    };
    let words_at = |at, size: Vec2| {
        let texts = Texts::new(Language::English);
        let mut harness = Harness::builder()
            .with_size(size)
            .with_context_setup(apply_theme)
            .build_ui_state(
                move |ui, model: &mut HudModel| {
                    show_hud(ui.ctx(), &texts, model);
                },
                said(at),
            );
        harness.run();
        let texts = painted(harness.output());
        texts
            .iter()
            .find(|text| text.text.contains("Home is"))
            .map(|text| text.rect)
            .expect("it is said")
    };
    let size = vec2(1280.0, 720.0);
    let words = words_at(Some([-0.5, 0.1]), size);
    let head = vec2(640.0 - 0.5 * 360.0, 360.0 - 0.1 * 360.0).to_pos2();
    assert!((words.center().x - head.x).abs() < 1.0, "{words}");
    assert!(
        words.max.y < head.y && words.max.y > head.y - 24.0,
        "{words}"
    );
    for x in [-0.3, 0.3] {
        let words = words_at(Some([x, 0.85]), size);
        let head_x = 640.0 + 360.0 * x;
        assert!(
            !(words.min.x - 40.0..words.max.x + 40.0).contains(&head_x),
            "without room over a head they are beside it: {words}"
        );
    }
    let aside = words_at(None, size);
    assert!((aside.center().x - 640.0).abs() < 1.0 && aside.center().y > 400.0);
    for at in [
        None,
        Some([1.7, 0.9]),
        Some([-9.0, 0.0]),
        Some([f32::NAN, 0.0]),
    ] {
        for size in SIZES {
            let words = words_at(at, size);
            let screen = Rect::from_min_size(Pos2::ZERO, size);
            assert!(
                size.x < 320.0 || screen.contains_rect(words),
                "{at:?} at {size}: {words}"
            );
        }
    }
}
