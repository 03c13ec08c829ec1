//! The partner of a portal, chosen by a line that is dragged from the one to the other.

use antipode_language::{Texts, Value};
use antipode_room_scene::RoomScene;
use antipode_rooms::portal::{Opening, Portal};
use antipode_rooms::{Room, What, space_in_parts};
use antipode_ui::workshop::ViewLine;
use antipode_workshop::{Edit, Field, make};
use egui::Color32;
use glam::{DVec2, DVec3};

use super::{GRIP_POINTS, Workshop, bent, chosen};

/// The colour of the line.
const LINE: Color32 = Color32::from_rgb(0xC8, 0xA8, 0xFF);
/// How far above a portal its knob is, points.
const ABOVE_POINTS: f64 = 22.0;

/// A line that is being dragged.
#[derive(Clone, Debug, PartialEq)]
pub struct Linking {
    /// From where, and from which portal.
    start: DVec2,
    from: String,
    /// To where, and to which portal, if there is one.
    at: DVec2,
    to: Option<String>,
}

impl Workshop {
    /// The portal that is chosen, by itself or in its group, and where in the view the knob of its line is.
    fn link_knob(&self, scene: &RoomScene) -> Option<(String, DVec2)> {
        let name = chosen_portal(scene)?;
        let (index, object) = scene.room().find(&name)?;
        let pose = scene.poses()[index];
        let (through, at) = self.through(scene, pose.translation, &[index])?;
        let top = DVec3::Y * chosen::half(&object.what).y;
        let top = through.seen_at(pose.transform_point3(top), at)?;
        // Of a portal that is out of sight nothing hangs at the border.
        let corners = |it: &Opening| {
            let at = it.polygon().into_iter();
            let corner = |it: DVec2| pose.transform_point3(DVec3::new(0.0, it.y, -it.x));
            at.map(|it| through.seen_at(corner(it), top))
                .collect::<Option<Vec<_>>>()
        };
        if let What::Portal(it) = &object.what
            && let Some(corners) = corners(&it.opening)
            && is_out_of_sight(&corners)
        {
            return None;
        }
        let knob = top + DVec2::Y * self.half_heights(ABOVE_POINTS);
        // It stays in reach of a portal that is near.
        Some((name, knob.clamp(DVec2::splat(-0.9), DVec2::splat(0.9))))
    }

    /// Where the knob of the chosen portal is, and the middle of another, for tests.
    #[cfg(test)]
    pub fn link_places(&self, scene: &RoomScene, to: &str) -> Option<(DVec2, DVec2)> {
        let (_, knob) = self.link_knob(scene)?;
        let (index, _) = scene.room().find(to)?;
        let middle = scene.poses()[index].translation;
        let (_, at) = scene.way_to(&self.viewpoint(scene), middle, &[])?;
        Some((knob, at))
    }

    /// Where the middle of a thing is seen, for tests.
    #[cfg(test)]
    pub fn seen_in_view(&self, scene: &RoomScene, name: &str) -> Option<DVec2> {
        let (index, _) = scene.room().find(name)?;
        let middle = scene.poses()[index].translation;
        let (_, at) = scene.way_to(&self.viewpoint(scene), middle, &[])?;
        Some(at)
    }

    /// Where the mark of the start is seen, for tests.
    #[cfg(test)]
    pub fn seen_start(&self, scene: &RoomScene) -> Option<DVec2> {
        let middle = scene.room().spawn.at + DVec3::Y;
        Some(scene.way_to(&self.viewpoint(scene), middle, &[])?.1)
    }

    /// The lines over the view, for tests.
    #[cfg(test)]
    pub fn lines(&self, scene: &RoomScene, texts: &Texts) -> Vec<ViewLine> {
        super::lines::lines(self, scene, texts)
    }

    /// Takes hold of the knob, if it is there.
    pub fn grab_link(&mut self, scene: &RoomScene, at: DVec2) -> bool {
        let view = self.viewpoint(scene);
        let knob = self.link_knob(scene);
        let near = self.half_heights(GRIP_POINTS);
        self.linking =
            knob.filter(|(_, knob)| view.apart(*knob, at) < near)
                .map(|(from, start)| Linking {
                    start,
                    from,
                    at,
                    to: None,
                });
        self.linking.is_some()
    }

    /// The line is dragged to there.
    pub fn pull_link(&mut self, scene: &RoomScene, at: DVec2) {
        let to = self.portal_at(scene, at);
        if let Some(linking) = &mut self.linking {
            (linking.at, linking.to) = (at, to);
        }
    }

    /// The line is let go of: what it leads to is the partner.
    pub fn let_link(&mut self, scene: &RoomScene) -> Option<Edit> {
        let Linking { from, to, .. } = self.linking.take()?;
        Some(link(scene.room(), &from, &to?))
    }

    /// The portal that is seen nearest there, open or closed.
    fn portal_at(&self, scene: &RoomScene, at: DVec2) -> Option<String> {
        let room = scene.room();
        let poses = scene.poses();
        let view = self.viewpoint(scene);
        let found = room.portals().filter_map(|(index, portal)| {
            let pose = poses[index];
            let (through, from) = scene.way_to(&view, pose.translation, &[])?;
            let corner = |it: DVec2| {
                let corner = pose.transform_point3(DVec3::new(0.0, it.y, -it.x));
                through.seen_at(corner, from)
            };
            let corners: Option<Vec<_>> =
                portal.opening.polygon().into_iter().map(corner).collect();
            let away = pose.translation.distance(view.eye.place.point);
            is_within(&corners?, at).then_some((away, index))
        });
        // The portal itself only where no other is.
        let own = self.linking.as_ref().map(|it| it.from.as_str());
        let is_own = |it: &(f64, usize)| Some(room.objects[it.1].name.as_str()) == own;
        let nearest = found.min_by(|a, b| is_own(a).cmp(&is_own(b)).then(a.0.total_cmp(&b.0)))?;
        Some(room.objects[nearest.1].name.clone())
    }

