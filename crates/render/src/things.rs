//! What grows and stands on chunks, as meshes in the pages of the land.
//!
//! All that stands on a chunk is one mesh, so that it is culled, hidden, carried into the space, lit and shadowed as the chunk's
//! land is, and costs a call nothing. It is made from the shapes of `antipode_plants` in one of their sizes, by how large
//! a metre of the chunk is in the picture. No edge is long and no triangle is a card: what is far off is a solid of a dozen
//! triangles, which every map of the space bends as it does land.

use antipode_frame::{Frame, Quality};
use antipode_geometry::tiled::as_seen_from;
use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_plants::{Age, Size, Species, shape};
use antipode_terrain::{Level, Thing};
use glam::{DVec3, Vec3};

use crate::baked::{Baked, MARGIN_M};
use crate::block_sight::BlockSight;
use crate::chunk_store::{ChunkStore, GpuChunk};
use crate::draw_list::DrawList;
use crate::land_mesh::LandMesh;
use crate::low_growth::{MOVED_M, Reach};
use crate::pages::Pages;
use crate::parts::Block;
use crate::plan::{ChunkChoice, FramePlan};
use crate::renderer::Preset;
use crate::shadow::{Caster, Shadows};
use crate::terrain_pipelines::{ShadowReach, TerrainPipelines};
use crate::touched::Touched;
use crate::uniforms::ChunkInstance;

/// From so many pixels a metre on things are shown in each size but the last: for cards, and for the processor, to which a
/// corner is as dear as a hundred pixels.
const CARD_PX: [f64; 3] = [24.0, 5.0, 2.5];
const SOFTWARE_PX: [f64; 3] = [64.0, 12.0, 3.0];
/// Where a thing is drawn by fewer triangles than now only if a metre has this share of those pixels: on the line between two
/// sizes it does not flip to and fro.
const COARSER_SHARE: f64 = 0.8;
/// The fast quality has them coarser, as if they were smaller.
const FAST_SHARE: f64 = 0.6;
/// Nearer than this the things of a chunk are looked at one by one, metres.
const SINGLY_M: f64 = 64.0;
/// Corners of things that a frame makes at most, but for one chunk's: a third of a millisecond.
const CORNERS: usize = 16_000;
/// How much wider a box is than its thing: leaves sway.
const SLACK_M: f64 = 0.3;
/// The things of a chunk on the adapter.
#[derive(Debug)]
pub struct Grown {
    /// In which size each of them is shown.
    sizes: Vec<Size>,
    /// That of all, where it is one.
    common: Option<Size>,
    /// The middle of their roots, metres from the corner of their chunk.
    middle: DVec3,
    mesh: LandMesh,
    /// What throws their shadow, where that is another.
    shadow: Option<LandMesh>,
}

/// What a thing is, if it is known.
pub fn kind_of(thing: &Thing) -> Option<(Species, Age)> {
    Some((Species::of_byte(thing.species)?, Age::of_byte(thing.age)?))
}

/// A box of land with what stands on it: `origin` is the chunk's corner.
pub fn with_things(land: [DVec3; 2], origin: DVec3, things: &[Thing]) -> [DVec3; 2] {
    let known = things.iter().filter_map(|it| Some((it, kind_of(it)?)));
    known.fold(land, |[low, high], (thing, (species, age))| {
        let scale = f64::from(thing.scale);
        let around_m = species.radius_m(age) * scale * 1.2 + SLACK_M;
        let over_m = species.height_m(age) * scale * 1.2 + SLACK_M;
        let root = origin + thing.root.as_dvec3();
        [
            low.min(root - DVec3::new(around_m, 0.0, around_m)),
            high.max(root + DVec3::new(around_m, over_m, around_m)),
        ]
    })
}

/// The box of those that stand on one mesh of a chunk and not on another; nothing where all do.
pub fn changed(coord: ChunkCoord, old: &[Thing], new: &[Thing]) -> Option<Touched> {
    let only = |these: &[Thing], others: &[Thing]| -> Vec<Thing> {
        let is_only = |it: &&Thing| !others.contains(it);
        these.iter().filter(is_only).copied().collect()
    };
    let all = [only(old, new), only(new, old)].concat();
    let nothing = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let [min, max] = with_things(nothing, coord.origin(), &all);
    min.is_finite().then_some(Touched {
        of: Caster {
            chart: coord.chart,
            min,
            max,
        },
        is_edited: true,
    })
}

