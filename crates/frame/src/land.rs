//! The land of a picture: the meshes of a world's chunks, and what became of them since a follower last looked.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::ChunkCoord;
use antipode_terrain::ChunkMesh;

/// Removals that are remembered at most, and at least half as many. A follower who is farther behind starts over.
const MOST_GONE: usize = 8192;

/// A change to the terrain meshes held by a follower.
#[derive(Clone, Debug)]
pub enum ChunkChange {
    /// Insert or replace the chunk's mesh; an empty mesh draws nothing.
    Put(ChunkCoord, Arc<ChunkMesh>),
    /// Forget the chunk.
    Remove(ChunkCoord),
}

/// The terrain meshes of one world, each with the number of the change that brought it.
///
/// Whoever draws the land follows it with a [`LandCursor`] of its own. Reading takes nothing away, so any number of
/// followers may draw one world, each as seldom as it likes, and one that begins late is told of all that is there.
#[derive(Clone, Debug, Default)]
pub struct Land {
    /// The last change of each chunk; none for the mesh of a chunk that is gone.
    latest: BTreeMap<ChunkCoord, (u64, Option<Arc<ChunkMesh>>)>,
    /// The chunks of `latest` by the numbers of their changes.
    order: BTreeMap<u64, ChunkCoord>,
    /// The number of the last change of all.
    last: u64,
    /// Chunks of `latest` that are gone.
    gone: usize,
    /// The number of the last removal that is remembered no longer.
    forgotten: u64,
}

/// How far a follower has read a [`Land`]; a new one has read nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LandCursor(u64);

/// What a follower has to do to have all of a [`Land`].
#[derive(Clone, Debug, Default)]
pub struct LandNews {
    /// Drop every chunk first: some that are gone are no longer told of.
    pub starts_over: bool,
    /// The last change of each chunk that changed, in the order of the chunks.
    pub changes: Vec<ChunkChange>,
}

impl Land {
    /// Makes a change.
    pub fn change(&mut self, change: ChunkChange) {
        let (coord, mesh) = match change {
            ChunkChange::Put(coord, mesh) => (coord, Some(mesh)),
            ChunkChange::Remove(coord) => (coord, None),
        };
        self.last += 1;
        self.gone += usize::from(mesh.is_none());
        self.order.insert(self.last, coord);
        if let Some((number, before)) = self.latest.insert(coord, (self.last, mesh)) {
            self.order.remove(&number);
            self.gone -= usize::from(before.is_none());
        }
        if self.gone > MOST_GONE {
            self.forget_gone();
        }
    }

    /// What has changed since a follower last asked; it has read everything then.
    pub fn news(&self, cursor: &mut LandCursor) -> LandNews {
        let LandCursor(read) = std::mem::replace(cursor, LandCursor(self.last));
        let starts_over = 0 < read && read < self.forgotten;
        let read = if starts_over { 0 } else { read };
        let later = self.order.range(read + 1..).map(|(_, coord)| *coord);
        let changes = later.filter_map(|coord| match &self.latest.get(&coord)?.1 {
            Some(mesh) => Some(ChunkChange::Put(coord, Arc::clone(mesh))),
            // A follower that has read nothing has nothing to forget.
            None => (read > 0).then_some(ChunkChange::Remove(coord)),
        });
        let mut changes: Vec<_> = changes.collect();
        changes.sort_unstable_by_key(ChunkChange::coord);
        LandNews {
            starts_over,
            changes,
        }
    }

    /// The chunks that are there, in their order.
    pub fn meshes(&self) -> impl Iterator<Item = (ChunkCoord, &Arc<ChunkMesh>)> {
        let latest = self.latest.iter();
        latest.filter_map(|(coord, (_, mesh))| Some((*coord, mesh.as_ref()?)))
    }

    /// The mesh of a chunk, if it is there.
    pub fn mesh(&self, coord: ChunkCoord) -> Option<&Arc<ChunkMesh>> {
        self.latest.get(&coord)?.1.as_ref()
    }

    /// Forgets the older half of the removals: who has read since then has heard of them.
    fn forget_gone(&mut self) {
        let numbers = self.order.iter();
        let is_gone = |coord| {
            self.latest
                .get(coord)
                .is_some_and(|(_, mesh)| mesh.is_none())
        };
        let gone = numbers.filter(|(_, coord)| is_gone(*coord));
        let older: Vec<_> = gone
            .map(|(&number, _)| number)
            .take(MOST_GONE / 2)
            .collect();
        for number in older {
            let coord = self.order.remove(&number);
            coord.and_then(|coord| self.latest.remove(&coord));
            self.gone -= 1;
            self.forgotten = number;
        }
    }
}

impl FromIterator<ChunkChange> for Land {
    fn from_iter<T: IntoIterator<Item = ChunkChange>>(changes: T) -> Self {
        let mut land = Self::default();
        changes.into_iter().for_each(|change| land.change(change));
        land
    }
}

impl ChunkChange {
    /// The chunk that changes.
    pub fn coord(&self) -> ChunkCoord {
        match self {
            Self::Put(coord, _) | Self::Remove(coord) => *coord,
        }
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::ChartId;
    use glam::IVec3;

    use super::*;

    fn coord(x: i32) -> ChunkCoord {
        ChunkCoord::new(ChartId::FIRST, IVec3::new(x, 0, 0))
    }

    fn put(x: i32) -> ChunkChange {
        ChunkChange::Put(coord(x), Arc::default())
    }

    /// Which chunks are told of, and whether each is put.
    fn told(land: &Land, cursor: &mut LandCursor) -> Vec<(i32, bool)> {
        let news = land.news(cursor);
        let tell = |change: &ChunkChange| {
            (
                change.coord().index.x,
                matches!(change, ChunkChange::Put(..)),
            )
        };
        news.changes.iter().map(tell).collect()
    }

    #[test]
    fn each_follower_is_told_once_of_each_chunks_last_change_and_takes_nothing_from_others() {
        let mut land: Land = [put(2), put(1), put(2), put(0)].into_iter().collect();
        let (mut early, mut late) = (LandCursor::default(), LandCursor::default());
        assert_eq!(told(&land, &mut early), [(0, true), (1, true), (2, true)]);
        assert!(told(&land, &mut early).is_empty());
        land.change(ChunkChange::Remove(coord(1)));
        land.change(put(2));
        assert_eq!(told(&land, &mut early), [(1, false), (2, true)]);
        assert_eq!(told(&land, &mut late), [(0, true), (2, true)]);
        land.change(put(1));
        assert_eq!(told(&land, &mut early), [(1, true)]);
        assert_eq!(told(&land, &mut late), [(1, true)]);
        assert_eq!(land.meshes().count(), 3);
    }

    #[test]
    fn a_follower_who_is_too_far_behind_starts_over_and_the_removals_do_not_pile_up() {
        let mut land: Land = [put(-1), put(0)].into_iter().collect();
        let (mut far, mut near, mut new) = Default::default();
        land.news(&mut far);
        land.news(&mut near);
        for x in 0..2 * MOST_GONE as i32 {
            land.change(ChunkChange::Remove(coord(x)));
            let news = land.news(&mut near);
            assert!(
                !news.starts_over,
                "who reads after each change hears of all: {x}"
            );
            assert_eq!(news.changes.len(), 1, "{x}");
        }
        assert!(land.latest.len() <= MOST_GONE + 1 && land.order.len() == land.latest.len());
        assert!(!land.news(&mut new).starts_over);
        let news = land.news(&mut far);
        assert!(news.starts_over);
        assert_eq!(news.changes.len(), 1, "what is there: {news:?}");
    }
}
