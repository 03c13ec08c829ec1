// Figures: limbs swing in the model, the model stands in the chart, and every vertex is carried into the space
// like the land it stands on.

struct VertexIn {
    @location(0) position: vec3<f32>,   // metres; x ahead, y up from the feet, z to the right
    @location(1) normal: vec4<f32>,     // w: how much it glows
    @location(2) colour: vec4<f32>,     // sRGB; a: gloss
    @location(3) swing: vec2<f32>,      // height of the joint, m; share of the swing, signed
    @location(4) offset: vec3<f32>,     // the feet from the reference, metres
    @location(5) hemisphere: u32,
    @location(6) pose: vec4<f32>,       // cosine and sine of the heading, angle of the swing, rise of the body m
    @location(7) frame_origin: vec4<f32>, // view coordinates of the feet, where the figure is ported as a whole,
    @location(8) frame_x: vec4<f32>,    // and per metre along x, y and z
    @location(9) frame_y: vec4<f32>,
    @location(10) frame_z: vec4<f32>,
    @location(11) lights: vec3<u32>,    // which lamps (64 bits) and beams may light the figure
}

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) albedo: vec4<f32>,     // a: gloss
    @location(2) toward_eye: vec3<f32>,
    @location(3) veil: vec4<f32>,       // rgb: the fog's share of the colour; a: share of the figure's own
    @location(4) glow: f32,
    @location(5) view: vec4<f32>,
    @location(6) frame_normal: vec4<f32>, // the normal in view coordinates, where needed
    @location(7) @interpolate(flat) lights: vec3<u32>,
    @location(8) place: vec3<f32>,      // from the reference, m
}

// Turns about the axis to the right: a positive angle moves what hangs from the joint ahead.
fn turn_limb(v: vec3<f32>, angle: f32) -> vec3<f32> {
    let c = cos(angle);
    let s = sin(angle);
    return vec3<f32>(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
}

fn face(v: vec3<f32>, heading: vec2<f32>) -> vec3<f32> {
    return vec3<f32>(heading.x * v.x - heading.y * v.z, v.y, heading.y * v.x + heading.x * v.z);
}

// Where a vertex stands, in metres from the feet.
fn stance(in: VertexIn) -> vec3<f32> {
    let joint = vec3<f32>(0.0, in.swing.x, 0.0);
    let angle = in.pose.z * in.swing.y;
    let bent = turn_limb(in.position - joint, angle) + joint + vec3<f32>(0.0, in.pose.w, 0.0);
    return face(bent, in.pose.xy);
}

fn figure_at(in: VertexIn, p: vec3<f32>, view: vec4<f32>) -> VertexOut {
    let normal = face(turn_limb(in.normal.xyz, in.pose.z * in.swing.y), in.pose.xy);
    let space = space_at(in.hemisphere);
    let fog = fog_at(eye_distance(space, view));
    let direction = direction_of(view.xyz);
    var out: VertexOut;
    out.clip = clip_from_view(space, view);
    out.normal = port_normal(space, p, normalize(normal), in.hemisphere);
    out.albedo = vec4<f32>(to_linear(in.colour.rgb), in.colour.a);
    out.toward_eye = -direction;
    out.veil = vec4<f32>(haze_before(space, view) * fog, 1.0 - fog);
    out.glow = in.normal.w;
    out.view = view;
    out.lights = in.lights;
    out.place = p;
    if wants_model_normal(space, in.lights) {
        out.frame_normal = frame_vector(space, p, out.normal, in.hemisphere);
    }
    return out;
}

@vertex
fn vertex(in: VertexIn) -> VertexOut {
    let p = in.offset + stance(in);
    return figure_at(in, p, port_to_view(space_at(in.hemisphere), p, in.hemisphere));
}

// The whole figure by one first-order map, where that errs by less than anyone can see.
@vertex
fn vertex_framed(in: VertexIn) -> VertexOut {
    let from_feet = stance(in);
    let view = in.frame_origin + in.frame_x * from_feet.x + in.frame_y * from_feet.y
        + in.frame_z * from_feet.z;
    return figure_at(in, in.offset + from_feet, view);
}

@vertex
fn vertex_caster(in: VertexIn) -> @builtin(position) vec4<f32> {
    return caster_clip(in.offset + stance(in), in.hemisphere);
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    let point = shaded_at(in.place, in.view);
    let normal = normalize(in.normal);
    let toward_eye = normalize(in.toward_eye);
    let gloss = in.albedo.a;
    let edge = 1.0 - max(dot(normal, toward_eye), 0.0);
    let edge2 = edge * edge;
    let halfway = normalize(scene.key_direction.xyz + toward_eye);
    let shine = pow(max(dot(normal, halfway), 0.0), 48.0);
    let sky = mix(scene.ambient_ground.rgb, scene.ambient_sky.rgb, 0.5 + 0.5 * normal.y);
    let share = key_share(point, in.clip.xy, normal, true);
    var colour = in.albedo.rgb * daylight_on(scene.space, in.view, normal, in.frame_normal, share);
    if any(in.lights != vec3<u32>(0u)) {
        colour += lights_on(in.view, in.frame_normal, in.lights, gloss) * in.albedo.rgb;
    }
    // A soft bright edge keeps the figure readable against land of its own brightness.
    colour += scene.ambient_sky.rgb * (edge2 * edge * (0.30 + 0.9 * gloss));
    colour += (scene.key_colour.rgb * (shine * share) + sky * 0.35) * gloss;
    // Brighter than white, so that tone mapping lets it shine; a little less at the rim, so that it stays round.
    colour += in.albedo.rgb * (in.glow * (3.2 - 1.4 * edge2));
    return vec4<f32>(colour * in.veil.a + in.veil.rgb, 1.0);
}
