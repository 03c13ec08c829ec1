//! The textbook formulas, in single precision with the system's own functions: the baseline.
//!
//! They are those of the theses that the game goes back to, and of most textbooks: hyperboloid
//! coordinates of the camera, inverse cosines of inner products, translations with 1/(1 + w),
//! normals carried like directions. Nothing but the laboratory uses them.

use glam::{Mat4, Vec3, Vec4};

/// The inner product of the model: `sign` is -1 for hyperbolic, 1 for spherical space.
pub fn inner(sign: f32, a: Vec4, b: Vec4) -> f32 {
    a.truncate().dot(b.truncate()) + sign * a.w * b.w
}

/// The exponential chart, q in radii, without a guard at 0.
pub fn exponential(sign: f32, q: Vec3) -> Vec4 {
    let d = q.length();
    if sign < 0.0 {
        (q * (d.sinh() / d)).extend(d.cosh())
    } else {
        (q * (d.sin() / d)).extend(d.cos())
    }
}

/// The raised map: ported first, and then boosted back to the eye. u and h in radii.
pub fn port_then_boost(h: f32, u: Vec3) -> Vec4 {
    let x = exponential(-1.0, u + Vec3::Y * h);
    let (sinh, cosh) = (h.sinh(), h.cosh());
    Vec4::new(x.x, cosh * x.y - sinh * x.w, x.z, cosh * x.w - sinh * x.y)
}

/// The isometry that takes the origin to X, with its 1/(1 + w).
pub fn translation(sign: f32, x: Vec4) -> Mat4 {
    let v = x.truncate();
    let column = |i: usize| {
        let along = -sign * v[i] / (1.0 + x.w);
        let mut column = (v * along).extend(-sign * v[i]);
        column[i] += 1.0;
        column
    };
    Mat4::from_cols(column(0), column(1), column(2), x)
}

/// The distance by the inverse cosine of the inner product, in radii.
pub fn distance(sign: f32, a: Vec4, b: Vec4) -> f32 {
    let product = inner(sign, a, b);
    if sign < 0.0 {
        (-product).acosh()
    } else {
        product.acos()
    }
}

/// The direction from a to b: what of b is not along a, made a unit vector.
pub fn direction(sign: f32, a: Vec4, b: Vec4) -> Vec4 {
    let v = b - a * (sign * inner(sign, a, b));
    v / inner(sign, v, v).sqrt()
}

/// A normal of four components made a unit vector by its Euclidean length.
pub fn four_normal(v: Vec4) -> Vec4 {
    v / v.length()
}

/// The chart point of a hyperboloid point, by the inverse cosine.
pub fn unport(x: Vec4) -> Vec3 {
    let d = x.w.acosh();
    x.truncate() * (d / d.sinh())
}

/// The usual depth of a 24-bit buffer, near 0 and far 1, at a distance `z` ahead: whole steps.
pub fn depth_24(near: f64, far: f64, z: f64) -> f64 {
    let depth = far / (far - near) * (1.0 - near / z);
    (depth * 16_777_215.0).round()
}
