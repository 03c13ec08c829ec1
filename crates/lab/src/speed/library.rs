//! Rivals of the geometry crate's kernels that the game does not use: the same closed forms with the system's `f32`
//! library, and the port that is boosted afterwards. Formulas: docs/geometry.md.

use antipode_geometry::Real;
use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;

/// (sinh(t)/t, cosh(t)).
fn sinhc_cosh(t: f32) -> (f32, f32) {
    (if t == 0.0 { 1.0 } else { t.sinh() / t }, t.cosh())
}

/// (sin(t)/t, cos(t)).
fn sinc_cos(t: f32) -> (f32, f32) {
    (if t == 0.0 { 1.0 } else { t.sin() / t }, t.cos())
}

/// The exponential chart of hyperbolic space; `q` in radii, and so the result.
pub fn exponential([x, y, z]: [f32; 3]) -> [f32; 4] {
    let (across, w) = sinhc_cosh((x * x + y * y + z * z).sqrt());
    [across * x, across * y, across * z, w]
}

/// The raised map in closed form, metres from the eye.
pub fn raised(map: &RaisedMap<f32>, [x, y, z]: [f32; 3]) -> [f32; 4] {
    let (k, c) = (map.k, map.offset_m);
    let q = y + c;
    let level = x * x + z * z;
    let d = (level + q * q).sqrt();
    let delta = (y * (y + 2.0 * c) + level) / (d + c);
    let m = if q > 0.0 { level / (d + q) } else { d - q };
    let across = sinhc_cosh(k * d).0;
    let near = sinhc_cosh(k * delta);
    let up = delta * near.0 - map.cosh * across * m;
    [
        across * x,
        up,
        across * z,
        near.1 + map.sinh * across * (k * m),
    ]
}

/// The raised map ported first and then boosted back to the eye: what the closed form avoids.
pub fn port_then_boost<T: Real>(map: &RaisedMap<T>, [x, y, z]: [T; 3]) -> [T; 4] {
    let k = map.k;
    let q = y + map.offset_m;
    let [across, w] = T::sinhc_cosh(k * (x * x + q * q + z * z).sqrt());
    let up = map.cosh * (across * q) - map.sinh * (w / k);
    let back = map.cosh * w - map.sinh * (k * across * q);
    [across * x, up, across * z, back]
}

/// The horizon map of a hyperbolic world in closed form, metres from the eye.
pub fn horizon(map: &HorizonMap<f32>, [x, y, z]: [f32; 3]) -> [f32; 4] {
    let k = map.k;
    let r = k * (x * x + z * z).sqrt();
    let (half, half_cosh) = sinhc_cosh(0.5 * r);
    let rise = sinhc_cosh(k * y);
    let upright = sinhc_cosh(k * (y + map.lift_m)).1;
    let across = upright * half * half_cosh;
    let sag = -0.5 * upright * (half * half) * (r * r);
    [
        across * x,
        y * rise.0 + map.sin * sag,
        across * z,
        rise.1 - map.cos * sag,
    ]
}

/// The chart of the sphere's hemisphere A, metres from its pole.
pub fn sphere(k: f32, [x, y, z]: [f32; 3]) -> [f32; 4] {
    let (level, far) = sinc_cos(k * (x * x + z * z).sqrt());
    let (up, upright) = sinc_cos(k * y);
    [
        upright * level * x,
        up * y,
        upright * level * z,
        upright * far,
    ]
}

/// The matrix of those columns applied to a vector.
pub fn seen<T: Real>([x, y, z, w]: &[[T; 4]; 4], [a, b, c, d]: [T; 4]) -> [T; 4] {
    let row = |i: usize| x[i] * a + y[i] * b + z[i] * c + w[i] * d;
    [row(0), row(1), row(2), row(3)]
}
