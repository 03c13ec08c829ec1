// The port: from flat chart metres to the curved space, in single precision.
//
// Mirrors crates/geometry; docs/geometry.md has the mathematics. No entry points and no
// bindings: other shaders are appended to this file. Every name but the four functions, the
// struct and its constants begins with `geo_`.
//
// WGSL's own sin, cos, sinh, cosh, asinh and atan2 may be off by thousands of units in the last
// place, so series in t^2 take their places: only + - * are exact enough everywhere. View
// coordinates are x right, y up, z back in metres and w without unit.

struct Space {
    // Applied to the ported point, xyz in metres and w without unit.
    view: mat4x4<f32>,
    // Focal factors sx and sy, near distance in metres, radius in metres (0 where flat).
    project: vec4<f32>,
    // Raised and sphere: curvature k per metre, offset h in radii, sinh h, cosh h. Horizon: kappa
    // per square metre (negative where hyperbolic), height H of the eye in metres, S(H), C(H).
    curve: vec4<f32>,
    // Horizon: farthest level distance and greatest height shown, in metres; k per metre.
    edge: vec4<f32>,
    // x: GEO_FLAT, GEO_RAISED, GEO_SPHERE or GEO_HORIZON.
    kind: vec4<u32>,
}

const GEO_FLAT: u32 = 0u;
const GEO_RAISED: u32 = 1u;
const GEO_SPHERE: u32 = 2u;
const GEO_HORIZON: u32 = 3u;

const GEO_PI: f32 = 3.14159265;
const GEO_LOG2_E: f32 = 1.44269504;
// ln 2 in two parts; a whole number up to 2^14 times the first is exact, fused or not.
const GEO_LN2_HIGH: f32 = 0.693359375;
const GEO_LN2_LOW: f32 = -2.12194440e-4;
// Hyperboloid coordinates stay in range of f32 up to here, in radii.
const GEO_FAR: f32 = 79.0;
// On the horizon map two hyperboloid coordinates are multiplied.
const GEO_FAR_LEVEL: f32 = 38.0;

// sin(t)/t for t^2 = s, t up to pi/2: Taylor, next term 2e-12.
fn geo_sinc_quarter(s: f32) -> f32 {
    return 1.0 + s * (-1.66666667e-1 + s * (8.33333333e-3 + s * (-1.98412698e-4
        + s * (2.75573192e-6 + s * (-2.50521084e-8 + s * 1.60590438e-10)))));
}

// cos(t) for t^2 = s, t up to pi/2: Taylor, next term 7e-11.
fn geo_cos_quarter(s: f32) -> f32 {
    return 1.0 + s * (-0.5 + s * (4.16666667e-2 + s * (-1.38888889e-3
        + s * (2.48015873e-5 + s * (-2.75573192e-7 + s * (2.08767570e-9
        + s * -1.14707456e-11))))));
}

// (sin(t)/t, cos(t)) for t^2 = s, t up to pi, from the half angle.
fn geo_sinc_cos(s: f32) -> vec2<f32> {
    let q = 0.25 * s;
    let sinc = geo_sinc_quarter(q);
    return vec2<f32>(sinc * geo_cos_quarter(q), 1.0 - 2.0 * q * sinc * sinc);
}

// exp(t) for 0 <= t < 88: a power of two times a Taylor series on half a binade.
fn geo_exp(t: f32) -> f32 {
    let n = floor(t * GEO_LOG2_E + 0.5);
    let x = (t - n * GEO_LN2_HIGH) - n * GEO_LN2_LOW;
    let e = 1.0 + x * (1.0 + x * (0.5 + x * (1.66666667e-1 + x * (4.16666667e-2
        + x * (8.33333333e-3 + x * (1.38888889e-3 + x * 1.98412698e-4))))));
    // The power of two goes on in two halves: 2^127 times a mantissa of 1 is the last one.
    let half = i32(n) / 2;
    let low = bitcast<f32>(u32(half + 127) << 23u);
    let high = bitcast<f32>(u32(i32(n) - half + 127) << 23u);
    return e * low * high;
}

