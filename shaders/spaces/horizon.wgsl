// The horizon map, of hyperbolic space and of flat space that is bent either way: the cylindrical chart about the foot of
// the eye, on a sheet below it. One text for every curvature, since the player turns it through zero.
//
// No branch here is on uniforms alone, so that `&` stands where `&&` could: lavapipe compiles a shader that has one anew for
// every frame, and keeps each.

// Two hyperboloid coordinates are multiplied, which stay in range of f32 up to here, in radii.
const GEO_FAR_LEVEL: f32 = 38.0;
// Farther than any view coordinate, metres.
const GEO_ENDLESS: f32 = 3.0e38;

// A point from the eye, drawn in where products of its coordinates would leave the range of f32.
fn geo_within_horizon(space: Space, p: vec3<f32>) -> vec3<f32> {
    let bounded = clamp(p, vec3<f32>(-1.0e18), vec3<f32>(1.0e18));
    let far = length(bounded) * space.k_per_m;
    if (space.kappa < 0.0) & (far > GEO_FAR_LEVEL) {
        return bounded * (GEO_FAR_LEVEL / far);
    }
    return bounded;
}

// A climb of y metres from the eye on the horizon map.
struct geo_Climb {
    // S(y) in metres and C(y).
    rise: f32,
    fall: f32,
    // C(y + H) is scale lifted (1 + upright), scale a power of two.
    scale: f32,
    lifted: f32,
    upright: f32,
}

fn geo_climb(space: Space, y: f32) -> geo_Climb {
    let kappa = space.kappa;
    let steep = space.k_per_m * abs(y);
    if (kappa < 0.0) & (steep > 1.0) {
        // One exponential for all three: its error scales the point and leaves the direction.
        let sense = select(1.0, -1.0, y < 0.0);
        let e = geo_half_exp(steep, 0.0);
        let lifted = space.lift_cosine + sense * space.k_per_m * space.lift_sine;
        return geo_Climb(
            sense * space.radius_m * (e.x + e.x * (e.y + (e.z - e.w))),
            e.x + e.x * (e.y + (e.z + e.w)),
            e.x,
            lifted,
            e.y + (e.z + e.w / (lifted * lifted)),
        );
    }
    let near = geo_excess(kappa * y * y);
    let rise = y + y * near.x;
    let upright = (space.lift_cosine - 1.0) + (space.lift_cosine * near.y - kappa * rise * space.lift_sine);
    return geo_Climb(rise, 1.0 + near.y, 1.0, 1.0, upright);
}

// Ported and boosted in closed form; p in metres from the eye:
// Y' = S(u.y) - S(H) C(y) (C(r) - 1), W' = C(u.y) + C(H) C(y) (C(r) - 1).
fn port(space: Space, p: vec3<f32>) -> vec4<f32> {
    let u = geo_within_horizon(space, p);
    let s = space.kappa * (u.x * u.x + u.z * u.z);
    // (scale, sine, cosine, divisor) of the level distance.
    var level = vec4<f32>(1.0, geo_excess(s), 1.0);
    if s <= -1.0 {
        level = geo_parts_far(space.k_per_m * vec3<f32>(u.x, 0.0, u.z));
    }
    let climb = geo_climb(space, u.y);
    let upright = climb.scale * climb.lifted;
    // (C(r) - 1)(1 + climb.upright)
    let whole = level.x - 1.0;
    let part = level.x * level.z;
    let sag = upright * (whole + (part + (whole + part) * climb.upright));
    let across = geo_product(upright * level.x, level.y, climb.upright) / level.w;
    return vec4<f32>(
        across * u.x,
        climb.rise - space.lift_sine * sag,
        across * u.z,
        climb.fall + space.lift_cosine * sag,
    );
}

fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec3<f32> {
    let u = geo_within_horizon(space, p);
    let s = space.kappa * (u.x * u.x + u.z * u.z);
    let climb = geo_climb(space, u.y);
    let upright = climb.scale * climb.lifted * (1.0 + climb.upright);
    let flip = select(1.0, -1.0, space.kappa > 0.0);
    return geo_normal_cylindrical(n, u, s, upright, flip, abs(space.kappa));
}

// The chart stands on the sheet below the eye.
fn frame_vector(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec4<f32> {
    let s = select(-1.0, 1.0, space.kappa > 0.0);
    let k = space.k_per_m;
    let m = geo_frame_cylindrical(n, k * vec2<f32>(p.x, p.z), k * (p.y + space.lift), s);
    // Down to the eye, by its height.
    let sine = k * space.lift_sine;
    return space.view * vec4<f32>(
        m.x,
        space.lift_cosine * m.y - sine * m.w,
        m.z,
        space.lift_cosine * m.w + s * sine * m.y,
    );
}

// n/d where flat, n exp(-d) over the hyperbolic distance, and the height over the equator where it bends in, once it is
// divided by the distance ahead.
fn depth_of(space: Space, v: vec4<f32>) -> f32 {
    let near = space.near_m;
    let outwards = near / (v.w + space.k_per_m * geo_length(v.xyz));
    return select(outwards, 0.5 * near * (1.0 + v.w), space.kappa > 0.0);
}

fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    let rho = geo_length(v.xyz);
    if (space.kappa < 0.0) & (rho < GEO_ENDLESS) {
        return space.radius_m * geo_asinh(rho * space.k_per_m);
    }
    if (space.kappa > 0.0) & (rho < GEO_ENDLESS) {
        return space.radius_m * geo_angle(rho * space.k_per_m, v.w);
    }
    return rho;
}

fn curvature_of(space: Space) -> vec2<f32> {
    return vec2<f32>(select(1.0, -1.0, space.kappa < 0.0), space.k_per_m);
}
