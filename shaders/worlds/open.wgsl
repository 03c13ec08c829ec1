// Charts whose axes are those of the first one but for a turn about the upright: the sky's axes are these, and shadows are told
// in them.

// About the upright only x and z turn.
fn in_common_axes(v: vec3<f32>) -> vec3<f32> {
    let turned = chart.home[0].xz * v.x + chart.home[2].xz * v.z;
    return vec3<f32>(turned.x, v.y, turned.y);
}

fn in_sky_axes(p: vec3<f32>, v: vec3<f32>) -> vec3<f32> {
    return in_common_axes(v);
}

fn grain_point(wrapped: vec3<f32>, p: vec3<f32>) -> vec3<f32> {
    return wrapped;
}

fn grain_at(grain: vec3<f32>) -> vec3<f32> {
    return grain;
}

// The grain's axes are the common ones. Lamps see the ground as it is without its slope.
fn tilted(normal: vec3<f32>, model_normal: vec4<f32>, slope: vec3<f32>, steps: Steps) -> Tilted {
    let along = slope - normal * dot(normal, slope);
    return Tilted(normalize(normal - along), model_normal);
}

fn from_ring(place: vec3<f32>, view: vec4<f32>) -> vec3<f32> {
    return place - scene.ring_centre.xyz;
}

fn caster_point(p: vec3<f32>) -> vec4<f32> {
    return vec4<f32>(p, 1.0);
}

fn shadow_place(place: vec3<f32>, view: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(place, 1.0);
}

fn shaded_at(place: vec3<f32>, view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> Shaded {
    if SHADOWS == 0u {
        return NOT_SHADED;
    }
    let faced = surely_faced(dot(normalize(normal), scene.key_direction));
    let right = vec4<f32>(dpdx(place), 0.0);
    let below = vec4<f32>(dpdy(place), 0.0);
    return Shaded(vec4<f32>(place, 1.0), right, below, faced, 1.0);
}

fn shadow_away(point: Shaded, number: u32) -> f32 {
    let c = scene.shadows.maps[number].clip * point.at;
    return max(abs(c.x), abs(c.y));
}

fn on_map(c: vec4<f32>, x: vec4<f32>, y: vec4<f32>) -> OnMap {
    return OnMap(c.xyz, x.xyz, y.xyz, 1.0);
}
