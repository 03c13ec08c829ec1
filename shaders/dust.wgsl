// Dust, spray and chips: discs that face the eye, lit as the ground that they come from; and marks on the ground, which take
// a share of its light.

// How a particle is drawn.
const DUST: u32 = 0u;
const CHIP: u32 = 2u;

struct ParticleIn {
    @builtin(vertex_index) corner: u32,
    @location(0) place: vec4<f32>,      // its middle from the reference, and its radius, metres
    @location(1) ground: vec4<f32>,     // unit normal of the ground below, and the height over it, metres
    @location(2) colour: vec4<f32>,     // linear light; a: opacity
    @location(3) looks: vec4<f32>,      // how it is drawn; its shape, 0 to 1; its turn, radians; what is left of the sky
    @location(4) lights: vec3<u32>,     // which lamps (64 bits) and beams may light it
}

struct ParticleOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,         // from -1 to 1 across it, turned with it
    @location(1) view: vec4<f32>,
    @location(2) rises: vec2<f32>,      // height over the ground in radii, and over its own middle
    @location(3) @interpolate(flat) lit: vec4<f32>,  // its light where the key light reaches it; a: opacity
    @location(4) @interpolate(flat) dark: vec4<f32>, // where it does not; a: 1 where that light cannot
    @location(5) @interpolate(flat) veil: vec4<f32>, // rgb: the fog's share; a: share of its own
    @location(6) @interpolate(flat) looks: vec4<f32>,
    @location(7) @interpolate(flat) place: vec3<f32>, // its middle from the reference in the common axes, metres
    @location(8) @interpolate(flat) middle: vec4<f32>, // its middle in view coordinates
    @location(9) @interpolate(flat) normal: vec3<f32>,
    @location(10) @interpolate(flat) frame_normal: vec4<f32>,
}

// Corners of a square as two triangles.
fn corner_of(index: u32) -> vec2<f32> {
    let x = select(-1.0, 1.0, index == 1u || index == 2u || index == 4u);
    let y = select(-1.0, 1.0, index == 2u || index == 4u || index == 5u);
    return vec2<f32>(x, y);
}

// Before the near plane, where nothing is drawn.
const NOWHERE: vec4<f32> = vec4<f32>(0.0, 0.0, 2.0, 1.0);

// A cloud that is nearer to the eye than so many radii thins out.
const NEAR_RADII: vec2<f32> = vec2<f32>(0.6, 2.4);

// Of clouds made for a processor only one in so many is drawn, as much denser.
const SPARED: u32 = 2u;
const DENSER: f32 = 1.5;

// Whether a cloud is left out.
fn is_spared(in: ParticleIn) -> bool {
    let number = u32(in.looks.y * 4096.0);
    return !BY_PIXEL && u32(in.looks.x) == DUST && number % SPARED != 0u;
}

