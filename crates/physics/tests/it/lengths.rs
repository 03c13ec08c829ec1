//! Cars on the level ground of spaces whose charts are not true to length: as fast as on flat land wherever they are, and straight on
//! along geodesics.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;
use std::time::Instant;

use antipode_geometry::{
    ChartId, ChartPoint, ChunkCoord, Eye, Geometry, HyperbolicWorld, Strategy, strategy,
};
use antipode_physics::{
    PhysicsWorld, TerrainCollider, Vehicle, VehicleInput, VehicleMotion, VehiclePhysics,
};
use glam::{DQuat, DVec3, IVec3, Vec3};

use crate::common::{STEP_S, Soup};
use crate::vehicle::ahead;

const HEIGHT_M: f64 = 10.0;
/// The ground of each chart reaches so far past its edge, as that of the game does, in metres.
const BEYOND_M: f64 = 8.0;
/// A tile is so wide, in metres.
const TILE_M: f64 = 64.0;
const TILES_RADIUS_M: f64 = 60.305;

/// A space with level ground, in each chart that somebody has been in.
struct Land {
    space: Arc<dyn Strategy>,
    ground: Vec<(IVec3, TerrainCollider)>,
    world: PhysicsWorld,
}

impl Land {
    fn new(space: Arc<dyn Strategy>, reaches: impl Fn(f64, f64) -> bool) -> Self {
        let most = 14;
        let chunk = |cx: i32, cz: i32| {
            let is_there = |x: i32, z: i32| reaches(f64::from(32 * cx + x), f64::from(32 * cz + z));
            let cells = (0..32).flat_map(|x| (0..32).map(move |z| (x, z)));
            let at = |x: i32, z: i32| (x * 33 + z) as u32;
            let triangles = cells.filter(|&(x, z)| is_there(x, z)).flat_map(|(x, z)| {
                let [a, b] = [at(x, z), at(x + 1, z)];
                [[a, a + 1, b], [b, a + 1, b + 1]]
            });
            let triangles: Vec<[u32; 3]> = triangles.collect();
            let places = (0..33).flat_map(|x| (0..33).map(move |z| (x, z)));
            let places = places.map(|(x, z)| [x as f32, HEIGHT_M as f32, z as f32]);
            let ground = TerrainCollider::build(&places.collect::<Vec<_>>(), &triangles)?;
            Some((IVec3::new(cx, 0, cz), ground))
        };
        let all = (-most..most).flat_map(|x| (-most..most).map(move |z| (x, z)));
        Self {
            space,
            ground: all.filter_map(|(x, z)| chunk(x, z)).collect(),
            world: PhysicsWorld::new(),
        }
    }

    fn sphere(radius_m: f64) -> Self {
        let most_m = FRAC_PI_2 * radius_m + BEYOND_M;
        let space = strategy(Geometry::Spherical, radius_m);
        Self::new(space, |x, z| x.hypot(z) < most_m)
    }

    fn tiles() -> Self {
        let most_m = 0.5 * TILE_M + BEYOND_M;
        let space = Arc::new(HyperbolicWorld::new(TILES_RADIUS_M));
        Self::new(space, |x, z| {
            [x, z].iter().all(|it| (-most_m..most_m).contains(it))
        })
    }

    fn admit(&mut self, chart: ChartId) {
        if self.world.chart(chart).terrain_count() > 0 {
            return;
        }
        for (index, ground) in &self.ground {
            let coord = ChunkCoord::new(chart, *index);
            let there = self.world.chart_mut(chart);
            there.set_terrain(coord, coord.min(), Some(ground.clone()));
        }
    }

    /// How many metres of the space it is from one place to another along the level, and the way that the one looks at the other.
    fn way(&self, from: ChartPoint, to: ChartPoint) -> (f64, DVec3) {
        let foot = |at: ChartPoint| ChartPoint::new(at.chart, at.pos.with_y(0.0));
        let eye = Eye {
            point: foot(from),
            ..Eye::default()
        };
        let view = self.space.view_point(&eye, foot(to));
        let way = eye.to_chart(view.truncate()).normalize_or_zero();
        let plane_m = self.space.distance_m(foot(from), foot(to), &eye);
        let sign = self.space.curvature().sign;
        let up = from.pos.y / self.space.radius_m();
        let stretch = if sign > 0.0 { up.cos() } else { up.cosh() };
        (plane_m * stretch, way)
    }
}

