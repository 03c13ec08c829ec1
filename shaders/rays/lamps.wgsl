// In which directions a lamp is seen. Mirrors crates/deformation/src/lamp.rs. Follows trace.wgsl and the frame.

// A direction in which light may come.
struct Aim {
    w: vec3<f32>,
    length: f32,    // felt metres of the lamp's size, or -1 where it does not
    scale: f32,     // how large, to those, the metres here are
    pace: f32,      // metres of the scene for a felt one, at the lamp
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
    var others = 0u;
    var at = 0u;
    loop {
        let number = stack_get(stack, at);
        if !stack_has(than, than_depth, number) {
            only = number;
            others += 1u;
        }
        at += 1u;
        if !HAS_NESTS || at >= depth {
            break;
        }
    }
    return select(NOTHING, only, others == 1u);
}

fn weight(part: f32, medium: vec3<f32>, i: u32) -> vec3<f32> {
    return part * medium[i] / medium;
}

// The way through the faces across axis i from p to l, both in the box's coordinates; `to_felt` is the inverse of K at p.
fn through_faces(row: Row, i: u32, p: vec3<f32>, l: vec3<f32>, to_felt: mat3x3<f32>) -> Aim {
    let none = Aim(vec3<f32>(0.0), -1.0, 1.0, 1.0);
    let number = row.number;
    let away = l - p;
    let h = half_of(number);
    let sign = select(-1.0, 1.0, away[i] >= 0.0);
    var cuts = vec4<f32>(p[i], l[i], l[i], l[i]);
    cuts.y = row.faces.x * sign * h[i];
    if row.count == 3u {
        cuts.z = row.faces.y * sign * h[i];
    }
    let parts = cuts.yzw - cuts.xyz;
    if away[i] == 0.0 || any(parts * sign < vec3<f32>(0.0)) {
        return none;
    }
    let first = weight(parts.x, row.media[0], i);
    let second = weight(parts.y, row.media[1], i);
    let third = weight(parts.z, row.media[2], i);
    let u = away / (first + second + third);
    var room = abs(p + u * first) - h;
    room[i] = -1.0;
    if row.count == 3u {
        var other = abs(p + u * (first + second)) - h;
        other[i] = -1.0;
        room = max(room, other);
    }
    if greatest(room) > 0.0 {
        return none;
    }
    let time = parts.x * row.media[0][i] + parts.y * row.media[1][i] + parts.z * row.media[2][i];
    let felt = to_felt * (axes_of(number) * (u * time / row.media[0]));
    let felt_m = max(length(felt), 1.0e-20);
    return Aim(felt / felt_m, felt_m, 1.0, length(u / row.media[row.count - 1u]) * time / felt_m);
}

// The way to a lamp through a portal. Behind it the lamp shows where the inverse of G, which is that of its partner, takes it.
fn lamp_through_portal(from_path: ptr<function, Path>, lamp: u32, number: u32) -> Aim {
    let none = Aim(vec3<f32>(0.0), -1.0, 1.0, 1.0);
    let partner = portals.all[number].partner;
    let x = (*from_path).x;
    let is_here = (*from_path).depth == portals.all[number].depth && all((*from_path).stack == portals.all[number].stack);
    let is_there = lamps.all[lamp].depth == portals.all[partner].depth && all(lamps.all[lamp].stack == portals.all[partner].stack);
    let image = portals.all[number].at + portal_carried(partner, lamps.all[lamp].place - portals.all[partner].at);
    let here = before_portal(number, x);
    let there = before_portal(number, image);
    let is_open = here > 0.0 || portals.all[number].sides == 2u;
    if !is_here || !is_there || !is_open || here * there >= 0.0 || !is_in_portal(number, mix(x, image, here / (here - there))) {
        return none;
    }
    let away = image - x;
    let felt = inverse_of(squeeze_toward(from_path, away)) * away;
    let felt_m = max(length(felt), 1.0e-20);
    let scale = portals.all[number].scale;
    return Aim(felt / felt_m, felt_m * scale, 1.0 / scale, length(portal_carried(number, away)) / (felt_m * scale));
}

