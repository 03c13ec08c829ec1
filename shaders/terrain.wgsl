// The land: each vertex is translated and then carried into the space, lit by sun or moon and the sky,
// grained in world space so that scale can be read, and faded into the haze behind it.

struct VertexIn {
    @location(0) units: vec4<u32>,      // xyz: 1/1024 m from the chunk's corner; w: 32nds of those, five bits each
    @location(1) octahedral: vec2<f32>, // unit normal, as crates/terrain/src/mesh.rs folds it
    @location(2) colour: vec4<f32>,     // sRGB, and the byte of the kind of ground
    @location(3) offset: vec3<f32>,     // the chunk's corner from the whole metres next to the reference
    @location(4) flags: u32,            // lowest bit: whether a figure's shadow may fall on the chunk; above it a
                                        // bit for each shade that may; of what grows for each that may bend it
    @location(5) world: vec4<f32>,      // xyz: where grain has the chunk's corner, wrapped to 256 m; w: of a mesh that comes in a
                                        // blend, the share of the pixels that show it; minus that of one that goes
    @location(6) frame_origin: vec4<f32>, // view coordinates of the reference, where the chunk is ported as a whole,
    @location(7) frame_x: vec4<f32>,    // and per metre along the common x, y and z
    @location(8) frame_y: vec4<f32>,
    @location(9) frame_z: vec4<f32>,
    @location(10) lights: vec3<u32>,    // which lamps (64 bits) and beams (16) may light the chunk, and its level
}

// Added to the share of a blend where a figure's shadow may fall on the chunk: what every pixel is handed costs.
const SHADED: f32 = 8.0;

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) facing: vec3<f32>,     // what land_light says of the light, and
    @location(1) @interpolate(perspective, centroid) albedo: vec3<f32>, // a sliver at an edge would lead it below nothing
    @location(2) grain: vec3<f32>,      // where grain is read
    @location(3) veil: vec3<f32>,       // the fog's share of the colour, and the land's in the light of far lamps
    @location(4) land: vec4<f32>,       // share of the land's own colour, width of view m, steepness, height m
    @location(5) place: vec4<f32>,      // xyz: from the reference, m; w: metres beyond what the chart draws
    @location(6) @interpolate(flat) feet: vec4<f32>, // w: as above
    @location(7) view: vec4<f32>,
    @location(8) frame_normal: vec4<f32>, // the normal in view coordinates, where needed
    @location(9) @interpolate(flat) lights: vec3<u32>,
    @location(10) dark: vec3<f32>,      // of the shadow; where surfaces are drawn, x is what is left of the sky
    @location(11) kinds_a: vec4<f32>,   // of each kind of ground, how much, where surfaces are drawn; facing is the normal there
    @location(12) kinds_b: vec4<f32>,
    @location(13) kinds_c: vec4<f32>,
    @location(14) kinds_d: vec4<f32>,
}

// Feet of the figure nearest to a vertex, of those that bits are set for. Flat over a triangle: a mean of two figures
// would shade thin air. Which there are, the chunk says and not a uniform: lavapipe compiles a shader whose loops end by a
// uniform anew for every frame, and keeps each.
fn nearest_feet(place: vec3<f32>, which: u32) -> vec3<f32> {
    var nearest = vec3<f32>(1e6);
    for (var i = 0u; (which >> i) != 0u; i++) {
        let feet = scene.shades[i].xyz;
        let closer = distance(place, feet) < distance(place, nearest) && ((which >> i) & 1u) != 0u;
        nearest = select(nearest, feet, closer);
    }
    return nearest;
}

// Metres from the chunk's corner, exactly.
fn position_of(units: vec4<u32>) -> vec3<f32> {
    let parts = (vec3<u32>(units.w) >> vec3<u32>(0u, 5u, 10u)) & vec3<u32>(31u);
    return vec3<f32>((units.xyz << vec3<u32>(5u)) | parts) * (1.0 / 32768.0);
}

fn normal_of(in: VertexIn) -> vec3<f32> {
    let side = in.octahedral;
    let y = 1.0 - abs(side.x) - abs(side.y);
    let unfolded = side - max(-y, 0.0) * select(vec2<f32>(-1.0), vec2<f32>(1.0), side >= vec2<f32>(0.0));
    return normalize(vec3<f32>(unfolded.x, y, unfolded.y));
}