struct Drive {
    physics: VehiclePhysics,
    car: Vehicle,
}

fn turned(yaw: f64) -> DVec3 {
    DVec3::new(yaw.cos(), 0.0, yaw.sin())
}

impl Drive {
    fn at(land: &mut Land, place: ChartPoint, yaw: f64) -> Self {
        let physics = VehiclePhysics::default().in_space(&land.space);
        let place = ChartPoint::new(place.chart, place.pos.with_y(HEIGHT_M + 0.05));
        let car = physics.vehicle(VehicleMotion::at(place, DQuat::from_rotation_y(-yaw)));
        let mut drive = Self { physics, car };
        for _ in 0..60 {
            drive.step(land, VehicleInput::default());
        }
        drive
    }

    fn point(&self) -> ChartPoint {
        self.car.motion().point()
    }

    /// A step, and how far it went, in metres of the space.
    fn step(&mut self, land: &mut Land, input: VehicleInput) -> f64 {
        let before = self.point();
        land.admit(before.chart);
        let mut all = [(&mut self.car, Some(input))];
        self.physics.step(&land.world, None, &mut all, STEP_S);
        let (way_m, _) = land.way(before, self.point());
        if let Some(crossing) = land.space.cross(self.point()) {
            self.physics.carry(&mut self.car, &crossing);
        }
        way_m
    }

    /// Gets to top speed and says how far a second goes then, in metres.
    fn top_speed_m_s(&mut self, land: &mut Land) -> f64 {
        for _ in 0..300 {
            self.step(land, ahead());
        }
        (0..60).map(|_| self.step(land, ahead())).sum()
    }

    /// Brakes until it stands, and says how far that went, in metres.
    fn braking_m(&mut self, land: &mut Land) -> f64 {
        let brake = VehicleInput {
            brake: true,
            ..VehicleInput::default()
        };
        (0..240).map(|_| self.step(land, brake)).sum()
    }
}

/// What a car does on flat land: metres in a second at top speed, and to stand still again.
fn on_flat_land() -> (f64, f64) {
    let mut soup = Soup::default();
    for (x, z) in (-10..300).flat_map(|x| (-10..10).map(move |z| (x, z))) {
        let at = |x: i32, z: i32| Vec3::new(x as f32, 0.0, z as f32);
        soup.quad(
            [at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)],
            Vec3::Y,
        );
    }
    let world = soup.charts_at(DVec3::ZERO);
    let mut physics = VehiclePhysics::default();
    let mut car = physics.vehicle(VehicleMotion {
        place: DVec3::Y * 0.05,
        ..VehicleMotion::default()
    });
    let mut gone = |count: usize, input: VehicleInput| {
        let mut gone_m = 0.0;
        for _ in 0..count {
            let before = car.motion().place;
            physics.step(&world, None, &mut [(&mut car, Some(input))], STEP_S);
            gone_m += car.motion().place.distance(before);
        }
        gone_m
    };
    gone(60, VehicleInput::default());
    gone(300, ahead());
    let second_m = gone(60, ahead());
    let brake = VehicleInput {
        brake: true,
        ..VehicleInput::default()
    };
    (second_m, gone(240, brake))
}

/// Places of a sphere, each with a heading: about a pole, between, along the equator, over it straight and aslant.
fn on_sphere(radius_m: f64) -> Vec<(ChartPoint, f64)> {
    let rim_m = FRAC_PI_2 * radius_m;
    let at = |share: f64, azimuth: f64, heading: f64, chart: ChartId| {
        let pos = turned(azimuth) * (share * rim_m);
        (ChartPoint::new(chart, pos), azimuth + heading)
    };
    let (first, second) = (ChartId::FIRST, ChartId::SECOND);
    vec![
        at(0.0, 0.0, 0.7, first),
        at(0.5, 2.0, 1.1, second),
        at(0.98, 0.4, 0.25 * TAU, first),
        at(1.0, 3.9, 0.25 * TAU, second),
        at(0.9, 5.1, 0.0, first),
        at(0.8, 1.2, 0.9, second),
    ]
}

