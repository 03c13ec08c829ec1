//! What is chosen: where it is, how large, and by which axes it is held.

use std::sync::Arc;

use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::Held;
use antipode_rooms::aberration::Lengths;
use antipode_rooms::portal::Opening;
use antipode_rooms::room::Names;
use antipode_rooms::{Object, Room, What, poses};
use antipode_workshop::Clip;
use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::changes;
use super::kits::{Stands, bounds_of_group};

/// So many names are looked for one by one.
const FEW: usize = 8;
/// What is wider has its copy near it, though they overlap, metres.
const WIDEST_M: f64 = 20.0;
/// Half sizes of what has none of its own, metres.
const POINT_M: f64 = 0.3;

/// Where handles of what is chosen begin, which is at what was chosen last, and their axes: its own, or the room's.
pub fn held(scene: &RoomScene, own_axes: bool) -> Option<Held> {
    let room = scene.room();
    let poses = scene.poses();
    let last = last(scene)?;
    let is_alone = scene.document().selection().len() == 1;
    let object = &room.objects[last];
    let axes = if own_axes {
        rotation_of(&poses[last])
    } else {
        DMat3::IDENTITY
    };
    let is_own = axes.abs_diff_eq(rotation_of(&poses[last]), 1e-9);
    let felt = match &object.what {
        What::Aberration(it) if is_alone && is_own => match it.lengths {
            Lengths::Felt { axis, .. } => Some(axis.index()),
            Lengths::Stretch(_) => None,
        },
        _ => None,
    };
    Some(Held {
        origin: poses[last].translation,
        axes,
        half: half_of(scene, object),
        stays_m: changes::stays(&object.what).unwrap_or_default(),
        felt,
    })
}

/// The place of what was chosen last among all objects.
pub fn last(scene: &RoomScene) -> Option<usize> {
    let names = scene.document().selection().iter().rev();
    let mut found = names.filter_map(|it| scene.room().find(it));
    found.next().map(|(index, _)| index)
}

/// The places of what is chosen among all objects, in the order in which it was chosen.
pub fn indices(scene: &RoomScene) -> Vec<usize> {
    let (room, names) = (scene.room(), scene.document().selection());
    if names.len() <= FEW {
        return first(scene, FEW);
    }
    let places = room.places();
    let found = names
        .iter()
        .filter_map(|name| places.get(name.as_str()).copied());
    found.collect()
}

/// The same of those that were chosen first, at most so many. They are looked for one by one.
pub fn first(scene: &RoomScene, most: usize) -> Vec<usize> {
    let names = scene.document().selection().iter();
    let found = names.filter_map(|name| scene.room().find(name));
    found.map(|(index, _)| index).take(most).collect()
}

/// The spaces of a thing, by their places among all objects: those that a group carries, or the thing itself. It is held from outside
/// of them.
pub fn own_spaces(room: &Room, index: usize) -> Vec<usize> {
    if room.objects[index].what != What::Group {
        return vec![index];
    }
    let name = &room.objects[index].name;
    let spaces = room.aberrations().map(|(space, _)| space);
    let carried = spaces
        .filter(|space| roots(room, &[name.clone(), room.objects[*space].name.clone()]).len() == 1);
    carried.collect()
}

/// What is chosen and not carried by something else that is.
pub fn roots(room: &Room, chosen: &[String]) -> Vec<usize> {
    let places = room.places();
    let names: Names<'_> = chosen.iter().map(String::as_str).collect();
    let is_carried = |object: &Object| {
        let mut group = object.group.as_deref();
        for _ in 0..antipode_rooms::bounds::MOST_DEEP {
            let Some(name) = group else { return false };
            if names.contains(name) {
                return true;
            }
            let outer = places.get(name);
            group = outer.and_then(|it| room.objects[*it].group.as_deref());
        }
        false
    };
    let all = chosen.iter().filter_map(|it| places.get(it.as_str()));
    all.copied()
        .filter(|it| !is_carried(&room.objects[*it]))
        .collect()
}