/// The size for a metre of so many pixels, of things that are shown in a size before.
fn size_for(metre_px: f64, thresholds_px: [f64; 3], before: Option<Size>) -> Size {
    let from = |px: f64, size: Size| {
        let is_finer = before.is_some_and(|before| before <= size);
        metre_px >= if is_finer { COARSER_SHARE * px } else { px }
    };
    let mut sizes = Size::ALL.into_iter().zip(thresholds_px);
    let found = sizes.find(|(size, px)| from(*px, *size));
    found.map_or(Size::Far, |(size, _)| size)
}

/// From so many pixels a metre on things are shown in each size but the last.
fn thresholds_px(quality: Quality, preset: Preset) -> [f64; 3] {
    let least = match preset {
        Preset::Software => SOFTWARE_PX,
        Preset::Card => CARD_PX,
    };
    match quality {
        Quality::Fast => least.map(|px| px / FAST_SHARE),
        Quality::Balanced | Quality::Exact => least,
    }
}

impl Grown {
    /// Things in these sizes; nothing of a chunk without.
    fn of(
        things: &[Thing],
        sizes: Vec<Size>,
        eye: Option<Vec3>,
        pages: &mut Pages,
    ) -> Option<Self> {
        if things.is_empty() {
            return None;
        }
        let mesh = Baked::of(things, sizes.iter().copied(), eye).put(pages);
        // Nobody counts the leaves of a shadow.
        let of_shadow = || sizes.iter().map(|size| (*size).max(Size::Middle));
        let has_near = sizes.contains(&Size::Near);
        let shadow = has_near.then(|| Baked::of(things, of_shadow(), None).put(pages));
        let first = *sizes.first()?;
        Some(Self {
            common: sizes.iter().all(|size| *size == first).then_some(first),
            middle: mean_root(things),
            sizes,
            mesh,
            shadow,
        })
    }

    /// Things that nobody has looked at yet.
    pub fn far(things: &[Thing], pages: &mut Pages) -> Option<Self> {
        Self::of(things, vec![Size::Far; things.len()], None, pages)
    }

    /// Gives its room back.
    pub fn give_back(self, pages: &mut Pages) {
        self.mesh.give_back(pages);
        if let Some(shadow) = self.shadow {
            shadow.give_back(pages);
        }
    }

    /// The mesh, and whether all of it is in the last size, in which nothing of what it is made of is seen.
    fn mesh(&self) -> (&LandMesh, bool) {
        (&self.mesh, self.common == Some(Size::Far))
    }

    /// Whether its things, which these are, have the sizes that they are shown in.
    fn fits(&self, things: &[Thing], scale: &Scale) -> bool {
        if let (None, Some(size)) = (scale.eye, self.common) {
            return scale.size_of_all(size) == size;
        }
        let mut pairs = things.iter().zip(&self.sizes);
        pairs.all(|(thing, size)| scale.size(thing, *size) == *size)
    }

    /// Lists what throws their shadow, for a map whose matrix begins at a place of the chart, metres; returns its triangles.
    pub fn list_caster(
        &self,
        coord: ChunkCoord,
        chart: u32,
        from: DVec3,
        list: &mut DrawList,
    ) -> usize {
        let caster = self.shadow.as_ref().unwrap_or(&self.mesh);
        let corner = coord.origin() - f64::from(MARGIN_M);
        let instance = ChunkInstance::new(corner, from).past_rim();
        list.add(chart, instance, caster.pieces(0).map(|piece| (0, piece)));
        caster.triangles()
    }
}

/// What falls on the things of a chunk, and what bends them.
#[derive(Clone, Copy, Debug)]
pub struct ThingsLight {
    preset: Preset,
    reach: ShadowReach,
    by_figures: bool,
    lights: [u32; 3],
    pressers: u32,
}

impl ThingsLight {
    /// Lists a mesh that is told from [`MARGIN_M`] before its chunk's corner, carried as the chunk is, but past the edge of its
    /// chart as well; returns how many triangles are out of the picture.
    fn list(
        self,
        (mesh, is_far): (&LandMesh, bool),
        sight: &BlockSight<'_>,
        coord: ChunkCoord,
        choice: &ChunkChoice,
        list: &mut DrawList,
        chart: u32,
    ) -> usize {
        let corner = coord.origin() - f64::from(MARGIN_M);
        let corner = ChartPoint::new(coord.chart, corner);
        let instance = ChunkInstance::at(sight.frame, corner, &choice.port)
            .bent(self.pressers, self.by_figures)
            .lit(self.lights, Level::FULL);
        let number = TerrainPipelines::number_of_plants(
            choice,
            self.preset,
            is_far,
            self.reach,
            self.lights,
        );
        let shown = |block: &Block| sight.shown(coord, block).map(|_| number);
        let (pieces, left_out) = mesh.pieces_seen(0, number, shown);
        list.add(chart, instance, pieces.into_iter());
        left_out
    }

