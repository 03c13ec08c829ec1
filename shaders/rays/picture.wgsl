// The picture: light, what is seen at each pixel, and how far off. Follows frame.wgsl, shading.wgsl and lamps.wgsl, and takes from
// first_by_rays.wgsl or first_by_raster.wgsl what light of the eye meets.

// Light below this share is not looked for.
const FAINT: f32 = 0.004;
// Light of the line between the halves of a picture.
const LINE: vec3<f32> = vec3<f32>(1.2, 1.2, 1.2);

// Pictures are taken from a copy as if pixels were this much smaller: writing would blur else before it is too small to be read.
const SHARPER: f32 = 0.6;

// A surface as it looks where it is hit.
struct Surface {
    colour: vec3<f32>,
    n: vec3<f32>,           // felt, against the ray
    flat: vec3<f32>,        // normal in the scene, against the ray
    material: u32,
}

fn octahedral(packed: u32) -> vec3<f32> {
    let p = unpack2x16snorm(packed);
    var n = vec3<f32>(p, 1.0 - abs(p.x) - abs(p.y));
    let under = max(-n.z, 0.0);
    n = vec3<f32>(n.xy - signs(vec3<f32>(p, 0.0)).xy * under, n.z);
    return normalize(n);
}

// The coordinates along a surface that looks along the greatest part of n.
fn along_surface(p: vec3<f32>, n: vec3<f32>) -> vec2<f32> {
    let a = abs(n);
    if a.x > a.y && a.x > a.z {
        return p.yz;
    }
    return select(p.xy, p.xz, a.y > a.z);
}

// Colour of a material at a place of the thing's own metres, or of its texture; a pixel covers `width` metres there.
fn colour_of(number: u32, p: vec3<f32>, n: vec3<f32>, uv: vec2<f32>, width: vec3<f32>, uv_width: f32) -> vec3<f32> {
    var colour = materials[number].colour;
    let edge = materials[number].square_m;
    if edge > 0.0 {
        // Surfaces lie on the borders of squares: a little inside one is sure to be in one.
        let share = checker_share(along_surface(p - 0.01 * edge * n, n) / edge, along_surface(width, n) / edge);
        colour = mix(colour, materials[number].checker, share);
    }
    let layer = materials[number].layer;
    if layer >= 0.0 {
        let scale = materials[number].repeats;
        let texels = f32(textureDimensions(textures).x) * scale * uv_width;
        colour *= textureSampleLevel(textures, texture_sampler, uv * scale, i32(layer), log2(max(SHARPER * texels, 1.0))).rgb;
    }
    return colour;
}

// How many metres of the scene a felt cone of a pixel is wide at its end, along each axis of the scene.
fn cone_in_scene(k: mat3x3<f32>, felt: f32) -> vec3<f32> {
    let rows = transpose(k);
    return felt * vec3<f32>(length(rows[0]), length(rows[1]), length(rows[2]));
}

// The plane of a cut, where light of the eye comes to it.
struct Cap {
    is_seen: bool,
    normal: vec3<f32>,  // in the scene, against the ray
    mesh_n: vec3<f32>,
}

// What is cut is full: who looks past its cut at the inside of its far side sees the plane of the cut in its place.
fn cap_of(ended: ptr<function, Ended>, rows: mat3x4<f32>, v: vec3<f32>, from_inside: bool) -> Cap {
    var cap = Cap(false, vec3<f32>(0.0), vec3<f32>(0.0));
    if HAS_CUTS && from_inside {
        let cut = bitcast<vec4<f32>>(instance_part((*ended).found.instance, 5u));
        let plane = rows * cut.xyz + vec4<f32>(0.0, 0.0, 0.0, cut.w);
        let onward = dot(plane.xyz, v);
        if onward > 0.0 {
            let back = min(dot(plane, vec4<f32>((*ended).path.x, 1.0)) / onward, (*ended).length);
            (*ended).path.x -= back * v;
            (*ended).length -= back;
            cap = Cap(true, -normalize(plane.xyz), -cut.xyz);
        }
    }
    return cap;
}

