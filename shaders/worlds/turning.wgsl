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

// Grain is read in one of three ways: about a corner, along an edge, and as it is written within the square. Reach from a corner
// and from an edge, metres, and by how much those borders are ragged.
const CORNER_M: f32 = 6.0;
const EDGE_M: f32 = 3.0;
const RAGGED_M: f32 = 1.2;
// E(1) to E(4) of E(j): turned by j fifths of a turn. E(5) is E(0).
const FIRST: vec2<f32> = vec2<f32>(0.30901699, 0.95105652);
const SECOND: vec2<f32> = vec2<f32>(-0.80901699, 0.58778525);
const THIRD: vec2<f32> = vec2<f32>(-0.80901699, -0.58778525);
const FOURTH: vec2<f32> = vec2<f32>(0.30901699, -0.95105652);

// E(j). Not by a list: one that a number says where to read lies in memory.
fn fifths(j: u32) -> vec2<f32> {
    let first = select(vec2<f32>(1.0, 0.0), FIRST, j == 1u);
    let second = select(first, SECOND, j == 2u);
    let third = select(second, THIRD, j == 3u);
    return select(third, FOURTH, j == 4u);
}

fn ragged(at: vec2<f32>) -> f32 {
    let waves = fract(vec2<f32>(0.131 * at.x + 0.059 * at.y, 0.094 * at.y - 0.145 * at.x));
    return RAGGED_M * (abs(2.0 * waves.x - 1.0) + abs(2.0 * waves.y - 1.0) - 1.0);
}

// All squares at an edge or a corner read the same. Sides are counted from +x by quarter turns towards +z, and corner n is between
// the sides n and n + 1. With the ways u from side n and v from side n + 1, metres, and the way a along the nearest side, which
// grows by quarter turns as the count does:
//   about a corner   v E(j) + u E(j + 1), E(j) being j fifths of a turn, where the square is the j-th about it
//   along an edge    (u, a), which is (-u, -a) from the other side
fn grain_place(p: vec2<f32>) -> vec2<f32> {
    let away = 0.5 * (chart.domain_high - chart.domain_low) - abs(p);
    let is_right = p.x > 0.0;
    let is_below = p.y > 0.0;
    let corner = select(select(2u, 3u, is_right), select(1u, 0u, is_right), is_below);
    let j = min((chart.joins >> (4u + 3u * corner)) & 7u, 4u);
    // Side n is that at x where n is even.
    let u = select(away.y, away.x, (corner & 1u) == 0u);
    let v = select(away.x, away.y, (corner & 1u) == 0u);
    let about = v * fifths(j) + u * fifths(j + 1u);

    let is_side_x = away.x < away.y;
    let side = select(select(3u, 1u, is_below), select(2u, 0u, is_right), is_side_x);
    let along = select(select(p.x, -p.x, is_below), select(-p.y, p.y, is_right), is_side_x);
    let sign = select(1.0, -1.0, ((chart.joins >> side) & 1u) == 1u);
    let beside = sign * vec2<f32>(min(away.x, away.y), along);
    let is_at_edge = min(away.x, away.y) < EDGE_M + ragged(beside);
    let is_at_corner = length(about) < CORNER_M + ragged(about);
    return select(select(p, beside, is_at_edge), about, is_at_corner);
}

fn grain_at(grain: vec3<f32>) -> vec3<f32> {
    let at = grain_place(grain.xz);
    return vec3<f32>(at.x, grain.y, at.y);
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
