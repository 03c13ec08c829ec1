//! Between the scene and the chunk workers: wishes out, finished chunks in, and what a script waits for.

use std::time::{Duration, Instant};

use std::sync::Arc;

use antipode_geometry::ChartPoint;
use antipode_streaming::{Detail, Reach, StreamingError, Until, Update, Wish};
use glam::DVec3;
use thiserror::Error;

use crate::actors::Actors;
use crate::bot;
use crate::detail::{Sharpness, Sights};
use crate::ground::chunks_near;
use crate::notice::{Hint, Notice};
use crate::persist;
use crate::projectile::Projectile;
use crate::reach::{self, OTHERS_MARGIN_M};
use crate::scene::Scene;
use crate::situation::is_ground_ready;
use crate::step::Simulation;
use crate::tuning::{AUTOSAVE_S, BODIES_WITHIN_CHUNKS};
use crate::world::World;
use crate::{body, earthworks, felling, ground_changed};

/// Ground within this distance of the player stands before a world counts as playable, in metres, as far as it is to be
/// loaded at all: a hole so near would be seen.
const PLAYABLE_AROUND_M: f64 = 96.0;
/// Ground about doors is made solid in cells with this margin, metres.
const DOOR_MARGIN_M: f64 = 6.0;
/// Times that a script waits for the ground around a body that was lifted to other ground.
const MOST_LIFTS: usize = 4;

/// A world that could not be closed because its last commit failed. Nothing is lost: go on playing it, or close it
/// again, or drop it to leave without saving.
#[derive(Debug, Error)]
#[error("{error}")]
pub struct CloseFailure {
    /// The world, as it was.
    pub scene: Box<Scene>,
    /// Why it could not be closed.
    #[source]
    pub error: StreamingError,
}

impl Scene {
    /// Tells the workers what is wanted now. Cheap; called every frame.
    pub fn request_ground(&mut self) {
        self.renew_sight();
        let head = self.head();
        self.sim.world.move_bodies_about(head.point);
        let eye = self.shown.watched.unwrap_or(head);
        let sight = self.shown.sight.clone();
        let world = &self.sim.world;
        let wish = Wish {
            centre: eye.point,
            front: eye.front(),
            view_distance: world.setup.view_distance,
            apart: door_feet(world),
            bodies: reaches(world, &self.sim.actors),
            bodies_distance: BODIES_WITHIN_CHUNKS.into(),
            bodies_within: world.bodies_within_tiles(),
            detail: sight.map(|sight| sight as Arc<dyn Detail>),
        };
        let World {
            streamer, ground, ..
        } = &mut self.sim.world;
        streamer.wish(&wish);
        ground.show_all(|coord| streamer.keeps_in_view(coord));
    }

    /// Takes the sizes of things in the picture anew, if they no longer hold.
    fn renew_sight(&mut self) {
        let sharpness = Sharpness::of(
            self.shown.quality,
            self.shown.picture_height_px,
            self.shown.viewing.fov_y_rad,
        );
        let Some(sharpness) = sharpness else {
            self.shown.sight = None;
            return;
        };
        let watched = self.shown.watched;
        let head = watched.unwrap_or_else(|| self.now().head_through(&self.picturing()));
        let strategy = self.lens().strategy();
        let sight = self.shown.sight.as_ref();
        let doors = door_feet(&self.sim.world);
        if !sight.is_some_and(|sight| sight.holds(&**strategy, &head, &doors, sharpness)) {
            let sight = Sights::new(strategy, &head, &doors, sharpness);
            self.shown.sight = Some(Arc::new(sight));
        }
    }

    /// Lets the workers seem to be at their work still, whatever they have done: for tests of what is shown meanwhile.
    /// Only [`Scene::pump`] goes by it.
    pub fn hold_land(&mut self, held: bool) {
        self.sim.world.holds_land = held;
    }

    /// Takes finished work in until `budget` is used up. Never blocks.
    pub fn pump(&mut self, budget: Duration) {
        self.request_ground();
        if self.sim.world.holds_land {
            return;
        }
        let updates = self.sim.world.streamer.poll(budget);
        self.apply(updates);
        self.free_body();
    }

    /// Blocks until every edit made so far shows and the ground around the player stands, or `limit` has passed.
    /// Scripts call this after each step so that the same script always gives the same world.
    /// Returns false when the limit passed first.
    pub fn wait_for_step(&mut self, limit: Duration) -> bool {
        self.request_ground();
        let updates = self.sim.world.streamer.wait(Until::Edits, limit);
        self.apply(updates);
        for _ in 0..MOST_LIFTS {
            self.await_ground(limit);
            if !self.free_body() {
                break;
            }
            self.request_ground();
        }
        self.is_ground_ready()
    }

