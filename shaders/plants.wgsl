// What grows and stands on the land, in vertices of the land's layout: lit as land is, without its grain, its layers and the ring
// about what is dug. What is of leaves sways in the wind, is bent by what goes through it, and gives way where it is close to the eye.
// Follows terrain.wgsl and surfaces.wgsl.

// The numbers of blades in the fourth byte of vertices, where they stand and at their tips; crates/render/src/baked.rs.
const BLADE_FEET: u32 = 17u;
const BLADE_TIPS: u32 = 18u;

// Distances from the eye between which leaves come to be seen, metres.
const GIVES_WAY_M: vec2<f32> = vec2<f32>(0.5, 1.6);

struct PlantOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) facing: vec3<f32>,     // as land has it, and
    @location(1) @interpolate(perspective, centroid) albedo: vec3<f32>,
    @location(2) veil: vec3<f32>,
    @location(3) place: vec4<f32>,      // xyz: from the reference, m; w: share of the plant's own colour in the fog
    @location(4) view: vec4<f32>,
    @location(5) frame_normal: vec4<f32>,
    @location(6) @interpolate(flat) lights: vec3<u32>,
    @location(7) dark: vec3<f32>,
    @location(8) grain: vec3<f32>,
    @location(9) @interpolate(flat) marks: vec2<u32>, // what it is made of; whether a figure's shadow may fall on it
    @location(10) rest: vec4<f32>,      // the `shadow_place` without the wind, of which maps of shadows do not know
}

// How far the wind bends what sways altogether, metres along the common axes: gusts that go over the land, and a flutter in them.
// Whole waves in the 256 m after which the grain's places wrap.
fn wind_at(world: vec3<f32>) -> vec3<f32> {
    let q = world.xz * (6.2831853 / 256.0);
    let gust = 0.5 + 0.5 * sin(dot(q, vec2<f32>(7.0, 4.0)) - scene.wind.x);
    let flutter = sin(dot(q, vec2<f32>(61.0, -47.0)) + 40.0 * (6.2831853 / 256.0) * world.y - scene.wind.y);
    let bent = scene.wind.z * (gust * gust + 0.2) * (0.7 + 0.3 * flutter);
    return vec3<f32>(0.8 * bent, -0.15 * bent * flutter, 0.6 * bent);
}

// How much of that bends a vertex made of this.
fn sway_of(made_of: u32) -> f32 {
    return select(select(0.0, 1.0, made_of == BLADE_TIPS), 0.5, made_of == LEAVES);
}

fn made_of_byte(in: VertexIn) -> u32 {
    return u32(in.colour.a * 255.0 + 0.5) & NUMBER_BITS;
}

// As far as this from the middle of what presses leaves go aside less, so that none jumps from side to side, metres.
const MIDDLE_M: f32 = 0.3;
// What is pressed keeps so much of its height, and goes aside by so much of it.
const KEPT_LOW: f32 = 0.18;
const ASIDE: f32 = 0.55;

// What cars and feet that are near a chunk move a vertex by, in the chart: by its height over their ground, so that what stands on
// the ground does so still.
fn pressed_by(in: VertexIn, rest: vec3<f32>) -> vec3<f32> {
    var moved = vec3<f32>(0.0);
    var left = select(0.0, 1.0, sway_of(made_of_byte(in)) > 0.0);
    for (var i = 0u; ((in.flags >> 1u) >> i) != 0u; i++) {
        let it = chart.pressers[i];
        let off = rest - it.place;
        let share = clamp(dot(off, it.along) / max(dot(it.along, it.along), 1e-4), -1.0, 1.0);
        let side = off - share * it.along;
        let over_m = dot(side, it.up);
        let aside = side - over_m * it.up;
        let away_m = length(aside);
        let near = 1.0 - smoothstep(0.5 * it.reach_m, it.reach_m, away_m);
        let low = 1.0 - smoothstep(0.6 * it.height_m, it.height_m, over_m);
        // What is pressed already is pressed less by the next, and nothing is pressed into the ground.
        let pressed = it.strength * near * low * left;
        left -= pressed;
        let way = aside * (ASIDE / max(away_m, MIDDLE_M)) - it.up * (1.0 - KEPT_LOW);
        moved += way * (pressed * max(over_m, 0.0));
    }
    return moved;
}

// What the wind moves a vertex by, in the chart.
fn swayed_by(in: VertexIn) -> vec3<f32> {
    let bent = wind_at(in.world.xyz + in_common_axes(position_of(in.units)));
    // Back from the common axes: they are turned against the chart's.
    let x = dot(in_common_axes(vec3<f32>(1.0, 0.0, 0.0)), bent);
    let z = dot(in_common_axes(vec3<f32>(0.0, 0.0, 1.0)), bent);
    return vec3<f32>(x, bent.y, z) * sway_of(made_of_byte(in));
}

