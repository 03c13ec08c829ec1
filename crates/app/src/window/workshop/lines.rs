//! Lines over the view: the handles, the edges of what is chosen, and what a felt length is pulled to.

use antipode_language::{Texts, Value};
use antipode_room_scene::RoomScene;
use antipode_room_scene::tuning::EYE_M;
use antipode_room_scene::workshop::{Handle, Handles, Through, Viewpoint};
use antipode_rooms::aberration::{Lengths, Sides};
use antipode_rooms::{What, direction};
use antipode_ui::workshop::ViewLine;
use egui::Color32;
use glam::{DAffine3, DVec2, DVec3};

use super::kits::bounds_of_group;
use super::{GRIP_POINTS, Workshop, chosen};

/// Colours of the axes: x, y and z.
const AXES: [Color32; 3] = [
    Color32::from_rgb(0xF0, 0x6A, 0x5E),
    Color32::from_rgb(0x7F, 0xD1, 0x6B),
    Color32::from_rgb(0x6E, 0xA8, 0xF7),
];
/// Of what is chosen.
const CHOSEN: Color32 = Color32::from_rgb(0xF2, 0x99, 0x4A);
/// Of what is under the pointer.
const HOT: Color32 = Color32::from_rgb(0xFF, 0xF0, 0xC8);
/// Of what no picture shows.
const MARK: Color32 = Color32::from_rgba_premultiplied(0x6E, 0x5C, 0x8C, 0x8C);
/// Most of these that are drawn, and how large lamps are, metres.
const MOST_MARKS: usize = 72;
const LAMP_M: f64 = 0.15;
/// Most things whose edges are drawn.
const MOST: usize = 12;
/// Pieces of an edge that is seen through faces or portals.
const PIECES: usize = 8;

/// All of them.
pub fn lines(workshop: &Workshop, scene: &RoomScene, texts: &Texts) -> Vec<ViewLine> {
    let mut all = Vec::new();
    marks(workshop, scene, texts, &mut all);
    if scene.leaves_out_walls() {
        left_out(workshop, scene, &mut all);
    }
    for index in chosen::first(scene, MOST) {
        edges(workshop, scene, (index, &scene.poses()[index]), &mut all);
    }
    if let Some([a, b]) = workshop.frame
        && a != b
    {
        let corners = [a, DVec2::new(b.x, a.y), b, DVec2::new(a.x, b.y), a];
        all.push(ViewLine {
            points: corners.iter().map(flat).collect(),
            colour: CHOSEN,
            width: 2.0,
            label: None,
            knob: false,
        });
    }
    if let Some((_, handles)) = workshop.handles(scene) {
        add_handles(workshop, scene, &handles, texts, &mut all);
    }
    workshop.link_lines(scene, texts, &mut all);
    all
}

/// Where portals are, which have no frame of their own, lamps, and where one begins: what no picture shows. What the pointer is on
/// is named.
fn marks(workshop: &Workshop, scene: &RoomScene, texts: &Texts, all: &mut Vec<ViewLine>) {
    let room = scene.room();
    let view = workshop.viewpoint(scene);
    let marked = scene.document().marked();
    let is_unseen = |what: &What| matches!(what, What::Portal(_) | What::Light { .. });
    let objects = room.objects.iter().enumerate();
    let unseen: Vec<_> = objects
        .filter(|(_, it)| is_unseen(&it.what) && !marked.is_hidden(it))
        .collect();
    for (index, object) in unseen.into_iter().take(MOST_MARKS) {
        let pose = scene.poses()[index];
        let half = chosen::half(&object.what);
        let (y, z) = (half.y, half.z);
        let corners = match object.what {
            What::Portal(_) => vec![(-y, -z), (y, -z), (y, z), (-y, z), (-y, -z)],
            _ => vec![
                (0.0, -LAMP_M),
                (0.0, LAMP_M),
                (0.0, 0.0),
                (LAMP_M, 0.0),
                (-LAMP_M, 0.0),
            ],
        };
        let points = corners
            .into_iter()
            .map(|(y, z)| pose.transform_point3(DVec3::new(0.0, y, z)));
        let lines = mark(scene, &view, pose.translation, points);
        all.extend(lines.map(|it| named(workshop, &view, it, &object.name)));
    }
    let feet = room.spawn.at;
    let ahead = direction(DVec2::new(room.spawn.look.x, 0.0)) * 0.5;
    let points = [feet + DVec3::Y * EYE_M, feet, feet + ahead];
    let start = mark(scene, &view, feet + DVec3::Y, points.into_iter());
    let name = texts.say("workshop-field-spawn-at");
    all.extend(start.map(|it| named(workshop, &view, it, &name)));
}

/// A mark with its name, if the pointer is on it.
fn named(workshop: &Workshop, view: &Viewpoint, mut mark: ViewLine, name: &str) -> ViewLine {
    let near = workshop.half_heights(GRIP_POINTS);
    let corners: Vec<_> = mark
        .points
        .iter()
        .map(|[x, y]| DVec2::new(f64::from(*x), f64::from(*y)))
        .collect();
    let is_near = |at: &DVec2| view.distance_to_line(*at, &corners) < near;
    if workshop.dragging.is_none() && workshop.pointer.as_ref().is_some_and(is_near) {
        mark.label = Some(name.to_owned());
    }
    mark
}

