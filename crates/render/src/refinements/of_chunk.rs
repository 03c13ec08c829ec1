//! The refinements of one chunk, and the error of drawing it with them.

use antipode_frame::Frame;

use super::Refinement;
use crate::chunk_store::GpuChunk;
use crate::pages::Pages;
use crate::plan::{Bounds, RefineKey, unhalved_error_px};

/// Where the eye is nearer than this to the box of a chunk's land, or in it, the land itself is looked at, metres.
const LOOKED_AT_WITHIN_M: f64 = 4.0;

impl GpuChunk {
    pub(super) fn is_refined_for(&self, key: &RefineKey) -> bool {
        self.refined.as_ref().is_some_and(|r| r.rules.key == *key)
    }

    /// Whether it has a refinement for an eye, shown or not.
    pub(super) fn is_ready_for(&self, key: &RefineKey) -> bool {
        let comes = self.coming.as_ref().is_some_and(|r| r.rules.key == *key);
        comes || self.is_refined_for(key)
    }

    pub(super) fn set_refined(&mut self, pages: &mut Pages, refinement: Refinement) {
        self.drop_refined(pages);
        self.is_urgent = false;
        self.refined = Some(refinement);
    }

    pub(super) fn set_coming(&mut self, pages: &mut Pages, refinement: Refinement) {
        if let Some(before) = self.coming.replace(refinement) {
            before.give_back(pages);
        }
    }

    /// Shows what has come for an eye; lets go of all that was made for another.
    pub(super) fn turn_to(&mut self, pages: &mut Pages, key: &RefineKey) {
        if let Some(coming) = self.coming.take() {
            if coming.rules.key == *key {
                self.set_refined(pages, coming);
            } else {
                coming.give_back(pages);
            }
        }
        if !self.is_refined_for(key) {
            self.drop_refined(pages);
            self.is_urgent = false;
        }
    }

    pub(super) fn drop_refined(&mut self, pages: &mut Pages) {
        if let Some(refined) = self.refined.take() {
            refined.give_back(pages);
        }
    }

    /// The most that its edges stray in a frame as it is drawn, pixels.
    pub(super) fn error_px(&self, frame: &Frame, bounds: &Bounds) -> f64 {
        match &self.refined {
            None => unhalved_error_px(frame, bounds, &self.land),
            Some(refined)
                if refined
                    .rules
                    .key
                    .holds(frame, bounds, &frame.view.eye.point) =>
            {
                refined.error_px
            }
            Some(Refinement {
                rules, error_px, ..
            }) => {
                let near_m = self.nearest_m(frame);
                rules.stale_error_px(*error_px, frame, bounds, &self.land, near_m)
            }
        }
    }

    /// No place of its land is nearer to the eye than this, metres along the chart.
    pub(super) fn nearest_m(&self, frame: &Frame) -> f64 {
        let boxed_m = Bounds::nearest_chart_m(frame, &self.land);
        let coord = self.land.coord;
        if boxed_m > LOOKED_AT_WITHIN_M || frame.view.eye.point.chart != coord.chart {
            return boxed_m;
        }
        let eye = (frame.view.eye.point.pos - coord.origin()).as_vec3();
        let vertices = self.source.vertices.iter();
        let square = vertices.map(|vertex| vertex.position().distance_squared(eye));
        let square = f64::from(square.fold(f32::INFINITY, f32::min));
        // The corner nearest to a place of a triangle is no farther from it than this, and at right angles to the way
        // to the eye where that place is the nearest.
        let corner_square = self.land.longest_edge_m().powi(2) / 3.0;
        boxed_m.max((square - corner_square).max(0.0).sqrt())
    }
}