// (sinh(t)/t, cosh(t)) for |t| <= 81: Taylor in t^2 up to 2, where nothing cancels, then exp.
fn geo_sinhc_cosh(t: f32) -> vec2<f32> {
    let a = abs(t);
    if a < 2.0 {
        let s = a * a;
        let sinhc = 1.0 + s * (1.66666667e-1 + s * (8.33333333e-3 + s * (1.98412698e-4
            + s * (2.75573192e-6 + s * (2.50521084e-8 + s * (1.60590438e-10
            + s * 7.64716373e-13))))));
        let cosh = 1.0 + s * (0.5 + s * (4.16666667e-2 + s * (1.38888889e-3
            + s * (2.48015873e-5 + s * (2.75573192e-7 + s * (2.08767570e-9
            + s * 1.14707456e-11))))));
        return vec2<f32>(sinhc, cosh);
    }
    let e = 0.5 * geo_exp(a);
    let r = 0.25 / e;
    return vec2<f32>((e - r) / a, e + r);
}

// The sine over its argument and the cosine of any curvature: `s` is kappa t^2, within pi^2 where
// positive.
fn geo_sine_cosine(s: f32) -> vec2<f32> {
    if s > 0.0 {
        return geo_sinc_cos(s);
    }
    return geo_sinhc_cosh(sqrt(-s));
}

// (sinc(t) - 1)/t^2 for t^2 = s up to 4, `flip` -1 for sin and 1 for sinh: Taylor.
fn geo_sinc_bend(s: f32, flip: f32) -> f32 {
    let x = flip * s;
    return flip * (1.66666667e-1 + x * (8.33333333e-3 + x * (1.98412698e-4
        + x * (2.75573192e-6 + x * (2.50521084e-8 + x * (1.60590438e-10
        + x * 7.64716373e-13))))));
}

// atan2(s, c) for s >= 0: halved twice, so that the series runs to tan(pi/8) only.
fn geo_angle(s: f32, c: f32) -> f32 {
    let r = sqrt(s * s + c * c);
    if r == 0.0 {
        return 0.0;
    }
    let half = s / (r + abs(c));
    let t = half / (1.0 + sqrt(1.0 + half * half));
    let x = t * t;
    let quarter = t * (1.0 + x * (-3.33333333e-1 + x * (0.2 + x * (-1.42857143e-1
        + x * (1.11111111e-1 + x * (-9.09090909e-2 + x * (7.69230769e-2
        + x * (-6.66666667e-2 + x * 5.88235294e-2))))))));
    let angle = 4.0 * quarter;
    return select(angle, GEO_PI - angle, c < 0.0);
}

// asinh(x) for x >= 0: series where log(1 + small) would lose digits, after two halvings.
fn geo_asinh(x: f32) -> f32 {
    if x > 1.0e4 {
        return log(x) + 0.693147181;
    }
    if x > 0.5 {
        return log(x + sqrt(x * x + 1.0));
    }
    // sinh(t/2) = sinh t / sqrt(2 (1 + cosh t)).
    let y = x / sqrt(2.0 * (1.0 + sqrt(1.0 + x * x)));
    let z = y / sqrt(2.0 * (1.0 + sqrt(1.0 + y * y)));
    let s = z * z;
    return 4.0 * z * (1.0 + s * (-1.66666667e-1 + s * (7.5e-2 + s * (-4.46428571e-2
        + s * 3.03819444e-2))));
}

// The length of a vector whose squares may be out of range.
fn geo_length(v: vec3<f32>) -> f32 {
    let most = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if most < 1.0e15 {
        return length(v);
    }
    return most * length(v / most);
}

// Points too far for f32 are drawn in towards the eye; they are never on the picture.
fn geo_within_range(space: Space, p: vec3<f32>) -> vec3<f32> {
    // Half of f32's range in decades, before the length is squared.
    let bounded = clamp(p, vec3<f32>(-1.0e18), vec3<f32>(1.0e18));
    let far = length(bounded) * space.curve.x;
    return select(bounded, bounded * (GEO_FAR / far), far > GEO_FAR);
}