    /// What may throw a shadow on them, and the lamps and beams that may light them.
    pub fn of(preset: Preset, shadows: &Shadows, reach: ShadowReach, lights: [u32; 3]) -> Self {
        // Where branches cost, no shadow of a figure is looked for on leaves: few would see it there.
        let looked_for = match reach {
            ShadowReach::All | ShadowReach::Land => ShadowReach::Land,
            ShadowReach::Nothing => reach,
        };
        Self {
            preset,
            reach: shadows.told_apart(looked_for),
            by_figures: reach == ShadowReach::All,
            lights,
            pressers: 0,
        }
    }

    /// The same of things that these bend, a bit for each.
    #[must_use]
    pub fn bent_by(self, pressers: u32) -> Self {
        Self { pressers, ..self }
    }
}

impl ChunkStore {
    /// Shows what stands on a new mesh, as it was before where it is the same.
    pub(crate) fn plant(&mut self, coord: ChunkCoord, old: Option<&mut GpuChunk>) {
        let Some(chunk) = self.chunks.get_mut(&coord) else {
            return;
        };
        let (things, tufts) = (&chunk.source.things, &chunk.source.tufts);
        let before = old.and_then(|old| {
            let is_same = old.source.tufts == *tufts;
            // Until the new one is made there would be bare ground.
            let low = old.low.take_if(|_| !tufts.is_empty());
            chunk.low = low.map(|it| if is_same { it } else { it.outdated() });
            let is_same = old.source.things == *things;
            old.grown.take_if(|_| is_same)
        });
        chunk.grown = before.or_else(|| Grown::far(things, &mut self.pages));
    }

    /// Shows the things of the chunks that are drawn in the sizes that they have in the picture, the nearest first, as many as
    /// a frame has time for.
    pub fn grow(&mut self, frame: &Frame, plan: &FramePlan, preset: Preset) {
        self.preset = preset;
        let thresholds_px = thresholds_px(frame.view.quality, preset);
        self.renew_fallen(frame);
        let land = self.land();
        let mut left = if self.rush { usize::MAX } else { CORNERS };
        let reach = Reach::of(frame.view.quality, preset);
        self.wither(frame, reach);
        // Neither keeps the other from growing.
        let mut left_low = left;
        let moved_m = if self.rush { 0.0 } else { MOVED_M };
        for choice in &plan.chunks {
            let chunk = &land.land()[choice.place];
            let Some(grown) = self.chunks.get_mut(&chunk.coord) else {
                continue;
            };
            let eye = (choice.distance_m < SINGLY_M)
                .then(|| {
                    let middle = ChartPoint::new(chunk.coord.chart, chunk.coord.centre());
                    as_seen_from(&*frame.view.strategy, middle, frame.view.eye.point)
                })
                .flatten();
            let eye = eye.map(|eye| (eye - chunk.coord.origin()).as_vec3());
            if let Some(eye) =
                eye.filter(|_| choice.distance_m < f64::from(reach.m) && left_low > 0)
            {
                let made = grown.sprout(eye, reach, moved_m, &mut self.pages);
                left_low = left_low.saturating_sub(made);
            }
            let Some(shown) = grown.grown.as_ref().filter(|_| left > 0) else {
                continue;
            };
            let middle = chunk.coord.origin() + shown.middle;
            let middle = ChartPoint::new(chunk.coord.chart, middle);
            let scale = Scale {
                metre_px: plan.bounds.metre_px_at(frame, middle),
                near_px: plan.bounds.near_px(),
                thresholds_px,
                eye,
            };
            left = left.saturating_sub(grown.grow(&scale, &mut self.pages));
        }
    }
}

/// The middle of some things, metres from the corner of their chunk.
fn mean_root(things: &[Thing]) -> DVec3 {
    let sum: DVec3 = things.iter().map(|it| it.root.as_dvec3()).sum();
    sum / things.len().max(1) as f64
}

/// How large the things of a chunk are in a picture.
struct Scale {
    /// How many pixels a metre takes amid the things of the chunk.
    metre_px: f64,
    /// How many one takes that is a metre off.
    near_px: f64,
    /// See [`thresholds_px`].
    thresholds_px: [f64; 3],
    /// Where the eye is, of a chunk so near that its things differ: metres from its corner.
    eye: Option<Vec3>,
}

impl Scale {
    fn size(&self, thing: &Thing, before: Size) -> Size {
        let Some(eye) = self.eye else {
            return self.size_of_all(before);
        };
        let away_m = thing.root.distance(eye).max(1.0);
        let px = self.near_px / f64::from(away_m);
        size_for(px, self.thresholds_px, Some(before))
    }

