// Deformed space: aberrations, and what their faces do. Mirrors crates/deformation (event.rs, face.rs, space.rs) in f32.
// First of the files of shaders/rays; portal.wgsl, scene.wgsl, trace.wgsl, shading.wgsl and an entry follow.

const SIDES_SOFT: u32 = 0u;
const SIDES_SNELL: u32 = 1u;
const SIDES_LEGACY: u32 = 2u;
const EXIT_ORIGINAL: u32 = 0u;
const EXIT_INVERSE: u32 = 1u;
// Boxes that a stack has room for, one a byte.
const STACK_ROOM: u32 = 16u;
// Rounding of a place, as a share of the numbers that it is made of.
const ROUNDING: f32 = 1.0e-6;
const LEAST_SPEED: f32 = 1.0e-18;

// The boxes that can be entered from a place, for who looks for the next face.
struct Near {
    few_low: u32,           // their numbers, one a byte, if they are few
    few_high: u32,
    few: u32,               // how many those are
    crowd: u32,             // where the tree of many begins in `neighbours`, or NOTHING
}

struct Aberration {
    centre: vec3<f32>,
    sides: u32,
    x_axis: vec3<f32>,      // its axes in the scene
    half_x: f32,
    y_axis: vec3<f32>,
    half_y: f32,
    z_axis: vec3<f32>,
    half_z: f32,
    squeeze_x: vec3<f32>,   // rows of K = R diag(1/s) R^T, which is symmetric
    walls: u32,             // a bit for each axis across which its faces are opaque
    squeeze_y: vec3<f32>,
    first: u32,             // of its neighbours in `neighbours`
    squeeze_z: vec3<f32>,
    count: u32,             // of them
    legacy: vec3<f32>,      // d = 1/s - 1
    flags: u32,             // exit rule; bit 8: outlined
    stretch: vec3<f32>,
    rank: u32,
    heading: vec3<f32>,     // the direction with which one must go to feel it, or 0 where it is felt whichever way
    is_felt_always: f32,    // 1 then, or 0
    near: Near,
    wall_material: u32,
    padding_x: u32,
    padding_y: u32,
    padding_z: u32,
}

// Whether there are boxes of those sides: what is not there takes no time.
override HAS_SNELL: bool = true;
override HAS_LEGACY: bool = true;
// Whether boxes can be entered from within others.
override HAS_NESTS: bool = true;
// Whether some boxes are felt one way only, and whether so many can be entered from one place that there is a tree of them.
override HAS_HEADINGS: bool = true;
override HAS_CROWDS: bool = true;
override HAS_OUTLINES: bool = true;
// Whether nothing is felt to be stretched, and whether it matters which faces light passes.
override IS_FLAT: bool = false;
override HAS_FACES: bool = true;

struct Spaces {
    boxes: array<Aberration, 256>,
}

@group(0) @binding(0) var<uniform> space: Spaces;
// Lists of boxes that can be entered from within each, and at the end those that can be from outside of all; trees of them.
@group(0) @binding(1) var<storage, read> neighbours: array<u32>;

// Who travels.
struct Path {
    x: vec3<f32>,
    w: vec3<f32>,           // felt direction, of length 1
    unbent: vec3<f32>,      // the same before the thesis's rule bent it
    k: mat3x3<f32>,         // product of the K of the boxes of the stack, times scale
    stack: vec4<u32>,       // a byte for each box, outermost first
    depth: u32,
    is_light: bool,         // light of the picture, which the thesis's rule bends
    scale: f32,             // how many times larger than at first the traveller is
    left: u32,              // the portal that it has come out of last, 256 more before its front; or NO_PORTAL
    passed: u32,            // portals
}

// The directions of two opposite corners of the picture, component by component.
struct Corners {
    low: vec4<f32>,
    high: vec4<f32>,
}

fn stack_get(stack: vec4<u32>, at: u32) -> u32 {
    return (stack[at >> 2u] >> (8u * (at & 3u))) & 255u;
}

fn stack_set(stack: vec4<u32>, at: u32, number: u32) -> vec4<u32> {
    var changed = stack;
    let shift = 8u * (at & 3u);
    changed[at >> 2u] = (stack[at >> 2u] & ~(255u << shift)) | (number << shift);
    return changed;
}

