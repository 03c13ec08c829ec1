//! Finds a way over the ground as it is, with its edits: a search among columns that stand a metre apart around the walker.
//!
//! Columns are those of the walker's chart, past its rim too; each is asked for in the chart that its point belongs to.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;

use antipode_geometry::{ChartId, ChartPoint, Strategy};
use glam::DVec3;
use pathfinding::prelude::astar;

use super::bearing::{ahead, way};
use crate::ground::Ground;
use crate::pick::over;

/// Distance between columns, in metres.
const COLUMN_M: f64 = 1.0;
/// How far about a place that turned out to be no way there is none, in metres.
pub(crate) const BLOCKED_M: f64 = 0.8 * COLUMN_M;
/// How far a way is planned ahead, and how far from the start columns are looked at, in metres.
const PLANS_M: f64 = 9.0;
pub(crate) const LOOKS_M: f64 = 12.0;
/// Ground within this distance is asked about by a plan, to each side and up and down, in metres.
pub(crate) const ASKS_M: f64 = 14.0;
/// From how far above the feet, and down to how far below, the floor of a next column is looked for, and in what steps,
/// in metres.
const FLOOR_ABOVE_M: f64 = 1.3;
const FLOOR_BELOW_M: f64 = 3.1;
const FLOOR_STEP_M: f64 = 0.4;
/// Heights over a floor that must be free, in metres.
const FREE_AT_M: [f64; 3] = [0.5, 1.1, 1.8];
/// Steepest way that is walked up, as rise over level distance: short of the character's limit of fifty degrees. The field
/// is linear over a metre, so a ledge is either such a slope or higher than a jump: nobody needs to jump.
const STEEPEST: f64 = 0.95;
/// Unevenness of a floor that is let pass besides, in metres.
const UNEVEN_M: f64 = 0.05;
/// Deepest that is gone down at once, in metres.
const DROPS_M: f64 = 2.6;
/// What a metre of drop costs besides, in metres of way.
const DROP_COSTS: f64 = 1.5;
/// Most columns that a search goes on from.
const MOST_EXPANDED: usize = 350;
/// A way that ends nowhere at least this much nearer to the goal is none, in metres.
const LEAST_GAIN_M: f64 = 0.8;
/// Costs are counted in millimetres.
const PER_M: f64 = 1000.0;

/// A way to go.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Route {
    /// Where the feet will be, the last place first.
    pub steps: Vec<ChartPoint>,
    /// Whether it leads to what was asked for, or as far towards it as is planned; else only nearer.
    pub reaches: bool,
}

/// The ground to walk on.
pub(crate) struct WalkableGround<'a> {
    pub strategy: &'a dyn Strategy,
    pub ground: &'a Ground,
    /// Places that are no way, and how far about them there is none, in metres.
    pub blocked: &'a [(ChartPoint, f64)],
}

/// A column and its floor, relative to the start: indices along two axes, and the height in centimetres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Node {
    x: i32,
    z: i32,
    y_cm: i32,
}

