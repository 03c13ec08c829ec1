// What a picture needs to know: the eye, the light, and how surfaces look. Follows trace.wgsl.

struct Lamp {
    place: vec3<f32>,
    radius_m: f32,          // of the scene
    colour: vec3<f32>,
    reach_m: f32,           // felt
    stack: vec4<u32>,
    depth: u32,
    padding_x: u32,
    padding_y: u32,
    padding_z: u32,
}

struct Frame {
    eye: vec3<f32>,
    pixel_rad: f32,
    right: vec4<f32>,       // felt directions, times half of the picture
    up: vec4<f32>,
    front: vec3<f32>,
    reach_m: f32,           // how far one sees, felt
    zenith: vec3<f32>,
    fog_m: f32,             // felt distance at which fog is complete
    sun: vec3<f32>,
    sun_cosine: f32,        // of the angle of its radius
    sun_colour: vec3<f32>,
    sun_count: u32,         // 0 or 1
    top: vec4<f32>,
    horizon: vec4<f32>,
    ground: vec4<f32>,
    ambient_sky: vec4<f32>,
    ambient_ground: vec4<f32>,
    outline_colour: vec3<f32>,  // of the outlines of boxes
    outline_strength: f32,
    stack: vec4<u32>,       // the eye's, depth deep
    width: u32,             // pixels
    height: u32,
    bounces: u32,           // mirrors and panes in a row
    samples: u32,           // for a pixel
    depth: u32,
    lamp_count: u32,
    first_column: u32,      // the part that is drawn ends before end_column and end_row
    end_column: u32,
    line_column: u32,       // shown as a line
    first_row: u32,
    end_row: u32,
    scale: f32,             // how many times larger than at first the eye is
    parallel: u32,          // 1: all is seen along parallel lines, and right and up are metres of the scene
    padding_x: u32,
    padding_y: u32,
    padding_z: u32,
}

struct Lamps {
    all: array<Lamp, 8>,
}

struct Material {
    colour: vec3<f32>,
    layer: f32,             // of its texture, or -1
    checker: vec3<f32>,     // colour of the other squares
    square_m: f32,          // edge of a square, or 0
    glow: vec3<f32>,
    mirror: f32,            // share of light that it mirrors
    glass_index: f32,       // refractive index, or 0
    gloss: f32,
    repeats: f32,           // of the texture for one of uv
    padding: f32,
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
// Lanes may be at different lamps: software adapters read a uniform many lanes at a time.
@group(1) @binding(7) var<uniform> lamps: Lamps;
