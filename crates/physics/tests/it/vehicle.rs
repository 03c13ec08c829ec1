//! What a driver notices of a vehicle on known ground: springs, driving, braking, steering, pushing.

use crate::common::{STEP_S, Soup, bumps, plain};
use antipode_physics::{
    PhysicsWorld, Vehicle, VehicleInput, VehicleMotion, VehiclePhysics, VehicleTuning,
};
use glam::{DQuat, DVec3, IVec3, Vec3};

pub(crate) struct Driver {
    pub world: PhysicsWorld,
    pub physics: VehiclePhysics,
    pub vehicle: Vehicle,
}

impl Driver {
    pub fn at(world: PhysicsWorld, place: DVec3) -> Self {
        let physics = VehiclePhysics::default();
        let vehicle = physics.vehicle(VehicleMotion {
            place,
            ..VehicleMotion::default()
        });
        Self {
            world,
            physics,
            vehicle,
        }
    }

    /// On a plain, at rest.
    fn rested() -> Self {
        let mut driver = Self::at(plain().charts_at(DVec3::ZERO), DVec3::Y * 0.3);
        driver.steps(120, VehicleInput::default());
        driver
    }

    pub fn step(&mut self, input: VehicleInput) {
        self.step_beside(Some(input), None);
    }

    pub fn step_beside(&mut self, input: Option<VehicleInput>, other: Option<&mut Vehicle>) {
        let mut all = vec![(&mut self.vehicle, input)];
        all.extend(other.map(|it| (it, Some(parked()))));
        self.physics.step(&self.world, None, &mut all, STEP_S);
    }

    pub fn set_motion(&mut self, motion: VehicleMotion) {
        self.physics.set_motion(&mut self.vehicle, motion);
    }

    pub fn steps(&mut self, count: usize, input: VehicleInput) {
        for _ in 0..count {
            self.step(input);
        }
    }

    pub fn motion(&self) -> VehicleMotion {
        self.vehicle.motion()
    }

    pub fn contacts(&self) -> usize {
        let wheels = self.vehicle.wheels();
        wheels.iter().filter(|wheel| wheel.contact).count()
    }
}

pub(crate) fn ahead() -> VehicleInput {
    VehicleInput {
        throttle: 1.0,
        ..VehicleInput::default()
    }
}

pub(crate) fn never(_: DVec3) -> bool {
    false
}

#[test]
fn at_rest_it_stands_on_four_wheels_with_its_springs_pushed_in() {
    let driver = Driver::rested();
    let motion = driver.motion();
    assert_eq!(driver.contacts(), 4);
    assert!(motion.velocity.length() < 0.01, "{motion:?}");
    assert!(motion.place.y.abs() < 0.02, "the tyres touch: {motion:?}");
    assert!(motion.up().y > 0.9999);
    let droop_m = driver.physics.tuning().droop_m;
    for wheel in driver.vehicle.wheels() {
        assert!((wheel.compression_m - droop_m).abs() < 0.02, "{wheel:?}");
        assert!((wheel.hub.y - 0.36).abs() < 0.02, "{wheel:?}");
    }
}

#[test]
fn a_drop_pushes_the_springs_in_and_they_swing_out() {
    let mut driver = Driver::at(plain().charts_at(DVec3::ZERO), DVec3::Y * 0.6);
    let (mut most_m, mut least_after_m) = (0.0f64, f64::MAX);
    for _ in 0..180 {
        driver.step(VehicleInput::default());
        let now_m = driver.vehicle.wheels()[0].compression_m;
        if now_m < most_m - 0.01 {
            least_after_m = least_after_m.min(now_m);
        }
        most_m = most_m.max(now_m);
    }
    let droop_m = driver.physics.tuning().droop_m;
    assert!(most_m > droop_m + 0.05, "{most_m}");
    assert!(least_after_m < droop_m - 0.005, "{least_after_m}");
    assert!(driver.motion().velocity.length() < 0.02);
}

#[test]
fn it_drives_straight_reaches_its_speed_and_sprint_doubles() {
    let after_s = |seconds: usize, boost: bool| {
        let mut driver = Driver::rested();
        driver.steps(60 * seconds, VehicleInput { boost, ..ahead() });
        driver.motion()
    };
    let slow = after_s(1, false);
    assert!((6.5..8.5).contains(&slow.speed_m_s()), "{slow:?}");
    // All four wheels pull, but the front ones have less load the harder they do.
    let ratio = after_s(1, true).speed_m_s() / slow.speed_m_s();
    assert!((1.5..2.1).contains(&ratio), "{ratio}");
    let fast = after_s(4, false);
    assert!((13.5..15.5).contains(&fast.speed_m_s()), "{fast:?}");
    assert!(fast.place.z.abs() < 0.05 && fast.up().y > 0.995);
    let hurried = after_s(3, true);
    assert!((24.0..31.0).contains(&hurried.speed_m_s()), "{hurried:?}");
}

