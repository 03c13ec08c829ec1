//! Draws what is seen through the openings of a frame, before the frame itself: one view for each that is in the picture, as
//! large as the picture, of which only the rectangle about the opening is drawn; and one more where that sees the opening again.

use antipode_frame::{Frame, ModelId, Opening};
use antipode_items::Item;
use wgpu::CommandEncoder;

use super::view_state::{LandSource, Part, Shared, ViewState};
use super::{DrawStats, Renderer};
use crate::openings::{Beyond, place_of};
use crate::pipeline_cache::Key;

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

/// What two rectangles have in common: x, y, width and height.
fn common(a: [u32; 4], b: [u32; 4]) -> Option<[u32; 4]> {
    let low = [0, 1].map(|axis| a[axis].max(b[axis]));
    let end = |it: [u32; 4], axis: usize| it[axis] + it[axis + 2];
    let high = [0, 1].map(|axis| end(a, axis).min(end(b, axis)));
    let is_any = low[0] < high[0] && low[1] < high[1];
    is_any.then(|| [low[0], low[1], high[0] - low[0], high[1] - low[1]])
}

impl Renderer {
    /// Has what the other sides of doors are drawn with made as soon as a door is to be seen, be it a single one or one in hand:
    /// nobody is to wait for it when the pair stands.
    pub(super) fn foresee_openings(&mut self, frame: &Frame, key: Key) {
        if self.patient {
            return;
        }
        let door = ModelId::Item(Item::Door);
        let in_hand = frame
            .view
            .hand
            .as_ref()
            .is_some_and(|hand| hand.model == door);
        if in_hand || frame.content.figures.iter().any(|it| it.model == door) {
            let cut = Key {
                is_cut: true,
                ..key
            };
            // Only what the picture itself is drawn with goes before; other maps may never be seen.
            if self.pipelines.is_made(key) {
                self.pipelines.want(cut);
            }
        }
    }

    /// Whether a world that nothing has been shown of yet has doors through which nothing can be seen yet: its veil stays down for that.
    pub(super) fn awaits_openings(&mut self, frame: &Frame, key: Key) -> bool {
        let is_shown = self.shown_world == Some(frame.content.loaded_world);
        if self.patient || self.chunks.rush || is_shown || frame.openings.is_empty() {
            return false;
        }
        let cut = Key {
            is_cut: true,
            ..key
        };
        self.awaits_map = !self.pipelines.is_made(cut);
        self.awaits_map
    }

    /// Draws the other side of each opening that is in the picture. A door that is seen there shows once more what is behind it, and
    /// one that is seen in that, haze.
    pub(super) fn draw_beyond(
        &mut self,
        frame: &Frame,
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) {
        self.fit_openings(frame.openings.len());
        let mut states = std::mem::take(&mut self.openings);
        let mut deeper = std::mem::take(&mut self.deeper);
        for (at, (opening, state)) in frame.openings.iter().zip(&mut states).enumerate() {
            state.is_drawn = false;
            let Some(place) = self.place_in(frame, opening, state.targets.size) else {
                continue;
            };
            let mut beyond = frame.seen_by(opening.view.clone());
            // Of the pair, the one that is looked through may be seen again; the other is the edge of what is drawn.
            beyond.openings.push(opening.clone());
            let below = self.draw_again(&beyond, opening, place, &mut deeper[at], encoder, stats);
            let shows = Beyond {
                light: &below.as_ref().unwrap_or(&self.picture.light).clone(),
                is_drawn: below.is_some(),
            };
            state.is_drawn = self.draw_side(&beyond, state, place, shows, encoder, stats);
        }
        self.openings = states;
        self.deeper = deeper;
    }

    /// Draws what an opening shows where it is seen through itself, within the rectangle that is drawn of that; returns its light.
    fn draw_again(
        &mut self,
        beyond: &Frame,
        opening: &Opening,
        within: [u32; 4],
        state: &mut Option<ViewState>,
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) -> Option<wgpu::BindGroup> {
        let view = opening.again.as_deref()?;
        let size = self.picture.targets.size;
        let place = common(within, self.place_in(beyond, opening, size)?)?;
        let state = state.get_or_insert_with(|| self.another_state());
        let frame = {
            let mut frame = beyond.seen_by(view.clone());
            frame.openings.push(opening.clone());
            frame
        };
        let haze = self.picture.light.clone();
        let shows = Beyond {
            light: &haze,
            is_drawn: false,
        };
        let is_drawn = self.draw_side(&frame, state, place, shows, encoder, stats);
        is_drawn.then(|| state.light.clone())
    }

    /// The rectangle of a picture of that size, or of the larger one that it is a part of, that an opening takes.
    fn place_in(&self, frame: &Frame, opening: &Opening, size: (u32, u32)) -> Option<[u32; 4]> {
        place_of(frame, opening, self.tile.map_or(size, |tile| tile.whole))
    }

    /// Draws a view of another side within a rectangle; returns whether it could be.
    fn draw_side(
        &mut self,
        frame: &Frame,
        state: &mut ViewState,
        place: [u32; 4],
        shows: Beyond<'_>,
        encoder: &mut CommandEncoder,
        stats: &mut DrawStats,
    ) -> bool {
        let map = self.map_of_further(frame);
        let Some(pipelines) = self.pipelines.get(map) else {
            return false;
        };
        let whole = self.tile.map_or(state.targets.size, |tile| tile.whole);
        let land_index = self.chunks.land();
        let height_px = self.tile.map_or(self.height_px, |tile| tile.whole.1);
        let mut plan = state.plan(frame, height_px, &land_index);
        let (device, queue) = (&self.device, &self.queue);
        state.take_figures(device, queue, frame, &self.figures, &mut plan, None);
        let land = LandSource {
            chunks: &self.chunks,
            index: &land_index,
            shadows: &self.shadows,
        };
        state.take_land(device, queue, frame, land, &mut plan, whole);
        let part = Part {
            tile: self.tile,
            seen: self.tile.is_none().then_some(place),
            beyond: &[shows],
        };
        let scenery = self.scenery(pipelines);
        state.draw(frame, scenery, encoder, part, None, stats);
        true
    }

    /// Has targets for so many openings, as large as the picture's.
    fn fit_openings(&mut self, count: usize) {
        self.openings.truncate(count);
        self.deeper.resize_with(count, || None);
        let (size, samples) = (self.picture.targets.size, self.options.samples);
        let deeper = self.deeper.iter_mut().flatten();
        for state in self.openings.iter_mut().chain(deeper) {
            if state.targets.size != size {
                state.fit(&self.device, &self.tonemap, size, samples);
            }
        }
        while self.openings.len() < count {
            self.openings.push(self.another_state());
        }
    }

    /// A view as large as the picture.
    fn another_state(&self) -> ViewState {
        let shared = Shared {
            heavens: &self.heavens,
            shadows: &self.shadows,
        };
        let (device, tonemap) = (&self.device, &self.tonemap);
        let land = self.picture.more_land();
        let (size, samples) = (self.picture.targets.size, self.options.samples);
        ViewState::new(device, shared, tonemap, land, size, samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_have_in_common_what_lies_in_both() {
        assert_eq!(common([2, 3, 10, 10], [8, 1, 9, 5]), Some([8, 3, 4, 3]));
        assert_eq!(common([2, 3, 6, 10], [8, 1, 9, 5]), None);
    }
}
