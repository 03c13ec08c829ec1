//! Describes how the last picture was drawn, for the probe and for the frame figures of the display.

use antipode_geometry::HyperbolicMap;
use antipode_language::{Texts, Value};
use antipode_render::{DrawStats, PlanStats};
use antipode_scene::frame::Quality;
use antipode_scene::{Lens, Scene};
use antipode_ui::FigureModel;
use serde::Serialize;

/// What the renderer chose for one frame, what it left out, and the error that causes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Drawn {
    /// The quality that was asked for.
    pub quality: &'static str,
    /// For what the picture was made: `card` or `software`.
    pub preset: &'static str,
    /// Triangles drawn.
    pub triangles: usize,
    /// What the renderer chose.
    #[serde(flatten)]
    pub plan: PlanStats,
}

impl Drawn {
    /// What the statistics of a frame of that quality tell.
    pub fn new(stats: &DrawStats, quality: Quality) -> Self {
        Self {
            quality: quality.name(),
            preset: stats.preset.name(),
            triangles: stats.triangles,
            plan: stats.plan,
        }
    }

    /// The frame figures of the display; the times are in milliseconds, where they are known. `dropped_s` is the
    /// world's time that was left out so far.
    pub fn figures(
        &self,
        texts: &Texts,
        scene: &Scene,
        frame_ms: Option<f64>,
        gpu_ms: Option<f64>,
        dropped_s: f64,
    ) -> FigureModel {
        FigureModel {
            frame_ms,
            gpu_ms,
            picture: picture_label(texts, scene.lens()),
            quality: texts.say(&format!("quality-{}", self.quality)),
            chunks_by_frame: self.plan.chunks_by_frame,
            chunks_by_vertex: self.plan.chunks_by_vertex,
            chunks_refined: self.plan.chunks_refined,
            chunks_by_level: self.plan.chunks_by_level,
            triangles: self.triangles,
            outside: self.plan.triangles_outside,
            hidden: self.plan.triangles_hidden,
            small: self.plan.triangles_small,
            error_px: self.plan.error_px,
            level_error_px: self.plan.level_error_px,
            dropped_s,
        }
    }
}

/// Map and dial in words; empty where a space has but one picture and no dial.
fn picture_label(texts: &Texts, lens: &Lens) -> String {
    let value = lens.value();
    let key = match (lens.map(), lens.bend()) {
        (Some(HyperbolicMap::Raised), _) => "picture-raised",
        (Some(HyperbolicMap::Horizon), _) => "picture-horizon",
        (None, Some(_)) => "picture-bend",
        (None, None) => return String::new(),
    };
    let sign = if value >= 0.0 { "+" } else { "" };
    let values = [("sign", sign.into()), ("value", Value::decimals(value, 1))];
    texts.say_with(key, &values)
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{Geometry, strategy};

    use super::*;

    #[test]
    fn the_probe_tells_quality_triangles_and_what_was_chosen_side_by_side() {
        let mut stats = DrawStats {
            triangles: 7,
            ..DrawStats::default()
        };
        stats.plan.chunks_by_level = [4, 3, 2, 1];
        stats.plan.error_px = 0.25;
        let said = serde_json::to_value(Drawn::new(&stats, Quality::Fast)).unwrap_or_default();
        assert_eq!(said["quality"], "fast");
        assert_eq!(said["triangles"], 7);
        assert_eq!(said["chunks_by_level"], serde_json::json!([4, 3, 2, 1]));
        assert_eq!(said["error_px"], 0.25);
        assert_eq!(said["triangles_hidden"], 0);
    }

    #[test]
    fn the_picture_is_named_with_its_dial() {
        let texts = Texts::default();
        let mut lens = Lens::new(strategy(Geometry::Hyperbolic, 20.0));
        assert_eq!(picture_label(&texts, &lens), "raised map 10.0");
        assert!(lens.set_map(HyperbolicMap::Horizon) && lens.set_curvature(3.25));
        assert_eq!(picture_label(&texts, &lens), "horizon map 3.2");
        let mut lens = Lens::new(strategy(Geometry::Euclidean, f64::INFINITY));
        assert_eq!(picture_label(&texts, &lens), "");
        assert!(lens.set_bend(-4.0));
        assert_eq!(picture_label(&texts, &lens), "bend -4.0");
    }
}
