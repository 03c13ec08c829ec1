//! What the pointer does in the view: it chooses what is seen under it, and drags handles and things.

use antipode_deformation::Chain;
use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::{Change, Drag, Handle, Sight, Viewpoint};
use antipode_rooms::{Room, What};
use antipode_ui::workshop::ViewEvent;
use antipode_workshop::{Edit, closure};
use glam::{DVec2, DVec3};

use super::dragging::{Dragging, body_drag};
use super::{GRIP_POINTS, Seen, Workshop, changes, chosen};

/// Radians for a point of a drag that turns the view.
const TURN_PER_POINT: f64 = 0.005;
/// How much nearer a notch of the wheel brings what is looked at.
const ZOOM: f64 = 0.88;
/// Felt speed of flight, metres a second, and how many times that is at most.
const FLIGHT_M_S: (f64, f64) = (5.0, 4.0);
/// What is so many times larger than an opening is seen behind it as a background.
const LARGER: f64 = 3.0;
/// How near to the click before another is one at the same place, points.
const SAME_POINTS: f64 = 4.0;

/// What is done to the room in the view.
#[derive(Clone, Debug, PartialEq)]
pub enum Deed {
    /// A moment of a drag.
    Moment(Edit),
    /// A step of its own.
    Step(Edit),
}

/// What could be meant by the last click: clicks at the same place go through it.
#[derive(Clone, Debug)]
pub struct Meant {
    at: DVec2,
    all: Vec<usize>,
    number: usize,
}

impl Workshop {
    /// The handle that is dragged or under the pointer.
    pub fn active_handle(&self) -> Option<Handle> {
        let dragged = self.dragging.as_ref().map(|it| it.drag.handle);
        dragged.or(self.hover)
    }

    /// Lets go of what is dragged, and takes back what that did. Returns whether anything was.
    pub fn give_up(&mut self, scene: &mut RoomScene) -> bool {
        if self.linking.take().is_some() {
            return true;
        }
        let was_framing = self.frame.take().is_some_and(|[from, to]| from != to);
        let given_up = self.dragging.take().is_some();
        if given_up {
            scene.cancel_drag();
        }
        given_up || was_framing
    }

    /// Something was done in the view. Returns what that does to the room.
    pub fn view_event(&mut self, scene: &mut RoomScene, event: ViewEvent) -> Option<Deed> {
        match event {
            ViewEvent::Hover(at) => self.hover_at(scene, DVec2::from_array(at)),
            ViewEvent::Leave => (self.pointer, self.hover) = (None, None),
            ViewEvent::Grab(at) if self.grab_link(scene, DVec2::from_array(at)) => {}
            ViewEvent::Grab(at) => self.grab(scene, DVec2::from_array(at)),
            ViewEvent::Pull { at, .. } if self.linking.is_some() => {
                self.pull_link(scene, DVec2::from_array(at));
            }
            ViewEvent::Pull { at, free } => {
                let edit = self.pull(scene, DVec2::from_array(at), free);
                return edit.map(Deed::Moment);
            }
            ViewEvent::Let { .. } if self.linking.is_some() => {
                return self.let_link(scene).map(Deed::Step);
            }
            ViewEvent::Let {
                at, adds, is_click, ..
            } => self.let_go(scene, DVec2::from_array(at), adds, is_click),
            ViewEvent::Look([x, y]) => {
                self.camera.look(x * TURN_PER_POINT, -y * TURN_PER_POINT);
            }
            ViewEvent::Orbit([x, y]) => {
                let (right, up) = (x * TURN_PER_POINT, -y * TURN_PER_POINT);
                self.camera.orbit(scene.space(), right, up);
            }
            ViewEvent::Pan([x, y]) => {
                let metres = self.camera.pivot_m * self.half_heights(1.0) * 0.7;
                let by = DVec3::new(0.0, -x * metres, y * metres);
                self.camera.fly(scene.space(), by);
            }
            ViewEvent::Zoom(notches) => {
                self.camera.zoom(scene.space(), ZOOM.powf(notches));
            }
            ViewEvent::Fly(by, time_s, fast) => {
                let speed = FLIGHT_M_S.0 * if fast { FLIGHT_M_S.1 } else { 1.0 };
                let by = DVec3::from_array(by).clamp_length_max(1.0) * speed * time_s;
                self.camera.fly(scene.space(), by);
            }
        }
        None
    }

    fn hover_at(&mut self, scene: &RoomScene, at: DVec2) {
        self.pointer = Some(at);
        let within = self.half_heights(GRIP_POINTS);
        let handles = self.handles(scene);
        self.hover =
            handles.and_then(|(through, handles)| handles.under(&through.view, at, within));
    }

