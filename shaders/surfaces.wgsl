// Surfaces of the kinds of ground: what a pixel's colour, slope and gloss are, by kind, near and farther off.
// Follows surface_kinds.wgsl, which has what each is like, and `tint_of`, the table of the kinds' colours that
// crates/terrain/src/tint.rs has and meshes hold already; one entry, `surface_at`, and for vertices `kind_of` and
// `kind_weights`.
//
// All is made of noise and of cells in the grain's own place (`grain_point`), so that nothing is stored, nothing tiles before
// the 256 m after which places wrap, and nothing swims. Every pattern fades before a pixel spans half of its length, so that
// nothing shimmers. Heights come with their gradients, for normals: of noise by the derivative of its weights, of cells by the
// way to their middle. Kinds blend by the height of their detail: pebbles stand out of sand, and moss grows in hollows.

// The numbers of kinds, as crates/terrain/src/kind.rs has them.
const GRASS: u32 = 1u;
const SOIL: u32 = 2u;
const SAND: u32 = 3u;
const GRAVEL: u32 = 4u;
const ROCK: u32 = 5u;
const ASH: u32 = 6u;
const SNOW: u32 = 7u;
const MOSS: u32 = 8u;
const CLAY: u32 = 9u;
const BASALT: u32 = 10u;
const SLATE: u32 = 11u;
const COAL: u32 = 12u;
const COPPER: u32 = 13u;
const CRYSTAL: u32 = 14u;
// What plants are made of, which is no ground.
const WOOD: u32 = 15u;
const LEAVES: u32 = 16u;
const KINDS: u32 = 16u;
// A vertex's byte has the number of its kind in five bits, and above them the skin of untouched land, or steps of the sky.
const NUMBER_BITS: u32 = 0x1fu;
const SKY_SHIFT: u32 = 5u;
const OPEN_SKY: u32 = 6u;
const SKIN: u32 = 7u;

// Whether a steep face of untouched land shows the rock below it.
fn is_thin(kind: u32) -> bool {
    return kind != SNOW && kind != BASALT && kind < SLATE;
}

// The kind that a vertex says, how much of it is rock, since it is steep there, and how much of the sky is left.
fn kind_of(byte: f32, normal_y: f32) -> vec3<f32> {
    let number = u32(byte * 255.0 + 0.5);
    let kind = number & NUMBER_BITS;
    let sky = number >> SKY_SHIFT;
    let steep = smoothstep(0.26, 0.46, 1.0 - normal_y);
    let is_skin = sky == SKIN && is_thin(kind);
    return vec3<f32>(f32(min(kind, KINDS)), select(0.0, steep, is_skin), f32(min(sky, OPEN_SKY)) / f32(OPEN_SKY));
}

// Of each kind, from the first on, how much a vertex has.
fn kind_weights(kind: vec3<f32>) -> mat4x4<f32> {
    var weights = mat4x4<f32>();
    for (var row = 0u; row < 4u; row++) {
        let numbers = vec4<f32>(1.0, 2.0, 3.0, 4.0) + 4.0 * f32(row);
        let own = select(vec4<f32>(0.0), vec4<f32>(1.0 - kind.y), numbers == vec4<f32>(kind.x));
        weights[row] = own + select(vec4<f32>(0.0), vec4<f32>(kind.y), numbers == vec4<f32>(f32(ROCK)));
    }
    return weights;
}

// What a pixel of ground is like.
struct Surface {
    albedo: vec3<f32>,
    slope: vec3<f32>,   // of its height, metres per metre along the grain's axes
    gloss: f32,         // of the key light's highlight, 0 to 1
    glow: vec3<f32>,    // light of its own
}

// A kind's detail with the mean of its tones taken to one, so that the mean of its colours is what the table of tints says,
// which meshes and far land show.
fn levelled(detail: Detail, mean: vec3<f32>) -> Detail {
    var level = detail;
    level.tone = max(detail.tone, vec3<f32>(0.0)) / mean;
    return level;
}

fn detail_of(kind: u32, spot: Spot) -> Detail {
    let ground = ground_at(kind, spot);
    switch kind {
        case 1u: { return levelled(grass(ground), vec3<f32>(0.985)); }
        case 3u: { return levelled(sand(ground), vec3<f32>(0.990)); }
        case 4u: { return levelled(gravel(ground), vec3<f32>(0.740)); }
        case 5u: { return levelled(rock(ground), vec3<f32>(0.870)); }
        case 6u: { return levelled(ash(ground), vec3<f32>(0.955, 0.927, 0.920)); }
        case 7u: { return levelled(snow(ground), vec3<f32>(0.860, 0.910, 0.980)); }
        case 8u: { return levelled(moss(ground), vec3<f32>(0.520, 0.535, 0.465)); }
        case 9u: { return levelled(clay(ground), vec3<f32>(0.877)); }
        case 10u: { return levelled(basalt(ground), vec3<f32>(0.950)); }
        case 11u: { return levelled(slate(ground), vec3<f32>(0.785)); }
        case 12u: { return levelled(coal(ground), vec3<f32>(1.185)); }
        case 13u: { return levelled(copper(ground), vec3<f32>(1.410, 1.350, 1.140)); }
        case 15u: { return levelled(wood(ground), vec3<f32>(1.0)); }
        case 16u: { return levelled(leaves(ground), vec3<f32>(1.0)); }
        case 14u: { return levelled(crystal(ground), vec3<f32>(1.180, 1.020, 1.500)); }
        default: { return levelled(soil(ground), vec3<f32>(0.760, 0.770, 0.780)); }
    }
}

