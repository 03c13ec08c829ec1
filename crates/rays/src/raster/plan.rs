//! The views of a picture: what is seen from the eye, through doors, and through doors behind these.
//!
//! A ray of felt direction w is at o + t K w after t felt metres, with o and K the same for all rays of a view. At the first, o is
//! the eye. At a door the place is kept while K becomes K': with f on the door's plane, f = o + t K w and o' = f - t K' w give
//!
//! > o' = f - K' K^-1 (f - o)
//!
//! which is the same for all f of the plane where K' K^-1 moves nothing along it: where the stretches along the door are 1. So
//! each view is a camera in coordinates of the scene, at o, whose picture of x is that of K^-1 (x - o). Behind a portal of map G, of
//! linear part L, x = o + t V w becomes G o + t L V w: a view more, with w turned by O, and V = m K turn for who is m times larger.

use antipode_deformation::{Placed, Space, Stack, Traveller};
use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::tidy::clearance;
use crate::scene::Eye;

/// Least distance along the view's direction that is drawn, felt metres.
pub const NEAR_M: f64 = 2e-4;
/// What is as near to a portal's plane as this share of its coordinates lies in it.
const PLANE: f64 = 4e-6;

/// How much is drawn by a raster.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Doors in a row, and one.
    pub levels: usize,
    /// Views; at most 255.
    pub views: usize,
}

/// A view.
#[derive(Clone, Debug)]
pub struct View {
    /// Boxes that one looks about in.
    pub stack: Stack,
    /// V: takes the eye's felt directions to velocities in the scene.
    pub carry: DMat3,
    /// Product of the O of the portals that are before it.
    pub turn: DMat3,
    /// Product of their q, and the eye's own scale.
    pub scale: f64,
    /// How many they are.
    pub passed: u32,
    /// The portal that one looks out of, and whether before its front.
    pub left: Option<(usize, bool)>,
    /// From where it is seen, metres of the scene.
    pub origin: DVec3,
    /// What has n.x < d is before the door: n and d.
    pub cut: Option<(DVec3, f64)>,
    /// How many doors are before it.
    pub level: usize,
    /// The part of the picture in which its door lies: least and greatest x and y, from -1 at the left and the bottom to 1.
    pub extent: (DVec2, DVec2),
    /// Picks x, y and depth of the picture, each as a product with x - o.
    pub rows: [DVec3; 3],
}

/// What a face of a box is in a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Opaque: the face of the box of that number across that axis, and whether it is the one that the axis points to.
    Wall(usize, usize, bool),
    /// A door or a portal to the view of that number.
    Door(usize),
    /// Only rays know what is seen in it.
    Rays,
}

/// A face of a box, or a part of a portal, in a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The number of the view.
    pub view: usize,
    /// Takes a square from -1 to 1 of the first two coordinates to where it is.
    pub pose: DAffine3,
    /// Whether it is of a portal: half of that square, and before what lies in its plane.
    pub is_portal: bool,
    /// What it is.
    pub kind: Kind,
}

/// A polygon that one may see through.
struct Opening {
    corners: Vec<DVec3>,
    /// The view behind it, but for the part of the picture in which it lies.
    behind: View,
}

/// All views of a picture, and the faces in them.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The first is that of the eye.
    pub views: Vec<View>,
    /// Faces.
    pub faces: Vec<Face>,
}

impl Plan {
    /// One view in coordinates of the scene, with all walls that there are.
    pub fn plain(space: &Space, eye: &Eye, aspect: f64) -> Self {
        let lens = lens(eye, aspect);
        let mut plan = Self::default();
        plan.views.push(View {
            stack: Stack::default(),
            carry: DMat3::IDENTITY,
            turn: DMat3::IDENTITY,
            scale: eye.place.scale,
            passed: 0,
            left: None,
            origin: eye.place.point,
            cut: None,
            level: 0,
            extent: (DVec2::NEG_ONE, DVec2::ONE),
            rows: lens,
        });
        for (number, placed) in space.placed().iter().enumerate() {
            let walls = sides().filter(|(axis, _)| placed.aberration.is_wall(*axis));
            plan.faces.extend(walls.map(|(axis, is_far)| Face {
                view: 0,
                pose: face_pose(placed, axis, is_far),
                is_portal: false,
                kind: Kind::Wall(number, axis, is_far),
            }));
        }
        plan
    }

