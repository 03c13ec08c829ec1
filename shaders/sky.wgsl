// The sky, where nothing stands before it: gradient, sun, moon and stars by the chart direction of each pixel.

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

// One star in some cells of a grid that turns with the sun; round, at least a pixel wide.
fn stars(direction: vec3<f32>) -> f32 {
    let s = scene.glare.w;
    let c = scene.sun.w;
    let turned = vec3<f32>(direction.x, c * direction.y + s * direction.z, c * direction.z - s * direction.y);
    let p = turned * 72.0 + 512.0;
    let cell = floor(p);
    let key = vec3<u32>(cell) * vec3<u32>(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du);
    let h = key.x ^ key.y ^ key.z;
    let chance = mix_bits(h);
    if chance > 0.10 {
        return 0.0;
    }
    let place = 0.25 + 0.5 * vec3<f32>(mix_bits(h + 17u), mix_bits(h + 71u), mix_bits(h + 131u));
    let apart = length(p - cell - place);
    let size = 0.10 + 0.12 * mix_bits(h + 191u);
    let bright = 0.25 + 1.6 * pow(mix_bits(h + 251u), 4.0);
    return bright * (1.0 - smoothstep(0.0, size, apart));
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    let direction = normalize(in.ray);
    var colour = haze(direction);
    let above = smoothstep(-0.02, 0.10, direction.y);
    if scene.top.w > 0.0 && above > 0.0 {
        colour += vec3<f32>(0.85, 0.92, 1.0) * (stars(direction) * scene.top.w * above);
    }
    let to_sun = dot(direction, scene.sun.xyz);
    if to_sun > 0.9 {
        let near = 1.0 - clamp((1.0 - to_sun) * 10.0, 0.0, 1.0);
        let near4 = near * near * near * near;
        let disc = smoothstep(0.99915, 0.99945, to_sun);
        colour += scene.glare.rgb * (disc * 14.0 + near4 * near4 * 0.9) * smoothstep(-0.06, 0.0, direction.y);
    }
    let to_moon = dot(direction, scene.moon.xyz);
    if to_moon > 0.99 {
        let disc = smoothstep(0.99915, 0.99930, to_moon);
        let seas = value_noise(direction * 60.0 + 64.0, 255u);
        let halo = clamp((to_moon - 0.99) * 100.0, 0.0, 1.0);
        let lit = vec3<f32>(0.80, 0.86, 1.0) * (disc * (0.9 - 0.45 * smoothstep(0.45, 0.7, seas)) + 0.05 * halo * halo);
        colour += lit * (smoothstep(-0.04, 0.02, direction.y) * (0.15 + 0.85 * scene.top.w));
    }
    return vec4<f32>(colour, 1.0);
}
