//! Pictures taken from elsewhere than the player's eye, through another lens and at another hour, while the world
//! stands still. Nothing of the world changes with them, so nothing has to be put back.

use antipode_geometry::{Eye, Strategy};
use glam::DVec3;

use crate::frame::Frame;
use crate::lens::Lens;
use crate::player::wrap_angle;
use crate::scene::Scene;
use crate::tuning::PITCH_LIMIT_RAD;

/// From where, through what and when a picture is taken.
#[derive(Clone, Debug)]
pub struct Viewpoint {
    /// The camera.
    pub eye: Eye,
    /// Map and dial.
    pub lens: Lens,
    /// Time of day in seconds.
    pub time_of_day_s: f64,
    /// Whether figures are in the picture.
    pub figures: bool,
}

impl Viewpoint {
    /// What the player sees now; a dial on its way is where it goes.
    pub fn of(scene: &Scene) -> Self {
        let mut lens = scene.lens().clone();
        lens.settle();
        Self {
            eye: Eye {
                dial: lens.value(),
                ..scene.eye()
            },
            lens,
            time_of_day_s: scene.time_of_day_s(),
            figures: true,
        }
    }

    /// Turns the camera by the angles given in radians, to the right and up, keeping short of the vertical.
    pub fn turn(&mut self, yaw_rad: f64, pitch_rad: f64) {
        self.eye.yaw = wrap_angle(self.eye.yaw + yaw_rad);
        self.eye.pitch = (self.eye.pitch + pitch_rad).clamp(-PITCH_LIMIT_RAD, PITCH_LIMIT_RAD);
    }

    /// Moves the camera by metres of the chart to its right, straight up and the way it looks; through everything,
    /// over the equator of a closed world too, and between the heights that such a world has.
    pub fn fly(&mut self, strategy: &dyn Strategy, by: DVec3) {
        let eye = &mut self.eye;
        let way = eye.right() * by.x + DVec3::Y * by.y + eye.front() * by.z;
        eye.point = eye.point.moved(way);
        if let Some(limits) = strategy.limits() {
            let y = &mut eye.point.pos.y;
            *y = y.clamp(limits.bedrock_m, limits.ceiling_m);
        }
        if let Some(crossing) = strategy.cross(eye.point) {
            eye.point = crossing.point;
            eye.yaw = wrap_angle(eye.yaw - crossing.turn_rad);
        }
    }

    /// Sets the dial of its picture. Returns false when out of range or there is none.
    pub fn set_dial(&mut self, value: f64) -> bool {
        let set = match self.lens.bend() {
            Some(_) => self.lens.set_bend_dial(value),
            None => self.lens.set_curvature(value),
        };
        self.eye.dial = self.lens.value();
        set
    }
}

impl Scene {
    /// The snapshot to draw from a viewpoint. Terrain changes are handed over once, as by [`Scene::frame`].
    pub fn frame_from(
        &mut self,
        view: &Viewpoint,
        fov_y_rad: f64,
        aspect: f64,
        world_id: u64,
    ) -> Frame {
        let figures = if view.figures {
            self.figures_seen_by(&view.eye, true)
        } else {
            Vec::new()
        };
        let strategy = view.lens.strategy();
        let sky = crate::day::sky(view.time_of_day_s, &**strategy, &view.eye);
        Frame {
            eye: view.eye,
            strategy: std::sync::Arc::clone(strategy),
            sky,
            figures,
            hand: None,
            lights: self.lights(&view.eye),
            marker: None,
            fog_distance_m: self.fog_distance_from_m(&view.eye, &**strategy),
            ..self.frame(fov_y_rad, aspect, world_id)
        }
    }

    /// Has land made around a camera that is elsewhere than the player, or around the player again.
    pub fn watch_from(&mut self, eye: Option<Eye>) {
        self.watched = eye;
    }
}
