// Portals, and what becomes of a path at one. Mirrors crates/deformation/src/portal.rs in f32. Follows space.wgsl.

// What a portal's number is in the list of events, beside those of boxes.
const PORTAL: u32 = 0x40000000u;
// A path that has passed none.
const NO_PORTAL: u32 = 0xffffffffu;
const BEFORE_FRONT: u32 = 256u;

struct Portal {
    at: vec3<f32>,
    scale: f32,             // q
    normal: vec3<f32>,
    partner: u32,
    right: vec3<f32>,
    sides: u32,
    up: vec3<f32>,
    first: u32,             // of its edges
    linear_x: vec3<f32>,    // rows of q K2 O A1, the linear part of G
    edges: u32,
    linear_y: vec3<f32>,
    is_turned: u32,
    linear_z: vec3<f32>,
    depth: u32,             // of its own stack
    turn_x: vec3<f32>,      // rows of O
    padding_x: u32,
    turn_y: vec3<f32>,
    padding_y: u32,
    turn_z: vec3<f32>,
    padding_z: u32,
    stack: vec4<u32>,       // that it stands in
}

struct Edge {
    inwards: vec2<f32>,     // a direction in the portal's plane, to the right and up
    least: f32,             // what a place of the polygon has along it
    padding: f32,
}

struct Portals {
    all: array<Portal, 64>,
    edges: array<Edge, 1024>,
}

// Whether there are portals: what is not there takes no time.
override HAS_PORTALS: bool = true;

@group(0) @binding(6) var<uniform> portals: Portals;

// K of a path's stack times its scale.
fn carry(path: ptr<function, Path>) -> mat3x3<f32> {
    let k = squeeze_of((*path).stack, (*path).depth, (*path).w, (*path).is_light);
    if HAS_PORTALS {
        return k * (*path).scale;
    }
    return k;
}

// K of a path's boxes for who goes from there in felt direction w and is no light of the picture, without the path's scale. It is
// the path's own where all boxes are felt whichever way.
fn squeeze_toward(path: ptr<function, Path>, w: vec3<f32>) -> mat3x3<f32> {
    if HAS_HEADINGS || HAS_LEGACY {
        return squeeze_of((*path).stack, (*path).depth, w, false);
    }
    return (*path).k * (1.0 / (*path).scale);
}

fn portal_slack(x: vec3<f32>) -> f32 {
    return ROUNDING * (1.0 + greatest(abs(x)));
}

fn before_portal(number: u32, x: vec3<f32>) -> f32 {
    return dot(portals.all[number].normal, x - portals.all[number].at);
}

fn is_in_portal(number: u32, x: vec3<f32>) -> bool {
    let away = x - portals.all[number].at;
    let local = vec2<f32>(dot(portals.all[number].right, away), dot(portals.all[number].up, away));
    let first = portals.all[number].first;
    for (var edge = first; edge < first + portals.all[number].edges; edge++) {
        if dot(portals.edges[edge].inwards, local) < portals.edges[edge].least {
            return false;
        }
    }
    return true;
}

// A way into a portal: when, or -1, and whether before its front.
struct Opening {
    time: f32,
    front: bool,
}

fn portal_opening(number: u32, path: ptr<function, Path>, v: vec3<f32>) -> Opening {
    let x = (*path).x;
    let before = before_portal(number, x);
    let rate = dot(portals.all[number].normal, v);
    var front = before > 0.0;
    if abs(before) <= portal_slack(x) {
        front = rate < 0.0;
        // Who has just come out is on the side that it came out to.
        if ((*path).left & 255u) == number && (*path).left != NO_PORTAL {
            front = ((*path).left & BEFORE_FRONT) != 0u;
        }
    }
    let sign = select(-1.0, 1.0, front);
    let across = -sign * rate;
    let is_open = front || portals.all[number].sides == 2u;
    if across <= 0.0 || !is_open {
        return Opening(-1.0, front);
    }
    let time = max(sign * before, 0.0) / across;
    return Opening(select(-1.0, time, is_in_portal(number, x + v * time)), front);
}

// For how long one is so near to a portal's plane that a solid there may lie on either side.
fn portal_hides(number: u32, x: vec3<f32>, v: vec3<f32>) -> f32 {
    return 2.0 * portal_slack(x) / max(abs(dot(portals.all[number].normal, v)), LEAST_SPEED);
}

// For how long after a portal nothing is met.
fn portal_hid(path: ptr<function, Path>, v: vec3<f32>) -> f32 {
    if (*path).left == NO_PORTAL {
        return 0.0;
    }
    let number = (*path).left & 255u;
    if abs(before_portal(number, (*path).x)) > portal_slack((*path).x) {
        return 0.0;
    }
    return portal_hides(number, (*path).x, v);
}

// A vector behind a portal, by the linear part of G.
fn portal_carried(number: u32, v: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(portals.all[number].linear_x, v), dot(portals.all[number].linear_y, v), dot(portals.all[number].linear_z, v));
}

// A felt direction behind a portal, and before it.
fn portal_turned(number: u32, w: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(portals.all[number].turn_x, w), dot(portals.all[number].turn_y, w), dot(portals.all[number].turn_z, w));
}

fn portal_turned_back(number: u32, w: vec3<f32>) -> vec3<f32> {
    return w.x * portals.all[number].turn_x + w.y * portals.all[number].turn_y + w.z * portals.all[number].turn_z;
}

// x <- G x, w <- O w, and the stack is that of the new place. Neither plane is missed by rounding.
fn pass_portal(path: ptr<function, Path>, number: u32, front: bool) {
    let partner = portals.all[number].partner;
    let normal = portals.all[number].normal;
    let away = (*path).x - portals.all[number].at;
    let there = portal_carried(number, away - normal * dot(normal, away));
    let other = portals.all[partner].normal;
    (*path).x = portals.all[partner].at + there - other * dot(other, there);
    (*path).w = normalize(portal_turned(number, (*path).w));
    (*path).unbent = portal_turned(number, (*path).unbent);
    (*path).stack = portals.all[partner].stack;
    (*path).depth = portals.all[partner].depth;
    (*path).scale *= portals.all[number].scale;
    (*path).left = partner | select(0u, BEFORE_FRONT, front);
    (*path).passed += 1u;
    (*path).k = carry(path);
}
