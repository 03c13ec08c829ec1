// The solids of a scene: a hierarchy of boxes over all that stays, one for each mesh that moves, and one over all of these.
// Follows space.wgsl.
//
// What is read at each step lies in textures: software adapters read them many lanes at a time, and buffers lane after lane.
// They also run both branches of every `if`, so that what is seldom needed stands in a loop further out; and the body of a loop
// once more for lanes that leave it at its beginning, so that loops are left at their end.

const NOTHING: u32 = 0xffffffffu;
// What is waiting below all that belongs to the instance that a path is in.
const LEFT_INSTANCE: u32 = 0xfffffffeu;
// What a child is: another node, triangles from that one on, or an instance.
const TRIANGLES: u32 = 0x40000000u;
const INSTANCE: u32 = 0x80000000u;
// Flags of instances.
const MOVES: u32 = 1u;
const UNSEEN_BY_EYE: u32 = 2u;
const HELD: u32 = 4u;             // seen by the eye alone
// Whether movers may be cut, as at portals.
override HAS_CUTS: bool = true;
// Texels of a row of the lists: 2 to the power of this.
const ROW_BITS: u32 = 11u;

// Four for each node: the corners of the boxes of its children; w of the first two: what they are.
@group(0) @binding(2) var nodes: texture_2d<u32>;
// Three for each triangle: a corner, and the two edges from there; w: its number in its mesh, 1 for the last one of a leaf,
// and the instance of what stays.
@group(0) @binding(3) var triangles: texture_2d<u32>;
// Eight for each instance: rows from the scene to the mesh's coordinates; root, object, materials and flags; metres of the
// scene for one along each axis of the mesh; a plane in the mesh's coordinates, what is behind which is not there, or nought.
@group(0) @binding(4) var instances: texture_2d<u32>;

// What a straight path has met.
struct Found {
    time: f32,
    instance: u32,
    triangle: u32,
    along: vec2<f32>,   // shares of the second and third corner
}

fn texel(number: u32) -> vec2<u32> {
    return vec2<u32>(number & ((1u << ROW_BITS) - 1u), number >> ROW_BITS);
}

fn triangle_part(triangle: u32, part: u32) -> vec4<u32> {
    return textureLoad(triangles, texel(3u * triangle + part), 0);
}

fn instance_part(instance: u32, part: u32) -> vec4<u32> {
    return textureLoad(instances, texel(8u * instance + part), 0);
}

// From the scene to an instance's coordinates: to be multiplied from the left by a place with a fourth coordinate of 1.
fn to_mesh_of(instance: u32) -> mat3x4<f32> {
    return mat3x4<f32>(bitcast<vec4<f32>>(instance_part(instance, 0u)), bitcast<vec4<f32>>(instance_part(instance, 1u)), bitcast<vec4<f32>>(instance_part(instance, 2u)));
}

fn inverse_pace(v: vec3<f32>) -> vec3<f32> {
    return signs(v) / max(abs(v), vec3<f32>(1.0e-20));
}

// When a path is in a box: from x to y. Rounding may not lose what lies in a face.
fn in_box(low: vec3<u32>, high: vec3<u32>, x: vec3<f32>, pace: vec3<f32>, ahead: vec3<bool>) -> vec2<f32> {
    let enters = (bitcast<vec3<f32>>(select(high, low, ahead)) - x) * pace;
    let leaves = (bitcast<vec3<f32>>(select(low, high, ahead)) - x) * pace;
    return vec2<f32>(max(enters.x, max(enters.y, enters.z)), min(leaves.x, min(leaves.y, leaves.z)) * 1.0000006);
}

