// What every pass over the scene shares: the light and sky of the moment, haze, and value noise.
// Follows the text of a map. Colours are linear light; directions are unit vectors in the axes of `in_sky_axes`.

// Figures whose shade on the ground is drawn: the nearest ones.
const SHADES: u32 = 8u;

// What bends leaves and grass at once: the nearest ones.
const PRESSERS: u32 = 8u;

// Lamps and beams that can be lit at once.
const LAMPS: u32 = 64u;
const BEAMS: u32 = 16u;

// Maps of the key light's shadows.
const SHADOW_MAPS: u32 = 8u;

// Light that goes all ways from a place.
struct Lamp {
    place: vec4<f32>,   // in view coordinates, w in metres
    colour: vec3<f32>,
    fades_per_m2: f32,  // one over the square of the chord at which it has faded away
}

// Light that goes one way from a place.
struct Beam {
    place: vec4<f32>,   // as above
    axis: vec4<f32>,    // the way it goes there, a unit vector in view coordinates
    colour: vec3<f32>,
    fades_per_m2: f32,  // as above
    full_cosine: f32,   // of the angle within which it is full
    dark_cosine: f32,   // of the angle outside which there is none
    behind: vec4<f32>,  // a covector of view coordinates: nothing is lit that has a negative product with it
}

// A map of depth as the key light sees it.
struct ShadowMap {
    clip: mat4x4<f32>,  // to its clip coordinates, from metres from the reference; in a closed world from view coordinates
    layer: f32,
    texel_depth: f32,   // depth of a texel's length where w is 1
    weight: f32,        // how far it is to be trusted, 0 to 1
    hand: f32,          // 1, or -1 for a mirrored picture
}

struct Shadows {
    maps: array<ShadowMap, SHADOW_MAPS>,
    strength: f32,      // of the key light's shadows, 0 to 1
    side_texels: f32,   // of a map
    texel: f32,         // one over that
    by_moon: f32,       // 1 where a closed world's moon throws them
}

// What presses down and aside what grows about it: a car, or feet.
struct Presser {
    place: vec3<f32>,   // the middle of where it touches the ground, from the reference, m
    reach_m: f32,       // how far from its line it presses
    along: vec3<f32>,   // from the middle to the end of its line, m
    height_m: f32,      // what is higher over its ground is left alone
    up: vec3<f32>,      // away from the ground, a unit vector
    strength: f32,      // the share of the way to the ground that it presses
}

// The chart of what is drawn.
struct Chart {
    view: mat4x4<f32>,      // from its ported points, xyz in metres and w without unit, to view coordinates
    home: mat4x4<f32>,      // to the model in which light is told, that of the first chart or of the eye's
    fraction: vec3<f32>,    // the reference from the whole metres that its chunks are measured from
    joins: u32,             // how a square is joined to those about it: a bit for each side, where it comes second, and three for
                            // each corner, how many turns it is from the one that comes first
    domain_low: vec2<f32>,  // a rectangle past which other charts draw the land: least x and z from the reference,
    domain_high: vec2<f32>, // and greatest
    origin: vec4<f32>,      // where the reference lies in the chart, as the map tells it: `Space`
    north: vec4<f32>,       // xy: towards the ideal point in the north, a unit vector of x and z at the chart's middle
    pressers: array<Presser, PRESSERS>,
}

struct Scene {
    space: Space,
    right: vec3<f32>,           // to the right of the picture
    time_s: f32,
    up: vec3<f32>,              // upwards in the picture
    contour_strength: f32,      // of the contour bands
    front: vec3<f32>,           // into the picture
    fog_distance_m: f32,        // at which the fog is complete
    top: vec3<f32>,             // sky overhead, in a closed world the haze about the eye
    star_strength: f32,
    horizon: vec3<f32>,         // sky at the horizon, in a closed world the haze of full day
    star_sine: f32,             // of the turn of the stars about x
    glare: vec3<f32>,           // the sun's disc and glow
    star_cosine: f32,           // of that turn
    sun: vec3<f32>,             // towards the sun
    cloud_drift: f32,           // how far clouds have drifted, 0 to 1 over a day
    moon: vec3<f32>,            // towards the moon
    cloud_cover: f32,           // share of the sky that clouds cover
    key_direction: vec3<f32>,   // towards the key light
    pixel_width: f32,           // in clip units
    key_colour: vec3<f32>,
    pixel_height: f32,          // in clip units
    ambient_sky: vec3<f32>,
    orb_radius: f32,            // of a closed world's sun and moon, radii
    ambient_ground: vec3<f32>,
    ring_edges: f32,            // how dark the edges of the ring are, 0 to 1
    moon_colour: vec3<f32>,     // moonlight at its full
    covered: f32,               // how much the land over the eye covers the sky there, 0 to 1
    sun_place: vec4<f32>,       // of a closed world's sun, a unit vector of the model in view coordinates
    moon_place: vec4<f32>,      // of its moon
    ring_centre: vec4<f32>,     // the middle of the ring about what is dug or built: xyz from the reference, m; in a
                                // closed world in view coordinates
    ring_light: vec3<f32>,
    ring_radius_m: f32,         // 0 for none
    ring_x: vec4<f32>,          // in a closed world, metres of the chart along x for a difference in view coordinates,
    ring_y: vec4<f32>,          // and along y and z
    ring_z: vec4<f32>,
    wind: vec4<f32>,            // turns of its gusts and of what flutters in them, radians, and how far it bends a blade's tip, m
    ring_ground: vec4<f32>,     // as what the land within the ring is shown: a kind's colour and its number, 0 as it is
    cuts: mat4x4<f32>,          // columns: covectors of view coordinates; what has a negative product with one is cut off
    figure_cut: vec4<f32>,      // one that cuts figures only
    shades: array<vec4<f32>, SHADES>, // xyz: feet from the reference, m
    lamps: array<Lamp, LAMPS>,
    beams: array<Beam, BEAMS>,
    shadows: Shadows,
}

