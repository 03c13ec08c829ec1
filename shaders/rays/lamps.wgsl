// In which directions a lamp is seen. Mirrors crates/deformation/src/lamp.rs. Follows trace.wgsl and the frame.

// A direction in which light may come.
struct Aim {
    w: vec3<f32>,
    length: f32,    // felt metres, or -1 where it does not
}

// A row of up to three media behind each other, in the axes of the box whose faces part them.
struct Row {
    number: u32,
    media: array<vec3<f32>, 3>,
    count: u32,
    faces: vec2<f32>,
}

fn has_one_more(stack: vec4<u32>, depth: u32, than: vec4<u32>, than_depth: u32) -> u32 {
    if depth != than_depth + 1u {
        return NOTHING;
    }
    var only = NOTHING;
    for (var at = 0u; at < depth; at++) {
        let number = stack_get(stack, at);
        if !stack_has(than, than_depth, number) {
            if only != NOTHING {
                return NOTHING;
            }
            only = number;
        }
    }
    return only;
}

fn stretch_for(number: u32, way: vec3<f32>) -> vec3<f32> {
    return select(vec3<f32>(1.0), space.boxes[number].stretch, is_felt(number, way));
}

fn axes_of(number: u32) -> mat3x3<f32> {
    return mat3x3<f32>(space.boxes[number].x_axis, space.boxes[number].y_axis, space.boxes[number].z_axis);
}

fn weight(part: f32, medium: vec3<f32>, i: u32) -> vec3<f32> {
    return part * medium[i] / medium;
}

// The way through the faces across axis i from p to l, both in the box's coordinates; `ambient` is K outside of the box.
fn through_faces(row: ptr<function, Row>, i: u32, p: vec3<f32>, l: vec3<f32>, ambient: mat3x3<f32>) -> Aim {
    let none = Aim(vec3<f32>(0.0), -1.0);
    let number = (*row).number;
    let away = l - p;
    let h = half_of(number);
    let sign = select(-1.0, 1.0, away[i] >= 0.0);
    var cuts = vec4<f32>(p[i], l[i], l[i], l[i]);
    cuts.y = (*row).faces.x * sign * h[i];
    if (*row).count == 3u {
        cuts.z = (*row).faces.y * sign * h[i];
    }
    let parts = cuts.yzw - cuts.xyz;
    if away[i] == 0.0 || any(parts * sign < vec3<f32>(0.0)) {
        return none;
    }
    let first = weight(parts.x, (*row).media[0], i);
    let second = weight(parts.y, (*row).media[1], i);
    let third = weight(parts.z, (*row).media[2], i);
    let u = away / (first + second + third);
    var room = abs(p + u * first) - h;
    room[i] = -1.0;
    if (*row).count == 3u {
        var other = abs(p + u * (first + second)) - h;
        other[i] = -1.0;
        room = max(room, other);
    }
    if greatest(room) > 0.0 {
        return none;
    }
    let time = parts.x * (*row).media[0][i] + parts.y * (*row).media[1][i] + parts.z * (*row).media[2][i];
    let felt = inverse_of(ambient) * (axes_of(number) * (u * time));
    let length = length(felt);
    return Aim(felt / max(length, 1.0e-20), length);
}

// How many ways to a lamp there may be from a place.
fn lamp_tries(from_path: ptr<function, Path>, lamp: u32) -> u32 {
    let stack = (*from_path).stack;
    let depth = (*from_path).depth;
    let lamp_stack = frame.lamps[lamp].stack;
    let lamp_depth = frame.lamps[lamp].depth;
    if depth == lamp_depth && all(stack == lamp_stack) {
        var count = ways.outermost_count;
        if depth > 0u {
            count = space.boxes[stack_get(stack, depth - 1u)].count;
        }
        return 1u + 3u * count;
    }
    return select(0u, 3u, depth + 1u == lamp_depth || lamp_depth + 1u == depth);
}

// The way of a number below that.
fn lamp_aim(from_path: ptr<function, Path>, lamp: u32, attempt: u32) -> Aim {
    let none = Aim(vec3<f32>(0.0), -1.0);
    let stack = (*from_path).stack;
    let depth = (*from_path).depth;
    let lamp_stack = frame.lamps[lamp].stack;
    let lamp_depth = frame.lamps[lamp].depth;
    let place = frame.lamps[lamp].place.xyz;
    let away = place - (*from_path).x;
    var row: Row;
    var axis = attempt % 3u;
    var ambient: mat3x3<f32>;
    let one = vec3<f32>(1.0);
    if depth == lamp_depth {
        ambient = squeeze_of(stack, depth, away, false);
        if attempt == 0u {
            let felt = inverse_of(ambient) * away;
            let length = length(felt);
            return Aim(felt / max(length, 1.0e-20), length);
        }
        axis = (attempt - 1u) % 3u;
        var first = ways.outermost;
        if depth > 0u {
            first = space.boxes[stack_get(stack, depth - 1u)].first;
        }
        let number = neighbours[first + (attempt - 1u) / 3u];
        if stack_has(stack, depth, number) {
            return none;
        }
        row = Row(number, array<vec3<f32>, 3>(one, stretch_for(number, away), one), 3u, vec2<f32>(-1.0, 1.0));
    } else if depth < lamp_depth {
        let number = has_one_more(lamp_stack, lamp_depth, stack, depth);
        if number == NOTHING {
            return none;
        }
        let s = stretch_for(number, away);
        ambient = squeeze_of(stack, depth, away, false);
        row = Row(number, array<vec3<f32>, 3>(one, s, s), 2u, vec2<f32>(-1.0, 1.0));
    } else {
        let number = has_one_more(stack, depth, lamp_stack, lamp_depth);
        if number == NOTHING {
            return none;
        }
        ambient = squeeze_of(lamp_stack, lamp_depth, away, false);
        row = Row(number, array<vec3<f32>, 3>(stretch_for(number, away), one, one), 2u, vec2<f32>(1.0, -1.0));
    }
    if space.boxes[row.number].sides == SIDES_LEGACY || (space.boxes[row.number].walls & (1u << axis)) != 0u {
        return none;
    }
    let p = local_vector(row.number, (*from_path).x - space.boxes[row.number].centre);
    let l = local_vector(row.number, place - space.boxes[row.number].centre);
    return through_faces(&row, axis, p, l, ambient);
}