/// Places of a tile, each with a heading: over an edge, over a corner, and near to one aslant.
fn in_tiles() -> Vec<(ChartPoint, f64)> {
    [
        (DVec3::ZERO, 0.0),
        (DVec3::new(-5.0, 0.0, 9.0), 2.3),
        (DVec3::new(12.0, 0.0, 12.0), 0.125 * TAU),
        (DVec3::new(28.0, 0.0, 29.0), 0.6 * TAU),
        (DVec3::new(31.0, 0.0, -20.0), 0.25 * TAU),
    ]
    .map(|(pos, yaw)| (ChartPoint::a(pos), yaw))
    .to_vec()
}

fn all_lands() -> Vec<(Land, Vec<(ChartPoint, f64)>)> {
    let mut all: Vec<_> = [64.0, 256.0]
        .map(|it| (Land::sphere(it), on_sphere(it)))
        .into();
    all.push((Land::tiles(), in_tiles()));
    all
}

#[test]
fn a_car_is_as_fast_and_stops_as_soon_as_on_flat_land() {
    let (second_m, stop_m) = on_flat_land();
    assert!((14.0..15.5).contains(&second_m), "{second_m}");
    for (mut land, places) in all_lands() {
        for (place, yaw) in places {
            let name = format!("{:?} from {place:?} by {yaw}", land.space);
            let mut drive = Drive::at(&mut land, place, yaw);
            let gone_m = drive.top_speed_m_s(&mut land);
            let told_m_s = drive.car.motion().speed_m_s();
            let braked_m = drive.braking_m(&mut land);
            println!("{name}: {gone_m} m/s of {second_m}, {braked_m} m of {stop_m}");
            assert!((gone_m / second_m - 1.0).abs() < 0.01, "{name}: {gone_m}");
            assert!(
                (told_m_s / gone_m - 1.0).abs() < 0.01,
                "{name}: {told_m_s} said of {gone_m}"
            );
            assert!((braked_m / stop_m - 1.0).abs() < 0.02, "{name}: {braked_m}");
            assert!((drive.point().pos.y - HEIGHT_M).abs() < 0.05, "{name}");
        }
    }
}

#[test]
fn a_car_that_goes_straight_on_keeps_a_geodesic() {
    for (mut land, places) in all_lands() {
        let radius_m = land.space.radius_m().min(64.0);
        let way_m = FRAC_PI_2 * radius_m;
        for (place, yaw) in places {
            let name = format!("{:?} from {place:?} by {yaw}", land.space);
            let mut drive = Drive::at(&mut land, place, yaw);
            let start = drive.point();
            let heading = drive.car.motion().ahead().with_y(0.0).normalize();
            let (mut gone_m, mut aside_rad): (f64, f64) = (0.0, 0.0);
            while gone_m < way_m {
                gone_m += drive.step(&mut land, ahead());
                let (far_m, way) = land.way(start, drive.point());
                if far_m > 5.0 {
                    aside_rad = aside_rad.max(way.angle_between(heading));
                }
            }
            let (_, back) = land.way(drive.point(), start);
            let ahead = drive.car.motion().ahead().with_y(0.0).normalize();
            let turned_rad = (-back).angle_between(ahead);
            println!("{name}: {aside_rad} aside, {turned_rad} turned");
            let most_rad = 0.5_f64.to_radians();
            assert!(aside_rad < most_rad, "{name}: {aside_rad} rad aside");
            assert!(turned_rad < most_rad, "{name}: turned by {turned_rad} rad");
        }
    }
}

/// What is felt in a step: speed, height, springs, and by how much it looks elsewhere than straight on.
#[test]
fn nothing_is_felt_of_edges_nor_of_ground_that_is_laid_anew() {
    for (mut land, places) in all_lands() {
        for (place, yaw) in places {
            let name = format!("{:?} from {place:?} by {yaw}", land.space);
            let mut drive = Drive::at(&mut land, place, yaw);
            drive.top_speed_m_s(&mut land);
            let (mut before, mut crossed) = (drive.car.motion(), 0);
            for _ in 0..240 {
                let way_m = drive.step(&mut land, ahead());
                let now = drive.car.motion();
                crossed += usize::from(now.chart != before.chart);
                let springs = drive.car.wheels().map(|it| it.compression_m);
                let speed_m_s = way_m / STEP_S;
                let is_smooth = (speed_m_s / before.velocity.length() - 1.0).abs() < 2e-3;
                assert!(is_smooth, "{name}: {speed_m_s} after {before:?}");
                let rise_m = now.place.y - before.place.y;
                assert!(rise_m.abs() < 1e-3, "{name}: up by {rise_m}");
                assert!(
                    drive.car.jolt_m_s() < 0.05,
                    "{name}: {}",
                    drive.car.jolt_m_s()
                );
                assert!(
                    springs.iter().all(|it| (0.1..0.14).contains(it)),
                    "{name}: {springs:?}"
                );
                before = now;
            }
            println!("{name}: {crossed} crossed");
        }
    }
}