    /// Takes hold of the handle there, or of what is chosen if that is seen there.
    fn grab(&mut self, scene: &RoomScene, at: DVec2) {
        (self.dragging, self.frame) = (None, Some([at; 2]));
        let names = scene.document().selection().to_vec();
        let within = self.half_heights(GRIP_POINTS);
        let Some(held) = chosen::held(scene, self.bar.own_axes) else {
            return;
        };
        let taken = |drag: Drag| Dragging {
            drag,
            held: all_held(scene.room(), &names),
            poses: scene.poses().to_vec(),
            names: names.clone(),
            origin: held.origin,
            half: held.half,
            aside: DVec2::ZERO,
            begun: false,
        };
        if let Some((through, handles)) = self.handles(scene)
            && let Some(handle) = handles.under(&through.view, at, within)
        {
            self.dragging = Drag::begin(&through, &handles, handle, at).map(taken);
            self.frame = None;
            return;
        }
        let view = self.viewpoint(scene);
        let Some(seen) = scene.seen(&view, at) else {
            return;
        };
        if all_held(scene.room(), &names).contains(&seen.object) {
            let drag = body_drag(scene, &view, held, &seen, at);
            self.dragging = drag.map(taken);
            if let Some(dragging) = &mut self.dragging {
                dragging.aside = dragging.footing(scene, &view, at).unwrap_or_default();
            }
            self.frame = None;
        }
    }

    /// What a drag to there makes of what is held.
    fn pull(&mut self, scene: &mut RoomScene, at: DVec2, free: bool) -> Option<Edit> {
        if let Some([_, to]) = &mut self.frame {
            *to = at;
            return None;
        }
        let snap = self.snap(free);
        let on_surfaces = self.bar.on_surfaces && !free;
        let view = self.viewpoint(scene);
        let dragging = self.dragging.as_mut()?;
        let on_surface = on_surfaces && dragging.drag.handle == Handle::Body;
        let change = if on_surface {
            dragging.on_surface(scene, &view, at, &snap)?
        } else {
            let through = dragging.through(scene, &view);
            dragging.drag.change(&through, at, &snap)?
        };
        if !std::mem::replace(&mut dragging.begun, true) {
            scene.document_mut().begin_drag();
        }
        let before = scene.document().room_before_drag();
        let before = (before, &*dragging.poses);
        changes::edit(before, &dragging.names, dragging.origin, &change)
    }

    /// Ends a drag, or chooses what was clicked.
    fn let_go(&mut self, scene: &mut RoomScene, at: DVec2, adds: bool, is_click: bool) {
        if let Some(dragging) = self.dragging.take()
            && dragging.begun
        {
            scene.document_mut().end_drag();
            // What is behind the way by which it was dragged is sought anew from where it is now.
            self.seen = self.seen.take().filter(|it| it.chain.has_portal());
            if let Some(seen) = &mut self.seen {
                seen.at = at;
            }
            return;
        }
        let frame = self.frame.take();
        if is_click {
            self.choose_at(scene, at, adds);
        } else if let Some(frame) = frame {
            self.choose_within(scene, frame, adds);
        }
    }

    /// Chooses what is seen there; at the same place again the aberrations and portals through which it is seen, one after
    /// another.
    fn choose_at(&mut self, scene: &mut RoomScene, at: DVec2, adds: bool) {
        let view = self.viewpoint(scene);
        let is_free = |index: &usize| {
            let name = &scene.room().objects[*index].name;
            !scene.document().is_locked(name) && !scene.document().is_hidden(name)
        };
        let all: Vec<usize> = meant(scene, &view, at)
            .into_iter()
            .filter(is_free)
            .collect();
        let near = self.half_heights(SAME_POINTS);
        let number = match &self.meant {
            Some(last) if view.apart(last.at, at) < near && last.all == all && !adds => {
                (last.number + 1) % all.len().max(1)
            }
            _ => 0,
        };
        let found = all.get(number).copied();
        self.meant = Some(Meant { at, all, number });
        // Aberrations are held from outside, by the straight way.
        let is_box = |it: &Sight| {
            let what = &scene.room().objects[it.object].what;
            matches!(what, What::Aberration(_))
        };
        let is_found = |it: &Sight| {
            found.is_some_and(|found| {
                it.object == found || outermost(scene.room(), it.object) == found
            })
        };
        let chain = scene
            .seen(&view, at)
            .filter(|it| is_found(it) && !is_box(it));
        self.seen = chain.map(|it| Seen {
            chain: it.chain,
            at,
        });
        let name = found.map(|index| scene.room().objects[index].name.clone());
        let document = scene.document_mut();
        match name {
            Some(name) if adds => document.toggle(&name),
            Some(name) => document.select([name]),
            None if !adds => document.select([]),
            None => {}
        }
    }

