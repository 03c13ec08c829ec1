//! The level of detail of each chunk: the coarsest that the picture cannot tell from the full one, and
//! no two neighbours more than one level apart.

use std::collections::HashMap;
use std::hash::BuildHasher;

use antipode_geometry::tiled::beside;
use antipode_geometry::{Atlas, ChunkCoord};
use antipode_terrain::Level;
use glam::IVec3;

/// A chunk becomes coarser than it is only if the error would stay under this share of what is let
/// pass: on the line between two levels neither it nor its neighbours flip to and fro.
const COARSER_SHARE: f64 = 0.8;

/// The six chunks that share a face with one, over edges of tiles, too.
pub(crate) fn faces(atlas: &dyn Atlas, coord: ChunkCoord) -> impl Iterator<Item = ChunkCoord> {
    let steps = IVec3::AXES.into_iter().flat_map(|axis| [-axis, axis]);
    steps.map(move |step| beside(atlas, coord, step))
}

/// The coarsest level whose error stays under `tolerance_px`, given each level's error in metres
/// and the pixels that a metre takes; `before` is what the chunk has now.
pub(crate) fn choose(
    errors_m: &[f64; Level::ALL.len()],
    pixels_per_metre: f64,
    tolerance_px: f64,
    before: Option<Level>,
) -> Level {
    let passes = |level: &Level| {
        let coarsens = before.is_some_and(|before| *level > before);
        let share = if coarsens { COARSER_SHARE } else { 1.0 };
        errors_m[level.index()] * pixels_per_metre < tolerance_px * share
    };
    let coarser = Level::ALL.into_iter().skip(1);
    coarser.take_while(passes).last().unwrap_or(Level::FULL)
}

/// Makes levels finer until no two chunks with a common face are more than one apart. Nothing is
/// made finer than that takes.
pub(crate) fn relax<S: BuildHasher>(atlas: &dyn Atlas, levels: &mut HashMap<ChunkCoord, Level, S>) {
    for level in Level::ALL {
        let Some(limit) = level.coarser() else { return };
        let here: Vec<_> = levels
            .iter()
            .filter_map(|(&coord, &own)| (own == level).then_some(coord))
            .collect();
        for coord in here {
            for next in faces(atlas, coord) {
                if let Some(own) = levels.get_mut(&next) {
                    *own = limit.min(*own);
                }
            }
        }
    }
}

/// The levels that a chunk may have beside neighbours of the given levels, from finest to coarsest;
/// `None` where they are too far apart for any.
pub(crate) fn allowed(beside: impl Iterator<Item = Level>) -> Option<(Level, Level)> {
    let (mut finest, mut coarsest) = (Level::FULL, Level::ALL[Level::ALL.len() - 1]);
    for level in beside {
        finest = finest.max(level.finer().unwrap_or(Level::FULL));
        coarsest = coarsest.min(level.coarser().unwrap_or(level));
    }
    (finest <= coarsest).then_some((finest, coarsest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use antipode_geometry::{ChartId, Euclidean};
    use proptest::prelude::*;

    const ERRORS_M: [f64; 4] = [0.0, 0.25, 0.75, 2.0];

    fn chunk(index: IVec3) -> ChunkCoord {
        ChunkCoord {
            chart: ChartId::FIRST,
            index,
        }
    }

    #[test]
    fn the_coarsest_level_that_cannot_be_seen_is_chosen() {
        let at = |pixels| choose(&ERRORS_M, pixels, 0.5, None).index();
        assert_eq!([9.0, 1.9, 0.6, 0.2, 0.0].map(at), [0, 1, 2, 3, 3]);
        assert_eq!(at(f64::INFINITY), 0);
        assert_eq!(choose(&ERRORS_M, 0.1, 0.0, None), Level::FULL);
        assert_eq!(
            choose(&[0.0, f64::NAN, 0.0, 0.0], 0.1, 0.5, None),
            Level::FULL
        );
    }

    #[test]
    fn on_the_line_between_two_levels_a_chunk_stays_at_the_one_it_has() {
        let line = 0.5 / ERRORS_M[1];
        for before in [Level::ALL[0], Level::ALL[1]] {
            for pixels in [0.95 * line, 0.85 * line, 0.99 * line] {
                assert_eq!(choose(&ERRORS_M, pixels, 0.5, Some(before)), before);
            }
        }
        assert_eq!(
            choose(&ERRORS_M, 0.7 * line, 0.5, Some(Level::FULL)),
            Level::ALL[1]
        );
        assert_eq!(
            choose(&ERRORS_M, 1.1 * line, 0.5, Some(Level::ALL[1])),
            Level::FULL
        );
    }

    #[test]
    fn neighbours_too_far_apart_allow_no_level() {
        let between = |levels: &[usize]| {
            let found = allowed(levels.iter().map(|&n| Level::ALL[n]));
            found.map(|(fine, coarse)| (fine.index(), coarse.index()))
        };
        assert_eq!(between(&[]), Some((0, 3)));
        assert_eq!(between(&[0, 1]), Some((0, 1)));
        assert_eq!(between(&[3, 2, 3]), Some((2, 3)));
        assert_eq!(between(&[1, 3]), Some((2, 2)));
        assert_eq!(between(&[0, 3]), None);
    }

    proptest! {
        #[test]
        fn relaxed_levels_differ_by_one_at_most_and_are_the_coarsest_such(
            raw in proptest::collection::vec(0..4_usize, 125)
        ) {
            let places: Vec<_> = (0..125).map(|n| IVec3::new(n / 25, n / 5 % 5, n % 5)).collect();
            let mut levels: HashMap<_, _> =
                places.iter().zip(&raw).map(|(&at, &n)| (chunk(at), Level::ALL[n])).collect();
            relax(&Euclidean, &mut levels);
            for &at in &places {
                // The least of all raw levels plus the steps to them: the distance transform.
                let want = places.iter().zip(&raw).map(|(&other, &n)| {
                    n + (at - other).abs().element_sum() as usize
                });
                prop_assert_eq!(Some(levels[&chunk(at)].index()), want.min());
            }
        }
    }
}