/// Two that drive into each other over an edge meet there.
#[test]
fn cars_meet_over_edges() {
    for (mut land, edge_m) in [
        (Land::sphere(64.0), FRAC_PI_2 * 64.0),
        (Land::tiles(), 0.5 * TILE_M),
    ] {
        let at = |off_m: f64| ChartPoint::a(DVec3::new(edge_m + off_m, HEIGHT_M + 0.05, 3.0));
        let mut physics = VehiclePhysics::default().in_space(&land.space);
        let over = land.space.cross(at(5.0)).unwrap();
        land.admit(ChartId::FIRST);
        land.admit(over.point.chart);
        let near = VehicleMotion::at(at(-5.0), DQuat::IDENTITY);
        let far = VehicleMotion::at(at(5.0), DQuat::from_rotation_y(0.5 * TAU)).carried(&over);
        let mut cars = [near, far].map(|it| physics.vehicle(it));
        let mut jolt_m_s: f64 = 0.0;
        for _ in 0..150 {
            let [a, b] = &mut cars;
            let mut all = [(a, Some(ahead())), (b, Some(ahead()))];
            physics.step(&land.world, None, &mut all, STEP_S);
            for car in &mut cars {
                jolt_m_s = jolt_m_s.max(car.jolt_m_s());
                if let Some(crossing) = land.space.cross(car.motion().point()) {
                    physics.carry(car, &crossing);
                }
            }
        }
        let [a, b] = cars.map(|it| it.motion());
        let (apart_m, _) = land.way(a.point(), b.point());
        assert!(jolt_m_s > 2.0, "{:?}: {jolt_m_s} m/s", land.space);
        assert!(
            (2.5..4.5).contains(&apart_m),
            "{:?}: {apart_m} m",
            land.space
        );
        assert!(a.place.y > HEIGHT_M - 0.2 && b.place.y > HEIGHT_M - 0.2);
    }
}

/// Prints what a step costs in metres of the chart and of the space, at top speed.
#[test]
#[ignore = "it measures"]
fn print_times() {
    let lands = [Land::sphere(64.0), Land::sphere(256.0), Land::tiles()];
    for mut land in lands {
        for boost in [false, true] {
            let mut times = [Vec::new(), Vec::new()];
            for round in 0..8 {
                let mut drive = Drive::at(&mut land, ChartPoint::a(DVec3::new(3.0, 0.0, 3.0)), 0.4);
                if round % 2 == 0 {
                    drive.physics = VehiclePhysics::default();
                    drive.car = drive.physics.vehicle(drive.car.motion());
                }
                let input = VehicleInput { boost, ..ahead() };
                for _ in 0..600 {
                    land.admit(drive.point().chart);
                    let mut all = [(&mut drive.car, Some(input))];
                    let begun = Instant::now();
                    drive.physics.step(&land.world, None, &mut all, STEP_S);
                    times[round % 2].push(begun.elapsed().as_secs_f64() * 1e6);
                    if let Some(crossing) = land.space.cross(drive.point()) {
                        drive.physics.carry(&mut drive.car, &crossing);
                    }
                }
            }
            // What is longer was spent elsewhere.
            let mean = |all: &[f64]| {
                let own: Vec<_> = all.iter().filter(|it| **it < 1500.0).collect();
                own.iter().copied().sum::<f64>() / own.len() as f64
            };
            let middle = |all: &[f64]| {
                let mut all = all.to_vec();
                all.sort_by(f64::total_cmp);
                (all[all.len() / 2], all[all.len() - 1])
            };
            println!(
                "{:?}, boost {boost}: chart {:.1} us (median, most {:.1?}), space {:.1} us ({:.1?})",
                land.space,
                mean(&times[0]),
                middle(&times[0]),
                mean(&times[1]),
                middle(&times[1])
            );
        }
    }
}
