//! One fixed step of the simulation.

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_physics::{Character, CharacterInput};
use antipode_terrain::Stroke;
use glam::DVec3;

use crate::actions::Actions;
use crate::camera::CameraMode;
use crate::frame::{Marker, MarkerShape};
use crate::ground::chunks_near;
use crate::harm::{HarmKind, fall_harm};
use crate::item::Item;
use crate::motion::Doing;
use crate::notice::Hint;
use crate::pick::{self, pick};
use crate::player::{self, Appearance, Body, Look, Position};
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::{BRUSH_RADIUS_M, DAY_S, REACH_M, STEP_S};
use crate::{drops, lamp};

/// Ground within this distance of a body must be there with its collider before the body moves, in metres.
const NEEDED_AROUND_M: f64 = 4.0;

/// What is built may not come nearer to the player's body than this below a roof, in metres.
const BODY_SLACK_M: f64 = 0.5;
/// Apart from each other, places above the head at which a roof is looked for, in metres.
const ROOF_STEP_M: f64 = 0.5;

impl Scene {
    /// Advances the world by one step of [`STEP_S`] seconds.
    ///
    /// While the ground around the player is not there yet the body is held still; everything else goes on.
    pub fn step(&mut self, actions: &Actions) {
        self.kept.changed = true;
        self.world.bodies_about = ChunkCoord::containing(self.head().point);
        self.take_aim(actions.aimed);
        self.handle_switches(actions);
        self.player.lens.glide(STEP_S);
        self.renew_picture();
        self.shown.dip.pass(STEP_S);
        // A body that has just been lifted waits for the next step: other ground may be near it now.
        let actions = &if self.is_dead() {
            Actions::default()
        } else {
            *actions
        };
        self.use_doors(actions);
        if !self.is_driving() && self.is_ground_ready() && !self.free_body() {
            self.move_player(actions);
        }
        self.step_cars(actions);
        self.notice_round();
        // Both hands are on the wheel.
        let actions = &if self.is_driving() {
            Actions::default()
        } else {
            *actions
        };
        self.step_bots();
        self.heal();
        self.world.time_of_day_s = (self.world.time_of_day_s + STEP_S).rem_euclid(DAY_S);
        self.world.simulated_s += STEP_S;
        self.update_marker();
        self.use_tool(actions);
        self.use_gun(actions);
        self.use_lamp(actions);
        self.step_projectiles();
        lamp::step(&self.world, &mut self.actors);
        drops::step(
            &self.world,
            &mut self.actors,
            &mut self.player,
            &mut self.outbox,
        );
        self.step_hand(actions);
        self.player.primary_before = actions.primary;
        self.player.secondary_before = actions.secondary;
        self.autosave();
    }

    /// Whether the ground around the player exists with its colliders.
    pub fn is_ground_ready(&self) -> bool {
        chunks_near(&*self.world.strategy, self.feet(), NEEDED_AROUND_M)
            .into_iter()
            .all(|c| self.world.streamer.is_ready(c))
    }

    fn handle_switches(&mut self, actions: &Actions) {
        if let Ok(mut look) = self.actors.ecs.get::<&mut Look>(self.actors.player) {
            look.turn(actions.look_yaw, actions.look_pitch);
        }
        let in_hand = self.player.inventory.selected();
        if let Some(slot) = actions.slot {
            self.player.inventory.select(slot);
        }
        self.player.inventory.step(actions.slot_step);
        if self.player.inventory.selected() != in_hand {
            self.outbox.sounds.push(SoundEvent::SlotChanged);
        }
        if actions.toggle_light
            && let Some(number) = self.driven_number()
        {
            self.toggle_car_lights(number);
        } else if actions.toggle_light {
            self.player.flashlight = !self.player.flashlight;
        }
        if actions.drop_one || actions.drop_all {
            self.drop_held(actions.drop_all);
        }
        if actions.talk {
            self.talk();
        }
        if actions.turn_map {
            self.turn_map();
        }
        self.player.lens.turn(actions.dial);
        let (least, most, _) = BRUSH_RADIUS_M;
        self.player.brush_radius_m =
            (self.player.brush_radius_m + f64::from(actions.brush_step)).clamp(least, most);
        if actions.toggle_camera {
            self.shown.camera = match self.shown.camera {
                CameraMode::First => CameraMode::Third,
                CameraMode::Third => CameraMode::First,
            };
        }
    }

