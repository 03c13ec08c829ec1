//! Bodies on the level ground of a closed world: as fast everywhere and in every direction, and straight on along great circles.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::{Arc, OnceLock};

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, Geometry, Strategy, strategy};
use antipode_physics::{
    Ball, BallTuning, Character, CharacterInput, CharacterTuning, PhysicsWorld,
};
use glam::{DVec3, IVec3, Vec3};

use crate::common::{STEP_S, Soup};

const RADIUS_M: f64 = 32.0;
const HEIGHT_M: f64 = 10.0;
/// The ground of each chart reaches so far past the rim, as that of the game does, in metres.
const BEYOND_M: f64 = 8.0;

/// Level ground over all of both charts.
fn world() -> &'static (Arc<dyn Strategy>, PhysicsWorld) {
    static WORLD: OnceLock<(Arc<dyn Strategy>, PhysicsWorld)> = OnceLock::new();
    WORLD.get_or_init(|| {
        let space = strategy(Geometry::Spherical, RADIUS_M);
        let most_m = FRAC_PI_2 * RADIUS_M + BEYOND_M;
        let most = most_m as i32 + 1;
        let mut soup = Soup::default();
        for (x, z) in (-most..most).flat_map(|x| (-most..most).map(move |z| (x, z))) {
            if f64::from(x).hypot(f64::from(z)) > most_m {
                continue;
            }
            let at = |x: i32, z: i32| Vec3::new(x as f32, HEIGHT_M as f32, z as f32);
            soup.quad(
                [at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)],
                Vec3::Y,
            );
        }
        let ground = soup.build();
        let mut physics = PhysicsWorld::new();
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            let coord = ChunkCoord::new(chart, IVec3::ZERO);
            let there = physics.chart_mut(chart);
            there.set_terrain(coord, DVec3::ZERO, Some(ground.clone()));
        }
        (space, physics)
    })
}

fn halton(index: u32, base: u32) -> f64 {
    let (mut part, mut sum, mut left) = (1.0, 0.0, index);
    while left > 0 {
        part /= f64::from(base);
        sum += part * f64::from(left % base);
        left /= base;
    }
    sum
}

/// Places all over the world, each with a heading.
fn places() -> impl Iterator<Item = (ChartPoint, f64)> {
    (1..=50).map(|n| {
        let [far, around, heading] = [2, 3, 5].map(|base| halton(n, base));
        let level_m = (1.0 - far).acos() * RADIUS_M;
        let (z, x) = (around * TAU).sin_cos();
        let chart = if n % 2 == 0 {
            ChartId::FIRST
        } else {
            ChartId::SECOND
        };
        let at = ChartPoint::new(chart, DVec3::new(x * level_m, HEIGHT_M, z * level_m));
        (at, heading * TAU)
    })
}

/// Somebody who keeps straight on.
struct Walker {
    at: ChartPoint,
    yaw: f64,
    body: Character,
    tuning: CharacterTuning,
}

impl Walker {
    fn new((at, yaw): (ChartPoint, f64)) -> Self {
        let mut walker = Self {
            at,
            yaw,
            body: Character::at(at.pos),
            tuning: CharacterTuning::default(),
        };
        for _ in 0..60 {
            walker.step(false);
        }
        walker
    }

    fn heading(&self) -> DVec3 {
        DVec3::new(self.yaw.cos(), 0.0, self.yaw.sin())
    }

    fn step(&mut self, jump: bool) {
        let (space, physics) = world();
        let input = CharacterInput {
            wish: self.heading(),
            jump,
            ..CharacterInput::default()
        };
        let ground = physics.for_bodies(&**space, self.at.chart);
        self.yaw -= ground.move_character(&mut self.body, &self.tuning, &input, STEP_S);
        self.at.pos = self.body.feet;
        if let Some(crossing) = space.cross(self.at) {
            self.at = crossing.point;
            self.body.feet = self.at.pos;
            self.body.velocity = crossing.turn_vector(self.body.velocity);
            self.yaw -= crossing.turn_rad;
        }
    }
}

/// The way that a foot looks at another, and how far that is along the level at a height, metres.
fn seen(from: ChartPoint, to: ChartPoint, height_m: f64) -> (DVec3, f64) {
    let (space, _) = world();
    let foot = |at: ChartPoint| ChartPoint::new(at.chart, at.pos.with_y(0.0));
    let eye = Eye {
        point: foot(from),
        ..Eye::default()
    };
    let way = eye.to_chart(space.view_point(&eye, foot(to)).truncate());
    let plane_m = space.distance_m(foot(from), foot(to), &eye);
    (way.normalize(), plane_m * (height_m / RADIUS_M).cos())
}

#[test]
fn a_walk_is_as_fast_at_every_place_and_in_every_direction() {
    for place in places() {
        let mut walker = Walker::new(place);
        let mut gone_m = 0.0;
        for _ in 0..60 {
            let before = walker.at;
            walker.step(false);
            gone_m += seen(before, walker.at, walker.at.pos.y).1;
        }
        assert!(walker.body.grounded, "{place:?}");
        let walk_m = walker.tuning.walk_speed_m_s;
        assert!(
            (gone_m / walk_m - 1.0).abs() < 1e-4,
            "{place:?}: {gone_m} m in a second"
        );
        assert!((walker.body.velocity.length() - walk_m).abs() < 1e-9);
    }
}

