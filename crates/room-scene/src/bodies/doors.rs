//! Bodies astride the door of an aberration. Along a door nothing is stretched, so there space goes on without a strain: what lies
//! beyond is met by its felt length, and the part of a body that is there takes up as much of the scene as it does there.
//!
//! With f on the door, a place x beyond has y = A1 f + A2 (x - f) in the chart before it (`frame.rs`).

use antipode_deformation::{EventKind, Sides, Space, Traveller, Void, half, trace};
use glam::{DAffine3, DMat3, DVec3};

use super::Body;
use super::frame::Frame;

/// How far beyond a face it is asked what is there, metres.
const BEYOND_M: f64 = 1e-6;

/// A door that something is near.
#[derive(Clone, Copy, Debug)]
pub struct Door {
    /// Its normal in the scene, to the side of the body, and a place of it.
    pub normal: DVec3,
    pub at: DVec3,
    /// K beyond it.
    squeeze: DMat3,
    /// To the chart beyond it.
    frame: Frame,
}

impl Body {
    /// The doors within so many felt metres of its own size that are before it.
    pub fn doors(&self, space: &Space, reach: f64) -> Vec<Door> {
        let stack = &self.place.stack;
        let entered = space.entrances(stack).iter().map(|it| usize::from(*it));
        let near = stack.innermost().into_iter().chain(entered);
        near.flat_map(|number| (0..6).map(move |face| (number, face)))
            .filter_map(|(number, face)| self.door(space, (number, face), reach))
            .collect()
    }

    fn door(&self, space: &Space, (number, face): (usize, usize), reach: f64) -> Option<Door> {
        let placed = &space.placed()[number];
        let box_of = &placed.aberration;
        let (axis, sign) = (face / 2, if face % 2 == 0 { 1.0 } else { -1.0 });
        if !box_of.is_door(axis) || matches!(box_of.sides, Sides::Legacy(_)) {
            return None;
        }
        let outward = placed.axes.col(axis) * sign;
        let at = box_of.centre + outward * box_of.half[axis];
        let is_in = self.place.stack.contains(number);
        let normal = if is_in { -outward } else { outward };
        let before = normal.dot(self.place.point - at);
        let extent = (self.out().transpose() * normal).length() * reach;
        let local = placed.local(self.place.point);
        let aside = (0..3).any(|it| it != axis && local[it].abs() > box_of.half[it]);
        if !(0.0..extent).contains(&before) || aside {
            return None;
        }
        let squeeze = self.squeeze_beyond(space, number, -normal * (before + BEYOND_M))?;
        (squeeze != self.squeeze).then(|| Door {
            normal,
            at,
            squeeze,
            frame: Frame::across(&self.squeeze, &squeeze, at),
        })
    }

    /// K where one gets to by that way of the scene, if only the face of that box lies on it.
    fn squeeze_beyond(&self, space: &Space, number: usize, way: DVec3) -> Option<DMat3> {
        let own = self.out().inverse() * way;
        let w = own.try_normalize()?;
        let path = trace(space, &self.place, w, own.length(), &Void, &Traveller::Body);
        let crosses = |kind: EventKind| matches!(kind, EventKind::Entered | EventKind::Left);
        match &path.events[..] {
            [one] if one.number == number && crosses(one.kind) => {
                Some(space.squeeze(&path.place.stack, self.velocity, &Traveller::Body))
            }
            _ => None,
        }
    }
}

impl Door {
    /// How far before it a place of the scene is.
    pub fn before(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.at)
    }

    /// Parts a convex polygon of the scene: what is before the door, and what is beyond, as it is felt from here: where it would be
    /// if space went on as it is here, of product `here`.
    pub fn part(&self, polygon: &[DVec3], here: &DMat3) -> [Vec<DVec3>; 2] {
        let before = half(polygon, |it| self.before(it));
        let mut beyond = half(polygon, |it| -self.before(it));
        let (into, back) = (self.squeeze.inverse(), self.frame.inverse());
        for corner in &mut beyond {
            *corner = *here * back.place(into * *corner);
        }
        [before, beyond]
    }

    /// The pose of what is beyond it, of something that is posed so before it.
    pub fn pose_beyond(&self, pose: &DAffine3, here: &DMat3) -> DAffine3 {
        let chart = DAffine3::from_mat3(here.inverse()) * *pose;
        let shifted = DAffine3::from_translation(self.frame.shift) * chart;
        DAffine3::from_mat3(self.squeeze) * shifted
    }
}