    /// The views through the doors of tidy tunnels.
    pub fn doors(space: &Space, tidy: &[bool], eye: &Eye, aspect: f64, limits: Limits) -> Self {
        let stack = eye.place.stack;
        let mut maker = Maker {
            space,
            tidy,
            lens: lens(eye, aspect),
            limits,
            plan: Self::default(),
        };
        let carry = maker.squeeze(&stack) * eye.place.scale;
        let first = View {
            stack,
            carry,
            turn: DMat3::IDENTITY,
            scale: eye.place.scale,
            passed: 0,
            left: None,
            origin: eye.place.point,
            cut: None,
            level: 0,
            extent: (DVec2::NEG_ONE, DVec2::ONE),
            rows: maker.rows(carry),
        };
        maker.plan.views.push(first);
        let mut at = 0;
        while let Some(view) = maker.plan.views.get(at).cloned() {
            maker.look_about(at, &view);
            at += 1;
        }
        maker.plan
    }

    /// Whether there is nothing in it that only rays know.
    pub fn sees_all(&self) -> bool {
        self.faces.iter().all(|face| face.kind != Kind::Rays)
    }

    /// Levels that it has.
    pub fn levels(&self) -> usize {
        self.views
            .iter()
            .map(|view| view.level + 1)
            .max()
            .unwrap_or(0)
    }
}

/// Picks x, y and depth of the picture, each as a product with a felt displacement from the eye.
fn lens(eye: &Eye, aspect: f64) -> [DVec3; 3] {
    let half = (0.5 * eye.fov_y_rad).tan();
    [eye.right / (half * aspect), eye.up / half, eye.front]
}

/// Axes and sides of a box's faces.
fn sides() -> impl Iterator<Item = (usize, bool)> {
    (0..6).map(|side| (side / 2, side % 2 == 1))
}

struct Maker<'a> {
    space: &'a Space,
    tidy: &'a [bool],
    lens: [DVec3; 3],
    limits: Limits,
    plan: Plan,
}

impl Maker<'_> {
    fn squeeze(&self, stack: &Stack) -> DMat3 {
        // Whichever way: tidy boxes are felt both ways.
        self.space.squeeze(stack, DVec3::Z, &Traveller::Body)
    }

    /// The lens of a view: p.(V^-1 x) = (V^-T p).x.
    fn rows(&self, carry: DMat3) -> [DVec3; 3] {
        let to_scene = carry.inverse().transpose();
        self.lens.map(|row| to_scene * row)
    }

    /// Lists the faces that a view shows, and opens views behind its doors.
    fn look_about(&mut self, number: usize, view: &View) {
        if let Some(own) = view.stack.innermost() {
            sides().for_each(|side| self.look_at((number, view), own, side, true));
        }
        for entrance in self.space.entrances(&view.stack) {
            let other = usize::from(*entrance);
            if !view.stack.contains(other) {
                sides().for_each(|side| self.look_at((number, view), other, side, false));
            }
        }
        (0..self.space.portals().len()).for_each(|it| self.look_into((number, view), it));
    }

    /// Lists a face through which one would leave a box, or enter it, if it is seen from that side.
    fn look_at(
        &mut self,
        (of, view): (usize, &View),
        number: usize,
        (axis, is_far): (usize, bool),
        leaves: bool,
    ) {
        let placed = &self.space.placed()[number];
        let pose = face_pose(placed, axis, is_far);
        let (one, other, outward) = (
            pose.matrix3.x_axis,
            pose.matrix3.y_axis,
            pose.matrix3.z_axis,
        );
        let centre = pose.translation;
        let before = outward.dot(view.origin - centre);
        let is_seen = if leaves { before < 0.0 } else { before > 0.0 };
        // What reaches farthest behind the door that one looks through.
        let is_beyond = view.cut.is_none_or(|(n, d)| {
            let reach = n.dot(one).abs() + n.dot(other).abs();
            n.dot(centre) + reach > d + clearance(placed)
        });
        if !is_seen || !is_beyond {
            return;
        }
        let kind = if !self.tidy[number] {
            Kind::Rays
        } else if placed.aberration.is_wall(axis) {
            Kind::Wall(number, axis, is_far)
        } else {
            let onward = outward.normalize() * if leaves { 1.0 } else { -1.0 };
            let stack = self
                .space
                .stack_at(centre + onward * (0.5 * clearance(placed)));
            let is_next = stack.len().abs_diff(view.stack.len()) == 1;
            let corners = [-one - other, one - other, one + other, other - one];
            let carry = self.squeeze(&stack) * view.turn * view.scale;
            let behind = View {
                stack,
                carry,
                origin: centre - carry * (view.carry.inverse() * (centre - view.origin)),
                cut: Some((onward, onward.dot(centre))),
                ..view.clone()
            };
            let opening = Opening {
                corners: corners.map(|corner| centre + corner).to_vec(),
                behind,
            };
            self.open(view, &opening, is_next)
        };
        self.plan.faces.push(Face {
            view: of,
            pose,
            is_portal: false,
            kind,
        });
    }

    /// Lists a portal as triangles, if the view shows it, and opens the view behind it.
    fn look_into(&mut self, (of, view): (usize, &View), number: usize) {
        let portal = &self.space.portals()[number];
        let partner = &self.space.portals()[portal.portal.to];
        let front = portal.before(view.origin) > 0.0;
        // What lies in the plane of a portal is hidden by it.
        let slack = PLANE * (1.0 + partner.portal.at.abs().max_element());
        let is_beyond = view.cut.is_none_or(|(n, d)| {
            portal
                .corners
                .iter()
                .any(|corner| n.dot(*corner) > d + slack)
        });
        if portal.stack != view.stack || !portal.is_open(front) || !is_beyond {
            return;
        }
        let onward = partner.normal * if front { 1.0 } else { -1.0 };
        let carry = portal.map.matrix3 * view.carry;
        let behind = View {
            stack: partner.stack,
            carry,
            turn: DMat3::from_quat(portal.turn) * view.turn,
            scale: portal.scale * view.scale,
            passed: view.passed + 1,
            left: Some((portal.portal.to, front)),
            origin: portal.map.transform_point3(view.origin),
            cut: Some((onward, onward.dot(partner.portal.at) + slack)),
            ..view.clone()
        };
        let is_tidy = partner.stack.iter().all(|number| self.tidy[number]);
        let corners = portal.corners.clone();
        let kind = self.open(view, &Opening { corners, behind }, is_tidy);
        let corners = &portal.corners;
        for (a, b) in corners.iter().zip(&corners[1..]).skip(1) {
            self.plan.faces.push(Face {
                view: of,
                pose: triangle_pose([corners[0], *a, *b]),
                is_portal: true,
                kind,
            });
        }
    }

    /// The view through an opening, if there may be one more.
    fn open(&mut self, view: &View, opening: &Opening, is_known: bool) -> Kind {
        let number = self.plan.views.len();
        let level = view.level + 1;
        let has_room = level < self.limits.levels && number < self.limits.views;
        let Some(extent) = extent(view, &opening.corners).filter(|_| has_room && is_known) else {
            return Kind::Rays;
        };
        self.plan.views.push(View {
            level,
            extent,
            rows: self.rows(opening.behind.carry),
            ..opening.behind.clone()
        });
        Kind::Door(number)
    }
}