#[test]
fn the_brake_stops_it_and_the_other_pedal_reverses() {
    let mut driver = Driver::rested();
    driver.steps(180, ahead());
    let (from, speed) = (driver.motion().place.x, driver.motion().speed_m_s());
    let brake = VehicleInput {
        brake: true,
        ..VehicleInput::default()
    };
    let mut steps = 0;
    while driver.motion().speed_m_s() > 0.1 {
        driver.step(brake);
        assert!(driver.vehicle.brakes());
        steps += 1;
        assert!(steps < 240, "{:?}", driver.motion());
    }
    let way_m = driver.motion().place.x - from;
    let wanted_m = speed * speed / (2.0 * driver.physics.tuning().brake_m_s2);
    assert!(way_m < 1.6 * wanted_m, "{way_m} {wanted_m}");
    driver.steps(
        120,
        VehicleInput {
            throttle: -1.0,
            ..VehicleInput::default()
        },
    );
    let back = driver.motion().speed_m_s();
    assert!((-7.5..-4.0).contains(&back), "{back}");
    assert!(!driver.vehicle.brakes());
}

#[test]
fn let_go_on_the_level_it_slows_down_by_itself_without_brake_lights() {
    let mut driver = Driver::rested();
    let rolling = VehicleMotion {
        velocity: DVec3::X * 14.0,
        ..driver.motion()
    };
    driver.set_motion(rolling);
    for _ in 0..300 {
        driver.step(VehicleInput::default());
        assert!(!driver.vehicle.brakes());
    }
    let motion = driver.motion();
    assert!(
        motion.speed_m_s() < 2.0 && motion.up().y > 0.995,
        "{motion:?}"
    );
}

#[test]
fn it_turns_to_the_side_that_is_steered_to_and_stays_on_its_wheels() {
    for (steer, side) in [(1.0, 1.0), (-1.0, -1.0)] {
        let mut driver = Driver::rested();
        driver.steps(120, ahead());
        driver.steps(90, VehicleInput { steer, ..ahead() });
        let motion = driver.motion();
        assert!(motion.place.z * side > 2.0, "{motion:?}");
        assert!(motion.ahead().z * side > 0.3, "{motion:?}");
        assert!(motion.up().y > 0.95, "{motion:?}");
    }
}

pub(crate) fn parked() -> VehicleInput {
    VehicleInput {
        parked: true,
        ..VehicleInput::default()
    }
}

#[test]
fn over_rough_ground_it_drives_on_and_never_falls_through() {
    let mut soup = Soup::default();
    soup.march(IVec3::new(-40, -5, -40), IVec3::new(40, 5, 40), bumps);
    let mut driver = Driver::at(soup.charts_at(DVec3::ZERO), DVec3::new(0.0, 2.0, 0.0));
    driver.steps(60, VehicleInput::default());
    let from = driver.motion().place;
    let (mut farthest_m, mut lowest) = (0.0f64, f64::MAX);
    for step in 0..1200 {
        // Round and round, so that it stays on the patch.
        let steer = if step % 400 < 100 { 0.3 } else { 1.0 };
        driver.step(VehicleInput { steer, ..ahead() });
        let at = driver.motion().place;
        farthest_m = farthest_m.max(at.distance(from));
        let middle = driver.motion().middle().as_vec3();
        lowest = lowest.min(f64::from(bumps(middle)));
    }
    assert!(farthest_m > 8.0, "{farthest_m}");
    assert!(lowest > 0.0, "its middle stays above the ground: {lowest}");
}

#[test]
fn however_fast_it_falls_it_does_not_pass_the_ground() {
    let mut driver = Driver::at(plain().charts_at(DVec3::ZERO), DVec3::Y * 30.0);
    driver.set_motion(VehicleMotion {
        place: DVec3::Y * 30.0,
        velocity: DVec3::NEG_Y * 55.0,
        turn: DQuat::from_rotation_z(0.5),
        ..VehicleMotion::default()
    });
    driver.step(VehicleInput::default());
    let mut jolt = 0.0f64;
    for _ in 0..300 {
        driver.step(VehicleInput::default());
        jolt = jolt.max(driver.vehicle.jolt_m_s());
        let middle = driver.motion().middle();
        assert!(middle.y > 0.2, "{middle}");
    }
    assert!(jolt > 8.0, "such a fall is felt: {jolt}");
}

