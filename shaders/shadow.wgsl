// Shadows of the key light: how what throws them is drawn into maps of depth, and how those are read.
// Follows common.wgsl.
//
// A map's matrix takes what a fragment knows of its place to the map: chart metres where the light comes from one
// direction of the chart, and view coordinates where it comes from a point of a closed world: `shaded_at`. Both are linear over a
// triangle as it was authored, and so are the map's coordinates and depth: a point is compared with its own surface
// exactly, and no acne is to be hidden but that of surfaces that bend within a texel.

// 0: no shadows; 1: soft over a texel; 2: over five.
override SHADOWS: u32 = 0u;
// Whether figures may throw any on what is drawn. In software a branch costs what it leaves out: what no shadow of a
// figure, or none at all, can fall on is drawn by pipelines without what reads it.
override FIGURE_SHADOWS: bool = true;

const SHADOW_CASCADES: u32 = 3u;
const SHADOW_FIGURES: u32 = 7u;
// How far a cascade is read, as a part of its half side, and over which part of that it goes over to the next.
const SHADOW_EDGE: f32 = 0.86;
const SHADOW_BLEND: f32 = 0.16;
// Depths of a texel that a surface may be off where it bends, up to which slope that grows, and the steepest slopes that
// are followed at low and at high quality. At low, texels are wide, and what is steeper yet is not told from the edge of
// a shadow: followed to 10, vertical walls let light through.
const SHADOW_BIAS: f32 = 0.75;
const SHADOW_BIASED: f32 = 10.0;
const SHADOW_STEEPEST_LOW: f32 = 6.0;
const SHADOW_STEEPEST_HIGH: f32 = 32.0;
// Depths of a texel that a triangle which strays from its normals may lie below what it strays from.
const SHADOW_STRAY: f32 = 16.0;

struct Caster {
    clip: mat4x4<f32>,  // from what `caster_point` makes of the first chart's points
    curvature_per_m: f32,
    rim_m: f32,        // where a chart's land ends, from its middle
}

@group(0) @binding(2) var shadow_maps: texture_depth_2d_array;
@group(0) @binding(3) var shadow_sampler: sampler;
@group(3) @binding(0) var<uniform> caster: Caster;

// Where a point of the chart falls on the map that is being drawn.
fn caster_clip(p: vec3<f32>) -> vec4<f32> {
    return caster.clip * (chart.home * caster_point(p));
}

// What a fragment knows of its place, and how that changes to the next pixel on the right and below.
struct Shaded {
    at: vec4<f32>,
    x: vec4<f32>,
    y: vec4<f32>,
    faced: f32,        // how surely its normals face the light, 0 to 1
    open: f32,         // the share of the light that reaches it where no map tells: little of it without a sky
}

const NOT_SHADED: Shaded = Shaded(vec4<f32>(0.0), vec4<f32>(0.0), vec4<f32>(0.0), 0.0, 1.0);

// From the cosine to the light. What turns to it by less is dim, and triangles of steep land stray from their normals as
// far as that.
fn surely_faced(cosine: f32) -> f32 {
    return smoothstep(0.25 * FACING, 0.75 * FACING, cosine);
}

// The share of the key light that what slopes in a surface's detail may have: none where the surface itself turns away. Maps are not
// asked there, and in a cave every slope to the sun would shine.
fn detail_share(point: Shaded) -> f32 {
    return select(point.faced, 1.0, SHADOWS == 0u);
}

// What reaches a place of so much sky as far as no map tells: deep below untouched land there is no sun.
fn open_to(point: Shaded, sky: f32) -> Shaded {
    var told = point;
    told.open = smoothstep(DEEPEST_SKY, DEEPEST_SKY + 0.35, sky);
    return told;
}

fn chosen(rows: array<vec4<f32>, 3>, number: u32) -> vec4<f32> {
    return select(select(rows[1], rows[2], number == 2u), rows[0], number == 0u);
}

fn scalars_of(map: ShadowMap) -> vec4<f32> {
    return vec4<f32>(map.layer, map.texel_depth, map.weight, map.hand);
}

