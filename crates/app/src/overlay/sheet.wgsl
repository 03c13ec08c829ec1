// What is kept of the interface, laid over a picture or emptied: within the scissors.

@group(0) @binding(0) var kept: texture_2d<f32>;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u)) * 2.0 - 1.0;
    return vec4<f32>(corner, 0.0, 1.0);
}

@fragment
fn fragment(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(kept, vec2<i32>(at.xy), 0);
}

@fragment
fn fragment_empty() -> @location(0) vec4<f32> {
    return vec4<f32>(0.0);
}
