// What each kind of ground is like at a pixel: `surfaces.wgsl` says how they come together.
// Follows the file of a world's daylight, which says which way is up in the grain (`grain_up`).

// One kind at a pixel, before its colour.
struct Detail {
    height: f32,        // 0 in hollows to 1 on top, for blending
    slope: vec3<f32>,
    tone: vec3<f32>,    // what the colour is multiplied by
    gloss: f32,
    glow: vec3<f32>,
}

// A pixel's place.
struct Spot {
    p: vec3<f32>,       // of the grain, m
    up: vec3<f32>,
    wide_m: f32,        // what the pixel spans
}

// How much is left of a pattern of a length where a pixel spans so much. What fades, fades to its own mean, so that no kind
// changes its colour with the distance; the means stand beside the patterns, and a test measures them. What is gone is not
// worked out.
fn left_of(spot: Spot, length_m: f32) -> f32 {
    return 1.0 - smoothstep(0.22, 0.5, spot.wide_m / length_m);
}

// So many of a noise's cells are its length.
const NOISE_CELLS: f32 = 1.2;

// Value noise about zero, -1 to 1, with its gradient; so many cells a metre, a power of two.
fn noise_at(p: vec3<f32>, frequency: f32) -> vec4<f32> {
    let q = p * frequency;
    let mask = u32(256.0 * frequency) - 1u;
    let base = floor(q);
    let f = q - base;
    let s = f * f * (3.0 - 2.0 * f);
    let d = 6.0 * f * (1.0 - f);
    let c0 = vec3<u32>(vec3<i32>(base)) & vec3<u32>(mask);
    let c1 = (c0 + vec3<u32>(1u)) & vec3<u32>(mask);
    let prime = vec3<u32>(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du);
    let h0 = c0 * prime;
    let h1 = c1 * prime;
    let v000 = mix_bits(h0.x ^ h0.y ^ h0.z);
    let v100 = mix_bits(h1.x ^ h0.y ^ h0.z);
    let v010 = mix_bits(h0.x ^ h1.y ^ h0.z);
    let v110 = mix_bits(h1.x ^ h1.y ^ h0.z);
    let v001 = mix_bits(h0.x ^ h0.y ^ h1.z);
    let v101 = mix_bits(h1.x ^ h0.y ^ h1.z);
    let v011 = mix_bits(h0.x ^ h1.y ^ h1.z);
    let v111 = mix_bits(h1.x ^ h1.y ^ h1.z);
    let near = mix(mix(v000, v100, s.x), mix(v010, v110, s.x), s.y);
    let far = mix(mix(v001, v101, s.x), mix(v011, v111, s.x), s.y);
    let along_x = mix(mix(v100 - v000, v110 - v010, s.y), mix(v101 - v001, v111 - v011, s.y), s.z);
    let along_y = mix(mix(v010 - v000, v110 - v100, s.x), mix(v011 - v001, v111 - v101, s.x), s.z);
    let gradient = vec3<f32>(along_x, along_y, far - near) * d * frequency;
    return vec4<f32>(mix(near, far, s.z), gradient) * 2.0 - vec4<f32>(1.0, 0.0, 0.0, 0.0);
}

// The same at a pixel, or none at all where it has no cells.
fn grain_noise(spot: Spot, frequency: f32) -> vec4<f32> {
    let left = left_of(spot, NOISE_CELLS / max(frequency, 1e-3));
    if left <= 0.0 || frequency <= 0.0 {
        return vec4<f32>(0.0);
    }
    return noise_at(spot.p, frequency) * left;
}

// The nearest of scattered middles: the way from it, and how far it and the next are, in cells; a number of its own, 0 to 1;
// and what is left of all that.
struct Cell {
    way: vec3<f32>,
    near: f32,
    next: f32,
    own: f32,
    left: f32,
}

// About the mean of all.
const NO_CELL: Cell = Cell(vec3<f32>(0.0), 0.55, 0.75, 0.5, 0.0);

