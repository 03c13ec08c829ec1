// The hyperbolic world: the equiangular chart of a square, tanh(x/R) = X/W and tanh(z/R) = Z/W, seen from the reference.
//
// In the model X is the point from the reference, which is the eye's own place where the chart is written there, and else
// lies at the eye's height over the chart's middle: `space.origin` has its tangents X/W and Z/W and its W on the ground,
// `space.lift` its height in radii. Everything is a difference to it, so that nothing cancels near the eye.

// X/W along the edges of squares, phi^(-3/2), and how near to it counts as on it: a rounding of f32.
const GEO_EDGE: f32 = 0.48586827;
const GEO_ON_EDGE: f32 = 3.0e-7;
// What is on an edge is moved out by these, metres, and metres a metre away: twice what vertices are rounded to, and some
// roundings of f32. The squares on both sides so overlap by less than a pixel shows, and no sky is seen between them.
const GEO_LAP_M: f32 = 6.0e-5;
const GEO_LAP: f32 = 1.0e-6;
// No place is nearer than this to the end of the plane, where 1 - a^2 - b^2 is 0.
const GEO_PLANE_END: f32 = 1.0e-3;

// A place of the ground: its tangents a = X/W and b = Z/W, and by how much they differ from the reference's.
struct geo_Ground {
    at: vec2<f32>,
    away: vec2<f32>,
}

// By how far a tangent is moved out where it is an edge's.
fn geo_lap(at: f32, metres: f32, k: f32) -> f32 {
    let out = k * metres * (1.0 - at * at);
    return select(0.0, select(out, -out, at < 0.0), abs(abs(at) - GEO_EDGE) < GEO_ON_EDGE);
}

// tanh(x0 + u) - tanh(x0) = tanh(u) (1 - a0^2)/(1 + a0 tanh(u)).
fn geo_ground(space: Space, p: vec3<f32>) -> geo_Ground {
    let u = space.k_per_m * p.xz;
    let x = geo_sinhc_cosh(u.x);
    let z = geo_sinhc_cosh(u.y);
    let t = u * vec2<f32>(x.x, z.x) / vec2<f32>(x.y, z.y);
    let here = space.origin.xy;
    let away = t * (1.0 - here * here) / (1.0 + here * t);
    let at = here + away;
    let lap = GEO_LAP_M + GEO_LAP * (length(space.view[3].xyz) + length(p.xz));
    let out = vec2<f32>(geo_lap(at.x, lap, space.k_per_m), geo_lap(at.y, lap, space.k_per_m));
    return geo_Ground(at + out, away + out);
}

// W of a place of the ground.
fn geo_ground_w(at: vec2<f32>) -> f32 {
    return 1.0 / sqrt(max(1.0 - dot(at, at), GEO_PLANE_END));
}

// A vector (X, Z, W) of the plane in the frame at the reference, whose axes are those of the chart's middle carried there.
fn geo_from_reference(space: Space, v: vec2<f32>, w: f32) -> vec3<f32> {
    let w0 = space.origin.z;
    let here = w0 * space.origin.xy;
    let along = dot(here, v);
    return vec3<f32>(v + here * (along / (1.0 + w0) - w), w0 * w - along);
}

// The ground's point is a multiple of (a, b, 1), which is that of the reference and (da, db, 0): of the first only w is left,
// 1/w0. Then down to the reference by its height, as on the horizon map: with c what W on the ground exceeds 1 by,
// Y' = sinh(y - y0) - sinh(y0) cosh(y) c and W' = cosh(y - y0) + cosh(y0) cosh(y) c.
fn port(space: Space, p: vec3<f32>) -> vec4<f32> {
    let ground = geo_ground(space, p);
    let scale = geo_ground_w(ground.at);
    let level = scale * geo_from_reference(space, ground.away, 0.0).xy;
    let square = dot(level, level);
    let more = square / (1.0 + sqrt(1.0 + square));
    let climb = space.k_per_m * p.y;
    let rise = geo_sinhc_cosh(climb);
    let upright = geo_sinhc_cosh(space.lift + climb).y;
    let radius = space.radius_m;
    return vec4<f32>(
        radius * upright * level.x,
        rise.x * p.y - radius * (space.lift_sine * (upright * more)),
        radius * upright * level.y,
        rise.y + space.lift_cosine * (upright * more),
    );
}

// By the transposed inverse of the chart's lengths (W I + W^3/(1 + W) v v^T) diag(1 - a^2, 1 - b^2) cosh(y), v = (a, b), which
// is 1/(W cosh(y)) (I - W/(1 + W) v v^T) diag(1 - a^2, 1 - b^2)^-1.
fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec3<f32> {
    let at = geo_ground(space, p).at;
    let w = geo_ground_w(at);
    let upright = geo_sinhc_cosh(space.lift + space.k_per_m * p.y).y;
    let m = n.xz / max(1.0 - at * at, vec2<f32>(GEO_PLANE_END));
    let level = m - at * (dot(at, m) * w / (1.0 + w));
    return normalize(vec3<f32>(level.x, n.y * (w * upright), level.y));
}

// The chart's frame at a place is that of its middle carried there: E_x = (1 + X^2/(1 + W), X Z/(1 + W), X) in (X, Z, W), E_z
// alike, and E_y = (sinh(y) P, cosh(y)) over the point P of the ground.
fn frame_vector(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec4<f32> {
    let at = geo_ground(space, p).at;
    let w = geo_ground_w(at);
    let here = w * at;
    let along = dot(here, n.xz);
    let level = geo_from_reference(space, n.xz + here * (along / (1.0 + w)), along);
    let ground = geo_from_reference(space, here, w);
    let height = space.lift + space.k_per_m * p.y;
    let upright = geo_sinhc_cosh(height);
    let rise = height * upright.x * n.y;
    let m = level + rise * ground;
    let y = upright.y * n.y;
    let view = space.view * vec4<f32>(
        space.radius_m * m.x,
        space.radius_m * (space.lift_cosine * y - space.lift_sine * m.z),
        space.radius_m * m.y,
        space.lift_cosine * m.z - space.lift_sine * y,
    );
    return vec4<f32>(view.xyz * space.k_per_m, view.w);
}

// n/d, once it is divided by the distance ahead: d is R sinh of the distance, so that it falls along each ray, and it is linear
// in triangles, whose planes the port keeps.
fn depth_of(space: Space, v: vec4<f32>) -> f32 {
    return space.near_m;
}

fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    return space.radius_m * geo_asinh(min(geo_length(v.xyz) * space.k_per_m, 1.0e37));
}

fn curvature_of(space: Space) -> vec2<f32> {
    return vec2<f32>(-1.0, space.k_per_m);
}
