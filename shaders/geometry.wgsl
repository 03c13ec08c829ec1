// The port: from flat chart metres to the curved space, in single precision.
//
// Mirrors crates/geometry; docs/geometry.md has the mathematics. No entry points and no
// bindings: other shaders are appended to this file. Every name but the five functions, the
// struct and its constants begins with `geo_`.
//
// Its sines, cosines and their kin are those of trigonometry.wgsl, which stands in front. View
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
const GEO_ANY: u32 = 4u;

// The map to compile for. A pipeline that names one has no branches for the others; GEO_ANY leaves it to the
// uniform, which costs about twice as much a vertex where every branch is run.
override GEO_KIND: u32 = 4u;

fn geo_kind(space: Space) -> u32 {
    return select(GEO_KIND, space.kind.x, GEO_KIND == GEO_ANY);
}

// Hyperboloid coordinates stay in range of f32 up to here, in radii.
const GEO_FAR: f32 = 79.0;
// On the horizon map two hyperboloid coordinates are multiplied.
const GEO_FAR_LEVEL: f32 = 38.0;
// Squares of lengths between this and its reciprocal neither overflow nor vanish.
const GEO_SQUARABLE: f32 = 1.0e15;

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
    // So near the eye, at no offset, the map is the identity, and squares would vanish.
    if (d + c) * GEO_SQUARABLE < min(space.project.w, 1.0) {
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
    let kappa = space.curve.x;
    let steep = space.edge.z * abs(y);
    if kappa < 0.0 && steep > 1.0 {
        // One exponential for all three: its error scales the point and leaves the direction.
        let sense = select(1.0, -1.0, y < 0.0);
        let e = geo_half_exp(steep, 0.0);
        let lifted = space.curve.w + sense * space.edge.z * space.curve.z;
        return geo_Climb(
            sense * space.project.w * (e.x + e.x * (e.y + (e.z - e.w))),
            e.x + e.x * (e.y + (e.z + e.w)),
            e.x,
            lifted,
            e.y + (e.z + e.w / (lifted * lifted)),
        );
    }
    let near = geo_excess(kappa * y * y);
    let rise = y + y * near.x;
    let upright = (space.curve.w - 1.0) + (space.curve.w * near.y - kappa * rise * space.curve.z);
    return geo_Climb(rise, 1.0 + near.y, 1.0, 1.0, upright);
}

// Horizon map, ported and boosted in closed form; p in metres from the eye:
// Y' = S(u.y) - S(H) C(y) (C(r) - 1), W' = C(u.y) + C(H) C(y) (C(r) - 1).
fn geo_port_horizon(space: Space, p: vec3<f32>) -> vec4<f32> {
    let u = geo_within_horizon(space, p);
    let s = space.curve.x * (u.x * u.x + u.z * u.z);
    // (scale, sine, cosine, divisor) of the level distance.
    var level = vec4<f32>(1.0, geo_excess(s), 1.0);
    if s <= -1.0 {
        level = geo_parts_far(space.edge.z * vec3<f32>(u.x, 0.0, u.z));
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
        climb.rise - space.curve.z * sag,
        across * u.z,
        climb.fall + space.curve.w * sag,
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
    if geo_kind(space) == GEO_RAISED {
        x = geo_port_raised(space, p);
    } else if geo_kind(space) == GEO_SPHERE {
        x = geo_port_sphere(space, p, hemisphere);
    } else if geo_kind(space) == GEO_HORIZON {
        x = geo_port_horizon(space, p);
    }
    return space.view * x;
}

// (sinc - 1)/s of the sign `flip` belongs to, from a sinc already known where that does not cancel.
fn geo_bend(s: f32, flip: f32, sinc: f32) -> f32 {
    let direct = (sinc - 1.0) / max(s, 1.0);
    return select(direct, geo_sinc_bend(s, flip), s < 4.0 || flip < 0.0);
}

// A chart normal as a unit covector of the space, in the coordinates of the chart's frame at
// the point, whose y is up: its dot product with a light's chart direction is N.L. It is
// normalised here, in three dimensions: under the model's inner product f32 would lose it.
fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>, hemisphere: u32) -> vec3<f32> {
    if geo_kind(space) == GEO_RAISED {
        let q = space.curve.x * geo_within_range(space, p) + vec3<f32>(0.0, space.curve.y, 0.0);
        let s = dot(q, q);
        // Far out the part across the ray is below the reach of the part along it.
        let stretch = min(geo_sine_cosine(-s).x, GEO_SQUARABLE);
        let bend = geo_bend(s, 1.0, stretch);
        return normalize(n / stretch + q * (bend / stretch * dot(n, q)));
    }
    if geo_kind(space) == GEO_FLAT {
        return normalize(n);
    }
    // Cylindrical charts; the mirror of hemisphere B leaves the formula as it is.
    var u: vec3<f32>;
    var s: f32;
    var upright: f32;
    var flip = -1.0;
    var scale = 1.0;
    if geo_kind(space) == GEO_SPHERE {
        u = space.curve.x * p;
        s = u.x * u.x + u.z * u.z;
        upright = geo_sinc_cos(u.y * u.y).y;
    } else {
        u = geo_within_horizon(space, p);
        s = space.curve.x * (u.x * u.x + u.z * u.z);
        let climb = geo_climb(space, u.y);
        upright = climb.scale * climb.lifted * (1.0 + climb.upright);
        flip = select(1.0, -1.0, space.curve.x > 0.0);
        scale = abs(space.curve.x);
    }
    let level = geo_sine_cosine(s).x;
    let bend = geo_bend(abs(s), flip, level) * scale * (n.x * u.x + n.z * u.z);
    // Divided by the greater of the sine over r and 1, so that nothing overflows.
    let shrink = 1.0 / max(abs(level), 1.0);
    return normalize(vec3<f32>(
        (n.x + bend * u.x) * shrink,
        n.y * upright * (level * shrink),
        (n.z + bend * u.z) * shrink,
    ));
}

