//! What is near: the walk over the tiles about a place, and ways on the level.

use std::collections::HashSet;
use std::f64::consts::TAU;

use glam::{DMat2, DMat4, DVec2, DVec3, DVec4, Vec3Swizzles};

use super::plan::azimuths_rad;
use super::world::{HyperbolicWorld, inverse};
use crate::tiling::{EDGE_TANH, TilePath};
use crate::{Away, CHUNK_CELLS, ChartId, ChartPoint, Joins, Tiled};

/// Land is there no farther than so many radii, where a metre is 1/74 of the radius's metres across: within are 366 tiles.
const LAND_RAD: f64 = 5.0;
/// So many times the land of the flat view's square at most.
const LAND_SHARE: f64 = 2.0;
/// Ground is meshed so far past the edges that run through chunks, metres.
const MESHED_PAST_M: f64 = 8.0;
/// No walk finds more tiles: 8 radii of them.
const MOST_TILES: usize = 8192;

/// How far it is in radii from a point (X, Y, Z, W) of a tile's model on the level to the nearest of a box between lines of the
/// grid, given by X/W and Z/W of its corners.
///
/// The line X = a W has the unit normal `n = (1, 0, a)/sqrt(1 - a^2)` in (X, Z, W), and `<n, p> = (X - a W)/sqrt(1 - a^2)` is
/// the sine of the distance from it. The foot is `p - <n, p> n`. Where no foot lies on a side of the box, the nearest is a corner
/// `c = (a, b, 1)/sqrt(1 - a^2 - b^2)`, with `cosh d = -<c, p>`.
fn away_rad(point: DVec4, low: DVec2, high: DVec2) -> f64 {
    let (x, z, w) = (point.x, point.z, point.w);
    // How far past the line at `a`, along an axis where it is `along`; `across` is to be in a range at the foot.
    let past = |out: f64, along: f64, a: f64, across: f64, range: [f64; 2]| {
        let rest = (1.0 - a * a).sqrt();
        let sine = out * (along - a * w) / rest;
        let foot_w = w - out * sine * a / rest;
        let is_side = (range[0] * foot_w..=range[1] * foot_w).contains(&across);
        (sine, is_side)
    };
    let sides = [
        past(1.0, x, high.x, z, [low.y, high.y]),
        past(-1.0, x, low.x, z, [low.y, high.y]),
        past(1.0, z, high.y, x, [low.x, high.x]),
        past(-1.0, z, low.y, x, [low.x, high.x]),
    ];
    if sides.iter().all(|(sine, _)| *sine <= 0.0) {
        return 0.0;
    }
    let feet = sides
        .iter()
        .filter(|(sine, is_side)| *sine > 0.0 && *is_side);
    let nearest = feet
        .map(|(sine, _)| sine.asinh())
        .fold(f64::INFINITY, f64::min);
    if nearest.is_finite() {
        return nearest;
    }
    let corners = [
        low,
        high,
        DVec2::new(low.x, high.y),
        DVec2::new(high.x, low.y),
    ];
    let away = corners.map(|c| (w - c.x * x - c.y * z) / (1.0 - c.length_squared()).sqrt());
    away.into_iter()
        .fold(f64::INFINITY, f64::min)
        .max(1.0)
        .acosh()
}

/// A chart that comes near a place.
#[derive(Clone, Copy)]
struct NearChart {
    away_m: f64,
    chart: ChartId,
    /// From the model of the place's chart to its own.
    way: DMat4,
}

/// What tells ways on the level from a place.
struct Outwards {
    /// From the model of the place's chart to the place's frame.
    to_frame: DMat4,
    /// From the frame to the axes of the chart there.
    to_chart: DMat2,
    radius_m: f64,
}

impl Outwards {
    /// The way to what is seen at a point of the frame, metres: x and z.
    fn way_m(&self, seen: DVec4) -> DVec2 {
        let ahead = DVec2::new(seen.x, seen.z);
        let length_m = ahead.length().asinh() * self.radius_m;
        (self.to_chart * ahead).normalize_or_zero() * length_m
    }
}

/// A box of a ground plan: its corners by X/W and Z/W, and its middle.
struct PlanBox {
    low: DVec2,
    high: DVec2,
    middle: DVec4,
}

impl HyperbolicWorld {
    /// Breadth first, each tile's way found from that of the tile before: no way is asked for that is not needed again. The
    /// disc about the place is connected, so that all of its tiles are found over edges of tiles that it comes into.
    fn near_charts(&self, at: ChartPoint, reach_m: f64) -> Vec<NearChart> {
        let level = self.level(at.pos);
        let mut found = vec![NearChart {
            away_m: 0.0,
            chart: at.chart,
            way: DMat4::IDENTITY,
        }];
        let mut known = HashSet::from([at.chart]);
        let mut next = 0;
        while let Some(&NearChart { chart, way, .. }) = found.get(next) {
            next += 1;
            for (over, crossing) in self.tiles.crossings(chart) {
                if known.len() >= MOST_TILES || !known.insert(over) {
                    continue;
                }
                let way = *crossing * way;
                let away_m = self.square_away_m(way * level);
                if away_m <= reach_m {
                    found.push(NearChart {
                        away_m,
                        chart: over,
                        way,
                    });
                }
            }
        }
        found.sort_by(|a, b| {
            let by_distance = a.away_m.total_cmp(&b.away_m);
            by_distance.then(a.chart.cmp(&b.chart))
        });
        found
    }