// With the middle in one more cell.
fn nearer_of(cell: Cell, at: vec3<f32>, q: vec3<f32>, mask: vec3<u32>) -> Cell {
    let c = vec3<u32>(vec3<i32>(at)) & mask;
    let h = (c.x * 0x9e3779b1u) ^ (c.y * 0x85ebca77u) ^ (c.z * 0xc2b2ae3du);
    let a = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    let b = (a ^ (a >> 12u)) * 0x297a2d39u;
    let jitter = vec3<f32>(vec3<u32>(b, b >> 8u, b >> 16u) & vec3<u32>(255u)) * (1.0 / 255.0);
    let way = q - at - 0.14 - 0.72 * jitter;
    let far = dot(way, way);
    if far < cell.near {
        return Cell(way, far, cell.near, f32((a >> 9u) & 1023u) * (1.0 / 1023.0), cell.left);
    }
    return Cell(cell.way, cell.near, min(cell.next, far), cell.own, cell.left);
}

fn nearest_of_four(start: Cell, corner: vec3<f32>, q: vec3<f32>, mask: vec3<u32>) -> Cell {
    var cell = nearer_of(start, corner, q, mask);
    cell = nearer_of(cell, corner + vec3<f32>(1.0, 0.0, 0.0), q, mask);
    cell = nearer_of(cell, corner + vec3<f32>(0.0, 1.0, 0.0), q, mask);
    return nearer_of(cell, corner + vec3<f32>(1.0, 1.0, 0.0), q, mask);
}

// So many cells a metre along each axis. Only the eight cells about the nearest corner are looked at, which jitter of less
// than half keeps from showing.
fn cell_at(place: vec3<f32>, frequency: f32, left: f32) -> Cell {
    if left <= 0.0 {
        return NO_CELL;
    }
    let q = place * frequency;
    let mask = vec3<u32>(u32(256.0 * frequency) - 1u);
    let corner = floor(q - 0.5);
    var cell = Cell(vec3<f32>(0.0), 9.0, 9.0, 0.0, left);
    for (var n = 0u; n < 2u; n++) {
        cell = nearest_of_four(cell, corner + vec3<f32>(0.0, 0.0, f32(n)), q, mask);
    }
    cell.near = sqrt(cell.near);
    cell.next = sqrt(cell.next);
    return cell;
}

// What a kind is made of: how many cells a metre each of four noises has, the widest first, and each of two patterns of cells,
// and the lengths by which those fade, metres. Adapters put every call in its place anew, so noises and cells are asked for here
// alone and not by each kind: a card's driver took seconds for each way of drawing land, when they were.
struct Patterns {
    noises: vec4<f32>,
    cells: vec2<f32>,
    lengths_m: vec2<f32>,
}

fn patterns_of(kind: u32) -> Patterns {
    switch kind {
        case 1u: { return Patterns(vec4<f32>(0.25, 2.0, 32.0, 0.0), vec2<f32>(8.0, 0.0), vec2<f32>(0.15, 0.0)); }
        case 3u: { return Patterns(vec4<f32>(0.125, 0.5, 64.0, 0.0), vec2<f32>(0.0), vec2<f32>(0.0)); }
        case 4u: { return Patterns(vec4<f32>(0.5, 0.0, 64.0, 0.0), vec2<f32>(4.0, 16.0), vec2<f32>(0.3, 0.075)); }
        case 5u, 13u: { return Patterns(vec4<f32>(0.25, 2.0, 8.0, 32.0), vec2<f32>(0.5, 0.0), vec2<f32>(0.5, 0.0)); }
        case 6u: { return Patterns(vec4<f32>(0.25, 1.0, 64.0, 0.0), vec2<f32>(8.0, 0.0), vec2<f32>(0.15, 0.0)); }
        case 7u: { return Patterns(vec4<f32>(0.25, 1.0, 8.0, 128.0), vec2<f32>(0.0), vec2<f32>(0.0)); }
        case 8u: { return Patterns(vec4<f32>(0.5, 8.0, 0.0, 0.0), vec2<f32>(2.0, 32.0), vec2<f32>(0.6, 0.0375)); }
        case 9u: { return Patterns(vec4<f32>(0.5, 4.0, 32.0, 0.0), vec2<f32>(2.0, 8.0), vec2<f32>(0.35, 0.1)); }
        case 10u: { return Patterns(vec4<f32>(0.5, 8.0, 0.0, 0.0), vec2<f32>(2.0, 32.0), vec2<f32>(0.35, 0.0375)); }
        case 11u: { return Patterns(vec4<f32>(0.5, 4.0, 32.0, 0.0), vec2<f32>(0.0), vec2<f32>(0.0)); }
        case 12u: { return Patterns(vec4<f32>(2.0, 0.0, 0.0, 0.0), vec2<f32>(8.0, 0.0), vec2<f32>(0.12, 0.0)); }
        case 14u: { return Patterns(vec4<f32>(1.0, 0.0, 0.0, 0.0), vec2<f32>(4.0, 16.0), vec2<f32>(0.25, 0.06)); }
        case 15u: { return Patterns(vec4<f32>(1.0, 8.0, 64.0, 0.0), vec2<f32>(0.0), vec2<f32>(0.0)); }
        case 16u: { return Patterns(vec4<f32>(0.5, 4.0, 0.0, 0.0), vec2<f32>(4.0, 16.0), vec2<f32>(0.3, 0.075)); }
        default: { return Patterns(vec4<f32>(0.5, 4.0, 64.0, 0.0), vec2<f32>(4.0, 16.0), vec2<f32>(0.3, 0.075)); }
    }
}