    /// Frees a body that was put somewhere, once its ground is there; returns whether that moved it.
    fn free_body(&mut self) -> bool {
        let Simulation {
            world,
            actors,
            player,
            ..
        } = &mut self.sim;
        let is_due = player.body_unchecked && is_ground_ready(world, actors);
        let freed = is_due && body::free(world, actors, player);
        self.kept.changed |= freed;
        freed
    }

    /// Waits for the ground that a step, a probe or a lift may ask about.
    fn await_ground(&mut self, limit: Duration) {
        let updates = self.sim.world.streamer.wait(Until::Bodies, limit);
        self.apply(updates);
    }

    /// Blocks until no chunk work is pending, or `limit` has passed; returns false when it did.
    pub fn settle(&mut self, limit: Duration) -> bool {
        let until = Instant::now() + limit;
        self.request_ground();
        loop {
            let left = until.saturating_duration_since(Instant::now());
            let updates = self.sim.world.streamer.wait(Until::Idle, left);
            let is_last = updates.is_empty();
            self.apply(updates);
            // What was applied may ask for more: a tree falls whose ground is gone.
            if self.pending() == 0 || is_last {
                break;
            }
        }
        self.refresh_marker();
        self.pending() == 0
    }

    /// How much of the ground around a new arrival stands, 0 to 1; at 1 the world can be played.
    pub fn loading_progress(&self) -> f32 {
        let mut needed = chunks_near(&*self.sim.world.strategy, self.feet(), PLAYABLE_AROUND_M);
        needed.retain(|coord| self.sim.world.streamer.is_wanted(*coord));
        let there = needed
            .iter()
            .filter(|c| self.sim.world.streamer.is_ready(**c))
            .count();
        if needed.is_empty() {
            return 1.0;
        }
        there as f32 / needed.len() as f32
    }

    /// Work the chunk workers have not finished.
    pub fn pending(&self) -> usize {
        self.sim.world.streamer.pending()
    }

    /// Commits in the background what changed, if the last commit is [`AUTOSAVE_S`] old.
    pub(crate) fn autosave(&mut self) {
        if self.kept.stored && self.sim.world.simulated_s - self.kept.saved_at_s >= AUTOSAVE_S {
            self.save();
        }
    }

    /// Commits in the background what has changed; a notice tells when it failed.
    pub fn save(&mut self) {
        if !self.kept.stored {
            return;
        }
        self.kept.saved_at_s = self.sim.world.simulated_s;
        self.kept.changed = false;
        let (world, actors, player) = (&self.sim.world, &self.sim.actors, &self.sim.player);
        let mut meta = world.setup.to_meta();
        meta.created_unix_s = self.kept.created_unix_s;
        meta.played_s = world.simulated_s;
        meta.cheated = self.kept.cheated;
        let records = persist::records(world, actors, player, &self.kept.unknown_slots);
        let mut changes = self.kept.hand_over(records);
        changes.append(&mut self.sim.world.felled.take_changes());
        self.sim.world.streamer.save(Some(meta), changes);
    }

    /// Commits everything, waits until it is on disk and ends the chunk workers.
    ///
    /// # Errors
    /// When the last commit failed; the failure says why and gives the world back.
    pub fn close(mut self) -> Result<(), CloseFailure> {
        self.save();
        let Err(error) = self.sim.world.streamer.close() else {
            return Ok(());
        };
        let updates = self.sim.world.streamer.poll(Duration::ZERO);
        self.apply(updates);
        Err(CloseFailure {
            scene: Box::new(self),
            error,
        })
    }

    /// Whether the world is kept on disk at all.
    pub fn is_kept(&self) -> bool {
        self.kept.stored
    }

    /// Whether every save asked for so far is on disk: none is under way and the last one did not fail.
    pub fn is_saved(&self) -> bool {
        self.sim.world.streamer.saves_in_flight() == 0 && self.kept.save_problem.is_none()
    }

    /// Whether there is anything that no save asked for so far is sure to hold, such as an edit that was still under
    /// way then, or a save that failed. Never so in a world that is not kept.
    pub fn needs_save(&self) -> bool {
        self.kept.stored && (self.kept.changed || self.sim.world.streamer.needs_save())
    }

