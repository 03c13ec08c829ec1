// Figures: joints bend the model in its own axes, the model is turned and stands in the chart, and every vertex is carried
// into the space like the land it stands on. What is in the player's hand stands before the eye instead.

// Joints that a model has at most, and figures whose joints are seen at once.
const JOINTS: u32 = 21u;
const BATCH: u32 = 16u;

// Flags of a figure.
const HOSTILE: u32 = 1u;
const LIGHTS: u32 = 2u;
const BRAKES: u32 = 4u;
const POSSIBLE: u32 = 8u;
const BARRED: u32 = 16u;
const DARK_SHIFT: u32 = 5u;
const NO_SKY: u32 = 7u;
const PLACE_SHIFT: u32 = 8u;

// How much brighter brake lights are than tail lights.
const BRAKING: f32 = 0.6 / 0.28;

struct VertexIn {
    @location(0) position: vec3<f32>,   // metres; x ahead, y up from the feet, z to the right
    @location(1) normal: vec4<f32>,     // w: how much it glows
    @location(2) colour: vec4<f32>,     // sRGB; a: gloss, or the cover of what light goes through
    @location(3) offset: vec3<f32>,     // the origin from the reference, or from the eye in its axes, metres
    @location(4) flags: u32,            // HOSTILE, LIGHTS, BRAKES, POSSIBLE, BARRED; from DARK_SHIFT on how much of the sky it lacks, of
                                        // NO_SKY; from PLACE_SHIFT on the figure's place in its batch
    @location(5) turn: vec4<f32>,       // a quaternion
    @location(6) frame_origin: vec4<f32>, // view coordinates of the origin, where the figure is ported as a whole,
    @location(7) frame_x: vec4<f32>,    // and per metre along x, y and z
    @location(8) frame_y: vec4<f32>,
    @location(9) frame_z: vec4<f32>,
    @location(10) lights: vec4<u32>,    // which lamps (64 bits) and beams may light the figure; w: what of it is shown
    @location(11) level: vec4<f32>,     // metres of the chart for each along x (xy), and along z (zw), when the model is turned
    @location(14) glow_switch: u32,     // what switches the glow: 0 nothing, 1 the lights, 2 these and the brake lights
}

struct SkinIn {
    @location(12) weights: vec4<f32>,   // they sum to 1
    @location(13) joints: vec4<u32>,
}

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) albedo: vec4<f32>,     // a: gloss, or cover
    @location(2) toward_eye: vec3<f32>,
    @location(3) veil: vec4<f32>,       // rgb: the fog's share of the colour; a: share of the figure's own
    @location(4) glow: f32,             // negative of what is not there, but shown where it would be
    @location(5) view: vec4<f32>,
    @location(6) frame_normal: vec4<f32>, // the normal in view coordinates, where needed
    @location(7) @interpolate(flat) lights: vec3<u32>,
    @location(8) place: vec3<f32>,      // from the reference, m, in the common axes
    @location(9) kept_m: f32,           // how far it is on the side of a cut that is shown
    @location(10) sky: f32,             // what is left of the light from all around
}

// A figure that is shown whole, and how far from its origin a cut may lie, metres.
const WHOLE: u32 = 0x80008000u;
const CUT_REACH_M: f32 = 8.0;
const HALF_TURN: f32 = 3.14159265;

// How far on the side that is shown a place from the origin is, in the chart.
fn kept(cut: u32, place: vec3<f32>) -> f32 {
    let packed = unpack2x16snorm(cut);
    let heading = packed.x * HALF_TURN;
    let along = place.x * cos(heading) + place.z * sin(heading);
    return select(along - packed.y * CUT_REACH_M, 1.0, cut == WHOLE);
}

// What a cut takes away, pressed onto its plane: the shadow of the rest is that of what is shown.
fn kept_part(cut: u32, place: vec3<f32>) -> vec3<f32> {
    let heading = unpack2x16snorm(cut).x * HALF_TURN;
    let past = min(kept(cut, place), 0.0);
    return place - vec3<f32>(cos(heading), 0.0, sin(heading)) * past;
}

