//! What each kind of ground throws up, and how much.

use std::f64::consts::TAU;

use antipode_geometry::ChartPoint;
use antipode_terrain::Kind;
use glam::DVec3;

use super::tracks::Rolling;
use super::{Effect, Particle, Particles, Sort, Surface, surface_at};
use crate::bot::Bot;
use crate::player::{Body, Position};
use crate::situation::Situation;
use crate::tuning::LANDS_FROM_M_S;
use crate::world::World;

/// Places of a brush from which ground flies at a stroke.
const SPOTS: u32 = 5;
/// Share of the brush's radius within which they lie.
const SPREAD: f64 = 0.45;
/// Clods begin at least so high over the ground, metres: those that touch it are gone.
const CLOD_ABOVE_M: f64 = 0.05;

/// A fall of this speed, in m/s, throws up the most.
const HARD_LANDING_M_S: f64 = 9.0;
/// Clouds about who lands so hard on the dustiest ground.
const PUFF_CLOUDS: f64 = 16.0;
/// A step is as a landing at this share of its speed, and carries its dust along at that one.
const STEP_SHARE: f64 = 0.14;
const STEP_DRAG: f64 = 0.15;
/// Wheels throw up dust from the first speed on, on ground as hard as rock from the second, and so much faster all of it, m/s.
const SLOW_M_S: f64 = 2.5;
const FAST_M_S: f64 = 9.0;
const ROLLS_FULLY_M_S: f64 = 9.0;
/// Tyres that slide so fast throw up as much, m/s.
const SLIDES_FULLY_M_S: f64 = 4.0;
/// Less dusty ground is hard.
const HARD: f64 = 0.2;
/// Clouds and clods for each metre that a wheel rolls over the dustiest ground.
const CLOUDS_PER_M: f64 = 1.5;
const SPRAY_PER_M: f64 = 0.7;

/// How much dust lies on a kind of ground, 0 to 1.
fn dustiness(kind: Kind) -> f64 {
    match kind {
        Kind::Sand | Kind::Ash => 1.0,
        Kind::Soil | Kind::Coal => 0.75,
        Kind::Gravel => 0.6,
        Kind::Snow => 0.5,
        Kind::Clay => 0.45,
        Kind::Grass | Kind::Wood => 0.3,
        Kind::Moss => 0.22,
        Kind::Rock | Kind::Basalt | Kind::Slate | Kind::Copper | Kind::Crystal => 0.18,
    }
}

/// Bark and splinters.
const WOOD: Surface = Surface {
    kind: Kind::Wood,
    colour: [0.22, 0.13, 0.07],
    sky: 1.0,
};

/// Splinters of boulders and corner stones.
const STONE: Surface = Surface {
    kind: Kind::Rock,
    colour: [0.24, 0.23, 0.22],
    sky: 1.0,
};

/// Leaves of bushes, how many of one fly at a time, and the share of the speed of what goes through that they take along.
const LEAVES: Surface = Surface {
    kind: Kind::Grass,
    colour: [0.15, 0.26, 0.055],
    sky: 1.0,
};
const LEAVES_FLY: f64 = 9.0;
const LEAVES_TAKEN: f64 = 0.45;

/// How a kind of ground breaks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Breaks {
    /// Chips of a spot, spray and clouds.
    pub chips: f64,
    pub spray: f64,
    pub dust: f64,
    /// How dense its clouds are, 0 to 1.
    pub opacity: f64,
    /// How much lighter its dust is than the ground: that is dry and fine.
    pub paler: f32,
    /// Radius of its chips, metres.
    pub chip_m: [f64; 2],
}

