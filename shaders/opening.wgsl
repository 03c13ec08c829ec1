// The opening of a door: each pixel shows what was drawn there of the other side, which has its own distances and haze.

@group(2) @binding(0) var beyond: texture_2d<f32>;

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) view: vec4<f32>,
}

@vertex
fn vertex(@location(0) offset: vec3<f32>) -> VertexOut {
    let space = space_of_chart();
    var out: VertexOut;
    out.view = port_to_view(space, offset);
    out.clip = clip_from_view(space, out.view);
    return out;
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    let light = textureLoad(beyond, vec2<i32>(in.clip.xy), 0).rgb;
    if is_cut(in.view) {
        discard;
    }
    return vec4<f32>(light, 1.0);
}

// Behind a door that is seen through a door there is haze.
@fragment
fn fragment_haze(in: VertexOut) -> @location(0) vec4<f32> {
    if is_cut(in.view) {
        discard;
    }
    return vec4<f32>(scene.horizon, 1.0);
}