impl WalkableGround<'_> {
    /// A way from one place towards another: straight where that can be walked, else round what is in the way.
    /// Nothing where there is no way that leads nearer.
    pub fn route(&self, from: ChartPoint, to: ChartPoint) -> Option<Route> {
        let there = way(self.strategy, from, to);
        let target = if there.level_m > PLANS_M {
            ahead(self.strategy, from, there.heading, PLANS_M)
        } else {
            to
        };
        let target = over(self.strategy, from, target);
        if let Some(end) = self.straight(from, target.pos) {
            return Some(Route {
                steps: vec![self.placed(from.chart, end)],
                reaches: true,
            });
        }
        Search::new(self, from, target.pos).run()
    }

    /// The floor at about the height of a place, with room to stand on it.
    pub fn stand(&self, place: ChartPoint) -> Option<ChartPoint> {
        let floor = self.floor(place.chart, place.pos)?;
        Some(self.placed(place.chart, floor))
    }

    /// Whether one can walk straight there, and where the feet are then.
    fn straight(&self, from: ChartPoint, to: DVec3) -> Option<DVec3> {
        let level = (to - from.pos).with_y(0.0);
        // Goals are whole steps away, and a last digit is not to make one step more.
        let count = (level.length() / (0.5 * COLUMN_M) - 1e-6).ceil().max(1.0);
        let mut at = from.pos;
        for index in 1..=count as u32 {
            let next = from.pos + level * (f64::from(index) / count);
            let floor = self.floor(from.chart, next.with_y(at.y))?;
            let run_m = (floor - at).with_y(0.0).length();
            if (floor.y - at.y).abs() > STEEPEST * run_m + UNEVEN_M || self.is_blocked(from, floor)
            {
                return None;
            }
            at = floor;
        }
        Some(at)
    }

    fn is_blocked(&self, from: ChartPoint, at: DVec3) -> bool {
        self.blocked.iter().any(|(spot, about_m)| {
            let spot = over(self.strategy, from, *spot).pos;
            (spot - at).with_y(0.0).length() < *about_m
        })
    }

    /// The point in the chart that it belongs to.
    fn placed(&self, chart: ChartId, pos: DVec3) -> ChartPoint {
        let point = ChartPoint::new(chart, pos);
        self.strategy.cross(point).map_or(point, |over| over.point)
    }

    fn density(&self, chart: ChartId, pos: DVec3) -> f64 {
        f64::from(self.ground.density(self.placed(chart, pos)))
    }

    /// The floor of a column near a height, with room to stand on it.
    fn floor(&self, chart: ChartId, near: DVec3) -> Option<DVec3> {
        let at = |y: f64| self.density(chart, near.with_y(y));
        let mut high = (near.y + FLOOR_ABOVE_M, at(near.y + FLOOR_ABOVE_M));
        let bottom = near.y - FLOOR_BELOW_M;
        while high.0 > bottom {
            let y = high.0 - FLOOR_STEP_M;
            let low = (y, at(y));
            if high.1 >= 0.0 && low.1 < 0.0 {
                // The field is nearly linear over so short a way.
                let middle = high.0 - FLOOR_STEP_M * high.1 / (high.1 - low.1);
                let free = FREE_AT_M.iter().all(|rise| at(middle + rise) > 0.0);
                return free.then(|| near.with_y(middle));
            }
            high = low;
        }
        None
    }

    /// What it costs in metres to go from a floor to the next, if one can; both free to stand on.
    fn cost_m(&self, chart: ChartId, from: DVec3, to: DVec3) -> Option<f64> {
        let rise = to.y - from.y;
        let run_m = (to - from).with_y(0.0).length();
        if rise < -DROPS_M {
            return None;
        }
        let half = from.midpoint(to).with_y(from.y);
        let middle = self.floor(chart, half);
        let walks = middle.is_some_and(|middle| {
            let steepest = STEEPEST * 0.5 * run_m + UNEVEN_M;
            (middle.y - from.y).abs() <= steepest && (to.y - middle.y).abs() <= steepest
        });
        if walks {
            return Some(run_m.hypot(rise));
        }
        (rise < -0.3).then_some(run_m - DROP_COSTS * rise)
    }
}

/// One search.
struct Search<'a> {
    land: &'a WalkableGround<'a>,
    from: ChartPoint,
    to: DVec3,
    /// The first axis of the columns: that of the chart which is nearest to the way to the goal. So of two ways that are
    /// as long the same is found whichever way the chart lies, but for goals exactly on a diagonal.
    first: DVec3,
    expanded: Cell<usize>,
    /// The node nearest to the goal so far.
    best: Cell<(u64, Node)>,
    floors: RefCell<HashMap<Node, Option<Node>>>,
    start: Node,
}

impl<'a> Search<'a> {
    fn new(land: &'a WalkableGround<'a>, from: ChartPoint, to: DVec3) -> Self {
        let start = Node {
            x: 0,
            z: 0,
            y_cm: 0,
        };
        let way = to - from.pos;
        let first = if way.x.abs() >= way.z.abs() {
            DVec3::X * way.x.signum()
        } else {
            DVec3::Z * way.z.signum()
        };
        let search = Self {
            land,
            from,
            to,
            first,
            expanded: Cell::new(0),
            best: Cell::new((u64::MAX, start)),
            floors: RefCell::default(),
            start,
        };
        search.best.set((search.left(start), start));
        search
    }

