//! The world itself: its space, its land and its day. Nobody lives in it; who does is in `actors`.

use std::sync::Arc;

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartPoint, ChunkCoord, ChunkCube, Doorway, Strategy};
use antipode_physics::{PhysicsWorld, TerrainCollider};
use antipode_streaming::{Chunk, Reach, Streamer};
use antipode_terrain::{FIRST_PLANTED, Field, RIM_REACH_M, Samples, Thing};
use glam::DVec3;

use crate::day;
use crate::felling::Felled;
use crate::fixture::Solids;
use crate::ground::{Ground, Spent, chunks_near, height_below};
use crate::planted::Planted;
use crate::restore::{LONGEST_PLAYED_S, finite_or};
use crate::setup::WorldSetup;
use crate::tuning::{BODIES_WITHIN_CHUNKS, DAY_S, DAY_START_S};

/// A reach that ends where a chunk does ends short of it by so much, metres.
const SHORT_OF_NEXT_M: f64 = 1e-3;

/// Depth below somebody's head searched for ground, in metres.
pub(crate) const GROUND_SEARCH_M: f64 = 128.0;

/// A space with land in it.
pub(crate) struct World {
    pub setup: WorldSetup,
    pub strategy: Arc<dyn Strategy>,
    pub streamer: Streamer,
    /// Finished land waits: see [`crate::Scene::hold_land`].
    pub holds_land: bool,
    pub physics: PhysicsWorld,
    pub ground: Ground,
    /// What of all that grows was felled.
    pub felled: Felled,
    /// What somebody planted.
    pub planted: Planted,
    /// What was put down and is bumped into.
    pub solids: Solids,
    /// The pair of doors that stood when the step began.
    pub doors: Option<Doorway>,
    /// The chunk of the player's head when the step began: bodies move about it.
    bodies_about: ChunkCoord,
    /// The chunks about it, in an open world those that bodies move in.
    bodies_within: ChunkCube,
    pub time_of_day_s: f64,
    pub simulated_s: f64,
}

fn cube_of_bodies(strategy: &dyn Atlas, about: ChunkCoord) -> ChunkCube {
    ChunkCube::about(strategy, about, BODIES_WITHIN_CHUNKS, RIM_REACH_M)
}

impl World {
    /// A world that has just begun, with no land in it yet.
    pub fn new(
        setup: WorldSetup,
        strategy: Arc<dyn Strategy>,
        field: &Arc<Field>,
        streamer: Streamer,
    ) -> Self {
        let bodies_about = ChunkCoord::containing(ChartPoint::a(DVec3::ZERO));
        Self {
            setup,
            bodies_about,
            bodies_within: cube_of_bodies(&*strategy, bodies_about),
            ground: Ground::new(Arc::clone(field)),
            strategy,
            streamer,
            felled: Felled::default(),
            planted: Planted::default(),
            solids: Solids::default(),
            holds_land: false,
            doors: None,
            physics: PhysicsWorld::new(),
            time_of_day_s: DAY_START_S,
            simulated_s: 0.0,
        }
    }

    /// Has bodies move about the player's head, and be exact about the feet.
    pub fn centre_on(&mut self, head: ChartPoint, feet: ChartPoint) {
        self.move_bodies_about(head);
        self.centre_on_body(feet);
    }

    /// Has bodies move about the player's head.
    pub fn move_bodies_about(&mut self, head: ChartPoint) {
        let about = ChunkCoord::containing(head);
        if about != self.bodies_about {
            self.bodies_about = about;
            self.bodies_within = cube_of_bodies(&*self.strategy, about);
        }
    }

    /// Has bodies be exact about a place.
    pub fn centre_on_body(&mut self, point: ChartPoint) {
        self.physics.recentre(point, self.bodies_within.middles());
    }

    /// Lets time pass.
    pub fn pass(&mut self, dt_s: f64) {
        self.time_of_day_s = (self.time_of_day_s + dt_s).rem_euclid(DAY_S);
        self.simulated_s += dt_s;
    }

    /// Whether bodies move in a chunk: in an open world within a distance of the player that is always the same, however
    /// far the view is; in a closed one everywhere.
    pub fn lets_move(&self, coord: ChunkCoord) -> bool {
        self.strategy.is_closed() || self.bodies_within.has(coord, BODIES_WITHIN_CHUNKS)
    }

    /// Whether a body may move in a chunk now: it is near enough, and all that it has of ground is there.
    pub fn is_firm(&self, coord: ChunkCoord) -> bool {
        self.lets_move(coord) && self.streamer.is_firm(coord)
    }