/// How a kind of ground breaks.
pub(super) fn breaks(kind: Kind) -> Breaks {
    let of = |chips, spray, dust, opacity, paler, chip_m| Breaks {
        chips,
        spray,
        dust,
        opacity,
        paler,
        chip_m,
    };
    match kind {
        Kind::Grass => of(5.0, 1.5, 1.0, 0.45, 0.12, [0.03, 0.07]),
        Kind::Moss => of(5.0, 1.5, 0.8, 0.38, 0.06, [0.03, 0.07]),
        Kind::Soil => of(4.5, 3.0, 1.8, 0.66, 0.16, [0.02, 0.07]),
        Kind::Clay => of(5.0, 1.0, 1.0, 0.50, 0.14, [0.03, 0.085]),
        Kind::Sand => of(0.0, 14.0, 2.4, 0.80, 0.14, [0.012, 0.02]),
        Kind::Ash => of(0.8, 4.0, 2.8, 0.80, 0.12, [0.015, 0.03]),
        Kind::Snow => of(0.0, 14.0, 2.4, 0.85, 0.30, [0.02, 0.04]),
        Kind::Gravel => of(8.0, 0.0, 1.3, 0.55, 0.25, [0.025, 0.06]),
        Kind::Rock => of(7.0, 0.0, 1.6, 0.60, 0.35, [0.02, 0.09]),
        Kind::Basalt | Kind::Slate => of(7.0, 0.0, 1.3, 0.50, 0.25, [0.02, 0.09]),
        Kind::Coal => of(7.0, 1.0, 1.6, 0.70, 0.03, [0.02, 0.07]),
        Kind::Copper => of(7.0, 0.0, 1.2, 0.45, 0.25, [0.02, 0.075]),
        Kind::Crystal => of(8.0, 0.0, 0.6, 0.32, 0.30, [0.02, 0.08]),
        Kind::Wood => of(7.0, 0.0, 0.7, 0.30, 0.20, [0.025, 0.07]),
    }
}

impl Particles {
    /// Throws up what an effect tells of.
    pub(super) fn throw_up(&mut self, world: &World, effect: &Effect) {
        match *effect {
            Effect::Dug { at, radius_m } => self.dig(world, at, radius_m, 1.0),
            Effect::Built { at, radius_m } => self.dig(world, at, radius_m, 0.0),
            Effect::Struck { at, up, speed_m_s } => self.strike(world, at, up, speed_m_s),
            Effect::Chopped { at, is_stone } => {
                let of = if is_stone { &STONE } else { &WOOD };
                self.burst(at, DVec3::Y, of, 0.8, 1.2);
            }
            Effect::Rustled { at, velocity } => self.strew(at, velocity),
            Effect::Landed { at, speed_m_s } => self.puff(world, at, speed_m_s, DVec3::ZERO),
            Effect::Stepped { at, velocity } => {
                let speed_m_s = STEP_SHARE * velocity.length();
                self.puff(world, at, speed_m_s, velocity * STEP_DRAG);
            }
        }
    }

    /// Puffs under those who land and are not the player.
    pub(super) fn land_others(&mut self, now: Situation<'_>) {
        let mut bodies = now.actors.ecs.query::<(&Bot, &Position, &Body)>();
        for (_, position, body) in &mut bodies {
            if body.0.impact_m_s >= LANDS_FROM_M_S {
                self.puff(now.world, position.0, body.0.impact_m_s, DVec3::ZERO);
            }
        }
    }

    /// Leaves fly along with what goes through them.
    fn strew(&mut self, at: ChartPoint, velocity: DVec3) {
        for _ in 0..self.some(LEAVES_FLY) {
            let radius_m = self.dice.between([0.05, 0.10]);
            let way = self.way(DVec3::Y, 1.3);
            let start = Particle::of(Sort::Chip, at, DVec3::Y, &LEAVES);
            let it = Particle {
                velocity: velocity * LEAVES_TAKEN * self.dice.unit()
                    + way * self.dice.between([1.5, 4.5]),
                life_s: self.dice.between([2.0, 4.0]),
                colour: shaded(LEAVES.colour, self.dice.between([0.7, 1.5]) as f32),
                radius_m: [radius_m; 2],
                shape: self.dice.unit(),
                ..start.raised(0.5 * self.dice.unit())
            };
            self.add(it);
        }
    }

    /// A few chips where a bullet struck.
    fn strike(&mut self, world: &World, at: ChartPoint, up: DVec3, speed_m_s: f64) {
        if let Some(surface) = surface_at(world, at) {
            let large = (speed_m_s / 40.0).clamp(0.3, 0.8);
            self.burst(at, up, &surface, large, 1.0);
        }
    }

