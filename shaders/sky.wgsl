// The sky where nothing stands before it: the haze of each direction over the whole picture, with or without clouds, then by
// night the band of faint stars. After that celestial.wgsl draws the sun, the moon and the single stars; clouds are before
// them, and so they shine only as far as the alpha there says.

@group(0) @binding(5) var band: texture_cube<f32>;
@group(0) @binding(6) var layer: texture_2d<f32>;
@group(0) @binding(7) var smooth_sampler: sampler;

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) ray: vec3<f32>,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> VertexOut {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u)) * 2.0 - 1.0;
    var out: VertexOut;
    // Depth 0 is infinitely far in reversed depth.
    out.clip = vec4<f32>(corner, 0.0, 1.0);
    out.ray = scene.front
        + scene.right * (corner.x / scene.space.focal_x)
        + scene.up * (corner.y / scene.space.focal_y);
    return out;
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    return vec4<f32>(haze(normalize(in.ray)), 1.0);
}

// The band turns about x with the sun, as the stars do.
@fragment
fn fragment_band(in: VertexOut) -> @location(0) vec4<f32> {
    let d = normalize(in.ray);
    let s = scene.star_sine;
    let c = scene.star_cosine;
    let at_sunrise = vec3<f32>(d.x, c * d.y + s * d.z, c * d.z - s * d.y);
    let light = textureSampleLevel(band, smooth_sampler, at_sunrise, 0.0).rgb;
    let over_horizon = smoothstep(0.0, 0.25, d.y);
    return vec4<f32>(light * (0.55 * scene.star_strength * over_horizon), 0.0);
}

// Clouds lie in a level layer as many heights away as the ray needs to get up to it. They drift, and seen through a
// second, slower layer of themselves they change their shape.
const CLOUD_SCALE: f32 = 0.11;
const CLOUD_TEXELS: f32 = 256.0;
// Whole repetitions of the picture over a day, so that nothing jumps at its end.
const WIND: vec2<f32> = vec2<f32>(1.0, 1.0);
const SLOW_WIND: vec2<f32> = vec2<f32>(1.0, 0.0);

// How far towards the light is looked for what shades a cloud: three texels. `heavens.rs` puts the fall over so many along
// both axes into the picture.
const TOWARD: f32 = 3.0 / CLOUD_TEXELS;
const GROUPED: f32 = 0.37;

// Thickness of the clouds, and how much that falls on the way towards the light. Both are read half way there: four reads
// of the picture would be dear in software.
fn thickness(at: vec2<f32>, toward: vec2<f32>, level: f32) -> vec2<f32> {
    let drift = scene.cloud_drift;
    let middle = at + toward * (0.5 * TOWARD);
    let heaps = textureSampleLevel(layer, smooth_sampler, middle + drift * WIND, level);
    let groups = textureSampleLevel(layer, smooth_sampler, GROUPED * middle + drift * SLOW_WIND + 0.31, level);
    let both = 0.62 * vec2<f32>(heaps.r, slope(heaps, toward)) + 0.38 * vec2<f32>(groups.r, GROUPED * slope(groups, toward));
    return vec2<f32>(both.x + 0.5 * both.y, both.y);
}

fn slope(texel: vec4<f32>, toward: vec2<f32>) -> f32 {
    return 2.0 * dot(texel.gb - 127.0 / 255.0, toward);
}

// The sky with clouds. What is left of the light from behind them goes into the alpha, for what is drawn there.
@fragment
fn fragment_clouds(in: VertexOut) -> @location(0) vec4<f32> {
    let d = normalize(in.ray);
    let behind = haze(d);
    let rise = max(d.y, 0.0) + 0.06;
    let at = d.xz / rise * CLOUD_SCALE;
    // A pixel's width in the layer grows with the square of the way there.
    let pixel = scene.pixel_height / scene.space.focal_y;
    let level = clamp(log2(CLOUD_SCALE * CLOUD_TEXELS * pixel / (rise * rise)), 0.0, 6.0);
    let toward = normalize(scene.key_direction.xz + vec2<f32>(1.0e-3, 0.0));
    let thick = thickness(at, toward, level);
    let clear = 0.74 - 0.48 * scene.cloud_cover;
    let cover = smoothstep(clear, clear + 0.22, thick.x) * smoothstep(0.015, 0.16, d.y);
    // Thinner towards the light means that light comes through to this side.
    let shaded = clamp(0.5 + 3.2 * thick.y, 0.0, 1.0);
    let near_sun = max(dot(d, scene.key_direction), 0.0);
    let near2 = near_sun * near_sun;
    let lining = near2 * near2 * near2 * near2 * (1.0 - cover);
    let lit = scene.key_colour * (0.22 + 0.34 * shaded + 0.5 * lining)
        + scene.ambient_sky * 0.62 + scene.horizon * 0.12;
    let opacity = cover * 0.94;
    let colour = mix(behind, lit, smoothstep(0.0, 0.35, d.y));
    return vec4<f32>(mix(behind, colour, opacity), 1.0 - opacity);
}