// A pixel's place with its kind's noises and cells.
struct Ground {
    spot: Spot,
    a: vec4<f32>,
    b: vec4<f32>,
    c: vec4<f32>,
    d: vec4<f32>,
    wide: Cell,
    small: Cell,
}

fn ground_at(kind: u32, spot: Spot) -> Ground {
    let has = patterns_of(kind);
    let a = grain_noise(spot, has.noises.x);
    let b = grain_noise(spot, has.noises.y);
    // Cells of rock and clay are not as regular as the lattice.
    var wide_at = spot.p;
    var small_at = spot.p;
    if kind == ROCK || kind == COPPER {
        wide_at += 0.04 * b.yzw;
    } else if kind == CLAY {
        wide_at += 0.006 * b.yzw;
        small_at += 0.004 * b.yzw;
    } else if kind == BASALT {
        // Columns stand upright, each of its own height.
        let height = dot(spot.p, spot.up);
        wide_at += spot.up * (floor(height * 0.8 + 0.3 * a.x) * 3.0 - height);
    }
    let left = vec2<f32>(left_of(spot, max(has.lengths_m.x, 1e-6)), left_of(spot, max(has.lengths_m.y, 1e-6)));
    return Ground(
        spot,
        a,
        b,
        grain_noise(spot, has.noises.z),
        grain_noise(spot, has.noises.w),
        cell_at(wide_at, has.cells.x, left.x),
        cell_at(small_at, has.cells.y, left.y),
    );
}

// What lies across the ground of a vector.
fn level_of(spot: Spot, v: vec3<f32>) -> vec3<f32> {
    return v - spot.up * dot(v, spot.up);
}

// Stones: domes of a size, each of its own tone, in dark gaps. The first four numbers are height and slope.
struct Stones {
    height: f32,
    slope: vec3<f32>,
    gap: f32,           // 1 between them
    own: f32,
    number: f32,        // as `own`, but not faded, and
    left: f32,          // what is left of all
}

// Those of the greatest numbers alone, which are this share of the ground in the mean.
fn few(stones: Stones, above: f32, mean: f32) -> f32 {
    return mix(mean, step(above, stones.number) * (1.0 - stones.gap), stones.left);
}

fn stones(cell: Cell) -> Stones {
    let radius = 0.42 + 0.22 * cell.own;
    let share = clamp(cell.near / radius, 0.0, 1.0);
    let left = cell.left;
    let height = 1.0 - share * share;
    // Metres: a stone is a third as high as it is wide.
    let slope = -cell.way * (0.7 / (radius * radius)) * step(share, 0.999);
    let gap = smoothstep(0.55, 1.0, share);
    return Stones(mix(0.24, height, left), slope * left, mix(0.70, gap, left), mix(0.5, cell.own, left), cell.own, left);
}

fn grass(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let mid = ground.b;
    let fine = ground.c;
    let cell = ground.wide;
    let left = cell.left;
    // Tussocks: blades stand out from their middles.
    let side = level_of(spot, cell.way);
    let axis = normalize(level_of(spot, vec3<f32>(0.8, 0.31, 0.5)));
    let angle = atan2(dot(side, cross(spot.up, axis)), dot(side, axis));
    let blades_left = left_of(spot, 0.03);
    let turns = 17.0 + floor(6.0 * cell.own);
    let blade = sin(angle * turns + 5.0 * fine.x + 40.0 * cell.own) * smoothstep(0.03, 0.25, cell.near) * blades_left;
    let dome = 1.0 - cell.near * cell.near * 1.6;
    var tone = vec3<f32>(1.0) + 0.22 * wide.x * vec3<f32>(1.0, 0.45, 0.3);
    tone *= 1.0 + 0.20 * mid.x;
    tone *= mix(0.97, 0.62 + 0.62 * dome, 0.8 * left) + 0.16 * (cell.own - 0.5) * left;
    tone *= 1.0 + 0.22 * blade + 0.22 * fine.x;
    // Dry tips.
    tone += vec3<f32>(0.42, 0.26, 0.02) * max(blade, 0.0) * step(0.72, cell.own);
    let around = cross(spot.up, side) / max(dot(side, side), 0.02);
    let slope = -0.55 * side * left + around * (0.03 * blade) + fine.yzw * 0.006 + mid.yzw * 0.035;
    return Detail(mix(0.5, clamp(dome, 0.0, 1.0), left), slope, tone, 0.0, vec3<f32>(0.0));
}