    fn outwards(&self, pos: DVec3) -> Outwards {
        let foot = pos.with_y(0.0);
        let [x, z] = [DVec3::X, DVec3::Z].map(|axis| self.chart.in_chart(foot, axis).xz());
        Outwards {
            to_frame: inverse(self.chart.frame(foot)),
            to_chart: DMat2::from_cols(x, z),
            radius_m: self.chart.radius_m,
        }
    }

    /// X/W and Z/W at a place of the ground plan, where a point has such.
    fn tangents(&self, at: DVec2) -> DVec2 {
        let point = self.chart.point(DVec3::new(at.x, 0.0, at.y));
        DVec2::new(point.x, point.z) / point.w
    }

    /// How far it is to a tile's square from a point of its model, metres.
    fn square_away_m(&self, point: DVec4) -> f64 {
        let edge = DVec2::splat(EDGE_TANH);
        away_rad(point, -edge, edge) * self.chart.radius_m
    }
}

impl Tiled for HyperbolicWorld {
    fn charts_within(&self, at: ChartPoint, reach_m: f64) -> Vec<ChartId> {
        let near = self.near_charts(at, reach_m).into_iter();
        near.map(|it| it.chart).collect()
    }

    fn boxes_within(
        &self,
        at: ChartPoint,
        reach_m: f64,
        boxes: &[[DVec2; 2]],
    ) -> Vec<(ChartId, Vec<Away>)> {
        if self.tiles.frame(at.chart).is_none() {
            return Vec::new();
        }
        let plan = |[low, high]: &[DVec2; 2]| {
            let middle = low.midpoint(*high);
            PlanBox {
                low: self.tangents(*low),
                high: self.tangents(*high),
                middle: self.level(DVec3::new(middle.x, 0.0, middle.y)),
            }
        };
        let plans: Vec<_> = boxes.iter().map(plan).collect();
        let (level, outwards) = (self.level(at.pos), self.outwards(at.pos));
        let aways = |it: NearChart| {
            let point = it.way * level;
            let back = outwards.to_frame * inverse(it.way);
            let away = |plan: &PlanBox| Away {
                nearest_m: away_rad(point, plan.low, plan.high) * self.chart.radius_m,
                way_m: outwards.way_m(back * plan.middle),
            };
            (it.chart, plans.iter().map(away).collect())
        };
        let near = self.near_charts(at, reach_m).into_iter();
        near.map(aways).collect()
    }

    fn away_m(&self, at: ChartPoint, chart: ChartId, low: DVec2, high: DVec2) -> f64 {
        let way = self.tiles.way(at.chart, chart);
        way.map_or(f64::INFINITY, |way| {
            let point = way * self.level(at.pos);
            away_rad(point, self.tangents(low), self.tangents(high)) * self.chart.radius_m
        })
    }

    fn level_way_m(&self, from: ChartPoint, to: ChartPoint) -> Option<DVec3> {
        let way = self.tiles.way(to.chart, from.chart)?;
        let outwards = self.outwards(from.pos);
        let along = outwards.way_m(outwards.to_frame * (way * self.level(to.pos)));
        Some(DVec3::new(along.x, to.pos.y - from.pos.y, along.y))
    }

    fn azimuths_rad(
        &self,
        at: ChartPoint,
        chart: ChartId,
        low: DVec2,
        high: DVec2,
    ) -> Option<[f64; 2]> {
        let (corners, middle) = self.plan_corners(at, chart, low, high)?;
        azimuths_rad(corners, middle)
    }

    /// The line X = a W is that of `tanh(x/R) = a`.
    fn grid_lines_m(&self, at: ChartPoint, chart: ChartId) -> Option<DVec2> {
        let point = self.tiles.way(at.chart, chart)? * self.level(at.pos);
        let lines = DVec2::new(point.x, point.z) / point.w;
        Some(DVec2::new(lines.x.atanh(), lines.y.atanh()) * self.chart.radius_m)
    }

    fn land_reach_m(&self, view_m: f64) -> f64 {
        let half_m = self.chart.half_m();
        // Where edges run through chunks, what is meshed past them counts: it costs as much as land.
        let past_m = if (half_m / f64::from(CHUNK_CELLS)).fract() == 0.0 {
            0.0
        } else {
            MESHED_PAST_M
        };
        let meshed = (1.0 + past_m / half_m).powi(2);
        let budget_m = self.disc_m(LAND_SHARE / meshed * (2.0 * view_m).powi(2));
        view_m.min(budget_m).min(LAND_RAD * self.chart.radius_m)
    }

    /// A disc of r has `2 pi R^2 (cosh(r/R) - 1)`.
    fn disc_m(&self, land_m2: f64) -> f64 {
        let radius_m = self.chart.radius_m;
        radius_m * (1.0 + land_m2 / (TAU * radius_m * radius_m)).acosh()
    }

    fn over(&self, chart: ChartId, side: u8) -> Option<(ChartId, u8)> {
        self.tiles.over(chart, side)
    }

    fn edges_from_first(&self, chart: ChartId) -> Option<usize> {
        Some(TilePath::from_number(chart.number()).ok()?.len())
    }

    fn joins(&self, chart: ChartId) -> Joins {
        self.tiles.joins(chart, || Joins::of(self, chart))
    }
}