/// The axes of a pose, of length 1.
pub fn rotation_of(pose: &DAffine3) -> DMat3 {
    let m = pose.matrix3;
    DMat3::from_cols(
        m.x_axis.normalize_or(DVec3::X),
        m.y_axis.normalize_or(DVec3::Y),
        m.z_axis.normalize_or(DVec3::Z),
    )
}

/// Whether what was chosen last is a group.
pub fn is_group(scene: &RoomScene) -> bool {
    last(scene).is_some_and(|index| scene.room().objects[index].what == What::Group)
}

/// How long what was chosen last is along one of its axes, or all that it carries, metres.
pub fn length_m(scene: &RoomScene, axis: usize) -> Option<f64> {
    let object = &scene.room().objects[last(scene)?];
    if object.what != What::Group {
        return Some(2.0 * half(&object.what)[axis]);
    }
    let (low, high) = bounds_of_group(scene.room(), scene.poses(), &object.name)?;
    Some((high - low)[axis])
}

/// Half sizes of an object of a room along its own axes, metres: a group is as large as what it carries, and stands on the lowest of that.
fn half_of(scene: &RoomScene, object: &Object) -> DVec3 {
    if object.what != What::Group {
        return half(&object.what);
    }
    let bounds = bounds_of_group(scene.room(), scene.poses(), &object.name);
    bounds.map_or(DVec3::splat(POINT_M), |(low, high)| {
        let far = low.abs().max(high.abs());
        DVec3::new(far.x, -low.y, far.z)
    })
}

/// Half sizes along its own axes, metres.
pub fn half(what: &What) -> DVec3 {
    let flat = |size: DVec2| DVec3::new(0.04, size.y, size.x) / 2.0;
    match what {
        What::Box { size }
        | What::Pyramid { size }
        | What::Ramp { size }
        | What::Stairs { size, .. }
        | What::Arch { size, .. } => *size / 2.0,
        What::Cylinder { radius, height } => DVec3::new(*radius, height / 2.0, *radius),
        What::Ball { radius } => DVec3::splat(*radius),
        What::Aberration(it) => it.half,
        What::Sign { size, .. } => flat(*size),
        What::Portal(it) => match &it.opening {
            Opening::Size(size) => flat(*size),
            Opening::Polygon(corners) => {
                let most = corners
                    .iter()
                    .fold(DVec2::ZERO, |most, it| most.max(it.abs()));
                flat(2.0 * most)
            }
        },
        What::Model { scale, .. } => DVec3::splat(*scale),
        What::Light { .. } | What::Group => DVec3::splat(POINT_M),
    }
}

/// The middle of some things, metres.
pub fn middle(scene: &RoomScene, all: &[usize]) -> Option<DVec3> {
    let sum: DVec3 = all.iter().map(|index| extent(scene, *index).0).sum();
    (!all.is_empty()).then(|| sum / all.len() as f64)
}

/// The middle of a thing, or of what a group carries, and how far it reaches from there, metres.
fn extent(scene: &RoomScene, index: usize) -> (DVec3, f64) {
    let (room, pose) = (scene.room(), &scene.poses()[index]);
    let object = &room.objects[index];
    let is_group = object.what == What::Group;
    let bounds = is_group.then(|| bounds_of_group(room, scene.poses(), &object.name));
    match bounds.flatten() {
        Some((low, high)) => {
            let middle = pose.transform_point3((low + high) / 2.0);
            (middle, (high - low).length() / 2.0)
        }
        None => (pose.translation, half(&object.what).length()),
    }
}

/// How far all that is chosen reaches along x, metres, in whole steps: so far aside a copy stands free. None where that is too far
/// for the copy to be in view.
pub fn width_m(scene: &RoomScene, step_m: f64) -> Option<f64> {
    width_of((scene.room(), scene.poses()), &indices(scene), step_m)
}

/// So many widths aside it is looked for a place where nothing is in the way of a copy, nor it before a door.
const CLEAR_STEPS: usize = 8;
/// More pairs of things are not compared for it: who pastes many waits for no place.
const MOST_COMPARED: usize = 20_000;

