//! What the probe says of the scene at a moment.

use antipode_geometry::{ChartPoint, Hemisphere, HyperbolicMap};
use glam::DVec3;

use crate::car::CarView;
use crate::day;
use crate::item::Item;
use crate::player::Health;
use crate::probe::{
    BotProbe, CameraProbe, CarProbe, ChunkProbe, DropProbe, LampProbe, MarkerProbe, PlayerProbe,
    Probe, ProjectileProbe, SlotProbe, TerrainProbe, WheelProbe,
};
use crate::scene::Scene;
use crate::tuning::FULL_HEALTH;

fn hemisphere(point: ChartPoint) -> char {
    match point.hemisphere {
        Hemisphere::A => 'A',
        Hemisphere::B => 'B',
    }
}

fn car_probe(car: &CarView) -> CarProbe {
    CarProbe {
        pos: car.point.pos.to_array(),
        vel: car.velocity.to_array(),
        yaw: car.yaw().to_degrees(),
        upright: (car.turn * DVec3::Y).y,
        speed: car.speed_m_s,
        steer: car.steer_rad.to_degrees(),
        lights: car.lights,
        brakes: car.brakes,
        wheels: car.wheels.map(|wheel| WheelProbe {
            contact: wheel.contact,
            compression: wheel.compression_m,
        }),
        hemisphere: hemisphere(car.point),
    }
}

impl Scene {
    /// The player's health.
    pub fn health(&self) -> f64 {
        self.actors
            .ecs
            .get::<&Health>(self.actors.player)
            .map_or(FULL_HEALTH, |health| health.0)
    }

    /// The state of the world for a script.
    pub fn probe(&self) -> Probe {
        let curved_radius = self.world.strategy.radius_m();
        Probe {
            t: self.world.simulated_s,
            world: self.world.setup.name.clone(),
            seed: self.world.setup.seed,
            geometry: self.world.setup.geometry.to_string(),
            radius: curved_radius.is_finite().then_some(curved_radius),
            map: self.player.lens.map().map(HyperbolicMap::name),
            curvature: self.player.lens.curvature(),
            bend: self.player.lens.bend(),
            quality: self.shown.quality.name(),
            time_of_day: self.world.time_of_day_s,
            hour: self.local_time_s().map(day::hour),
            player: self.player_probe(),
            camera: self.camera_probe(),
            item: self.player.inventory.held().map(Item::id),
            inventory: (0..)
                .zip(self.player.inventory.slots())
                .filter_map(|(slot, stack)| stack.map(|stack| SlotProbe { slot, stack }))
                .collect(),
            marker: MarkerProbe {
                pos: self.shown.marker.map(|m| m.point.pos.to_array()),
                radius: self.player.brush_radius_m,
            },
            flashlight: self.player.flashlight,
            car: self.near_car().map(|car| car_probe(&car)),
            cars: self.cars().iter().map(car_probe).collect(),
            bots: self.bot_probes(),
            projectiles: self.projectile_probes(),
            lamps: self.lamp_probes(),
            drops: self.drop_probes(),
            chunks: ChunkProbe {
                resident: self.world.ground.count(),
                pending: self.world.streamer.pending(),
                triangles: self.world.ground.triangles(),
                edited: self.world.streamer.edited_count(),
            },
            terrain: TerrainProbe {
                ground_height: self.ground_height(),
            },
        }
    }

    fn player_probe(&self) -> PlayerProbe {
        let (position, look, body, _) = self.player_parts();
        PlayerProbe {
            pos: position.0.pos.to_array(),
            vel: body.0.velocity.to_array(),
            yaw: look.yaw.to_degrees(),
            pitch: look.pitch.to_degrees(),
            grounded: body.0.grounded,
            health: self.health(),
            hemisphere: hemisphere(position.0),
            in_car: self.is_driving(),
            animation: self.animation(),
        }
    }

    fn camera_probe(&self) -> CameraProbe {
        let optics = self.aiming();
        let eye = self.camera_through(&optics).eye;
        CameraProbe {
            pos: eye.point.pos.to_array(),
            mode: self.shown.camera.id(),
            curved: optics.strategy.curved(&eye, eye.point).to_array(),
        }
    }

    fn animation(&self) -> &'static str {
        let (_, _, body, _) = self.player_parts();
        let speed = body.0.velocity.x.hypot(body.0.velocity.z);
        if self.is_dead() {
            return "die";
        }
        if self.is_driving() {
            return "drive";
        }
        match (self.player.flying, body.0.grounded) {
            (true, _) => "fly",
            (false, false) => "jump",
            _ if speed < 0.3 => "idle",
            _ if speed > self.actors.tuning.walk_speed_m_s * 1.2 => "run",
            _ => "walk",
        }
    }

    /// The car that is driven, else the nearest.
    fn near_car(&self) -> Option<CarView> {
        let (head, feet) = (self.head(), self.feet());
        let distance_m = |car: &CarView| self.world.strategy.distance_m(feet, car.point, &head);
        self.driven_car().or_else(|| {
            self.cars()
                .into_iter()
                .min_by(|a, b| distance_m(a).total_cmp(&distance_m(b)))
        })
    }

    fn bot_probes(&self) -> Vec<BotProbe> {
        self.bots()
            .iter()
            .map(|view| BotProbe {
                id: view.bot.id,
                pos: view.point.pos.to_array(),
                health: view.health,
                hostile: view.fights,
                hemisphere: hemisphere(view.point),
                state: view.state.name(),
            })
            .collect()
    }

    fn projectile_probes(&self) -> Vec<ProjectileProbe> {
        self.projectiles()
            .into_iter()
            .map(|(id, bullet)| ProjectileProbe {
                id: id.0,
                pos: bullet.point.pos.to_array(),
                vel: bullet.velocity.to_array(),
                age: bullet.age_s,
                hemisphere: hemisphere(bullet.point),
            })
            .collect()
    }

    fn lamp_probes(&self) -> Vec<LampProbe> {
        self.lamps()
            .iter()
            .map(|lamp| LampProbe {
                pos: lamp.point.pos.to_array(),
                hemisphere: hemisphere(lamp.point),
            })
            .collect()
    }

    fn drop_probes(&self) -> Vec<DropProbe> {
        self.drops()
            .iter()
            .map(|drop| DropProbe {
                stack: drop.stack,
                pos: drop.point.pos.to_array(),
                hemisphere: hemisphere(drop.point),
            })
            .collect()
    }
}
