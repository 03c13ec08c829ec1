//! The map of figures: what is on it, and on which land it may matter.

use antipode_frame::Frame;
use antipode_geometry::ChartPoint;
use glam::DMat4;

use super::caster::Caster;
use super::levels::{Shot, near_crop};
use super::light::{Crop, Light};
use super::maps::PASSES;
use super::uniform::{CasterUniform, own_base, reference_from};
use super::{ShadowQuality, Shadows};
use crate::terrain_pipelines::ShadowReach;

/// How far from the eye figures throw shadows, metres.
const FIGURES_M: f64 = 24.0;
/// How far beyond a figure its soft shadow reaches, and edges of land that were halved stray, metres.
const EDGE_M: f64 = 0.25;

impl Shadows {
    /// What the map of figures is a picture of, before its heights are known; none where there is none.
    pub fn figures_shot(&self, frame: &Frame) -> Option<Shot> {
        if self.quality == ShadowQuality::Off {
            return None;
        }
        if self.merges() {
            return self.levels[0].shot;
        }
        let light = Light::of(frame);
        Some(Shot {
            light,
            crop: near_crop(frame, &light, FIGURES_M, 1, self.maps.texels),
            heights: [0.0, 1.0],
        })
    }

    /// Takes this frame's figures by the boxes that hold them, as far as any of them is near, and the heights between which
    /// all lie that fall on the map.
    pub fn prepare_figures(
        &mut self,
        frame: &Frame,
        shot: Option<Shot>,
        figures: &[Caster],
        heights: [f64; 2],
    ) {
        let strategy = &*frame.view.strategy;
        let Some(Shot { light, crop, .. }) = shot else {
            return;
        };
        let mut is_near = false;
        for room in figures {
            let Some([_, high]) = light.heights(strategy, &crop, room) else {
                continue;
            };
            let middle = ChartPoint::new(room.chart, room.middle());
            is_near |= strategy.distance_m(frame.view.eye.point, middle, &frame.view.eye)
                < 2.0 * FIGURES_M;
            if self.merges() {
                continue;
            }
            let base = light.base(strategy, middle);
            let (face, centre) = light.seen(base);
            let half = light.length_on_plane(base, room.reach().length() + EDGE_M);
            self.rooms.push((Crop { face, centre, half }, high));
        }
        if !is_near {
            self.rooms.clear();
            return;
        }
        let shot = Shot {
            light,
            crop,
            heights,
        };
        let from = match light {
            Light::Far { .. } if !light.is_ideal() => {
                DMat4::from_translation(reference_from(frame, &light).truncate())
            }
            Light::Far { .. } | Light::Star { .. } => own_base(frame, &light),
        };
        let uniform = CasterUniform::new(&shot, from);
        self.maps.write(&self.queue, PASSES - 1, &uniform);
        self.figures = Some(shot);
    }

    /// What may throw a shadow on a box of land, as far as that makes a difference to how it is drawn.
    pub fn reach(&self, frame: &Frame, of: &Caster) -> ShadowReach {
        if self.figures_shade(frame, of) {
            return ShadowReach::All;
        }
        // Under a sky nearly all land is on some map; where there are faces, all is.
        let [level] = &self.levels[..] else {
            return ShadowReach::Land;
        };
        let strategy = &*frame.view.strategy;
        let is_on = |shot: &Shot| shot.light.heights(strategy, &shot.crop, of).is_some();
        if level.shot.as_ref().is_some_and(is_on) {
            ShadowReach::Land
        } else {
            ShadowReach::Nothing
        }
    }

    /// What may throw a shadow on a part of a box that `whole` holds for, as far as that makes a difference to how the
    /// part is drawn.
    pub fn reach_within(&self, frame: &Frame, whole: ShadowReach, part: &Caster) -> ShadowReach {
        if self.quality == ShadowQuality::Low && whole != ShadowReach::Nothing {
            self.reach(frame, part)
        } else {
            self.told_apart(whole)
        }
    }

    /// What is drawn as what: where branches cost nothing, land that no figure's shadow falls on is drawn as all is.
    pub fn told_apart(&self, reach: ShadowReach) -> ShadowReach {
        if self.quality == ShadowQuality::Low {
            reach
        } else {
            ShadowReach::All
        }
    }

    /// Whether the shadow of a figure may fall on a box of land.
    fn figures_shade(&self, frame: &Frame, of: &Caster) -> bool {
        let Some(shot) = self.figures.as_ref().filter(|_| !self.rooms.is_empty()) else {
            return false;
        };
        let (strategy, light) = (&*frame.view.strategy, &shot.light);
        let below =
            |[low, _]: [f64; 2], high: f64| matches!(light, Light::Star { .. }) || low < high;
        let thrown = light.thrown(strategy, of);
        self.rooms.iter().any(|(around, high)| {
            let heights = thrown.heights(around);
            heights.is_some_and(|heights| below(heights, *high))
        })
    }
}