/// So far aside copies stand free both of what they are copies of and of copies that were pasted there before. None where that is
/// too far for the copy to be in view.
pub fn free_aside(room: &Room, clip: &Clip, step_m: f64) -> Option<DVec3> {
    let mut alone = Room::new("");
    alone.objects = clip.objects().to_vec();
    let all = alone.objects.iter().enumerate();
    let roots: Vec<_> = all.filter(|(_, it)| it.group.is_none()).collect();
    let roots: Vec<_> = roots.into_iter().map(|(index, _)| index).collect();
    let first = &alone.objects[*roots.first()?];
    let width_m = width_of((&alone, &poses(&alone)), &roots, step_m)?;
    let is_free = |by: &DVec3| {
        let there = |it: &Arc<Object>| it.at.abs_diff_eq(first.at + by, 1e-6);
        !room.objects.iter().any(there)
    };
    let steps = || (1..).map(|number| DVec3::X * width_m * f64::from(number));
    let clear = || {
        let stands = Stands::of(room);
        steps().take(CLEAR_STEPS).find(|by| {
            let mut moved = alone.objects.clone();
            let roots = moved.iter_mut().filter(|it| it.group.is_none());
            roots.for_each(|it| Arc::make_mut(it).at += by);
            is_free(by) && !stands.are_in_the_way(&moved)
        })
    };
    let is_few = alone.objects.len() * room.objects.len() <= MOST_COMPARED;
    let near = is_few.then(clear).flatten();
    near.or_else(|| steps().find(is_free))
}

fn width_of(stands: (&Room, &[DAffine3]), all: &[usize], step_m: f64) -> Option<f64> {
    let width_m = extent_of(stands, all, 0)?;
    // What rounding adds is no step.
    let steps = (width_m / step_m - 1e-6).ceil();
    Some(steps.max(1.0) * step_m).filter(|it| *it <= WIDEST_M)
}

/// How far all that is chosen reaches along an axis of the room, metres.
pub fn extent_m(scene: &RoomScene, axis: usize) -> Option<f64> {
    extent_of((scene.room(), scene.poses()), &indices(scene), axis)
}

fn extent_of((room, poses): (&Room, &[DAffine3]), all: &[usize], axis: usize) -> Option<f64> {
    let spans = all.iter().map(|index| {
        let (object, pose) = (&room.objects[*index], &poses[*index]);
        let is_group = object.what == What::Group;
        let bounds = is_group.then(|| bounds_of_group(room, poses, &object.name));
        let half = half(&object.what);
        let (low, high) = bounds.flatten().unwrap_or((-half, half));
        let middle = pose.transform_point3((low + high) / 2.0)[axis];
        let out = pose.matrix3.row(axis).abs().dot((high - low) / 2.0);
        (middle - out, middle + out)
    });
    let both = spans.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    Some(both.1 - both.0)
}

/// The lowest and highest corner of the box about a thing, or about what a group carries, and the others of its front.
pub fn ends(scene: &RoomScene, index: usize) -> [DVec3; 4] {
    let (room, pose) = (scene.room(), scene.poses()[index]);
    let object = &room.objects[index];
    // All of the room is looked through for what a group carries.
    let is_group = object.what == What::Group;
    let bounds = is_group.then(|| bounds_of_group(room, scene.poses(), &object.name));
    let half = half(&object.what);
    let (low, high) = bounds.flatten().unwrap_or((-half, half));
    [
        low,
        high,
        DVec3::new(low.x, high.y, high.z),
        DVec3::new(high.x, low.y, low.z),
    ]
    .map(|corner| pose.transform_point3(corner))
}

/// How far some things reach from a point, metres.
pub fn reach_m(scene: &RoomScene, all: &[usize], origin: DVec3) -> f64 {
    let reach = all.iter().map(|index| {
        let (middle, reach_m) = extent(scene, *index);
        reach_m + middle.distance(origin)
    });
    reach.fold(0.5, f64::max)
}
