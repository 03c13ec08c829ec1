//! A vehicle driven over the equator of a closed world at full speed: nothing that its driver feels changes.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::common::{STEP_S, Soup};
use antipode_geometry::{BodyFrame, ChartId, ChartPoint, ChunkCoord, Geometry, Strategy, strategy};
use antipode_physics::{PhysicsWorld, VehicleInput, VehicleMotion, VehiclePhysics};
use glam::{DVec3, IVec3, Vec3};

/// The ground of each chart reaches so far past the rim, as that of the game does, in metres.
const BEYOND_M: f64 = 8.0;
/// Only this much of a chart is made, from the rim inwards, in metres.
const INWARDS_M: f64 = 32.0;

/// A world whose ground has the same height at one place of the space whichever chart it is seen from.
fn world(space: &dyn Strategy, waves_m: f64) -> PhysicsWorld {
    let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap();
    let most = (rim_m + BEYOND_M) as i32 + 1;
    let mut world = PhysicsWorld::new();
    for chart in [ChartId::FIRST, ChartId::SECOND] {
        let height = |x: i32, z: i32| {
            let at = DVec3::new(f64::from(x), 0.0, f64::from(z));
            let n = space.noise_point(ChartPoint::new(chart, at));
            let wave = (0.35 * n.x).sin() + (0.31 * n.y).cos() + (0.4 * n.z).sin();
            Vec3::new(x as f32, (10.0 + waves_m * wave) as f32, z as f32)
        };
        let mut soup = Soup::default();
        for x in -most..most {
            for z in -most..most {
                let far_m = f64::from(x).hypot(f64::from(z));
                if far_m < rim_m - INWARDS_M || far_m > rim_m + BEYOND_M {
                    continue;
                }
                let corners = [
                    height(x, z),
                    height(x + 1, z),
                    height(x + 1, z + 1),
                    height(x, z + 1),
                ];
                soup.quad(corners, Vec3::Y);
            }
        }
        let coord = ChunkCoord::new(chart, IVec3::ZERO);
        let ground = world.chart_mut(chart);
        ground.set_terrain(coord, DVec3::ZERO, Some(soup.build()));
    }
    world
}

/// What is felt in a step.
#[derive(Clone, Copy, Debug)]
struct Felt {
    speed_m_s: f64,
    /// The way it looks, turned back into the first chart.
    ahead: DVec3,
    contacts: [bool; 4],
}

struct Run {
    /// The last steps before the crossing, and the first ones after it.
    before: Vec<Felt>,
    after: Vec<Felt>,
}

/// Drives over the equator at an azimuth, turned aside by an angle.
fn drive(
    space: &Arc<dyn Strategy>,
    world: &PhysicsWorld,
    azimuth: f64,
    aside: f64,
    boost: bool,
) -> Run {
    let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap();
    let heading = azimuth + aside;
    let way = DVec3::new(heading.cos(), 0.0, heading.sin());
    let out = DVec3::new(azimuth.cos(), 0.0, azimuth.sin());
    let mut physics = VehiclePhysics::default().in_space(space);
    let never = |_: DVec3| false;
    let at = out * (rim_m - 14.0) - way * 3.0 + DVec3::Y * 10.0;
    let free = physics.upright_at(world, ChartPoint::a(at), way, &never);
    let free = free.unwrap();
    let mut vehicle = physics.vehicle(free);
    for _ in 0..90 {
        let mut all = [(&mut vehicle, Some(VehicleInput::default()))];
        physics.step(world, None, &mut all, STEP_S);
    }
    let speed_m_s = if boost { 28.0 } else { 14.5 };
    let rested = vehicle.motion();
    physics.set_motion(
        &mut vehicle,
        VehicleMotion {
            velocity: rested.ahead() * speed_m_s,
            ..rested
        },
    );
    let input = VehicleInput {
        throttle: 1.0,
        boost,
        ..VehicleInput::default()
    };
    let mut run = Run {
        before: Vec::new(),
        after: Vec::new(),
    };
    let mut back = 0.0;
    while run.after.len() < 12 {
        let from = vehicle.motion().point();
        physics.step(world, None, &mut [(&mut vehicle, Some(input))], STEP_S);
        let motion = vehicle.motion();
        let gone = BodyFrame::way(&**space, from, motion.point());
        // Frames turn along a way that is straight, which nobody feels.
        back -= BodyFrame::step(&**space, from, gone).turn_rad;
        let felt = Felt {
            speed_m_s: motion.velocity.length(),
            ahead: glam::DQuat::from_rotation_y(back) * motion.ahead(),
            contacts: vehicle.wheels().map(|wheel| wheel.contact),
        };
        if motion.chart == ChartId::SECOND {
            run.after.push(felt);
            continue;
        }
        run.before.push(felt);
        assert!(run.before.len() < 300, "it does not get there: {motion:?}");
        if let Some(crossing) = space.cross(motion.point()) {
            physics.carry(&mut vehicle, &crossing);
            back -= crossing.turn_rad;
        }
    }
    run
}

