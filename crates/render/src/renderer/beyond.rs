//! Draws what is seen through the openings of a frame, before the frame itself: one view for each that is in the picture, as
//! large as the picture, of which only the rectangle about the opening is drawn.

use antipode_frame::Frame;
use wgpu::CommandEncoder;

use super::view_state::{LandSource, Part, Shared, ViewState};
use super::{DrawStats, Renderer};
use crate::openings::{Beyond, place_of};

/// What lies beyond the openings.
pub(super) fn of(states: &[ViewState]) -> Vec<Beyond<'_>> {
    states
        .iter()
        .map(|state| Beyond {
            light: &state.light,
            is_drawn: state.is_drawn,
        })
        .collect()
}

impl Renderer {
    /// Draws the other side of each opening that is in the picture; a door that is seen there shows haze.
    pub(super) fn draw_beyond(
        &mut self,
        frame: &Frame,
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) {
        self.fit_openings(frame.openings.len());
        let mut states = std::mem::take(&mut self.openings);
        for (opening, state) in frame.openings.iter().zip(&mut states) {
            let size = state.targets.size;
            let whole = self.tile.map_or(size, |tile| tile.whole);
            let place = place_of(frame, opening, whole);
            state.is_drawn = false;
            let Some(place) = place else { continue };
            let mut beyond = frame.seen_by(opening.view.clone());
            // Of the pair, the one that is looked through may be seen again; the other is the edge of what is drawn.
            beyond.openings.push(opening.clone());
            let map = self.map_of_further(&beyond);
            let Some(pipelines) = self.pipelines.get(map) else {
                continue;
            };
            let land_index = self.chunks.land();
            let height_px = self.tile.map_or(self.height_px, |tile| tile.whole.1);
            let mut plan = state.plan(&beyond, height_px, &land_index);
            let (device, queue) = (&self.device, &self.queue);
            state.take_figures(device, queue, &beyond, &self.figures, &mut plan, None);
            let land = LandSource {
                chunks: &self.chunks,
                index: &land_index,
                shadows: &self.shadows,
            };
            state.take_land(device, queue, &beyond, land, &mut plan, whole);
            let haze = [Beyond {
                light: &self.picture.light,
                is_drawn: false,
            }];
            let part = Part {
                tile: self.tile,
                seen: self.tile.is_none().then_some(place),
                beyond: &haze,
            };
            let scenery = self.scenery(pipelines);
            state.draw(&beyond, scenery, encoder, part, None, stats);
            state.is_drawn = true;
        }
        self.openings = states;
    }

    /// Has targets for so many openings, as large as the picture's.
    fn fit_openings(&mut self, count: usize) {
        self.openings.truncate(count);
        let (size, samples) = (self.picture.targets.size, self.options.samples);
        for state in &mut self.openings {
            if state.targets.size != size {
                state.fit(&self.device, &self.tonemap, size, samples);
            }
        }
        while self.openings.len() < count {
            let shared = Shared {
                heavens: &self.heavens,
                shadows: &self.shadows,
            };
            let (device, tonemap) = (&self.device, &self.tonemap);
            let land = self.picture.more_land();
            let state = ViewState::new(device, shared, tonemap, land, size, samples);
            self.openings.push(state);
        }
    }
}