// Metres by which a point lies beyond what is drawn of its chart.
fn beyond_chart(p: vec3<f32>) -> f32 {
    let past = max(chart.domain_low - p.xz, p.xz - chart.domain_high);
    return max(max(past.x, past.y), geo_beyond_edge(scene.space, p));
}

fn land_at(in: VertexIn, p: vec3<f32>, view: vec4<f32>) -> VertexOut {
    let authored = normal_of(in);
    let ground = kind_of(in.colour.a, authored.y);
    let world = in.world.xyz + in_common_axes(position_of(in.units));
    let grain = grain_point(world, p);
    let space = space_of_chart();
    let fog = fog_at(eye_distance(space, view));
    // What a pixel spans grows with this in every space: the distance in a flat one, and as land overhead in a
    // closed world comes to look larger again, this falls.
    let spread_m = length(view.xyz);
    var out: VertexOut;
    out.clip = clip_from_view(space, view);
    let chart_normal = port_normal(space, p, authored);
    let normal = in_sky_axes(p, chart_normal);
    let place = in_common_axes(p);
    // No ground is blacker than basalt, so that overhangs keep their shape.
    let own = to_linear(in.colour.rgb) + 0.014;
    if BY_PIXEL {
        out.albedo = own;
        let weights = kind_weights(ground);
        out.kinds_a = weights[0];
        out.kinds_b = weights[1];
        out.kinds_c = weights[2];
        out.kinds_d = weights[3];
    } else {
        out.albedo = own * mix(coarse_tone(u32(ground.x), grain_at(grain)), coarse_tone(ROCK, grain_at(grain)), ground.y);
    }
    out.grain = grain;
    // No haze is lit where neither the eye nor the land has a sky.
    out.veil = haze_before(view) * (fog * mix(1.0, ground.z, scene.covered));
    out.land = vec4<f32>(1.0 - fog, spread_m, sqrt(max(1.0 - authored.y * authored.y, 0.0)), world.y);
    out.place = vec4<f32>(place, beyond_chart(p));
    let mark = select(0.0, SHADED, (in.flags & 1u) != 0u);
    out.feet = vec4<f32>(nearest_feet(place, in.flags >> 1u), in.world.w + mark);
    out.view = view;
    if wants_model_normal(in.lights) {
        out.frame_normal = frame_vector(space, p, chart_normal);
    }
    let sky = mix(DEEPEST_SKY, 1.0, ground.z);
    let light = land_light(view, normal, out.frame_normal, out.albedo, sky);
    out.facing = light.facing;
    out.dark = light.dark;
    if BY_PIXEL {
        out.facing = normal;
        out.dark.x = sky;
    }
    if any_lit(in.lights) {
        let lamplight = lamplight_at(space, view, out.frame_normal, in.lights);
        out.lights = lamplight.near;
        // It joins the veil, without the grain: one more number for every pixel of every picture would cost a tenth.
        out.veil += out.albedo * lamplight.far * (1.0 - fog);
    }
    return out;
}

// A vertex from the reference. Offsets are whole metres and so are chunk borders, so the sum is exact there: both
// chunks give a shared vertex the same bits, however far from the origin they lie.
fn from_reference(in: VertexIn) -> vec3<f32> {
    return (in.offset + position_of(in.units)) - chart.fraction;
}

@vertex
fn vertex(in: VertexIn) -> VertexOut {
    let p = from_reference(in);
    return land_at(in, p, port_to_view(space_of_chart(), p));
}

fn framed_view(in: VertexIn, p: vec3<f32>) -> vec4<f32> {
    let q = in_common_axes(p);
    return in.frame_origin + in.frame_x * q.x + in.frame_y * q.y + in.frame_z * q.z;
}

// The whole chunk by one first-order map, where that errs by less than anyone can see.
@vertex
fn vertex_framed(in: VertexIn) -> VertexOut {
    let p = from_reference(in);
    return land_at(in, p, framed_view(in, p));
}

// How far over the edge of its chart land throws shadows: half an edge of a triangle, so that there is no gap, metres.
const RIM_OVERLAP: f32 = 0.5;