    fn pos(&self, node: Node) -> DVec3 {
        let second = DVec3::new(-self.first.z, 0.0, self.first.x);
        let level = self.first * f64::from(node.x) + second * f64::from(node.z);
        self.from.pos + level * COLUMN_M + DVec3::Y * (f64::from(node.y_cm) * 0.01)
    }

    /// Millimetres still to go over the level.
    fn left(&self, node: Node) -> u64 {
        ((self.to - self.pos(node)).with_y(0.0).length() * PER_M) as u64
    }

    fn run(&self) -> Option<Route> {
        let near = |node: &Node| self.left(*node) <= (0.75 * COLUMN_M * PER_M) as u64;
        let found = self.search(near);
        let reaches = found.is_some();
        let path = if let Some(path) = found {
            path
        } else {
            let (left, best) = self.best.get();
            if left + (LEAST_GAIN_M * PER_M) as u64 > self.left(self.start) {
                return None;
            }
            self.expanded.set(0);
            self.search(|node| *node == best)?
        };
        let placed = |node: &Node| self.land.placed(self.from.chart, self.pos(*node));
        let mut steps: Vec<_> = path.iter().skip(1).map(placed).collect();
        steps.reverse();
        Some(Route { steps, reaches })
    }

    fn search(&self, success: impl Fn(&Node) -> bool) -> Option<Vec<Node>> {
        astar(
            &self.start,
            |node| self.neighbours(*node),
            |node| self.left(*node),
            |node| success(node),
        )
        .map(|(path, _)| path)
    }

    /// The columns around that one can go to, and what it costs. Past corners one needs both sides.
    fn neighbours(&self, node: Node) -> Vec<(Node, u64)> {
        let count = self.expanded.get() + 1;
        self.expanded.set(count);
        let left = self.left(node);
        if left < self.best.get().0 {
            self.best.set((left, node));
        }
        if count > MOST_EXPANDED {
            return Vec::new();
        }
        let mut sides = [None; 4];
        for (side, (dx, dz)) in [(1, 0), (0, 1), (-1, 0), (0, -1)].into_iter().enumerate() {
            sides[side] = self.reached(node, dx, dz);
        }
        let mut found: Vec<_> = sides.iter().copied().flatten().collect();
        for side in 0..4 {
            let next = (side + 1) % 4;
            if sides[side].is_some() && sides[next].is_some() {
                let (dx, dz) = [(1, 1), (-1, 1), (-1, -1), (1, -1)][side];
                found.extend(self.reached(node, dx, dz));
            }
        }
        found
    }

    fn reached(&self, node: Node, dx: i32, dz: i32) -> Option<(Node, u64)> {
        let (x, z) = (node.x + dx, node.z + dz);
        if f64::from(x.abs().max(z.abs())) * COLUMN_M > LOOKS_M {
            return None;
        }
        let column = Node {
            x,
            z,
            y_cm: node.y_cm,
        };
        let next = self.floor(column)?;
        let cost_m = self
            .land
            .cost_m(self.from.chart, self.pos(node), self.pos(next))?;
        Some((next, (cost_m * PER_M) as u64))
    }

