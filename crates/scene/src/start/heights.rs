//! Heights of the ground, for a search that asks for many of them.

use std::collections::HashMap;

use antipode_geometry::{ChartId, ChartPoint};
use antipode_terrain::Field;
use glam::{DVec2, DVec3};

/// Steps down to the ground, in metres, and as a share of the field's value: the field would have to change three times as
/// fast as the height for land to be missed.
const STEP_M: f64 = 0.5;
const STEP_SHARE: f64 = 0.33;
/// How exactly the ground is found at least, in metres, and after how many tries that is enough.
const EXACT_M: f64 = 2e-3;
const TRIES: u32 = 12;
/// Columns of the coarse land are so far apart, in metres.
const APART_M: f64 = 8.0;

/// A height and the field's value there.
type Sample = (f64, f64);

/// Height of the topmost ground over a place, or a hair over it.
pub(super) fn ground_m(field: &Field, chart: ChartId, x: f64, z: f64) -> f64 {
    let at = |y| f64::from(field.sample(ChartPoint::new(chart, DVec3::new(x, y, z))));
    let (mut ground, mut air) = bracket(field, at);
    for _ in 0..TRIES {
        // A little to the far side of where the ground should be, so that both ends close in on it.
        let between = crossing(ground, air);
        let y = if air.0 - between > between - ground.0 {
            between + 0.5 * EXACT_M
        } else {
            between - 0.5 * EXACT_M
        };
        let value = at(y);
        if value < 0.0 {
            ground = (y, value);
        } else {
            air = (y, value);
        }
        if air.0 - ground.0 <= EXACT_M {
            break;
        }
    }
    air.0
}

/// Where the value is nothing, if it changes evenly.
fn crossing(ground: Sample, air: Sample) -> f64 {
    let share = ground.1 / (ground.1 - air.1);
    ground.0 + share * (air.0 - ground.0)
}

/// A height in the topmost ground and one over it.
fn bracket(field: &Field, at: impl Fn(f64) -> f64) -> (Sample, Sample) {
    let (low, high) = field.ground_range_m();
    let mut air = (high + STEP_M, at(high + STEP_M));
    while air.0 > low {
        let y = air.0 - (STEP_SHARE * air.1).max(STEP_M);
        let below = (y, at(y));
        if below.1 < 0.0 {
            return (below, air);
        }
        air = below;
    }
    ((low - STEP_M, -STEP_M), air)
}

/// Heights between columns of a lattice, each of which is asked for once: one land is looked at from many places.
pub(super) struct Land<'a> {
    field: &'a Field,
    known: HashMap<(ChartId, i32, i32), f64>,
}

impl<'a> Land<'a> {
    pub(super) fn new(field: &'a Field) -> Self {
        Self {
            field,
            known: HashMap::new(),
        }
    }

    /// About where the ground over or under a point is.
    pub(super) fn ground(&mut self, point: ChartPoint) -> ChartPoint {
        let crossed = self.field.strategy().cross(point);
        let ChartPoint { chart, pos } = crossed.map_or(point, |it| it.point);
        let at = DVec2::new(pos.x, pos.z) / APART_M;
        let low = at.floor();
        let part = at - low;
        let (x, z) = (low.x as i32, low.y as i32);
        let near =
            self.column(chart, x, z) * (1.0 - part.x) + self.column(chart, x + 1, z) * part.x;
        let far = self.column(chart, x, z + 1) * (1.0 - part.x)
            + self.column(chart, x + 1, z + 1) * part.x;
        let y = near * (1.0 - part.y) + far * part.y;
        ChartPoint::new(chart, pos.with_y(y))
    }

    fn column(&mut self, chart: ChartId, x: i32, z: i32) -> f64 {
        let field = self.field;
        *self.known.entry((chart, x, z)).or_insert_with(|| {
            let at = DVec2::new(f64::from(x), f64::from(z)) * APART_M;
            let (ground, air) = bracket(field, |y| {
                f64::from(field.sample(ChartPoint::new(chart, DVec3::new(at.x, y, at.y))))
            });
            crossing(ground, air)
        })
    }
}
