//! Caves of worlds in tiles, each told in the patch of a tile nearby.

use antipode_geometry::{ChartId, ChartPoint};
use glam::{DVec2, DVec3};

use super::{Here, Hollow, REACH_M};
use crate::caves::{Bounds, Caves, Den};
use crate::field::Field;
use crate::tracts::{Tract, Tracts};

impl Field {
    /// [`Field::carve`] of a world in tiles.
    pub(super) fn carve_tiled(
        &self,
        caves: &Caves,
        tracts: &Tracts,
        (chart, first, step_m): (ChartId, DVec3, u32),
        [width, height, depth]: [usize; 3],
        mut take: impl FnMut(usize, Hollow),
    ) {
        let step_m = f64::from(step_m);
        let steps = DVec3::new(width as f64, height as f64, depth as f64) - 1.0;
        let last = first + steps * step_m;
        let heights = |j: usize| first.y + j as f64 * step_m;
        let dens = self.dens_about(caves, tracts, chart, [first, last], REACH_M);
        let tract = tracts.tract(&**self.strategy(), chart);
        let Some(tract) = tract.filter(|_| !dens.is_empty()) else {
            return;
        };
        let xs = tract.tangents(first.x, step_m, width);
        let zs = tract.tangents(first.z, step_m, depth);
        for n in 0..width * depth {
            let at = DVec2::new(xs[n / depth], zs[n % depth]);
            let (owner, at) = tracts.owner(&**self.strategy(), &tract, tract.noise.written(at));
            let ends = [first.y, last.y];
            // Edges are another tile's, so that all who share one find the same.
            let mut others = Vec::new();
            let (owner, dens) = match &owner {
                Some(owner) => {
                    others.extend(caves.dens(self, (owner, &[at]), ends, REACH_M));
                    (owner, &others)
                }
                None => (&tract, &dens),
            };
            let column = Dens::new(owner, at, dens, ends);
            if column.all.is_empty() {
                continue;
            }
            for j in 0..height {
                if let Some(hollow) = column.hollow(self, heights(j)) {
                    take(n * height + j, hollow);
                }
            }
        }
    }

    /// What caves make of a point.
    pub(super) fn hollow_tiled(
        &self,
        caves: &Caves,
        tracts: &Tracts,
        point: ChartPoint,
    ) -> Option<Hollow> {
        let space = &**self.strategy();
        let pos = point.pos;
        let tract = tracts.tract(space, point.chart)?;
        let at = DVec2::new(tract.noise.tangent(pos.x), tract.noise.tangent(pos.z));
        let (owner, at) = tracts.owner(space, &tract, tract.noise.written(at));
        let owner = owner.as_ref().unwrap_or(&tract);
        let ends = [pos.y, pos.y];
        let dens = caves.dens(self, (owner, &[at]), ends, REACH_M);
        Dens::new(owner, at, &dens, ends).hollow(self, pos.y)
    }

    /// The caves that come near a box of a chart.
    pub(super) fn dens_about(
        &self,
        caves: &Caves,
        tracts: &Tracts,
        chart: ChartId,
        [first, last]: [DVec3; 2],
        reach_m: f64,
    ) -> Vec<Den> {
        let Some(tract) = tracts.tract(&**self.strategy(), chart) else {
            return Vec::new();
        };
        let xs = [first.x, last.x].map(|x| tract.noise.tangent(x));
        let zs = [first.z, last.z].map(|z| tract.noise.tangent(z));
        let corners = [[0, 0], [0, 1], [1, 0], [1, 1]];
        let corners = corners.map(|[i, k]| tract.noise.written(DVec2::new(xs[i], zs[k])));
        caves.dens(self, (&tract, &corners), [first.y, last.y], reach_m)
    }
}

/// The caves near a column, each with the column's ground in its patch.
struct Dens<'a> {
    all: Vec<(DVec3, Vec<&'a crate::caves::Stretch>)>,
}

impl<'a> Dens<'a> {
    fn new(tract: &Tract, at: DVec2, dens: &'a [Den], ends: [f64; 2]) -> Self {
        let mut all = Vec::new();
        for den in dens {
            let Some(ground) = tract.ground(at, den.place) else {
                continue;
            };
            let column = Bounds {
                low: ground + DVec3::Y * ends[0],
                high: ground + DVec3::Y * ends[1],
            };
            let near = den.stretches.iter();
            let near: Vec<_> = near
                .filter(|it| it.bounds(REACH_M).meets(&column))
                .collect();
            if !near.is_empty() {
                all.push((ground, near));
            }
        }
        Self { all }
    }

    fn hollow(&self, field: &Field, y: f64) -> Option<Hollow> {
        let hollows = self.all.iter().filter_map(|(ground, stretches)| {
            let mut here = Here::new(field, *ground + DVec3::Y * y, y);
            for stretch in stretches {
                here.meet(stretch);
            }
            here.found
        });
        hollows.max_by(|a, b| a.value.total_cmp(&b.value))
    }
}
