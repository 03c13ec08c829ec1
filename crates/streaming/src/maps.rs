//! Maps and sets by chunk. The main thread looks up some hundred chunks a frame in these books, so
//! they hash by two or three multiplications instead of the standard library's keyed hash: where
//! chunks lie is the game's own choice, and nobody gains by choosing ones that collide.

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

use antipode_geometry::ChunkCoord;

pub(crate) type ChunkMap<T> = HashMap<ChunkCoord, T, BuildHasherDefault<ChunkHasher>>;
pub(crate) type ChunkSet = HashSet<ChunkCoord, BuildHasherDefault<ChunkHasher>>;

/// The fraction of the golden ratio, as a 64-bit fixed-point number: odd, and its bits show no pattern.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Multiplies by the golden ratio and folds the product's high half onto its low one, so that every
/// bit of the input reaches the low bits, which choose the bucket, and the high ones, which tell
/// chunks in it apart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChunkHasher(u64);

impl Default for ChunkHasher {
    fn default() -> Self {
        Self(GOLDEN)
    }
}

impl ChunkHasher {
    fn mix(&mut self, word: u64) {
        let product = u128::from(self.0 ^ word) * u128::from(GOLDEN);
        self.0 = (product as u64) ^ ((product >> 64) as u64);
    }
}

impl Hasher for ChunkHasher {
    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..part.len()].copy_from_slice(part);
            self.mix(u64::from_le_bytes(word));
        }
    }

    fn write_i32(&mut self, value: i32) {
        self.mix(u64::from(value.cast_unsigned()));
    }

    fn write_isize(&mut self, value: isize) {
        self.mix(value as u64);
    }

    fn finish(&self) -> u64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use std::hash::BuildHasher;

    use antipode_geometry::ChartId;
    use glam::IVec3;

    use super::*;

    #[test]
    fn chunks_of_a_wide_range_spread_evenly_over_buckets_and_tags() {
        let hasher = BuildHasherDefault::<ChunkHasher>::default();
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
