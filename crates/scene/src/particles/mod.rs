//! Dust, spray and chips in the air: a pool of a fixed size that follows what the steps of the simulation did to the ground.
//!
//! Nothing of it is part of the world. The simulation tells its [`Effect`]s and never asks for a particle, so the same world
//! comes of the same actions whatever flies in it. The same seed and actions throw the same particles. They know nothing of
//! doors: what flies through one goes on behind it.

pub(crate) mod contact;
mod flight;
mod spray;
mod surface;
#[cfg(test)]
mod tests;
mod tracks;

use antipode_geometry::{ChartPoint, ChunkCoord, Strategy};
use glam::DVec3;

use crate::frame;
use crate::npc::Dice;
use crate::probe::{MarkProbe, ParticleProbe};
use crate::situation::Situation;
use crate::world::World;
use surface::{Surface, surface_at};
use tracks::Tracks;

/// Particles at once. More take the places of those that are nearest to their end.
pub(crate) const MOST_PARTICLES: usize = 512;
/// Effects of a step that are followed.
const MOST_EFFECTS: usize = 32;

/// Something that throws up ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Effect {
    /// A tool bit, with a brush of that radius, metres.
    Dug { at: ChartPoint, radius_m: f64 },
    /// Ground was laid by such a brush.
    Built { at: ChartPoint, radius_m: f64 },
    /// A bullet struck the ground, at that speed into it.
    Struck {
        at: ChartPoint,
        up: DVec3,
        speed_m_s: f64,
    },
    /// What grows or stands was struck, which is wood or stone.
    Chopped { at: ChartPoint, is_stone: bool },
    /// Something went through leaves, in metres per second of the chart.
    Rustled { at: ChartPoint, velocity: DVec3 },
    /// Feet came down from a fall of that speed.
    Landed { at: ChartPoint, speed_m_s: f64 },
    /// A foot of somebody who goes that fast came down, in metres per second of the chart.
    Stepped { at: ChartPoint, velocity: DVec3 },
}

/// The effects of a step.
#[derive(Debug, Default)]
pub(crate) struct Effects(Vec<Effect>);

impl Effects {
    /// Tells of one more; of too many, the later are left out.
    pub fn push(&mut self, effect: Effect) {
        if self.0.len() < MOST_EFFECTS {
            self.0.push(effect);
        }
    }
}

/// How a particle moves and looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sort {
    /// The air holds it back; it spreads and fades.
    Dust,
    /// It falls, and is gone where it meets the ground.
    Spray,
    /// It falls, bounces and comes to lie.
    Chip,
}

/// A particle.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Particle {
    pub point: ChartPoint,
    /// In metres of the space along the axes of its chart's frame, m/s.
    pub velocity: DVec3,
    pub sort: Sort,
    pub age_s: f64,
    /// The age at which it is gone.
    pub life_s: f64,
    /// Its radius at first and in the end, metres.
    pub radius_m: [f64; 2],
    /// At its densest.
    pub opacity: f64,
    pub colour: [f32; 3],
    pub sky: f32,
    /// From 0 to 1, by which particles differ.
    pub shape: f64,
    /// How far it has flown, metres, by which chips turn.
    pub turned_m: f64,
    /// Unit normal of the ground below, and the height over it, metres.
    pub up: DVec3,
    pub height_m: f64,
    /// Whether it has come to lie.
    pub lies: bool,
}

/// All particles.
#[derive(Debug)]
pub(crate) struct Particles {
    pool: Vec<Particle>,
    dice: Dice,
    tracks: Tracks,
}

impl Default for Particles {
    fn default() -> Self {
        Self {
            pool: Vec::with_capacity(MOST_PARTICLES),
            dice: Dice::new(&[]),
            tracks: Tracks::default(),
        }
    }
}

impl Particles {
    /// Moves all particles by a step, and throws up what that step did.
    pub fn step(&mut self, now: Situation<'_>, effects: &mut Effects) {
        let world = now.world;
        flight::step(&mut self.pool, world);
        self.dice = Dice::new(&[world.setup.seed, world.simulated_s.to_bits()]);
        for effect in effects.0.drain(..) {
            self.throw_up(world, &effect);
        }
        self.land_others(now);
        let mut tracks = std::mem::take(&mut self.tracks);
        tracks.step(now, |rolling| self.roll(&rolling));
        self.tracks = tracks;
    }

