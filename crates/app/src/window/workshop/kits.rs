//! Parts and examples of several things that belong together: a house, a pair of portals. Each is the file of a room in
//! `assets/workshop`, whose groups stand on the ground with their fronts to +z.

#[cfg(test)]
mod tests;

use std::collections::HashSet;
use std::sync::Arc;

use antipode_rooms::aberration::{Aberration, Lengths, Sides};
use antipode_rooms::bounds::MOST_LIGHTS;
use antipode_rooms::{Colour, Object, Room, What, poses, rotation, space_in_parts};
use antipode_workshop::{Clip, Edit, make};
use glam::{DAffine3, DVec3};

use super::chosen::half;

/// What is nearer to a kit's lower end is what it stands on, metres.
const UNDER_M: f64 = 0.06;
/// Where else a kit is tried, metres to the right of where it was meant and behind that.
const ELSEWHERE_M: [(f64, f64); 13] = [
    (0.0, 0.0),
    (4.0, 0.0),
    (-4.0, 0.0),
    (0.0, 4.0),
    (8.0, 0.0),
    (-8.0, 0.0),
    (0.0, 8.0),
    (12.0, 0.0),
    (-12.0, 0.0),
    (16.0, 0.0),
    (-16.0, 0.0),
    (24.0, 0.0),
    (-24.0, 0.0),
];
/// So far before a portal, a gate and the ends of a tunnel nothing else is put: one could not go in, nor see through it.
const BEFORE_DOOR_M: f64 = 2.5;
/// How far from the first group of a kit the second is tried, in shares of how far it stands in the file.
const APART: [f64; 6] = [1.0, -1.0, 0.7, -0.7, 1.6, -1.6];

/// Frames of a portal alone, and of the second, so that one knows them apart.
const FRAMES: [Colour; 2] = [Colour([0x4f, 0xae, 0x7a]), Colour([0xe0, 0x78, 0x1c])];

macro_rules! kits {
    ($($id:literal),* $(,)?) => {
        &[$(($id, include_str!(concat!("../../../../../assets/workshop/", $id, ".ron")))),*]
    };
}

/// All of them: what they are known by, and their files.
pub const KITS: &[(&str, &str)] = kits![
    "house",
    "portals",
    "portal",
    "tunnel-longer",
    "tunnel-shorter",
    "portals-of-size",
    "falling-loop",
];

/// What a kit consists of, as its file has it.
pub fn objects(id: &str) -> Option<Vec<Arc<Object>>> {
    let (_, text) = KITS.iter().find(|(known, _)| *known == id)?;
    let clip = Clip::parse(text).ok()?;
    Some(clip.objects().to_vec())
}

/// Where a kit is to stand.
pub struct Site<'a> {
    /// What is seen there, metres.
    pub point: DVec3,
    /// Which way is out of that.
    pub normal: DVec3,
    /// Into the picture.
    pub front: DVec3,
    /// A length on the grid.
    pub snap: &'a dyn Fn(f64) -> f64,
    /// The ground below a point.
    pub ground: &'a dyn Fn(DVec3) -> Option<DVec3>,
}

/// Puts a kit in where nothing is in its way and its portals may stand, as near to where it was meant as can be; its front is
/// turned to who looks.
pub fn put(room: &Room, id: &str, site: &Site<'_>) -> Option<Edit> {
    let mut kit = objects(id)?;
    leave_lights_out(&mut kit, room);
    if id == "portal" && room.portals().count() % 2 == 1 {
        let framed = kit.iter_mut().filter(|it| it.surface.colour == FRAMES[0]);
        framed.for_each(|it| Arc::make_mut(it).surface.colour = FRAMES[1]);
    }
    place(room, &kit, 0.0, site)
}

/// The same of one thing alone.
pub fn put_alone(room: &Room, object: Object, site: &Site<'_>) -> Option<Edit> {
    let lift_m = half(&object.what).y;
    place(room, &[object.into()], lift_m, site)
}