    /// The knob, and the line with what would become of who passes.
    pub fn link_lines(&self, scene: &RoomScene, texts: &Texts, all: &mut Vec<ViewLine>) {
        let flat = |at: DVec2| at.as_vec2().to_array();
        let line = |from: DVec2, to: DVec2, label: Option<String>| ViewLine {
            points: vec![flat(from), flat(to)],
            colour: LINE,
            width: 3.0,
            label,
            knob: true,
        };
        if let Some(linking) = &self.linking {
            let label = match &linking.to {
                Some(to) => would_be(texts, scene, &linking.from, to),
                None => texts.say("workshop-link-to"),
            };
            all.push(line(linking.start, linking.at, Some(label)));
        } else if let Some((name, knob)) = self.link_knob(scene) {
            let below = DVec2::Y * self.half_heights(ABOVE_POINTS * 0.7);
            let is_free = self.dragging.is_none();
            let label = is_free.then(|| partner_words(texts, scene.room(), &name));
            all.push(line(knob - below, knob, label));
        }
    }
}

/// To which portal one leads, in words.
fn partner_words(texts: &Texts, room: &Room, name: &str) -> String {
    let to = portal(room, name).map_or("", |it| it.to.as_str());
    if to == name {
        return texts.say("workshop-link-itself");
    }
    if portal(room, to).is_none() {
        return texts.say("workshop-link-nowhere");
    }
    let values: [(&str, Value<'_>); 1] = [("name", to.into())];
    texts.say_with("workshop-link-partner", &values)
}

/// The portal that is chosen, or the only one that what is chosen carries.
fn chosen_portal(scene: &RoomScene) -> Option<String> {
    let [name] = scene.document().selection() else {
        return None;
    };
    let room = scene.room();
    let (_, object) = room.find(name)?;
    if matches!(object.what, What::Portal(_)) {
        return Some(name.clone());
    }
    let carried = room.portals().map(|(index, _)| &room.objects[index]);
    let mut own = carried.filter(|it| it.group.as_ref() == Some(name));
    let only = own.next()?;
    own.next().is_none().then(|| only.name.clone())
}

/// Whether a place is within a convex shape.
fn is_within(corners: &[DVec2], at: DVec2) -> bool {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let turns: Vec<f64> = sides.map(|(a, b)| (*b - *a).perp_dot(at - *a)).collect();
    turns.iter().all(|it| *it >= 0.0) || turns.iter().all(|it| *it <= 0.0)
}

/// Whether all of a shape is beside the view.
fn is_out_of_sight(corners: &[DVec2]) -> bool {
    let low = corners.iter().fold(DVec2::INFINITY, |it, at| it.min(*at));
    let high = corners
        .iter()
        .fold(DVec2::NEG_INFINITY, |it, at| it.max(*at));
    low.cmpgt(DVec2::ONE).any() || high.cmplt(DVec2::NEG_ONE).any()
}

fn portal<'r>(room: &'r Room, name: &str) -> Option<&'r Portal> {
    match &room.find(name)?.1.what {
        What::Portal(it) => Some(it),
        _ => None,
    }
}

/// Links two portals to each other by one edit. Those that they led to before lead to themselves then.
pub fn link(room: &Room, a: &str, b: &str) -> Edit {
    let to = |from: &str, to: &str| Edit::Change(from.to_owned(), vec![Field::new("to", to)]);
    let mut edits = vec![to(a, b)];
    if a != b {
        edits.push(to(b, a));
    }
    let left = room
        .portals()
        .map(|(index, it)| (&room.objects[index].name, it));
    let left = left.filter(|(name, it)| {
        *name != a && *name != b && it.to != **name && (it.to == a || it.to == b)
    });
    edits.extend(left.map(|(name, _)| to(name, name)));
    Edit::Several(edits)
}

/// What two portals would do to who passes if they led to each other.
fn would_be(texts: &Texts, scene: &RoomScene, a: &str, b: &str) -> String {
    let Ok(room) = make(scene.room(), &link(scene.room(), a, b)) else {
        return texts.say("workshop-link-to");
    };
    let so_far = space_in_parts(&room);
    bent::of_portal(texts, &room, &so_far.space, a).0
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;
    use crate::window::workshop::kits;

    #[test]
    fn what_a_portal_led_to_before_leads_to_itself() {
        let mut room = Room::new("a");
        for (number, id) in ["portals", "portals-of-size"].into_iter().enumerate() {
            let mut objects = kits::objects(id).unwrap();
            let alone = objects.iter_mut().filter(|it| it.group.is_none());
            for object in alone.map(std::sync::Arc::make_mut) {
                object.at.z -= 20.0 * number as f64;
            }
            room.objects.extend(objects);
        }
        let made = make(&room, &link(&room, "portal", "large portal")).unwrap();
        let to = |name: &str| portal(&made, name).unwrap().to.clone();
        assert_eq!(to("portal"), "large portal");
        assert_eq!(to("large portal"), "portal");
        assert_eq!(to("portal 2"), "portal 2");
        assert_eq!(to("small portal"), "small portal");
    }

    #[test]
    fn a_place_is_within_a_shape_or_beside_it() {
        let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)].map(DVec2::from);
        assert!(is_within(&square, DVec2::new(1.9, 0.5)));
        assert!(!is_within(&square, DVec2::new(2.1, 0.5)));
        let mut other = square;
        other.reverse();
        assert!(is_within(&other, DVec2::new(0.1, 0.9)));
    }
}
