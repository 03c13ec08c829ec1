//! Top right: what there is to know of the moment, and on demand what drawing the frame took and left out.

use antipode_language::{Texts, Value};
use egui::{Align2, FontId, Painter, Rect, pos2};

use super::{HudModel, plate::Lines};
use crate::theme::{GRID, TEXT, mono};

/// What drawing a frame took, what was chosen for it, and what it left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureModel {
    /// From one frame to the next in milliseconds, where it is known.
    pub frame_ms: Option<f64>,
    /// The adapter's own time in milliseconds, where it can tell.
    pub gpu_ms: Option<f64>,
    /// The picture's map and dial in words, e.g. "horizon map 10.0"; empty where the space has none.
    pub picture: String,
    /// How much exactness is traded for speed, in a word.
    pub quality: String,
    /// Chunks drawn as a whole, by one matrix.
    pub chunks_by_frame: usize,
    /// Chunks drawn vertex by vertex.
    pub chunks_by_vertex: usize,
    /// Chunks drawn with more triangles than their mesh has.
    pub chunks_refined: usize,
    /// Chunks drawn at each level of detail, the finest first.
    pub chunks_by_level: [usize; 4],
    /// Triangles drawn.
    pub triangles: usize,
    /// Triangles left out because they are out of the picture.
    pub outside: usize,
    /// Triangles left out because the curve of the land hides them.
    pub hidden: usize,
    /// Triangles left out because they would rise over the land by less than the quality lets pass.
    pub small: usize,
    /// The largest error of the picture in pixels.
    pub error_px: f64,
    /// What 99 of 100 places of the land are off by at most for their level of detail, in pixels.
    pub level_error_px: f64,
    /// Time of the world that was left out because the machine was too slow for it, in seconds.
    pub dropped_s: f64,
}

/// Draws it, under the position where both do not fit side by side; returns what it covers. `land`: what the land about is
/// called, where the map does not say so.
pub(super) fn show(
    painter: &Painter,
    screen: Rect,
    position: Rect,
    texts: &Texts,
    model: &HudModel,
    land: &str,
) -> Rect {
    let (lines, font) = match &model.figures {
        None => (moment(texts, model, land), mono()),
        Some(figures) => (measured(texts, model, figures), FontId::monospace(11.0)),
    };
    let lines = Lines::new(painter, screen, &lines, &font, TEXT);
    let fits = position.max.x + lines.width() + GRID <= screen.max.x;
    let y = if fits {
        screen.min.y
    } else {
        position.max.y + 4.0
    };
    lines.paint(painter, screen, pos2(screen.max.x, y), Align2::RIGHT_TOP)
}

/// A name, empty where none is needed, and what there is to say of it.
type Line = (String, String);

fn moment(texts: &Texts, model: &HudModel, land: &str) -> Vec<Line> {
    let mut lines = Vec::new();
    if model.fps > 0.0 {
        lines.push(fps(texts, model));
    }
    let here = [land, &model.time_label];
    let here = here.into_iter().filter(|text| !text.is_empty());
    let here = here.collect::<Vec<_>>().join(&texts.say("figures-comma"));
    let known = [model.geometry.clone(), here].into_iter();
    lines.extend(known.filter(|text| !text.is_empty()));
    lines
        .into_iter()
        .map(|line| (String::new(), line))
        .collect()
}

fn fps(texts: &Texts, model: &HudModel) -> String {
    let frames = Value::decimals(f64::from(model.fps), 0);
    texts.say_with("figures-fps", &[("frames", frames)])
}

fn measured(texts: &Texts, model: &HudModel, figures: &FigureModel) -> Vec<Line> {
    let space: Vec<&str> = [&model.geometry, &figures.picture, &figures.quality]
        .into_iter()
        .map(String::as_str)
        .filter(|text| !text.is_empty())
        .collect();
    let count = |number| Value::from(grouped(number));
    let [full, half, quarter, eighth] = figures.chunks_by_level.map(count);
    let chunks = [
        ("frame", count(figures.chunks_by_frame)),
        ("vertex", count(figures.chunks_by_vertex)),
        ("refined", count(figures.chunks_refined)),
    ];
    let detail = [
        ("full", full),
        ("half", half),
        ("quarter", quarter),
        ("eighth", eighth),
    ];
    let saved = [
        ("outside", count(figures.outside)),
        ("hidden", count(figures.hidden)),
        ("small", count(figures.small)),
    ];
    let error = [
        ("most", Value::decimals(figures.error_px, 3)),
        ("far", Value::decimals(figures.level_error_px, 1)),
    ];
    let drawn = [("triangles", count(figures.triangles))];
    let line = |name, key, values: &[_]| (texts.say(name), texts.say_with(key, values));
    let mut lines = vec![
        (String::new(), times(texts, model, figures)),
        (String::new(), space.join(&texts.say("figures-comma"))),
        line("figures-chunks", "figures-chunks-are", &chunks),
        line("figures-detail", "figures-detail-is", &detail),
        line("figures-drawn", "figures-drawn-are", &drawn),
        line("figures-saved", "figures-saved-are", &saved),
        line("figures-error", "figures-error-is", &error),
    ];
    if figures.dropped_s > 0.0 {
        let dropped = [("seconds", Value::decimals(figures.dropped_s, 1))];
        lines.push(line("figures-dropped", "figures-dropped-is", &dropped));
    }
    lines
}

/// What the frame took.
fn times(texts: &Texts, model: &HudModel, figures: &FigureModel) -> String {
    let ms = |time: Option<f64>| match time {
        Some(ms) => texts.say_with("figures-ms", &[("ms", Value::decimals(ms, 1))]),
        None => texts.say("figures-unknown"),
    };
    let fps = if model.fps > 0.0 {
        fps(texts, model)
    } else {
        texts.say("figures-fps-unknown")
    };
    let values = [
        ("fps", fps.into()),
        ("frame", ms(figures.frame_ms).into()),
        ("gpu", ms(figures.gpu_ms).into()),
        ("time", Value::from(&model.time_label)),
    ];
    texts.say_with("figures-times", &values)
}

/// A number with a blank between thousands.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_000), "1 000");
        assert_eq!(grouped(12_345_678), "12 345 678");
    }
}
