// Hyperbolic space by the raised map: the exponential chart about a centre some radii below the eye.

// Hyperboloid coordinates stay in range of f32 up to here, in radii.
const GEO_FAR: f32 = 79.0;

// Points too far for f32 are drawn in towards the eye; they are never on the picture.
fn geo_within_range(space: Space, p: vec3<f32>) -> vec3<f32> {
    // Half of f32's range in decades, before the length is squared.
    let bounded = clamp(p, vec3<f32>(-1.0e18), vec3<f32>(1.0e18));
    let far = length(bounded) * space.k_per_m;
    return select(bounded, bounded * (GEO_FAR / far), far > GEO_FAR);
}

// Ported and boosted in closed form; p in metres from the eye.
fn port(space: Space, p: vec3<f32>) -> vec4<f32> {
    let k = space.k_per_m;
    let c = space.lift * space.radius_m;
    let u = geo_within_range(space, p);
    let q_y = u.y + c;
    let rho_square = u.x * u.x + u.z * u.z;
    let d = sqrt(rho_square + q_y * q_y);
    // So near the eye, at no offset, the map is the identity, and squares would vanish.
    if (d + c) * GEO_SQUARABLE < min(space.radius_m, 1.0) {
        return vec4<f32>(u, 1.0);
    }
    let delta = (u.y * (u.y + 2.0 * c) + rho_square) / (d + c);
    // Both sides of `select` are computed, and the first divides by d + q_y.
    let above = rho_square / select(1.0, d + q_y, q_y > 0.0);
    let m = select(d - q_y, above, q_y > 0.0);
    var across: f32;
    var along: vec2<f32>;
    if k * delta > 2.0 {
        // delta = d - h: with one exponential for both, its error scales the whole point and
        // leaves the direction alone.
        let e = 0.5 * geo_exp(k * d);
        let f = e / (space.lift_cosine + space.lift_sine);
        across = (e - 0.25 / e) / (k * d);
        along = vec2<f32>(space.radius_m * (f - 0.25 / f), f + 0.25 / f);
    } else {
        across = geo_sinhc_cosh(k * d).x;
        let near = geo_sinhc_cosh(k * delta);
        along = vec2<f32>(delta * near.x, near.y);
    }
    return vec4<f32>(
        across * u.x,
        along.x - space.lift_cosine * across * m,
        across * u.z,
        along.y + space.lift_sine * across * (k * m),
    );
}

fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec3<f32> {
    let q = space.k_per_m * geo_within_range(space, p) + vec3<f32>(0.0, space.lift, 0.0);
    let s = dot(q, q);
    // Far out the part across the ray is below the reach of the part along it.
    let stretch = min(geo_sine_cosine(-s).x, GEO_SQUARABLE);
    let bend = geo_bend(s, 1.0, stretch);
    return normalize(n / stretch + q * (bend / stretch * dot(n, q)));
}

// The chart's frame is carried out along the ray from the map's centre: with the ported point (X, W) it is
// (n + X (n.X)/(1 + W), n.X).
fn frame_vector(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec4<f32> {
    let out_of_range = space.k_per_m * p + vec3<f32>(0.0, space.lift, 0.0);
    let q = out_of_range * min(1.0, GEO_FAR_FRAME / max(length(out_of_range), 1e-6));
    let near = geo_sine_cosine(-dot(q, q));
    let x = near.x * q;
    let t = dot(n, x);
    let m = vec4<f32>(n + x * (t / (1.0 + near.y)), t);
    let boosted = vec4<f32>(
        m.x,
        space.lift_cosine * m.y - space.lift_sine * m.w,
        m.z,
        space.lift_cosine * m.w - space.lift_sine * m.y,
    );
    return space.view * boosted;
}

// n exp(-d) over the hyperbolic distance, once it is divided by the distance ahead.
fn depth_of(space: Space, v: vec4<f32>) -> f32 {
    return space.near_m / (v.w + space.k_per_m * geo_length(v.xyz));
}

fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    return space.radius_m * geo_asinh(geo_length(v.xyz) * space.k_per_m);
}

fn curvature_of(space: Space) -> vec2<f32> {
    return vec2<f32>(-1.0, space.k_per_m);
}