    /// A ring of dust along the ground about feet that come down so fast, carried along with a velocity.
    fn puff(&mut self, world: &World, at: ChartPoint, speed_m_s: f64, along: DVec3) {
        let Some(surface) = surface_at(world, at) else {
            return;
        };
        let up = world.ground.normal(at).as_dvec3();
        let hard = (speed_m_s / HARD_LANDING_M_S).min(1.0);
        let dusty = dustiness(surface.kind);
        for _ in 0..self.some(PUFF_CLOUDS * hard * dusty.sqrt()) {
            let flat = self.way(up, std::f64::consts::FRAC_PI_2);
            let flat = (flat - up * flat.dot(up)).normalize_or_zero();
            let speed = self.dice.between([0.7, 2.6]) * hard;
            let velocity = flat * speed + up * (0.35 * speed) + along;
            let radius_m = self.dice.between([0.10, 0.2]) * (0.6 + 0.6 * hard);
            let start = at.moved(flat * (0.25 * self.dice.unit() + 0.05));
            self.cloud(start, up, &surface, velocity, radius_m, 0.5 + 0.6 * hard);
        }
    }

    /// What a wheel throws up behind it.
    pub(super) fn roll(&mut self, rolling: &Rolling) {
        let Rolling { surface, up, .. } = rolling;
        let speed_m_s = rolling.velocity.length();
        let from_m_s = if dustiness(surface.kind) < HARD {
            FAST_M_S
        } else {
            SLOW_M_S
        };
        let fast = ((speed_m_s - from_m_s) / ROLLS_FULLY_M_S).clamp(0.0, 1.0);
        let slides = (rolling.slide_m_s / SLIDES_FULLY_M_S).min(1.0);
        let much = dustiness(surface.kind) * (fast + slides).min(1.5) * rolling.gone_m;
        for _ in 0..self.some(CLOUDS_PER_M * much) {
            let way = self.way(*up, 0.9);
            let velocity = rolling.velocity * 0.22 + way * self.dice.between([0.4, 1.4]);
            let radius_m = self.dice.between([0.18, 0.34]);
            self.cloud(rolling.at, *up, surface, velocity, radius_m, 1.1);
        }
        let thrown = breaks(surface.kind).spray * (fast + slides).min(1.5) * rolling.gone_m;
        for _ in 0..self.some(SPRAY_PER_M * thrown) {
            let way = self.way(*up, 0.7);
            let velocity = rolling.velocity * 0.35 + way * self.dice.between([1.0, 2.8]);
            let radius_m = self.dice.between([0.02, 0.05]);
            self.clod(rolling.at, *up, surface, velocity, radius_m);
        }
    }

    /// Ground flies from some places that a brush covers; of what is laid only dust.
    fn dig(&mut self, world: &World, at: ChartPoint, radius_m: f64, chips: f64) {
        let normal = world.ground.normal(at).as_dvec3();
        for _ in 0..SPOTS {
            let angle = self.dice.heading();
            let away_m = SPREAD * radius_m * self.dice.unit().sqrt();
            let above_m = 0.5 + 0.4 * radius_m;
            let found = on_ground(world, at, normal, (angle, away_m), above_m);
            let Some((spot, up)) = found else {
                continue;
            };
            let Some(surface) = surface_at(world, spot) else {
                continue;
            };
            let large = 0.7 + 0.14 * radius_m;
            self.burst(spot, up, &surface, large, chips);
        }
    }

    /// A burst of ground off a place, away from its normal, so many times as large as that of a small brush.
    fn burst(&mut self, at: ChartPoint, up: DVec3, surface: &Surface, large: f64, chips: f64) {
        let how = breaks(surface.kind);
        for _ in 0..self.some(how.chips * chips) {
            let speed = self.dice.between([1.6, 4.6]) * large.sqrt();
            let radius_m = self.dice.between(how.chip_m) * large;
            let life_s = self.dice.between([2.5, 5.0]);
            let velocity = self.way(up, 0.75) * speed;
            let start = Particle::of(Sort::Chip, at, up, surface);
            let colour = shaded(surface.colour, self.dice.between([0.75, 1.25]) as f32);
            let it = Particle {
                velocity,
                life_s,
                colour,
                radius_m: [radius_m; 2],
                shape: self.dice.unit(),
                ..start.raised(radius_m)
            };
            self.add(it);
        }
        for _ in 0..self.some(how.spray * chips) {
            let radius_m = self.dice.between([0.014, 0.04]) * large;
            let velocity = self.way(up, 0.9) * self.dice.between([1.2, 4.2]) * large.sqrt();
            self.clod(at, up, surface, velocity, radius_m);
        }
        for _ in 0..self.some(how.dust) {
            let radius_m = self.dice.between([0.16, 0.3]) * large;
            let velocity = self.way(up, 0.8) * self.dice.between([0.8, 2.4]) * large;
            self.cloud(at, up, surface, velocity, radius_m, 1.0);
        }
    }