// A vertex of the model: where it is from the origin, in metres, and its normal.
struct Stance {
    place: vec3<f32>,
    normal: vec3<f32>,
}

// Where joints carry what hangs from them: each is three rows, whose products with a place and 1 are where it comes to.
@group(2) @binding(0) var<uniform> joints: array<mat3x4<f32>, JOINTS * BATCH>;

// Linear blend skinning (Magnenat-Thalmann et al. 1988): the mean of where the joints would carry the vertex. Joints turn
// and move but do not stretch, so normals go as places do.
fn bend(model: Stance, skin: SkinIn, figure: u32) -> Stance {
    let at = vec4<u32>(figure * JOINTS) + skin.joints;
    let rows = joints[at.x] * skin.weights.x + joints[at.y] * skin.weights.y + joints[at.z] * skin.weights.z
        + joints[at.w] * skin.weights.w;
    return Stance(vec4<f32>(model.place, 1.0) * rows, vec4<f32>(model.normal, 0.0) * rows);
}

fn turn(v: vec3<f32>, q: vec4<f32>) -> vec3<f32> {
    return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

// What is rigid in the space is stretched in a chart whose metres are others, as its instance says; heights stay.
fn levelled(v: vec3<f32>, level: vec4<f32>) -> vec3<f32> {
    let plane = level.xy * v.x + level.zw * v.z;
    return vec3<f32>(plane.x, v.y, plane.y);
}

// Normals go by the transposed inverse.
fn levelled_normal(v: vec3<f32>, level: vec4<f32>) -> vec3<f32> {
    let plane = vec2<f32>(level.w * v.x - level.y * v.z, level.x * v.z - level.z * v.x);
    let size = level.x * level.w - level.y * level.z;
    return vec3<f32>(plane.x, v.y * size, plane.y);
}

fn turned(model: Stance, in: VertexIn) -> Stance {
    let place = levelled(turn(model.place, in.turn), in.level);
    return Stance(place, levelled_normal(turn(model.normal, in.turn), in.level));
}

fn plain(in: VertexIn) -> Stance {
    return turned(Stance(in.position, in.normal.xyz), in);
}

fn bent(in: VertexIn, skin: SkinIn) -> Stance {
    return turned(bend(Stance(in.position, in.normal.xyz), skin, in.flags >> PLACE_SHIFT), in);
}

// The share of its least channel that green and blue of a hostile one's suit have.
const HOSTILE_HUES: vec2<f32> = vec2<f32>(0.16, 0.12);

// Light and dark stay what they are, so that the figure keeps its parts; every hue becomes red.
fn suit_colour(in: VertexIn) -> vec3<f32> {
    let colour = to_linear(in.colour.rgb);
    let most = max(colour.r, max(colour.g, colour.b));
    let least = min(colour.r, min(colour.g, colour.b));
    return select(colour, vec3<f32>(most, least * HOSTILE_HUES), (in.flags & HOSTILE) != 0u);
}

// What is not there yet: green where it can be put, red where it cannot, its light and dark parts told apart.
const POSSIBLE_HUE: vec3<f32> = vec3<f32>(0.10, 0.95, 0.42);
const BARRED_HUE: vec3<f32> = vec3<f32>(1.10, 0.12, 0.06);

fn figure_colour(in: VertexIn) -> vec3<f32> {
    let colour = suit_colour(in);
    if (in.flags & (POSSIBLE | BARRED)) == 0u {
        return colour;
    }
    let bright = 0.35 + 0.65 * max(colour.r, max(colour.g, colour.b));
    return bright * select(POSSIBLE_HUE, BARRED_HUE, (in.flags & BARRED) != 0u);
}

fn glow(in: VertexIn) -> f32 {
    if (in.flags & (POSSIBLE | BARRED)) != 0u {
        return -1.0;
    }
    let brakes = in.glow_switch == 2u && (in.flags & BRAKES) != 0u;
    let shines = in.glow_switch == 0u || (in.flags & LIGHTS) != 0u;
    return in.normal.w * select(select(0.0, 1.0, shines), BRAKING, brakes);
}

// What is left of the light from all around where a figure stands.
fn sky_over(in: VertexIn) -> f32 {
    let dark = in.flags >> DARK_SHIFT & NO_SKY;
    return mix(1.0, DEEPEST_SKY, f32(dark) / f32(NO_SKY));
}

fn figure_at(in: VertexIn, stance: Stance, view: vec4<f32>) -> VertexOut {
    let p = in.offset + stance.place;
    let space = space_of_chart();
    let fog = fog_at(eye_distance(space, view));
    let direction = direction_of(view.xyz);
    var out: VertexOut;
    out.clip = clip_from_view(space, view);
    let chart_normal = port_normal(space, p, normalize(stance.normal));
    out.normal = in_sky_axes(p, chart_normal);
    out.albedo = vec4<f32>(figure_colour(in), in.colour.a);
    out.toward_eye = -direction;
    out.veil = vec4<f32>(haze_before(view) * fog, 1.0 - fog);
    out.sky = sky_over(in);
    out.glow = glow(in);
    out.view = view;
    out.lights = in.lights.xyz;
    out.kept_m = kept(in.lights.w, stance.place);
    out.place = in_common_axes(p);
    if wants_model_normal(in.lights.xyz) {
        out.frame_normal = frame_vector(space, p, chart_normal);
    }
    return out;
}

fn by_vertex(in: VertexIn, stance: Stance) -> VertexOut {
    let p = in.offset + stance.place;
    return figure_at(in, stance, port_to_view(space_of_chart(), p));
}

// The whole figure by one first-order map, where that errs by less than anyone can see.
fn by_frame(in: VertexIn, stance: Stance) -> VertexOut {
    let p = stance.place;
    let view = in.frame_origin + in.frame_x * p.x + in.frame_y * p.y + in.frame_z * p.z;
    return figure_at(in, stance, view);
}

@vertex
fn vertex(in: VertexIn) -> VertexOut {
    return by_vertex(in, plain(in));
}

@vertex
fn vertex_framed(in: VertexIn) -> VertexOut {
    return by_frame(in, plain(in));
}

@vertex
fn vertex_bent(in: VertexIn, skin: SkinIn) -> VertexOut {
    return by_vertex(in, bent(in, skin));
}

@vertex
fn vertex_bent_framed(in: VertexIn, skin: SkinIn) -> VertexOut {
    return by_frame(in, bent(in, skin));
}

// What is not there throws no shadow: all of it falls on one point.
fn caster_at(in: VertexIn, place: vec3<f32>) -> vec4<f32> {
    let is_there = (in.flags & (POSSIBLE | BARRED)) == 0u;
    let here = kept_part(in.lights.w, place);
    return caster_clip(in.offset + select(vec3<f32>(0.0), here, is_there));
}

@vertex
fn vertex_caster(in: VertexIn) -> @builtin(position) vec4<f32> {
    return caster_at(in, plain(in).place);
}

@vertex
fn vertex_caster_bent(in: VertexIn, skin: SkinIn) -> @builtin(position) vec4<f32> {
    return caster_at(in, bent(in, skin).place);
}

// What is in the hand is seen at this focal length, whatever the field of view is: 1 over the tangent of 27 degrees.
const HAND_FOCAL: f32 = 1.96;
// It is nearer than all else: its depths lie from here to 1.
const HAND_DEPTH: f32 = 0.9;

// Before the eye, at the length of an arm, every space is flat.
@vertex
fn vertex_hand(in: VertexIn) -> VertexOut {
    let stance = plain(in);
    let v = in.offset + stance.place;
    let normal = normalize(stance.normal);
    let direction = direction_of(v);
    let aspect = scene.space.focal_x / scene.space.focal_y;
    let depth = mix(scene.space.near_m, -v.z, HAND_DEPTH);
    var out: VertexOut;
    out.clip = vec4<f32>(HAND_FOCAL * aspect * v.x, HAND_FOCAL * v.y, depth, -v.z);
    out.normal = scene.right * normal.x + scene.up * normal.y - scene.front * normal.z;
    out.albedo = vec4<f32>(to_linear(in.colour.rgb), in.colour.a);
    out.toward_eye = -direction;
    out.veil = vec4<f32>(0.0, 0.0, 0.0, 1.0);
    out.sky = sky_over(in);
    out.glow = in.normal.w;
    out.view = vec4<f32>(v, 1.0);
    out.place = scene.right * v.x + scene.up * v.y - scene.front * v.z;
    out.frame_normal = vec4<f32>(normal, 0.0);
    out.lights = in.lights.xyz;
    out.kept_m = 1.0;
    return out;
}

// Light that comes off a surface of that gloss.
fn figure_light(in: VertexOut, gloss: f32) -> vec3<f32> {
    let normal = normalize(in.normal);
    let seen = seen_normal(in.view, normal, in.frame_normal);
    let toward_eye = normalize(in.toward_eye);
    let edge = 1.0 - max(dot(seen, toward_eye), 0.0);
    let edge2 = edge * edge;
    let halfway = normalize(scene.key_direction + toward_eye);
    let shine = pow(max(dot(seen, halfway), 0.0), 48.0);
    let sky = mix(scene.ambient_ground, scene.ambient_sky, 0.5 + 0.5 * normal.y) * in.sky;
    let unlit = is_unlit(in.view, normal, in.frame_normal);
    let point = shaded_at(in.place, in.view, normal, in.frame_normal);
    let share = key_share(open_to(point, in.sky), in.clip.xy, unlit, true);
    var colour = in.albedo.rgb * daylight_on(in.view, normal, in.frame_normal, share, in.sky);
    if any_lit(in.lights) {
        colour += lights_on(in.view, in.frame_normal, in.lights, gloss) * in.albedo.rgb;
    }
    // A soft bright edge keeps the figure readable against land of its own brightness.
    colour += scene.ambient_sky * in.sky * (edge2 * edge * (0.30 + 0.9 * gloss));
    colour += (scene.key_colour * (shine * share) + sky * 0.35) * gloss;
    // Brighter than white, so that tone mapping lets it shine; a little less at the rim, so that it stays round.
    colour += in.albedo.rgb * (in.glow * (3.2 - 1.4 * edge2));
    return colour;
}

// The light of what is not there: it shines by itself, a little brighter towards its edges, and every other pixel is open.
fn ghost_light(in: VertexOut) -> vec3<f32> {
    let facing = abs(dot(normalize(in.normal), normalize(in.toward_eye)));
    return in.albedo.rgb * (1.15 - 0.6 * facing);
}

// Whether a sheet of the view or the figure's own cut takes it away.
fn is_cut_off(in: VertexOut) -> bool {
    return is_cut(in.view) || (CUTS && dot(scene.figure_cut, in.view) < 0.0) || in.kept_m < 0.0;
}

fn is_open(clip: vec4<f32>) -> bool {
    let at = vec2<u32>(clip.xy);
    return ((at.x + at.y) & 1u) == 1u;
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    var light = figure_light(in, in.albedo.a);
    let is_ghost = in.glow < -0.5;
    if is_cut_off(in) || (is_ghost && is_open(in.clip)) {
        discard;
    }
    light = select(light, ghost_light(in), is_ghost);
    return vec4<f32>(light * in.veil.a + in.veil.rgb, 1.0);
}

// Glass: what it sends back and what it shines by itself comes on top of what shines through.
@fragment
fn fragment_clear(in: VertexOut) -> @location(0) vec4<f32> {
    let cover = in.albedo.a;
    let light = figure_light(in, 0.9) * in.veil.a + in.veil.rgb;
    if is_cut_off(in) {
        discard;
    }
    return vec4<f32>(light * cover, cover);
}