    /// Why the last commit failed, if it did.
    pub fn save_problem(&self) -> Option<Notice> {
        self.kept.save_problem.clone()
    }

    /// Blocks until what was saved so far is on disk, or `limit` has passed; returns false when it was not.
    pub fn wait_saved(&mut self, limit: Duration) -> bool {
        let updates = self.sim.world.streamer.wait(Until::Saved, limit);
        let done = updates.iter().any(|u| matches!(u, Update::Saved));
        self.apply(updates);
        done || self.sim.world.streamer.saves_in_flight() == 0
    }

    fn apply(&mut self, updates: Vec<Update>) {
        let mut edited = Vec::new();
        for update in updates {
            match update {
                Update::Loaded(chunk) => {
                    self.sim.world.put(chunk);
                }
                Update::Edited(chunks) => {
                    edited.extend(chunks.iter().map(|chunk| chunk.coord));
                    felling::put_edited(&mut self.sim, chunks);
                }
                Update::Solid {
                    coord,
                    collider,
                    samples,
                } => self.sim.world.set_solid(coord, collider, samples),
                Update::Unloaded(coord) => self.sim.world.remove(coord),
                Update::Moved {
                    press,
                    earth,
                    gathered,
                } => {
                    let now_s = self.sim.world.simulated_s;
                    let works = &mut self.sim.player.earthworks;
                    works.enter(press, &earth, &gathered, now_s);
                    if works.misses_coal(self.sim.world.streamer.stock()) {
                        self.sim.outbox.hints.push(Hint::NoCoalYet);
                    }
                }
                Update::Undone(end) => {
                    let works = &mut self.sim.player.earthworks;
                    earthworks::undone(works, &mut self.sim.outbox, end);
                }
                Update::Saved => self.kept.save_problem = None,
                Update::SaveFailed(why) => {
                    let problem = Notice::NotSaved(why);
                    // The same failure comes back with every autosave; once told is enough.
                    if self.kept.save_problem.as_ref() != Some(&problem) {
                        self.sim.outbox.notices.push(problem.clone());
                    }
                    self.kept.save_problem = Some(problem);
                }
                Update::Problem(sentence) => {
                    self.sim.outbox.notices.push(Notice::Land(sentence));
                }
            }
        }
        self.shown.sills.renew(&self.sim.world);
        if !edited.is_empty() {
            let Simulation {
                world,
                actors,
                player,
                outbox,
            } = &mut self.sim;
            ground_changed::tell(world, actors, &edited);
            outbox.ground_changed.extend(edited);
            body::lift_out(world, actors, player);
        }
    }
}

/// Where the ground must be solid: around the player, and around others and what flies.
fn reaches(world: &World, actors: &Actors) -> Vec<Reach> {
    let in_chart = |at: ChartPoint, velocity| (at, world.strategy.in_chart(at, velocity));
    let (feet, velocity) = in_chart(actors.feet(), actors.player_body().velocity);
    let mut reaches = reach::of_body(&*world.strategy, feet, velocity);
    let bullets = actors.map(|_, it: &Projectile| in_chart(it.point, it.velocity));
    let cars = actors.car_views().into_iter();
    let cars = cars.map(|it| in_chart(it.point, it.velocity));
    // Each for themselves: the ground under cars is not to be lost to a hail of bullets.
    reaches.extend(reach::of_others(&*world.strategy, cars, OTHERS_MARGIN_M));
    reaches.extend(reach::of_others(
        &*world.strategy,
        bullets.into_iter(),
        OTHERS_MARGIN_M,
    ));
    let bots = bot::views(actors);
    let living = bots.iter().map(|view| (view.point, DVec3::ZERO));
    reaches.extend(reach::of_others(
        &*world.strategy,
        living,
        crate::npc::ASKS_M,
    ));
    let within = |reach: &Reach| world.within_bodies(reach);
    let mut reaches: Vec<Reach> = reaches.iter().filter_map(within).collect();
    // Who goes through a door is to find ground, however far it leads.
    let doors = door_feet(world).into_iter().map(|foot| (foot, DVec3::ZERO));
    reaches.extend(reach::of_others(&*world.strategy, doors, DOOR_MARGIN_M));
    reaches
}

/// Where the pair of doors stands.
fn door_feet(world: &World) -> Vec<ChartPoint> {
    let leaves = world.doors.iter().flat_map(|doors| &doors.leaves);
    leaves.map(|leaf| leaf.foot).collect()
}