/// A great circle is told by the place and the heading at its start: a quarter of the way round on, the foot has that place a
/// quarter of a turn away, and looks along the circle.
#[test]
fn straight_on_is_a_great_circle_over_a_quarter_of_the_world() {
    let (space, _) = world();
    for place in places() {
        let mut walker = Walker::new(place);
        let start = walker.at;
        let around = Eye {
            point: ChartPoint::new(start.chart, start.pos.with_y(0.0)),
            ..Eye::default()
        };
        let side = DVec3::new(-walker.yaw.sin(), 0.0, walker.yaw.cos());
        let aside_rad = |at: ChartPoint| {
            let foot = ChartPoint::new(at.chart, at.pos.with_y(0.0));
            let view = space.view_point(&around, foot).truncate() / RADIUS_M;
            around.to_chart(view).dot(side).asin()
        };
        let quarter_m = FRAC_PI_2 * RADIUS_M * (HEIGHT_M / RADIUS_M).cos();
        let steps = (quarter_m / (walker.tuning.walk_speed_m_s * STEP_S)) as u32;
        for step in 0..steps {
            walker.step(step % 60 == 7);
            let off_rad = aside_rad(walker.at);
            assert!(
                off_rad.abs() < 1e-6,
                "{place:?}: {off_rad} rad aside after {step} steps"
            );
        }
        let back = seen(walker.at, start, 0.0).0;
        let turned_rad = (back + walker.heading()).length();
        assert!(
            turned_rad < 0.1_f64.to_radians(),
            "{place:?}: {turned_rad} rad off the way"
        );
    }
}

#[test]
fn a_jump_is_as_high_and_as_wide_everywhere() {
    for place in places() {
        let mut walker = Walker::new(place);
        let start = walker.at;
        let mut highest_m: f64 = 0.0;
        walker.step(true);
        let mut steps = 1.0;
        while !walker.body.grounded {
            highest_m = highest_m.max(walker.at.pos.y - HEIGHT_M);
            walker.step(false);
            steps += 1.0;
        }
        let (_, wide_m) = seen(start, walker.at, HEIGHT_M);
        let should_m = walker.tuning.walk_speed_m_s * steps * STEP_S;
        // Up to a metre higher a metre of the level is up to a hundredth more.
        assert!(
            (wide_m / should_m - 1.0).abs() < 0.01,
            "{place:?}: {wide_m} of {should_m} m"
        );
        let high_m = walker.tuning.jump_height_m;
        assert!(
            (highest_m - high_m).abs() < 0.02,
            "{place:?}: {highest_m} m high"
        );
    }
}

#[test]
fn who_stands_stays_put_to_the_bit() {
    let (space, physics) = world();
    for (at, _) in places() {
        let mut body = Character::at(at.pos);
        let ground = physics.for_bodies(&**space, at.chart);
        let (tuning, still) = (CharacterTuning::default(), CharacterInput::default());
        for _ in 0..30 {
            ground.move_character(&mut body, &tuning, &still, STEP_S);
        }
        let before = body.clone();
        assert!(
            before.grounded && ground.move_character(&mut body, &tuning, &still, STEP_S) == 0.0
        );
        assert_eq!(body, before);
        assert!(body.feet.distance(at.pos) < 1e-6, "{at:?} {}", body.feet);
    }
}

/// What is thrown bounces off level ground as high and as far in every direction, and keeps its way.
#[test]
fn a_ball_flies_as_far_everywhere() {
    let (space, physics) = world();
    let tuning = BallTuning {
        radius_m: 0.05,
        gravity_m_s2: 9.81,
        bounce: 1.0,
        slide: 1.0,
    };
    for (start, yaw) in places() {
        let ahead = DVec3::new(yaw.cos(), 0.0, yaw.sin());
        let mut at = start.moved(DVec3::Y * 0.5);
        let mut velocity = ahead * 6.0 + DVec3::Y;
        let (mut gone_m, mut touches) = (0.0, 0);
        for _ in 0..60 {
            let mut ball = Ball {
                centre: at.pos,
                velocity,
            };
            let ground = physics.for_bodies(&**space, at.chart);
            touches += usize::from(
                ground
                    .throw_ball(&mut ball, &tuning, STEP_S)
                    .touch
                    .is_some(),
            );
            let next = ChartPoint::new(at.chart, ball.centre);
            gone_m += seen(at, next, at.pos.y).1;
            (at, velocity) = (next, ball.velocity);
            if let Some(crossing) = space.cross(at) {
                (at, velocity) = (crossing.point, crossing.turn_vector(velocity));
            }
        }
        assert!(touches > 0, "{start:?}");
        assert!(
            (gone_m / 6.0 - 1.0).abs() < 2e-3,
            "{start:?}: {gone_m} m in a second"
        );
        let (way, _) = seen(start, at, 0.0);
        assert!(way.distance(ahead) < 1e-3, "{start:?}: {way} for {ahead}");
        // Casts of balls tell normals in single precision.
        let level_m_s = velocity.with_y(0.0).length();
        assert!((level_m_s - 6.0).abs() < 0.02, "{start:?}: {level_m_s}");
    }
}
