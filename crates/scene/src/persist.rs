//! Between the scene and its save: everything the player could change goes out and comes back.

use std::time::{SystemTime, UNIX_EPOCH};

use antipode_geometry::{ChartPoint, ChunkCoord, Hemisphere, HyperbolicMap};
use antipode_storage::{PlayerRecord, SlotRecord, WorldMeta, WorldState};
use antipode_terrain::Biome;
use glam::DVec3;

use crate::camera::CameraMode;
use crate::ground::height_below;
use crate::item::{Inventory, Item, Stack};
use crate::lens::DialGoals;
use crate::notice::Notice;
use crate::player::{Health, Look};
use crate::probe::{
    CameraProbe, ChunkProbe, MarkerProbe, PlayerProbe, Probe, SlotProbe, TerrainProbe,
};
use crate::scene::{Scene, SceneError, WorldSetup};
use crate::tuning::{BRUSH_RADIUS_M, FULL_HEALTH};

/// Depth below the player's head searched for ground, in metres.
pub(crate) const GROUND_SEARCH_M: f64 = 128.0;

impl WorldSetup {
    /// The setup a save describes, with the given view distance where the save has none of its own.
    ///
    /// # Errors
    /// When the save names a geometry this version does not know.
    pub fn from_meta(meta: &WorldMeta, view_distance: u32) -> Result<Self, SceneError> {
        let geometry = meta
            .geometry
            .parse()
            .map_err(|_| SceneError::UnknownGeometry {
                name: meta.name.clone(),
                geometry: meta.geometry.clone(),
            })?;
        Ok(Self {
            name: meta.name.clone(),
            seed: meta.seed,
            geometry,
            radius_m: meta.radius_m,
            view_distance,
        })
    }

    /// The record of a world made now.
    pub fn to_meta(&self) -> WorldMeta {
        let now = unix_now_s();
        WorldMeta {
            name: self.name.clone(),
            seed: self.seed,
            geometry: self.geometry.to_string(),
            radius_m: self.radius_m,
            biome: Biome::from_seed(self.seed).name().to_owned(),
            created_unix_s: now,
            last_played_unix_s: now,
            played_s: 0.0,
            cheated: false,
        }
    }
}

impl Scene {
    /// The records to commit.
    pub(crate) fn records(&self) -> (WorldMeta, WorldState) {
        let mut meta = self.setup.to_meta();
        meta.created_unix_s = self.created_unix_s;
        meta.played_s = self.simulated_s;
        meta.cheated = self.cheated;
        (meta, self.state())
    }

    fn state(&self) -> WorldState {
        let goals = self.lens.goals();
        let (position, look, body, _) = self.player_parts();
        let inventory = (0..)
            .zip(self.inventory.slots())
            .filter_map(|(slot, stack)| {
                stack.map(|s| SlotRecord {
                    slot,
                    item: s.item.id().to_owned(),
                    count: s.count,
                })
            })
            .collect();
        WorldState {
            player: PlayerRecord {
                hemisphere: u8::from(position.0.hemisphere == Hemisphere::B),
                pos: position.0.pos.to_array(),
                vel: body.0.velocity.to_array(),
                yaw: look.yaw,
                pitch: look.pitch,
                health: self.health(),
                third_person: self.camera == CameraMode::Third,
                flying: self.flying,
                grounded: body.0.grounded,
            },
            item_slot: self.inventory.selected(),
            inventory,
            time_of_day_s: self.time_of_day_s,
            map: self.lens.map().unwrap_or_default().to_string(),
            curvature: goals.raised,
            curvature_horizon: goals.horizon,
            bent: self.lens.bend().is_some(),
            bend: goals.bend,
            brush_radius_m: self.brush_radius_m,
            simulated_s: self.simulated_s,
            view_distance: self.setup.view_distance,
        }
    }

    /// Takes a saved state in. Numbers that no play could have produced are replaced by the start's.
    pub(crate) fn restore(&mut self, state: &WorldState) {
        self.restore_player(&state.player);
        self.inventory = Inventory::empty();
        for record in &state.inventory {
            match Item::from_id(&record.item) {
                Some(item) => self.inventory.put(
                    record.slot,
                    Stack {
                        item,
                        count: record.count.max(1),
                    },
                ),
                None => self.notices.push(Notice::UnknownItem(record.item.clone())),
            }
        }
        self.inventory.select(state.item_slot);
        self.set_time_of_day_s(finite_or(state.time_of_day_s, 0.0));
        self.restore_lens(state);
        let (least, most, usual) = BRUSH_RADIUS_M;
        self.brush_radius_m = finite_or(state.brush_radius_m, usual).clamp(least, most);
        self.simulated_s = finite_or(state.simulated_s, 0.0).max(0.0);
        self.saved_at_s = self.simulated_s;
    }

