// The one routine by which light goes through deformed space. Mirrors crates/deformation/src/trace.rs. Follows scene.wgsl.

const MAX_EVENTS: u32 = 64u;

const END_SPENT: u32 = 0u;
const END_OBJECT: u32 = 1u;
const END_WALL: u32 = 2u;
const END_TOO_MANY: u32 = 3u;

// What a path needs to know of the scene besides its solids.
struct Ways {
    outermost: u32,     // where in `neighbours` the boxes begin that can be entered from outside of all
    outermost_count: u32,
    root: u32,          // of the hierarchy of all solids, or NOTHING
    outlined: u32,      // the flags of a box whose outline is drawn, any of them
    portal_count: u32,
    crowd: u32,         // where the tree of these boxes lies in `neighbours`, if they are many
    crowd_end: u32,
    padding: u32,
    corners: Corners,
}

// No uniform, since it changes with every picture: see frame.wgsl.
@group(0) @binding(5) var<storage, read> ways: Ways;

// How a path has ended.
struct Ended {
    path: Path,
    end: u32,
    length: f32,        // felt metres
    found: Found,
    wall: u32,          // the aberration whose wall it is, and across which axis
    axis: u32,
    events: u32,
    outline: f32,       // felt metres to the first outline that it passed within `width`, or -1
}

// Who sets out, as large as the metres of the scene times `scale`.
fn path_from(x: vec3<f32>, w: vec3<f32>, stack: vec4<u32>, depth: u32, is_light: bool, scale: f32) -> Path {
    var path = Path(x, w, w, mat3x3<f32>(), stack, depth, is_light, scale, NO_PORTAL, 0u);
    if HAS_LEGACY && is_light {
        for (var at = 0u; at < depth; at++) {
            let number = stack_get(stack, at);
            if space.boxes[number].sides == SIDES_LEGACY && is_felt(number, w) {
                path.w = legacy_bend(ways.corners, path.w, space.boxes[number].legacy);
            }
        }
    }
    path.k = carry(&path);
    return path;
}

struct Next {
    time: f32,
    number: u32,    // of a box; PORTAL and more, of a portal; NOTHING at the end of the path
    axis: u32,
    enters: bool,   // a portal before its front
}

fn next_event(path: ptr<function, Path>, v: vec3<f32>, longest: f32) -> Next {
    let x = (*path).x;
    let stack = (*path).stack;
    let depth = (*path).depth;
    let together = 2.0 * ROUNDING * (1.0 + greatest(abs(x))) * inverseSqrt(max(dot(v, v), 1.0e-30));
    var next = Next(longest, NOTHING, 0u, false);
    if !HAS_FACES {
        return next;
    }
    for (var at = 0u; at < depth; at++) {
        let number = stack_get(stack, at);
        let out = crossing_out(local_vector(number, x - space.boxes[number].centre), local_vector(number, v), half_of(number));
        let is_tied = next.number != NOTHING && out.time <= next.time + together;
        if out.time < next.time || is_tied {
            next = Next(min(out.time, longest), number, out.axis, false);
        }
    }
    var first = ways.outermost;
    var count = ways.outermost_count;
    var crowd = ways.crowd;
    var crowd_end = ways.crowd_end;
    if depth > 0u {
        let innermost = stack_get(stack, depth - 1u);
        first = space.boxes[innermost].first;
        count = space.boxes[innermost].count;
        crowd = space.boxes[innermost].crowd;
        crowd_end = space.boxes[innermost].crowd_end;
    }
    if crowd < crowd_end {
        count = 0u;
        let pace = inverse_pace(v);
        let ahead = v >= vec3<f32>(0.0);
        while crowd < crowd_end {
            let low = vec3<u32>(neighbours[crowd], neighbours[crowd + 1u], neighbours[crowd + 2u]);
            let high = vec3<u32>(neighbours[crowd + 4u], neighbours[crowd + 5u], neighbours[crowd + 6u]);
            let within = in_box(low, high, x, pace, ahead);
            if within.x > within.y || within.y < 0.0 || within.x > next.time {
                crowd = neighbours[crowd + 3u];
                continue;
            }
            let number = neighbours[crowd + 7u];
            crowd += 8u;
            if number == NOTHING || stack_has(stack, depth, number) {
                continue;
            }
            let crossing = crossing_in(local_vector(number, x - space.boxes[number].centre), local_vector(number, v), half_of(number));
            // Of boxes that are entered together the outermost comes first, in whichever order they are asked.
            var slack = select(together, 0.0, next.number == NOTHING);
            if next.enters && space.boxes[number].rank < space.boxes[next.number].rank {
                slack = -together;
            }
            if crossing.is_there && crossing.time < next.time - slack {
                next = Next(crossing.time, number, crossing.axis, true);
            }
        }
    }
    for (var slot = first; slot < first + count; slot++) {
        let number = neighbours[slot];
        if stack_has(stack, depth, number) {
            continue;
        }
        let crossing = crossing_in(local_vector(number, x - space.boxes[number].centre), local_vector(number, v), half_of(number));
        let least = next.time - select(together, 0.0, next.number == NOTHING);
        if crossing.is_there && crossing.time < least {
            next = Next(crossing.time, number, crossing.axis, true);
        }
    }
    if HAS_PORTALS {
        for (var number = 0u; number < ways.portal_count; number++) {
            let opening = portal_opening(number, path, v);
            if opening.time >= 0.0 && opening.time < next.time {
                next = Next(opening.time, PORTAL + number, 0u, opening.front);
            }
        }
    }
    return next;
}