    fn move_player(&mut self, actions: &Actions) {
        let strategy = std::sync::Arc::clone(&self.world.strategy);
        let (flying, dead) = (self.player.flying, self.is_dead());
        let holds = self.player.inventory.held().is_some();
        let Ok((position, look, body, appearance)) =
            self.actors
                .ecs
                .query_one_mut::<(&mut Position, &mut Look, &mut Body, &mut Appearance)>(
                    self.actors.player,
                )
        else {
            return;
        };
        let input = CharacterInput {
            wish: player::wish(actions, look),
            sprint: actions.sprint,
            jump: actions.jump,
            fly: flying,
            rise: actions.jump,
            sink: actions.sink,
        };
        let origin = strategy.chart_origin_m(position.0.hemisphere);
        let character: &mut Character = &mut body.0;
        character.feet = position.0.pos + origin;
        self.world.physics.recentre(character.feet);
        self.world
            .physics
            .move_character(character, &self.actors.tuning, &input, STEP_S);
        position.0.pos = character.feet - origin;
        if let Some(limits) = strategy.limits() {
            let y = position.0.pos.y.clamp(limits.bedrock_m, limits.ceiling_m);
            if y != position.0.pos.y {
                position.0.pos.y = y;
                body.0.velocity.y = 0.0;
            }
        }
        player::cross(&*strategy, position, look, body);
        let harm = fall_harm(body.0.hardest_m_s(), self.actors.tuning.gravity_m_s2);
        self.shown.dip.land(body.0.impact_m_s);
        let doing = Doing {
            flying,
            dead,
            holds,
            ..player::doing(look, body)
        };
        let foot_down = appearance.motion.pass(&doing, STEP_S);
        self.hear_body(foot_down);
        self.hurt_player(harm, HarmKind::Fall, None);
    }

    /// Points the marker anew, as after the view was set from outside a step.
    pub fn refresh_marker(&mut self) {
        self.update_marker();
    }

    /// Points the marker along the geodesic through the crosshair; an empty hand has none.
    pub(crate) fn update_marker(&mut self) {
        let held = self.player.inventory.held().filter(|_| !self.is_driving());
        let digs = held.and_then(Item::brush_strength_per_s);
        self.shown.marker = digs.map(|_| {
            let optics = self.aiming();
            let eye = self.camera_through(&optics).eye;
            let past_head_m = self.past_head_m(&optics, &eye);
            let found: pick::Pick = pick(
                &*optics.strategy,
                &self.world.physics,
                &eye,
                past_head_m,
                REACH_M,
            );
            Marker {
                point: found.point,
                radius_m: self.player.brush_radius_m,
                active: false,
                shape: if self.shown.viewing.safe_marker {
                    MarkerShape::SafeRing
                } else {
                    MarkerShape::Ring
                },
            }
        });
    }

    fn use_tool(&mut self, actions: &Actions) {
        let strength = self
            .player
            .inventory
            .held()
            .and_then(Item::brush_strength_per_s);
        let sign = f32::from(i8::from(actions.primary) - i8::from(actions.secondary));
        self.hear_tool(sign, STEP_S);
        let (Some(strength), Some(marker)) = (strength, self.shown.marker.as_mut()) else {
            return;
        };
        if sign == 0.0 {
            return;
        }
        marker.active = true;
        let centre = marker.point;
        if sign < 0.0 && self.would_immure(centre) {
            if !self.player.secondary_before {
                self.outbox.hints.push(Hint::InTheWay);
            }
            return;
        }
        let amount = sign * strength * STEP_S as f32;
        let stroke = Stroke {
            centre,
            radius_m: self.player.brush_radius_m,
            amount,
        };
        self.world.streamer.edit(stroke);
    }

    /// Whether building there would fill the place of the player's body under a roof. In the open it is lifted by what
    /// is built; here the nearest free place is on top of the hill.
    fn would_immure(&self, centre: ChartPoint) -> bool {
        if self.player.flying || self.is_driving() {
            return false;
        }
        let tuning = &self.actors.tuning;
        let middle = self.feet().moved(DVec3::Y * (0.5 * tuning.height_m));
        let reach_m = self.player.brush_radius_m + 0.5 * tuning.height_m + BODY_SLACK_M;
        if self.world.strategy.distance_m(middle, centre, &self.head()) > reach_m {
            return false;
        }
        let steps = (self.player.brush_radius_m / ROOF_STEP_M).ceil() as u32;
        let above = |step| tuning.height_m + f64::from(step) * ROOF_STEP_M;
        (0..=steps).any(|step| {
            self.world
                .ground
                .is_solid(self.feet().moved(DVec3::Y * above(step)))
        })
    }
}