// Raised map, ported and boosted in closed form; p in metres from the eye.
fn geo_port_raised(space: Space, p: vec3<f32>) -> vec4<f32> {
    let k = space.curve.x;
    let c = space.curve.y * space.project.w;
    let u = geo_within_range(space, p);
    let q_y = u.y + c;
    let rho_square = u.x * u.x + u.z * u.z;
    let d = sqrt(rho_square + q_y * q_y);
    if d + c == 0.0 {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
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
        let f = e / (space.curve.w + space.curve.z);
        across = (e - 0.25 / e) / (k * d);
        along = vec2<f32>(space.project.w * (f - 0.25 / f), f + 0.25 / f);
    } else {
        across = geo_sinhc_cosh(k * d).x;
        let near = geo_sinhc_cosh(k * delta);
        along = vec2<f32>(delta * near.x, near.y);
    }
    return vec4<f32>(
        across * u.x,
        along.x - space.curve.w * across * m,
        across * u.z,
        along.y + space.curve.z * across * (k * m),
    );
}

// Cylindrical chart of the sphere; p in metres from the hemisphere's pole.
fn geo_port_sphere(space: Space, p: vec3<f32>, hemisphere: u32) -> vec4<f32> {
    let k = space.curve.x;
    let u = k * p;
    let level = geo_sinc_cos(u.x * u.x + u.z * u.z);
    let upright = geo_sinc_cos(u.y * u.y);
    let flip = select(1.0, -1.0, hemisphere == 1u);
    return vec4<f32>(
        upright.y * level.x * p.x * flip,
        upright.x * p.y,
        upright.y * level.x * p.z,
        upright.y * level.y * flip,
    );
}

// A point from the eye, drawn in where products of its coordinates would leave the range of f32.
fn geo_within_horizon(space: Space, p: vec3<f32>) -> vec3<f32> {
    let bounded = clamp(p, vec3<f32>(-1.0e18), vec3<f32>(1.0e18));
    let far = length(bounded) * space.edge.z;
    if space.curve.x < 0.0 && far > GEO_FAR_LEVEL {
        return bounded * (GEO_FAR_LEVEL / far);
    }
    return bounded;
}

// Horizon map, ported and boosted in closed form; p in metres from the eye. With q = S(r/2)^2:
// Y' = S(u.y) + 2 kappa S(H) C(y) q, W' = C(u.y) - 2 kappa C(H) C(y) q.
fn geo_port_horizon(space: Space, p: vec3<f32>) -> vec4<f32> {
    let kappa = space.curve.x;
    let u = geo_within_horizon(space, p);
    let y = u.y + space.curve.y;
    let r_square = u.x * u.x + u.z * u.z;
    let half = geo_sine_cosine(0.25 * kappa * r_square);
    let rise = geo_sine_cosine(kappa * u.y * u.y);
    let upright = geo_sine_cosine(kappa * y * y).y;
    let sag = 0.5 * upright * (half.x * half.x) * (kappa * r_square);
    let across = upright * (half.x * half.y);
    return vec4<f32>(
        across * u.x,
        rise.x * u.y + space.curve.z * sag,
        across * u.z,
        rise.y - space.curve.w * sag,
    );
}

// Metres by which a point lies beyond what its map shows; far below zero where all is shown.
fn geo_beyond_edge(space: Space, p: vec3<f32>) -> f32 {
    return max(length(p.xz) - space.edge.x, abs(p.y + space.curve.y) - space.edge.y);
}

// A chart point in view coordinates. p is in metres relative to the space's reference: the eye,
// or the hemisphere's pole on the sphere.
fn port_to_view(space: Space, p: vec3<f32>, hemisphere: u32) -> vec4<f32> {
    var x = vec4<f32>(p, 1.0);
    if space.kind.x == GEO_RAISED {
        x = geo_port_raised(space, p);
    } else if space.kind.x == GEO_SPHERE {
        x = geo_port_sphere(space, p, hemisphere);
    } else if space.kind.x == GEO_HORIZON {
        x = geo_port_horizon(space, p);
    }
    return space.view * x;
}

