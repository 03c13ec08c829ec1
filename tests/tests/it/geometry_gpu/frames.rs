//! `frame_vector` against the derivative of the f64 port: the image of the unit normal of a surface.

use antipode_geometry::{
    ChartId, ChartPoint, Eye, Geometry, HyperbolicMap, Projection, Strategy, picture, strategy,
};
use glam::{DMat3, DVec3, DVec4};

use super::answers::answers;
use super::probes::{Numbers, case};

/// How far apart the points of a difference are, metres.
const STEP_M: f64 = 1e-4;

/// The model's inner product of two vectors in view coordinates without unit.
fn product(sign: f64, a: DVec4, b: DVec4) -> f64 {
    a.truncate().dot(b.truncate()) + sign * a.w * b.w
}

/// The unit vector of the model's tangent space on which a covector of the chart is largest: with the derivative J of
/// the port and the metric g = J^T J, it is J g^-1 n over its own length.
fn exact(
    space: &dyn Strategy,
    eye: &Eye,
    point: ChartPoint,
    n: DVec3,
    radius_m: f64,
    sign: f64,
) -> DVec4 {
    let at = |by: DVec3| {
        let view = space.view_point(eye, point.moved(by));
        DVec4::from((view.truncate() / radius_m, view.w))
    };
    let columns = [DVec3::X, DVec3::Y, DVec3::Z]
        .map(|axis| (at(axis * STEP_M) - at(-axis * STEP_M)) / (2.0 * STEP_M));
    let g = |i: usize, j: usize| product(sign, columns[i], columns[j]);
    let metric = DMat3::from_cols_array(&[
        g(0, 0),
        g(0, 1),
        g(0, 2),
        g(1, 0),
        g(1, 1),
        g(1, 2),
        g(2, 0),
        g(2, 1),
        g(2, 2),
    ]);
    let raised = metric.inverse() * n;
    let vector = columns[0] * raised.x + columns[1] * raised.y + columns[2] * raised.z;
    vector / product(sign, vector, vector).sqrt()
}

#[test]
fn frame_vectors_are_what_the_port_makes_of_unit_normals() {
    let mut rng = Numbers(23);
    let projection = Projection::new(1.2, 1.6, 0.05);
    let (mut cases, mut wanted) = (Vec::new(), Vec::new());
    for i in 0..4000 {
        let kind = i % 4;
        let (space, sign) = match kind {
            0 => (strategy(Geometry::Hyperbolic, 20.0), -1.0),
            1 => (strategy(Geometry::Spherical, 32.0), 1.0),
            2 => (
                picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Horizon, false),
                -1.0,
            ),
            _ => (strategy(Geometry::Euclidean, 0.0), 0.0),
        };
        let mut eye = rng.eye(DVec3::new(0.0, 12.0, 0.0));
        eye.dial = rng.between(2.0, 20.0);
        let away = rng.direction() * rng.between(0.5, 30.0);
        let chart = if kind == 1 && i % 8 < 4 {
            ChartId::SECOND
        } else {
            ChartId::FIRST
        };
        let pos = if kind == 1 {
            away.with_y(rng.between(4.0, 16.0))
        } else {
            eye.point.pos + away
        };
        let point = ChartPoint::new(chart, pos.as_vec3().as_dvec3());
        let n = rng.direction().as_vec3().as_dvec3();
        let radius_m = space.radius_at_m(&eye);
        let radius_m = if radius_m.is_finite() { radius_m } else { 1.0 };
        wanted.push((
            exact(space.as_ref(), &eye, point, n, radius_m, sign),
            kind,
            sign,
        ));
        cases.push(case(space.as_ref(), &eye, &projection, point, n));
    }
    let Some(answers) = answers(&cases) else {
        return;
    };
    let mut worst = [0.0_f64; 4];
    for ((answer, (exact, kind, sign)), case) in answers.iter().zip(wanted).zip(&cases) {
        let ours = answer.frame.as_dvec4();
        // A difference that is seen from where the vector stands: the model's own length of it, relative to the size
        // of its coordinates, which far from the eye are large and cancel.
        let off = (ours - exact).length() / exact.length().max(1.0);
        assert!(
            off < 1e-3,
            "kind {kind}, {sign}: {} {} {ours} {exact}",
            case.p,
            case.n
        );
        worst[kind as usize] = worst[kind as usize].max(off);
    }
    // On the horizon map the sheet below the eye is the origin: going down to it and back up cancels.
    let bars = [2e-6, 1e-6, 2e-4, 1e-6];
    assert!(
        worst.iter().zip(bars).all(|(off, bar)| *off < bar),
        "{worst:?}"
    );
}
