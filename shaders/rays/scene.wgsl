// The solids of a scene: two levels of a hierarchy of boxes, one of each mesh and one of the instances of meshes.
// Follows space.wgsl.

const NOTHING: u32 = 0xffffffffu;
// Levels of both hierarchies together: each has 40 at most and as many more as halving what is left takes (bvh.rs).
const WAITING_ROOM: u32 = 96u;

// A box of the hierarchies. Those of instances come first, so that the root of all is node 0.
struct Node {
    low: vec3<f32>,
    first: u32,     // the first of two children, or of `count` triangles, or an instance
    high: vec3<f32>,
    count: u32,     // 0 where it has children
}

struct Instance {
    row_x: vec4<f32>,   // from the scene to the mesh's coordinates
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    root: u32,
    object: u32,
    materials: u32,     // added to the mesh's materials
    room: u32,
    scale: vec4<f32>,   // metres of the scene for one along each axis of the mesh
}

@group(0) @binding(2) var<storage, read> nodes: array<Node>;
// Three for each triangle: a corner, and the two edges from there; w of the first is its number in its mesh.
@group(0) @binding(3) var<storage, read> triangles: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read> instances: array<Instance>;

// What a straight path has met.
struct Found {
    time: f32,
    instance: u32,
    triangle: u32,
    along: vec2<f32>,   // shares of the second and third corner
}

fn inverse_pace(v: vec3<f32>) -> vec3<f32> {
    return signs(v) / max(abs(v), vec3<f32>(1.0e-20));
}

// When a path is in a box: from x to y. Rounding may not lose what lies in a face.
fn in_box(low: vec3<f32>, high: vec3<f32>, x: vec3<f32>, pace: vec3<f32>) -> vec2<f32> {
    let a = (low - x) * pace;
    let b = (high - x) * pace;
    return vec2<f32>(greatest(min(a, b)), -greatest(-max(a, b)) * 1.0000006);
}

// What the path x + t v meets first for 0 <= t <= longest; or anything that it meets, where `any` will do.
fn scene_first(x: vec3<f32>, v: vec3<f32>, longest: f32, any_will_do: bool) -> Found {
    var found = Found(longest, NOTHING, 0u, vec2<f32>(0.0));
    var waiting: array<u32, WAITING_ROOM>;
    var count = 0u;
    var floor = NOTHING;        // of the waiting ones that belong to the mesh that is looked at; none in the upper level
    var instance = 0u;
    var o = x;
    var d = v;
    var pace = inverse_pace(v);
    var number = 0u;
    loop {
        let first = nodes[number].first;
        let held = nodes[number].count;
        var is_next = false;
        if held == 0u {
            let near = in_box(nodes[first].low, nodes[first].high, o, pace);
            let other = in_box(nodes[first + 1u].low, nodes[first + 1u].high, o, pace);
            let meets = near.x <= near.y && near.y >= 0.0 && near.x <= found.time;
            let meets_other = other.x <= other.y && other.y >= 0.0 && other.x <= found.time;
            let other_is_nearer = other.x < near.x;
            if meets && meets_other {
                waiting[count] = first + select(1u, 0u, other_is_nearer);
                count += 1u;
                number = first + select(0u, 1u, other_is_nearer);
                is_next = true;
            } else if meets || meets_other {
                number = first + select(1u, 0u, meets);
                is_next = true;
            }
        } else if floor == NOTHING {
            instance = first;
            o = vec3<f32>(dot(instances[first].row_x, vec4<f32>(x, 1.0)), dot(instances[first].row_y, vec4<f32>(x, 1.0)), dot(instances[first].row_z, vec4<f32>(x, 1.0)));
            d = vec3<f32>(dot(instances[first].row_x.xyz, v), dot(instances[first].row_y.xyz, v), dot(instances[first].row_z.xyz, v));
            pace = inverse_pace(d);
            floor = count;
            number = instances[first].root;
            is_next = true;
        } else {
            for (var triangle = first; triangle < first + held; triangle++) {
                let corner = triangles[3u * triangle].xyz;
                let ab = triangles[3u * triangle + 1u].xyz;
                let ac = triangles[3u * triangle + 2u].xyz;
                let across = cross(d, ac);
                let volume = dot(ab, across);
                let from_corner = o - corner;
                let one = 1.0 / volume;
                let b = dot(from_corner, across) * one;
                let turned = cross(from_corner, ab);
                let c = dot(d, turned) * one;
                let time = dot(ac, turned) * one;
                if volume != 0.0 && b >= 0.0 && c >= 0.0 && b + c <= 1.0 && time >= 0.0 && time <= found.time {
                    found = Found(time, instance, triangle, vec2<f32>(b, c));
                }
            }
            if any_will_do && found.instance != NOTHING {
                break;
            }
        }
        if !is_next {
            if count == floor {
                floor = NOTHING;
                o = x;
                d = v;
                pace = inverse_pace(v);
            }
            if count == 0u {
                break;
            }
            count -= 1u;
            number = waiting[count];
        }
    }
    return found;
}
