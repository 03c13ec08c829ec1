// Which triangle, wall or door is seen at each pixel, and in which view: what a raster finds out in place of rays. How it looks
// is for picture.wgsl. Mirrors crates/rays/src/raster.

// What is drawn at once: triangles of a mesh, or faces of boxes, in one view.
struct Draw {
    to_clip: mat4x4<f32>,   // from a place of the mesh about `eye`
    eye: vec3<f32>,         // in the mesh's coordinates
    depth_factor: f32,      // of a face: by how much its depth is greater
    cut: vec4<f32>,         // the plane of the view's door, in these: what is before it is not seen
    own_cut: vec4<f32>,     // that of the mesh, if it is cut, or nought
    what: u32,              // of a face: what it is
    instance: u32,          // added to the instance of what stays
    view: u32,
    door: u32,              // what must be seen in the level before, where there is one
}

struct Corner {
    @builtin(position) place: vec4<f32>,
    @location(0) @interpolate(flat) seen: vec2<u32>,
    @location(1) @interpolate(flat) door: u32,
    @location(2) beyond: vec2<f32>, // how far it is behind the cuts
}

// Texels of a row of the list: 2 to the power of this, as in scene.wgsl.
const ROW_BITS: u32 = 11u;

@group(0) @binding(0) var triangles: texture_2d<u32>;
@group(0) @binding(1) var<storage, read> draws: array<Draw>;
// The level before.
@group(0) @binding(2) var before: texture_2d<u32>;

fn part_of(triangle: u32, part: u32) -> vec4<u32> {
    let number = 3u * triangle + part;
    return textureLoad(triangles, vec2<u32>(number & ((1u << ROW_BITS) - 1u), number >> ROW_BITS), 0);
}

fn corner_at(at: u32, place: vec3<f32>, what: u32, instance: u32) -> Corner {
    let whole = vec4<f32>(place, 1.0);
    let beyond = vec2<f32>(dot(draws[at].cut, whole), dot(draws[at].own_cut, whole));
    let clip = draws[at].to_clip * vec4<f32>(place - draws[at].eye, 1.0);
    return Corner(clip, vec2<u32>(what, (instance << 8u) | draws[at].view), draws[at].door, beyond);
}

@vertex
fn triangle(@builtin(vertex_index) vertex: u32, @builtin(instance_index) at: u32) -> Corner {
    let number = vertex / 3u;
    let which = vertex % 3u;
    let third = part_of(number, 2u);
    var edge = vec3<f32>(0.0);
    if which == 1u {
        edge = bitcast<vec3<f32>>(part_of(number, 1u).xyz);
    } else if which == 2u {
        edge = bitcast<vec3<f32>>(third.xyz);
    }
    let place = bitcast<vec3<f32>>(part_of(number, 0u).xyz) + edge;
    return corner_at(at, place, 1u + number, draws[at].instance + third.w);
}

// A face is a square from -1 to 1 in its own coordinates, or its first half.
@vertex
fn face(@builtin(vertex_index) vertex: u32, @builtin(instance_index) at: u32) -> Corner {
    let right = vertex == 1u || vertex == 2u || vertex == 4u;
    let top = vertex == 2u || vertex >= 4u;
    let place = vec3<f32>(select(-1.0, 1.0, right), select(-1.0, 1.0, top), 0.0);
    var corner = corner_at(at, place, draws[at].what, 0u);
    corner.place.z *= draws[at].depth_factor;
    return corner;
}

@fragment
fn first(corner: Corner) -> @location(0) vec2<u32> {
    return corner.seen;
}

// Of what is cut.
@fragment
fn first_cut(corner: Corner) -> @location(0) vec2<u32> {
    if corner.beyond.y < 0.0 {
        discard;
    }
    return corner.seen;
}

// Behind a door: only where that is seen, and only what is behind its plane.
@fragment
fn deeper(corner: Corner) -> @location(0) vec2<u32> {
    let seen = textureLoad(before, vec2<u32>(corner.place.xy), 0).x;
    if seen != corner.door || any(corner.beyond < vec2<f32>(0.0)) {
        discard;
    }
    return corner.seen;
}