// The widest of a kind's patterns, as vertices can show it: what its colour is multiplied by. So slow that a vertex more or less,
// where edges are halved, does not change the picture; strong patterns of 2 m are only hinted at.
fn coarse_tone(kind: u32, p: vec3<f32>) -> vec3<f32> {
    let is_quick = kind == SOIL || kind == GRAVEL || kind == CLAY;
    let wide = noise_at(p, select(0.25, 0.5, is_quick)).x;
    switch kind {
        case 1u: { return 1.0 + wide * vec3<f32>(0.22, 0.10, 0.07); }
        case 3u, 5u, 7u: { return vec3<f32>(1.0 + 0.08 * wide); }
        case 6u: { return vec3<f32>(1.0 + 0.34 * wide); }
        case 8u: { return 1.0 + wide * vec3<f32>(0.20, 0.10, 0.05); }
        case 10u, 11u: { return vec3<f32>(1.0 + 0.16 * wide); }
        default: { return vec3<f32>(1.0 + 0.13 * wide); }
    }
}

// The two kinds of which a pixel has most.
struct Most {
    kinds: vec2<u32>,
    weights: vec2<f32>,
}

fn more_of(most: Most, kind: u32, weight: f32) -> Most {
    if weight > most.weights.x {
        return Most(vec2<u32>(kind, most.kinds.x), vec2<f32>(weight, most.weights.x));
    }
    if weight > most.weights.y {
        return Most(vec2<u32>(most.kinds.x, kind), vec2<f32>(most.weights.x, weight));
    }
    return most;
}

fn more_of_four(most: Most, before: u32, weights: vec4<f32>) -> Most {
    let x = more_of(most, before + 1u, weights.x);
    let y = more_of(x, before + 2u, weights.y);
    let z = more_of(y, before + 3u, weights.z);
    return more_of(z, before + 4u, weights.w);
}

// Not by a loop: what a number says where to read, a card keeps in memory and not in registers, and a pixel takes a sixth longer.
fn most_of(weights: mat4x4<f32>) -> Most {
    var most = Most(vec2<u32>(SOIL), vec2<f32>(0.0));
    most = more_of_four(most, 0u, weights[0]);
    most = more_of_four(most, 4u, weights[1]);
    most = more_of_four(most, 8u, weights[2]);
    return more_of_four(most, 12u, weights[3]);
}

// How far heights reach into each other where kinds blend: near, and where a pixel is so wide that nothing of their detail is
// seen. There a sharp border would have the corners of triangles, which are metres long.
const BLEND_DEPTHS: vec2<f32> = vec2<f32>(0.10, 0.40);
const BLEND_WIDE_M: vec2<f32> = vec2<f32>(0.03, 0.20);

// A tint over the biome's colour.
fn tinted(biome: vec3<f32>, tint: vec4<f32>) -> vec3<f32> {
    return mix(biome, tint.rgb, tint.a);
}

// The colours of two kinds at a pixel, of which the vertices' colour is the mean by these weights: b being the biome's colour
// and t the tints, g = w1 (b (1 - a1) + a1 t1) + w2 (b (1 - a2) + a2 t2), and so b = (g - w1 a1 t1 - w2 a2 t2) / (1 - w1 a1 - w2 a2).
fn parted(ground: vec3<f32>, kinds: vec2<u32>, weights: vec2<f32>) -> array<vec3<f32>, 2> {
    let one = tint_of(kinds.x);
    let two = tint_of(kinds.y);
    let shares = weights * vec2<f32>(one.a, two.a);
    let rest = (ground - shares.x * one.rgb - shares.y * two.rgb) / max(1.0 - shares.x - shares.y, 0.05);
    let biome = clamp(rest, vec3<f32>(0.0), vec3<f32>(1.0));
    let apart = tinted(biome, two) - tinted(biome, one);
    // The weights of a halved edge's middle are those of one kind, and its colour is not.
    let least = 0.4 * ground;
    return array<vec3<f32>, 2>(max(ground - weights.y * apart, least), max(ground + weights.x * apart, least));
}

// A pixel of ground: `ground` is the vertices' colour, `wide_m` what the pixel spans.
fn surface_at(weights: mat4x4<f32>, ground: vec3<f32>, p: vec3<f32>, wide_m: f32) -> Surface {
    let spot = Spot(p, grain_up(p), wide_m);
    let most = most_of(weights);
    // Asked for in one place, so that it stands in the adapter's program once.
    let count = select(2u, 1u, most.weights.y < 0.02);
    var one: Detail;
    var two: Detail;
    for (var n = 0u; n < count; n++) {
        let detail = detail_of(select(most.kinds.x, most.kinds.y, n == 1u), spot);
        if n == 0u {
            one = detail;
        } else {
            two = detail;
        }
    }
    if count == 1u {
        return Surface(ground * one.tone, one.slope, one.gloss, one.glow);
    }
    let scores = most.weights * (vec2<f32>(0.4) + vec2<f32>(one.height, two.height));
    let depth = mix(BLEND_DEPTHS.x, BLEND_DEPTHS.y, smoothstep(BLEND_WIDE_M.x, BLEND_WIDE_M.y, wide_m));
    let heights = max(scores - (max(scores.x, scores.y) - depth), vec2<f32>(0.0));
    let share = heights.y / (heights.x + heights.y);
    let colours = parted(ground, most.kinds, most.weights / (most.weights.x + most.weights.y));
    return Surface(
        mix(colours[0] * one.tone, colours[1] * two.tone, share),
        mix(one.slope, two.slope, share),
        mix(one.gloss, two.gloss, share),
        mix(one.glow, two.glow, share),
    );
}
