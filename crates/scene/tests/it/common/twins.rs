//! The same world twice: flat in one chart, and in a chart for each square of 64 m, each turned its own way. What is done
//! to one is done to the other, and what is told of the other is told in the coordinates of the one.

use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, Geometry};
use antipode_scene::{Actions, Scene};
use antipode_testing::tiled::TiledFlat;
use glam::DVec3;

use super::{LIMIT, setup};

/// A world of one chart and one of many.
pub struct Twins {
    pub one: Scene,
    pub many: Scene,
}

impl Twins {
    pub fn new() -> Self {
        let setup = setup(Geometry::Euclidean);
        let mut twins = Self {
            one: Scene::open(setup.clone(), None).unwrap(),
            many: Scene::open_in(Arc::new(TiledFlat), setup, None, 2).unwrap(),
        };
        twins.wait();
        twins
    }

    fn wait(&mut self) {
        for scene in [&mut self.one, &mut self.many] {
            assert!(scene.wait_for_step(LIMIT));
        }
    }

    /// Puts both players on the ground at a place of the plan, facing so.
    pub fn stand(&mut self, x: f64, z: f64, yaw_rad: f64, pitch_rad: f64) {
        let pos = DVec3::new(x, self.ground_m(x, z) + 0.2, z);
        self.one.teleport(ChartPoint::a(pos));
        self.many.teleport(TiledFlat::at(pos));
        self.aim(yaw_rad, pitch_rad);
        self.wait();
    }

    pub fn aim(&mut self, yaw_rad: f64, pitch_rad: f64) {
        self.one.aim(yaw_rad, pitch_rad);
        let turn_rad = turn_rad(self.many.feet().chart);
        self.many.aim(yaw_rad - turn_rad, pitch_rad);
    }

    /// Height of the untouched ground, metres.
    pub fn ground_m(&self, x: f64, z: f64) -> f64 {
        self.one
            .field()
            .clone()
            .surface_height(ChartId::FIRST, x, z)
    }

    /// Does to each what can be said of a place and a heading.
    pub fn arrange(&mut self, at: DVec3, yaw_rad: f64, deed: impl Fn(&mut Scene, ChartPoint, f64)) {
        deed(&mut self.one, ChartPoint::a(at), yaw_rad);
        let point = TiledFlat::at(at);
        deed(&mut self.many, point, yaw_rad - turn_rad(point.chart));
        self.wait();
    }

    /// A step of both.
    pub fn step(&mut self, actions: &Actions) {
        for scene in [&mut self.one, &mut self.many] {
            scene.step(actions);
            assert!(scene.wait_for_step(LIMIT));
        }
    }

    /// How far the players are apart, metres.
    pub fn apart_m(&self) -> f64 {
        apart_m(self.one.feet(), self.many.feet())
    }
}

/// By how much a heading in a chart is less than the same one in the chart of the flat world, radians.
fn turn_rad(chart: ChartId) -> f64 {
    let middle = ChartPoint::a(DVec3::ZERO);
    TiledFlat.carry(middle, chart).unwrap().turn_rad
}

/// How far a place of the world of many charts is from one of the other, metres.
pub fn apart_m(one: ChartPoint, many: ChartPoint) -> f64 {
    TiledFlat::common(many).distance(one.pos)
}
