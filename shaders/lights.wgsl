// Lamps and beams: light that comes from a place in the space, by the space's own distances and directions.
// Follows common.wgsl.
//
// With the lit point v, its unit normal n and the lamp l, all in view coordinates with w in radii (metres), and s the
// sign of the curvature k^2: the chord c^2 = <l - v, l - v> is (2/k sin(k d/2))^2, the sine of the distance over k is
// c sqrt(1 - s k^2 c^2/4), and the cosine between the normal and the way to the lamp is <n, l - v> over that sine.
// Nothing is divided by k but w, so the flat space is the limit.

// What a lit point needs to know of itself.
struct Lit {
    view: vec4<f32>,    // w in metres: 1/k of the model's, 0 where flat
    normal: vec4<f32>,
    sign: f32,          // of the curvature
    k: f32,             // 1/m
}

fn lit_at(space: Space, view: vec4<f32>, normal: vec4<f32>) -> Lit {
    let is_horizon = geo_kind(space) == GEO_HORIZON;
    let k = select(space.curve.x, space.edge.z, is_horizon);
    let opens = geo_kind(space) == GEO_RAISED || (is_horizon && space.curve.x < 0.0);
    // So flat, w would be rounded to nothing before it is divided.
    let curved = geo_kind(space) != GEO_FLAT && k > 1.0e-4;
    let inverse = select(0.0, 1.0 / max(k, 1.0e-4), curved);
    let own_k = select(0.0, k, curved);
    return Lit(vec4<f32>(view.xyz, view.w * inverse), normal, select(1.0, -1.0, opens), own_k);
}

fn model_dot(lit: Lit, a: vec4<f32>, b: vec4<f32>) -> f32 {
    return dot(a.xyz, b.xyz) + lit.sign * a.w * b.w;
}

// Diffuse and specular light of one lamp, before its colour.
// `reach2` is the square of the chord at which the light has faded away.
fn lamp_on(lit: Lit, toward: vec4<f32>, reach2: f32, gloss: f32) -> f32 {
    let chord2 = max(model_dot(lit, toward, toward), 1.0e-4);
    if chord2 > reach2 {
        return 0.0;
    }
    let bend = lit.sign * lit.k * lit.k * chord2 * 0.25;
    let sine = sqrt(chord2 * max(1.0 - bend, 1.0e-3));
    // asin(x)/x by its series, x^2 = bend; negative where it stands for asinh.
    let distance = sqrt(chord2) * (1.0 + bend * (0.16666667 + bend * (0.075 + bend * 0.044642857)));
    let share2 = chord2 / reach2;
    let fade = max(1.0 - share2 * share2, 0.0);
    let cosine = model_dot(lit, lit.normal, toward) / sine;
    // Light wraps a little round an edge, as from a globe that is no point.
    let diffuse = max(0.9 * cosine + 0.1, 0.0);
    // The way back to the eye is minus the view's own direction; Blinn's half way between the two.
    let back = -normalize(lit.view.xyz);
    let half_way = normalize(toward.xyz / sine + back);
    let shine = gloss * pow(max(dot(lit.normal.xyz, half_way), 0.0), 32.0);
    return fade * fade * (diffuse + shine) / (1.0 + 0.5 * distance + 0.12 * distance * distance);
}

// Light of all lamps of a mask on a point.
fn lamps_on(lit: Lit, mask: vec2<u32>, gloss: f32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    for (var half = 0u; half < 2u; half++) {
        var left = select(mask.x, mask.y, half == 1u);
        while left != 0u {
            let lamp = scene.lamps[firstTrailingBit(left) + 32u * half];
            left &= left - 1u;
            let toward = vec4<f32>(lamp.place.xyz, lamp.place.w) - lit.view;
            sum += lamp.colour.rgb * lamp_on(lit, toward, lamp.colour.w, gloss);
        }
    }
    return sum;
}

// Light of all beams of a mask on a point: full within the inner cone, none outside the outer.
fn beams_on(lit: Lit, mask: u32, gloss: f32) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    var left = mask;
    while left != 0u {
        let beam = scene.beams[firstTrailingBit(left)];
        left &= left - 1u;
        let toward = beam.place - lit.view;
        let chord2 = max(model_dot(lit, toward, toward), 1.0e-4);
        let sine = sqrt(chord2 * max(1.0 - lit.sign * lit.k * lit.k * chord2 * 0.25, 1.0e-3));
        let along = -model_dot(lit, beam.axis, toward) / sine;
        let inside = smoothstep(beam.cone.y, beam.cone.x, along);
        sum += beam.colour.rgb * (inside * lamp_on(lit, toward, beam.colour.w, gloss));
    }
    return sum;
}

fn lights_on(view: vec4<f32>, normal: vec4<f32>, mask: vec3<u32>, gloss: f32) -> vec3<f32> {
    let lit = lit_at(scene.space, view, normal);
    return lamps_on(lit, mask.xy, gloss) + beams_on(lit, mask.z, gloss);
}

// Light of the sun, the moon and all around on a point of a closed world. The cosine between the normal n and the way
// to a body s is <n, s> over the sine of the distance, n being square to the point.
// `up` is the normal's share of the way up; `share` of the light that throws shadows reaches the point.
fn orbs_on(space: Space, view: vec4<f32>, normal: vec4<f32>, up: f32, share: f32) -> vec3<f32> {
    let place = model_of(space, view);
    let near = vec2<f32>(dot(place, scene.sun_place), dot(place, scene.moon_place));
    let slant = vec2<f32>(dot(normal, scene.sun_place), dot(normal, scene.moon_place));
    let facing = slant * inverseSqrt(max(vec2<f32>(1.0) - near * near, vec2<f32>(1.0e-3)));
    let reaches = mix(vec2<f32>(share, 1.0), vec2<f32>(1.0, share), scene.shadows.key.w);
    let bounced = 0.06 * (vec2<f32>(1.0) - abs(facing)) + vec2<f32>(0.05);
    let key = 0.78 * max(facing, vec2<f32>(0.0)) * reaches + bounced * (0.4 + 0.6 * reaches);
    let day = smoothstep(NIGHT, DAY, near.x);
    // Low light has come a long way through haze: red.
    let warmth = mix(vec3<f32>(1.0, 0.42, 0.16), vec3<f32>(1.0), smoothstep(0.15, 0.9, day));
    let moonlight = smoothstep(NIGHT, DAY, near.y) * (1.0 - day);
    let ambient = mix(scene.ambient_ground.rgb, scene.ambient_sky.rgb, 0.5 + 0.5 * up);
    return scene.key_colour.rgb * warmth * (day * key.x)
        + scene.moon_colour.rgb * (moonlight * key.y)
        + ambient * mix(NIGHT_AMBIENT, vec3<f32>(1.0), day);
}

// All light but that of lamps and beams: `normal` in the chart's frame, `model_normal` in view coordinates.
// `share` as above.
fn daylight_on(space: Space, view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>, share: f32) -> vec3<f32> {
    if geo_kind(space) == GEO_SPHERE {
        return orbs_on(space, view, model_normal, normal.y, share);
    }
    return light_on(normal, share);
}

// Whether a vertex needs its normal in view coordinates.
fn wants_model_normal(space: Space, lights: vec3<u32>) -> bool {
    return geo_kind(space) == GEO_SPHERE || any(lights != vec3<u32>(0u));
}