// The direction of the sun as it shows in a portal, where that may be seen from a place.
fn sun_through_portal(from_path: ptr<function, Path>, number: u32) -> Aim {
    let none = Aim(vec3<f32>(0.0), -1.0, 1.0, 1.0);
    if portals.all[number].is_turned == 0u {
        return none;
    }
    let w = portal_turned_back(number, frame.sun);
    let is_here = (*from_path).depth == portals.all[number].depth && all((*from_path).stack == portals.all[number].stack);
    if is_here && portal_opening(number, from_path, squeeze_toward(from_path, w) * w).time < 0.0 {
        return none;
    }
    return Aim(w, frame.reach_m, 1.0, 1.0);
}

// Whether a path to the sun has come to it: straight, or through a portal by itself where one is named.
fn is_sunward(path: Path, number: u32) -> bool {
    if number == NO_PORTAL {
        return dot(path.w, frame.sun) > 0.99999;
    }
    return path.passed == 1u && (path.left & 255u) == portals.all[number].partner;
}

// How many ways to a lamp there may be from a place, without portals.
fn lamp_tries(from_path: ptr<function, Path>, lamp: u32) -> u32 {
    if IS_FLAT {
        return 1u;
    }
    let stack = (*from_path).stack;
    let depth = (*from_path).depth;
    let lamp_stack = lamps.all[lamp].stack;
    let lamp_depth = lamps.all[lamp].depth;
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
    let none = Aim(vec3<f32>(0.0), -1.0, 1.0, 1.0);
    let own = (*from_path).stack;
    let own_depth = (*from_path).depth;
    let lamp_stack = lamps.all[lamp].stack;
    let lamp_depth = lamps.all[lamp].depth;
    let place = lamps.all[lamp].place;
    let away = place - (*from_path).x;
    let is_same = own_depth == lamp_depth;
    // What both are in, and what only one of them is.
    let is_lamp_inner = own_depth < lamp_depth;
    let outer = select(lamp_stack, own, is_lamp_inner || is_same);
    let outer_depth = min(own_depth, lamp_depth);
    let to_felt = inverse_of(squeeze_toward(from_path, away));
    if IS_FLAT || (is_same && attempt == 0u) {
        let straight = to_felt * away;
        let felt_m = max(length(straight), 1.0e-20);
        return Aim(straight / felt_m, felt_m, 1.0, length(away) / felt_m);
    }
    var number = 0u;
    var axis = attempt % 3u;
    if is_same {
        axis = (attempt - 1u) % 3u;
        var first = ways.outermost;
        if own_depth > 0u {
            first = space.boxes[stack_get(own, own_depth - 1u)].first;
        }
        number = neighbours[first + (attempt - 1u) / 3u];
        if stack_has(own, own_depth, number) {
            return none;
        }
    } else {
        number = has_one_more(select(own, lamp_stack, is_lamp_inner), max(own_depth, lamp_depth), outer, outer_depth);
        if number == NOTHING {
            return none;
        }
    }
    if space.boxes[number].sides == SIDES_LEGACY || (space.boxes[number].walls & (1u << axis)) != 0u {
        return none;
    }
    let one = vec3<f32>(1.0);
    let s = select(one, space.boxes[number].stretch, is_felt(number, away));
    let leaves = !is_same && !is_lamp_inner;
    let row = Row(number, array<vec3<f32>, 3>(select(one, s, leaves), select(s, one, leaves), select(one, s, is_lamp_inner)), select(2u, 3u, is_same), select(vec2<f32>(-1.0, 1.0), vec2<f32>(1.0, -1.0), leaves));
    let p = local_place(number, (*from_path).x);
    let l = local_place(number, place);
    return through_faces(row, axis, p, l, to_felt);
}
