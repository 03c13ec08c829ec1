// How surfaces look: what rays and whoever draws the same rooms in another way have in common. Takes plain numbers only.
// Colours are linear light; directions and distances are felt ones.

// Share of the fog at a distance: little at first, complete at `complete_m`.
fn fog_share(distance_m: f32, complete_m: f32) -> f32 {
    let x = clamp(distance_m / complete_m, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x) * x;
}

// The sky in a direction: `up` is where the zenith is.
fn sky_light(direction: vec3<f32>, up: vec3<f32>, top: vec3<f32>, horizon: vec3<f32>, ground: vec3<f32>) -> vec3<f32> {
    let height = dot(direction, up);
    let low = 1.0 - clamp(height, 0.0, 1.0);
    let low2 = low * low;
    return mix(mix(top, horizon, low2 * low2), ground, smoothstep(0.0, 0.25, -height));
}

// Light from all about on a surface of normal n.
fn ambient_light(n: vec3<f32>, up: vec3<f32>, sky: vec3<f32>, ground: vec3<f32>) -> vec3<f32> {
    return mix(ground, sky, 0.5 + 0.5 * dot(n, up));
}

// The share of a lamp's light that comes through a felt distance, as in lights.wgsl: none at `reach_m`.
fn lamp_through(distance_m: f32, reach_m: f32) -> f32 {
    let share = distance_m / reach_m;
    let fade = max(1.0 - share * share * share * share, 0.0);
    return fade * fade / (1.0 + 0.24 * distance_m * distance_m);
}

// Diffuse light of a lamp by the cosine between normal and way, wrapped a little round edges.
fn lamp_diffuse(cosine: f32) -> f32 {
    return max(0.9 * cosine + 0.1, 0.0);
}

// Specular light (J. Blinn's half way between the ways to the light and to the eye).
fn shine(n: vec3<f32>, to_light: vec3<f32>, to_eye: vec3<f32>) -> f32 {
    return pow(max(dot(n, normalize(to_light + to_eye)), 0.0), 48.0);
}

// Share of the second colour of a checker of squares of edge 1, averaged over `width` of them along each way
// (I. Quilez' box filter: the integral of a square wave is a triangle wave).
fn checker_share(p: vec2<f32>, width: vec2<f32>) -> f32 {
    let w = max(width, vec2<f32>(1.0e-4));
    let low = abs(fract((p - 0.5 * w) * 0.5) - 0.5);
    let high = abs(fract((p + 0.5 * w) * 0.5) - 0.5);
    let wave = 2.0 * (low - high) / w;
    return 0.5 - 0.5 * wave.x * wave.y;
}
