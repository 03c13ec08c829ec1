// Where light of the eye is met first, as raster.wgsl has found it, and how it goes on: by rays. Follows picture.wgsl;
// first_by_rays.wgsl is the other one. Mirrors crates/rays/src/raster.

// A view through a row of doors and portals: light that the eye has from felt direction w is at origin + t K turn w after t felt
// metres of the eye's size, K that of the boxes there times scale.
struct View {
    origin: vec3<f32>,
    depth: u32,             // of the stack
    k_x: vec4<f32>,         // columns of K
    k_y: vec4<f32>,
    k_z: vec4<f32>,
    turn_x: vec4<f32>,      // columns of its turn by the portals
    turn_y: vec4<f32>,
    turn_z: vec4<f32>,
    stack: vec4<u32>,
    scale: f32,             // as in Path
    left: u32,
    passed: u32,
    room: u32,
}

struct Views {
    levels: u32,
    boxes: u32,             // aberrations in which places have to be looked for, since views pass their faces; or 0
    room_x: u32,
    room_y: u32,
    list: array<View>,
}

// What is seen: 1 + a triangle; a wall, with its box, axis and side; a door, with the view through it; or what only rays know.
const WALL_SEEN: u32 = 0x80000000u;
const DOOR_SEEN: u32 = 0xc0000000u;
const RAYS_SEE: u32 = 0xe0000000u;
// Whether there is nothing that only rays know, and nothing that light goes on from: what is not needed takes no time.
override SEES_ALL: bool = false;

@group(2) @binding(0) var visible: texture_2d_array<u32>;
@group(2) @binding(1) var<storage, read> views: Views;

// What is seen, and instance and view. Where nothing is, the view is that of the last door.
fn visible_at(pixel: vec2<u32>) -> vec2<u32> {
    var seen = textureLoad(visible, pixel, 0, 0).xy;
    for (var level = 1u; level < views.levels; level++) {
        if seen.x < DOOR_SEEN || seen.x >= RAYS_SEE {
            break;
        }
        let view = seen.x & 255u;
        seen = textureLoad(visible, pixel, level, 0).xy;
        if seen.x == 0u {
            seen.y = view;
        }
    }
    return seen;
}

// The boxes that a path is in just before it comes to a place.
fn look_for_boxes(path: ptr<function, Path>, v: vec3<f32>) {
    let back = 8.0 * ROUNDING * (1.0 + greatest(abs((*path).x)));
    let place = (*path).x - v * (back * inverseSqrt(max(dot(v, v), 1.0e-30)));
    (*path).stack = vec4<u32>(0u);
    (*path).depth = 0u;
    for (var number = 0u; number < views.boxes; number++) {
        let room = abs(local_place(number, place)) - half_of(number);
        if greatest(room) < 0.0 {
            stack_push(path, number);
        }
    }
}

fn next_seen(path: Path, longest: f32, bounce: u32, pixel: vec2<u32>) -> Ended {
    var seen = vec2<u32>(RAYS_SEE, 0u);
    if bounce == 0u {
        seen = visible_at(pixel);
    }
    var ended = Ended(path, END_SPENT, longest, Found(0.0, NOTHING, 0u, vec2<f32>(0.0)), 0u, 0u, 0u, -1.0);
    let by_rays = seen.x >= DOOR_SEEN;
    let view = select(seen.y & 255u, 0u, by_rays);
    let w = mat3x3<f32>(views.list[view].turn_x.xyz, views.list[view].turn_y.xyz, views.list[view].turn_z.xyz) * path.w;
    ended.path.w = w;
    if seen.x != 0u && !by_rays {
        let k = mat3x3<f32>(views.list[view].k_x.xyz, views.list[view].k_y.xyz, views.list[view].k_z.xyz);
        let origin = views.list[view].origin;
        let v = k * w;
        var time = 0.0;
        if seen.x < WALL_SEEN {
            ended.found = meet_again(seen.x - 1u, seen.y >> 8u, origin, v);
            time = ended.found.time;
            ended.end = END_OBJECT;
        } else {
            ended.wall = (seen.x >> 3u) & 255u;
            ended.axis = (seen.x >> 1u) & 3u;
            let normal = axis_of(ended.wall, ended.axis);
            let side = select(-1.0, 1.0, (seen.x & 1u) != 0u) * half_of(ended.wall)[ended.axis];
            time = max((side - dot(normal, origin - space.boxes[ended.wall].centre)) / dot(normal, v), 0.0);
            ended.end = END_WALL;
        }
        if time > longest {
            ended.end = END_SPENT;
        } else {
            ended.length = time;
            var there = path;
            there.x = origin + time * v;
            there.w = w;
            there.unbent = w;
            there.k = k;
            there.scale = views.list[view].scale;
            there.left = views.list[view].left;
            there.passed = views.list[view].passed;
            there.stack = views.list[view].stack;
            there.depth = views.list[view].depth;
            if views.boxes > 0u {
                look_for_boxes(&there, v);
            }
            ended.path = there;
        }
    }
    if !SEES_ALL && by_rays {
        ended = trace(path, longest, false, bounce == 0u, frame.pixel_rad);
    }
    return ended;
}

// Where a straight path meets a triangle of which one knows that it does. The raster's corners are on a grid, so that the path may
// miss it by a little: then the nearest place of the triangle counts.
fn meet_again(triangle: u32, instance: u32, x: vec3<f32>, v: vec3<f32>) -> Found {
    let moves = (instance_part(instance, 3u).w & MOVES) != 0u;
    let to_mesh = to_mesh_of(instance);
    let o = select(x, vec4<f32>(x, 1.0) * to_mesh, moves);
    let d = select(v, vec4<f32>(v, 0.0) * to_mesh, moves);
    let ab = bitcast<vec3<f32>>(triangle_part(triangle, 1u).xyz);
    let ac = bitcast<vec3<f32>>(triangle_part(triangle, 2u).xyz);
    let across = cross(d, ac);
    let one = 1.0 / dot(ab, across);
    let from_corner = o - bitcast<vec3<f32>>(triangle_part(triangle, 0u).xyz);
    let b = clamp(dot(from_corner, across) * one, 0.0, 1.0);
    let c = clamp(dot(d, cross(from_corner, ab)) * one, 0.0, 1.0 - b);
    // Where the place that is b and c along the edges lies along the path.
    let time = dot(b * ab + c * ac - from_corner, d) / dot(d, d);
    return Found(max(time, 0.0), instance, triangle, vec2<f32>(b, c));
}
