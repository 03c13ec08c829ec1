// Rays of a list, to compare with the same in f64. Follows trace.wgsl.

struct Ray {
    x: vec3<f32>,
    longest: f32,       // felt metres
    w: vec3<f32>,       // felt direction
    depth: u32,         // of its stack
    stack: vec4<u32>,
}

struct Answer {
    x: vec3<f32>,
    length: f32,        // felt metres
    w: vec3<f32>,
    events: u32,
    end: u32,           // how it ended
    what: u32,          // the object or the aberration
    part: u32,          // its triangle or axis
    depth: u32,         // of its stack
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
    let ended = trace(path_from(ray.x, ray.w, ray.stack, ray.depth, false, 1.0), ray.longest, false, false, 0.0);
    var what = ended.wall;
    var part = ended.axis;
    if ended.end == END_OBJECT {
        what = instance_part(ended.found.instance, 3u).y;
        part = triangle_part(ended.found.triangle, 0u).w;
    }
    answers[id.x] = Answer(
        ended.path.x, ended.length,
        ended.path.w, ended.events,
        ended.end, what, part, ended.path.depth,
        ended.path.stack,
    );
}