    fn restore_lens(&mut self, state: &WorldState) {
        let map = state.map.parse().unwrap_or_else(|_| {
            self.notices.push(Notice::UnknownMap(state.map.clone()));
            HyperbolicMap::default()
        });
        let goals = DialGoals {
            raised: state.curvature,
            horizon: state.curvature_horizon,
            bend: state.bend,
        };
        self.lens.restore(map, state.bent, goals);
    }

    fn restore_player(&mut self, record: &PlayerRecord) {
        let numbers = record.pos.iter().chain(&record.vel).chain([
            &record.yaw,
            &record.pitch,
            &record.health,
        ]);
        if !numbers.into_iter().all(|n| n.is_finite()) {
            self.notices.push(Notice::PlayerDamaged);
            return;
        }
        let hemisphere = if record.hemisphere == 1 && self.strategy.rim_m().is_some() {
            Hemisphere::B
        } else {
            Hemisphere::A
        };
        let point = ChartPoint::new(hemisphere, DVec3::from_array(record.pos));
        let velocity = DVec3::from_array(record.vel);
        self.place_body(point, velocity, record.grounded);
        if let Ok((look, health)) = self
            .ecs
            .query_one_mut::<(&mut Look, &mut Health)>(self.player)
        {
            *look = Look {
                yaw: 0.0,
                pitch: 0.0,
            };
            look.turn(record.yaw, record.pitch);
            health.0 = record.health.clamp(0.0, FULL_HEALTH);
        }
        self.camera = if record.third_person {
            CameraMode::Third
        } else {
            CameraMode::First
        };
        self.flying = record.flying;
    }

    /// The player's health.
    pub fn health(&self) -> f64 {
        self.ecs
            .get::<&Health>(self.player)
            .map_or(FULL_HEALTH, |health| health.0)
    }

    /// The state of the world for a script.
    pub fn probe(&self) -> Probe {
        let curved_radius = self.strategy.radius_m();
        Probe {
            t: self.simulated_s,
            world: self.setup.name.clone(),
            seed: self.setup.seed,
            geometry: self.setup.geometry.to_string(),
            radius: curved_radius.is_finite().then_some(curved_radius),
            map: self.lens.map().map(HyperbolicMap::name),
            curvature: self.lens.curvature(),
            bend: self.lens.bend(),
            quality: self.quality.name(),
            time_of_day: self.time_of_day_s,
            player: self.player_probe(),
            camera: self.camera_probe(),
            item: self.inventory.held().map(Item::id),
            inventory: (0..)
                .zip(self.inventory.slots())
                .filter_map(|(slot, stack)| stack.map(|stack| SlotProbe { slot, stack }))
                .collect(),
            marker: MarkerProbe {
                pos: self.marker.map(|m| m.point.pos.to_array()),
                radius: self.brush_radius_m,
            },
            chunks: ChunkProbe {
                resident: self.ground.count(),
                pending: self.streamer.pending(),
                triangles: self.ground.triangles(),
                edited: self.streamer.edited_count(),
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
            hemisphere: if position.0.hemisphere == Hemisphere::A {
                'A'
            } else {
                'B'
            },
            in_car: false,
            animation: self.animation(),
        }
    }

    fn camera_probe(&self) -> CameraProbe {
        let eye = self.eye();
        CameraProbe {
            pos: eye.point.pos.to_array(),
            mode: self.camera.id(),
            curved: self.lens.strategy().curved(&eye, eye.point).to_array(),
        }
    }

    fn animation(&self) -> &'static str {
        let (_, _, body, _) = self.player_parts();
        let speed = body.0.velocity.x.hypot(body.0.velocity.z);
        match (self.flying, body.0.grounded) {
            (true, _) => "fly",
            (false, false) => "jump",
            _ if speed < 0.3 => "idle",
            _ if speed > self.tuning.walk_speed_m_s * 1.2 => "run",
            _ => "walk",
        }
    }

    /// Height of the ground under the player's head, in metres of the chart; `None` where none is near, or where
    /// the head is in rock with no cave below. Beyond the view distance it is that of untouched ground, whatever
    /// happens to be loaded there.
    pub fn ground_height(&self) -> Option<f64> {
        height_below(self.head().point, GROUND_SEARCH_M, |point| {
            let density = if self.streamer.is_wanted(ChunkCoord::containing(point)) {
                self.ground.density(point)
            } else {
                self.ground.untouched_density(point)
            };
            density < 0.0
        })
    }
}

fn finite_or(value: f64, otherwise: f64) -> f64 {
    if value.is_finite() { value } else { otherwise }
}

fn unix_now_s() -> u64 {
    SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |since| since.as_secs())
}
