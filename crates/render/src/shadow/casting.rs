//! The map of figures: what is on it, and on which land it may matter.

use antipode_scene::frame::{Figure, Frame};
use glam::{DVec3, DVec4};

use super::Shadows;
use super::levels::{Shot, near_crop};
use super::light::{Caster, Crop, Light};
use super::maps::PASSES;
use super::uniform::CasterUniform;

/// How far from the eye figures throw shadows, metres, and how far over their feet they reach.
const FIGURES_M: f64 = 24.0;
const FIGURE_HEIGHT_M: f64 = 2.5;
/// How far to each side of its feet a figure reaches, metres.
const FIGURE_REACH_M: f64 = 2.5;
impl Shadows {
    /// Takes this frame's figures, as far as any of them is near.
    pub(super) fn prepare_figures(&mut self, frame: &Frame, light: &Light) {
        let near = |figure: &&Figure| {
            frame
                .strategy
                .distance_m(frame.eye.point, figure.point, &frame.eye)
                < 2.0 * FIGURES_M
        };
        let crop = near_crop(frame, light, FIGURES_M, 1, self.maps.texels);
        let mut heights = [f64::INFINITY, f64::NEG_INFINITY];
        for figure in frame.figures.iter().filter(near) {
            if let Some([low, high]) = light.heights(&*frame.strategy, &crop, &room_of(figure)) {
                heights = [heights[0].min(low), heights[1].max(high)];
            }
        }
        if heights[0] > heights[1] {
            return;
        }
        let shot = Shot {
            light: *light,
            crop,
            heights,
        };
        let eye = &frame.eye;
        let reference = frame.strategy.reference(eye, eye.point.hemisphere);
        let from = match light {
            Light::Far { anchor, .. } => (reference - *anchor).extend(1.0),
            Light::Star { .. } => DVec4::W,
        };
        self.maps
            .write(&self.queue, PASSES - 1, &CasterUniform::new(&shot, from));
        self.figures = Some(shot);
    }

    /// Whether the shadow of a figure may fall on a box of land.
    pub fn figures_shade(&self, frame: &Frame, of: &Caster) -> bool {
        let Some(shot) = &self.figures else {
            return false;
        };
        let (strategy, light) = (&*frame.strategy, &shot.light);
        let shades = |figure: &Figure| {
            let room = room_of(figure);
            let Some([_, high]) = light.heights(strategy, &shot.crop, &room) else {
                return false;
            };
            let middle = figure.point.moved(DVec3::Y * (0.5 * FIGURE_HEIGHT_M));
            let base = light.base(strategy, middle);
            let (face, centre) = light.seen(base);
            let half = light.length_on_plane(base, FIGURE_REACH_M);
            let around = Crop { face, centre, half };
            let below = |[low, _]: [f64; 2]| matches!(light, Light::Star { .. }) || low < high;
            light.heights(strategy, &around, of).is_some_and(below)
        };
        frame.figures.iter().any(shades)
    }
}

/// The room that a figure takes.
fn room_of(figure: &Figure) -> Caster {
    let side = DVec3::new(FIGURE_REACH_M, 0.0, FIGURE_REACH_M);
    Caster {
        hemisphere: figure.point.hemisphere,
        min: figure.point.pos - side,
        max: figure.point.pos + side + DVec3::Y * FIGURE_HEIGHT_M,
    }
}