/// Finds a place for things whose middles are so far over the ground.
fn place(room: &Room, kit: &[Arc<Object>], lift_m: f64, site: &Site<'_>) -> Option<Edit> {
    let turn = DVec3::new(quarter(site.front), 0.0, 0.0);
    let depth = reach(kit);
    let out = DVec3::new(site.normal.x, 0.0, site.normal.z) * depth;
    let before = Stands::of(room);
    let closed = space_in_parts(room).closed.len();
    let lay = |(right, behind): (f64, f64), apart: f64| {
        let is_meant = (right, behind) == (0.0, 0.0);
        let aside = rotation(turn) * DVec3::new(right, 0.0, -behind - depth);
        let meant = site.point + out + aside;
        let mut at = DVec3::new((site.snap)(meant.x), meant.y, (site.snap)(meant.z));
        if !is_meant && let Some(ground) = (site.ground)(at) {
            at.y = ground.y;
        }
        laid(kit, at, turn, apart, site.ground).map(|objects| lifted(objects, lift_m))
    };
    let all = || {
        let shares: &[f64] = if has_second(kit) { &APART } else { &APART[..1] };
        let places = ELSEWHERE_M.into_iter();
        places.flat_map(move |place| shares.iter().map(move |it| (place, *it)))
    };
    let fits = |objects: &Vec<Arc<Object>>| {
        let made = make(room, &paste(objects));
        made.is_ok_and(|made| space_in_parts(&made).closed.len() <= closed)
    };
    let first = |is_good: &dyn Fn(&Vec<Arc<Object>>) -> bool| {
        let mut any = all().filter_map(|(place, apart)| lay(place, apart));
        any.find(|it| is_good(it) && fits(it))
    };
    let is_free = |it: &Vec<Arc<Object>>| !before.are_in_the_way(it);
    let found = first(&|it| is_level(it) && is_free(it))
        .or_else(|| first(&is_free))
        .or_else(|| first(&|_| true));
    Some(paste(&found?))
}

/// The yaw, in quarter turns, by which +z comes to be against where one looks: yaw f takes it to (-sin f, 0, cos f).
pub fn quarter(front: DVec3) -> f64 {
    (front.x.atan2(-front.z).to_degrees() / 90.0).round() * 90.0
}

/// Whether its groups stand equally high.
fn is_level(objects: &[Arc<Object>]) -> bool {
    let mut alone = objects.iter().filter(|it| it.group.is_none());
    let first = alone.next().map_or(0.0, |it| it.at.y);
    alone.all(|it| (it.at.y - first).abs() < UNDER_M)
}

fn lifted(mut objects: Vec<Arc<Object>>, lift_m: f64) -> Vec<Arc<Object>> {
    let alone = objects.iter_mut().filter(|it| it.group.is_none());
    alone.for_each(|it| Arc::make_mut(it).at.y += lift_m);
    objects
}

/// A room that has as many lamps as it may have takes in a kit without its own.
fn leave_lights_out(kit: &mut Vec<Arc<Object>>, room: &Room) {
    let is_light = |it: &&Arc<Object>| matches!(it.what, What::Light { .. });
    let lights = room.objects.iter().chain(&*kit).filter(is_light).count();
    if lights > MOST_LIGHTS {
        kit.retain(|it| !is_light(&it));
    }
}

fn paste(objects: &[Arc<Object>]) -> Edit {
    let mut room = Room::new("kit");
    room.objects = objects.to_vec();
    let names: Vec<_> = objects.iter().map(|it| it.name.clone()).collect();
    Edit::Paste {
        clip: Clip::of(&room, &names),
        by: DVec3::ZERO,
        is_part: true,
    }
}

fn has_second(kit: &[Arc<Object>]) -> bool {
    kit.iter().filter(|it| it.group.is_none()).count() > 1
}

/// How far its things reach to its front, metres.
fn reach(kit: &[Arc<Object>]) -> f64 {
    let boxes = boxes_of(kit);
    boxes.iter().map(|it| it.1.z).fold(0.0, f64::max)
}

/// A kit at a place: its second group stands so many times as far from the first as in the file, on the ground there.
fn laid(
    kit: &[Arc<Object>],
    at: DVec3,
    turn: DVec3,
    apart: f64,
    ground: &dyn Fn(DVec3) -> Option<DVec3>,
) -> Option<Vec<Arc<Object>>> {
    let mut objects = kit.to_vec();
    let alone = objects.iter_mut().filter(|it| it.group.is_none());
    for object in alone.map(Arc::make_mut) {
        let aside = rotation(turn) * (object.at * apart);
        let mut there = at + aside;
        if aside != DVec3::ZERO {
            there.y = ground(there)?.y;
        }
        object.at = there.map(|one| (one * 1e4).round() / 1e4 + 0.0);
        object.turn += turn;
    }
    Some(objects)
}

/// What stands somewhere: the lowest and highest corner of a box about it.
type Bounds = (DVec3, DVec3, bool);

