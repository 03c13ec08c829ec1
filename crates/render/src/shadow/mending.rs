//! Ground that somebody digs or builds on: the maps follow it in the same frame.
//!
//! Ground that was dug lies behind what a map has there and would be dark until the map is drawn anew, which takes some
//! frames; while a button is held, that never ends. So the rectangle of a map that an edit falls on is emptied and drawn
//! again at once, from the land as it is. That is done to the finest map that the place is read from, and to the next
//! where it may be read as well; others are drawn anew as for any land that comes.

use antipode_frame::Frame;

use super::caster::Caster;
use super::levels::Shot;
use super::light::{Crop, Light, Rectangle};
use super::{MapTarget, Over, ShadowSources, Shadows};
use crate::touched::Touched;

/// A map alone is read as far as this part of its half side: `SHADOW_EDGE` less `SHADOW_BLEND` of shadow.wgsl.
const READ_ALONE: f64 = 0.7;

impl Shadows {
    /// Takes note of land that is not what it was, and has the maps follow edits; returns the triangles that this takes.
    pub(super) fn follow(
        &mut self,
        frame: &Frame,
        land: &mut ShadowSources<'_>,
        touched: &[Touched],
    ) -> usize {
        let mut used = 0;
        for number in 0..self.levels.len() {
            let mut hole = None;
            for it in touched {
                if !(it.is_edited && self.is_read(number, frame, &it.of)) {
                    self.note(number, frame, &it.of);
                } else if let Some(shot) = self.levels[number].shot
                    && shot.shows(frame, &it.of)
                {
                    hole = Some(joined(hole, shot.rectangle(frame, &it.of)));
                    // What was built higher than the map holds is missing until it is drawn anew.
                    if !shot.holds(frame, &it.of) {
                        self.note(number, frame, &it.of);
                    }
                }
            }
            used += self.mend(number, frame, land, hole);
            self.spoil(number, frame, touched);
        }
        used
    }

    /// Whether a level is read where a box is: whether the finer one is not enough.
    fn is_read(&self, number: usize, frame: &Frame, of: &Caster) -> bool {
        let finer = match self.levels[number].shot.map(|shot| shot.light) {
            None => return false,
            Some(_) if number == 0 => return true,
            Some(Light::Far { .. }) => number - 1,
            Some(Light::Star { .. }) => 0,
        };
        let Some(shot) = self.levels[finer].shot else {
            return true;
        };
        let [low, high] = shot.rectangle(frame, of);
        let inner = READ_ALONE * shot.crop.half;
        let [from, to] = [shot.crop.centre - inner, shot.crop.centre + inner];
        low.cmplt(from).any() || high.cmpgt(to).any()
    }

    /// Draws a rectangle of a map that is shown anew.
    fn mend(
        &mut self,
        number: usize,
        frame: &Frame,
        land: &mut ShadowSources<'_>,
        hole: Option<Rectangle>,
    ) -> usize {
        let (Some(hole), Some(shot)) = (hole, self.levels[number].shot) else {
            return 0;
        };
        let has_pass = self.has_pass();
        let level = &mut self.levels[number];
        level.is_mended = true;
        if !has_pass {
            level.changed.get_or_insert(0);
            return 0;
        }
        let target = MapTarget {
            shot: &shot,
            layer: level.layer,
        };
        self.fill(frame, land, target, hole)
    }

    /// Has a map in the making follow edits when all else is on it.
    fn spoil(&mut self, number: usize, frame: &Frame, touched: &[Touched]) {
        for job in self.jobs.iter_mut().flatten() {
            let edited = touched.iter().filter(|it| it.is_edited);
            for it in edited.filter(|it| job.level == number && job.shot.shows(frame, &it.of)) {
                job.hole = Some(joined(job.hole, job.shot.rectangle(frame, &it.of)));
            }
        }
    }

    /// Plans a pass that empties a rectangle of a layer and draws the land there; returns its triangles.
    pub(super) fn fill(
        &mut self,
        frame: &Frame,
        land: &mut ShadowSources<'_>,
        target: MapTarget<'_>,
        hole: Rectangle,
    ) -> usize {
        let shot = target.shot;
        let Some((texels, part)) = self.texels_of(shot, hole) else {
            return 0;
        };
        let falls = |of: &Caster| {
            shot.light
                .heights(&*frame.view.strategy, &part, of)
                .is_some()
        };
        let casters = land.chunks.casters().filter(|(_, of)| falls(of));
        let mut todo: Vec<_> = casters.map(|(coord, _)| coord).collect();
        self.pass(
            frame,
            target,
            Over::Hole(texels),
            land,
            &mut todo,
            usize::MAX,
        )
    }

    /// The texels of a map in which a rectangle lies, and a square about it; nothing where it lies outside.
    fn texels_of(&self, shot: &Shot, [low, high]: Rectangle) -> Option<([u32; 4], Crop)> {
        let size = self.maps.texels;
        let crop = &shot.crop;
        let texel = 2.0 * crop.half / f64::from(size);
        let corner = crop.centre - crop.half;
        let first = ((low - corner) / texel).floor() - 1.0;
        let last = ((high - corner) / texel).ceil() + 1.0;
        let within = |v: f64| v.clamp(0.0, f64::from(size));
        let [x0, y0, x1, y1] = [first.x, first.y, last.x, last.y].map(within);
        if x0 >= x1 || y0 >= y1 {
            return None;
        }
        // Rows run down, from the map's upper end.
        let rows = [f64::from(size) - y1, f64::from(size) - y0];
        let texels = [x0, rows[0], x1 - x0, rows[1] - rows[0]].map(|v| v as u32);
        let half = 0.5 * (last - first).max_element() * texel;
        let centre = corner + 0.5 * (first + last) * texel;
        Some((
            texels,
            Crop {
                centre,
                half,
                ..*crop
            },
        ))
    }
}

impl Shot {
    fn shows(&self, frame: &Frame, of: &Caster) -> bool {
        let heights = self.light.heights(&*frame.view.strategy, &self.crop, of);
        heights.is_some()
    }

    /// Whether its depth reaches as high as a box does.
    fn holds(&self, frame: &Frame, of: &Caster) -> bool {
        let heights = self.light.heights(&*frame.view.strategy, &self.crop, of);
        heights.is_none_or(|[_, high]| high <= self.highest())
    }

    /// Where a box falls on its plane; all of the map where that cannot be said.
    fn rectangle(&self, frame: &Frame, of: &Caster) -> Rectangle {
        let Crop { face, centre, half } = self.crop;
        let found = self.light.rectangle(&*frame.view.strategy, face, of);
        found.unwrap_or([centre - half, centre + half])
    }
}

fn joined(a: Option<Rectangle>, b: Rectangle) -> Rectangle {
    a.map_or(b, |[low, high]| [low.min(b[0]), high.max(b[1])])
}