    /// Has all that lies look for the ground again, since that of these chunks has changed; prints in ground that is gone go.
    pub fn ground_changed(&mut self, world: &World, chunks: &[ChunkCoord]) {
        self.pool.iter_mut().for_each(|it| it.lies = false);
        self.tracks.ground_changed(world, chunks);
    }

    /// Prints that a picture shows at a time, simulated seconds.
    pub fn prints(&self, now_s: f64) -> impl Iterator<Item = frame::GroundMark> {
        self.tracks.seen(now_s)
    }

    /// Adds one; where there is no room, in the place of that which is nearest to its end.
    fn add(&mut self, particle: Particle) {
        if self.pool.len() < MOST_PARTICLES {
            self.pool.push(particle);
            return;
        }
        let left_s = |it: &Particle| it.life_s - it.age_s;
        let oldest = self
            .pool
            .iter_mut()
            .min_by(|a, b| left_s(a).total_cmp(&left_s(b)));
        if let Some(oldest) = oldest {
            *oldest = particle;
        }
    }

    /// How many there are.
    pub fn probe(&self, now_s: f64) -> (ParticleProbe, MarkProbe) {
        let count = |sort| self.pool.iter().filter(|it| it.sort == sort).count();
        let particles = ParticleProbe {
            alive: self.pool.len(),
            dust: count(Sort::Dust),
            spray: count(Sort::Spray),
            chips: count(Sort::Chip),
        };
        let alive = self.tracks.count(now_s);
        (particles, MarkProbe { alive })
    }

    /// What a picture shows of them that is taken so many seconds before the last step's end.
    pub fn seen(&self, space: &dyn Strategy, before_s: f64) -> Vec<frame::Particle> {
        let seen = |it: &Particle| it.seen(space, before_s);
        self.pool.iter().map(seen).collect()
    }
}

/// Radians that a chip turns for each metre.
const TURN_RAD_PER_M: f64 = 9.0;
/// Radians that a cloud turns in a second.
const DRIFT_RAD_PER_S: f64 = 0.35;
/// How long it takes a cloud to come, and what has landed to go, seconds.
const COMES_S: f64 = 0.07;
const GOES_S: f64 = 0.8;

impl Particle {
    fn seen(&self, space: &dyn Strategy, before_s: f64) -> frame::Particle {
        let age_s = (self.age_s - before_s).max(0.0);
        let share = (age_s / self.life_s).min(1.0);
        let [from, to] = self.radius_m;
        let sign = if self.shape < 0.5 { -1.0 } else { 1.0 };
        let (radius_m, opacity, turn) = match self.sort {
            Sort::Dust => {
                let comes = (age_s / COMES_S).min(1.0);
                let fades = (1.0 - share).powf(1.4);
                let spread = 1.0 - (1.0 - share).powi(3);
                let turn = DRIFT_RAD_PER_S * age_s;
                (from + (to - from) * spread, comes * fades, turn)
            }
            Sort::Spray => (from + (to - from) * share, 1.0 - share * share, 0.0),
            Sort::Chip => {
                // It sinks away by growing smaller: a hard bit that is half there looks like a mistake.
                let left = ((self.life_s - age_s) / GOES_S).clamp(0.0, 1.0);
                (from * left, 1.0, TURN_RAD_PER_M * self.turned_m)
            }
        };
        frame::Particle {
            point: self
                .point
                .moved(space.in_chart(self.point, self.velocity) * -before_s),
            look: match self.sort {
                Sort::Dust => frame::Look::Dust,
                Sort::Spray => frame::Look::Spray,
                Sort::Chip => frame::Look::Chip,
            },
            radius_m: radius_m as f32,
            turn_rad: (std::f64::consts::TAU * self.shape + sign * turn) as f32,
            shape: self.shape as f32,
            colour: self.colour,
            opacity: (self.opacity * opacity) as f32,
            sky: self.sky,
            up: self.up.as_vec3(),
            height_m: self.height_m as f32,
        }
    }
}
