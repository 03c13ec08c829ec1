// Lamps and beams: light that comes from a place in the space, by the space's own distances and directions.
// Follows common.wgsl.
//
// How the light of the day falls is another matter under a sky than in a closed world: a file of shaders/worlds, behind
// shadow.wgsl, defines just these functions. `share` of the light that throws shadows reaches a point; places and normals
// are given in the common axes and, where they are wanted, normals in view coordinates (`model_normal`).
//
//   in_common_axes(v)                 a vector of the chart in the axes in which all that is drawn tells light and places from
//                                     the reference: those of the first chart, or where charts have none in common its own
//   in_sky_axes(p, v)                 a vector of the chart's frame at a place, metres from the reference, in the axes in which the
//                                     light from a sky is told
//   grain_point(wrapped, p)           where grain is read at a vertex: a place that is wrapped as grain repeats, or one from p, metres
//                                     from the reference in the chart
//   grain_at(grain)                   and at a point between vertices, from what grain_point gives those
//   grain_up(grain)                   which way is up where grain is read
//   tilted(normal, model_normal, ..)  both normals of a surface that slopes so in the grain's axes
//   haze_before(view)                 the haze before a view point
//   daylight_on(view, normal, ..)     all light but that of lamps and beams, where so much of the sky is left
//   wants_model_normal(lights)        whether a vertex needs its normal in view coordinates
//   land_light(view, normal, ..)      what a vertex of land tells its fragments of the day's light
//   daylit(light, albedo, share)      what those make of it
//   land_sky(light)                  how much of the sky that says there is, where it says so, and else all of it
//   is_land_unlit(light, ..)          and whether it says that is_unlit
//   seen_normal(view, normal, ..)     the normal as one sees it, to be compared with directions at the eye
//   from_ring(place, view)            how far a point is from the middle of the ring, in metres of the chart
//   is_unlit(view, normal, ..)        whether a point turns away from the light that throws shadows, or lies where that does
//                                     not reach
//   caster_point(p)                   a point of the chart as a shadow map takes it, before `chart.home`
//   shadow_place(place, view)         which of the two `shaded_at` asks; that may be given as both
//   shaded_at(place, view, ..)        what shadow maps are asked about a fragment. To be called before it may be discarded.
//                                     Places are told apart there and not on a map, which would save two products of three:
//                                     near the eye a pixel is a hundredth of a texel, and what rounding leaves of the
//                                     difference is noise
//   shadow_away(point, number)        how far from a map's middle a point falls on it: 1 at its edge
//   on_map(clip, x, y)                a point on a map's plane, from clip coordinates there and their changes
//   land_shadow(point, pixel)         share of the key light that land lets through to a point
//
// With the lit point v, its unit normal n and the lamp l, all in view coordinates with w in radii (metres), and s the
// sign of the curvature k^2: the square of the chord c, <l - v, l - v>, is (2/k sin(k d/2))^2, the sine of the distance over k is
// c sqrt(1 - s k^2 c^2/4), and the cosine between the normal and the way to the lamp is <n, l - v> over that sine.
// Nothing is divided by k but w, so the flat space is the limit.

// Whether any lamp or beam may light what is drawn. In software a loop that ends at once costs a round of it, and so what
// none lights is drawn by pipelines without them.
override LIT: bool = true;

fn any_lit(lights: vec3<u32>) -> bool {
    return LIT && any(lights != vec3<u32>(0u));
}

// What a vertex of land tells its fragments of the day's light.
struct LandLight {
    facing: vec3<f32>,
    dark: vec3<f32>,
}

// How much the grain and the view change to the next pixels.
struct Steps {
    grain_x: vec3<f32>,
    grain_y: vec3<f32>,
    view_x: vec4<f32>,
    view_y: vec4<f32>,
}

// A normal in the common axes and in view coordinates.
struct Tilted {
    normal: vec3<f32>,
    model_normal: vec4<f32>,
}

// What a lit point needs to know of itself.
struct Lit {
    view: vec4<f32>,    // w in metres: 1/k of the model's, 0 where flat
    normal: vec4<f32>,
    sign: f32,          // of the curvature
    k: f32,             // 1/m
}