    /// A soft clod.
    fn clod(
        &mut self,
        at: ChartPoint,
        up: DVec3,
        surface: &Surface,
        velocity: DVec3,
        radius_m: f64,
    ) {
        let start = Particle::of(Sort::Spray, at, up, surface);
        let it = Particle {
            velocity,
            life_s: self.dice.between([0.7, 1.3]),
            radius_m: [radius_m, 1.5 * radius_m],
            opacity: 0.8,
            shape: self.dice.unit(),
            ..start.raised(radius_m.max(CLOD_ABOVE_M))
        };
        self.add(it);
    }

    /// A cloud of dust, so many times as dense as its kind's.
    pub(super) fn cloud(
        &mut self,
        at: ChartPoint,
        up: DVec3,
        surface: &Surface,
        velocity: DVec3,
        radius_m: f64,
        dense: f64,
    ) {
        let how = breaks(surface.kind);
        let grows = self.dice.between([2.6, 4.0]);
        let start = Particle::of(Sort::Dust, at, up, surface);
        let it = Particle {
            velocity,
            life_s: self.dice.between([1.0, 2.0]),
            radius_m: [radius_m, grows * radius_m],
            opacity: (how.opacity * dense).min(0.9),
            colour: paler(surface.colour, how.paler),
            shape: self.dice.unit(),
            ..start.raised(0.5 * radius_m)
        };
        self.add(it);
    }

    /// A whole number about a mean: its parts come by chance.
    fn some(&mut self, mean: f64) -> u32 {
        (mean + self.dice.unit()) as u32
    }

    /// A way off ground with that normal, within so many radians of it.
    pub(super) fn way(&mut self, up: DVec3, within_rad: f64) -> DVec3 {
        let (right, ahead) = up.any_orthonormal_pair();
        let (sin, cos) = (TAU * self.dice.unit()).sin_cos();
        let off = within_rad * self.dice.unit().sqrt();
        up * off.cos() + (right * cos + ahead * sin) * off.sin()
    }
}

impl Particle {
    /// One of a sort off a place, at rest.
    pub(super) fn of(sort: Sort, at: ChartPoint, up: DVec3, surface: &Surface) -> Self {
        Self {
            point: at,
            velocity: DVec3::ZERO,
            sort,
            age_s: 0.0,
            life_s: 1.0,
            radius_m: [0.05; 2],
            opacity: 1.0,
            colour: surface.colour,
            sky: surface.sky,
            shape: 0.0,
            turned_m: 0.0,
            up,
            height_m: 0.0,
            lies: false,
        }
    }

    /// The same so much farther from the ground, metres.
    fn raised(self, by_m: f64) -> Self {
        Self {
            point: self.point.moved(self.up * by_m),
            height_m: self.height_m + by_m,
            ..self
        }
    }
}

/// The place on the ground that far from another along it, in a direction told by an angle, and the ground's normal there. So far
/// above it the ground is looked for, metres, and as far below.
fn on_ground(
    world: &World,
    at: ChartPoint,
    normal: DVec3,
    (angle, away_m): (f64, f64),
    above_m: f64,
) -> Option<(ChartPoint, DVec3)> {
    let (right, ahead) = normal.any_orthonormal_pair();
    let beside = (right * angle.cos() + ahead * angle.sin()) * away_m;
    let from = at.pos + beside + normal * above_m;
    let ground = world.physics.chart(at.chart);
    let hit = ground.cast_ray(from, -normal, 2.0 * above_m)?;
    Some((ChartPoint::new(at.chart, hit.point), hit.normal))
}

fn shaded(colour: [f32; 3], by: f32) -> [f32; 3] {
    colour.map(|channel| channel * by)
}

/// The same, a share of the way to a light grey.
fn paler(colour: [f32; 3], by: f32) -> [f32; 3] {
    colour.map(|channel| channel + (0.75 - channel) * by)
}
