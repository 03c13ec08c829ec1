//! Caves of worlds in tiles, each told in the patch of a tile nearby.

use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint};
use glam::{DVec2, DVec3};

use super::{Here, Hollow, REACH_M};
use crate::caves::{Bounds, Caves, Den};
use crate::field::Field;
use crate::tracts::{Met, Tract, Tracts};

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
        let columns = xs
            .iter()
            .flat_map(|x| zs.iter().map(|z| DVec2::new(*x, *z)));
        let ends = [first.y, last.y];
        let mut owners = Owners::of(dens);
        let (space, mut met) = (&**self.strategy(), Met::default());
        let places: Vec<_> = columns
            .map(|at| {
                let at = tract.noise.written(at);
                owners.place(tracts.owner(space, &tract, at, &mut met))
            })
            .collect();
        owners.look_for(|owner, corners| caves.dens(self, (owner, corners), ends, REACH_M));
        for (n, (owner, at)) in places.into_iter().enumerate() {
            let (owner, dens) = owners.get(owner, &tract);
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
        let (owner, at) = tracts.owner(space, &tract, tract.noise.written(at), &mut Met::default());
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

/// Whose caves the columns of a grid ask for: edges and what lies past them are another tile's, so that all who share those find
/// the same.
struct Owners {
    /// Near the grid, as the tile has them that it is told in.
    own: Vec<Den>,
    others: Vec<Other>,
}

/// Another tile that columns belong to.
struct Other {
    tract: Arc<Tract>,
    /// Where they lie, by X/W and Z/W there: each of them, so that a cave that comes near one is near all together.
    places: Vec<DVec2>,
    dens: Vec<Den>,
}

impl Owners {
    fn of(own: Vec<Den>) -> Self {
        Self {
            own,
            others: Vec::new(),
        }
    }

    /// Takes a column in, and returns the number of its owner and where it lies there.
    fn place(&mut self, (owner, at): (Option<Arc<Tract>>, DVec2)) -> (Option<usize>, DVec2) {
        let Some(tract) = owner else {
            return (None, at);
        };
        let mut known = self.others.iter();
        let number = known.position(|it| Arc::ptr_eq(&it.tract, &tract));
        let number = number.unwrap_or(self.others.len());
        match self.others.get_mut(number) {
            Some(other) => other.places.push(at),
            None => self.others.push(Other {
                tract,
                places: vec![at],
                dens: Vec::new(),
            }),
        }
        (Some(number), at)
    }

    /// Looks for the caves of the others near what they have.
    fn look_for(&mut self, dens: impl Fn(&Tract, &[DVec2]) -> Vec<Den>) {
        for other in &mut self.others {
            other.dens = dens(&other.tract, &other.places);
        }
    }

    /// An owner and its caves.
    fn get<'a>(&'a self, owner: Option<usize>, own: &'a Tract) -> (&'a Tract, &'a [Den]) {
        let other = owner.and_then(|number| self.others.get(number));
        other.map_or((own, &self.own), |it| (&it.tract, &it.dens))
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