@group(1) @binding(0) var<uniform> scene: Scene;
@group(1) @binding(1) var<uniform> chart: Chart;

// Whether this view is cut at all: pictures that are not are drawn by pipelines without what that takes.
override CUTS: bool = false;
// Whether land shows the surfaces of its kinds and is lit by pixel; else it has the biome's colours alone, and in closed
// worlds light from the corners of its triangles.
override BY_PIXEL: bool = false;

// Whether a view point is cut off. To be asked after everything that looks at the next pixel.
fn is_cut(view: vec4<f32>) -> bool {
    return CUTS && any(view * scene.cuts < vec4<f32>(0.0));
}

// The space, for points of the chart.
fn space_of_chart() -> Space {
    var space = scene.space;
    space.view = chart.view;
    space.origin = chart.origin;
    return space;
}

// Direction, at the eye, in which a view point is seen.
fn direction_of(view: vec3<f32>) -> vec3<f32> {
    return normalize(scene.right * view.x + scene.up * view.y - scene.front * view.z);
}

// The sky without disc, moon and stars; land fades into it, so that its edge never shows.
fn haze(direction: vec3<f32>) -> vec3<f32> {
    let low = 1.0 - clamp(direction.y, 0.0, 1.0);
    let low2 = low * low;
    let gradient = mix(scene.top, scene.horizon, low2 * low2);
    let toward = max(dot(direction, scene.sun), 0.0);
    let toward2 = toward * toward;
    let toward4 = toward2 * toward2;
    let toward8 = toward4 * toward4;
    let glow = 0.10 * toward2 * low2 + 0.22 * toward8;
    return gradient + scene.glare * glow;
}

// Share of the fog at a distance in the space: little at first, complete at the fog distance.
fn fog_at(distance_m: f32) -> f32 {
    let x = clamp(distance_m / scene.fog_distance_m, 0.0, 1.0);
    let x2 = x * x;
    let x4 = x2 * x2;
    return 0.42 * x2 + 0.58 * x4 * x2;
}

// Cosine of the angle to the key from which on what is lit counts as such for what is bounced about: what turns away is
// as dark as what lies in a shadow, so that in one no edge is seen where land turns to the light.
const FACING: f32 = 0.2;

// What is left of the light from all around where no sky is: so that one finds the way out of a hole.
const DEEPEST_SKY: f32 = 0.10;

// Warm key and cool ambient from above, bounce from below: nothing is black.
// `share` of the key reaches the place; in a shadow less of it is bounced about, too. So much of the `sky` is seen from there.
fn light_on(normal: vec3<f32>, share: f32, sky: f32) -> vec3<f32> {
    let facing = dot(normal, scene.key_direction);
    // Land is flat between its vertices and its normals are not: triangles turn away one by one before they do. Light
    // that has all but gone by then shows no edges of theirs.
    let turned = smoothstep(0.0, FACING, facing);
    let key = max(facing, 0.0) * turned;
    let wrap = 0.06 * (1.0 - abs(facing)) + 0.05;
    let upward = 0.5 + 0.5 * normal.y;
    let bounced = wrap * (0.4 + 0.6 * share * turned) * sky;
    return scene.key_colour * (0.78 * key * share + bounced)
        + mix(scene.ambient_ground, scene.ambient_sky, upward) * sky;
}

// sRGB to linear light; cubic fit of the standard's curve, within 0.003.
fn to_linear(c: vec3<f32>) -> vec3<f32> {
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}

fn mix_bits(h: u32) -> f32 {
    let a = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    return f32((a ^ (a >> 13u)) & 0xffffu) * (1.0 / 65535.0);
}

// Value noise from 0 to 1 on the unit lattice, repeating after `mask + 1` cells (a power of two).
fn value_noise(p: vec3<f32>, mask: u32) -> f32 {
    let base = floor(p);
    let f = p - base;
    let s = f * f * (3.0 - 2.0 * f);
    let c0 = vec3<u32>(vec3<i32>(base)) & vec3<u32>(mask);
    let c1 = (c0 + vec3<u32>(1u)) & vec3<u32>(mask);
    let prime = vec3<u32>(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du);
    let h0 = c0 * prime;
    let h1 = c1 * prime;
    let a = h0.y ^ h0.z;
    let b = h1.y ^ h0.z;
    let c = h0.y ^ h1.z;
    let d = h1.y ^ h1.z;
    let x00 = mix(mix_bits(h0.x ^ a), mix_bits(h1.x ^ a), s.x);
    let x10 = mix(mix_bits(h0.x ^ b), mix_bits(h1.x ^ b), s.x);
    let x01 = mix(mix_bits(h0.x ^ c), mix_bits(h1.x ^ c), s.x);
    let x11 = mix(mix_bits(h0.x ^ d), mix_bits(h1.x ^ d), s.x);
    return mix(mix(x00, x10, s.y), mix(x01, x11, s.y), s.z);
}
