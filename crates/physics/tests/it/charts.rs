//! Vehicles of several charts: each collides in its own.

use antipode_geometry::{ChartId, ChartPoint, Crossing};
use antipode_physics::{PhysicsWorld, Vehicle, VehicleInput, VehicleMotion, VehiclePhysics};
use glam::{DQuat, DVec3};

use crate::common::{STEP_S, plain};

/// Level ground in charts 0 and 7.
fn two_charts() -> PhysicsWorld {
    let mut world = plain().charts_at(DVec3::ZERO);
    *world.chart_mut(ChartId::new(7)) = plain().world();
    world
}

#[test]
fn vehicles_at_one_place_of_two_charts_do_not_meet_until_one_is_carried() {
    let world = two_charts();
    let parked = VehicleInput {
        parked: true,
        ..VehicleInput::default()
    };
    let ahead = VehicleInput {
        throttle: 1.0,
        ..VehicleInput::default()
    };
    let mut physics = VehiclePhysics::default();
    let place = |chart: u128, x: f64| {
        let point = ChartPoint::new(ChartId::new(chart), DVec3::new(x, 0.1, 0.0));
        VehicleMotion::at(point, DQuat::IDENTITY)
    };
    let mut still = physics.vehicle(place(7, 8.0));
    let mut driven = physics.vehicle(place(0, 0.0));
    let step = |still: &mut Vehicle, driven: &mut Vehicle, physics: &mut VehiclePhysics| {
        let mut all = [(still, Some(parked)), (driven, Some(ahead))];
        physics.step(&world, None, &mut all, STEP_S);
    };
    for _ in 0..150 {
        step(&mut still, &mut driven, &mut physics);
    }
    assert!(driven.motion().place.x > 12.0, "{:?}", driven.motion());
    assert!((still.motion().place.x - 8.0).abs() < 0.1);
    let before = driven.motion();
    // A quarter turn takes +x to -z.
    let crossing = Crossing {
        point: ChartPoint::new(ChartId::new(7), DVec3::new(8.0, before.place.y, 12.0)),
        turn_rad: std::f64::consts::FRAC_PI_2,
    };
    physics.carry(&mut driven, &crossing);
    let after = driven.motion();
    assert_eq!(after.point(), crossing.point);
    assert!((after.velocity.z + before.velocity.x).abs() < 1e-9);
    let contacts = driven.wheels().map(|wheel| wheel.contact);
    step(&mut still, &mut driven, &mut physics);
    let speeds = [&before, &driven.motion()].map(|motion| motion.velocity.length());
    assert!((speeds[0] - speeds[1]).abs() < 0.2, "{speeds:?}");
    assert_eq!(driven.wheels().map(|wheel| wheel.contact), contacts);
    for _ in 0..90 {
        step(&mut still, &mut driven, &mut physics);
    }
    let pushed = still.motion().place;
    assert!(
        pushed.z < -1.0,
        "who comes into the chart meets it: {pushed}"
    );
}
