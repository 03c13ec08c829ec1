//! Which of two columns of chunks may be before the other: one that a ray from the eye meets later is of a greater ring.

use std::collections::HashMap;

use antipode_frame::Frame;
use antipode_geometry::tiled::{beside, fits};
use antipode_geometry::{CHUNK_CELLS, ChartId, ChunkCoord, Strategy, Tiled};
use glam::{DVec2, IVec2, IVec3};

use super::skyline::Grid;

/// No column is more steps from the eye's.
const MOST_STEPS: u32 = 512;

/// The rings of a frame's columns.
pub struct Rings<'a> {
    frame: &'a Frame,
    grid: Option<(ChartId, Grid)>,
    tiles: Option<TileRings<'a>>,
}

impl<'a> Rings<'a> {
    /// None counted yet.
    pub fn of(frame: &'a Frame) -> Self {
        Self {
            frame,
            grid: None,
            tiles: TileRings::of(frame),
        }
    }

    /// The grid of a chart.
    pub fn grid(&mut self, chart: ChartId) -> Grid {
        let known = self.grid.filter(|(of, _)| *of == chart);
        let (_, grid) = known.unwrap_or_else(|| (chart, Grid::of(self.frame, chart)));
        self.grid = Some((chart, grid));
        grid
    }

    /// The ring of a column; none where that cannot be said.
    pub fn ring(&mut self, chart: ChartId, place: IVec2) -> Option<u32> {
        match &mut self.tiles {
            Some(tiles) => tiles.ring(chart, place, MOST_STEPS),
            None => self.grid(chart).ring(place),
        }
    }

    /// The ring of a column that may hide others: past the edge of its domain a chart has land only near by, and where that
    /// ends a mesh has neither ground nor air.
    pub fn ring_of_hiding(&mut self, chart: ChartId, place: IVec2) -> Option<u32> {
        let low = place.as_dvec2() * f64::from(CHUNK_CELLS);
        let domain = self.frame.view.strategy.domain(chart);
        let past_m = domain.most_outside_m(low, low + f64::from(CHUNK_CELLS));
        self.ring(chart, place).filter(|_| past_m <= 0.0)
    }
}

/// The rings of columns of a world in tiles of whole chunks.
///
/// Lines of the grid and edges are geodesics, and so is the plan of a ray. It enters a column over a side that has the eye on its
/// outer side, so that a column's ring is one more than the greatest of those over such sides. That comes to an end: an edge of two
/// tiles lies midway between their middles, so that over edges the middle gets nearer to the eye.
struct TileRings<'a> {
    space: &'a dyn Strategy,
    tiled: &'a dyn Tiled,
    frame: &'a Frame,
    /// Where the eye is by the lines of each chart's grid, in chunks.
    eyes: HashMap<ChartId, Option<DVec2>>,
    known: HashMap<(ChartId, IVec2), Option<u32>>,
}

impl<'a> TileRings<'a> {
    fn of(frame: &'a Frame) -> Option<Self> {
        let space = &*frame.view.strategy;
        let tiled = space.tiled()?;
        fits(space, ChartId::FIRST).then(|| Self {
            space,
            tiled,
            frame,
            eyes: HashMap::new(),
            known: HashMap::new(),
        })
    }

    fn ring(&mut self, chart: ChartId, place: IVec2, most: u32) -> Option<u32> {
        if let Some(ring) = self.known.get(&(chart, place)) {
            return *ring;
        }
        let ring = self.counted(chart, place, most);
        self.known.insert((chart, place), ring);
        ring
    }

    fn counted(&mut self, chart: ChartId, place: IVec2, most: u32) -> Option<u32> {
        let (tiled, at) = (self.tiled, self.frame.view.eye.point);
        let lines_m = || tiled.grid_lines_m(at, chart);
        let eye = self
            .eyes
            .entry(chart)
            .or_insert_with(|| Some(lines_m()? / f64::from(CHUNK_CELLS)));
        let (eye, most) = ((*eye)?, most.checked_sub(1)?);
        let coord = ChunkCoord::new(chart, IVec3::new(place.x, 0, place.y));
        let [low, high] = [place, place + 1].map(IVec2::as_dvec2);
        let sides = [
            (eye.x > high.x, IVec3::X),
            (eye.x < low.x, IVec3::NEG_X),
            (eye.y > high.y, IVec3::Z),
            (eye.y < low.y, IVec3::NEG_Z),
        ];
        let mut ring = 0;
        for (_, step) in sides.into_iter().filter(|(is_before, _)| *is_before) {
            let before = beside(self.space, coord, step);
            let place = IVec2::new(before.index.x, before.index.z);
            ring = ring.max(1 + self.ring(before.chart, place, most)?);
        }
        Some(ring)
    }
}
