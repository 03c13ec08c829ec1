//! What the wheels of cars do to the ground: prints behind them, which fade, and what they throw up.

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_physics::RayHit;
use antipode_terrain::Kind;
use glam::{DQuat, DVec3};

use super::{Surface, surface_at};
use crate::actors::ActorId;
use crate::car::CarView;
use crate::frame::{GroundMark, MarkShape};
use crate::situation::Situation;
use crate::world::World;

/// Prints of all wheels at once. More take the places of the oldest.
pub(crate) const MOST_PRINTS: usize = 1024;
/// How long a print lasts, and for how long of that it fades, seconds.
const LASTS_S: f64 = 30.0;
const FADES_S: f64 = 14.0;
/// Length of a print, metres.
const PRINT_M: f64 = 0.32;
/// A wheel that has come farther than this since the last one was lifted or put elsewhere, metres.
const LEAP_M: f64 = 1.6;
/// Half of a tyre's width, metres.
const HALF_WIDTH_M: f64 = 0.14;
/// Prints lie so high over the ground, metres.
const LIFT_M: f64 = 0.012;
/// The ground below a hub is looked for this far, metres.
const BELOW_HUB_M: f64 = 0.75;
/// The ground beside a wheel is looked for from so far above it, and as far below, metres.
const BESIDE_M: f64 = 0.3;
/// A print whose ground is farther off than this has lost it, metres.
const LOST_M: f64 = 0.05;
/// How fast tyres slide to leave prints that are twice as dark, m/s.
const DARK_SLIDE_M_S: f64 = 4.0;

/// A wheel on its way.
#[derive(Debug)]
struct Trail {
    wheel: (ActorId, usize),
    /// Where it touched the ground when it left its last print, and that print's end.
    from: Option<(ChartPoint, [DVec3; 2])>,
    strength: f32,
    along_m: f64,
}

/// A print on the ground.
#[derive(Clone, Debug, PartialEq)]
struct Print {
    mark: GroundMark,
    up: DVec3,
    /// When it was left, simulated seconds.
    at_s: f64,
}

/// A wheel that rolls over ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rolling {
    pub at: ChartPoint,
    pub up: DVec3,
    pub surface: Surface,
    /// The car's, in its chart, m/s.
    pub velocity: DVec3,
    pub slide_m_s: f64,
    /// How far it has rolled since it was told of last, metres.
    pub gone_m: f64,
}

/// Prints of all wheels.
#[derive(Debug)]
pub(crate) struct Tracks {
    prints: Vec<Print>,
    /// Where the next print goes once there are so many.
    next: usize,
    trails: Vec<Trail>,
}

impl Default for Tracks {
    fn default() -> Self {
        Self {
            prints: Vec::with_capacity(MOST_PRINTS),
            next: 0,
            trails: Vec::new(),
        }
    }
}

/// How dark the prints in a kind of ground are, 0 to 1.
fn softness(kind: Kind) -> f64 {
    match kind {
        Kind::Snow => 0.50,
        Kind::Sand | Kind::Ash => 0.46,
        Kind::Soil => 0.44,
        Kind::Clay => 0.36,
        Kind::Moss => 0.28,
        Kind::Grass => 0.24,
        Kind::Gravel => 0.14,
        Kind::Rock
        | Kind::Basalt
        | Kind::Slate
        | Kind::Coal
        | Kind::Copper
        | Kind::Crystal
        | Kind::Wood => 0.0,
    }
}

impl Tracks {
    /// Lets wheels leave prints; tells of those that have rolled on.
    pub fn step(&mut self, now: Situation<'_>, mut rolled: impl FnMut(Rolling)) {
        let now_s = now.world.simulated_s;
        let is_old = |print: &Print| now_s - print.at_s > LASTS_S;
        if self.prints.iter().all(is_old) {
            self.forget();
        }
        let cars = now.actors.car_views();
        self.trails
            .retain(|it| cars.iter().any(|car| car.id == it.wheel.0));
        for car in cars.iter().filter(|car| !car.rests) {
            for number in 0..car.wheels.len() {
                if let Some(rolling) = self.roll(now.world, car, number) {
                    rolled(rolling);
                }
            }
        }
    }

    fn forget(&mut self) {
        self.prints.clear();
        self.next = 0;
    }

    /// Prints whose ground has gone, or has been built over, go with it. A brush that digs changes a few chunks many times a second,
    /// and there may be a thousand prints: those elsewhere are not looked at.
    pub fn ground_changed(&mut self, world: &World, chunks: &[ChunkCoord]) {
        let is_there = |print: &Print| chunks.contains(&print.chunk());
        self.prints.retain(|it| !is_there(it) || it.is_held(world));
        self.next = 0;
    }

    /// How many prints can be seen.
    pub fn count(&self, now_s: f64) -> usize {
        self.prints.iter().filter(|it| it.left(now_s) > 0.0).count()
    }