@vertex
fn vertex_particle(in: ParticleIn) -> ParticleOut {
    let space = space_of_chart();
    let p = in.place.xyz;
    let radius = in.place.w;
    let middle = port_to_view(space, p);
    let chart_normal = port_normal(space, p, in.ground.xyz);
    let frame_normal = frame_vector(space, p, chart_normal);
    // Square to the way from the eye, a length in view coordinates is one of the space.
    let way = normalize(middle.xyz);
    let side = cross(way, select(vec3<f32>(0.0, 1.0, 0.0), vec3<f32>(1.0, 0.0, 0.0), abs(way.y) > 0.99));
    let right = normalize(side);
    let up = cross(right, way);
    let square = corner_of(in.corner);
    let away = (right * square.x + up * square.y) * radius;
    let turn = vec2<f32>(cos(in.looks.z), sin(in.looks.z));
    let rise = dot(away, frame_normal.xyz) / max(radius, 1e-4);
    let distance_m = eye_distance(space, middle);
    let fog = fog_at(distance_m);
    var out: ParticleOut;
    out.uv = vec2<f32>(square.x * turn.x - square.y * turn.y, square.x * turn.y + square.y * turn.x);
    out.view = vec4<f32>(middle.xyz + away, middle.w);
    out.clip = select(clip_from_view(space, out.view), NOWHERE, is_spared(in));
    out.rises = vec2<f32>(in.ground.w / max(radius, 1e-4) + rise, rise);
    out.normal = in_sky_axes(p, chart_normal);
    out.place = in_common_axes(p);
    out.middle = middle;
    out.frame_normal = frame_normal;
    let sky = mix(0.10, 1.0, in.looks.w);
    var lit = daylight_on(middle, out.normal, frame_normal, 1.0, sky);
    var dark = daylight_on(middle, out.normal, frame_normal, 0.0, sky);
    if any_lit(in.lights) {
        let lamps = lights_on(middle, frame_normal, in.lights, 0.0);
        lit += lamps;
        dark += lamps;
    }
    let is_soft = u32(in.looks.x) != CHIP;
    let near = smoothstep(NEAR_RADII.x * radius, NEAR_RADII.y * radius, distance_m);
    let denser = select(1.0, DENSER, !BY_PIXEL && u32(in.looks.x) == DUST);
    let opacity = min(in.colour.a * denser, 0.95) * select(1.0, near, is_soft);
    out.lit = vec4<f32>(in.colour.rgb * lit, select(opacity, in.colour.a, !is_soft));
    out.dark = vec4<f32>(in.colour.rgb * dark, select(0.0, 1.0, is_unlit(middle, out.normal, frame_normal)));
    out.veil = vec4<f32>(haze_before(middle) * fog, 1.0 - fog);
    out.looks = in.looks;
    return out;
}

// How much of what is behind a cloud it hides at a place on its disc: lumps, thin at the rim, nothing below the ground.
fn cloud_cover(in: ParticleOut) -> f32 {
    let r2 = dot(in.uv, in.uv);
    let lumps = value_noise(vec3<f32>(in.uv * 1.7 + 31.0 * in.looks.y, 17.0 * in.looks.y + 4.0), 63u);
    let fine = value_noise(vec3<f32>(in.uv * 4.1 + 57.0 * in.looks.y, 29.0 * in.looks.y + 9.0), 63u);
    let rim = 1.0 - smoothstep(0.05, 0.95, r2 + 1.25 * (0.62 * lumps + 0.38 * fine) - 0.52);
    let over_ground = smoothstep(-0.12, 0.42, in.rises.x);
    return rim * smoothstep(0.0, 0.55, 1.0 - r2) * over_ground;
}

// A soft clod.
fn clod_cover(in: ParticleOut) -> f32 {
    let lumps = value_noise(vec3<f32>(in.uv * 2.3 + 31.0 * in.looks.y, 17.0 * in.looks.y), 63u);
    return 1.0 - smoothstep(0.30, 0.62, dot(in.uv, in.uv) * (0.45 + lumps));
}

// A hard bit: the least of five edges says how far inside it a point is, and which of its facets that is.
struct Facet {
    inside: f32,
    tone: f32,
}

fn facet_at(in: ParticleOut) -> Facet {
    var facet = Facet(1e3, 1.0);
    for (var i = 0u; i < 5u; i++) {
        let chance = fract(in.looks.y * (17.3 + 11.7 * f32(i)) + 0.37 * f32(i));
        let angle = 1.2566371 * (f32(i) + 0.7 * chance);
        let way = vec2<f32>(cos(angle), sin(angle));
        let inside = mix(0.52, 0.86, fract(chance * 7.31)) - dot(way, in.uv);
        // Each facet leans its own way, with that it turns to the light or away.
        let tone = 0.62 + 0.75 * fract(chance * 3.77 + 0.5 * in.looks.y);
        let is_nearer = inside < facet.inside;
        facet.tone = select(facet.tone, tone, is_nearer);
        facet.inside = min(facet.inside, inside);
    }
    return facet;
}