fn object_surface(ended: ptr<function, Ended>, felt_width: f32) -> Surface {
    let found = (*ended).found;
    let instance = found.instance;
    let v = (*ended).path.k * (*ended).path.w;
    let rows = to_mesh_of(instance);
    let to_mesh = transpose(mat3x3<f32>(rows[0].xyz, rows[1].xyz, rows[2].xyz));
    let about = instance_part(instance, 3u);
    // What stays has its triangles in the scene.
    let moves = (about.w & MOVES) != 0u;
    let one = bitcast<vec3<f32>>(triangle_part(found.triangle, 1u).xyz);
    let other = bitcast<vec3<f32>>(triangle_part(found.triangle, 2u).xyz);
    let ab = select(to_mesh * one, one, moves);
    let ac = select(to_mesh * other, other, moves);
    var flat = normalize(normalize(cross(ab, ac)) * to_mesh);
    let turned = dot(flat, v) > 0.0;
    flat = select(flat, -flat, turned);
    var mesh_n = select(1.0, -1.0, turned) * cross(ab, ac);
    let cap = cap_of(ended, rows, v, turned);
    let path = (*ended).path;
    let packed = attributes[3u * found.triangle];
    let share = vec3<f32>(1.0 - found.along.x - found.along.y, found.along);
    let own = share.x * octahedral(packed.x) + share.y * octahedral(packed.y) + share.z * octahedral(packed.z);
    var smooth_n = normalize(own * to_mesh);
    smooth_n = select(smooth_n, -smooth_n, turned);
    if HAS_CUTS && cap.is_seen {
        flat = cap.normal;
        smooth_n = cap.normal;
        mesh_n = cap.mesh_n;
    }
    var n = normalize(smooth_n * path.k);
    // What is seen does not look away.
    let facing = dot(n, path.w);
    n = normalize(n - max(facing + 0.01, 0.0) * path.w);
    let first = bitcast<vec4<f32>>(attributes[3u * found.triangle + 1u]);
    let last = bitcast<vec4<f32>>(attributes[3u * found.triangle + 2u]);
    let uv = share.x * first.xy + share.y * first.zw + share.z * last.xy;
    let uv_for_metre = last.z;
    let tint = unpack4x8unorm(bitcast<u32>(last.w)).rgb;
    let at = vec4<f32>(path.x, 1.0) * rows;
    let scale = bitcast<vec3<f32>>(instance_part(instance, 4u).xyz);
    let flat_felt = abs(dot(normalize(flat * path.k), path.w));
    let width = cone_in_scene(path.k, felt_width) / max(flat_felt, 0.04);
    let in_mesh = abs_matrix(to_mesh) * width * scale;
    let material = about.z + packed.w;
    let colour = colour_of(material, at * scale, normalize(mesh_n), uv, in_mesh, uv_for_metre * greatest(in_mesh / scale));
    return Surface(colour * tint * tint, n, flat, material);
}

fn abs_matrix(m: mat3x3<f32>) -> mat3x3<f32> {
    return mat3x3<f32>(abs(m[0]), abs(m[1]), abs(m[2]));
}

// The wall of a box: its pattern is in felt metres, so that one can count how long it is.
fn wall_surface(ended: ptr<function, Ended>, felt_width: f32) -> Surface {
    let path = (*ended).path;
    let number = (*ended).wall;
    let v = path.k * path.w;
    var flat = axis_of(number, (*ended).axis);
    flat = select(flat, -flat, dot(flat, v) > 0.0);
    let local = local_place(number, path.x);
    let is_inside = stack_has(path.stack, path.depth, number);
    let s = select(vec3<f32>(1.0), space.boxes[number].stretch, is_inside);
    let n = normalize(flat * path.k);
    let local_n = flat * axes_of(number);
    let width = path.scale * felt_width / max(abs(dot(n, path.w)), 0.04);
    let material = space.boxes[number].wall_material;
    let at = (local + half_of(number)) * s;
    let colour = colour_of(material, at, local_n, along_surface(at, local_n), vec3<f32>(width), width);
    return Surface(colour, n, flat, material);
}

// A way by which light may come: from the sun, which is 0, or a lamp, and how strongly it shines there if nothing is between.
struct Beam {
    light: u32,
    through: u32,       // a portal, or NO_PORTAL
    aim: Aim,
    strength: vec3<f32>,
    share: f32,
    is_there: bool,
    next_light: u32,    // what is to be tried after it: a light, and which of the ways from there
    next_attempt: u32,
}