/// The edges of aberrations whose walls are left out.
fn left_out(workshop: &Workshop, scene: &RoomScene, all: &mut Vec<ViewLine>) {
    let room = scene.room();
    let walled = room
        .aberrations()
        .filter(|(_, it)| it.sides == Sides::Walls);
    let poses = scene.poses();
    for (index, _) in walled.take(MOST) {
        let from = all.len();
        edges(workshop, scene, (index, &poses[index]), all);
        all[from..].iter_mut().for_each(|it| it.colour = MARK);
    }
}

fn mark(
    scene: &RoomScene,
    view: &Viewpoint,
    middle: DVec3,
    points: impl Iterator<Item = DVec3>,
) -> Option<ViewLine> {
    let (through, at) = scene.way_to(view, middle, &[])?;
    let seen: Vec<_> = points
        .filter_map(|point| through.seen_at(point, at))
        .map(|at| flat(&at))
        .collect();
    (seen.len() > 1).then_some(ViewLine {
        points: seen,
        colour: MARK,
        width: 1.0,
        label: None,
        knob: false,
    })
}

fn flat(at: &DVec2) -> [f32; 2] {
    at.as_vec2().to_array()
}

fn add_handles(
    workshop: &Workshop,
    scene: &RoomScene,
    handles: &Handles,
    texts: &Texts,
    all: &mut Vec<ViewLine>,
) {
    let (active, from) = (workshop.active_handle(), all.len());
    for line in &handles.lines {
        let axis = match line.handle {
            Handle::Along(axis)
            | Handle::Across(axis)
            | Handle::About(axis)
            | Handle::Size(axis)
            | Handle::Felt(axis) => axis,
            Handle::Body => 1,
        };
        let is_felt = matches!(line.handle, Handle::Felt(_));
        let is_hot = active == Some(line.handle);
        let colour = match (is_hot, is_felt) {
            (true, _) => HOT,
            (false, true) => CHOSEN,
            (false, false) => AXES[axis],
        };
        let knob = matches!(
            line.handle,
            Handle::Along(_) | Handle::Size(_) | Handle::Felt(_)
        );
        all.push(ViewLine {
            points: line.points.iter().map(flat).collect(),
            colour,
            width: if is_hot { 4.0 } else { 2.5 },
            label: match line.handle {
                Handle::Felt(_) => lengths(scene, texts),
                Handle::Size(axis) if is_hot => length(scene, texts, axis),
                _ => None,
            },
            knob,
        });
    }
    // Once is enough.
    let mut told = false;
    for line in &mut all[from..] {
        if line.label.is_some() && std::mem::replace(&mut told, true) {
            line.label = None;
        }
    }
}

/// How long what is chosen is along an axis, in words.
fn length(scene: &RoomScene, texts: &Texts, axis: usize) -> Option<String> {
    let length = chosen::length_m(scene, axis)?;
    let values = [("value", Value::decimals(length, 2))];
    Some(texts.say_with("workshop-unit-metres", &values))
}

/// How long the chosen aberration is outside and inside, in words.
fn lengths(scene: &RoomScene, texts: &Texts) -> Option<String> {
    let index = chosen::last(scene)?;
    let What::Aberration(it) = &scene.room().objects[index].what else {
        return None;
    };
    let Lengths::Felt { axis, felt_m } = it.lengths else {
        return None;
    };
    let outside = 2.0 * it.half[axis.index()];
    let metres = |length: f64| Value::decimals(length, usize::from(length < 10.0));
    let values = [("outside", metres(outside)), ("inside", metres(felt_m))];
    Some(texts.say_with("workshop-outside-inside", &values))
}

/// The edges of the box about a thing, as they are seen.
fn edges(
    workshop: &Workshop,
    scene: &RoomScene,
    (index, pose): (usize, &DAffine3),
    all: &mut Vec<ViewLine>,
) {
    let object = &scene.room().objects[index];
    let (middle, half) = match object.what {
        What::Group => match bounds_of_group(scene.room(), scene.poses(), &object.name) {
            Some((low, high)) => ((low + high) / 2.0, (high - low) / 2.0),
            None => return,
        },
        _ => (DVec3::ZERO, chosen::half(&object.what)),
    };
    // A box that space is stretched in is seen from outside, and so are its edges.
    let Some((through, at)) = workshop.through(
        scene,
        pose.translation,
        &chosen::own_spaces(scene.room(), index),
    ) else {
        return;
    };
    for axis in 0..3 {
        let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
        for (side_b, side_c) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let point = |share: f64| {
                let mut local = DVec3::ZERO;
                local[axis] = half[axis] * share;
                local[b] = half[b] * side_b;
                local[c] = half[c] * side_c;
                pose.transform_point3(middle + local)
            };
            edge(&through, at, point, all);
        }
    }
}

fn edge(through: &Through<'_>, from: DVec2, point: impl Fn(f64) -> DVec3, all: &mut Vec<ViewLine>) {
    let seen = |pieces: usize| {
        let mut at = from;
        let mut points = Vec::with_capacity(pieces + 1);
        for piece in 0..=pieces {
            let share = 2.0 * piece as f64 / pieces as f64 - 1.0;
            if let Some(seen) = through.seen_at(point(share), at) {
                at = seen;
                points.push(flat(&seen));
            }
        }
        points
    };
    // What no face turns is seen straight; of what has an end behind the eye a part is seen.
    let straight = through.chain.is_empty().then(|| seen(1));
    let whole = straight.filter(|it| it.len() == 2);
    let points = whole.unwrap_or_else(|| seen(PIECES));
    if points.len() > 1 {
        all.push(ViewLine {
            points,
            colour: CHOSEN,
            width: 1.5,
            label: None,
            knob: false,
        });
    }
}