// A chart normal as a unit covector of the space, in the coordinates of the chart's frame at
// the point, whose y is up: its dot product with a light's chart direction is N.L. It is
// normalised here, in three dimensions: under the model's inner product f32 would lose it.
fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>, hemisphere: u32) -> vec3<f32> {
    if space.kind.x == GEO_RAISED {
        let q = space.curve.x * geo_within_range(space, p) + vec3<f32>(0.0, space.curve.y, 0.0);
        let s = dot(q, q);
        let d = sqrt(s);
        // Past 1e12 the part across the ray is below f32's reach of the part along it.
        let stretch = min(geo_sinhc_cosh(d).x, 1.0e12);
        let bend = select((stretch - 1.0) / max(s, 1.0), geo_sinc_bend(s, 1.0), s < 1.0);
        return normalize(n / stretch + q * (bend / stretch * dot(n, q)));
    }
    if space.kind.x == GEO_SPHERE {
        // The mirror of hemisphere B leaves the formula as it is.
        let u = space.curve.x * p;
        let s = u.x * u.x + u.z * u.z;
        let level = geo_sinc_cos(s);
        let upright = geo_sinc_cos(u.y * u.y);
        let direct = (level.x - 1.0) / max(s, 1.0);
        let bend = select(direct, geo_sinc_bend(s, -1.0), s < 1.0) * (n.x * u.x + n.z * u.z);
        return normalize(vec3<f32>(
            n.x + bend * u.x,
            n.y * upright.y * level.x,
            n.z + bend * u.z,
        ));
    }
    if space.kind.x == GEO_HORIZON {
        let u = geo_within_horizon(space, p);
        let s = space.curve.x * (u.x * u.x + u.z * u.z);
        let y = u.y + space.curve.y;
        let level = geo_sine_cosine(s).x;
        let upright = geo_sine_cosine(space.curve.x * y * y).y;
        let series = geo_sinc_bend(abs(s), -sign(s));
        // Divided by the greater of S(r)/r and 1, so that nothing overflows.
        let shrink = 1.0 / max(level, 1.0);
        let bend = select((level - 1.0) / max(abs(s), 1.0), series, abs(s) < 1.0)
            * abs(space.curve.x) * (n.x * u.x + n.z * u.z);
        return normalize(vec3<f32>(
            (n.x + bend * u.x) * shrink,
            n.y * upright * (level * shrink),
            (n.z + bend * u.z) * shrink,
        ));
    }
    return normalize(n);
}

// Reversed depth, nearer is greater: n/d where flat, n exp(-d) over the hyperbolic distance,
// and on the sphere a line through W = 0 to the antipode.
fn clip_from_view(space: Space, v: vec4<f32>) -> vec4<f32> {
    let near = space.project.z;
    var depth = near;
    if space.kind.x == GEO_RAISED {
        depth = near / (v.w + space.curve.x * geo_length(v.xyz));
    } else if space.kind.x == GEO_SPHERE {
        depth = 0.5 * (near * v.w - v.z);
    } else if space.kind.x == GEO_HORIZON && space.curve.x < 0.0 {
        depth = near / (v.w + space.edge.z * geo_length(v.xyz));
    } else if space.kind.x == GEO_HORIZON && space.curve.x > 0.0 {
        depth = 0.5 * near * (1.0 + v.w);
    }
    return vec4<f32>(space.project.x * v.x, space.project.y * v.y, depth, -v.z);
}

// Distance from the eye in the space, in metres.
fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    let rho = geo_length(v.xyz);
    if space.kind.x == GEO_RAISED {
        return space.project.w * geo_asinh(rho * space.curve.x);
    }
    if space.kind.x == GEO_SPHERE {
        return space.project.w * geo_angle(rho * space.curve.x, v.w);
    }
    if space.kind.x == GEO_HORIZON && space.curve.x < 0.0 {
        return space.project.w * geo_asinh(rho * space.edge.z);
    }
    if space.kind.x == GEO_HORIZON && space.curve.x > 0.0 {
        return space.project.w * geo_angle(rho * space.edge.z, v.w);
    }
    return rho;
}