struct CasterIn {
    @location(0) units: vec4<u32>,      // as above
    @location(3) offset: vec3<f32>,     // the chunk's corner from where the map's matrix begins
    @location(4) flags: u32,            // lowest bit: no land, which ends at the edge of its chart
}

// Land past the edge, which pictures leave to the other chart, is no land and must throw no shadow. It is laid down
// on the sheet y = 0, under all land: left out, it would take with it the triangles that reach over it.
fn is_past_rim(p: vec3<f32>, flags: u32) -> bool {
    return (flags & 1u) == 0u && length(p.xz) > caster.rim_m + RIM_OVERLAP;
}

@vertex
fn vertex_caster(in: CasterIn) -> @builtin(position) vec4<f32> {
    let p = in.offset + position_of(in.units);
    return caster_clip(select(p, vec3<f32>(p.x, 0.0, p.z), is_past_rim(p, in.flags)));
}

// Nothing, over all of a map: what was there is gone.
@vertex
fn vertex_hole(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

// What a pixel spans of the way to the ring's middle counts as so much of its radius at most.
const RING_WIDEST: f32 = 0.06;
// Shares of the ring's radius between which the ground that is shown within it ends.
const OFFERED: vec2<f32> = vec2<f32>(0.62, 0.78);

// The thin ring about what is dug or built: all land as far from its middle as the brush reaches, in metres of the chart
// as it does, and a pixel or two wide however steeply it is seen. Gives the shares of the ring, of its dark edges, and of
// the ground that is shown within it. To be called before a fragment may be discarded.
fn ring_at(place: vec3<f32>, view: vec4<f32>) -> vec3<f32> {
    let from_middle = length(from_ring(place, view));
    // Where land ends before other land the next pixel may be metres off, and that is not the ring's width.
    let across_m = clamp(fwidth(from_middle), 1e-6, RING_WIDEST * scene.ring_radius_m + 1e-6);
    let pixels = abs(from_middle - scene.ring_radius_m) / across_m;
    let is_there = select(0.0, 1.0, scene.ring_radius_m > 0.0);
    let wide = 1.0 - smoothstep(2.0, 3.0, pixels);
    var offered = 0.0;
    if scene.ring_ground.w > 0.0 {
        offered = 1.0 - smoothstep(OFFERED.x, OFFERED.y, from_middle / scene.ring_radius_m);
    }
    return vec3<f32>(is_there * (1.0 - smoothstep(0.8, 1.8, pixels)), is_there * wide * scene.ring_edges, offered);
}

fn ringed(land: vec4<f32>, ring: vec3<f32>) -> vec4<f32> {
    let edged = land.rgb * (1.0 - ring.y);
    return vec4<f32>(mix(edged, scene.ring_light, ring.x), land.a);
}

// Whether land turns away from the light that throws shadows, or lies where that does not reach.
fn is_turned(in: VertexOut) -> bool {
    if BY_PIXEL {
        return is_unlit(in.view, normalize(in.facing), in.frame_normal);
    }
    return is_land_unlit(LandLight(in.facing, in.dark), in.view, in.frame_normal);
}

// How the grain and the view change to the next pixels. To be asked for before a fragment may be discarded.
fn steps_at(in: VertexOut) -> Steps {
    if !BY_PIXEL {
        return Steps();
    }
    let grain = grain_at(in.grain);
    return Steps(dpdx(grain), dpdy(grain), dpdx(in.view), dpdy(in.view));
}

// The patterns of land that has no surfaces of its own.
fn plain_tone(in: VertexOut) -> f32 {
    // Fine grain, gone where a pixel would hold several of its cells.
    let near = 1.0 - clamp(in.land.y * (1.0 / 44.0), 0.0, 1.0);
    let dapple = smoothstep(0.24, 0.76, value_noise(grain_at(in.grain) * 8.0, 2047u)) - 0.5;
    let tone = 1.0 + dapple * (0.18 * near * near);
    // Cuts show layers, about 1.1 m apart; whole over the 256 m after which heights wrap. In the mean they are no darker.
    let height = in.land.w;
    let cut = smoothstep(0.62, 0.86, in.land.z);
    let layer = abs(fract(height * 0.8984375) - 0.5) + 0.7 * abs(fract(height * 0.37109375) - 0.5);
    return tone * (1.0 - cut * (0.42 * (layer - 0.425)));
}

// What dims any land: contour bands and the shade of figures.
fn common_tone(in: VertexOut) -> f32 {
    let spread_m = in.land.y;
    // Contour bands keep their width along the ground, and a pixel's width far away.
    let to_contour = abs(fract(in.land.w * 0.125 + 0.5) - 0.5) * 8.0;
    let width = (0.04 + 0.0020 * spread_m) * max(in.land.z, 0.06);
    let line = 1.0 - smoothstep(width, 2.0 * width, to_contour);
    let tone = 1.0 - line * scene.contour_strength;
    // Figures stand in a soft shade of their own, wider and fainter the higher they are.
    let under = (in.place.xyz - in.feet.xyz) * vec3<f32>(1.5, 0.45, 1.5);
    let shade = max(1.0 - dot(under, under), 0.0);
    return tone * (1.0 - 0.55 * shade);
}

// What light needs to know of a pixel with a surface.
struct Seen {
    view: vec4<f32>,
    normal: vec3<f32>,
    frame_normal: vec4<f32>,
    lights: vec3<u32>,
    sky: f32,           // what is left of it
}

// All light on a surface, lit by pixel.
fn lit_surface(surface: Surface, seen: Seen, share: f32, steps: Steps) -> vec3<f32> {
    let tilt = tilted(normalize(seen.normal), seen.frame_normal, surface.slope, steps);
    // A normal n and a slope s have in the mean of all slopes the light of n, as long as n - s is not made one long: far off,
    // where no slope is seen, it is no lighter. Two thirds of a slope in space lie along the ground.
    let stretch = sqrt(1.0 + 0.67 * dot(surface.slope, surface.slope));
    var lit = surface.albedo * stretch * daylight_on(seen.view, tilt.normal, tilt.model_normal, share, seen.sky);
    // Blinn's highlight of the key light.
    let half_way = normalize(scene.key_direction - direction_of(seen.view.xyz));
    let shine = pow(max(dot(seen_normal(seen.view, tilt.normal, tilt.model_normal), half_way), 0.0), 36.0);
    lit += scene.key_colour * (0.30 * surface.gloss * shine * share);
    if any_lit(seen.lights) {
        lit += surface.albedo * lights_on(seen.view, tilt.model_normal, seen.lights, 0.0);
    }
    return lit + surface.glow;
}

// Land with the surfaces of its kinds.
fn surface_light(in: VertexOut, share: f32, steps: Steps, offered: f32) -> vec3<f32> {
    let wide_m = 0.7 * max(length(steps.grain_x), length(steps.grain_y));
    var weights = mat4x4<f32>(in.kinds_a, in.kinds_b, in.kinds_c, in.kinds_d);
    var albedo = in.albedo;
    if offered > 0.0 {
        weights = weights * (1.0 - offered) + kind_weights(vec3<f32>(scene.ring_ground.w, 0.0, 1.0)) * offered;
        albedo = mix(albedo, scene.ring_ground.rgb, offered);
    }
    let surface = surface_at(weights, albedo, grain_at(in.grain), wide_m);
    return lit_surface(surface, Seen(in.view, in.facing, in.frame_normal, in.lights, in.dark.x), share, steps);
}

// Of `offered` it is of the kind that was chosen to build of.
fn land_colour(in: VertexOut, point: Shaded, steps: Steps, offered: f32) -> vec4<f32> {
    let unlit = is_turned(in);
    let sky = select(land_sky(LandLight(in.facing, in.dark)), in.dark.x, BY_PIXEL);
    let share = key_share(open_to(point, sky), in.clip.xy, unlit, in.feet.w > 0.5 * SHADED);
    let tone = common_tone(in) * in.land.x;
    if BY_PIXEL {
        return vec4<f32>(surface_light(in, share * detail_share(point), steps, offered) * tone + in.veil, 1.0);
    }
    var lit = daylit(LandLight(in.facing, in.dark), in.albedo, share);
    if any_lit(in.lights) {
        lit += in.albedo * lights_on(in.view, in.frame_normal, in.lights, 0.0);
    }
    if offered > 0.0 {
        lit *= mix(vec3<f32>(1.0), scene.ring_ground.rgb / max(in.albedo, vec3<f32>(1e-3)), offered);
    }
    return vec4<f32>(lit * (plain_tone(in) * tone) + in.veil, 1.0);
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    let point = shaded_at(in.place.xyz, in.view, in.facing, in.frame_normal);
    let ring = ring_at(in.place.xyz, in.view);
    let steps = steps_at(in);
    if is_cut(in.view) {
        discard;
    }
    return ringed(land_colour(in, point, steps, ring.z), ring);
}

// Beyond what the chart draws: over its edge, where another chart draws it, or past what a bent picture shows. By
// more than 5 cm and, since far land is coarse and that of the two charts not the same, by about a pixel's width:
// where they ended just there, the sky would show between them.
fn is_trimmed(in: VertexOut) -> bool {
    return in.place.w > 0.05 + 0.004 * in.land.y;
}

@fragment
fn fragment_rim(in: VertexOut) -> @location(0) vec4<f32> {
    let point = shaded_at(in.place.xyz, in.view, in.facing, in.frame_normal);
    let ring = ring_at(in.place.xyz, in.view);
    let steps = steps_at(in);
    if is_trimmed(in) || is_cut(in.view) {
        discard;
    }
    return ringed(land_colour(in, point, steps, ring.z), ring);
}

struct DeepOut {
    @location(0) colour: vec4<f32>,
    @builtin(frag_depth) depth: f32,
}

// Hyperbolic depth is not quite linear inside a triangle: here each fragment is ported for its own.
fn depth_at(place: vec3<f32>) -> f32 {
    let clip = clip_from_view(scene.space, port_to_view(scene.space, place));
    return clamp(clip.z / max(clip.w, 1e-6), 0.0, 1.0);
}

@fragment
fn fragment_deep(in: VertexOut) -> DeepOut {
    let point = shaded_at(in.place.xyz, in.view, in.facing, in.frame_normal);
    let ring = ring_at(in.place.xyz, in.view);
    let steps = steps_at(in);
    if is_cut(in.view) {
        discard;
    }
    return DeepOut(ringed(land_colour(in, point, steps, ring.z), ring), depth_at(in.place.xyz));
}

@fragment
fn fragment_deep_rim(in: VertexOut) -> DeepOut {
    let point = shaded_at(in.place.xyz, in.view, in.facing, in.frame_normal);
    let ring = ring_at(in.place.xyz, in.view);
    let steps = steps_at(in);
    if is_trimmed(in) || is_cut(in.view) {
        discard;
    }
    return DeepOut(ringed(land_colour(in, point, steps, ring.z), ring), depth_at(in.place.xyz));
}

// Which pixels show what comes at a share from 0 to 1: a 4 x 4 ordered dither (Bayer, 1973).
fn dither(pixel: vec2<f32>) -> f32 {
    let p = vec2<u32>(pixel) & vec2<u32>(3u);
    let a = p.x ^ p.y;
    let rank = ((a & 1u) << 3u) | ((p.y & 1u) << 2u) | (a & 2u) | (p.y >> 1u);
    return (f32(rank) + 0.5) * (1.0 / 16.0);
}

// Whether a pixel is left to the other mesh of a blend: exactly one of the two draws it.
fn is_left_out(in: VertexOut) -> bool {
    let share = in.feet.w - select(0.0, SHADED, in.feet.w > 0.5 * SHADED);
    return (dither(in.clip.xy) < abs(share)) != (share > 0.0);
}

@fragment
fn fragment_blending(in: VertexOut) -> @location(0) vec4<f32> {
    let point = shaded_at(in.place.xyz, in.view, in.facing, in.frame_normal);
    let ring = ring_at(in.place.xyz, in.view);
    let steps = steps_at(in);
    if is_left_out(in) || is_trimmed(in) || is_cut(in.view) {
        discard;
    }
    return ringed(land_colour(in, point, steps, ring.z), ring);
}

@fragment
fn fragment_deep_blending(in: VertexOut) -> DeepOut {
    let point = shaded_at(in.place.xyz, in.view, in.facing, in.frame_normal);
    let ring = ring_at(in.place.xyz, in.view);
    let steps = steps_at(in);
    if is_left_out(in) || is_trimmed(in) || is_cut(in.view) {
        discard;
    }
    return DeepOut(ringed(land_colour(in, point, steps, ring.z), ring), depth_at(in.place.xyz));
}
