//! Triangles brought into an order in which those that lie together follow each other.
//!
//! What was halved is dense about the eye, and most of it lies behind or below the picture: by blocks it can be
//! left out.

use glam::Vec3;

use crate::parts::Block;

/// Triangles of a block at most, unless they cannot be parted: a block costs the planner a microsecond a frame, and
/// the adapter about as much as forty triangles.
const MOST_TRIANGLES: usize = 512;

/// Brings the triangles in order and tells where the blocks lie. The same triangles give the same order.
pub fn arrange(triangles: &mut [[u32; 3]], positions: &[Vec3]) -> Vec<Block> {
    let mut blocks = Vec::new();
    part(triangles, 0, positions, &mut blocks);
    blocks
}

/// Parts the triangles across the longest side of the box of their middles until there are few.
fn part(triangles: &mut [[u32; 3]], first: usize, positions: &[Vec3], blocks: &mut Vec<Block>) {
    let middle = |corners: &[u32; 3]| corners.iter().map(|&i| positions[i as usize]).sum::<Vec3>();
    if triangles.len() > MOST_TRIANGLES {
        let (min, max) = bounds(triangles.iter().map(middle));
        let axis = (max - min).max_position();
        let half = 0.5 * (min[axis] + max[axis]);
        triangles.sort_by_key(|corners| middle(corners)[axis] >= half);
        let count = triangles.partition_point(|corners| middle(corners)[axis] < half);
        if count > 0 && count < triangles.len() {
            let (low, high) = triangles.split_at_mut(count);
            part(low, first, positions, blocks);
            part(high, first + count, positions, blocks);
            return;
        }
    }
    if !triangles.is_empty() {
        let corners = triangles.as_flattened().iter();
        let (min, max) = bounds(corners.map(|&i| positions[i as usize]));
        let indices = 3 * first as u32..3 * (first + triangles.len()) as u32;
        blocks.push(Block { indices, min, max });
    }
}

fn bounds(points: impl Iterator<Item = Vec3>) -> (Vec3, Vec3) {
    points.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), p| {
        (min.min(p), max.max(p))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_triangle_is_in_one_block_that_holds_it_and_blocks_are_small() {
        let place = |i: u32| {
            let t = i as f32;
            Vec3::new(
                16.0 + 15.0 * (t * 0.37).sin(),
                4.0 + (t * 0.11).cos(),
                t % 32.0,
            )
        };
        let positions: Vec<_> = (0..9000).map(place).collect();
        let mut triangles: Vec<_> = (0..8000).map(|i| [i, i + 1, (i * 7) % 9000]).collect();
        let mut before = triangles.clone();
        let blocks = arrange(&mut triangles, &positions);
        assert!(blocks.len() >= 16, "{}", blocks.len());
        let mut next = 0;
        for block in &blocks {
            assert_eq!(block.indices.start, next);
            next = block.indices.end;
            let range = block.indices.start as usize..block.indices.end as usize;
            assert!(range.len() <= 3 * MOST_TRIANGLES);
            for &i in &triangles.as_flattened()[range] {
                let p = positions[i as usize];
                assert_eq!(p.clamp(block.min, block.max), p);
            }
        }
        assert_eq!(next as usize, 3 * triangles.len());
        before.sort_unstable();
        triangles.sort_unstable();
        assert_eq!(before, triangles);
    }

    #[test]
    fn triangles_that_cannot_be_parted_are_one_block() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let mut triangles = vec![[0, 1, 2]; 3000];
        assert_eq!(arrange(&mut triangles, &positions).len(), 1);
        assert!(arrange(&mut [], &positions).is_empty());
    }
}
