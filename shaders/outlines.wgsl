// Outlines of the shapes by which things are hit: short lines, a pixel or two wide however far they are.

struct VertexIn {
    @location(0) here: vec4<f32>,       // an end on the unit shape; w: 0 with the lower middle, 1 with the upper
    @location(1) there: vec4<f32>,      // the other end
    @location(2) side: f32,             // of the line, 1 or -1
    @location(3) offset: vec3<f32>,     // the shape's point from the reference, metres
    @location(4) turn: vec4<f32>,
    @location(5) size: vec4<f32>,       // along each axis, metres; w: height of the lower middle
    @location(6) colour: vec4<f32>,     // linear light; w: height of the upper middle
}

struct VertexOut {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec4<f32>,     // a: opacity
    @location(1) view: vec4<f32>,
}

// Half of a line's width, pixels.
const HALF_WIDTH_PX: f32 = 0.9;
// Ends nearer than this to the plane of the eye, or behind it, have no direction in the picture.
const NEAREST: f32 = 1e-3;

fn placed(in: VertexIn, end: vec4<f32>) -> vec3<f32> {
    let upright = end.xyz * in.size.xyz + vec3<f32>(0.0, mix(in.size.w, in.colour.w, end.w), 0.0);
    let q = in.turn;
    return in.offset + upright + 2.0 * cross(q.xyz, cross(q.xyz, upright) + q.w * upright);
}

@vertex
fn vertex(in: VertexIn) -> VertexOut {
    let space = space_of_chart();
    let view = port_to_view(space, placed(in, in.here));
    let here = clip_from_view(space, view);
    let there = clip_from_view(space, port_to_view(space, placed(in, in.there)));
    var out: VertexOut;
    out.view = view;
    let clear = 1.0 - fog_at(eye_distance(space, view));
    out.colour = vec4<f32>(in.colour.rgb, 0.9 * clear);
    if min(here.w, there.w) < NEAREST {
        // Before the near plane, where nothing is drawn.
        out.clip = vec4<f32>(0.0, 0.0, 2.0, 1.0);
        return out;
    }
    let pixel = vec2<f32>(scene.pixel_width, scene.pixel_height);
    let way = (there.xy / there.w - here.xy / here.w) / pixel;
    let length_px = max(length(way), 1e-4);
    let across = vec2<f32>(-way.y, way.x) / length_px * (in.side * HALF_WIDTH_PX);
    out.clip = vec4<f32>(here.xy + across * pixel * here.w, here.zw);
    return out;
}

@fragment
fn fragment(in: VertexOut) -> @location(0) vec4<f32> {
    if is_cut(in.view) {
        discard;
    }
    return vec4<f32>(in.colour.rgb * in.colour.a, in.colour.a);
}

// What lies behind land or a figure still shows, faintly.
@fragment
fn fragment_hidden(in: VertexOut) -> @location(0) vec4<f32> {
    if is_cut(in.view) {
        discard;
    }
    let opacity = in.colour.a * 0.25;
    return vec4<f32>(in.colour.rgb * opacity, opacity);
}