// The next way by which enough light may come to a surface, from this one on.
fn next_beam(at: ptr<function, Path>, surface: Surface, from_light: u32, from_attempt: u32) -> Beam {
    var beam = Beam(0u, NO_PORTAL, Aim(frame.sun, frame.reach_m, 1.0, 1.0), vec3<f32>(0.0), 0.0, false, from_light, from_attempt);
    loop {
        let attempt = beam.next_attempt;
        beam.light = beam.next_light;
        let is_sun = beam.light == 0u;
        let lamp = select(beam.light - 1u, 0u, is_sun);
        let without = select(lamp_tries(at, lamp), frame.sun_count, is_sun);
        var tries = without;
        if HAS_PORTALS && without + u32(!is_sun) > 0u {
            tries += ways.portal_count;
        }
        let is_through = HAS_PORTALS && attempt >= without;
        beam.through = select(NO_PORTAL, attempt - without, is_through);
        if is_through && is_sun {
            beam.aim = sun_through_portal(at, beam.through);
        } else if is_through {
            beam.aim = lamp_through_portal(at, lamp, beam.through);
        } else if !is_sun {
            beam.aim = lamp_aim(at, lamp, attempt);
        }
        let of_lamp = lamps.all[lamp].colour * lamp_through(max(beam.aim.length, 0.0), lamps.all[lamp].reach_m);
        beam.strength = select(of_lamp, frame.sun_colour, is_sun);
        let cosine = dot(surface.n, beam.aim.w);
        beam.share = select(lamp_diffuse(cosine), max(cosine, 0.0), is_sun);
        let is_faint = cosine <= 0.0 || greatest(beam.strength) * beam.share < FAINT * 0.1;
        beam.is_there = attempt < tries && beam.aim.length >= 0.0 && !is_faint;
        let is_last = attempt + 1u >= tries;
        beam.next_attempt = select(attempt + 1u, 0u, is_last);
        beam.next_light += u32(is_last);
        if beam.is_there || beam.next_light > frame.lamp_count {
            break;
        }
    }
    return beam;
}

// Whether nothing is in the way of a beam.
fn beam_arrives(at: ptr<function, Path>, beam: Beam, on_held: bool) -> bool {
    let is_sun = beam.light == 0u;
    let lamp = select(beam.light - 1u, 0u, is_sun);
    let radius = select(lamps.all[lamp].radius_m, 0.0, is_sun);
    var longest = beam.aim.length;
    if !is_sun {
        // The lamp is as large as it is in the scene, whatever it feels like.
        longest = max(longest - radius / beam.aim.pace, 0.0);
    }
    let ended = trace(path_toward(at, beam.aim.w, beam.aim.scale), longest, true, on_held, 0.0);
    if is_sun {
        return ended.end == END_SPENT && (!HAS_PORTALS || is_sunward(ended.path, beam.through));
    }
    // Where it met other boxes it has gone elsewhere.
    let left = lamps.all[lamp].place - ended.path.x;
    return ended.end == END_SPENT && length(left) <= radius + 0.002 * (1.0 + beam.aim.length);
}

// Light of the sun and of lamps that falls on a surface, and what of it shines. Software adapters go through the body of a loop
// for lanes that have left it, too: so that they trace no more often than the lane with the most beams, all of a beam but the
// tracing is found out in a loop of its own, within the one that traces. What the eye looks through throws no
// shadow on what is held before it.
fn direct_light(at: ptr<function, Path>, surface: Surface, to_eye: vec3<f32>, on_held: bool) -> vec3<f32> {
    var sum = vec3<f32>(0.0);
    let gloss = materials[surface.material].gloss;
    var light = 0u;
    var attempt = 0u;
    loop {
        let beam = next_beam(at, surface, light, attempt);
        if beam.is_there && beam_arrives(at, beam, on_held) {
            sum += beam.strength * (beam.share + gloss * shine(surface.n, beam.aim.w, to_eye));
        }
        light = beam.next_light;
        attempt = beam.next_attempt;
        if light > frame.lamp_count {
            break;
        }
    }
    return sum;
}

fn sky_at(w: vec3<f32>, with_sun: bool) -> vec3<f32> {
    var light = sky_light(w, frame.zenith, frame.top.rgb, frame.horizon.rgb, frame.ground.rgb);
    if with_sun && frame.sun_count > 0u {
        let toward = dot(w, frame.sun);
        light += frame.sun_colour * (4.0 * smoothstep(frame.sun_cosine - 0.0004, frame.sun_cosine + 0.0004, toward));
    }
    return light;
}

// How far a place is lifted off a surface, scene metres.
fn lift_of(x: vec3<f32>) -> f32 {
    return 2.0e-4 + 4.0e-6 * greatest(abs(x));
}

// The direction behind a pane: refracted by W. Snell's law, or mirrored where nothing gets through.
fn through_pane(w: vec3<f32>, n: vec3<f32>, ratio: f32) -> vec3<f32> {
    let cosine = -dot(w, n);
    let left = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if left < 0.0 {
        return reflect(w, n);
    }
    return normalize(ratio * w + (ratio * cosine - sqrt(left)) * n);
}

struct Seen {
    light: vec3<f32>,
    what: u32,      // 0 for nothing; 1 + the object; 0x80000000 + the aberration of a wall
    length: f32,
}