fn soil(ground: Ground) -> Detail {
    let wide = ground.a;
    let lumps = ground.b;
    let fine = ground.c;
    let pebbles = stones(ground.wide);
    let crumbs = stones(ground.small);
    var tone = vec3<f32>(1.0 + 0.20 * wide.x + 0.30 * lumps.x);
    tone *= (1.0 + 0.30 * (crumbs.own - 0.5)) * (1.0 - 0.42 * crumbs.gap) * (1.0 + 0.2 * fine.x);
    var slope = lumps.yzw * 0.07 + crumbs.slope * 0.5 + wide.yzw * 0.10;
    var height = 0.35 + 0.25 * lumps.x + 0.25 * crumbs.height;
    // A stone here and there.
    let is_stone = few(pebbles, 0.86, 0.064);
    tone = mix(tone, vec3<f32>(1.9, 2.1, 2.3) * (0.8 + 0.4 * fine.x), is_stone);
    slope = mix(slope, pebbles.slope, is_stone);
    height = mix(height, 0.9, is_stone);
    return Detail(height, slope, tone, 0.0, vec3<f32>(0.0));
}

// Waves across the ground along a way, one every so many metres, bent by a noise: their height 0 to 1 and slope for a
// height of a metre. The way has whole waves in the 256 m after which places wrap.
fn ripples(spot: Spot, way: vec3<f32>, bend: vec4<f32>) -> vec4<f32> {
    let turn = 6.2831853 / 256.0;
    let phase = dot(spot.p, way) * turn + bend.x;
    let wave = sin(phase);
    // Crests are sharper than troughs.
    let height = 0.5 + 0.5 * wave;
    let slope = 0.5 * cos(phase) * (way * turn + bend.yzw);
    return vec4<f32>(height * height, 2.0 * height * slope);
}

fn sand(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let mid = ground.b;
    let fine = ground.c;
    let bend = wide * 7.0 + mid * 1.6;
    // One every 0.16 m and every 2.2 m.
    let small = ripples(spot, vec3<f32>(1420.0, 310.0, 660.0), bend * 2.0);
    let large = ripples(spot, vec3<f32>(97.0, 24.0, 58.0), wide * 3.0);
    let small_left = left_of(spot, 0.16) * (0.55 + 0.45 * mid.x);
    let large_left = left_of(spot, 2.2);
    var tone = vec3<f32>(1.0) + 0.10 * mid.x * vec3<f32>(1.0, 0.9, 0.7);
    tone *= (1.0 + 0.26 * (small.x - 0.4) * small_left) * (1.0 + 0.14 * (large.x - 0.4) * large_left);
    tone *= 1.0 + 0.16 * fine.x;
    let slope = small.yzw * (0.016 * small_left) + large.yzw * (0.13 * large_left) + fine.yzw * 0.0022;
    let spark = smoothstep(0.82, 0.97, fine.x);
    return Detail(mix(0.4, 0.25 + 0.4 * small.x, left_of(spot, 0.16)), slope, tone, 0.35 * spark, vec3<f32>(0.0));
}

fn gravel(ground: Ground) -> Detail {
    let wide = ground.a;
    let fine = ground.c;
    let large = stones(ground.wide);
    let small = stones(ground.small);
    // Small ones lie between the large.
    let between = large.gap;
    let own = mix(large.own, small.own, between);
    var tone = vec3<f32>(0.62 + 0.85 * own) + 0.16 * wide.x;
    tone += (own - 0.5) * vec3<f32>(0.18, 0.0, -0.14);
    tone *= 1.0 - 0.55 * between * (0.35 + 0.65 * small.gap);
    tone *= 1.0 + 0.18 * fine.x;
    let slope = mix(large.slope, small.slope, between) + fine.yzw * 0.003;
    return Detail(0.3 + 0.7 * mix(large.height, 0.4 * small.height, between), slope, tone, 0.06, vec3<f32>(0.0));
}

