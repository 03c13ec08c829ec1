//! A drag of what is chosen, from when it is taken hold of.

use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::{Change, Drag, Held, Sight, Snap, Through, Viewpoint};
use antipode_rooms::What;
use glam::{DAffine3, DVec2, DVec3};

/// So near to a surface something lies on it, metres.
const TOUCHES_M: f64 = 0.02;

/// An axis along which a surface's normal has less than this lies in that surface.
const IN_SURFACE: f64 = 1e-6;

/// A drag that goes on.
#[derive(Clone, Debug)]
pub struct Dragging {
    pub drag: Drag,
    /// What is held, by name.
    pub names: Vec<String>,
    /// The same with all that it carries, by their places among all objects.
    pub held: Vec<usize>,
    /// The poses of all objects before it was dragged.
    pub poses: Vec<DAffine3>,
    /// Where handles of it were at the beginning.
    pub origin: DVec3,
    /// Half its height, metres: what lies on a surface stands on its lower end.
    pub half: DVec3,
    /// From the pointer to where its side on a surface is seen, so that it stays there when the drag begins.
    pub aside: DVec2,
    /// Whether anything was done yet.
    pub begun: bool,
}

impl Dragging {
    /// How far from the pointer that side of it is seen which lies on a surface; none where none does.
    pub fn footing(&self, scene: &RoomScene, view: &Viewpoint, at: DVec2) -> Option<DVec2> {
        let sides = [
            DVec3::NEG_Y,
            DVec3::X,
            DVec3::NEG_X,
            DVec3::Z,
            DVec3::NEG_Z,
            DVec3::Y,
        ];
        sides.into_iter().find_map(|side| {
            let foot = self.origin + side * self.half;
            let seen_at = self.through(scene, view).seen_at(foot, at)?;
            let seen = scene.seen_beside(view, seen_at, &self.held)?;
            (seen.place.point.distance(foot) < TOUCHES_M).then_some(seen_at - at)
        })
    }

    /// The way by which it was taken hold of.
    pub fn through<'a>(&self, scene: &'a RoomScene, view: &Viewpoint) -> Through<'a> {
        scene.through(view, self.drag.chain.clone())
    }

    /// Moves what is held onto what is seen beside the pointer, itself left out; on the grid along the axes of the room that lie in
    /// that surface.
    pub fn on_surface(
        &self,
        scene: &RoomScene,
        view: &Viewpoint,
        at: DVec2,
        snap: &Snap,
    ) -> Option<Change> {
        let seen = scene.seen_beside(view, at + self.aside, &self.held)?;
        let out = seen.normal.abs().dot(self.half);
        let mut to = seen.place.point + seen.normal * out;
        for axis in 0..3 {
            if seen.normal[axis].abs() < IN_SURFACE {
                to[axis] = snap.length(to[axis]);
            }
        }
        Some(Change::Move(to - self.origin))
    }
}

/// A drag of a thing by what is seen of it. An aberration is held from outside, whatever of it is seen from within.
pub fn body_drag(
    scene: &RoomScene,
    view: &Viewpoint,
    held: Held,
    seen: &Sight,
    at: DVec2,
) -> Option<Drag> {
    let is_box = matches!(scene.room().objects[seen.object].what, What::Aberration(_));
    if !is_box {
        let through = scene.through(view, seen.chain.clone());
        return Drag::begin_body(&through, held, seen.place.point, at);
    }
    let (through, _) = scene.way_to(view, held.origin, &[seen.object])?;
    let leg = through.leg(at)?;
    let way = (held.origin - leg.place.point).dot(leg.velocity) / leg.velocity.length_squared();
    let nearest = leg.place.point + leg.velocity * way;
    Drag::begin_body(&through, held, nearest, at)
}
