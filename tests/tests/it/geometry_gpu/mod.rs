//! `shaders/geometry.wgsl` on a real adapter, against 80-digit numbers and the f64 port.
//!
//! Without an adapter the test says so and passes, unless `ANTIPODE_REQUIRE_GPU=1`.

mod answers;
mod frames;
mod functions;
mod gpu;
mod kernels;
mod probes;
mod tables;

use antipode_geometry::{ChartPoint, FAR_LIMIT_RADII, Geometry, Projection, strategy};
use glam::{DVec3, Vec4Swizzles};

use self::answers::{Answer, answers};
use self::probes::{Case, Numbers, Probe, case, dense, golden};

/// The greatest errors of a run.
#[derive(Default, Debug)]
struct Worst {
    angle_rad: f64,
    distance: f64,
    depth: f64,
    normal_rad: f64,
}

/// Compares within the bounds that f32 inputs allow: the angle of sight everywhere, distances
/// relative to the distance, and on the sphere both relative to the radius.
fn compare(probes: &[Probe], answers: &[Answer]) -> [Worst; 3] {
    let mut worst = [Worst::default(), Worst::default(), Worst::default()];
    for (probe, answer) in probes.iter().zip(answers) {
        let geometry = probe.space.geometry();
        let ours = answer.view.as_dvec4();
        assert!(ours.is_finite() && answer.normal.is_finite() && answer.distance.is_finite());
        let worst = &mut worst[geometry as usize];
        let (a, b) = (ours.xyz(), probe.view.truncate());
        // A direction on the sphere has the error of the point, which is a part of the radius.
        let sphere = geometry == Geometry::Spherical;
        let scale = if sphere {
            probe.space.radius_m()
        } else {
            b.length()
        };
        let angle = if sphere {
            (a - b).length() / scale
        } else {
            (a.normalize() - b.normalize()).length()
        };
        worst.angle_rad = worst.angle_rad.max(angle);
        let span = if sphere { scale } else { probe.distance };
        let distance = (f64::from(answer.distance) - probe.distance).abs() / span;
        worst.distance = worst.distance.max(distance);
        let depth_scale = if sphere { scale } else { probe.clip.z };
        worst.depth = worst
            .depth
            .max((f64::from(answer.clip.z) - probe.clip.z).abs() / depth_scale);
        let normal = answer.normal.as_dvec3();
        assert!((normal.length() - 1.0).abs() < 1e-6);
        let turned = (normal - probe.normal).length() * probe.normal_condition();
        worst.normal_rad = worst.normal_rad.max(turned);
        let w = f64::from(answer.clip.w);
        assert_eq!(w, -ours.z, "clip w is the distance ahead");
    }
    worst
}

fn check(probes: &[Probe]) {
    let cases: Vec<Case> = probes.iter().map(|probe| probe.case).collect();
    let Some(answers) = answers(&cases) else {
        return;
    };
    let worst = compare(probes, &answers);
    for (geometry, worst) in Geometry::ALL.into_iter().zip(worst) {
        eprintln!("{geometry}: {worst:?}");
        assert!(worst.angle_rad < 5e-7, "{geometry}: {worst:?}");
        assert!(worst.distance < 2e-6, "{geometry}: {worst:?}");
        assert!(worst.depth < 1e-5, "{geometry}: {worst:?}");
        assert!(worst.normal_rad < 1e-6, "{geometry}: {worst:?}");
    }
}

#[test]
fn the_shader_agrees_with_eighty_digits() {
    check(&golden());
}

#[test]
fn the_shader_agrees_with_the_f64_port() {
    check(&dense(30_000));
}

#[test]
fn the_shader_is_finite_at_every_magnitude() {
    let mut rng = Numbers(11);
    let projection = Projection::new(1.2, 1.6, 0.05);
    let mut cases = Vec::new();
    let mut far = Vec::new();
    for i in 0..4000 {
        let space = strategy(Geometry::Hyperbolic, if i % 2 == 0 { 20.0 } else { 1024.0 });
        let mut eye = rng.eye(DVec3::ZERO);
        if i % 5 == 0 {
            eye.dial = 0.0;
        }
        let p = rng.direction() * 10.0_f64.powf(rng.between(-37.0, 37.0));
        let p = if i % 7 == 0 { DVec3::ZERO } else { p };
        far.push(p.length() > (FAR_LIMIT_RADII + 2.0) * space.radius_m());
        cases.push(case(
            space.as_ref(),
            &eye,
            &projection,
            ChartPoint::a(p),
            rng.direction(),
        ));
    }
    let Some(answers) = answers(&cases) else {
        return;
    };
    for ((answer, case), far) in answers.iter().zip(&cases).zip(far) {
        let finite = answer.view.is_finite() && answer.clip.is_finite();
        assert!(finite, "{} {} {}", case.p, answer.view, answer.clip);
        assert!(
            answer.normal.is_finite() && answer.distance.is_finite(),
            "{}",
            case.p
        );
        assert!((answer.normal.length() - 1.0).abs() < 1e-5, "{}", case.p);
        assert!(!far || answer.clip.z < 1e-8, "{} {}", case.p, answer.clip);
    }
}
