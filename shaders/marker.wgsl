// Where the lamp in hand would hang: a small ball in a faint shell.

struct VertexIn {
    @location(0) position: vec3<f32>,   // on the unit sphere
    @location(1) offset: vec3<f32>,     // the centre from the reference, metres
    @location(2) colour: vec4<f32>,     // linear light; a: opacity face on
    @location(3) shape: vec4<f32>,      // radius m; opacity edge on
}

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) outward: vec3<f32>,
    @location(1) toward_eye: vec3<f32>,
    @location(2) colour: vec4<f32>,
    @location(3) edge: f32,
    @location(4) view: vec4<f32>,
}

@vertex
fn vertex(in: VertexIn) -> VertexOut {
    let space = space_of_chart();
    let view = port_to_view(space, in.offset + in.position * in.shape.x);
    let centre = port_to_view(space, in.offset);
    var out: VertexOut;
    out.clip = clip_from_view(space, view);
    out.view = view;
    // Over so small a ball, view coordinates are as good as flat.
    out.outward = (view.xyz - centre.xyz) / in.shape.x;
    out.toward_eye = -normalize(view.xyz);
    // Near or around the eye a ball would veil what is being dug, so there it thins out.
    let thin = 0.12 + 0.88 * smoothstep(1.0, 2.6, length(centre.xyz) / max(in.shape.x, 1.5));
    out.colour = vec4<f32>(in.colour.rgb, in.colour.a * thin);
    out.edge = in.shape.y * thin;
    return out;
}

fn shade(in: VertexOut, share: f32) -> vec4<f32> {
    if is_cut(in.view) {
        discard;
    }
    let facing = abs(dot(normalize(in.outward), normalize(in.toward_eye)));
    let edge = 1.0 - facing;
    let opacity = mix(in.colour.a, in.edge, edge * edge * edge) * share;
    return vec4<f32>(in.colour.rgb * opacity, opacity);
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    return shade(in, 1.0);
}

// What lies behind the land still shows, faintly.
@fragment
fn fragment_hidden(in: VertexOut) -> @location(0) vec4<f32> {
    return shade(in, 0.05);
}
