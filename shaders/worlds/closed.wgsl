// Closed worlds: sun and moon stand in the space itself, a unit three-sphere, and light it from their points, so that
// light and shadows are told in view coordinates. What the functions are for, lights.wgsl says.

// What is left by night of the haze and of the light from all around; crates/scene/src/closed_day.rs.
const NIGHT_HAZE: vec3<f32> = vec3<f32>(0.055, 0.065, 0.10);
const NIGHT_AMBIENT: vec3<f32> = vec3<f32>(0.13, 0.15, 0.23);
// Cosines of the distance from the sun past which it is night and within which it is full day.
const NIGHT: f32 = -0.08;
const DAY: f32 = 0.48;

// A view point as a unit vector of the model.
fn model_of(view: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(view.xyz * scene.space.k_per_m, view.w);
}

// How much of the day's light there is at a place, 0 to 1.
fn daylight_at(model: vec4<f32>) -> f32 {
    return smoothstep(NIGHT, DAY, dot(model, scene.sun_place));
}

// Where the light that throws shadows stands, in view coordinates.
fn key_body() -> vec4<f32> {
    return mix(scene.sun_place, scene.moon_place, scene.shadows.by_moon);
}

// Charts have nothing in common but the equator: what is told of two of them is told in view coordinates.
fn in_common_axes(v: vec3<f32>) -> vec3<f32> {
    return v;
}

fn in_sky_axes(p: vec3<f32>, v: vec3<f32>) -> vec3<f32> {
    return v;
}

// The place on the sphere, since two charts agree at the equator there alone. Their places are not wrapped: p is one, from
// the chart's middle.
fn grain_point(wrapped: vec3<f32>, p: vec3<f32>) -> vec3<f32> {
    let radius = scene.space.radius_m;
    let r = max(length(p.xz), 1e-3);
    let sine = sin(r / radius) / r;
    let home = chart.home * vec4<f32>(sine * p.x, 0.0, sine * p.z, cos(r / radius));
    return (radius + p.y) * home.xwz;
}

fn grain_at(grain: vec3<f32>) -> vec3<f32> {
    return grain;
}

fn grain_up(grain: vec3<f32>) -> vec3<f32> {
    return normalize(grain);
}

// The slope along the ground, from what the height changes by to the next pixels: with the ways a and b to those, a vector
// p a + q b rises by (hx, hy) over them where <p a + q b, a> = hx and <p a + q b, b> = hy.
fn tilted(normal: vec3<f32>, model_normal: vec4<f32>, slope: vec3<f32>, steps: Steps) -> Tilted {
    let to_metres = vec4<f32>(1.0, 1.0, 1.0, scene.space.radius_m);
    let a = steps.view_x * to_metres;
    let b = steps.view_y * to_metres;
    let rise = vec2<f32>(dot(slope, steps.grain_x), dot(slope, steps.grain_y));
    let aa = dot(a, a);
    let ab = dot(a, b);
    let bb = dot(b, b);
    let inverse = 1.0 / max(aa * bb - ab * ab, 1e-14);
    let along = (a * (bb * rise.x - ab * rise.y) + b * (aa * rise.y - ab * rise.x)) * inverse;
    let held = along * min(1.0, 1.6 * inverseSqrt(max(dot(along, along), 1e-8)));
    return Tilted(normal, normalize(model_normal - held));
}

// The mean of the haze about the eye and that about the point.
fn haze_before(view: vec4<f32>) -> vec3<f32> {
    let there = scene.horizon * mix(NIGHT_HAZE, vec3<f32>(1.0), daylight_at(model_of(view)));
    return 0.5 * (scene.top + there);
}

// The cosine between the normal n and the way to a body s is <n, s> over the sine of the distance, n being square to the
// point. `up` is the normal's share of the way up.
fn orbs_on(view: vec4<f32>, normal: vec4<f32>, up: f32, share: f32, sky: f32) -> vec3<f32> {
    let place = model_of(view);
    let near = vec2<f32>(dot(place, scene.sun_place), dot(place, scene.moon_place));
    let slant = vec2<f32>(dot(normal, scene.sun_place), dot(normal, scene.moon_place));
    let facing = slant * inverseSqrt(max(vec2<f32>(1.0) - near * near, vec2<f32>(1.0e-3)));
    let reaches = mix(vec2<f32>(share, 1.0), vec2<f32>(1.0, share), scene.shadows.by_moon);
    let bounced = (0.06 * (vec2<f32>(1.0) - abs(facing)) + vec2<f32>(0.05)) * sky;
    let turned = smoothstep(vec2<f32>(0.0), vec2<f32>(FACING), facing);
    let about = reaches * turned;
    let key = 0.78 * max(facing, vec2<f32>(0.0)) * turned * reaches + bounced * (0.4 + 0.6 * about);
    let day = smoothstep(NIGHT, DAY, near.x);
    // Low light has come a long way through haze: red.
    let warmth = mix(vec3<f32>(1.0, 0.42, 0.16), vec3<f32>(1.0), smoothstep(0.15, 0.9, day));
    let moonlight = smoothstep(NIGHT, DAY, near.y) * (1.0 - day);
    let ambient = mix(scene.ambient_ground, scene.ambient_sky, 0.5 + 0.5 * up);
    return scene.key_colour * warmth * (day * key.x)
        + scene.moon_colour * (moonlight * key.y)
        + ambient * mix(NIGHT_AMBIENT, vec3<f32>(1.0), day) * sky;
}

