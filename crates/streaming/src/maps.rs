//! Maps and sets by chunk. The main thread looks up some hundred chunks a frame in these, so
//! they hash without the standard library's key: where chunks lie is the game's own choice, and nobody
//! gains by choosing ones that collide. The key is fixed, so that a run goes as the last one did.

use std::collections::{HashMap, HashSet};

use antipode_geometry::ChunkCoord;
use foldhash::fast::FixedState;

pub(crate) type ChunkMap<T> = HashMap<ChunkCoord, T, FixedState>;
pub(crate) type ChunkSet = HashSet<ChunkCoord, FixedState>;

#[cfg(test)]
mod tests {
    use std::hash::BuildHasher;

    use antipode_geometry::ChartId;
    use glam::IVec3;

    use super::*;

    #[test]
    fn chunks_of_a_wide_range_spread_evenly_over_buckets_and_tags() {
        let hasher = FixedState::default();
        let side = -20..20;
        let mut buckets = vec![0_u32; 1 << 12];
        let mut tags = [0_u32; 128];
        let mut hashes = HashSet::new();
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            for x in side.clone() {
                for y in side.clone() {
                    for z in side.clone() {
                        let hash = hasher.hash_one(ChunkCoord::new(chart, IVec3::new(x, y, z)));
                        buckets[(hash & 0xfff) as usize] += 1;
                        tags[(hash >> 57) as usize] += 1;
                        hashes.insert(hash);
                    }
                }
            }
        }
        // 128 000 chunks: 31 in each of 4096 buckets and 1000 of each of 128 tags, give or take six
        // standard deviations of chance.
        assert_eq!(hashes.len(), 128_000);
        assert!(
            buckets.iter().all(|count| *count < 31 + 34),
            "{:?}",
            buckets.iter().max()
        );
        assert!(
            tags.iter().all(|count| (810..1190).contains(count)),
            "{tags:?}"
        );
    }
}
