//! A vehicle on slopes and ramps, on its side and on its roof: where it stays, rolls over, falls back and stands up.

use crate::common::{Soup, plain};
use crate::vehicle::{Driver, ahead, never, parked};
use antipode_physics::{VehicleInput, VehicleMotion};
use glam::{DQuat, DVec3};

/// On ground that rises by so much for each metre along x, turned by so many degrees, held by its brake for 3 s.
fn held_on_a_slope(rise: f32, degrees: f64, input: VehicleInput) -> Driver {
    let mut soup = Soup::default();
    soup.field(-32, 32, |x, _| rise * x);
    let mut driver = Driver::at(soup.charts_at(DVec3::ZERO), DVec3::Y * 0.6);
    let turn = DQuat::from_rotation_y(degrees.to_radians());
    let motion = driver.motion();
    driver.set_motion(VehicleMotion { turn, ..motion });
    driver.steps(180, input);
    driver
}

#[test]
fn parked_on_a_slope_it_stays_and_sleeps() {
    for (rise, degrees) in [(0.0, 0.0), (0.4, 0.0), (0.4, 90.0), (0.7, 0.0), (0.7, 60.0)] {
        let driver = held_on_a_slope(rise, degrees, parked());
        assert!(
            driver.vehicle.is_asleep(),
            "{rise} {degrees}: {:?}",
            driver.motion()
        );
    }
}

#[test]
fn who_sits_in_it_on_a_slope_without_a_foot_on_a_pedal_does_not_creep_down() {
    for degrees in [0.0, 45.0, 90.0, 180.0] {
        let mut driver = held_on_a_slope(0.4, degrees, VehicleInput::default());
        let before = driver.motion().place;
        driver.steps(1200, VehicleInput::default());
        let way_m = driver.motion().place.distance(before);
        assert!(way_m < 0.005, "{degrees}: {way_m} m in 20 s");
        assert!(!driver.vehicle.brakes());
    }
}

#[test]
fn two_parked_ones_that_touch_on_a_slope_or_lie_on_one_another_come_to_rest() {
    for rise in [0.0f32, 0.3, 0.6] {
        for up_m in [0.6, 1.9] {
            let mut driver = held_on_a_slope(rise, 90.0, parked());
            let beside = DVec3::new(1.5, 1.5 * f64::from(rise) + up_m, 0.6);
            let place = driver.motion().place + beside;
            let mut other = driver.physics.vehicle(VehicleMotion {
                place,
                ..VehicleMotion::default()
            });
            for _ in 0..600 {
                driver.step_beside(Some(parked()), Some(&mut other));
            }
            let both = [&driver.vehicle, &other];
            assert!(
                both.iter().all(|it| it.is_asleep()),
                "{rise} {up_m}: {both:?}"
            );
        }
    }
}

#[test]
fn on_its_roof_it_lies_and_is_set_upright_with_its_heading() {
    let mut driver = Driver::at(plain().charts_at(DVec3::ZERO), DVec3::Y * 2.2);
    let heading = 0.7f64;
    let turn = DQuat::from_rotation_y(-heading) * DQuat::from_rotation_x(2.9);
    driver.set_motion(VehicleMotion {
        place: DVec3::Y * 2.2,
        turn,
        ..VehicleMotion::default()
    });
    driver.steps(240, ahead());
    assert!(driver.motion().up().y < -0.3, "{:?}", driver.motion());
    assert_eq!(driver.contacts(), 0);
    let lies = driver.motion();
    let upright = driver
        .physics
        .upright(&lies, &driver.world, &never)
        .unwrap();
    driver.set_motion(upright);
    driver.steps(120, VehicleInput::default());
    let stands = driver.motion();
    assert!(
        stands.up().y > 0.999 && driver.contacts() == 4,
        "{stands:?}"
    );
    let level = |motion: &VehicleMotion| motion.ahead().with_y(0.0).normalize();
    assert!(level(&lies).dot(level(&stands)) > 0.999);
    assert!((stands.place - lies.place).with_y(0.0).length() < 1.0);
}

/// How upright it is at worst over a ramp under its right-hand wheels, as high and as steep (rise for each metre).
fn least_up_over_a_ramp(height_m: f32, steep: f32, boost: bool) -> f64 {
    let mut soup = Soup::default();
    soup.field(-64, 64, |x, z| {
        if z > 0.0 {
            (steep * x).clamp(0.0, height_m)
        } else {
            0.0
        }
    });
    let mut driver = Driver::at(soup.charts_at(DVec3::ZERO), DVec3::new(-40.0, 0.3, 0.0));
    let mut least_up = 1.0f64;
    for _ in 0..360 {
        driver.step(VehicleInput { boost, ..ahead() });
        least_up = least_up.min(driver.motion().up().y);
    }
    least_up
}

#[test]
fn a_ramp_under_one_side_rolls_it_over_at_a_sprint_and_not_at_its_usual_speed() {
    for steep in [0.35, 0.7] {
        for height_m in [1.0, 1.5, 2.0, 2.5, 3.0, 3.5] {
            let hurried = least_up_over_a_ramp(height_m, steep, true);
            assert!(hurried < 0.0, "{height_m} m, {steep}: {hurried}");
            let usual = least_up_over_a_ramp(height_m, steep, false);
            assert!(usual > 0.4, "{height_m} m, {steep}: {usual}");
        }
        let kerb = least_up_over_a_ramp(0.25, steep, true);
        assert!(kerb > 0.9, "{kerb}");
    }
}

/// How far from upright it is 5 s after it was let go at that lean on a plain with somebody in it, in degrees.
fn ends_leaning_deg(lean_deg: f64) -> f64 {
    let lean = lean_deg.to_radians();
    let mut driver = Driver::at(plain().charts_at(DVec3::ZERO), DVec3::Y);
    let motion = VehicleMotion {
        place: DVec3::Y * (0.75 * lean.sin() + 0.02),
        turn: DQuat::from_rotation_x(lean),
        ..VehicleMotion::default()
    };
    driver.set_motion(motion);
    driver.steps(300, VehicleInput::default());
    driver.motion().up().y.acos().to_degrees()
}

#[test]
fn what_leans_falls_back_on_its_wheels_and_what_lies_on_its_side_does_not_get_up() {
    for lean_deg in [30.0, 45.0, 60.0] {
        let ends = ends_leaning_deg(lean_deg);
        assert!(ends < 2.0, "{lean_deg}: {ends}");
    }
    for lean_deg in [75.0, 82.0, 90.0] {
        let ends = ends_leaning_deg(lean_deg);
        assert!(ends > 60.0, "{lean_deg}: {ends}");
    }
}
