//! The tiles of charts, and the ways between them.

use glam::{DMat4, DVec2};

use super::cache::Cache;
use crate::tiling::{Frame, Isometry, Side, Tile, TilePath, TilingError, rings};
use crate::{ChartId, Joins};

/// Places in the tables: ten times as many as the charts within 5 radii, of which there are 400 with those at the edge. Of two
/// charts that are asked about in turn few then have one place.
const PLACES: usize = 4096;

/// Tiles one and two steps from one: 4 and 12.
const AROUND: usize = 16;

/// Frames, ways and numbers, worked out when asked for and kept for a while.
pub(super) struct Tiles {
    frames: Cache<ChartId, Frame>,
    ways: Cache<[ChartId; 2], DMat4>,
    charts: Cache<Tile, ChartId>,
    around: Cache<ChartId, [Option<ChartId>; AROUND]>,
    norths: Cache<ChartId, DVec2>,
    joins: Cache<ChartId, Joins>,
    over: Cache<ChartId, [Option<Over>; 4]>,
    /// The ways over edges, by the side left and the side come in by.
    crossings: [[DMat4; 4]; 4],
}

/// The chart over an edge, and its side there.
type Over = (ChartId, u8);

impl Tiles {
    /// With nothing kept yet.
    pub fn new() -> Self {
        Self {
            frames: Cache::of_places(PLACES),
            ways: Cache::of_places(PLACES),
            charts: Cache::of_places(PLACES),
            around: Cache::of_places(PLACES),
            norths: Cache::of_places(PLACES),
            joins: Cache::of_places(PLACES),
            over: Cache::of_places(PLACES),
            crossings: Side::ALL.map(|side| Side::ALL.map(|back| crossing(side, back))),
        }
    }

    /// The frame of a chart's tile; `None` where there is no such chart.
    pub fn frame(&self, chart: ChartId) -> Option<Frame> {
        self.frames.value(chart, || path(chart).ok()?.frame().ok())
    }

    /// The chart of a tile.
    pub fn chart(&self, frame: &Frame) -> Option<ChartId> {
        let number = || Some(ChartId::new(frame.path().ok()?.number()));
        self.charts.value(frame.tile(), number)
    }

    /// The charts one and two steps over edges from one, among which are all that share a corner with it.
    pub fn around(&self, chart: ChartId) -> impl Iterator<Item = ChartId> {
        let found = self.around.value(chart, || self.found_around(chart));
        found.into_iter().flatten().flatten()
    }

    /// The chart over a side of another, 0 to 3, and which of its sides is there.
    pub fn over(&self, chart: ChartId, side: u8) -> Option<Over> {
        let all = self.over.value(chart, || self.found_over(chart))?;
        *all.get(usize::from(side))?
    }

    fn found_over(&self, chart: ChartId) -> Option<[Option<Over>; 4]> {
        let frame = self.frame(chart)?;
        Some(Side::ALL.map(|side| {
            let crossed = frame.neighbour(side).ok()?;
            Some((self.chart(&crossed.frame)?, crossed.back.number()))
        }))
    }

    /// The charts over the sides of another that are there, and what takes points of the one's model to the other's.
    pub fn crossings(&self, chart: ChartId) -> impl Iterator<Item = (ChartId, &DMat4)> {
        let all = self.over.value(chart, || self.found_over(chart));
        let sides = all.into_iter().flatten().zip(&self.crossings);
        sides.filter_map(|(over, ways)| {
            let (chart, back) = over?;
            Some((chart, ways.get(usize::from(back))?))
        })
    }

    fn found_around(&self, chart: ChartId) -> Option<[Option<ChartId>; AROUND]> {
        let about = rings(&self.frame(chart)?, 2, 1 + AROUND).ok()?;
        let mut around = [None; AROUND];
        for (place, frame) in around.iter_mut().zip(about.iter().skip(1).flatten()) {
            *place = self.chart(frame);
        }
        Some(around)
    }

    /// From points (X, Y, Z, W) of a chart's model, in radii, to those of another's: each number within 1e-15 of itself, or
    /// 1e-14 where the tiles are more than 86 radii apart. `None` where there is no such chart.
    pub fn way(&self, from: ChartId, to: ChartId) -> Option<DMat4> {
        if from == to {
            return self.frame(from).map(|_| DMat4::IDENTITY);
        }
        self.ways.value([from, to], || self.found_way(from, to))
    }

    /// The ideal point in the north as a chart sees it from its middle, a unit vector of x and z; `None` where there is no such
    /// chart.
    ///
    /// It is -x of the root, carried from parent to child. A step towards it spreads what directions lack of it by e^step,
    /// but whoever goes there far goes along the axis, on which it is exact; away from it the error falls. So it is
    /// good to 1e-14 anywhere.
    pub fn north(&self, chart: ChartId) -> Option<DVec2> {
        let carried = || Some(path(chart).ok()?.sides().fold(DVec2::NEG_X, north_over));
        self.norths.value(chart, carried)
    }

    /// How a chart's tile is joined to those about it, as it is found where it is not known.
    pub fn joins(&self, chart: ChartId, found: impl FnOnce() -> Joins) -> Joins {
        self.joins
            .value(chart, || Some(found()))
            .unwrap_or_default()
    }

    fn found_way(&self, from: ChartId, to: ChartId) -> Option<DMat4> {
        let (here, there) = (self.frame(from)?, self.frame(to)?);
        if let Ok(way) = there.between(&here) {
            return Some(way.lorentz());
        }
        // Numbers too large to be exact. The way leads by the last tile that both were reached through, near to which the
        // shortest way passes, so that nothing cancels where the halves are multiplied; and that is nearer to both.
        let shared = shared_path(&path(from).ok()?, &path(to).ok()?).ok()?;
        let between = shared.frame().ok()?;
        let first = between.between(&here).ok()?.lorentz();
        Some(there.between(&between).ok()?.lorentz() * first)
    }
}

/// An ideal point as the child over a side of a tile sees it, by how that tile does. The step has the cosine phi and the
/// sine sqrt(phi), and the child's x goes on straight.
fn north_over(north: DVec2, side: Side) -> DVec2 {
    let cosh = 0.5 * (1.0 + 5.0_f64.sqrt());
    let sinh = cosh.sqrt();
    let turned = (0..side.number()).fold(north, |it, _| DVec2::new(it.y, -it.x));
    let w = cosh - sinh * turned.x;
    (DVec2::new(cosh * turned.x - sinh, turned.y) / w).normalize()
}

/// Over a side of a tile, into the next one by its side.
fn crossing(side: Side, back: Side) -> DMat4 {
    Isometry::crossing(back, side).map_or(DMat4::IDENTITY, |way| way.lorentz())
}

fn path(chart: ChartId) -> Result<TilePath, TilingError> {
    TilePath::from_number(chart.number())
}

fn shared_path(a: &TilePath, b: &TilePath) -> Result<TilePath, TilingError> {
    let both = a.sides().zip(b.sides());
    TilePath::new(both.take_while(|(a, b)| a == b).map(|(side, _)| side))
}