#[test]
fn the_same_inputs_give_the_same_bits_and_far_from_the_origin_nearly_the_same() {
    let run = |origin: DVec3| {
        let mut soup = Soup::default();
        soup.field(-60, 60, |x, z| 0.4 * (0.5 * x).sin() * (0.4 * z).cos());
        let mut driver = Driver::at(soup.charts_at(origin), origin + DVec3::Y);
        for step in 0..300 {
            let steer = if step > 100 { 0.5 } else { 0.0 };
            driver.step(VehicleInput { steer, ..ahead() });
        }
        let motion = driver.motion();
        (motion.place - origin, motion.velocity)
    };
    let (here, again) = (run(DVec3::ZERO), run(DVec3::ZERO));
    assert_eq!(here, again);
    let far = run(DVec3::new(32e6, 0.0, -64e6));
    assert!(here.0.distance(far.0) < 1e-3, "{here:?} {far:?}");
}

#[test]
fn without_ground_it_is_held_where_it_is() {
    let mut driver = Driver::at(PhysicsWorld::new(), DVec3::Y * 5.0);
    for _ in 0..60 {
        driver.step_beside(None, None);
    }
    assert_eq!(driver.motion().place, DVec3::Y * 5.0);
    driver.steps(30, VehicleInput::default());
    assert!(driver.motion().place.y < 4.5);
}

#[test]
fn a_push_moves_a_sleeper_and_one_vehicle_pushes_another() {
    let mut driver = Driver::rested();
    driver.steps(180, parked());
    assert!(driver.vehicle.is_asleep());
    let at = DVec3::new(0.0, 0.8, -0.7);
    driver
        .physics
        .push(&mut driver.vehicle, at, DVec3::Z * 2700.0);
    assert!(driver.motion().velocity.z > 1.0, "{:?}", driver.motion());
    driver.steps(240, parked());
    let at = driver.motion().place;
    let mut other = driver.physics.vehicle(VehicleMotion {
        place: at + DVec3::new(8.0, 0.3, 0.0),
        ..VehicleMotion::default()
    });
    for _ in 0..240 {
        driver.step_beside(Some(ahead()), Some(&mut other));
    }
    let pushed = other.motion().place - at;
    assert!(pushed.x > 8.5, "{pushed}");
}

#[test]
fn what_characters_meet_is_its_body() {
    let driver = Driver::rested();
    let (physics, motion) = (&driver.physics, driver.motion());
    let whole = physics.whole(&motion);
    let meets = |y: f64| {
        let (from, to) = (DVec3::new(-5.0, y, 0.0), DVec3::new(5.0, y, 0.0));
        whole.meets(from, to, 0.06)
    };
    let share = meets(0.6).unwrap();
    assert!((share - 0.342).abs() < 0.02, "{share}");
    assert!(meets(1.7).is_none());
    let touches = |x: f64| whole.touches_capsule(DVec3::X * x, 1.8, 0.35, 0.1);
    assert!(touches(1.9).is_some_and(|(away, _)| away.x > 0.99));
    assert!(touches(2.1).is_none());
    let mut world = plain().charts_at(DVec3::ZERO);
    world.set_obstacles(vec![whole.obstacle()]);
    let ground = world.chart(motion.chart);
    assert!(
        ground
            .in_chart()
            .overlaps_capsule(DVec3::new(1.7, 0.01, 0.0), 1.8, 0.35)
    );
    assert!(
        !ground
            .in_chart()
            .overlaps_capsule(DVec3::new(2.1, 0.01, 0.0), 1.8, 0.35)
    );
    let mut walker = crate::common::Walker::at(ground, 5.0, 0.0, 0.0);
    walker.steps(180, crate::common::go(-1.0, 0.0));
    assert!((1.7..2.2).contains(&walker.feet().x), "{}", walker.feet());
}

#[test]
fn the_tuning_is_that_of_the_model() {
    let tuning = VehicleTuning::default();
    assert!((tuning.wheelbase_m() - 1.98).abs() < 1e-9);
    assert_eq!(Vec3::splat(0.36).x, tuning.wheel_radius_m as f32);
}
