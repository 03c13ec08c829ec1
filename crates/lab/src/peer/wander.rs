//! Random paths over the heptagrid, as the published tests draw them.

use super::tiling::{EDGES, Tile, Tiling};
use crate::random::Numbers;

/// How often a step that comes no nearer, and one that goes farther, is taken on the way home.
const SIDEWAYS: f64 = 1.0 / 16.0;
const OUTWARDS: f64 = 1.0 / 32.0;

/// One of the edges of a tile, all alike.
pub fn any_edge(numbers: &mut Numbers) -> usize {
    let drawn = numbers.between(0.0, EDGES as f64) as usize;
    drawn.min(EDGES - 1)
}

/// From the first tile, each step over any edge, until `distance` tiles away. The path starts
/// with the first tile.
pub fn outwards(numbers: &mut Numbers, tiling: &mut Tiling, distance: u32) -> Vec<Tile> {
    let mut tile = Tiling::FIRST;
    let mut path = vec![tile];
    while tiling.distance(tile) < distance {
        tile = tiling.neighbour(tile, any_edge(numbers)).0;
        path.push(tile);
    }
    path
}

/// Out to `distance` tiles and home again, by another way as a rule: a step inwards is always
/// taken, others seldom.
pub fn loop_path(numbers: &mut Numbers, tiling: &mut Tiling, distance: u32) -> Vec<Tile> {
    let mut path = outwards(numbers, tiling, distance);
    let mut tile = path[path.len() - 1];
    while tile != Tiling::FIRST {
        let (to, _) = tiling.neighbour(tile, any_edge(numbers));
        let (before, after) = (tiling.distance(tile), tiling.distance(to));
        let chance = numbers.between(0.0, 1.0);
        if after < before
            || (after == before && chance < SIDEWAYS)
            || (after > before && chance < OUTWARDS)
        {
            tile = to;
            path.push(tile);
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_comes_home_and_goes_as_far_as_asked() {
        for seed in 0..20 {
            let mut tiling = Tiling::new();
            let path = loop_path(&mut Numbers::new(seed), &mut tiling, 12);
            assert_eq!(
                (path[0], path[path.len() - 1]),
                (Tiling::FIRST, Tiling::FIRST)
            );
            let far = path.iter().map(|&tile| tiling.distance(tile)).max();
            assert!(far >= Some(12));
            for pair in path.windows(2) {
                assert!(tiling.edge_between(pair[0], pair[1]).is_some());
            }
        }
    }
}
