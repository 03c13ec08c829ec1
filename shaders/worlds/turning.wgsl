// Charts of squares, which have no axes in common: what is near the eye is told in view coordinates, and light in axes that
// turn from place to place, one of which points to the ideal point in the north. docs/geometry.md has the mathematics.

// As they are: metres of a chart from its own reference.
fn in_common_axes(v: vec3<f32>) -> vec3<f32> {
    return v;
}

// With the point P of the ground and the null vector (n, 1) of the north, whose product with P is -1/g, the way there is
// g (n, 1) - P, and in the frame at P `g n - (X, Z)(1 + g)/(1 + W)`. North is -x, as everywhere.
fn in_sky_axes(p: vec3<f32>, v: vec3<f32>) -> vec3<f32> {
    let at = geo_ground(space_of_chart(), p).at;
    let w = geo_ground_w(at);
    let here = w * at;
    let g = 1.0 / max(w - dot(here, chart.north.xy), 1.0e-6);
    let north = normalize(g * chart.north.xy - here * ((1.0 + g) / (1.0 + w)));
    return vec3<f32>(-dot(north, v.xz), v.y, north.y * v.x - north.x * v.z);
}

// From the middle of the square.
fn grain_point(wrapped: vec3<f32>, p: vec3<f32>) -> vec3<f32> {
    let middle = 0.5 * (chart.domain_low + chart.domain_high);
    return vec3<f32>(p.x - middle.x, wrapped.y, p.z - middle.y);
}

// Within this of an edge grain is read by the edges, metres; with what makes the border ragged.
const BY_EDGES_M: f32 = 5.0;
const RAGGED_M: f32 = 1.8;
// On both sides of that border grain fades away over so many metres, until a pixel seems as wide as this.
const SEAM_M: f32 = 0.35;
const SEAM_WIDE_M: f32 = 0.5;

fn edges_away(grain: vec3<f32>) -> vec2<f32> {
    return 0.5 * (chart.domain_high - chart.domain_low) - abs(grain.xz);
}

// How far a place lies within the border, metres; less than 0 in the strip along the edges.
fn within_border(grain: vec3<f32>) -> f32 {
    let away = edges_away(grain);
    let ragged = sin(0.83 * grain.x + 0.37 * grain.z) + sin(0.59 * grain.z - 0.91 * grain.x + 1.3);
    return min(away.x, away.y) - BY_EDGES_M - 0.5 * RAGGED_M * ragged;
}

// As it is written in the square; and along the edges how far it is to the nearest ones along x and z, the lesser first: these are
// the same from both sides of an edge and from all five of a corner, whichever way squares are turned there.
fn grain_at(grain: vec3<f32>) -> vec3<f32> {
    if within_border(grain) > 0.0 {
        return grain;
    }
    let away = edges_away(grain);
    return vec3<f32>(min(away.x, away.y), grain.y, max(away.x, away.y));
}

fn grain_seam(grain: vec3<f32>) -> f32 {
    return SEAM_WIDE_M * max(1.0 - abs(within_border(grain)) / SEAM_M, 0.0);
}

// By the slope along the ground, as in a closed world: near the eye, where slopes are seen, view coordinates are those of the
// sky's axes at the eye.
fn tilted(normal: vec3<f32>, model_normal: vec4<f32>, slope: vec3<f32>, steps: Steps) -> Tilted {
    let a = steps.view_x.xyz;
    let b = steps.view_y.xyz;
    let rise = vec2<f32>(dot(slope, steps.grain_x), dot(slope, steps.grain_y));
    let aa = dot(a, a);
    let ab = dot(a, b);
    let bb = dot(b, b);
    let inverse = 1.0 / max(aa * bb - ab * ab, 1e-14);
    let along = (a * (bb * rise.x - ab * rise.y) + b * (aa * rise.y - ab * rise.x)) * inverse;
    let held = along * min(1.0, 1.6 * inverseSqrt(max(dot(along, along), 1e-8)));
    let turned = scene.right * held.x + scene.up * held.y - scene.front * held.z;
    return Tilted(normalize(normal - turned), model_normal);
}

fn from_ring(place: vec3<f32>, view: vec4<f32>) -> vec3<f32> {
    return (view - scene.ring_centre) * mat3x4<f32>(scene.ring_x, scene.ring_y, scene.ring_z);
}

// The space itself: `chart.home` takes it to the model of the eye's chart.
fn caster_point(p: vec3<f32>) -> vec4<f32> {
    return port(space_of_chart(), p);
}

fn shadow_place(place: vec3<f32>, view: vec4<f32>) -> vec4<f32> {
    return view;
}

fn shaded_at(place: vec3<f32>, view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> Shaded {
    if SHADOWS == 0u {
        return NOT_SHADED;
    }
    let faced = surely_faced(dot(normalize(normal), scene.key_direction));
    return Shaded(view, dpdx(view), dpdy(view), faced, 1.0);
}

fn shadow_away(point: Shaded, number: u32) -> f32 {
    let c = scene.shadows.maps[number].clip * point.at;
    let at = c.xy / max(c.w, 1e-6);
    return select(2.0, max(abs(at.x), abs(at.y)), c.w > 0.0);
}

fn on_map(c: vec4<f32>, x: vec4<f32>, y: vec4<f32>) -> OnMap {
    // A map that is not there yet is all zero, and trusted by nothing.
    let inverse = 1.0 / select(c.w, 1e-6, abs(c.w) < 1e-6);
    let at = c.xyz * inverse;
    return OnMap(at, (x.xyz - at * x.w) * inverse, (y.xyz - at * y.w) * inverse, inverse);
}
