// Rays of a list, to compare with the same in f64. Follows trace.wgsl.

struct Ray {
    x: vec4<f32>,       // w: longest
    w: vec4<f32>,       // w: depth of its stack
    stack: vec4<u32>,
}

struct Answer {
    x: vec4<f32>,       // w: felt length
    w: vec4<f32>,       // w: events
    what: vec4<u32>,    // how it ended; object or aberration; triangle or axis; depth of the stack
    stack: vec4<u32>,
}

@group(1) @binding(0) var<storage, read> rays: array<Ray>;
@group(1) @binding(1) var<storage, read_write> answers: array<Answer>;

@compute @workgroup_size(64)
fn probe(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&rays) {
        return;
    }
    let ray = rays[id.x];
    let ended = trace(path_from(ray.x.xyz, ray.w.xyz, ray.stack, u32(ray.w.w), false, 1.0), ray.x.w, false, false, 0.0);
    var what = vec2<u32>(ended.wall, ended.axis);
    if ended.end == END_OBJECT {
        what = vec2<u32>(instance_part(ended.found.instance, 3u).y, triangle_part(ended.found.triangle, 0u).w);
    }
    answers[id.x] = Answer(
        vec4<f32>(ended.path.x, ended.length),
        vec4<f32>(ended.path.w, f32(ended.events)),
        vec4<u32>(ended.end, what, ended.path.depth),
        ended.path.stack,
    );
}
