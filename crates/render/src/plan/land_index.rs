//! The land that is there, in an order in which a frame looks only at what it may see.

use std::ops::Range;

use antipode_geometry::{BoundingCylinder, ChartId};
use glam::{DVec2, IVec2};

use super::skyline::Column;
use super::{ChunkLand, Ground};

/// Columns of chunks along each side of a tile group, as a power of two.
const GROUP_COLUMNS_LOG2: u32 = 2;

/// Land to be planned for, arranged by columns of chunks and tile groups of columns.
#[derive(Debug, Default)]
pub struct LandIndex {
    land: Vec<ChunkLand>,
    /// Places in `land`: tile group by tile group, column by column, upwards.
    order: Vec<u32>,
    groups: Vec<TileGroup>,
    columns: Vec<Column>,
    /// The column of each place in `land`, by its place in `columns`; past its end where it hides nothing.
    column_of: Vec<u32>,
}

/// Columns beside each other, which are seen or not seen together.
#[derive(Clone, Debug)]
pub struct TileGroup {
    /// Holds all its land, and the circles around it.
    pub cylinder: BoundingCylinder,
    /// Triangles of its land.
    pub triangles: usize,
    chunks: Range<usize>,
}

type ColumnKey = (ChartId, [i32; 2], [i32; 2]);

/// What tells columns apart and brings those of a tile group together.
fn column_key(chunk: &ChunkLand) -> ColumnKey {
    let at = [chunk.coord.index.x, chunk.coord.index.z];
    let group = at.map(|i| i >> GROUP_COLUMNS_LOG2);
    (chunk.coord.chart, group, at)
}

impl LandIndex {
    /// Arranges land; what is planned of it names chunks by their place in this list.
    pub fn new(land: Vec<ChunkLand>) -> Self {
        let mut keyed: Vec<_> = (0..land.len() as u32)
            .zip(&land)
            .map(|(place, chunk)| (column_key(chunk), chunk.coord.index.y, place))
            .collect();
        keyed.sort_unstable();
        let mut land_index = Self {
            order: keyed.iter().map(|(.., place)| *place).collect(),
            column_of: vec![u32::MAX; land.len()],
            land,
            ..Self::default()
        };
        let mut from = 0;
        for group in keyed.chunk_by(|(a, ..), (b, ..)| a.0 == b.0 && a.1 == b.1) {
            let chunks = from..from + group.len();
            from = chunks.end;
            land_index.groups.push(land_index.group(chunks));
        }
        for column in keyed.chunk_by(|(a, ..), (b, ..)| a == b) {
            land_index.add_column(column);
        }
        land_index
    }

    fn group(&self, chunks: Range<usize>) -> TileGroup {
        let members = || {
            self.order[chunks.clone()]
                .iter()
                .map(|i| &self.land[*i as usize])
        };
        let level = |v: glam::DVec3| DVec2::new(v.x, v.z);
        let (mut min, mut max) = (glam::DVec3::INFINITY, glam::DVec3::NEG_INFINITY);
        for chunk in members() {
            min = min.min(chunk.whole[0]);
            max = max.max(chunk.whole[1]);
        }
        let middle = 0.5 * level(min + max);
        let reach = |chunk: &ChunkLand| {
            let [low, high] = chunk.whole;
            let half = 0.5 * level(high - low);
            (0.5 * level(low + high)).distance(middle) + half.length()
        };
        TileGroup {
            cylinder: BoundingCylinder {
                chart: members().next().map_or(ChartId::FIRST, |c| c.coord.chart),
                middle,
                radius_m: members().map(reach).fold(0.0, f64::max),
                heights_m: [min.y, max.y],
            },
            triangles: members().map(|chunk| chunk.triangles).sum(),
            chunks,
        }
    }

    /// Adds a column, given upwards, if it is known to be solid below some height.
    fn add_column(&mut self, chunks: &[(ColumnKey, i32, u32)]) {
        let upwards = chunks.iter().map(|(.., place)| &self.land[*place as usize]);
        let (Some(((chart, _, at), ..)), Some(solid_below_m)) =
            (chunks.first(), Ground::solid_below_m(upwards))
        else {
            return;
        };
        for (.., place) in chunks {
            self.column_of[*place as usize] = self.columns.len() as u32;
        }
        self.columns
            .push(Column::new(*chart, IVec2::from_array(*at), solid_below_m));
    }

    /// The land in the order in which it was given.
    pub fn land(&self) -> &[ChunkLand] {
        &self.land
    }

    /// What is seen or not seen together.
    pub fn groups(&self) -> &[TileGroup] {
        &self.groups
    }

    /// The chunks of a tile group, by their places in the land.
    pub fn chunks(&self, group: &TileGroup) -> impl Iterator<Item = usize> + '_ {
        self.order[group.chunks.clone()]
            .iter()
            .map(|place| *place as usize)
    }

    /// The columns that are known to be solid below some height.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The column of a chunk, by its place in [`LandIndex::columns`].
    pub fn column_of(&self, place: usize) -> Option<usize> {
        let column = *self.column_of.get(place)? as usize;
        (column < self.columns.len()).then_some(column)
    }
}
