// From light to display: filmic curve, the display's transfer curve where the target does not apply it,
// and half a step of ordered noise against banding. Scales the picture up where it was drawn smaller, and swaps its sides
// where a mirror shows it.

override SCALED: bool = false;
override SWAPPED: bool = false;
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
    out.place = vec2<f32>(select(corner.x, 1.0 - corner.x, SWAPPED), 1.0 - corner.y);
    return out;
}

// Light to display values in one step: K. Narkowicz's fit of the ACES reference curve at exposure 0.86 and the
// sRGB curve after it, together a ratio of quadratics in the root, within 0.004. Powers are dear in software.
fn display(light: vec3<f32>) -> vec3<f32> {
    let s = sqrt(max(light, vec3<f32>(0.0)));
    return clamp(s * (5.0722800 * s - 0.0913628) / (s * (5.1017517 * s - 0.5063058) + 1.0), vec3<f32>(0.0), vec3<f32>(1.0));
}

// The sRGB curve backwards, for targets that apply it themselves.
fn decode(c: vec3<f32>) -> vec3<f32> {
    return select(pow((c + 0.055) / 1.055, vec3<f32>(2.4)), c / 12.92, c <= vec3<f32>(0.04045));
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    var light: vec3<f32>;
    if SCALED {
        light = textureSampleLevel(picture, smooth_sampler, in.place, 0.0).rgb;
    } else {
        light = textureLoad(picture, vec2<i32>(in.clip.xy), 0).rgb;
    }
    // Interleaved gradient noise (J. Jimenez), one step of the display wide.
    let noise = fract(52.9829189 * fract(dot(in.clip.xy, vec2<f32>(0.06711056, 0.00583715)))) - 0.5;
    let colour = display(light) + noise * (1.0 / 255.0);
    if ENCODED {
        return vec4<f32>(colour, 1.0);
    }
    return vec4<f32>(decode(max(colour, vec3<f32>(0.0))), 1.0);
}
