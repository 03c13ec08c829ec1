// What all maps of the space share: how the space is told to the shaders, and what is made of a map's own functions.
//
// Mirrors crates/geometry; docs/geometry.md has the mathematics. No entry points and no bindings. Behind this file
// stands that of one map, of shaders/spaces, which defines just these functions:
//
//   port(space, p)             a chart point, in metres from the reference, as a point of the model: xyz in metres and w
//                              without unit
//   port_normal(space, p, n)   a chart normal as a unit covector of the space, in the coordinates of the chart's frame at
//                              the point, whose y is up: its dot product with a light's chart direction is N.L. It is
//                              normalised there, in three dimensions: under the model's inner product f32 would lose it
//   frame_vector(space, p, n)  a vector of that frame, as port_normal gives them, in view coordinates, x, y, z and w
//                              without unit: a unit vector of the model's tangent space for a unit vector of the frame
//   depth_of(space, v)         the third clip coordinate of a view point: depth is reversed, nearer is greater
//   eye_distance(space, v)     distance from the eye in the space, in metres
//   curvature_of(space)        its sign, 1 where flat, and its root per metre
//
// None knows of charts: `space.view` and `space.origin` are those of the chart whose points it is asked about. Every other name but the struct's
// and those of the functions here begins with `geo_`. Sines, cosines and their kin are those of trigonometry.wgsl, which
// stands in front. View coordinates are x right, y up, z back in metres and w without unit.

struct Space {
    // Applied to the ported point, xyz in metres and w without unit.
    view: mat4x4<f32>,
    focal_x: f32,
    focal_y: f32,
    near_m: f32,
    radius_m: f32,      // 0 where flat
    kappa: f32,         // curvature per square metre, negative where hyperbolic
    // How high the eye's map lies over its sheet: radii on the raised map, metres on the horizon, and its sine and cosine
    // of the space's kind: sinh and cosh, or S and C of kappa.
    lift: f32,
    lift_sine: f32,
    lift_cosine: f32,
    // How far a chart is drawn: along its ground from the reference, and up and down.
    level_m: f32,
    upright_m: f32,
    k_per_m: f32,       // root of |kappa|
    padding: f32,
    // Where the reference lies in its chart, for maps that depend on it: of squares X/W and Z/W, and W on the ground.
    origin: vec4<f32>,
}

// Squares of lengths between this and its reciprocal neither overflow nor vanish.
const GEO_SQUARABLE: f32 = 1.0e15;
// Lengths of frame vectors are told within this distance of the map's centre, in radii; farther off they keep the
// direction of that place, so that nothing overflows.
const GEO_FAR_FRAME: f32 = 12.0;

// Metres by which a point lies beyond what its chart is drawn of; far below zero where all is.
fn geo_beyond_edge(space: Space, p: vec3<f32>) -> f32 {
    return max(length(p.xz) - space.level_m, abs(p.y + space.lift) - space.upright_m);
}

// A chart point in view coordinates. p is in metres relative to the reference.
fn port_to_view(space: Space, p: vec3<f32>) -> vec4<f32> {
    return space.view * port(space, p);
}

// Clip coordinates of a view point.
fn clip_from_view(space: Space, v: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(space.focal_x * v.x, space.focal_y * v.y, depth_of(space, v), -v.z);
}

// (sinc - 1)/s of the sign `flip` belongs to, from a sinc already known where that does not cancel.
fn geo_bend(s: f32, flip: f32, sinc: f32) -> f32 {
    let direct = (sinc - 1.0) / max(s, 1.0);
    return select(direct, geo_sinc_bend(s, flip), s < 4.0 || flip < 0.0);
}

// The normal of a cylindrical chart: s is the level distance squared times the curvature, u the point in the unit in which
// `scale` is the curvature's size, and `upright` the cosine of the height.
fn geo_normal_cylindrical(n: vec3<f32>, u: vec3<f32>, s: f32, upright: f32, flip: f32, scale: f32) -> vec3<f32> {
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

// A frame vector of a cylindrical chart in its model, at a place and a height in radii: at level distance r and height y
// with s the sign of the curvature, the derivatives along r, across and along y of (C(y) S(r), S(y), C(y) C(r)).
fn geo_frame_cylindrical(n: vec3<f32>, level: vec2<f32>, height: f32, s: f32) -> vec4<f32> {
    let u = level * min(1.0, GEO_FAR_FRAME / max(length(level), 1e-6));
    let r2 = dot(u, u);
    let round = geo_sine_cosine(s * r2);
    let upright = geo_sine_cosine(s * height * height);
    let rise = clamp(height, -GEO_FAR_FRAME, GEO_FAR_FRAME) * upright.x;
    let along = n.x * u.x + n.z * u.y;
    // (C(r) - 1)/r^2 = -s/2 sinc(r/2)^2.
    let half = geo_sine_cosine(0.25 * s * r2).x;
    let turn = -0.5 * s * half * half * along - s * rise * round.x * n.y;
    return vec4<f32>(
        n.x + turn * u.x,
        upright.y * n.y,
        n.z + turn * u.y,
        -s * (round.x * along + rise * round.y * n.y),
    );
}