// One of the cascades. Numbers that differ from pixel to pixel are dear to look up with in software.
fn cascade(number: u32) -> ShadowMap {
    let a = scene.shadows.maps[0];
    let b = scene.shadows.maps[1];
    let c = scene.shadows.maps[2];
    let clip = mat4x4<f32>(
        chosen(array<vec4<f32>, 3>(a.clip[0], b.clip[0], c.clip[0]), number),
        chosen(array<vec4<f32>, 3>(a.clip[1], b.clip[1], c.clip[1]), number),
        chosen(array<vec4<f32>, 3>(a.clip[2], b.clip[2], c.clip[2]), number),
        chosen(array<vec4<f32>, 3>(a.clip[3], b.clip[3], c.clip[3]), number),
    );
    let rest = chosen(array<vec4<f32>, 3>(scalars_of(a), scalars_of(b), scalars_of(c)), number);
    return ShadowMap(clip, rest.x, rest.y, rest.z, rest.w);
}

// A point on a map's plane, how that changes to the next pixel, and one over its clip coordinate w.
struct OnMap {
    at: vec3<f32>,
    x: vec3<f32>,
    y: vec3<f32>,
    inverse: f32,
}

// Where a point is on a map, in texels and depth, and how depth changes from texel to texel on its own surface.
struct Placed {
    texel: vec2<f32>,
    depth: f32,
    slope: vec2<f32>,
    joined: f32,   // what is seen to slope less is one surface
    turned: f32,   // share of the light that is lost since its surface turns away
}

fn placed_on(point: Shaded, map: ShadowMap) -> Placed {
    let on = on_map(map.clip * point.at, map.clip * point.x, map.clip * point.y);
    let s = on.at;
    let dx = on.x;
    let dy = on.y;
    let texel = map.texel_depth * on.inverse;
    let size = scene.shadows.side_texels;
    let to_texels = vec2<f32>(0.5, -0.5) * size;
    let ax = dx.xy * to_texels;
    let ay = dy.xy * to_texels;
    let area = ax.x * ay.y - ax.y * ay.x;
    let slope = vec2<f32>(ay.y * dx.z - ax.y * dy.z, ax.x * dy.z - ay.x * dx.z);
    let joined = SHADOW_STEEPEST_HIGH * texel;
    let steepest = select(SHADOW_STEEPEST_HIGH, SHADOW_STEEPEST_LOW, SHADOWS == 1u) * texel;
    let safe = select(area, 1e-12, abs(area) < 1e-12);
    let g = clamp(slope / safe, vec2<f32>(-steepest), vec2<f32>(steepest));
    let bias = SHADOW_BIAS * min(length(vec3<f32>(g, texel)), SHADOW_BIASED * texel);
    // Surfaces are seen from their front: one that the light sees the other way round shades itself. Compared with
    // its own depth it would be striped, since that is then the far side of what the map holds.
    if area * map.hand < 0.0 {
        // One whose normals face the light strays from them, as seams between levels of detail do and thin triangles,
        // and its plane is none of the land's: it is to look as the land beside it.
        let stray = s.z + SHADOW_STRAY * texel;
        return Placed(s.xy * to_texels + 0.5 * size, stray, vec2<f32>(0.0), joined, 1.0 - point.faced);
    }
    return Placed(s.xy * to_texels + 0.5 * size, s.z + bias, g, joined, 0.0);
}

// Which of four texels let light through, from below on the left against the clock, as they are gathered; `own` is the
// depth of the point's plane at the upper left one, and `away` where the point is from there, in texels.
fn gathered(corner: vec2<f32>, layer: f32, own: f32, away: vec2<f32>, placed: Placed) -> vec4<f32> {
    let found = textureGather(shadow_maps, shadow_sampler, corner * scene.shadows.texel, u32(layer));
    let slope = placed.slope;
    let plane = own + vec4<f32>(slope.y, slope.x + slope.y, slope.x, 0.0);
    // Where nothing was drawn the map holds 0, and land may lie deeper than that: under a figure on a cliff.
    var free = max(plane, vec4<f32>(0.0)) >= found;
    // In a hollow, land beside the point rises over the point's plane and is no roof: continued to the point, as it is
    // seen to slope between the texels, it passes below. What slopes more is the edge of something else.
    let across = found.yyzz - found.xxww;
    let down = found.xyyx - found.wzzw;
    let ahead = vec4<f32>(away.x, away.x - 1.0, away.x - 1.0, away.x);
    let below = vec4<f32>(away.y - 1.0, away.y - 1.0, away.y, away.y);
    let passes = found + across * ahead + down * below <= vec4<f32>(placed.depth);
    let joined = abs(across) + abs(down) < vec4<f32>(placed.joined);
    free = free | (passes & joined);
    return select(vec4<f32>(0.0), vec4<f32>(1.0), free);
}

