//! Matrices that move a camera in the space: how they are made, and whether they are made orthonormal again after
//! each step.

use antipode_geometry::kernel::translation::translation;
use glam::{Mat4, Vec3, Vec4};

use crate::accuracy::off_orthogonal;
use crate::random::Numbers;
use crate::speed::pareto::{Contest, Group, Rival};
use crate::speed::port::BATCH;
use crate::{Effort, naive};

/// Moves closer to the antipode than this are not asked for, in radii.
const LEAST: f64 = 1e-5;
/// Farthest move in hyperbolic space, in radii.
const FAR: f64 = 2.0;

/// The translation along v that takes the origin to q = (v across, w), with `bend` = (cosS - 1)/t^2.
fn assembled(sign: f32, v: Vec3, across: f32, w: f32, bend: f32) -> Mat4 {
    let x = |axis: Vec3, along: f32| (axis + v * (bend * along)).extend(-sign * across * along);
    Mat4::from_cols(
        x(Vec3::X, v.x),
        x(Vec3::Y, v.y),
        x(Vec3::Z, v.z),
        (v * across).extend(w),
    )
}

/// The textbook's: from the point alone, by 1/(1 + w), with the library's functions.
fn textbook(sign: f32, v: Vec3) -> Mat4 {
    naive::translation(sign, naive::exponential(sign, v))
}

/// From half the angle, by series: nothing is divided by.
fn half_angle(sign: f32, v: Vec3) -> Mat4 {
    Mat4::from_cols_array_2d(&translation(sign, v.to_array()))
}

/// From half the angle with the library's functions.
fn half_angle_library(sign: f32, v: Vec3) -> Mat4 {
    let t = v.length();
    let sine = |t: f32| if sign > 0.0 { t.sin() } else { t.sinh() };
    let w = if sign > 0.0 { t.cos() } else { t.cosh() };
    let half = sine(0.5 * t) / (0.5 * t);
    assembled(sign, v, sine(t) / t, w, -0.5 * sign * half * half)
}

/// One translation, anywhere up to next to the antipode.
pub fn translation_groups(effort: Effort) -> [Group; 2] {
    let one = |id, title, sign: f32, inputs: Vec<Vec3>| {
        let error = |_: &Vec3, got: &Mat4| off_orthogonal(f64::from(sign), *got);
        let rivals = Contest::new(&inputs, error)
            .with("textbook: by 1/(1 + w), library, f32", "", |v| {
                textbook(sign, *v)
            })
            .with("from half the angle, library, f32", "", |v| {
                half_angle_library(sign, *v)
            })
            .with("from half the angle, series, f32", "", |v| {
                half_angle(sign, *v)
            });
        rivals.race(id, title, ("off orthogonal", ""), effort)
    };
    let mut numbers = Numbers::new(51);
    let sphere = (0..BATCH).map(|_| {
        let near_far_side = std::f64::consts::PI - numbers.magnitude(LEAST, 3.0);
        (numbers.direction() * near_far_side).as_vec3()
    });
    let sphere = sphere.collect();
    let hyperbolic = (0..BATCH)
        .map(|_| (numbers.direction() * numbers.magnitude(LEAST, FAR)).as_vec3())
        .collect();
    [
        one(
            "move-sphere",
            "Translation matrix on the sphere, to 1e-5 radii from the antipode",
            1.0,
            sphere,
        ),
        one(
            "move-hyperbolic",
            "Translation matrix in hyperbolic space, up to 2 radii",
            -1.0,
            hyperbolic,
        ),
    ]
}

/// Orthonormal again, the last column first.
fn orthonormal(sign: f32, m: Mat4) -> Mat4 {
    let inner = |a: Vec4, b: Vec4| naive::inner(sign, a, b);
    let w = m.w_axis / (sign * inner(m.w_axis, m.w_axis)).sqrt();
    let clear = |v: Vec4, unit: Vec4, square: f32| v - unit * (square * inner(v, unit));
    let unit = |v: Vec4| v / inner(v, v).sqrt();
    let x = unit(clear(m.x_axis, w, sign));
    let y = unit(clear(clear(m.y_axis, w, sign), x, 1.0));
    let z = unit(clear(clear(clear(m.z_axis, w, sign), x, 1.0), y, 1.0));
    Mat4::from_cols(x, y, z, w)
}

/// A small square, walked round and round: the camera stays near, whatever the curvature.
fn steps(sign: f32) -> Vec<Mat4> {
    let (ahead, aside) = (Vec3::new(0.05, 0.0, 0.01), Vec3::new(-0.01, 0.02, 0.05));
    [ahead, aside, -ahead, -aside]
        .map(|v| half_angle(sign, v))
        .into()
}

fn walked(steps: &[Mat4], count: usize, renew: impl Fn(Mat4) -> Mat4) -> Mat4 {
    (0..count).fold(Mat4::IDENTITY, |m, i| renew(m * steps[i % steps.len()]))
}

/// Many moves, one after the other.
pub fn walk_groups(effort: Effort) -> [Group; 2] {
    let count = effort.count(100_000);
    let one = |id, title: String, sign: f32| {
        let steps = steps(sign);
        let own = &steps;
        let end = |renew: &dyn Fn(Mat4) -> Mat4| {
            off_orthogonal(f64::from(sign), walked(own, count, renew))
        };
        let batch = |renew: fn(f32, Mat4) -> Mat4| -> Box<dyn FnMut()> {
            let own = steps.clone();
            Box::new(move || {
                std::hint::black_box(walked(&own, BATCH, |m| renew(sign, m)));
            })
        };
        let rivals = vec![
            Rival::of(
                "never made orthonormal",
                "",
                &[end(&|m| m)],
                batch(|_, m| m),
            ),
            Rival::of(
                "made orthonormal each step",
                "",
                &[end(&|m| orthonormal(sign, m))],
                batch(orthonormal),
            ),
        ];
        Group::race(id, &title, ("off orthogonal", ""), BATCH, rivals, effort)
    };
    [
        one(
            "walk-sphere",
            format!("One of {count} camera moves on the sphere, f32"),
            1.0,
        ),
        one(
            "walk-hyperbolic",
            format!("One of {count} camera moves in hyperbolic space, f32"),
            -1.0,
        ),
    ]
}
