// The sky where nothing stands before it: the haze of each direction, over the whole picture.
// The sun, the moon and the stars are drawn over it by celestial.wgsl.

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
    out.ray = scene.front.xyz
        + scene.right.xyz * (corner.x / scene.space.project.x)
        + scene.up.xyz * (corner.y / scene.space.project.y);
    return out;
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    return vec4<f32>(haze(normalize(in.ray)), 1.0);
}