// A square of texels round a point, and what is known of the point.
struct Square {
    first: vec2<f32>,   // the texel below on the left
    layer: f32,
    away: vec2<f32>,    // where the point is from that texel's middle
    here: f32,          // depth of the point's plane there
    placed: Placed,
}

// Of four texels, so many from the first, those that let light through: each counts by its share along both sides.
fn four_of(square: Square, step: vec2<f32>, wx: vec2<f32>, wy: vec2<f32>) -> f32 {
    let own = square.here + dot(square.placed.slope, step);
    let free = gathered(square.first + step + 1.0, square.layer, own, square.away - step, square.placed);
    return dot(free, vec4<f32>(wx.x * wy.y, wx.y * wy.y, wx.y * wy.x, wx.x * wy.x));
}

// Six texels beside each other, in two rows, and whole but for what a side cuts off.
fn twelve_of(square: Square, up: f32, part: f32, wy: vec2<f32>) -> f32 {
    return four_of(square, vec2<f32>(0.0, up), vec2<f32>(1.0 - part, 1.0), wy)
        + four_of(square, vec2<f32>(2.0, up), vec2<f32>(1.0, 1.0), wy)
        + four_of(square, vec2<f32>(4.0, up), vec2<f32>(1.0, part), wy);
}

// Share of the light that a map lets through to a point: each texel is compared with the plane of the point's own
// surface where the texel's middle is, and counts by its share of a square round the point: over one texel along each side at
// low quality, over five at high.
fn shadow_read(point: Shaded, map: ShadowMap) -> f32 {
    let placed = placed_on(point, map);
    let base = floor(placed.texel - 0.5);
    let part = placed.texel - 0.5 - base;
    let first = base - select(2.0, 0.0, SHADOWS == 1u);
    let away = placed.texel - 0.5 - first;
    let square = Square(first, map.layer, away, placed.depth - dot(placed.slope, away), placed);
    var lit: f32;
    // No loop: adapters hardly unroll those that a guard is put into.
    if SHADOWS == 1u {
        lit = four_of(square, vec2<f32>(0.0), vec2<f32>(1.0 - part.x, part.x), vec2<f32>(1.0 - part.y, part.y));
    } else {
        lit = 0.0;
        for (var row = 0u; row < 3u; row++) {
            let wy = vec2<f32>(select(1.0, 1.0 - part.y, row == 0u), select(1.0, part.y, row == 2u));
            lit += twelve_of(square, f32(2u * row), part.x, wy) * (1.0 / 25.0);
        }
    }
    return mix(point.open, lit * (1.0 - placed.turned), map.weight);
}

// Which pixels show the next map where one ends, by a fixed noise from 0 to 1 (Jimenez, 2014).
fn shadow_noise(pixel: vec2<f32>) -> f32 {
    return fract(52.9829189 * fract(dot(pixel, vec2<f32>(0.06711056, 0.00583715))));
}

// How far a map has given way to the next: 0 inside, 1 at the end of what is read of it.
fn shadow_end(away: f32) -> f32 {
    return clamp((away - SHADOW_EDGE) / SHADOW_BLEND + 1.0, 0.0, 1.0);
}

// Share of the key light that a map and the next let through, where one gives way to the other. Low quality reads one
// of them in each pixel.
fn either(point: Shaded, near: ShadowMap, next: ShadowMap, end: f32) -> f32 {
    let read = shadow_read(point, near);
    if end <= 0.0 {
        return read;
    }
    return mix(read, shadow_read(point, next), end);
}

// Share of the key light that figures let through to a point.
fn figure_shadow(point: Shaded) -> f32 {
    let away = shadow_away(point, SHADOW_FIGURES);
    if away >= 1.0 {
        return 1.0;
    }
    return mix(shadow_read(point, scene.shadows.maps[SHADOW_FIGURES]), 1.0, shadow_end(away));
}

// Share of the key light that the maps let through to a point; one that is unlit is left as it is.
fn key_through(point: Shaded, pixel: vec2<f32>, unlit: bool, by_figures: bool) -> f32 {
    if SHADOWS == 0u || unlit {
        return 1.0;
    }
    var lit = land_shadow(point, pixel);
    if FIGURE_SHADOWS && by_figures {
        lit = min(lit, figure_shadow(point));
    }
    return lit;
}

// Share of the key light that reaches a point.
fn key_share(point: Shaded, pixel: vec2<f32>, unlit: bool, by_figures: bool) -> f32 {
    return 1.0 - scene.shadows.strength * (1.0 - key_through(point, pixel, unlit, by_figures));
}