/// Takes a square from -1 to 1 to a face of a box, the third axis outwards.
fn face_pose(placed: &Placed, axis: usize, is_far: bool) -> DAffine3 {
    let half = placed.aberration.half;
    let (one, other) = ((axis + 1) % 3, (axis + 2) % 3);
    let [out, one, other] = [axis, one, other].map(|i| placed.axes.col(i) * half[i]);
    let out = if is_far { out } else { -out };
    DAffine3 {
        matrix3: DMat3::from_cols(one, other, out),
        translation: placed.aberration.centre + out,
    }
}

/// Takes the corners (-1, -1), (1, -1) and (1, 1) to those of a triangle.
fn triangle_pose([a, b, c]: [DVec3; 3]) -> DAffine3 {
    let (one, other) = (0.5 * (b - a), 0.5 * (c - b));
    DAffine3 {
        matrix3: DMat3::from_cols(one, other, one.cross(other).normalize_or(DVec3::Z)),
        translation: a + one + other,
    }
}

/// In which part of the picture a polygon lies, as far as the view shows it; none if it does not.
fn extent(view: &View, corners: &[DVec3]) -> Option<(DVec2, DVec2)> {
    let corners: Vec<_> = corners
        .iter()
        .map(|corner| DVec3::from_array(view.rows.map(|row| row.dot(*corner - view.origin))))
        .collect();
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let mut reach = |p: DVec3| {
        let place = p.truncate() / p.z;
        (low, high) = (low.min(place), high.max(place));
    };
    for (at, corner) in corners.iter().enumerate() {
        let next = corners[(at + 1) % corners.len()];
        if corner.z >= NEAR_M {
            reach(*corner);
        }
        if (corner.z >= NEAR_M) != (next.z >= NEAR_M) {
            let share = (NEAR_M - corner.z) / (next.z - corner.z);
            reach(corner.lerp(next, share));
        }
    }
    let (low, high) = (low.max(view.extent.0), high.min(view.extent.1));
    low.cmple(high).all().then_some((low, high))
}

#[cfg(test)]
mod tests;
