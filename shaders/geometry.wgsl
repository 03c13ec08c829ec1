// The curved-space mathematics of crates/geometry, for the GPU. No entry points, no bindings.
//
// Positions come relative to the eye (flat, hyperbolic) or to their hemisphere's centre (spherical), in metres.
// View coordinates are right, up, back in metres and w without unit; the eye is (0, 0, 0, 1).
// WGSL promises little of its trigonometric and hyperbolic built-ins, so none is used: series in t^2 near
// zero, the exponential away from it.

struct Space {
    view: mat4x4<f32>,    // takes a ported point to view coordinates
    project: vec4<f32>,   // sx, sy, near distance in metres, radius of the sphere in metres or 0
    curve: vec4<f32>,     // k = 1/R, h, sinh h, cosh h
    kind: vec4<u32>,      // 0 flat, 1 raised, 2 sphere
}

const FLAT: u32 = 0u;
const RAISED: u32 = 1u;

// sinh(t) / t. Series to t^10 below 1.5, where the first term left out is 2e-8; the exponential above,
// where sinh no longer cancels.
fn sinhc(t: f32) -> f32 {
    let s = t * t;
    let near = 1.0 + s * (1.0 / 6.0 + s * (1.0 / 120.0 + s * (1.0 / 5040.0
        + s * (1.0 / 362880.0 + s * (1.0 / 39916800.0)))));
    let e = exp(min(abs(t), 80.0));
    let far = 0.5 * (e - 1.0 / e) / max(abs(t), 1.0);
    return select(far, near, s < 2.25);
}

// cosh(t), the same way.
fn cosh_own(t: f32) -> f32 {
    let s = t * t;
    let near = 1.0 + s * (0.5 + s * (1.0 / 24.0 + s * (1.0 / 720.0
        + s * (1.0 / 40320.0 + s * (1.0 / 3628800.0)))));
    let e = exp(min(abs(t), 80.0));
    let far = 0.5 * (e + 1.0 / e);
    return select(far, near, s < 2.25);
}

// sin(t) / t for |t| <= 4; the first term left out is below 1e-7 there.
fn sinc(t: f32) -> f32 {
    let s = t * t;
    return 1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0
        * (1.0 - s / 156.0 * (1.0 - s / 210.0 * (1.0 - s / 272.0 * (1.0 - s / 342.0))))))));
}

// cos(t) for |t| <= 4.
fn cos_own(t: f32) -> f32 {
    let s = t * t;
    return 1.0 - s / 2.0 * (1.0 - s / 12.0 * (1.0 - s / 30.0 * (1.0 - s / 56.0 * (1.0 - s / 90.0
        * (1.0 - s / 132.0 * (1.0 - s / 182.0 * (1.0 - s / 240.0 * (1.0 - s / 306.0
        * (1.0 - s / 380.0)))))))));
}

// Raised map: port and boost in one closed form, derived in crates/geometry/src/raised.rs.
fn port_raised(curve: vec4<f32>, p: vec3<f32>) -> vec4<f32> {
    let k = curve.x;
    let h = curve.y;
    let u = p * k;
    let q_y = u.y + h;
    let rho_square = u.x * u.x + u.z * u.z;
    let d = sqrt(rho_square + q_y * q_y);
    let sum = d + h;
    let delta = select(0.0, (u.y * (u.y + 2.0 * h) + rho_square) / sum, sum > 0.0);
    let m = select(d - q_y, rho_square / max(d + q_y, 1e-30), q_y > 0.0);
    let stretch = sinhc(d);
    let y = sinhc(delta) * delta - curve.w * stretch * m;
    let w = cosh_own(delta) + curve.z * stretch * m;
    return vec4<f32>(stretch * p.x, y / k, stretch * p.z, w);
}

// Cylindrical chart of the sphere; B is chart A turned by diag(-1, 1, 1, -1).
fn port_sphere(k: f32, p: vec3<f32>, hemisphere: u32) -> vec4<f32> {
    let u = p * k;
    let r = length(u.xz);
    let cos_y = cos_own(u.y);
    let ground = cos_y * sinc(r);
    let side = select(1.0, -1.0, hemisphere == 1u);
    return vec4<f32>(side * ground * p.x, sinc(u.y) * p.y, ground * p.z, side * cos_y * cos_own(r));
}

// A chart position as the eye sees it.
fn port_to_view(space: Space, p: vec3<f32>, hemisphere: u32) -> vec4<f32> {
    if space.kind.x == FLAT {
        return space.view * vec4<f32>(p, 1.0);
    }
    if space.kind.x == RAISED {
        return space.view * port_raised(space.curve, p);
    }
    return space.view * port_sphere(space.curve.x, p, hemisphere);
}

// The exact normal of a ported surface, as unit frame coordinates: normals are covectors, so they take the
// inverse transpose of the map's differential. Dot it with the light's chart direction.
fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>, hemisphere: u32) -> vec3<f32> {
    if space.kind.x == FLAT {
        return normalize(n);
    }
    let u = p * space.curve.x;
    if space.kind.x == RAISED {
        // Exponential about the point (0, -h, 0): lengths stretch by sinh(d)/d across the ray, not along it.
        let q = u + vec3<f32>(0.0, space.curve.y, 0.0);
        let square = max(dot(q, q), 1e-20);
        return normalize(n + q * (dot(n, q) * (sinhc(sqrt(square)) - 1.0) / square));
    }
    let r = length(u.xz);
    let stretch = sinc(r);
    let square = max(r * r, 1e-20);
    let along = dot(n.xz, u.xz) * (stretch - 1.0) / square;
    let ground = n.xz + u.xz * along;
    return normalize(vec3<f32>(ground.x, n.y * cos_own(u.y) * stretch, ground.y));
}

// Clip coordinates; reversed depth, near at 1.
fn clip_from_view(space: Space, v: vec4<f32>) -> vec4<f32> {
    let near = space.project.z;
    var depth = near;
    if space.kind.x == RAISED {
        depth = near / (v.w + space.curve.x * length(v.xyz));
    } else if space.kind.x != FLAT {
        depth = 0.5 * (near * v.w - v.z);
    }
    return vec4<f32>(space.project.x * v.x, space.project.y * v.y, depth, -v.z);
}

// An arc tangent of y / x for y >= 0, to 1e-6: a minimax polynomial on [0, 1] and reflection.
fn angle_of(y: f32, x: f32) -> f32 {
    let a = abs(x);
    let t = min(y, a) / max(max(y, a), 1e-30);
    let s = t * t;
    let near = t * (0.99999934 + s * (-0.33329856 + s * (0.19946536 + s * (-0.13908534
        + s * (0.09642004 + s * (-0.05590986 + s * (0.02186123 + s * -0.00405406)))))));
    let first = select(near, 1.57079633 - near, y > a);
    return select(first, 3.14159265 - first, x < 0.0);
}

// Distance from the eye in the space, in metres.
fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    let chord = length(v.xyz);
    if space.kind.x == FLAT {
        return chord;
    }
    let x = chord * space.curve.x;
    if space.kind.x == RAISED {
        // asinh(x) = log(x + sqrt(x^2 + 1)); below 1/8 the series, where the logarithm would lose digits.
        let s = x * x;
        let near = x * (1.0 - s / 6.0 * (1.0 - s * 0.45 * (1.0 - s * 0.5952381)));
        return select(log(x + sqrt(s + 1.0)), near, x < 0.125) / space.curve.x;
    }
    return angle_of(x, v.w) / space.curve.x;
}