fn stack_has(stack: vec4<u32>, depth: u32, number: u32) -> bool {
    var at = 0u;
    var has = false;
    loop {
        has = has || (at < depth && stack_get(stack, at) == number);
        at += 1u;
        if !HAS_NESTS || has || at >= depth {
            break;
        }
    }
    return has;
}

fn stack_push(path: ptr<function, Path>, number: u32) {
    if (*path).depth == STACK_ROOM {
        return;
    }
    var at = (*path).depth;
    let rank = space.boxes[number].rank;
    loop {
        let below = stack_get((*path).stack, max(at, 1u) - 1u);
        if !HAS_NESTS || at == 0u || space.boxes[below].rank <= rank {
            break;
        }
        (*path).stack = stack_set((*path).stack, at, below);
        at -= 1u;
    }
    (*path).stack = stack_set((*path).stack, at, number);
    (*path).depth += 1u;
}

fn stack_pop(path: ptr<function, Path>, number: u32) {
    let stack = (*path).stack;
    let depth = (*path).depth;
    var to = 0u;
    var at = 0u;
    (*path).stack = vec4<u32>(0u);
    loop {
        let one = stack_get(stack, at);
        if at < depth && one != number {
            (*path).stack = stack_set((*path).stack, to, one);
            to += 1u;
        }
        at += 1u;
        if !HAS_NESTS || at >= depth {
            break;
        }
    }
    (*path).depth = to;
}

fn half_of(number: u32) -> vec3<f32> {
    return vec3<f32>(space.boxes[number].half_x, space.boxes[number].half_y, space.boxes[number].half_z);
}

// Whether a box is felt by who goes in felt direction w.
fn is_felt(number: u32, w: vec3<f32>) -> bool {
    return !HAS_HEADINGS || dot(space.boxes[number].heading, w) + space.boxes[number].is_felt_always > 0.0;
}

// The product of the K of all boxes of a stack, the innermost to the left.
fn squeeze_of(stack: vec4<u32>, depth: u32, w: vec3<f32>, is_light: bool) -> mat3x3<f32> {
    var k = mat3x3<f32>(vec3<f32>(1.0, 0.0, 0.0), vec3<f32>(0.0, 1.0, 0.0), vec3<f32>(0.0, 0.0, 1.0));
    if IS_FLAT {
        return k;
    }
    var at = 0u;
    loop {
        let number = stack_get(stack, at);
        if at < depth && is_felt(number, w) {
            if HAS_LEGACY && space.boxes[number].sides == SIDES_LEGACY {
                if !is_light {
                    let s = vec3<f32>(1.0) + space.boxes[number].legacy;
                    k = mat3x3<f32>(s * k[0], s * k[1], s * k[2]);
                }
            } else {
                // Symmetric, so that rows are columns.
                let own = mat3x3<f32>(space.boxes[number].squeeze_x, space.boxes[number].squeeze_y, space.boxes[number].squeeze_z);
                k = own * k;
            }
        }
        at += 1u;
        if !HAS_NESTS || at >= depth {
            break;
        }
    }
    return k;
}

fn axes_of(number: u32) -> mat3x3<f32> {
    return mat3x3<f32>(space.boxes[number].x_axis, space.boxes[number].y_axis, space.boxes[number].z_axis);
}

// A place in a box's own coordinates.
fn local_place(number: u32, x: vec3<f32>) -> vec3<f32> {
    return (x - space.boxes[number].centre) * axes_of(number);
}

fn axis_of(number: u32, axis: u32) -> vec3<f32> {
    switch axis {
        case 0u: { return space.boxes[number].x_axis; }
        case 1u: { return space.boxes[number].y_axis; }
        default: { return space.boxes[number].z_axis; }
    }
}

// A crossing of a face: when, across which axis, and whether there is one.
struct Crossing {
    time: f32,
    axis: u32,
    is_there: bool,
}

fn signs(u: vec3<f32>) -> vec3<f32> {
    return select(vec3<f32>(-1.0), vec3<f32>(1.0), u >= vec3<f32>(0.0));
}

fn greatest(v: vec3<f32>) -> f32 {
    return max(v.x, max(v.y, v.z));
}