// Beds of rock along a way, a bed every metre over its length: which bed, how far from its edge, and the slope of ledges.
fn beds(spot: Spot, way: vec3<f32>, bend: vec4<f32>) -> vec4<f32> {
    let at = dot(spot.p, way) + bend.x;
    let part = fract(at);
    let over = clamp((part - 0.72) / 0.26, 0.0, 1.0);
    let rise = 6.0 * over * (1.0 - over) / 0.26;
    return vec4<f32>(smoothstep(0.72, 0.98, part), (way + bend.yzw) * rise);
}

fn bed_tone(spot: Spot, way: vec3<f32>, bend: f32) -> f32 {
    let at = floor(dot(spot.p, way) + bend);
    return mix_bits(u32(i32(at) & 0xff) * 0x9e3779b1u);
}

fn rock(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let mid = ground.b;
    let rough = ground.c;
    let fine = ground.d;
    let crack = ground.wide;
    let bend = wide * 1.1 + mid * 0.10;
    let thick = spot.up * 1.25;
    let thin = spot.up * 5.0;
    let bed = beds(spot, thick, bend);
    let layer = beds(spot, thin, bend * 4.0);
    let thin_left = left_of(spot, 0.2);
    let cracked = mix(0.108, 1.0 - smoothstep(0.015, 0.05, crack.next - crack.near), crack.left);
    let thick_left = left_of(spot, 0.8);
    var tone = vec3<f32>(0.78 + 0.42 * mix(0.5, bed_tone(spot, thick, bend.x), thick_left));
    tone *= 1.0 + 0.26 * (bed_tone(spot, thin, bend.x * 4.0) - 0.5) * thin_left;
    tone *= (1.0 - 0.30 * mix(0.148, bed.x, thick_left)) * (1.0 - 0.22 * mix(0.148, layer.x, thin_left));
    tone *= 1.0 + 0.24 * mid.x + 0.26 * rough.x + 0.2 * fine.x;
    tone *= 1.0 - 0.5 * cracked;
    let slope = bed.yzw * (-0.10 * thick_left) + layer.yzw * (-0.024 * thin_left) + mid.yzw * 0.07 + rough.yzw * 0.022
        + fine.yzw * 0.006;
    return Detail(0.55 + 0.25 * mid.x + 0.2 * rough.x - 0.4 * cracked, slope, tone, 0.05, vec3<f32>(0.0));
}

fn ash(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let mid = ground.b;
    let fine = ground.c;
    let cinders = stones(ground.wide);
    let bend = wide * 5.0 + mid * 1.2;
    let small = ripples(spot, vec3<f32>(260.0, 70.0, -410.0), bend);
    let small_left = left_of(spot, 0.5);
    var tone = vec3<f32>(1.0 + 0.34 * wide.x + 0.24 * mid.x) + 0.30 * (small.x - 0.4) * small_left;
    tone *= 1.0 + 0.20 * fine.x;
    var slope = small.yzw * (0.035 * small_left) + mid.yzw * 0.05 + fine.yzw * 0.002;
    let is_cinder = few(cinders, 0.70, 0.126);
    let ruddy = vec3<f32>(1.1, 0.72, 0.62) * (0.35 + 0.5 * mix(0.5, fract(cinders.number * 17.0), cinders.left));
    tone = mix(tone, ruddy, is_cinder);
    slope = mix(slope, cinders.slope + fine.yzw * 0.006, is_cinder);
    return Detail(0.3 + 0.3 * mix(0.4, small.x, small_left) + 0.4 * is_cinder, slope, tone, 0.0, vec3<f32>(0.0));
}

fn snow(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let mid = ground.b;
    let small = ground.c;
    let fine = ground.d;
    let drift = ripples(spot, vec3<f32>(150.0, 40.0, 96.0), wide * 6.0 + mid * 1.4);
    let drift_left = left_of(spot, 1.3);
    let hollow = 0.5 - 0.5 * (0.6 * mid.x + 0.4 * small.x);
    var tone = vec3<f32>(1.0) - vec3<f32>(0.16, 0.10, 0.02) * hollow - vec3<f32>(0.10, 0.07, 0.02) * mix(0.62, 1.0 - drift.x, drift_left);
    let spark = smoothstep(0.80, 0.96, fine.x);
    tone += 0.5 * spark;
    let slope = drift.yzw * (0.06 * drift_left) + mid.yzw * 0.06 + small.yzw * 0.010;
    return Detail(0.55 + 0.3 * mix(0.38, drift.x, drift_left), slope, tone, 0.25 + spark, vec3<f32>(0.0));
}

