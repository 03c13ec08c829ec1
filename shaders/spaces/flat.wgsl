// Flat space: the chart as it is, before an ordinary camera.

fn port(space: Space, p: vec3<f32>) -> vec4<f32> {
    return vec4<f32>(p, 1.0);
}

fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec3<f32> {
    return normalize(n);
}

fn frame_vector(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec4<f32> {
    return vec4<f32>((space.view * vec4<f32>(n, 0.0)).xyz, 0.0);
}

// n/d, once it is divided by the distance ahead.
fn depth_of(space: Space, v: vec4<f32>) -> f32 {
    return space.near_m;
}

fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    return geo_length(v.xyz);
}

fn curvature_of(space: Space) -> vec2<f32> {
    return vec2<f32>(1.0, 0.0);
}
