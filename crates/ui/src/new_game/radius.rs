//! The size of a closed world: named ones, any other by its slider, and how far it is round it.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use antipode_language::{Texts, Value};
use egui::{Button, Response, RichText, Slider, Ui};

use crate::entry::parse_number;
use crate::layout::Stops;
use crate::theme::{WEAK, small};
use crate::widgets::focus_ring;

/// Radii of spherical worlds that the player may choose, in metres.
const RANGE_M: RangeInclusive<f64> = 16.0..=256.0;
/// Sizes with a name: the key of its words and the radius in metres.
const NAMED_M: [(&str, f64); 3] = [
    ("radius-moonlet", 32.0),
    ("radius-moon", 100.0),
    ("radius-planet", 256.0),
];
/// What a new world has unless another is chosen: hills are small beside the world from about here on.
pub(super) const DEFAULT_M: f64 = 100.0;

/// Draws the choice; returns the slider, which has the focus while Enter makes the world.
pub(super) fn choose(
    ui: &mut Ui,
    texts: &Texts,
    radius_m: &mut f64,
    walk_m_s: f64,
    stops: &mut Stops,
) -> Response {
    let label = ui.label(texts.say("radius"));
    ui.horizontal_wrapped(|ui| {
        for (key, named_m) in NAMED_M {
            let values = [
                ("name", texts.say(key).into()),
                ("metres", Value::decimals(named_m, 0)),
            ];
            let words = texts.say_with("radius-named", &values);
            let chosen = (*radius_m - named_m).abs() < 0.5;
            let size = ui.add(Button::new(words).selected(chosen));
            focus_ring(ui, &size);
            stops.add(&size);
            if size.clicked() {
                *radius_m = named_m;
            }
        }
    });
    // Rail and number stand on one line.
    ui.spacing_mut().slider_width = (ui.available_width() - 88.0).clamp(24.0, 320.0);
    let slider = Slider::new(radius_m, RANGE_M)
        .step_by(1.0)
        .custom_formatter(|metres, _| {
            let metres = Value::decimals(metres, 0);
            texts.say_with("radius-metres", &[("metres", metres)])
        })
        .custom_parser(parse_number);
    let response = ui.add(slider).labelled_by(label.id);
    focus_ring(ui, &response);
    stops.add(&response);
    let words = once_round(texts, *radius_m, walk_m_s);
    ui.label(RichText::new(words).font(small()).color(WEAK));
    response
}

/// How far it is once round, along a great circle through the middle of both hemispheres, and how long at a walk: ways
/// are measured, and walked, in metres of the chart, which are those of the sheet that the ground lies about.
fn once_round(texts: &Texts, radius_m: f64, walk_m_s: f64) -> String {
    let round_m = TAU * radius_m;
    let values = [
        ("metres", Value::decimals(round_m, 0)),
        ("minutes", Value::decimals(round_m / walk_m_s / 60.0, 1)),
    ];
    texts.say_with("radius-round", &values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_round_is_a_great_circle_and_its_time_that_of_a_walk() {
        let texts = Texts::default();
        for (radius_m, words) in [
            (32.0, "Around the world: 201 m, 0.7 minutes at a walk."),
            (100.0, "Around the world: 628 m, 2.3 minutes at a walk."),
            (256.0, "Around the world: 1608 m, 6.0 minutes at a walk."),
        ] {
            assert_eq!(once_round(&texts, radius_m, 4.5), words);
        }
    }
}