@fragment
fn fragment_particle(in: ParticleOut) -> @location(0) vec4<f32> {
    let point = shaded_at(in.place, in.middle, in.normal, in.frame_normal);
    let facet = facet_at(in);
    let pixel = max(fwidth(facet.inside), 1e-4);
    let look = u32(in.looks.x);
    var cover = clamp(facet.inside / pixel + 0.5, 0.0, 1.0);
    // The upper side of what is round sees more of the sky.
    var tone = facet.tone;
    if look != CHIP {
        cover = select(clod_cover(in), cloud_cover(in), look == DUST);
        tone = 0.92 + 0.16 * in.rises.y;
    }
    cover *= in.lit.a;
    if is_cut(in.view) || cover < 0.004 {
        discard;
    }
    let share = key_share(point, in.clip.xy, in.dark.a > 0.5, true);
    let light = mix(in.dark.rgb, in.lit.rgb, share) * tone;
    return vec4<f32>((light * in.veil.a + in.veil.rgb) * cover, cover);
}

// Shapes of marks.
const PRINT: f32 = 0.0;

struct MarkIn {
    @builtin(vertex_index) corner: u32,
    @location(0) from_left: vec3<f32>,  // corners from the reference, metres
    @location(1) from_right: vec3<f32>,
    @location(2) to_left: vec3<f32>,
    @location(3) to_right: vec3<f32>,
    @location(4) lies: vec4<f32>,       // strength at both ends, and how far along its track those are, metres
    @location(5) shape: f32,
}

struct MarkOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) at: vec2<f32>,         // across from -1 to 1, and along it from -1 to 1
    @location(1) along: vec2<f32>,      // strength, and metres along the track
    @location(2) view: vec4<f32>,
    @location(3) @interpolate(flat) shape: f32,
}

// A mark is drawn as if it were so much nearer to the eye than it lies, metres and as a share of its distance: land is bent
// between its corners.
const NEARER_M: f32 = 0.03;
const NEARER_SHARE: f32 = 0.004;

// The same point with the depth of one that is nearer to the eye.
fn clip_before_ground(space: Space, view: vec4<f32>) -> vec4<f32> {
    let away = max(length(view.xyz), 1e-3);
    let share = max(1.0 - NEARER_M / away - NEARER_SHARE, 0.5);
    let nearer = clip_from_view(space, vec4<f32>(view.xyz * share, view.w));
    let clip = clip_from_view(space, view);
    return vec4<f32>(clip.xy, nearer.z * (clip.w / select(nearer.w, 1e-6, abs(nearer.w) < 1e-6)), clip.w);
}

@vertex
fn vertex_mark(in: MarkIn) -> MarkOut {
    let space = space_of_chart();
    let at = corner_of(in.corner);
    let from_here = select(in.from_left, in.from_right, at.x > 0.0);
    let p = select(from_here, select(in.to_left, in.to_right, at.x > 0.0), at.y > 0.0);
    let view = port_to_view(space, p);
    let clear = 1.0 - fog_at(eye_distance(space, view));
    var out: MarkOut;
    out.clip = clip_before_ground(space, view);
    out.at = at;
    out.along = vec2<f32>(select(in.lies.x, in.lies.y, at.y > 0.0) * clear, select(in.lies.z, in.lies.w, at.y > 0.0));
    out.view = view;
    out.shape = in.shape;
    return out;
}

// Metres from one bar of a tread to the next.
const TREAD_M: f32 = 0.17;

// The pattern that a tyre leaves: slanted bars on both sides, a groove in the middle, all gone where a pixel spans a bar.
fn tread(at: vec2<f32>, along_m: f32, pixel_m: f32) -> f32 {
    let slant = along_m / TREAD_M + 0.9 * abs(at.x);
    let bar = smoothstep(0.16, 0.30, abs(fract(slant) - 0.5));
    let groove = smoothstep(0.06, 0.16, abs(at.x));
    let near = 1.0 - smoothstep(0.25, 0.6, pixel_m / TREAD_M);
    return mix(0.72, bar * groove, near * 0.75);
}

@fragment
fn fragment_mark(in: MarkOut) -> @location(0) vec4<f32> {
    let pixel_m = fwidth(in.along.y);
    if is_cut(in.view) {
        discard;
    }
    let sides = 1.0 - smoothstep(0.72, 1.0, abs(in.at.x));
    let round = max(1.0 - dot(in.at, in.at), 0.0);
    let print = sides * tread(in.at, in.along.y, pixel_m);
    let cover = select(round * round, print, in.shape == PRINT) * in.along.x;
    return vec4<f32>(0.0, 0.0, 0.0, clamp(cover, 0.0, 1.0));
}