fn daylight_on(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>, share: f32, sky: f32) -> vec3<f32> {
    return orbs_on(view, model_normal, normal.y, share, sky);
}

fn wants_model_normal(lights: vec3<u32>) -> bool {
    return true;
}

// The land's colour by day or night, and in the shadow: sun and moon stand among the land, and their light is three times
// the work of a fixed direction's, and changes little along an edge.
fn land_light(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>, albedo: vec3<f32>, sky: f32) -> LandLight {
    var light = LandLight(albedo * orbs_on(view, model_normal, normal.y, 1.0, sky), vec3<f32>(0.0));
    if SHADOWS != 0u {
        let unlit = is_unlit(view, normal, model_normal);
        light.dark = albedo * orbs_on(view, model_normal, normal.y, select(0.0, 1.0, unlit), sky);
    }
    return light;
}

fn daylit(light: LandLight, albedo: vec3<f32>, share: f32) -> vec3<f32> {
    if SHADOWS == 0u {
        return light.facing;
    }
    return mix(light.dark, light.facing, share);
}

// It is in the light already.
fn land_sky(light: LandLight) -> f32 {
    return 1.0;
}

fn is_land_unlit(light: LandLight, view: vec4<f32>, model_normal: vec4<f32>) -> bool {
    return all(light.facing - light.dark <= 0.002 * light.facing);
}

// A chart's frame at a figure is another than at the eye, mirrored beyond the equator: the normal is carried to the eye e
// along the geodesic, which takes n to n - <n, e> (x + e) / (1 + <x, e>).
fn seen_normal(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> vec3<f32> {
    let place = model_of(view);
    let n = model_normal.xyz - place.xyz * (model_normal.w / max(1.0 + place.w, 1.0e-3));
    return normalize(scene.right * n.x + scene.up * n.y - scene.front * n.z);
}

// Either chart may draw the land about the ring: metres of the ring's own come from the difference in view coordinates.
fn from_ring(place: vec3<f32>, view: vec4<f32>) -> vec3<f32> {
    return (view - scene.ring_centre) * mat3x4<f32>(scene.ring_x, scene.ring_y, scene.ring_z);
}

fn is_unlit(view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> bool {
    let body = key_body();
    return dot(model_normal, body) <= 0.0 || dot(model_of(view), body) <= NIGHT;
}

// The space itself.
fn caster_point(p: vec3<f32>) -> vec4<f32> {
    var space: Space;
    space.k_per_m = caster.curvature_per_m;
    return port(space, p);
}

fn shadow_place(place: vec3<f32>, view: vec4<f32>) -> vec4<f32> {
    return view;
}

fn shaded_at(place: vec3<f32>, view: vec4<f32>, normal: vec3<f32>, model_normal: vec4<f32>) -> Shaded {
    if SHADOWS == 0u {
        return NOT_SHADED;
    }
    // As in orbs_on.
    let body = key_body();
    let near = dot(model_of(view), body);
    let cosine = dot(model_normal, body) * inverseSqrt(max(1.0 - near * near, 1.0e-3));
    return Shaded(view, dpdx(view), dpdy(view), surely_faced(cosine), 1.0);
}

fn shadow_away(point: Shaded, number: u32) -> f32 {
    let c = scene.shadows.maps[number].clip * point.at;
    let at = c.xy / max(c.w, 1e-6);
    return select(2.0, max(abs(at.x), abs(at.y)), c.w > 0.0);
}

fn on_map(c: vec4<f32>, x: vec4<f32>, y: vec4<f32>) -> OnMap {
    // A map that is not there yet is all zero, and trusted by nothing.
    let inverse = 1.0 / select(c.w, 1e-6, abs(c.w) < 1e-6);
    let at = c.xyz * inverse;
    return OnMap(at, (x.xyz - at * x.w) * inverse, (y.xyz - at * y.w) * inverse, inverse);
}

// The face of the star's light on which a point lies.
fn shadow_face(point: Shaded) -> u32 {
    let x = (scene.shadows.maps[1].clip * point.at).w;
    let y = (scene.shadows.maps[3].clip * point.at).w;
    let z = (scene.shadows.maps[5].clip * point.at).w;
    let most = max(abs(x), max(abs(y), abs(z)));
    let along = select(select(5u, 3u, abs(y) >= most), 1u, abs(x) >= most);
    let value = select(select(z, y, abs(y) >= most), x, abs(x) >= most);
    return along + select(1u, 0u, value > 0.0);
}

// By the map round the eye and six faces; at low quality there is only the nearest, since looking up one of seven maps in
// each pixel doubles a frame in software.
fn land_shadow(point: Shaded, pixel: vec2<f32>) -> f32 {
    let near_end = shadow_end(shadow_away(point, 0u));
    if SHADOWS == 2u {
        return either(point, scene.shadows.maps[0], scene.shadows.maps[shadow_face(point)], near_end);
    }
    return mix(shadow_read(point, scene.shadows.maps[0]), point.open, near_end);
}
