//! The solid ground of a world, chart by chart.
//!
//! A place is a place of a chart, so there may be any number of charts, and none is in another's way. What lies near an
//! edge is written in each chart that comes there, and a body that crosses asks in the other chart from then on.

use std::collections::BTreeMap;

use antipode_geometry::{ChartId, ChartPoint};

use crate::{ChartGround, Obstacle, Solid};

/// The ground of all charts.
#[derive(Debug, Default)]
pub struct PhysicsWorld {
    charts: BTreeMap<ChartId, ChartGround>,
    /// How often what is solid may have changed.
    changes: u64,
    /// What a chart has in which nothing is solid.
    nothing: ChartGround,
}

impl PhysicsWorld {
    /// Without ground.
    pub fn new() -> Self {
        Self::default()
    }

    /// What is solid in a chart, to be asked.
    pub fn chart(&self, chart: ChartId) -> &ChartGround {
        self.charts.get(&chart).unwrap_or(&self.nothing)
    }

    /// What is solid in a chart, to be changed.
    pub fn chart_mut(&mut self, chart: ChartId) -> &mut ChartGround {
        self.changes += 1;
        self.charts.entry(chart).or_default()
    }

    /// Grows whenever what is solid may have changed, but for obstacles: what was found is right while this stays.
    pub(crate) fn changes(&self) -> u64 {
        self.changes
    }

    /// Moves the floating origins of charts that have ground to where bodies are, each as
    /// [`ChartGround::recentre`] says: first the player's place, and one in every other chart near. The player's chart
    /// keeps its origin without ground, too; any other in which nothing is solid is forgotten.
    pub fn recentre(&mut self, player: ChartPoint, others: impl Iterator<Item = ChartPoint>) {
        let own = player.chart;
        self.charts
            .retain(|chart, ground| *chart == own || !ground.is_empty());
        let here = self.charts.entry(own).or_default();
        here.recentre(player.pos);
        for focus in others.filter(|focus| focus.chart != own) {
            if let Some(ground) = self.charts.get_mut(&focus.chart) {
                ground.recentre(focus.pos);
            }
        }
    }

    /// Says which small solids stand on the terrain, in place of those that did.
    pub fn set_solids(&mut self, solids: &[Solid]) {
        self.changes += 1;
        for it in solids {
            self.charts.entry(it.chart()).or_default();
        }
        for (chart, ground) in &mut self.charts {
            let own = solids.iter().filter(|it| it.chart() == *chart);
            ground.set_solids(&own.cloned().collect::<Vec<_>>());
        }
    }

    /// Says what characters cannot walk through besides the terrain, in place of what was said before.
    pub fn set_obstacles(&mut self, obstacles: Vec<Obstacle>) {
        for ground in self.charts.values_mut() {
            ground.obstacles_mut().clear();
        }
        for obstacle in obstacles {
            let ground = self.charts.entry(obstacle.chart).or_default();
            ground.obstacles_mut().push(obstacle);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::ChunkCoord;
    use glam::{DVec3, IVec3};

    use super::*;
    use crate::TerrainCollider;

    /// Level ground at some height over all of a chunk, in charts 5 and 9.
    fn floors(heights: [f32; 2]) -> PhysicsWorld {
        let mut world = PhysicsWorld::new();
        for (chart, y) in [5, 9].map(ChartId::new).into_iter().zip(heights) {
            let positions = [
                [0.0, y, 0.0],
                [0.0, y, 32.0],
                [32.0, y, 0.0],
                [32.0, y, 32.0],
            ];
            let collider = TerrainCollider::build(&positions, &[[1, 3, 2], [0, 1, 2]]);
            let coord = ChunkCoord::new(chart, IVec3::ZERO);
            world
                .chart_mut(chart)
                .set_terrain(coord, DVec3::ZERO, collider);
        }
        world
    }

    fn below(world: &PhysicsWorld, chart: u128) -> Option<f64> {
        let from = DVec3::new(7.0, 20.0, 9.0);
        let hit = world
            .chart(ChartId::new(chart))
            .cast_ray(from, DVec3::NEG_Y, 40.0);
        hit.map(|hit| hit.distance_m)
    }

    #[test]
    fn each_chart_has_its_own_ground_at_the_same_place() {
        let world = floors([4.0, 11.0]);
        assert!((below(&world, 5).unwrap() - 16.0).abs() < 1e-5);
        assert!((below(&world, 9).unwrap() - 9.0).abs() < 1e-5);
        assert_eq!(below(&world, 7), None);
    }

    #[test]
    fn a_chart_without_ground_is_forgotten_and_the_players_own_is_not() {
        let mut world = floors([4.0, 11.0]);
        let far = ChartPoint::new(ChartId::new(5), DVec3::X * 900.0);
        for chart in [5, 9].map(ChartId::new) {
            let coord = ChunkCoord::new(chart, IVec3::ZERO);
            world.chart_mut(chart).set_terrain(coord, DVec3::ZERO, None);
        }
        world.recentre(far, std::iter::empty());
        assert_eq!(world.charts.len(), 1);
        assert_eq!(world.chart(far.chart).origin(), DVec3::X * 896.0);
        let next = ChartPoint::new(ChartId::new(9), DVec3::ZERO);
        world.recentre(next, std::iter::once(far));
        assert!(world.charts.len() == 1 && world.charts.contains_key(&next.chart));
    }

    #[test]
    fn rays_meet_a_solid_where_it_stands_until_it_is_gone() {
        let mut world = floors([4.0, 4.0]);
        let top = [
            [-1.0, 2.0, -1.0],
            [-1.0, 2.0, 1.0],
            [1.0, 2.0, 1.0],
            [1.0, 2.0, -1.0],
        ];
        let shape = TerrainCollider::build(&top, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        let at = |x: f64| Solid::new(ChartId::new(9), DVec3::new(x, 4.0, 9.0), shape.clone());
        world.set_solids(&[at(7.0), at(20.0)]);
        assert_eq!(below(&world, 9), Some(14.0));
        assert_eq!(below(&world, 5), Some(16.0), "of the other chart");
        let far = ChartPoint::new(ChartId::new(9), DVec3::X * 900.0);
        world.recentre(far, std::iter::empty());
        assert_eq!(below(&world, 9), Some(14.0), "from another origin");
        world.set_solids(&[at(20.0)]);
        assert_eq!(below(&world, 9), Some(16.0));
        assert_eq!(world.chart(ChartId::new(9)).solid_count(), 1);
    }

    #[test]
    fn an_obstacle_is_in_its_own_chart_only() {
        let mut world = floors([4.0, 4.0]);
        let chart = ChartId::new(9);
        let corner = DVec3::new(7.0, 5.0, 9.0);
        let face = [corner, corner + DVec3::X, corner + DVec3::Y];
        world.set_obstacles(vec![Obstacle::new(chart, [face].into())]);
        let near = |chart| {
            let ground = world.chart(chart);
            ground.obstacles_in(corner - 1.0, corner + 1.0).count()
        };
        assert_eq!([near(ChartId::new(5)), near(chart)], [0, 1]);
    }
}