    /// Whether a body may move in all that is within so many metres of a place.
    pub fn is_firm_around(&self, point: ChartPoint, reach_m: f64) -> bool {
        let near = chunks_near(&*self.strategy, point, reach_m);
        near.into_iter().all(|coord| self.is_firm(coord))
    }

    /// The chunks that bodies move in, in a world in tiles, of which a reach tells whole tiles.
    pub fn bodies_within_tiles(&self) -> Option<ChunkCube> {
        self.strategy.tiled().map(|_| self.bodies_within.clone())
    }

    /// What of a reach lies where bodies move; of a tile all of the ground plan counts.
    pub fn within_bodies(&self, reach: &Reach) -> Option<Reach> {
        if self.strategy.is_closed() {
            return Some(*reach);
        }
        let span = self.bodies_within.span(reach.chart, BODIES_WITHIN_CHUNKS)?;
        let [low, high] = span.map(|index| index.as_dvec3() * f64::from(CHUNK_CELLS));
        // The least of a reach is its own chunk's, so it has to end short of the next.
        let high = high + f64::from(CHUNK_CELLS) - SHORT_OF_NEXT_M;
        let (min, max) = (reach.min.max(low), reach.max.min(high));
        let is_there = min.cmple(max).all();
        is_there.then_some(Reach { min, max, ..*reach })
    }

    /// The time of day at a place, in seconds, 0 to 600; none at the poles of the sun's way.
    pub fn local_time_s(&self, at: ChartPoint) -> Option<f64> {
        day::local_time_s(self.time_of_day_s, &*self.strategy, at)
    }

    /// Height of the ground under somebody's head, in metres of the chart; `None` where none is near, or where
    /// the head is in rock with no cave below. Beyond where bodies move it is that of untouched ground, whatever
    /// happens to be loaded there.
    pub fn ground_height(&self, head: ChartPoint) -> Option<f64> {
        height_below(head, GROUND_SEARCH_M, |point| {
            let density = if self.lets_move(ChunkCoord::containing(point)) {
                self.ground.density(point)
            } else {
                self.ground.untouched_density(point)
            };
            density < 0.0
        })
    }

    /// Takes in a finished chunk.
    /// Returns what stood on it and stands there no more.
    pub fn put(&mut self, chunk: Chunk) -> Vec<(ChunkCoord, Thing)> {
        let (coord, seen) = (chunk.coord, self.streamer.keeps_in_view(chunk.coord));
        let stands = |thing: &Thing| chunk.mesh.things.iter().any(|it| it.slot == thing.slot);
        let before = self.ground.things(coord).iter();
        let lost = before.filter(|thing| !stands(thing));
        let lost: Vec<_> = lost.map(|thing| (coord, *thing)).collect();
        let spent = self.ground.put(chunk, seen, &mut self.physics);
        self.discard(spent);
        lost
    }

    /// Whether a thing that a chunk shows has not been felled meanwhile: what is left of that stands no more.
    pub fn stands(&self, coord: ChunkCoord, thing: &Thing) -> bool {
        if thing.slot < FIRST_PLANTED {
            !self.felled.has(coord, thing.slot)
        } else {
            self.planted.has(coord, thing)
        }
    }

    /// Takes in what makes a chunk solid, or what it is without.
    pub fn set_solid(
        &mut self,
        coord: ChunkCoord,
        collider: Option<TerrainCollider>,
        samples: Option<Arc<Samples>>,
    ) {
        let physics = &mut self.physics;
        let spent = self.ground.set_solid(coord, collider, samples, physics);
        self.discard(spent);
    }

    /// Lets a chunk go.
    pub fn remove(&mut self, coord: ChunkCoord) {
        let spent = self.ground.remove(coord, &mut self.physics);
        self.discard(spent);
    }

    /// What is needed no more is freed by a worker.
    fn discard(&self, spent: Spent) {
        if spent.0.is_some() || spent.1.is_some() {
            self.streamer.discard(spent);
        }
    }

    /// Sets the time of day in seconds; it wraps at a day's length.
    pub fn set_time_of_day_s(&mut self, time_s: f64) {
        self.time_of_day_s = time_s.rem_euclid(DAY_S);
    }

    /// Sets the simulated time in seconds, as far as anybody can have played; no time at all where it is no number.
    pub fn set_simulated_s(&mut self, time_s: f64) {
        self.simulated_s = finite_or(time_s, 0.0).clamp(0.0, LONGEST_PLAYED_S);
    }
}