    /// What a picture shows of them at a time.
    pub fn seen(&self, now_s: f64) -> impl Iterator<Item = GroundMark> {
        self.prints.iter().filter_map(move |print| {
            let left = print.left(now_s) as f32;
            (left > 0.0).then(|| GroundMark {
                strength: print.mark.strength.map(|it| it * left),
                ..print.mark
            })
        })
    }

    /// Lets one wheel roll on from where it left its last print.
    fn roll(&mut self, world: &World, car: &CarView, number: usize) -> Option<Rolling> {
        let wheel = &car.wheels[number];
        let known = (car.id, number);
        let place = self.trails.iter().position(|it| it.wheel == known);
        let place = place.unwrap_or_else(|| {
            self.trails.push(Trail {
                wheel: known,
                from: None,
                strength: 0.0,
                along_m: 0.0,
            });
            self.trails.len() - 1
        });
        let trail = &mut self.trails[place];
        let chart = car.point.chart;
        let touch = wheel
            .contact
            .then(|| below(world, car, wheel.hub))
            .flatten();
        let Some(touch) = touch else {
            trail.from = None;
            return None;
        };
        let axle = car.turn * DQuat::from_rotation_y(-wheel.steer_rad) * DVec3::Z;
        let at = ChartPoint::new(chart, touch.point);
        let from = trail
            .from
            .filter(|(from, _)| from.chart == chart && from.pos.distance(at.pos) < LEAP_M);
        let gone_m = from.map_or(0.0, |(from, _)| from.pos.distance(at.pos));
        if from.is_some() && gone_m < PRINT_M {
            return None;
        }
        let edges = edges(world, &at, touch.normal, car.level.in_chart(axle));
        let before = trail.strength;
        trail.from = Some((at, edges));
        let (_, [left, right]) = from?;
        let surface = surface_at(world, at)?;
        let dark = 1.0 + (wheel.slide_m_s.abs() / DARK_SLIDE_M_S).min(1.0);
        trail.strength = (softness(surface.kind) * dark).min(0.85) as f32;
        let begin_m = trail.along_m;
        trail.along_m += gone_m;
        let mark = GroundMark {
            chart,
            corners: [left, right, edges[0], edges[1]],
            shape: MarkShape::Print,
            strength: [before, trail.strength],
            along_m: [begin_m, trail.along_m].map(|it| it as f32),
        };
        if mark.strength != [0.0; 2] {
            self.leave(mark, touch.normal, world.simulated_s);
        }
        Some(Rolling {
            at,
            up: touch.normal,
            surface,
            velocity: car.velocity,
            slide_m_s: wheel.slide_m_s.abs(),
            gone_m,
        })
    }

    pub(super) fn leave(&mut self, mark: GroundMark, up: DVec3, at_s: f64) {
        let print = Print { mark, up, at_s };
        if self.prints.len() < MOST_PRINTS {
            self.prints.push(print);
            return;
        }
        self.prints[self.next] = print;
        self.next = (self.next + 1) % MOST_PRINTS;
    }
}

impl Print {
    /// Which share of its strength is left at a time.
    fn left(&self, now_s: f64) -> f64 {
        ((LASTS_S - (now_s - self.at_s)) / FADES_S).clamp(0.0, 1.0)
    }

    fn middle(&self) -> DVec3 {
        self.mark.corners.iter().sum::<DVec3>() / 4.0
    }

    fn chunk(&self) -> ChunkCoord {
        let on_ground = self.middle() - self.up * LIFT_M;
        ChunkCoord::containing(ChartPoint::new(self.mark.chart, on_ground))
    }

    /// Whether the ground is still where it was pressed into it.
    fn is_held(&self, world: &World) -> bool {
        let middle = self.middle();
        let from = middle + self.up * BESIDE_M;
        let ground = world.physics.chart(self.mark.chart);
        let hit = ground.cast_ray(from, -self.up, 2.0 * BESIDE_M);
        hit.is_some_and(|hit| (hit.distance_m - BESIDE_M).abs() < LOST_M)
    }
}

/// The ground below the hub of a wheel.
fn below(world: &World, car: &CarView, hub: DVec3) -> Option<RayHit> {
    let hub = car.place(hub);
    let down = car.turn * DVec3::NEG_Y;
    let ground = world.physics.chart(hub.chart);
    ground.cast_ray(hub.pos, down, BELOW_HUB_M)
}

/// Places on the ground left and right of where a wheel touches it; `axle` is a metre of the space along it, in the chart.
fn edges(world: &World, at: &ChartPoint, normal: DVec3, axle: DVec3) -> [DVec3; 2] {
    let ground = world.physics.chart(at.chart);
    [-HALF_WIDTH_M, HALF_WIDTH_M].map(|side_m| {
        let beside = at.pos + axle * side_m;
        let from = beside + normal * BESIDE_M;
        let hit = ground.cast_ray(from, -normal, 2.0 * BESIDE_M);
        hit.map_or(beside, |hit| hit.point) + normal * LIFT_M
    })
}