// Whether a point of a face of a box lies within `width` of one of its edges.
fn is_at_edge(number: u32, axis: u32, x: vec3<f32>, width: f32) -> bool {
    var room = half_of(number) - abs(local_vector(number, x - space.boxes[number].centre));
    room[axis] = 1.0e9;
    return -greatest(-room) < width;
}

// Goes on for at most `longest` felt metres. Outlines of boxes are told where a pixel is `width` felt metres wide for each
// metre; none for 0. Light of the eye passes what it does not see.
fn trace(start: Path, longest: f32, any_will_do: bool, of_eye: bool, width: f32) -> Ended {
    var ended = Ended(start, END_TOO_MANY, 0.0, Found(0.0, NOTHING, 0u, vec2<f32>(0.0)), 0u, 0u, 0u, -1.0);
    var path = start;
    for (var event = 0u; event < MAX_EVENTS; event++) {
        let v = path.k * path.w;
        let next = next_event(&path, v, max(longest - ended.length, 0.0));
        var beyond = ROUNDING * (1.0 + greatest(abs(path.x))) * inverseSqrt(max(dot(v, v), 1.0e-30));
        var hidden = 0.0;
        let is_portal = HAS_PORTALS && next.number >= PORTAL && next.number != NOTHING;
        if HAS_PORTALS {
            // What lies in a portal's plane is hidden by it from either side.
            hidden = portal_hid(&path, v);
            if is_portal {
                beyond = -portal_hides(next.number - PORTAL, path.x, v);
            }
        }
        // Through a portal one sees oneself.
        let unseen = of_eye && (!HAS_PORTALS || path.passed == 0u);
        var found = scene_first(path.x + hidden * v, v, next.time + beyond - hidden, ways.root, any_will_do, unseen);
        if found.instance != NOTHING {
            found.time += hidden;
            path.x += found.time * v;
            ended.length += found.time;
            ended.end = END_OBJECT;
            ended.found = found;
            break;
        }
        path.x += next.time * v;
        ended.length += next.time;
        if next.number == NOTHING {
            ended.end = END_SPENT;
            break;
        }
        if is_portal {
            ended.events += 1u;
            pass_portal(&path, next.number - PORTAL, next.enters);
            continue;
        }
        if width > 0.0 && ended.outline < 0.0 && (space.boxes[next.number].flags & ways.outlined) != 0u && is_at_edge(next.number, next.axis, path.x, 0.002 + width * ended.length * length(v)) {
            ended.outline = ended.length;
        }
        ended.events += 1u;
        if cross_face(&path, next.number, next.axis, next.enters, ways.corners) == WALL {
            ended.end = END_WALL;
            ended.wall = next.number;
            ended.axis = next.axis;
            break;
        }
    }
    ended.path = path;
    return ended;
}
