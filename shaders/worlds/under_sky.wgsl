// Worlds under a sky: sun and moon light all of it from one direction of the axes of `in_sky_axes`, far off. What depends on
// how charts lie in those axes stands in the file behind this one. What the functions are for, lights.wgsl says.

fn grain_up(grain: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(0.0, 1.0, 0.0);
}

fn haze_before(view: vec4<f32>) -> vec3<f32> {
    return haze(direction_of(view.xyz));
}

fn daylight_on(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>, share: f32, sky: f32) -> vec3<f32> {
    return light_on(normal, share, sky);
}

fn wants_model_normal(lights: vec3<u32>) -> bool {
    return any_lit(lights);
}

// The normal, and what is left of the sky: a fixed direction's light is worked out at each point.
fn land_light(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>, albedo: vec3<f32>, sky: f32) -> LandLight {
    return LandLight(normal, vec3<f32>(sky));
}

fn daylit(light: LandLight, albedo: vec3<f32>, share: f32) -> vec3<f32> {
    return albedo * light_on(normalize(light.facing), share, light.dark.x);
}

fn land_sky(light: LandLight) -> f32 {
    return light.dark.x;
}

fn is_land_unlit(light: LandLight, view: vec4<f32>, model_normal: vec4<f32>) -> bool {
    return is_unlit(view, normalize(light.facing), model_normal);
}

fn seen_normal(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> vec3<f32> {
    return normal;
}

fn is_unlit(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> bool {
    return dot(normal, scene.key_direction) <= 0.0;
}

// By cascades round the eye.
fn land_shadow(point: Shaded, pixel: vec2<f32>) -> f32 {
    let near_end = shadow_end(shadow_away(point, 0u));
    if SHADOWS == 2u {
        let past_near = near_end >= 1.0;
        let end = select(near_end, shadow_end(shadow_away(point, 1u)), past_near);
        let read = either(point, cascade(select(0u, 1u, past_near)), cascade(select(1u, 2u, past_near)), end);
        return mix(read, point.open, shadow_end(shadow_away(point, 2u)));
    }
    let noise = shadow_noise(pixel);
    let past_middle = shadow_end(shadow_away(point, 1u)) > noise;
    let read = shadow_read(point, cascade(select(0u, select(1u, 2u, past_middle), near_end > noise)));
    return mix(read, point.open, shadow_end(shadow_away(point, 2u)));
}

