//! What the last picture was drawn with, for the probe and for the frame figures of the display.

use antipode_geometry::HyperbolicMap;
use antipode_render::DrawStats;
use antipode_scene::frame::Quality;
use antipode_scene::{Lens, Scene};
use antipode_ui::FigureModel;
use serde::Serialize;

/// What the renderer chose for one frame, what it left out, and the error that causes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Drawn {
    /// The quality that was asked for.
    pub quality: &'static str,
    /// Triangles drawn.
    pub triangles: usize,
    /// Chunks drawn as a whole, by one matrix.
    pub chunks_by_frame: usize,
    /// Chunks drawn vertex by vertex.
    pub chunks_by_vertex: usize,
    /// Chunks drawn with edges halved.
    pub chunks_refined: usize,
    /// Chunks whose fragments found their own depth.
    pub chunks_fragment_depth: usize,
    /// Figures drawn as a whole, by one matrix.
    pub figures_by_frame: usize,
    /// Figures drawn vertex by vertex.
    pub figures_by_vertex: usize,
    /// Triangles left out because they are out of the picture.
    pub triangles_outside: usize,
    /// Triangles left out because the curve of the land hides them.
    pub triangles_hidden: usize,
    /// Triangles left out because they rise over nearer land by less than the quality lets pass.
    pub triangles_small: usize,
    /// Triangles that halving edges added.
    pub triangles_added: usize,
    /// The largest error in the frame, in pixels.
    pub error_px: f64,
}

impl Drawn {
    /// What the statistics of a frame of that quality tell.
    pub fn new(stats: &DrawStats, quality: Quality) -> Self {
        let plan = &stats.plan;
        Self {
            quality: quality.name(),
            triangles: stats.triangles,
            chunks_by_frame: plan.chunks_by_frame,
            chunks_by_vertex: plan.chunks_by_vertex,
            chunks_refined: plan.chunks_refined,
            chunks_fragment_depth: plan.chunks_fragment_depth,
            figures_by_frame: plan.figures_by_frame,
            figures_by_vertex: plan.figures_by_vertex,
            triangles_outside: plan.triangles_outside,
            triangles_hidden: plan.triangles_hidden,
            triangles_small: plan.triangles_small,
            triangles_added: plan.triangles_added,
            error_px: plan.error_px,
        }
    }

    /// The frame figures of the display; the times are in milliseconds, where they are known.
    pub fn figures(
        &self,
        scene: &Scene,
        frame_ms: Option<f64>,
        gpu_ms: Option<f64>,
    ) -> FigureModel {
        FigureModel {
            frame_ms,
            gpu_ms,
            picture: picture_label(scene.lens()),
            quality: self.quality.to_owned(),
            chunks_by_frame: self.chunks_by_frame,
            chunks_by_vertex: self.chunks_by_vertex,
            chunks_refined: self.chunks_refined,
            triangles: self.triangles,
            outside: self.triangles_outside,
            hidden: self.triangles_hidden,
            small: self.triangles_small,
            error_px: self.error_px,
        }
    }
}

/// Map and dial in words; empty where a space has but one picture and no dial.
fn picture_label(lens: &Lens) -> String {
    let value = lens.value();
    match (lens.map().map(HyperbolicMap::name), lens.bend()) {
        (Some(map), _) => format!("{map} map {value:.1}"),
        (None, Some(_)) => format!("bend {value:+.1}"),
        (None, None) => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::Geometry;

    use super::*;

    #[test]
    fn the_picture_is_named_with_its_dial() {
        let mut lens = Lens::new(Geometry::Hyperbolic, 20.0);
        assert_eq!(picture_label(&lens), "raised map 10.0");
        assert!(lens.set_map(HyperbolicMap::Horizon) && lens.set_curvature(3.25));
        assert_eq!(picture_label(&lens), "horizon map 3.2");
        let mut lens = Lens::new(Geometry::Euclidean, f64::INFINITY);
        assert_eq!(picture_label(&lens), "");
        assert!(lens.set_bend(-4.0));
        assert_eq!(picture_label(&lens), "bend -4.0");
    }
}
