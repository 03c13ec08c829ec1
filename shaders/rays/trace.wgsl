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
    padding_x: u32,
    padding_y: u32,
    padding_z: u32,
    near: Near,         // those boxes
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

// Who sets out from a path in felt direction w, and is no light of the picture.
fn path_toward(from_path: ptr<function, Path>, w: vec3<f32>, scale: f32) -> Path {
    let k = squeeze_toward(from_path, w) * scale;
    return Path((*from_path).x, w, w, k, (*from_path).stack, (*from_path).depth, false, scale, NO_PORTAL, 0u);
}

struct Next {
    time: f32,
    number: u32,    // of a box; PORTAL and more, of a portal; NOTHING at the end of the path
    axis: u32,
    enters: bool,   // a portal before its front
}

// The box of that number where a path leaves or enters it before what comes next. Of faces that are met together those of the
// innermost box come first on the way out, and of the outermost on the way in, in whichever order they are asked.
fn or_face(next: Next, number: u32, leaves: bool, x: vec3<f32>, v: vec3<f32>, longest: f32, together: f32) -> Next {
    let axes = axes_of(number);
    let h = half_of(number);
    let l = (x - space.boxes[number].centre) * axes;
    let u = v * axes;
    let slack = select(together, 0.0, next.number == NOTHING);
    if leaves {
        let out = crossing_out(l, u, h);
        if out.time < next.time + slack {
            return Next(min(out.time, longest), number, out.axis, false);
        }
        return next;
    }
    let crossing = crossing_in(l, u, h);
    let is_outer = HAS_CROWDS && next.enters && space.boxes[number].rank < space.boxes[next.number].rank;
    if crossing.is_there && crossing.time < next.time - select(slack, -slack, is_outer) {
        return Next(crossing.time, number, crossing.axis, true);
    }
    return next;
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
    var near = ways.near;
    if depth > 0u {
        near = space.boxes[stack_get(stack, depth - 1u)].near;
    }
    // The boxes that it is in, and those that it can enter.
    var at = 0u;
    loop {
        let leaves = at < depth;
        let slot = at - depth;
        let few = select(near.few_low, near.few_high, slot >= 4u);
        let number = select((few >> (8u * (slot & 3u))) & 255u, stack_get(stack, at), leaves);
        if leaves || (slot < near.few && !stack_has(stack, depth, number)) {
            next = or_face(next, number, leaves, x, v, longest, together);
        }
        at += 1u;
        if at >= depth + near.few {
            break;
        }
    }
    if HAS_CROWDS {
        let pace = inverse_pace(v);
        let ahead = v >= vec3<f32>(0.0);
        var node = near.crowd;
        let end = select(neighbours[node + 3u], NOTHING, node == NOTHING);
        while node < end {
            let low = vec3<u32>(neighbours[node], neighbours[node + 1u], neighbours[node + 2u]);
            let high = vec3<u32>(neighbours[node + 4u], neighbours[node + 5u], neighbours[node + 6u]);
            let within = in_box(low, high, x, pace, ahead);
            if within.x > within.y || within.y < 0.0 || within.x > next.time {
                node = neighbours[node + 3u];
                continue;
            }
            let number = neighbours[node + 7u];
            node += 8u;
            if number != NOTHING && !stack_has(stack, depth, number) {
                next = or_face(next, number, false, x, v, longest, together);
            }
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

// Whether a path on a face of a box is within `width` felt metres of one of its edges. A felt way u leads by <K u, a> along an
// axis a of the box, so by |K^T a| at most.
fn is_at_edge(number: u32, axis: u32, path: ptr<function, Path>, width: f32) -> bool {
    let box = space.boxes[number];
    let k = (*path).k;
    let felt = vec3<f32>(length(box.x_axis * k), length(box.y_axis * k), length(box.z_axis * k));
    var room = half_of(number) - abs(local_place(number, (*path).x)) - width * felt;
    room[axis] = 1.0e9;
    return -greatest(-room) < 0.0;
}

// Felt metres that an outline is wide at least.
const THINNEST: f32 = 0.002;

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
        if HAS_OUTLINES && width > 0.0 && ended.outline < 0.0 && (space.boxes[next.number].flags & ways.outlined) != 0u && is_at_edge(next.number, next.axis, &path, THINNEST + width * ended.length) {
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