// When a path from l at velocity u, in the box's own axes, enters the box of half sizes h. See event.rs.
fn crossing_in(l: vec3<f32>, u: vec3<f32>, h: vec3<f32>) -> Crossing {
    let slack = ROUNDING * (1.0 + greatest(abs(l)) + greatest(h));
    let sign = signs(u);
    let speed = max(abs(u), vec3<f32>(LEAST_SPEED));
    let near = -h - sign * l;
    let far = h - sign * l;
    let enters = near / speed;
    let leaves = far / speed;
    var time = enters.x;
    var before = near.x;
    var axis = 0u;
    if enters.y > time {
        time = enters.y;
        before = near.y;
        axis = 1u;
    }
    if enters.z > time {
        time = enters.z;
        before = near.z;
        axis = 2u;
    }
    let is_there = all(far > vec3<f32>(slack)) && before >= -slack && time < min(leaves.x, min(leaves.y, leaves.z));
    return Crossing(max(time, 0.0), axis, is_there);
}

// When a path from l inside of the box leaves it.
fn crossing_out(l: vec3<f32>, u: vec3<f32>, h: vec3<f32>) -> Crossing {
    let leaves = (h - signs(u) * l) / max(abs(u), vec3<f32>(LEAST_SPEED));
    var time = leaves.x;
    var axis = 0u;
    if leaves.y < time {
        time = leaves.y;
        axis = 1u;
    }
    if leaves.z < time {
        time = leaves.z;
        axis = 2u;
    }
    return Crossing(max(time, 0.0), axis, true);
}

// The thesis's bend. See legacy.rs.
fn legacy_bend(corners: Corners, r: vec3<f32>, d: vec3<f32>) -> vec3<f32> {
    let t = clamp((r - corners.low.xyz) / max(corners.high.xyz - corners.low.xyz, vec3<f32>(1.0e-30)), vec3<f32>(0.0), vec3<f32>(1.0));
    let bent = r + d * (2.0 * t * t * (3.0 - 2.0 * t) - 1.0);
    let length2 = dot(bent, bent);
    return select(r, bent * inverseSqrt(max(length2, 1.0e-20)), length2 > 1.0e-12);
}

fn inverse_of(m: mat3x3<f32>) -> mat3x3<f32> {
    let a = cross(m[1], m[2]);
    let b = cross(m[2], m[0]);
    let c = cross(m[0], m[1]);
    return transpose(mat3x3<f32>(a, b, c)) * (1.0 / dot(m[0], a));
}

// What became of a path at a face.
const WENT_THROUGH: u32 = 0u;
const REFLECTED: u32 = 1u;
const WALL: u32 = 2u;

// Takes a path through a face of a box, into it or out of it. See face.rs.
fn cross_face(path: ptr<function, Path>, number: u32, axis: u32, enters: bool, corners: Corners) -> u32 {
    if (space.boxes[number].walls & (1u << axis)) != 0u {
        return WALL;
    }
    let before = *path;
    if enters {
        stack_push(path, number);
    } else {
        stack_pop(path, number);
    }
    let sides = space.boxes[number].sides;
    if HAS_LEGACY && sides == SIDES_LEGACY && before.is_light && is_felt(number, before.unbent) {
        let d = space.boxes[number].legacy;
        let exit = space.boxes[number].flags & 15u;
        if enters {
            (*path).unbent = before.w;
            (*path).w = legacy_bend(corners, before.w, d);
        } else if exit == EXIT_ORIGINAL {
            (*path).w = before.unbent;
        } else if exit == EXIT_INVERSE {
            (*path).w = legacy_bend(corners, before.w, -d);
        }
    }
    (*path).k = carry(path);
    if HAS_SNELL && sides == SIDES_SNELL {
        let n = axis_of(number, axis);
        let m = n * (*path).k;
        let p = before.w * inverse_of(before.k);
        let q = p * (*path).k;
        let a = dot(m, m);
        let b = dot(q, m);
        let left = b * b - a * (dot(q, q) - 1.0);
        if left < 0.0 {
            let mirror = normalize(n * before.k);
            (*path).stack = before.stack;
            (*path).depth = before.depth;
            (*path).k = before.k;
            (*path).w = normalize(before.w - 2.0 * dot(before.w, mirror) * mirror);
            return REFLECTED;
        }
        let ahead = select(-1.0, 1.0, dot(n, before.k * before.w) >= 0.0);
        (*path).w = normalize(q + (ahead * sqrt(left) - b) / a * m);
    }
    return WENT_THROUGH;
}
