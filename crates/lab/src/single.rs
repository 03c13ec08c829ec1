//! The `f32` kernels of the geometry crate on vectors: the arithmetic of `shaders/geometry.wgsl`.

use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::{distance, exponential, sphere as sphere_kernel};
use antipode_geometry::{Real, SpaceUniform};
use glam::{Vec3, Vec4};

/// (sin(t)/t, cos(t)) for t^2 = s.
pub fn sinc_cos(s: f32) -> (f32, f32) {
    <f32 as Real>::sinc_cos(s).into()
}

/// (sinh(t)/t, cosh(t)).
pub fn sinhc_cosh(t: f32) -> (f32, f32) {
    <f32 as Real>::sinhc_cosh(t).into()
}

/// The raised map as the shader has it.
pub fn raised_map(space: &SpaceUniform) -> RaisedMap<f32> {
    let lift = [
        space.k_per_m,
        space.lift,
        space.lift_sine,
        space.lift_cosine,
    ];
    RaisedMap::from_uniform(lift, space.radius_m)
}

/// The horizon map as the shader has it.
pub fn horizon_map(space: &SpaceUniform) -> HorizonMap<f32> {
    let lift = [space.kappa, space.lift, space.lift_sine, space.lift_cosine];
    HorizonMap::from_uniform(lift, space.k_per_m, space.radius_m)
}

/// The raised map, p in metres from the eye: before the camera's rotation.
pub fn raised(space: &SpaceUniform, p: Vec3) -> Vec4 {
    let map = raised_map(space);
    map.port(p.to_array()).into()
}

/// The cylindrical chart of hemisphere A, p in metres from its pole, k in 1/m.
pub fn sphere(k: f32, p: Vec3) -> Vec4 {
    sphere_kernel::port(k, false, p.to_array()).into()
}

/// The exact normal of the hyperbolic exponential chart at q, in radii from its centre.
pub fn normal_exponential(q: Vec3, n: Vec3) -> Vec3 {
    exponential::normal(-1.0, q.to_array(), n.to_array()).into()
}

/// The exact normal of the sphere's cylindrical chart at u, in radii from the pole.
pub fn normal_sphere(u: Vec3, n: Vec3) -> Vec3 {
    sphere_kernel::normal(u.to_array(), n.to_array()).into()
}

/// The chord form of the distance between two unit points of the sphere, in radii.
pub fn sphere_distance(a: Vec4, b: Vec4) -> f32 {
    distance::spherical(a.to_array(), b.to_array())
}

/// The chord form of the distance of two points of the hyperboloid, in radii.
pub fn hyperbolic_distance(a: Vec4, b: Vec4) -> f32 {
    distance::hyperbolic(a.to_array(), b.to_array())
}