    /// The floor of a column near the height of the node asked for, each looked for once.
    fn floor(&self, column: Node) -> Option<Node> {
        if let Some(known) = self.floors.borrow().get(&column) {
            return *known;
        }
        let found = self
            .land
            .floor(self.from.chart, self.pos(column))
            .filter(|floor| !self.land.is_blocked(self.from, *floor))
            .map(|floor| Node {
                y_cm: ((floor.y - self.from.pos.y) * 100.0).round() as i32,
                ..column
            });
        self.floors.borrow_mut().insert(column, found);
        found
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, reason = "tests fail by panicking")]
    use std::sync::Arc;

    use antipode_geometry::{ChunkCoord, Geometry, strategy};
    use antipode_physics::PhysicsWorld;
    use antipode_streaming::Chunk;
    use antipode_terrain::{Field, Samples};
    use glam::IVec3;

    use super::*;

    /// Land of one chunk whose floor is at the height that is told for each place.
    fn land(height: impl Fn(f64, f64) -> f64) -> Ground {
        let space = strategy(Geometry::Euclidean, 0.0);
        let mut ground = Ground::new(Arc::new(Field::new(1, space)));
        let samples = Samples::from_fn(|p| (p.y - height(p.x, p.z)) as f32);
        let chunk = Chunk {
            coord: ChunkCoord {
                chart: ChartId::FIRST,
                index: IVec3::ZERO,
            },
            mesh: Arc::default(),
            collider: None,
            samples: Some(Arc::new(samples)),
        };
        ground.put(chunk, true, &mut PhysicsWorld::new());
        ground
    }

    fn route(ground: &Ground, from: DVec3, to: DVec3) -> Option<Route> {
        let space = strategy(Geometry::Euclidean, 0.0);
        let land = WalkableGround {
            strategy: &*space,
            ground,
            blocked: &[],
        };
        land.route(ChartPoint::a(from), ChartPoint::a(to))
    }

    const FROM: DVec3 = DVec3::new(10.5, 6.5, 14.5);
    const TO: DVec3 = DVec3::new(18.5, 6.5, 14.5);

    #[test]
    fn over_open_ground_the_way_is_straight() {
        let ground = land(|x, _| 6.5 + 0.3 * (x - 10.5));
        let route = route(&ground, FROM, TO).expect("a slope is a way");
        assert!(route.reaches && route.steps.len() == 1, "{route:?}");
        let end = route.steps[0].pos;
        assert!((end.y - (6.5 + 0.3 * 8.0)).abs() < 0.05, "{end}");
    }

    #[test]
    fn walls_and_pits_are_gone_round() {
        for height_m in [12.5, 0.5] {
            let in_the_way = |x: f64, z: f64| (13.0..16.0).contains(&x) && z < 19.0;
            let ground = land(|x, z| if in_the_way(x, z) { height_m } else { 6.5 });
            let route = route(&ground, FROM, TO).expect("there is a way round");
            assert!(route.reaches, "{height_m}");
            let mut farthest: f64 = 0.0;
            for step in &route.steps {
                let at = step.pos;
                assert!((at.y - 6.5).abs() < 0.6, "{height_m}: {at}");
                farthest = farthest.max(at.z);
            }
            assert!(farthest > 18.9, "{height_m}: through it at {farthest}");
        }
    }

    #[test]
    fn what_is_steep_is_climbed_and_a_wall_or_a_cliff_without_end_is_no_way() {
        let step = |rise_m: f64| land(move |x, _| if x > 14.0 { 6.5 + rise_m } else { 6.5 });
        let up = route(&step(0.9), FROM, TO).expect("a slope of 42 degrees");
        assert!(up.reaches, "{up:?}");
        let down = route(&step(-2.0), FROM, TO).expect("one can drop so deep");
        assert!(down.reaches, "{down:?}");
        let wall = route(&step(6.0), FROM, TO);
        assert!(wall.is_none_or(|route| !route.reaches));
        let cliff = route(&step(-6.0), FROM, TO);
        assert!(cliff.is_none_or(|route| !route.reaches));
    }

    #[test]
    fn a_place_that_was_no_way_is_gone_round() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let ground = land(|_, _| 6.5);
        let blocked = [(ChartPoint::a(DVec3::new(14.5, 6.5, 14.5)), BLOCKED_M)];
        let land = WalkableGround {
            strategy: &*space,
            ground: &ground,
            blocked: &blocked,
        };
        let route = land
            .route(ChartPoint::a(FROM), ChartPoint::a(TO))
            .expect("there is room beside it");
        let clear = |step: &ChartPoint| (step.pos - blocked[0].0.pos).length() > 0.7;
        assert!(route.reaches && route.steps.iter().all(clear), "{route:?}");
    }
}