/// The largest change from one step to the next of speed, as a share, and of the way it looks, in radians.
fn changes(felt: &[Felt]) -> (f64, f64) {
    felt.windows(2).fold((0.0, 0.0), |(speed, angle), w| {
        let (a, b) = (w[0], w[1]);
        let change = (b.speed_m_s / a.speed_m_s - 1.0).abs();
        let turned = a.ahead.dot(b.ahead).clamp(-1.0, 1.0).acos();
        (f64::max(speed, change), f64::max(angle, turned))
    })
}

fn many(mut each: impl FnMut(f64, f64, bool)) {
    for number in 0..16 {
        let azimuth = TAU * f64::from(number) / 16.0 + 0.05;
        let aside = [0.0, 0.5, -0.8, 1.0][number as usize % 4];
        each(azimuth, aside, number % 3 == 2);
    }
}

#[test]
fn on_even_ground_neither_speed_nor_heading_change_and_no_wheel_leaves_the_ground() {
    for radius_m in [32.0, 64.0] {
        let space = strategy(Geometry::Spherical, radius_m);
        let world = world(&*space, 0.0);
        many(|azimuth, aside, boost| {
            let run = drive(&space, &world, azimuth, aside, boost);
            let about = [&run.before[run.before.len() - 2..], &run.after[..4]].concat();
            let (speed, angle) = changes(&about);
            let told = format!("R {radius_m} at {azimuth:.2} aside {aside} boost {boost}");
            assert!(speed < 0.01, "{told}: speed changes by {speed}");
            assert!(angle < 0.01, "{told}: heading changes by {angle} rad");
            let all = about.iter().all(|felt| felt.contacts == [true; 4]);
            assert!(all, "{told}: {about:?}");
        });
    }
}

#[test]
fn on_waves_what_has_contact_keeps_it_and_nothing_changes_by_a_hundredth_more_than_elsewhere() {
    let space = strategy(Geometry::Spherical, 32.0);
    let world = world(&*space, 0.08);
    let mut kept = 0;
    many(|azimuth, aside, boost| {
        let run = drive(&space, &world, azimuth, aside, boost);
        let (last, first) = (run.before[run.before.len() - 1], run.after[0]);
        let told = format!("at {azimuth:.2} aside {aside} boost {boost}");
        for (before, after) in last.contacts.iter().zip(first.contacts) {
            assert!(!before || after, "{told}: {last:?} {first:?}");
            kept += usize::from(after);
        }
        let usual = changes(&run.before[run.before.len() - 12..]);
        let here = changes(&[last, first]);
        assert!(here.0 < usual.0 + 0.01, "{told}: speed {here:?} {usual:?}");
        assert!(
            here.1 < usual.1 + 0.01,
            "{told}: heading {here:?} {usual:?}"
        );
    });
}
