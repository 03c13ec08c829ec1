// What a picture needs to know: the eye, the light, and how surfaces look. Follows trace.wgsl.

struct Lamp {
    place: vec4<f32>,       // w: its radius, scene metres
    colour: vec4<f32>,      // rgb; w: reach, felt metres
    stack: vec4<u32>,
    depth: u32,
    room_x: u32,
    room_y: u32,
    room_z: u32,
}

struct Frame {
    eye: vec4<f32>,         // w: the angle of a pixel, rad
    right: vec4<f32>,       // felt directions, times half of the picture; w of front: how far one sees, felt metres
    up: vec4<f32>,
    front: vec4<f32>,
    zenith: vec4<f32>,      // w: felt distance at which fog is complete
    sun: vec4<f32>,         // w: cosine of the angle of its radius
    sun_colour: vec4<f32>,  // w: 1 where it throws light
    top: vec4<f32>,
    horizon: vec4<f32>,
    ground: vec4<f32>,
    ambient_sky: vec4<f32>,
    ambient_ground: vec4<f32>,
    outline: vec4<f32>,     // colour of the outlines of boxes
    stack: vec4<u32>,
    size: vec4<u32>,        // pixels; mirrors and panes in a row; samples a pixel
    counts: vec4<u32>,      // depth of the eye's stack; lamps; columns from and to which are drawn
    marks: vec4<u32>,       // column that is a line; rows from and to which are drawn
    lamps: array<Lamp, 8>,
}

struct Material {
    colour: vec4<f32>,      // w: layer of its texture, or -1
    checker: vec4<f32>,     // w: edge of the checker's squares in metres, or 0
    glow: vec4<f32>,        // w: share of light that it mirrors
    optics: vec4<f32>,      // refractive index of glass, or 0; gloss; repeats of the texture for one of uv
}

// No uniform: software adapters compile a shader anew for what it branches by in uniforms, whenever that changes.
@group(1) @binding(0) var<storage, read> frame: Frame;
@group(1) @binding(1) var<storage, read> materials: array<Material>;
// Three for each triangle: its normals and material; the corners' uv, how long one metre is in it, and its colour.
@group(1) @binding(2) var<storage, read> attributes: array<vec4<u32>>;
@group(1) @binding(3) var textures: texture_2d_array<f32>;
@group(1) @binding(4) var texture_sampler: sampler;
@group(1) @binding(5) var light_out: texture_storage_2d<rgba16float, write>;
@group(1) @binding(6) var seen_out: texture_storage_2d<rg32uint, write>;
