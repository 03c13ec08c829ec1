//! Pictures taken from elsewhere than the player's eye, through another lens and at another hour, while the world
//! stands still. Nothing of the world changes with them, so nothing has to be put back.

use antipode_geometry::{Atlas, ChartPoint, Eye};
use glam::DVec3;

use crate::lens::Lens;
use crate::player::wrap_angle;
use crate::scene::Scene;
use crate::tuning::{CAMERA_RADIUS_M, PITCH_LIMIT_RAD};
use crate::world::World;

/// A camera stops so far before it touches the ground, metres: what touches from the start is not told from what is in it.
const OFF_GROUND_M: f64 = 0.02;

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
    pub fn fly(&mut self, strategy: &dyn Atlas, by: DVec3) {
        self.go(strategy, self.way(by));
    }

    fn way(&self, by: DVec3) -> DVec3 {
        self.eye.right() * by.x + DVec3::Y * by.y + self.eye.front() * by.z
    }

    fn go(&mut self, strategy: &dyn Atlas, way: DVec3) {
        let eye = &mut self.eye;
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

impl Viewpoint {
    /// Moves as [`Viewpoint::fly`] does, but not into the ground: along it, and up where it rises. A camera that is in
    /// it, since land came where it was, gets out.
    pub(crate) fn fly_around_ground(&mut self, world: &World, by: DVec3) {
        let way = self.way(by);
        let level = way.with_y(0.0);
        let left = level - self.go_freely(world, level);
        if left != DVec3::ZERO {
            self.go_freely(world, DVec3::Y * left.length());
            self.go_freely(world, left);
        }
        self.go_freely(world, DVec3::Y * way.y);
    }

    /// Moves as far along a leg as is free, and tells how far that is. Over the equator legs turn with it.
    fn go_freely(&mut self, world: &World, leg: DVec3) -> DVec3 {
        let free = free_leg(world, self.eye.point, leg);
        self.go(&*world.strategy, free);
        free
    }
}

/// As much of a leg as keeps a camera off the ground.
fn free_leg(world: &World, from: ChartPoint, leg: DVec3) -> DVec3 {
    let (length_m, way) = (leg.length(), leg.normalize_or_zero());
    let ground = world.physics.chart(from.chart);
    let reach_m = length_m + OFF_GROUND_M;
    match ground.cast_sphere(from.pos, way, CAMERA_RADIUS_M, reach_m) {
        None => leg,
        Some(free_m) if free_m > 0.0 => way * (free_m - OFF_GROUND_M).clamp(0.0, length_m),
        Some(_) => {
            let into = world.ground.is_solid(from.moved(leg)) && !world.ground.is_solid(from);
            if into { DVec3::ZERO } else { leg }
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use std::time::Duration;

    use antipode_geometry::Geometry;

    use super::*;
    use crate::setup::WorldSetup;

    fn world(geometry: Geometry) -> Scene {
        let setup = WorldSetup {
            name: "Test".to_owned(),
            seed: 3,
            geometry,
            radius_m: 32.0,
            generator: antipode_terrain::Generator::default(),
            mode: crate::setup::Mode::default(),
            view_distance: 2,
        };
        let mut scene = Scene::open(setup, None).unwrap();
        assert!(scene.settle(Duration::from_mins(2)));
        scene
    }

    #[test]
    fn the_camera_of_pictures_flies_along_the_ground_and_not_into_it() {
        for geometry in Geometry::ALL {
            let scene = world(geometry);
            let mut view = Viewpoint::of(&scene);
            view.turn(0.0, -0.9);
            let (start, mut nearest) = (view.eye.point, f32::INFINITY);
            for _ in 0..400 {
                scene.fly_view(&mut view, DVec3::Z * 0.05);
                nearest = nearest.min(scene.sim.world.ground.density(view.eye.point));
            }
            assert!(nearest > 0.0, "{geometry:?}: {nearest} in the ground");
            assert!(
                nearest < 0.5,
                "{geometry:?}: {nearest}, never at the ground"
            );
            assert!(view.eye.point.pos.distance(start.pos) > 1.0);
            let low_m = view.eye.point.pos.y;
            for _ in 0..20 {
                scene.fly_view(&mut view, DVec3::Y * 0.05);
            }
            let risen_m = view.eye.point.pos.y - low_m;
            assert!(
                (risen_m - 1.0).abs() < 1e-9,
                "{geometry:?}: stuck, {risen_m} m"
            );
        }
    }
}