    /// Chooses all that are seen whole within a frame, and so not the ground that others stand on.
    fn choose_within(&mut self, scene: &mut RoomScene, [a, b]: [DVec2; 2], adds: bool) {
        self.forget_chain();
        let view = self.viewpoint(scene);
        let (low, high) = (a.min(b), a.max(b));
        let (room, marked) = (scene.room(), scene.document().marked());
        let is_within = |index: usize| {
            let own = chosen::own_spaces(room, index);
            let is_seen = |point: DVec3| {
                let seen = scene.way_to(&view, point, &own);
                seen.is_some_and(|(_, at)| at.cmpge(low).all() && at.cmple(high).all())
            };
            // Two corners, far apart, and the middle first: all of many things takes its time.
            is_seen(scene.poses()[index].translation)
                && chosen::ends(scene, index)[..2]
                    .iter()
                    .all(|it| is_seen(*it))
        };
        let found: Vec<usize> = room
            .objects
            .iter()
            .enumerate()
            .filter(|(_, it)| it.what != What::Group)
            .filter(|(_, it)| !marked.is_locked(it) && !marked.is_hidden(it))
            .filter(|(index, _)| is_within(*index))
            .map(|(index, _)| outermost(room, index))
            .collect();
        let mut names: Vec<String> = Vec::new();
        for index in found {
            let name = &room.objects[index].name;
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        if adds {
            let before = scene.document().selection().iter().cloned();
            names = before.chain(names).collect();
        }
        scene.document_mut().select(names);
    }

    /// The chain by which things were chosen holds no more, since others are chosen.
    pub fn forget_chain(&mut self) {
        (self.seen, self.meant) = (None, None);
    }

    /// What the middle of the picture shows: where a part is put, and the way out of the surface there.
    pub fn before_camera(&self, scene: &RoomScene) -> (DVec3, DVec3) {
        let view = self.viewpoint(scene);
        // A little below the middle, where the ground is.
        let at = DVec2::new(0.0, -0.42);
        let front = self.camera.axes().0;
        if view.eye.parallel_m.is_some() && front.y > -0.5 {
            // From the side there is no ground to look at: what stands there is where the camera turns about.
            let pivot = self.camera.point + front * self.camera.pivot_m;
            return (scene.ground_below(pivot).unwrap_or(pivot), DVec3::Y);
        }
        let farthest_m = match view.eye.parallel_m {
            Some(_) => f64::INFINITY,
            None => 60.0,
        };
        if let Some(seen) = scene.seen(&view, at).filter(|it| it.felt_m < farthest_m) {
            return (seen.place.point, seen.normal);
        }
        let through = scene.through(&view, Chain::default());
        let ahead = through
            .leg(at)
            .map(|leg| leg.place.point + leg.velocity * 6.0);
        (ahead.unwrap_or(view.eye.place.point), DVec3::Y)
    }
}

/// All that can be meant by a click there. A thing of a group means the group first. What is much larger than the opening through
/// which it is seen, as a floor is, is taken for the background of that opening, which is meant first.
fn meant(scene: &RoomScene, view: &Viewpoint, at: DVec2) -> Vec<usize> {
    let room = scene.room();
    let mut seen = scene.meant(view, at);
    let size = |index: usize| chosen::half(&room.objects[index].what).max_element();
    if let [first, .., nearest] = seen[..]
        && size(first) > LARGER * size(nearest)
    {
        // The first opening on the way comes first.
        seen.reverse();
    }
    let mut all = Vec::new();
    for index in seen {
        for it in [outermost(room, index), index] {
            if !all.contains(&it) {
                all.push(it);
            }
        }
    }
    all
}

/// The group that carries something, and is carried by none; the thing itself where it is in none.
fn outermost(room: &Room, index: usize) -> usize {
    let mut index = index;
    for _ in 0..antipode_rooms::bounds::MOST_DEEP {
        let group = room.objects[index].group.as_deref();
        let Some((outer, _)) = group.and_then(|it| room.find(it)) else {
            break;
        };
        index = outer;
    }
    index
}

/// Objects of these names and all that they carry, by their places, rising.
fn all_held(room: &Room, names: &[String]) -> Vec<usize> {
    let held = closure(room, names);
    let all = room.objects.iter().enumerate();
    all.filter(|(_, it)| held.contains(it.name.as_str()))
        .map(|(index, _)| index)
        .collect()
}

/// A step of the arrow keys: to the right, up, and towards who looks, along the axis of the room that is nearest to that.
pub fn nudge(scene: &RoomScene, workshop: &Workshop, by: [i8; 3]) -> Option<Edit> {
    let (front, right, _) = workshop.camera.axes();
    let level = |way: DVec3| {
        let flat = DVec3::new(way.x, 0.0, way.z);
        if flat.x.abs() > flat.z.abs() {
            DVec3::X * flat.x.signum()
        } else {
            DVec3::Z * flat.z.signum()
        }
    };
    let step = if workshop.bar.snaps {
        workshop.bar.grid_m
    } else {
        0.01
    };
    let [x, y, z] = by.map(f64::from);
    let way = level(right) * x + DVec3::Y * y - level(front) * z;
    let names = scene.document().selection();
    let change = Change::Move(way * step);
    let before = (scene.room(), scene.poses());
    changes::edit(before, names, DVec3::ZERO, &change)
}
