//! Draws further views of what a frame shows, each with targets of its own.

use antipode_frame::Frame;
use wgpu::CommandEncoder;

use super::view_state::{LandSource, Part, Shared, ViewState};
use super::{DrawStats, FurtherView, Renderer, ViewTarget};
use crate::targets::drawn_size;
use crate::tonemap::MirrorPlace;

impl Renderer {
    /// Draws further views of a frame that was drawn.
    pub(super) fn draw_further(
        &mut self,
        frame: &Frame,
        further: &[FurtherView<'_>],
        encoder: &mut CommandEncoder,
    ) -> Vec<DrawStats> {
        self.fit_further(further);
        let land_index = self.chunks.land();
        let mut states = std::mem::take(&mut self.further);
        let views = further.iter().zip(&mut states);
        let stats = views.map(|(it, state)| {
            let frame = frame.seen_by(it.view.clone());
            let map = self.map_of_further(&frame);
            state.mirror = None;
            let Some(pipelines) = self.pipelines.get(map) else {
                return DrawStats::nothing();
            };
            let mut plan = state.plan(&frame, it.size.1, &land_index);
            let (device, queue) = (&self.device, &self.queue);
            state.take_figures(device, queue, &frame, &self.figures, &mut plan, None);
            let land = LandSource {
                chunks: &self.chunks,
                index: &land_index,
                shadows: &self.shadows,
            };
            let drawn = state.targets.size;
            state.take_land(device, queue, &frame, land, &mut plan, drawn);
            let mut stats = self.planned(&plan);
            let scenery = self.scenery(pipelines);
            state.draw(&frame, scenery, encoder, Part::default(), None, &mut stats);
            match it.target {
                ViewTarget::Texture(target) => {
                    self.tonemap.draw(encoder, &state.light, target, None);
                }
                ViewTarget::Mirror(corner) => {
                    let size = it.size;
                    state.mirror = Some(MirrorPlace { corner, size });
                }
            }
            stats
        });
        let stats = stats.collect();
        self.further = states;
        stats
    }

    /// Has targets for so many further views, as large as they are.
    fn fit_further(&mut self, further: &[FurtherView<'_>]) {
        self.further.truncate(further.len());
        for (place, it) in further.iter().enumerate() {
            let (width, height) = it.size;
            let size = drawn_size(width, height, self.options.scale, self.largest_side());
            let samples = self.options.samples;
            match self.further.get_mut(place) {
                Some(state) if state.targets.size == size => {}
                Some(state) => state.fit(&self.device, &self.tonemap, size, samples),
                None => {
                    let shared = Shared {
                        heavens: &self.heavens,
                        shadows: &self.shadows,
                    };
                    let (device, tonemap) = (&self.device, &self.tonemap);
                    let land = self.picture.more_land();
                    let state = ViewState::new(device, shared, tonemap, land, size, samples);
                    self.further.push(state);
                }
            }
        }
    }
}