    /// The size that all have of a chunk that is not near.
    fn size_of_all(&self, before: Size) -> Size {
        size_for(self.metre_px, self.thresholds_px, Some(before))
    }
}

impl GpuChunk {
    /// Lists what grows on it; returns how many triangles are out of the picture.
    pub fn list_growth(
        &self,
        sight: &BlockSight<'_>,
        choice: &ChunkChoice,
        light: ThingsLight,
        list: &mut DrawList,
        chart: u32,
    ) -> usize {
        let grown = self.grown.as_ref().map(Grown::mesh);
        let low = self.low.as_ref().map(|it| (it.mesh(), false));
        let meshes = [grown, low].into_iter().flatten();
        let left_out =
            meshes.map(|mesh| light.list(mesh, sight, self.land.coord, choice, list, chart));
        left_out.sum()
    }

    /// Shows its things in the sizes that they have; returns how many corners that took.
    fn grow(&mut self, scale: &Scale, pages: &mut Pages) -> usize {
        let Some(before) = &self.grown else { return 0 };
        let things = &self.source.things;
        if before.fits(things, scale) {
            return 0;
        }
        let pairs = things.iter().zip(&before.sizes);
        let sizes: Vec<_> = pairs
            .map(|(thing, size)| scale.size(thing, *size))
            .collect();
        let corners = things.iter().zip(&sizes).filter_map(|(thing, size)| {
            let (species, age) = kind_of(thing)?;
            Some(shape(species, age, *size).corners.len())
        });
        let corners = corners.sum();
        if let Some(before) = self.grown.take() {
            before.give_back(pages);
        }
        self.grown = Grown::of(things, sizes, scale.eye, pages);
        corners
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_between_two_sizes_keeps_the_one_that_it_has() {
        use Size::{Coarse, Far, Middle, Near};
        let size_for = |px, before| size_for(px, CARD_PX, before);
        let [near_px, middle_px, coarse_px] = CARD_PX;
        assert_eq!(
            [1.0, 3.0, 6.0, 60.0].map(|px| size_for(px, None)),
            [Far, Coarse, Middle, Near]
        );
        let at = |px: f64| [Far, Coarse, Middle, Near].map(|before| size_for(px, Some(before)));
        assert_eq!(at(0.9 * near_px), [Middle, Middle, Middle, Near]);
        assert_eq!(at(0.9 * middle_px), [Coarse, Coarse, Middle, Middle]);
        assert_eq!(at(0.9 * coarse_px), [Far, Coarse, Coarse, Coarse]);
        assert_eq!(at(0.7 * coarse_px), [Far; 4]);
    }

    #[test]
    fn shadows_are_told_of_what_was_felled_and_of_nothing_else() {
        let at = |x: f32| Thing {
            root: Vec3::new(x, 4.0, 8.0),
            slot: x as u8,
            species: Species::Oak.byte(),
            age: Age::Grown.byte(),
            turn_rad: 0.0,
            scale: 1.0,
        };
        let coord = ChunkCoord::new(antipode_geometry::ChartId::FIRST, glam::IVec3::X);
        assert!(changed(coord, &[at(1.0), at(9.0)], &[at(9.0), at(1.0)]).is_none());
        let gone = changed(coord, &[at(1.0), at(9.0)], &[at(9.0)]);
        let middle = gone.map(|it| it.of.middle()).unwrap_or_default();
        assert!((middle.x - 33.0).abs() < 0.01 && middle.y > 6.0, "{middle}");
    }

    #[test]
    fn things_lie_within_their_box_and_reach_of_their_vertices() {
        for species in Species::ALL {
            for age in Age::ALL {
                for (corner, turn_rad) in [(0.0, 0.3), (31.9, 2.0)] {
                    let thing = Thing {
                        root: Vec3::new(corner, 12.0, corner),
                        slot: 0,
                        species: species.byte(),
                        age: age.byte(),
                        turn_rad,
                        scale: 1.14,
                    };
                    let root = thing.root.as_dvec3();
                    let [low, high] = with_things([root; 2], DVec3::ZERO, &[thing]);
                    for vertex in Baked::of(&[thing], [Size::Near].into_iter(), None).vertices {
                        let place = vertex.position().as_dvec3() - f64::from(MARGIN_M);
                        let is_in = place.cmple(high) & place.with_y(high.y).cmpge(low);
                        assert!(is_in.all(), "{species:?} {age:?}: {place} in {low} {high}");
                    }
                }
            }
        }
    }
}