fn lit_at(space: Space, view: vec4<f32>, normal: vec4<f32>) -> Lit {
    let curvature = curvature_of(space);
    // So flat, w would be rounded to nothing before it is divided.
    let curved = curvature.y > 1.0e-4;
    let inverse = select(0.0, 1.0 / max(curvature.y, 1.0e-4), curved);
    return Lit(vec4<f32>(view.xyz, view.w * inverse), normal, curvature.x, select(0.0, curvature.y, curved));
}

fn model_dot(lit: Lit, a: vec4<f32>, b: vec4<f32>) -> f32 {
    return dot(a.xyz, b.xyz) + lit.sign * a.w * b.w;
}

// The chord to a lamp, squared, and how far off the lamp is, squared: d^2 = c^2 (1 + b/3 + 8 b^2/45) to within a
// thousandth for |b| < 0.4, where b = s k^2 c^2/4 (asin^2 by its series, or asinh^2 where b is negative).
// The sine is sin(k d)/k = c sqrt(1 - b).
struct Away {
    chord2: f32,
    distance2: f32,
    sine: f32,
}

fn away(lit: Lit, toward: vec4<f32>) -> Away {
    let chord2 = max(model_dot(lit, toward, toward), 1.0e-4);
    let bend = lit.sign * lit.k * lit.k * 0.25 * chord2;
    let distance2 = chord2 * (1.0 + bend * (0.33333333 + bend * 0.17777778));
    return Away(chord2, distance2, sqrt(chord2 * max(1.0 - bend, 1.0e-3)));
}

// The share of a lamp's light that comes through so far, times the sine of the distance: zero where it has faded away.
// `fades` is one over the square of the chord at which it has.
fn through(at: Away, fades: f32) -> f32 {
    let share2 = at.chord2 * fades;
    let fade = max(1.0 - share2 * share2, 0.0);
    return fade * fade / (at.sine * (1.0 + 0.24 * at.distance2));
}

// Diffuse light of one lamp times the sine of the distance, which `through` divides by. Light wraps a little round an
// edge, as from a globe that is no point.
fn diffuse_of(lit: Lit, toward: vec4<f32>, at: Away) -> f32 {
    return max(0.9 * model_dot(lit, lit.normal, toward) + 0.1 * at.sine, 0.0);
}

// Specular light, also times the sine: by the cosine between the normal n and Blinn's half way between the unit ways a
// to the lamp and b to the eye, (<n, a> + <n, b>) / sqrt(2 + 2 <a, b>). With the chords A and B to both, which leave the
// space at v where a and b do not, <a, b> is (<A, B> - s k^2 A^2/2 B^2/2) over both sines, as <A, v> = -A^2/2. Far off in
// an open space the numbers of a vector are huge, so that nothing may be told by their first three alone.
fn shine_of(lit: Lit, toward: vec4<f32>, at: Away) -> f32 {
    let eye_w = select(0.0, 1.0 / max(lit.k, 1.0e-4), lit.k > 0.0);
    let back = vec4<f32>(0.0, 0.0, 0.0, eye_w) - lit.view;
    let to_eye = away(lit, back);
    let sines = at.sine * to_eye.sine;
    let bend = lit.sign * lit.k * lit.k * 0.25 * at.chord2 * to_eye.chord2;
    let between = clamp((model_dot(lit, toward, back) - bend) / sines, -0.999, 1.0);
    let both = model_dot(lit, lit.normal, toward) / at.sine + model_dot(lit, lit.normal, back) / to_eye.sine;
    let half_way = clamp(both * inverseSqrt(2.0 + 2.0 * between), 0.0, 1.0);
    return at.sine * pow(half_way, 32.0);
}

// The number of a bit that stands alone, by the exponent of its value: where vectors of integers are counted one by
// one this is quicker than counting.
fn number_of(bit: u32) -> u32 {
    return (bitcast<u32>(f32(bit)) >> 23u) - 127u;
}