fn moss(ground: Ground) -> Detail {
    let wide = ground.a;
    let mid = ground.b;
    let cushions = stones(ground.wide);
    let tufts = stones(ground.small);
    var tone = vec3<f32>(0.55, 0.62, 0.6) + cushions.height * vec3<f32>(0.65, 0.5, 0.25);
    tone += 0.24 * wide.x * vec3<f32>(1.0, 0.5, 0.2);
    tone *= 1.0 + 0.35 * (tufts.height - 0.24) + 0.24 * (tufts.own - 0.5) + 0.16 * mid.x;
    // Less than the mean of gaps, since cushions are low there.
    tone *= 1.0 - 0.45 * mix(0.58, cushions.gap, cushions.left);
    let slope = cushions.slope * 0.8 + tufts.slope * 0.45 + mid.yzw * 0.012;
    return Detail(0.2 + 0.7 * cushions.height, slope, tone, 0.0, vec3<f32>(0.0));
}

fn clay(ground: Ground) -> Detail {
    let wide = ground.a;
    let mid = ground.b;
    let fine = ground.c;
    let plate = ground.wide;
    let chip = ground.small;
    let left = plate.left;
    let edge = plate.next - plate.near;
    let crack = mix(0.195, 1.0 - smoothstep(0.03, 0.09, edge), left);
    let small = mix(0.098, 0.6 - 0.6 * smoothstep(0.02, 0.08, chip.next - chip.near), chip.left);
    // Plates curl up at their edges.
    let curl = mix(0.306, smoothstep(0.30, 0.06, edge) * (1.0 - crack), left);
    var tone = vec3<f32>(1.0 + 0.22 * (plate.own - 0.5) * left + 0.16 * wide.x) + 0.16 * curl;
    tone *= (1.0 - 0.68 * crack) * (1.0 - 0.40 * small) * (1.0 + 0.14 * mid.x + 0.12 * fine.x);
    let slope = plate.way * (0.42 * curl * left) + mid.yzw * 0.02 + fine.yzw * 0.003;
    return Detail(0.7 - 0.6 * crack, slope, tone, 0.10, vec3<f32>(0.0));
}

fn basalt(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let rough = ground.b;
    let column = ground.wide;
    let pores = stones(ground.small);
    let left = column.left;
    let edge = column.next - column.near;
    let joint = mix(0.285, 1.0 - smoothstep(0.03, 0.12, edge), left);
    let bevel = smoothstep(0.34, 0.05, edge);
    let own = mix(0.5, column.own, left);
    var tone = vec3<f32>(0.75 + 0.75 * own + 0.3 * wide.x);
    tone *= (1.0 - 0.72 * joint) * (1.0 + 0.28 * rough.x);
    tone *= 1.0 - 0.5 * few(pores, 0.72, 0.119);
    tone += 0.35 * mix(0.290, bevel * (1.0 - joint), left);
    let tilt = (vec3<f32>(column.own, fract(column.own * 7.0), fract(column.own * 13.0)) - 0.5) * 0.5 * left;
    let slope = level_of(spot, -column.way) * (1.1 * bevel * left) + tilt + rough.yzw * 0.018;
    return Detail(0.3 + 0.6 * own - 0.5 * joint, slope, tone, 0.14, vec3<f32>(0.0));
}

fn slate(ground: Ground) -> Detail {
    let spot = ground.spot;
    let wide = ground.a;
    let mid = ground.b;
    let fine = ground.c;
    let way = normalize(spot.up + vec3<f32>(0.55, 0.2, -0.35)) * 9.0;
    let bend = wide * 2.4 + mid * 0.35;
    let leaf = beds(spot, way, bend);
    let left = left_of(spot, 0.11);
    let own = mix(0.5, bed_tone(spot, way, bend.x), left);
    var tone = vec3<f32>(0.85 + 0.4 * wide.x) + (own - 0.5) * vec3<f32>(0.45, 0.5, 0.6);
    tone *= (1.0 - 0.5 * mix(0.148, leaf.x, left)) * (1.0 + 0.2 * mid.x + 0.16 * fine.x);
    let slope = leaf.yzw * (-0.022 * left) + mid.yzw * 0.03 + fine.yzw * 0.003;
    return Detail(0.4 + 0.3 * own, slope, tone, 0.30, vec3<f32>(0.0));
}

