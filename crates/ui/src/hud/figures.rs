//! Top right: what there is to know of the moment, and on demand what drawing the frame took and left out.

use egui::{Align2, FontId, Painter, Rect, pos2};

use super::{HudModel, plate::plate};
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
}

/// Draws it, under the position where both do not fit side by side; returns what it covers.
pub(super) fn show(painter: &Painter, screen: Rect, position: Rect, model: &HudModel) -> Rect {
    let (lines, font) = match &model.figures {
        None => (moment(model), mono()),
        Some(figures) => (measured(model, figures), FontId::monospace(11.0)),
    };
    let text = lines.join("\n");
    let layout = painter.layout_no_wrap(text.clone(), font.clone(), TEXT);
    let fits = position.max.x + layout.size().x + 3.0 * GRID <= screen.max.x;
    let y = if fits {
        screen.min.y
    } else {
        position.max.y + 4.0
    };
    plate(
        painter,
        screen,
        pos2(screen.max.x, y),
        Align2::RIGHT_TOP,
        &text,
        font,
        TEXT,
    )
}

fn moment(model: &HudModel) -> Vec<String> {
    let mut lines = Vec::new();
    if model.fps > 0.0 {
        lines.push(format!("{:.0} fps", model.fps));
    }
    lines.extend(
        [&model.geometry, &model.time_label]
            .into_iter()
            .filter(|text| !text.is_empty())
            .cloned(),
    );
    lines
}

fn measured(model: &HudModel, figures: &FigureModel) -> Vec<String> {
    let ms = |time: Option<f64>| time.map_or("n/a".to_owned(), |ms| format!("{ms:.1} ms"));
    let fps = if model.fps > 0.0 {
        format!("{:.0} fps", model.fps)
    } else {
        "fps n/a".to_owned()
    };
    let space: Vec<&str> = [&model.geometry, &figures.picture, &figures.quality]
        .into_iter()
        .map(String::as_str)
        .filter(|text| !text.is_empty())
        .collect();
    let line = |name: &str, text: String| format!("{name:<8}{text}");
    vec![
        format!(
            "{fps}   frame {}   gpu {}   {}",
            ms(figures.frame_ms),
            ms(figures.gpu_ms),
            model.time_label
        ),
        space.join(", "),
        line(
            "chunks",
            format!(
                "{} by frame, {} by vertex, {} refined",
                grouped(figures.chunks_by_frame),
                grouped(figures.chunks_by_vertex),
                grouped(figures.chunks_refined)
            ),
        ),
        line(
            "detail",
            format!(
                "{} full, {} half, {} quarter, {} eighth",
                grouped(figures.chunks_by_level[0]),
                grouped(figures.chunks_by_level[1]),
                grouped(figures.chunks_by_level[2]),
                grouped(figures.chunks_by_level[3])
            ),
        ),
        line("drawn", format!("{} triangles", grouped(figures.triangles))),
        line(
            "saved",
            format!(
                "{} outside, {} hidden, {} too small",
                grouped(figures.outside),
                grouped(figures.hidden),
                grouped(figures.small)
            ),
        ),
        line(
            "error",
            format!(
                "at most {:.3} px, far land {:.1} px",
                figures.error_px, figures.level_error_px
            ),
        ),
    ]
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
