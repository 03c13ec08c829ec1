//! How things stand: what a rule may ask about the world, its actors and the player before it changes anything. The eyes
//! of the player are here; what they meet is in `crosshair`.

use antipode_geometry::{ChartPoint, Eye};
use glam::DVec3;
use hecs::Entity;

use crate::actors::Actors;
use crate::aimed::ViewParams;
use crate::camera::{self, CameraMode, CameraPose};
use crate::car::camera as car_camera;
use crate::door_camera::{Followed, lead_through};
use crate::ground::chunks_near;
use crate::player::{self, Health, Player, Position};
use crate::projectile::Standing;
use crate::world::World;

/// Ground within this distance of a body must be there with its collider before the body moves, in metres.
const NEEDED_AROUND_M: f64 = 4.0;

/// The world, its actors and the player, to be looked at.
#[derive(Clone, Copy)]
pub(crate) struct Situation<'a> {
    pub world: &'a World,
    pub actors: &'a Actors,
    pub player: &'a Player,
}

impl<'a> Situation<'a> {
    /// That of these parts.
    pub fn of(world: &'a World, actors: &'a Actors, player: &'a Player) -> Self {
        Self {
            world,
            actors,
            player,
        }
    }

    /// Where the player's feet are.
    pub fn feet(&self) -> ChartPoint {
        self.actors.feet()
    }

    /// What the player aims through.
    pub fn aiming(&self) -> ViewParams {
        self.player.gaze.aiming()
    }

    /// The eye in the player's head, as the simulation has it.
    pub fn head(&self) -> Eye {
        self.head_through(&self.aiming())
    }

    /// The eye in the player's head, looking through that.
    pub fn head_through(&self, params: &ViewParams) -> Eye {
        if let Some(head) = car_camera::driver_head(*self, params) {
            return head;
        }
        let (position, look) = self.actors.player_stance();
        // Seen from behind, the body does not dip, and the camera would shake without a cause.
        let dip_m = match self.player.gaze.camera {
            CameraMode::First if params.dips => self.player.gaze.dip.depth_m(),
            CameraMode::First | CameraMode::Third => 0.0,
        };
        let behind_m = if params.dips {
            self.player.gaze.dip.behind_m()
        } else {
            0.0
        };
        let height_m = self.actors.tuning.eye_height_m() - dip_m - behind_m;
        player::eye(&position, &look, params.dial, height_m)
    }

    /// The camera, looking through that: on the other side of a door that is between it and whom it follows.
    pub fn camera_through(&self, params: &ViewParams) -> CameraPose {
        let mut pose = self.camera_beside(params);
        if let Some((leaf, doors)) = pose.through.zip(self.world.doors.as_ref()) {
            let space = &*params.strategy;
            pose.about = doors.pictured(space, leaf, &pose.eye, pose.about);
            pose.eye = doors.eye(space, leaf, &pose.eye);
        }
        pose
    }

    /// The camera as if there were no doors, in the chart of whom it follows: what lies beyond the head lies so from there, too.
    pub fn camera_beside(&self, params: &ViewParams) -> CameraPose {
        if let Some(mut camera) = car_camera::driver_camera(*self, params) {
            if let Some(car) = self.actors.driven_car() {
                let followed = Followed {
                    middle: car.middle(),
                    top: car.middle(),
                };
                let free = camera.eye;
                lead_through(self.world, params, &followed, free, &mut camera);
            }
            return camera;
        }
        let mut head = self.head_through(params);
        let mode = self.player.gaze.camera;
        let dead_s = self.player.condition.dead_s();
        if let Some(dead_s) = dead_s.filter(|_| mode == CameraMode::First) {
            let lies_at_once = params.reduced_motion;
            head = camera::fallen(&head, if lies_at_once { f64::INFINITY } else { dead_s });
        }
        let mut camera = camera::place(mode, &head, &self.world.physics);
        if mode == CameraMode::Third {
            let followed = Followed {
                middle: head.point.moved(DVec3::NEG_Y * (0.5 * head.lift_m)),
                top: head.point,
            };
            let free = camera::free_behind(&head);
            lead_through(self.world, params, &followed, free, &mut camera);
        }
        camera
    }

    /// How far the head lies beyond an eye that looks through that, metres: near a wall the camera stands closer than it
    /// would like.
    pub fn past_head_m(&self, params: &ViewParams, eye: &Eye) -> f64 {
        match self.player.gaze.camera {
            CameraMode::First => 0.0,
            CameraMode::Third => {
                let head = self.head_through(params);
                params.strategy.distance_m(eye.point, head.point, eye)
            }
        }
    }

    /// Everyone who can be struck, where they stand; the dead and spectators cannot.
    pub fn standing(&self) -> Vec<Standing> {
        let (actors, tuning) = (self.actors, &self.actors.tuning);
        let mut query = actors.ecs.query::<(Entity, &Position, &Health)>();
        let mut all: Vec<Standing> = query
            .iter()
            .filter(|(entity, _, health)| {
                // Whatever meets the car meets its driver.
                let is_there =
                    *entity != actors.player || !(self.player.flying || actors.cars.is_driving());
                health.0 > 0.0 && is_there
            })
            .map(|(entity, position, _)| Standing {
                entity,
                feet: position.0,
                height_m: tuning.height_m,
                radius_m: tuning.radius_m,
            })
            .collect();
        all.sort_unstable_by_key(|it| it.entity.id());
        all
    }

    /// Where the player stands up again.
    pub fn start(&self) -> ChartPoint {
        let start = self.player.start;
        start.unwrap_or_else(|| self.world.ground.spawn_point())
    }
}

/// Whether the ground around the player exists with its colliders, whatever the view has made of it.
pub(crate) fn is_ground_ready(world: &World, actors: &Actors) -> bool {
    chunks_near(&*world.strategy, actors.feet(), NEEDED_AROUND_M)
        .into_iter()
        .all(|coord| world.streamer.is_firm(coord))
}
