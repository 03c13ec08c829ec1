// From light to display: filmic curve, the display's transfer curve where the target does not apply it,
// and half a step of ordered noise against banding. Scales the picture up where it was drawn smaller.

override SCALED: bool = false;
override ENCODED: bool = false;

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var smooth_sampler: sampler;

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) place: vec2<f32>,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> VertexOut {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    var out: VertexOut;
    out.clip = vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
    out.place = vec2<f32>(corner.x, 1.0 - corner.y);
    return out;
}

// K. Narkowicz's fit of the ACES reference curve, exposed so that 0.5 stays near the middle.
fn filmic(light: vec3<f32>) -> vec3<f32> {
    let x = max(light, vec3<f32>(0.0)) * 0.86;
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), vec3<f32>(0.0), vec3<f32>(1.0));
}

// The sRGB curve by square roots (I. Taylor's fit), within 0.004: powers are dear in software.
fn encode(c: vec3<f32>) -> vec3<f32> {
    let a = sqrt(c);
    let b = sqrt(a);
    return max(0.662002687 * a + 0.684122060 * b - 0.323583601 * sqrt(b) - 0.022541147 * c, vec3<f32>(0.0));
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    var light: vec3<f32>;
    if SCALED {
        light = textureSampleLevel(picture, smooth_sampler, in.place, 0.0).rgb;
    } else {
        light = textureLoad(picture, vec2<i32>(in.clip.xy), 0).rgb;
    }
    var colour = filmic(light);
    // Interleaved gradient noise (J. Jimenez), in steps of the display.
    let noise = fract(52.9829189 * fract(dot(in.clip.xy, vec2<f32>(0.06711056, 0.00583715)))) - 0.5;
    if ENCODED {
        colour = encode(colour) + noise / 255.0;
    } else {
        // A step of the display is this wide in linear light, by the slope of the sRGB curve.
        colour += noise / 255.0 * (0.08 + 2.1 * sqrt(colour));
    }
    return vec4<f32>(colour, 1.0);
}