// Lengths of frame vectors are told within this distance of the map's centre, in radii; farther off they keep the
// direction of that place, so that nothing overflows.
const GEO_FAR_FRAME: f32 = 12.0;

// A vector of the chart's frame at a point, as `port_normal` gives them, in view coordinates: x, y, z and w without
// unit, a unit vector of the model's tangent space for a unit vector of the frame.
//
// The frame of the raised map is carried out along the ray from the map's centre: with the ported point (X, W) it is
// (n + X (n.X)/(1 + W), n.X). Those of the cylindrical charts, at level distance r and height y with s the sign of the
// curvature, are the derivatives along r, across and along y of (C(y) S(r), S(y), C(y) C(r)).
fn frame_vector(space: Space, p: vec3<f32>, n: vec3<f32>, hemisphere: u32) -> vec4<f32> {
    if geo_kind(space) == GEO_FLAT {
        return vec4<f32>((space.view * vec4<f32>(n, 0.0)).xyz, 0.0);
    }
    if geo_kind(space) == GEO_RAISED {
        let out_of_range = space.curve.x * p + vec3<f32>(0.0, space.curve.y, 0.0);
        let q = out_of_range * min(1.0, GEO_FAR_FRAME / max(length(out_of_range), 1e-6));
        let near = geo_sine_cosine(-dot(q, q));
        let x = near.x * q;
        let t = dot(n, x);
        let m = vec4<f32>(n + x * (t / (1.0 + near.y)), t);
        let boosted = vec4<f32>(
            m.x,
            space.curve.w * m.y - space.curve.z * m.w,
            m.z,
            space.curve.w * m.w - space.curve.z * m.y,
        );
        return space.view * boosted;
    }
    // The sphere's charts stand on its ground; the horizon map's on the sheet below the eye.
    let is_sphere = geo_kind(space) == GEO_SPHERE;
    let bends_in = is_sphere || space.curve.x > 0.0;
    let s = select(-1.0, 1.0, bends_in);
    let k = select(space.edge.z, space.curve.x, is_sphere);
    let height = k * (p.y + select(space.curve.y, 0.0, is_sphere));
    let level = k * vec2<f32>(p.x, p.z);
    let u = level * min(1.0, GEO_FAR_FRAME / max(length(level), 1e-6));
    let r2 = dot(u, u);
    let round = geo_sine_cosine(s * r2);
    let upright = geo_sine_cosine(s * height * height);
    let rise = clamp(height, -GEO_FAR_FRAME, GEO_FAR_FRAME) * upright.x;
    let along = n.x * u.x + n.z * u.y;
    // (C(r) - 1)/r^2 = -s/2 sinc(r/2)^2.
    let half = geo_sine_cosine(0.25 * s * r2).x;
    let turn = -0.5 * s * half * half * along - s * rise * round.x * n.y;
    var m = vec4<f32>(
        n.x + turn * u.x,
        upright.y * n.y,
        n.z + turn * u.y,
        -s * (round.x * along + rise * round.y * n.y),
    );
    if is_sphere {
        let flip = select(1.0, -1.0, hemisphere == 1u);
        let radius = space.project.w;
        let view = space.view * vec4<f32>(radius * flip * m.x, radius * m.y, radius * m.z, flip * m.w);
        return vec4<f32>(view.xyz / radius, view.w);
    }
    // Down to the eye, by its height.
    let sine = k * space.curve.z;
    m = vec4<f32>(
        m.x,
        space.curve.w * m.y - sine * m.w,
        m.z,
        space.curve.w * m.w + s * sine * m.y,
    );
    return space.view * m;
}

// Reversed depth, nearer is greater: n/d where flat, n exp(-d) over the hyperbolic distance,
// and on the sphere a line through W = 0 to the antipode.
fn clip_from_view(space: Space, v: vec4<f32>) -> vec4<f32> {
    let near = space.project.z;
    var depth = near;
    if geo_kind(space) == GEO_RAISED {
        depth = near / (v.w + space.curve.x * geo_length(v.xyz));
    } else if geo_kind(space) == GEO_SPHERE {
        depth = 0.5 * (near * v.w - v.z);
    } else if geo_kind(space) == GEO_HORIZON && space.curve.x < 0.0 {
        depth = near / (v.w + space.edge.z * geo_length(v.xyz));
    } else if geo_kind(space) == GEO_HORIZON && space.curve.x > 0.0 {
        depth = 0.5 * near * (1.0 + v.w);
    }
    return vec4<f32>(space.project.x * v.x, space.project.y * v.y, depth, -v.z);
}

// Distance from the eye in the space, in metres.
fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    let rho = geo_length(v.xyz);
    if geo_kind(space) == GEO_RAISED {
        return space.project.w * geo_asinh(rho * space.curve.x);
    }
    if geo_kind(space) == GEO_SPHERE {
        return space.project.w * geo_angle(rho * space.curve.x, v.w);
    }
    if geo_kind(space) == GEO_HORIZON && space.curve.x < 0.0 {
        return space.project.w * geo_asinh(rho * space.edge.z);
    }
    if geo_kind(space) == GEO_HORIZON && space.curve.x > 0.0 {
        return space.project.w * geo_angle(rho * space.edge.z, v.w);
    }
    return rho;
}