fn plant_at(in: VertexIn, rest: vec3<f32>, p: vec3<f32>, rest_view: vec4<f32>, view: vec4<f32>) -> PlantOut {
    let authored = normal_of(in);
    let number = u32(in.colour.a * 255.0 + 0.5);
    let left = f32(min(number >> SKY_SHIFT, OPEN_SKY)) / f32(OPEN_SKY);
    let space = space_of_chart();
    let fog = fog_at(eye_distance(space, view));
    let chart_normal = port_normal(space, p, authored);
    let normal = in_sky_axes(p, chart_normal);
    var out: PlantOut;
    out.clip = clip_from_view(space, view);
    out.albedo = to_linear(in.colour.rgb) + 0.014;
    out.veil = haze_before(view) * (fog * mix(1.0, left, scene.covered));
    out.place = vec4<f32>(in_common_axes(p), 1.0 - fog);
    out.view = view;
    out.rest = shadow_place(in_common_axes(rest), rest_view);
    out.marks = vec2<u32>(number & NUMBER_BITS, in.flags & 1u);
    if wants_model_normal(in.lights) {
        out.frame_normal = frame_vector(space, p, chart_normal);
    }
    let sky = mix(DEEPEST_SKY, 1.0, left);
    if BY_PIXEL {
        out.facing = normal;
        out.dark.x = sky;
        out.grain = grain_point(in.world.xyz + in_common_axes(position_of(in.units)), rest);
    } else {
        let light = land_light(view, normal, out.frame_normal, out.albedo, sky);
        out.facing = light.facing;
        out.dark = light.dark;
    }
    if any_lit(in.lights) {
        let lamplight = lamplight_at(space, view, out.frame_normal, in.lights);
        out.lights = lamplight.near;
        out.veil += out.albedo * lamplight.far * (1.0 - fog);
    }
    return out;
}

@vertex
fn vertex_plant(in: VertexIn) -> PlantOut {
    let rest = from_reference(in);
    let p = rest + swayed_by(in) + pressed_by(in, rest);
    let space = space_of_chart();
    return plant_at(in, rest, p, port_to_view(space, rest), port_to_view(space, p));
}

// What maps of shadows and the next pixel are asked about a pixel of a plant: before it may be discarded.
struct PlantPixel {
    point: Shaded,
    steps: Steps,
}

fn plant_pixel(in: PlantOut) -> PlantPixel {
    var steps = Steps();
    if BY_PIXEL {
        let grain = grain_at(in.grain);
        steps = Steps(dpdx(grain), dpdy(grain), dpdx(in.view), dpdy(in.view));
    }
    return PlantPixel(shaded_at(in.rest.xyz, in.rest, in.facing, in.frame_normal), steps);
}

// Whether leaves leave a pixel to what is behind them. Not in software: there the question alone costs a twelfth of a picture.
fn gives_way(in: PlantOut) -> bool {
    if !BY_PIXEL {
        return false;
    }
    let shown = smoothstep(GIVES_WAY_M.x, GIVES_WAY_M.y, length(in.view.xyz));
    return in.marks.x == LEAVES && dither(in.clip.xy) > shown;
}

// Made of one kind, each pixel of it.
fn plant_surface(in: PlantOut, steps: Steps) -> Surface {
    if in.marks.x > LEAVES {
        return Surface(in.albedo, vec3<f32>(0.0), 0.0, vec3<f32>(0.0));
    }
    let wide_m = 0.7 * max(length(steps.grain_x), length(steps.grain_y));
    let detail = detail_of(in.marks.x, Spot(grain_at(in.grain), grain_up(in.grain), wide_m));
    return Surface(in.albedo * detail.tone, detail.slope, detail.gloss, detail.glow);
}

fn plant_colour(in: PlantOut, pixel: PlantPixel) -> vec4<f32> {
    let by_figures = in.marks.y != 0u;
    let own = in.place.w;
    if BY_PIXEL {
        let unlit = is_unlit(in.view, normalize(in.facing), in.frame_normal);
        let share = key_share(open_to(pixel.point, in.dark.x), in.clip.xy, unlit, by_figures);
        let surface = plant_surface(in, pixel.steps);
        let seen = Seen(in.view, in.facing, in.frame_normal, in.lights, in.dark.x);
        return vec4<f32>(lit_surface(surface, seen, share * detail_share(pixel.point), pixel.steps) * own + in.veil, 1.0);
    }
    let light = LandLight(in.facing, in.dark);
    let unlit = is_land_unlit(light, in.view, in.frame_normal);
    let share = key_share(open_to(pixel.point, land_sky(light)), in.clip.xy, unlit, by_figures);
    var lit = daylit(light, in.albedo, share);
    if any_lit(in.lights) {
        lit += in.albedo * lights_on(in.view, in.frame_normal, in.lights, 0.0);
    }
    return vec4<f32>(lit * own + in.veil, 1.0);
}

// Leaves do not give way here: what this draws is farther off, or drawn in software.
@fragment
fn fragment_plant(in: PlantOut) -> @location(0) vec4<f32> {
    let pixel = plant_pixel(in);
    if is_cut(in.view) {
        discard;
    }
    return plant_colour(in, pixel);
}

// What may be close to the eye, with a card.
@fragment
fn fragment_close_plant(in: PlantOut) -> @location(0) vec4<f32> {
    let pixel = plant_pixel(in);
    if gives_way(in) || is_cut(in.view) {
        discard;
    }
    return plant_colour(in, pixel);
}

@fragment
fn fragment_deep_plant(in: PlantOut) -> DeepOut {
    let pixel = plant_pixel(in);
    if gives_way(in) || is_cut(in.view) {
        discard;
    }
    return DeepOut(plant_colour(in, pixel), depth_at(in.place.xyz));
}
