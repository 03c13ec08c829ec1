//! The size of a hyperbolic world: how wide its squares are, and how much land that makes.

use antipode_language::{Texts, Value};
use egui::{Button, RichText, Ui};

use crate::layout::Stops;
use crate::theme::{WEAK, small};
use crate::widgets::focus_ring;

/// The widths that there are, of a square at its middle, with the radii of their worlds, metres.
const SIZES_M: [(f64, f64); 3] = [(32.0, 30.152), (64.0, 60.305), (128.0, 120.61)];
/// What a new world has unless another is chosen.
pub(super) const DEFAULT_RADIUS_M: f64 = SIZES_M[1].1;
/// How far land is counted, metres.
const WITHIN_M: f64 = 250.0;

/// Draws the choice.
pub(super) fn choose(ui: &mut Ui, texts: &Texts, radius_m: &mut f64, stops: &mut Stops) {
    ui.label(texts.say("squares"));
    ui.horizontal_wrapped(|ui| {
        for (wide_m, its_radius_m) in SIZES_M {
            let words = texts.say_with("squares-wide", &[("metres", Value::decimals(wide_m, 0))]);
            let chosen = (*radius_m - its_radius_m).abs() < 0.5;
            let size = ui.add(Button::new(words).selected(chosen));
            focus_ring(ui, &size);
            stops.add(&size);
            if size.clicked() {
                *radius_m = its_radius_m;
            }
        }
    });
    let words = land_within(texts, *radius_m);
    ui.label(RichText::new(words).font(small()).color(WEAK));
}

/// How much land lies within [`WITHIN_M`] of a place, beside flat land: a disc of d metres has
/// `2 pi R^2 (cosh(d/R) - 1)` square metres, and `pi d^2` where flat.
fn land_within(texts: &Texts, radius_m: f64) -> String {
    let radii = WITHIN_M / radius_m;
    let times = 2.0 * (radii.cosh() - 1.0) / (radii * radii);
    let values = [
        ("metres", Value::decimals(WITHIN_M, 0)),
        ("times", Value::decimals(times, 1)),
    ];
    texts.say_with("squares-land", &values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_land_within_a_distance_is_that_of_a_hyperbolic_disc() {
        let texts = Texts::default();
        for ((_, radius_m), times) in SIZES_M.into_iter().zip(["58.0", "3.6", "1.4"]) {
            let words =
                format!("Within 250 m there is {times} times as much land as on flat ground.");
            assert_eq!(land_within(&texts, radius_m), words);
        }
    }
}