fn bounds(object: &Object, pose: &DAffine3) -> Bounds {
    let m = pose.matrix3;
    let half = half(&object.what);
    let reach = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
    let middle = pose.translation;
    let is_space = matches!(object.what, What::Aberration(_));
    (middle - reach, middle + reach, is_space)
}

fn takes_room(object: &Object) -> bool {
    !matches!(object.what, What::Group | What::Light { .. })
}

fn boxes_of(objects: &[Arc<Object>]) -> Vec<Bounds> {
    let mut room = Room::new("kit");
    room.objects = objects.to_vec();
    poses_of(&room)
}

fn poses_of(room: &Room) -> Vec<Bounds> {
    let all = room.objects.iter().zip(poses(room));
    let solid = all.filter(|(it, _)| takes_room(it));
    solid.map(|(it, pose)| bounds(it, &pose)).collect()
}

/// What is before portals, and before and behind gates and walled tunnels, as boxes.
fn before_doors(objects: &[Arc<Object>]) -> Vec<Bounds> {
    let mut room = Room::new("kit");
    room.objects = objects.to_vec();
    let all = room.objects.iter().zip(poses(&room));
    let before = all.flat_map(|(it, pose)| {
        let (low, high, _) = bounds(it, &pose);
        let ways = ways_out(&it.what).into_iter();
        ways.map(move |way| {
            let way = pose.matrix3 * way * BEFORE_DOOR_M;
            let (low, high) = (low + way.min(DVec3::ZERO), high + way.max(DVec3::ZERO));
            (low, high, false)
        })
    });
    before.collect()
}

/// Which ways one goes into a thing and out of it, by its own axes.
fn ways_out(what: &What) -> Vec<DVec3> {
    match what {
        What::Portal(_) => vec![DVec3::X],
        What::Arch { .. } => vec![DVec3::X, DVec3::NEG_X],
        What::Aberration(Aberration {
            lengths: Lengths::Felt { axis, .. },
            sides: Sides::Walls,
            ..
        }) => {
            let way = DVec3::AXES[axis.index()];
            vec![way, -way]
        }
        _ => Vec::new(),
    }
}

/// What stands in a room, and what is before its doors.
pub struct Stands(Vec<Bounds>);

impl Stands {
    /// Of a room.
    pub fn of(room: &Room) -> Self {
        let mut all = poses_of(room);
        all.extend(before_doors(&room.objects));
        Self(all)
    }

    /// Whether any of it is where these things would stand.
    pub fn are_in_the_way(&self, objects: &[Arc<Object>]) -> bool {
        is_in_the_way(&self.0, objects)
    }
}

/// Whether something that stands in the room is where a kit would stand. Space that holds all of the kit is not in its way.
fn is_in_the_way(room: &[Bounds], kit: &[Arc<Object>]) -> bool {
    let mut own = boxes_of(kit);
    own.extend(before_doors(kit));
    let lowest = own.iter().fold(DVec3::INFINITY, |it, own| it.min(own.0));
    let highest = own
        .iter()
        .fold(DVec3::NEG_INFINITY, |it, own| it.max(own.1));
    own.iter().any(|(low, high, _)| {
        let low = *low + DVec3::Y * UNDER_M;
        room.iter().any(|(from, to, is_space)| {
            let meets = low.cmplt(*to).all() && high.cmpgt(*from).all();
            let holds = from.cmple(lowest).all() && to.cmpge(highest).all();
            meets && !(*is_space && holds)
        })
    })
}

/// The lowest and highest corner of all that a group carries, in the group's own axes; none where that is nothing.
pub fn bounds_of_group(room: &Room, poses: &[DAffine3], group: &str) -> Option<(DVec3, DVec3)> {
    let (index, _) = room.find(group)?;
    let inverse = poses[index].inverse();
    let mut groups = HashSet::from([group]);
    for _ in 0..antipode_rooms::bounds::MOST_DEEP {
        let carried = room.objects.iter().filter(|it| {
            let outer = it.group.as_deref();
            it.what == What::Group && outer.is_some_and(|outer| groups.contains(outer))
        });
        let inner: Vec<_> = carried.map(|it| it.name.as_str()).collect();
        groups.extend(inner);
    }
    let is_carried = |it: &Object| it.group.as_deref().is_some_and(|it| groups.contains(it));
    let all = room.objects.iter().zip(poses);
    all.filter(|(it, _)| takes_room(it) && is_carried(it))
        .map(|(it, pose)| bounds(it, &(inverse * *pose)))
        .map(|(low, high, _)| (low, high))
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}
