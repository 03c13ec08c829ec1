//! What a normal costs and how wrong the picture's brightness gets: the exact inverse transpose, the normal carried
//! like a direction, and the four-vector that is normalised as if space were flat.

use antipode_geometry::kernel::{exponential, sphere};
use glam::{DVec3, Vec3, Vec4};

use crate::random::Numbers;
use crate::speed::pareto::{Contest, Group};
use crate::speed::port::BATCH;
use crate::{Effort, naive};

/// Towards the light, in the chart's frame.
const LIGHT: Vec3 = Vec3::new(0.48, 0.8, 0.36);
/// Farthest points, in radii; on the sphere nearly to the equator.
const FAR: f64 = 3.0;
const FAR_SPHERE: f64 = 1.5;

/// What the error is; it has no unit.
const ERROR: (&str, &str) = ("worst error of N.L", "");

/// A place in radii from the chart's centre and a unit normal there.
#[derive(Clone, Copy, Debug)]
struct Input {
    at: Vec3,
    normal: Vec3,
}

fn inputs(seed: u64, far: f64, place: impl Fn(&mut Numbers, f64) -> DVec3) -> Vec<Input> {
    let mut numbers = Numbers::new(seed);
    (0..BATCH)
        .map(|_| {
            let away = numbers.between(1e-3, far);
            let at = place(&mut numbers, away).as_vec3();
            Input {
                at,
                normal: numbers.direction().as_vec3(),
            }
        })
        .collect()
}

/// The exponential chart of hyperbolic space, `n/stretch + p bend`, in doubles.
fn exact(input: &Input) -> DVec3 {
    let (p, n) = (input.at.as_dvec3(), input.normal.as_dvec3());
    let d = p.length();
    let along = p * (n.dot(p) / (d * d));
    (along + (n - along) * (d / d.sinh())).normalize()
}

fn normal_exponential(input: &Input) -> Vec3 {
    exponential::normal(-1.0, input.at.to_array(), input.normal.to_array()).into()
}

fn normal_exponential_f64(input: &Input) -> DVec3 {
    let (at, normal) = (input.at.as_dvec3(), input.normal.as_dvec3());
    exponential::normal(-1.0, at.to_array(), normal.to_array()).into()
}

fn normal_sphere_f64(input: &Input) -> DVec3 {
    let (at, normal) = (input.at.as_dvec3(), input.normal.as_dvec3());
    sphere::normal(at.to_array(), normal.to_array()).into()
}

fn normal_sphere(input: &Input) -> Vec3 {
    sphere::normal(input.at.to_array(), input.normal.to_array()).into()
}

/// The frame's four-vector of a direction, carried out from the centre.
fn carried(at: Vec3, v: Vec3) -> Vec4 {
    exponential::direction(-1.0, at.to_array(), v.to_array()).into()
}

/// Brightness of the hyperbolic exponential chart, which the raised map is.
pub fn hyperbolic_group(effort: Effort) -> Group {
    let inputs = inputs(21, FAR, |numbers, away| numbers.direction() * away);
    let error = |i: &Input, got: &f32| (f64::from(*got) - exact(i).dot(LIGHT.as_dvec3())).abs();
    let rivals = Contest::new(&inputs, error)
        .with("exact: inverse transpose, series, f32", "shaders", |i| {
            normal_exponential(i).dot(LIGHT)
        })
        .with("exact, f64", "processor", |i| {
            in_double(normal_exponential_f64(i))
        })
        .with("carried like a direction", "", turned)
        .with("exact four-vector, flat length", "", |i| {
            let n = carried(i.at, normal_exponential(i));
            naive::inner(-1.0, naive::four_normal(n), carried(i.at, LIGHT))
        })
        .with("exact four-vector, own length", "", |i| {
            let n = carried(i.at, normal_exponential(i));
            let light = carried(i.at, LIGHT);
            let inner = |a, b| naive::inner(-1.0, a, b);
            inner(n, light) / (inner(n, n) * inner(light, light)).sqrt()
        });
    let title = "Brightness of one vertex in hyperbolic space, up to 3 radii away";
    rivals.race("normal-raised", title, ERROR, effort)
}

/// The cylindrical chart of the sphere in doubles.
fn exact_sphere(input: &Input) -> DVec3 {
    let (p, n) = (input.at.as_dvec3(), input.normal.as_dvec3());
    let r = p.x.hypot(p.z);
    let outward = DVec3::new(p.x / r, 0.0, p.z / r);
    let along = outward * n.dot(outward);
    let across = DVec3::new(n.x, 0.0, n.z) - along;
    let sinc = r.sin() / r;
    (along * sinc + across + DVec3::Y * (n.y * p.y.cos() * sinc)).normalize()
}

/// Brightness on the sphere.
pub fn sphere_group(effort: Effort) -> Group {
    let inputs = inputs(22, FAR_SPHERE, |numbers, away| {
        let turn = numbers.turn() * away;
        DVec3::new(turn.x, numbers.between(0.15, 0.5), turn.y)
    });
    let error =
        |i: &Input, got: &f32| (f64::from(*got) - exact_sphere(i).dot(LIGHT.as_dvec3())).abs();
    let rivals = Contest::new(&inputs, error)
        .with("exact: inverse transpose, series, f32", "shaders", |i| {
            normal_sphere(i).dot(LIGHT)
        })
        .with("exact, f64", "processor", |i| {
            in_double(normal_sphere_f64(i))
        })
        .with("carried like a direction", "", turned);
    let title = "Brightness of one vertex on the sphere, up to 1.5 radii from the pole";
    rivals.race("normal-sphere", title, ERROR, effort)
}

/// The brightness of an exact normal in doubles.
fn in_double(normal: DVec3) -> f32 {
    normal.dot(LIGHT.as_dvec3()) as f32
}

/// That of the chart's normal as it is, which is what carrying it out like a direction comes to.
fn turned(input: &Input) -> f32 {
    input.normal.normalize().dot(LIGHT)
}
