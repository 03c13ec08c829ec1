// Sun, moon and stars: small patches of light added to the sky, so that the rest of it stays cheap.

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) place: vec2<f32>,      // from the middle of the patch, 1 at its edge
    @location(1) light: vec3<f32>,
    @location(2) view: vec4<f32>,       // of a body that stands in the world
}

// Corners of two triangles that make a square of half width 1.
fn corner_of(index: u32) -> vec2<f32> {
    let right = index == 1u || index == 2u || index == 4u;
    let top = index == 2u || index == 4u || index == 5u;
    return vec2<f32>(select(-1.0, 1.0, right), select(-1.0, 1.0, top));
}

// Clip coordinates of a chart direction, infinitely far away.
fn clip_of(direction: vec3<f32>) -> vec4<f32> {
    return vec4<f32>(
        scene.space.focal_x * dot(direction, scene.right),
        scene.space.focal_y * dot(direction, scene.up),
        0.0,
        dot(direction, scene.front),
    );
}

// The corner of a square patch across the sky, `reach` being the tangent of its angular half width.
fn patch_corner(middle: vec3<f32>, corner: vec2<f32>, reach: f32) -> vec4<f32> {
    let other = select(vec3<f32>(0.0, 1.0, 0.0), vec3<f32>(1.0, 0.0, 0.0), abs(middle.y) > 0.9);
    let across = normalize(cross(other, middle));
    let along = cross(middle, across);
    return clip_of(middle + (across * corner.x + along * corner.y) * reach);
}

const SUN_REACH: f32 = 0.36;
const SUN_DISC: f32 = 0.105;            // share of the reach
const MOON_REACH: f32 = 0.16;
const MOON_DISC: f32 = 0.25;

@vertex
fn vertex_sun(@builtin(vertex_index) index: u32) -> VertexOut {
    let corner = corner_of(index);
    var out: VertexOut;
    out.clip = patch_corner(scene.sun, corner, SUN_REACH);
    out.place = corner;
    out.light = scene.glare * smoothstep(-0.10, 0.0, scene.sun.y);
    return out;
}

@fragment
fn fragment_sun(in: VertexOut) -> @location(0) vec4<f32> {
    let away = length(in.place);
    let near = max(1.0 - away, 0.0);
    let near2 = near * near;
    let disc = 1.0 - smoothstep(SUN_DISC * 0.9, SUN_DISC, away);
    return vec4<f32>(in.light * (disc * 12.0 + 0.75 * near2 * near2 * near2 + 0.10 * near2), 0.0);
}

@vertex
fn vertex_moon(@builtin(vertex_index) index: u32) -> VertexOut {
    let corner = corner_of(index);
    var out: VertexOut;
    out.clip = patch_corner(scene.moon, corner, MOON_REACH);
    out.place = corner;
    let risen = smoothstep(-0.06, 0.02, scene.moon.y);
    out.light = vec3<f32>(0.80, 0.86, 1.0) * (risen * (0.10 + 0.90 * scene.star_strength));
    return out;
}

@fragment
fn fragment_moon(in: VertexOut) -> @location(0) vec4<f32> {
    let away = length(in.place);
    let near = max(1.0 - away, 0.0);
    let disc = 1.0 - smoothstep(MOON_DISC * 0.95, MOON_DISC, away);
    let seas = smoothstep(0.42, 0.66, value_noise(vec3<f32>(in.place * 11.0 + 40.0, 3.5), 255u));
    let roundness = 1.0 - 0.35 * away * away / (MOON_DISC * MOON_DISC);
    return vec4<f32>(in.light * (disc * roundness * (0.80 - 0.34 * seas) + 0.045 * near * near * near), 0.0);
}

struct StarIn {
    @location(0) direction: vec3<f32>,
    @location(1) light: vec4<f32>,      // linear light; a: half width in pixels
}

@vertex
fn vertex_star(star: StarIn, @builtin(vertex_index) index: u32) -> VertexOut {
    // The stars turn about x with the sun.
    let s = scene.star_sine;
    let c = scene.star_cosine;
    let d = star.direction;
    let turned = vec3<f32>(d.x, c * d.y - s * d.z, s * d.y + c * d.z);
    let corner = corner_of(index);
    let middle = clip_of(turned);
    var out: VertexOut;
    let pixel = vec2<f32>(scene.pixel_width, scene.pixel_height);
    out.clip = middle + vec4<f32>(corner * pixel * (star.light.a * middle.w), 0.0, 0.0);
    out.place = corner;
    out.light = star.light.rgb * (scene.star_strength * smoothstep(-0.02, 0.16, turned.y));
    return out;
}

@fragment
fn fragment_star(in: VertexOut) -> @location(0) vec4<f32> {
    let near = max(1.0 - dot(in.place, in.place), 0.0);
    return vec4<f32>(in.light * (near * near), 0.0);
}

// Sun and moon of a closed world stand in it and so have a depth. Their patches reach ORB_REACH radii of the body
// across, along two unit vectors of the tangent space at its middle s: whatever is square to s.xyz, with w = 0.
const ORB_REACH: f32 = 7.0;

@vertex
fn vertex_orb(@builtin(vertex_index) index: u32, @builtin(instance_index) instance: u32) -> VertexOut {
    let is_sun = instance == 0u;
    let middle = select(scene.moon_place, scene.sun_place, is_sun);
    let toward = middle.xyz / max(length(middle.xyz), 1.0e-6);
    let other = select(vec3<f32>(0.0, 1.0, 0.0), vec3<f32>(1.0, 0.0, 0.0), abs(toward.y) > 0.9);
    let across = normalize(cross(other, toward));
    let along = cross(toward, across);
    let corner = corner_of(index);
    let at = middle + vec4<f32>(across * corner.x + along * corner.y, 0.0) * (ORB_REACH * scene.orb_radius);
    let space = scene.space;
    var out: VertexOut;
    out.view = vec4<f32>(at.xyz / space.k_per_m, at.w);
    out.clip = clip_from_view(space, out.view);
    out.place = corner;
    out.light = select(vec3<f32>(0.20, 0.24, 0.34), vec3<f32>(3.4, 2.6, 1.5), is_sun);
    return out;
}

@fragment
fn fragment_orb(in: VertexOut) -> @location(0) vec4<f32> {
    if is_cut(in.view) {
        discard;
    }
    let away = length(in.place);
    let near = max(1.0 - away, 0.0);
    let near2 = near * near;
    let disc = 1.0 - smoothstep(0.92 / ORB_REACH, 1.0 / ORB_REACH, away);
    return vec4<f32>(in.light * (disc * 1.6 + 0.22 * near2 * near2 + 0.03 * near2), 0.0);
}