// Facets: each cell is flat and leans its own way.
fn lean(cell: Cell) -> vec3<f32> {
    return vec3<f32>(cell.own, fract(cell.own * 37.0), fract(cell.own * 91.0)) - 0.5;
}

fn coal(ground: Ground) -> Detail {
    let mid = ground.a;
    let lump = ground.wide;
    let left = lump.left;
    let seam = mix(0.195, 1.0 - smoothstep(0.02, 0.10, lump.next - lump.near), left);
    let own = mix(0.5, lump.own, left);
    let tone = vec3<f32>(0.7 + 1.3 * own + 0.5 * mid.x) * (1.0 - 0.6 * seam);
    return Detail(0.4 + 0.4 * own, lean(lump) * (1.5 * left), tone, 0.75 * (1.0 - seam), vec3<f32>(0.0));
}

// Its mean, from where veins are too narrow to be seen.
const COPPER_TONE: vec3<f32> = vec3<f32>(1.41, 1.35, 1.14);

// Veins in rock, of which it has the patterns.
fn copper(ground: Ground) -> Detail {
    var base = rock(ground);
    let near = abs(ground.b.x + 0.35 * ground.c.x);
    let left = left_of(ground.spot, 0.5);
    let vein = 1.0 - smoothstep(0.06, 0.13, near);
    let patina = (1.0 - smoothstep(0.13, 0.34, near)) * (1.0 - vein);
    base.tone = mix(base.tone, vec3<f32>(0.55, 2.3, 2.1), 0.85 * patina);
    base.tone = mix(base.tone, vec3<f32>(4.2, 2.0, 1.05), vein);
    base.tone = mix(COPPER_TONE, base.tone, left);
    base.gloss = mix(base.gloss, 0.9, vein * left);
    base.height += 0.3 * mix(0.13, vein, left);
    return base;
}

fn crystal(ground: Ground) -> Detail {
    let mid = ground.a;
    let facet = ground.wide;
    let small = ground.small;
    let left = facet.left;
    let edge = mix(0.179, 1.0 - smoothstep(0.02, 0.09, facet.next - facet.near), left);
    let own = mix(0.5, facet.own, left);
    let hue = mix(vec3<f32>(0.6, 1.1, 1.3), vec3<f32>(1.5, 0.7, 1.5), own);
    var tone = hue * (0.55 + 0.8 * mix(0.5, fract(facet.own * 5.0), left) + 0.3 * mid.x);
    tone = tone * (1.0 + 0.3 * (small.own - 0.5) * small.left) + edge * 0.9;
    let deep = mix(0.45, 1.0 - facet.near, left);
    let glow = hue * vec3<f32>(0.020, 0.040, 0.055) * deep * (0.6 + 0.4 * mid.x);
    return Detail(0.8, lean(facet) * (2.0 * left), tone, 1.0, glow);
}

// Grain that runs upwards, and rings where it is cut.
fn wood(ground: Ground) -> Detail {
    let streak = ground.a;
    let mid = ground.b;
    let fine = ground.c;
    let tone = vec3<f32>((1.0 + 0.20 * streak.x) * (1.0 + 0.22 * mid.x) * (1.0 + 0.14 * fine.x));
    let slope = mid.yzw * 0.030 + fine.yzw * 0.006;
    return Detail(0.5 + 0.3 * mid.x, slope, tone, 0.05, vec3<f32>(0.0));
}

// Tufts of leaves, each of its own tone, dark between them.
fn leaves(ground: Ground) -> Detail {
    let wide = ground.a;
    let mid = ground.b;
    let tufts = stones(ground.wide);
    let blades = stones(ground.small);
    var tone = vec3<f32>(1.0 + 0.16 * wide.x) * (1.0 + 0.5 * (tufts.height - 0.40) + 0.20 * (tufts.own - 0.5));
    tone *= 1.0 + 0.45 * (blades.height - 0.40) + 0.16 * mid.x;
    let slope = tufts.slope * 0.55 + blades.slope * 0.35;
    return Detail(0.5, slope, tone, 0.06, vec3<f32>(0.0));
}