// What is seen in a direction from a place; `pixel` is where a raster has it.
fn see(start: vec3<f32>, direction: vec3<f32>, pixel: vec2<u32>) -> Seen {
    var seen = Seen(vec3<f32>(0.0), 0u, frame.reach_m);
    var left = vec3<f32>(1.0);
    var far = 0.0;
    var in_glass = false;
    var path = path_from(start, direction, frame.stack, frame.depth, true, frame.scale);
    for (var bounce = 0u; bounce <= frame.bounces; bounce++) {
        var ended = next_seen(path, frame.reach_m - far, bounce, pixel);
        path = ended.path;
        let before = far;
        far += ended.length;
        if ended.outline >= 0.0 {
            let strength = frame.outline_strength * (1.0 - fog_share(before + ended.outline, frame.fog_m));
            seen.light += left * strength * frame.outline_colour;
            left *= 1.0 - strength;
        }
        if ended.end == END_SPENT || ended.end == END_TOO_MANY {
            seen.light += left * sky_at(path.w, ended.end == END_SPENT);
            break;
        }
        var surface: Surface;
        var is_held = false;
        var what = 0x80000000u + ended.wall;
        if ended.end == END_OBJECT {
            surface = object_surface(&ended, frame.pixel_rad * far);
            let about = instance_part(ended.found.instance, 3u);
            what = 1u + about.y;
            is_held = (about.w & HELD) != 0u;
        } else {
            surface = wall_surface(&ended, frame.pixel_rad * far);
        }
        if bounce == 0u {
            seen.what = what;
            seen.length = ended.length;
        }
        let fog = fog_share(far, frame.fog_m);
        let mirror = materials[surface.material].mirror;
        let index = materials[surface.material].glass_index;
        let goes_on = bounce < frame.bounces;
        // Without bounces a mirror shows the sky and a pane is nearly opaque.
        let mirrored = select(0.6 * mirror, mirror, goes_on);
        let is_pane = index > 0.0 && goes_on;
        seen.light += left * fog * sky_at(path.w, false);
        left *= 1.0 - fog;
        if !is_pane && mirrored < 1.0 {
            var at = path;
            at.x += lift_of(path.x) * surface.flat;
            let diffuse = direct_light(&at, surface, -path.w, is_held) + ambient_light(surface.n, frame.zenith, frame.ambient_sky.rgb, frame.ambient_ground.rgb);
            seen.light += left * (1.0 - mirrored) * (surface.colour * diffuse + materials[surface.material].glow);
        }
        if is_pane {
            left *= surface.colour;
            let ratio = select(1.0 / index, index, in_glass);
            let w = through_pane(path.w, surface.n, ratio);
            let is_through = dot(w, surface.n) < 0.0;
            in_glass = in_glass != is_through;
            path.x += select(1.0, -1.0, is_through) * lift_of(path.x) * surface.flat;
            path.w = w;
        } else if mirrored > 0.0 {
            left *= mirrored * mix(vec3<f32>(1.0), surface.colour, 0.3);
            path.w = reflect(path.w, surface.n);
            path.x += lift_of(path.x) * surface.flat;
            if !goes_on {
                seen.light += left * sky_at(path.w, false);
                break;
            }
        } else {
            break;
        }
        if greatest(left) < FAINT {
            break;
        }
        path.k = carry(&path);
    }
    return seen;
}

@compute @workgroup_size(8, 8)
fn draw(@builtin(global_invocation_id) invocation: vec3<u32>) {
    let id = invocation.xy + vec2<u32>(frame.first_column, frame.first_row);
    if id.x >= frame.end_column || id.y >= min(frame.end_row, frame.height) {
        return;
    }
    var light = vec3<f32>(0.0);
    var first: Seen;
    for (var sample = 0u; sample < frame.samples; sample++) {
        // Of one sample the middle; of several a turned square's corners.
        let angle = 0.4636 + 1.5707963 * f32(sample);
        let offset = select(vec2<f32>(0.0), 0.3953 * vec2<f32>(cos(angle), sin(angle)), frame.samples > 1u);
        let place = 2.0 * (vec2<f32>(id) + 0.5 + offset) / vec2<f32>(vec2<u32>(frame.width, frame.height)) - 1.0;
        let pixel = id + vec2<u32>(0u, sample * frame.height);
        let aside = place.x * frame.right.xyz - place.y * frame.up.xyz;
        let is_parallel = frame.parallel != 0u;
        let start = select(frame.eye, frame.eye + aside, is_parallel);
        let seen = see(start, select(normalize(frame.front + aside), frame.front, is_parallel), pixel);
        light += seen.light;
        if sample == 0u {
            first = seen;
        }
    }
    light = select(light / f32(frame.samples), LINE, id.x == frame.line_column);
    textureStore(light_out, id, vec4<f32>(light, 1.0));
    textureStore(seen_out, id, vec4<u32>(first.what, bitcast<u32>(first.length), 0u, 0u));
}
