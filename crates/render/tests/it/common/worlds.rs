//! Worlds as the game opens them, to be stood in, dug and looked at.

use std::time::Duration;

use antipode_frame::Frame;
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::{Actions, Scene, WorldSetup};
use glam::DVec3;

const LIMIT: Duration = Duration::from_mins(5);
const ASPECT: f64 = 16.0 / 9.0;

/// A world that is played without a window.
pub struct World {
    pub scene: Scene,
    /// What of it was shown in frames.
    /// Lines of its pictures.
    lines: u32,
}

impl World {
    /// A new world, of which so many chunks are loaded; its land is there.
    pub fn new(geometry: Geometry, seed: u64, radius_m: f64, view_distance: u32) -> Self {
        let setup = WorldSetup {
            name: String::new(),
            seed,
            geometry,
            radius_m,
            generator: antipode_scene::Generator::OneBiome,
            mode: antipode_scene::Mode::default(),
            view_distance,
        };
        let mut scene = Scene::open(setup, None).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        let mut world = Self { scene, lines: 360 };
        world.settle();
        world
    }

    /// Has pictures of so many lines.
    pub fn of_lines(mut self, lines: u32) -> Self {
        self.lines = lines;
        self.scene.set_picture_height_px(lines);
        self
    }

    pub fn settle(&mut self) {
        assert!(self.scene.settle(LIMIT));
    }

    /// Steps of a 60th of a second.
    pub fn steps(&mut self, count: usize, actions: &Actions) {
        for _ in 0..count {
            self.scene.step(actions);
            assert!(self.scene.wait_for_step(LIMIT));
        }
    }

    pub fn rest(&mut self) {
        self.steps(40, &Actions::default());
    }

    pub fn aim(&mut self, yaw_deg: f64, pitch_deg: f64) {
        self.scene
            .aim(f64::to_radians(yaw_deg), f64::to_radians(pitch_deg));
    }

    /// Stands on the ground of a column; `None` in the chart of A.
    pub fn stand(&mut self, chart: ChartId, x: f64, z: f64) {
        let field = self.scene.field().clone();
        let y = field.surface_height(chart, x, z) + 0.2;
        let point = ChartPoint::new(chart, DVec3::new(x, y, z));
        self.scene.teleport(point);
        assert!(self.scene.wait_for_step(LIMIT));
        self.settle();
        self.rest();
    }

    /// Uses the strong pickaxe for some steps where the crosshair points: digs, or builds.
    pub fn use_pickaxe(&mut self, builds: bool, steps: usize) {
        let take = Actions {
            slot: Some(3),
            ..Actions::default()
        };
        self.steps(1, &take);
        let actions = Actions {
            primary: !builds,
            secondary: builds,
            ..Actions::default()
        };
        self.steps(steps, &actions);
    }

    /// What is seen, with nothing in the way.
    pub fn frame(&mut self) -> Frame {
        let fov_y_rad = self.scene.viewing().fov_y_rad;
        let mut frame = self.scene.frame(fov_y_rad, ASPECT, 1);
        frame.view.hand = None;
        frame.content_mut().marker = None;
        frame
    }

    /// Width and height of its pictures.
    pub fn size(&self) -> (u32, u32) {
        ((f64::from(self.lines) * ASPECT).round() as u32, self.lines)
    }
}
