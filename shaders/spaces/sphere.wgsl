// The sphere: the cylindrical chart about the pole of a hemisphere, which is the reference.

// That of hemisphere A; what turns it into another chart's is in `space.view`.
fn port(space: Space, p: vec3<f32>) -> vec4<f32> {
    let k = space.k_per_m;
    let u = k * p;
    let level = geo_sinc_cos(u.x * u.x + u.z * u.z);
    let upright = geo_sinc_cos(u.y * u.y);
    return vec4<f32>(
        upright.y * level.x * p.x,
        upright.x * p.y,
        upright.y * level.x * p.z,
        upright.y * level.y,
    );
}

fn port_normal(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec3<f32> {
    let u = space.k_per_m * p;
    let upright = geo_sinc_cos(u.y * u.y).y;
    return geo_normal_cylindrical(n, u, u.x * u.x + u.z * u.z, upright, -1.0, 1.0);
}

// The chart stands on its ground.
fn frame_vector(space: Space, p: vec3<f32>, n: vec3<f32>) -> vec4<f32> {
    let k = space.k_per_m;
    let m = geo_frame_cylindrical(n, k * vec2<f32>(p.x, p.z), k * p.y, 1.0);
    let radius = space.radius_m;
    let view = space.view * vec4<f32>(radius * m.xyz, m.w);
    return vec4<f32>(view.xyz / radius, view.w);
}

// A line through w = 0 to the antipode.
fn depth_of(space: Space, v: vec4<f32>) -> f32 {
    return 0.5 * (space.near_m * v.w - v.z);
}

fn eye_distance(space: Space, v: vec4<f32>) -> f32 {
    return space.radius_m * geo_angle(geo_length(v.xyz) * space.k_per_m, v.w);
}

fn curvature_of(space: Space) -> vec2<f32> {
    return vec2<f32>(1.0, space.k_per_m);
}