// Meets a triangle if that comes before what is found (T. Moeller and B. Trumbore, 1997); whether it is the last of its leaf.
fn meet(triangle: u32, o: vec3<f32>, d: vec3<f32>, instance: u32, cut: vec4<f32>, found: ptr<function, Found>) -> bool {
    let corner = triangle_part(triangle, 0u);
    let second = triangle_part(triangle, 1u);
    let third = triangle_part(triangle, 2u);
    let ab = bitcast<vec3<f32>>(second.xyz);
    let ac = bitcast<vec3<f32>>(third.xyz);
    let across = cross(d, ac);
    let volume = dot(ab, across);
    let from_corner = o - bitcast<vec3<f32>>(corner.xyz);
    let one = 1.0 / volume;
    let b = dot(from_corner, across) * one;
    let turned = cross(from_corner, ab);
    let c = dot(d, turned) * one;
    let time = dot(ac, turned) * one;
    let is_there = !HAS_CUTS || dot(cut, vec4<f32>(o + time * d, 1.0)) >= 0.0;
    if volume != 0.0 && b >= 0.0 && c >= 0.0 && b + c <= 1.0 && time >= 0.0 && time <= (*found).time && is_there {
        *found = Found(time, instance + third.w, triangle, vec2<f32>(b, c));
    }
    return second.w != 0u;
}

// How many children may wait while a path goes down the hierarchies: each has 40 levels at most and as many more as halving
// what is left takes (bvh.rs).
const WAITING_ROOM: u32 = 98u;

// Children that wait. Not of the function, which would have to empty it anew each time.
var<private> waiting: array<u32, WAITING_ROOM>;

// What the path x + t v meets first for 0 <= t <= longest; or anything that it meets, where `any_will_do`. Light of the eye
// passes what it does not see, and all other light what is held before it.
fn scene_first(x: vec3<f32>, v: vec3<f32>, longest: f32, root: u32, any_will_do: bool, of_eye: bool) -> Found {
    var found = Found(longest, NOTHING, 0u, vec2<f32>(0.0));
    waiting[0] = NOTHING;
    var count = 1u;
    var instance = 0u;
    var cut = vec4<f32>(0.0);
    var o = x;
    var d = v;
    var pace = inverse_pace(v);
    var ahead = v >= vec3<f32>(0.0);
    var at = root;
    loop {
        loop {
            // Down to triangles, or whatever is no node.
            loop {
                if at >= TRIANGLES {
                    break;
                }
                let place = texel(4u * at);
                let low = textureLoad(nodes, place, 0);
                let high = textureLoad(nodes, place + vec2<u32>(1u, 0u), 0);
                let other_low = textureLoad(nodes, place + vec2<u32>(2u, 0u), 0);
                let other_high = textureLoad(nodes, place + vec2<u32>(3u, 0u), 0);
                let one = in_box(low.xyz, high.xyz, o, pace, ahead);
                let other = in_box(other_low.xyz, other_high.xyz, o, pace, ahead);
                let meets = one.x <= one.y && one.y >= 0.0 && one.x <= found.time;
                let meets_other = other.x <= other.y && other.y >= 0.0 && other.x <= found.time;
                let other_first = meets_other && (other.x < one.x || !meets);
                if meets && meets_other {
                    waiting[count] = select(high.w, low.w, other_first);
                    count += 1u;
                }
                at = select(low.w, high.w, other_first);
                if !meets && !meets_other {
                    count -= 1u;
                    at = waiting[count];
                }
            }
            if at >= INSTANCE {
                break;
            }
            var triangle = at - TRIANGLES;
            loop {
                if meet(triangle, o, d, instance, cut, &found) {
                    break;
                }
                triangle += 1u;
            }
            if any_will_do && found.instance != NOTHING {
                count = 1u;
            }
            count -= 1u;
            at = waiting[count];
        }
        if at == NOTHING {
            break;
        }
        let enters = at != LEFT_INSTANCE;
        instance = select(0u, at - INSTANCE, enters);
        let to_mesh = to_mesh_of(instance);
        let about = instance_part(instance, 3u);
        if HAS_CUTS {
            cut = select(vec4<f32>(0.0), bitcast<vec4<f32>>(instance_part(instance, 5u)), enters);
        }
        o = select(x, vec4<f32>(x, 1.0) * to_mesh, enters);
        d = select(v, vec4<f32>(v, 0.0) * to_mesh, enters);
        pace = inverse_pace(d);
        ahead = d >= vec3<f32>(0.0);
        if enters {
            waiting[count] = LEFT_INSTANCE;
            count += 1u;
            at = about.x;
        }
        if !enters || (about.w & select(HELD, UNSEEN_BY_EYE, of_eye)) != 0u {
            count -= 1u;
            at = waiting[count];
        }
    }
    return found;
}
