//! What grows low on chunks near the eye, as a mesh for each: grass, flowers and their like.
//!
//! Farther from the eye it is coarser, scarcer and lower, so that it ends without an edge; the mesh is made anew as the eye moves.

use antipode_frame::{Frame, Quality};
use antipode_geometry::ChartPoint;
use antipode_geometry::tiled::as_seen_from;
use antipode_plants::{Growth, low_shape};
use antipode_terrain::Tuft;
use glam::Vec3;

use crate::baked::{Baked, block_at};
use crate::chunk_store::{ChunkStore, GpuChunk};
use crate::land_mesh::LandMesh;
use crate::pages::Pages;
use crate::renderer::Preset;

/// How far from the eye it grows with a card and where the processor draws, metres, and how much of it.
const CARD: Reach = Reach {
    m: 40.0,
    share: 1.0,
};
const SOFTWARE: Reach = Reach {
    m: 20.0,
    share: 0.5,
};
/// The share of the distance in the fast quality.
const FAST_SHARE: f32 = 0.6;
/// The share of the reach within which it is fine, that from which it is scarcer, and that from which it is lower.
const FINE: f32 = 0.25;
const SCARCER: f32 = 0.35;
const LOWER: f32 = 0.7;
/// How much of it is left at the end of the reach.
const LEFT: f32 = 0.3;
/// How long the sides of its blocks are in the plan, metres.
const BLOCK_M: f32 = 8.0;
/// It is made anew when the eye has moved so far, metres.
pub const MOVED_M: f32 = 2.5;

/// How far from the eye small growth is drawn, and the share of it that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Metres.
    pub m: f32,
    share: f32,
}

impl Reach {
    /// That of a quality and a preset.
    pub fn of(quality: Quality, preset: Preset) -> Self {
        let whole = match preset {
            Preset::Card => CARD,
            Preset::Software => SOFTWARE,
        };
        match quality {
            Quality::Fast => Self {
                m: FAST_SHARE * whole.m,
                ..whole
            },
            Quality::Balanced | Quality::Exact => whole,
        }
    }
}

/// The small growth of a chunk on the adapter.
#[derive(Debug)]
pub struct LowGrowth {
    mesh: LandMesh,
    /// Where the eye was, metres from the chunk's corner, and how far it reached; nothing of one that is not what grows there any
    /// more, and is shown until the new one is made.
    made_for: Option<(Vec3, Reach)>,
}

impl LowGrowth {
    /// The mesh.
    pub fn mesh(&self) -> &LandMesh {
        &self.mesh
    }

    /// The same, to be made anew.
    #[must_use]
    pub fn outdated(self) -> Self {
        Self {
            made_for: None,
            ..self
        }
    }

    /// Gives its room back.
    pub fn give_back(self, pages: &mut Pages) {
        self.mesh.give_back(pages);
    }
}

/// How large a tuft is so far from the eye, as a share of the reach; nothing of one that is left out there.
fn size_at(tuft: &Tuft, away: f32, share: f32) -> Option<f32> {
    let scarce = ((away - SCARCER) / (1.0 - SCARCER)).max(0.0);
    let is_left = f32::from(tuft.rank) / 256.0 < share * (1.0 - scarce * (1.0 - LEFT));
    let high = 1.0 - ((away - LOWER) / (1.0 - LOWER)).max(0.0);
    // What is left stands for what is not.
    let wide = 1.0 + 0.35 * scarce;
    (is_left && high > 0.0).then(|| f32::from(tuft.size) / 256.0 * high * wide)
}

fn baked(tufts: &[Tuft], eye: Vec3, reach: Reach) -> Baked {
    let shown = tufts.iter().filter_map(|tuft| {
        let away = tuft.root.distance(eye) / reach.m;
        let size = size_at(tuft, away, reach.share)?;
        let shape = low_shape(Growth::of_byte(tuft.growth)?, away < FINE);
        Some((block_at(tuft.root, BLOCK_M), tuft, shape, size))
    });
    let mut shown: Vec<_> = shown.collect();
    shown.sort_by_key(|(block, ..)| *block);
    let mut all = Baked::default();
    for block in shown.chunk_by(|(a, ..), (b, ..)| a == b) {
        all.add_block(|all| {
            for (_, tuft, shape, size) in block {
                all.add_tuft(tuft, shape, *size);
            }
        });
    }
    all
}

impl ChunkStore {
    /// Leaves out what grows low on chunks that are out of reach.
    pub(crate) fn wither(&mut self, frame: &Frame, reach: Reach) {
        let (strategy, eye) = (&frame.view.strategy, frame.view.eye.point);
        for (coord, chunk) in &mut self.chunks {
            let Some(low) = chunk.low.take() else {
                continue;
            };
            let middle = ChartPoint::new(coord.chart, 0.5 * (chunk.land.min + chunk.land.max));
            let seen = as_seen_from(&**strategy, middle, eye);
            let away_m = seen.map_or(f64::INFINITY, |pos| {
                pos.distance(pos.clamp(chunk.land.min, chunk.land.max))
            });
            if away_m > f64::from(reach.m + MOVED_M) {
                low.give_back(&mut self.pages);
            } else {
                chunk.low = Some(low);
            }
        }
    }
}

impl GpuChunk {
    /// Shows what grows low on it within reach of an eye, which is told from the chunk's corner and may have moved so far since;
    /// returns how many corners that took.
    pub fn sprout(&mut self, eye: Vec3, reach: Reach, moved_m: f32, pages: &mut Pages) -> usize {
        let tufts = &self.source.tufts;
        if tufts.is_empty() {
            return 0;
        }
        let is_same = |it: &LowGrowth| {
            it.made_for
                .is_some_and(|(then, reached)| then.distance(eye) <= moved_m && reached == reach)
        };
        if self.low.as_ref().is_some_and(is_same) {
            return 0;
        }
        if let Some(before) = self.low.take() {
            before.give_back(pages);
        }
        let baked = baked(tufts, eye, reach);
        let corners = baked.corners();
        self.low = Some(LowGrowth {
            mesh: baked.put(pages),
            made_for: Some((eye, reach)),
        });
        corners
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_growth_is_whole_close_by_and_ends_without_an_edge() {
        let tuft = |rank| Tuft {
            root: Vec3::ZERO,
            growth: Growth::Grass.byte(),
            turn: 0,
            size: 255,
            rank,
            ground: [90, 120, 60, 6],
        };
        let left = |away| {
            (0..=255)
                .filter(|rank| size_at(&tuft(*rank), away, 1.0).is_some())
                .count()
        };
        assert_eq!(left(0.0), 256);
        assert!(left(0.6) < left(0.4) && left(0.4) < 256);
        assert!((60..100).contains(&left(0.99)), "{}", left(0.99));
        assert_eq!(left(1.0), 0);
        assert!(size_at(&tuft(200), 0.0, 0.6).is_none() && size_at(&tuft(100), 0.0, 0.6).is_some());
        let size = |away| size_at(&tuft(0), away, 1.0).unwrap_or_default();
        assert!(size(0.99) < 0.06 && size(0.5) > 0.9);
    }
}