// Longest edge of land of the finest level, metres.
const LONGEST_EDGE: f32 = 1.75;
// Light of lamps farther off than this changes little over such an edge and is worked out at the corners of triangles;
// nearer than the first it is worked out at each point, and between the two partly so. Metres.
const SMOOTH_FROM: vec2<f32> = vec2<f32>(2.5, 5.0);

// The share of a lamp's light that is worked out at each point.
fn point_share(at: Away) -> f32 {
    return 1.0 - smoothstep(SMOOTH_FROM.x * SMOOTH_FROM.x, SMOOTH_FROM.y * SMOOTH_FROM.y, at.chord2);
}

// Light of all lamps of a mask on a point. Land, whose gloss is 0, is matt and so spared the highlights, and has the
// light of far lamps from its corners.
fn lamps_on(lit: Lit, mask: vec2<u32>, gloss: f32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    for (var half = 0u; half < 2u; half++) {
        var left = select(mask.x, mask.y, half == 1u);
        while left != 0u {
            let rest = left & (left - 1u);
            let lamp = scene.lamps[number_of(left ^ rest) + 32u * half];
            left = rest;
            let toward = lamp.place - lit.view;
            let at = away(lit, toward);
            var light = diffuse_of(lit, toward, at);
            if gloss > 0.0 {
                light += gloss * shine_of(lit, toward, at);
            } else {
                light *= point_share(at);
            }
            sum += lamp.colour * (through(at, lamp.fades_per_m2) * light);
        }
    }
    return sum;
}

// What lamps are to a triangle, as told by one of its corners.
struct Lamplight {
    near: vec3<u32>,    // lamps to be worked out at each point, and beams
    far: vec3<f32>,     // light of those that are not, or the share of it that is not
}

// Parts a chunk's lamps at a corner. Its mask's third number holds the beams in the lower half and the level of detail
// above.
fn lamplight_at(space: Space, view: vec4<f32>, normal: vec4<f32>, mask: vec3<u32>) -> Lamplight {
    let lit = lit_at(space, view, normal);
    let close = SMOOTH_FROM.y + LONGEST_EDGE * f32(1u << (mask.z >> 16u));
    var light = Lamplight(vec3<u32>(0u, 0u, mask.z & 0xffffu), vec3<f32>(0.0));
    for (var half = 0u; half < 2u; half++) {
        var left = select(mask.x, mask.y, half == 1u);
        while left != 0u {
            let rest = left & (left - 1u);
            let bit = left ^ rest;
            left = rest;
            let lamp = scene.lamps[number_of(bit) + 32u * half];
            let toward = lamp.place - lit.view;
            let at = away(lit, toward);
            let near = select(0u, bit, at.chord2 < close * close);
            light.near.x |= select(near, 0u, half == 1u);
            light.near.y |= select(0u, near, half == 1u);
            let share = (1.0 - point_share(at)) * through(at, lamp.fades_per_m2);
            light.far += lamp.colour * (share * diffuse_of(lit, toward, at));
        }
    }
    return light;
}

// Light of all beams of a mask on a point: full within the inner cone, none outside the outer.
fn beams_on(lit: Lit, view: vec4<f32>, mask: u32, gloss: f32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    var left = mask;
    while left != 0u {
        let beam = scene.beams[firstTrailingBit(left)];
        left &= left - 1u;
        // Light that has come by a door begins there.
        if dot(beam.behind, view) < 0.0 {
            continue;
        }
        let toward = beam.place - lit.view;
        let at = away(lit, toward);
        let along = -model_dot(lit, beam.axis, toward) / at.sine;
        let inside = smoothstep(beam.dark_cosine, beam.full_cosine, along);
        var light = diffuse_of(lit, toward, at);
        if gloss > 0.0 {
            light += gloss * shine_of(lit, toward, at);
        }
        sum += beam.colour * (inside * through(at, beam.fades_per_m2) * light);
    }
    return sum;
}

fn lights_on(view: vec4<f32>, normal: vec4<f32>, mask: vec3<u32>, gloss: f32) -> vec3<f32> {
    let lit = lit_at(scene.space, view, normal);
    return lamps_on(lit, mask.xy, gloss) + beams_on(lit, view, mask.z, gloss);
}
