//! Portals: pairs of polygons through each of which one sees and goes out of the other.
//!
//! A portal's own axes are as in rooms: its front is +x, and who looks at its front has +y above and -z to the right. Who goes
//! into its front comes out of its partner's front, upright as it was to the one: O takes the felt normal n1 to -n2 and the felt
//! up u1 to u2, which is a turn and never a mirror. With A = K^-1 at each side and q the ratio of the felt sizes, the map of
//! the scene is x -> G x = c2 + q K2 O A1 (x - c1). A traveller of felt direction w and scale m has v1 = m K1 w; behind the
//! portal its direction is O w and its scale m q, so that v2 = m q K2 O w = (q K2 O A1) v1: G takes its path to its path.

use std::f64::consts::TAU;

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};

use crate::place::Passage;
use crate::space::Traveller;
use crate::stack::Stack;

/// Portals that a space has at most.
pub const MAX_PORTALS: usize = 64;
/// Corners that a portal has at most.
pub const MAX_CORNERS: usize = 16;
/// A place as near to a portal's plane as this, as a share of its numbers, may lie on either side.
const ON_PLANE: f64 = 1e-12;

/// A portal as it is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Portal {
    /// What messages call it.
    pub name: String,
    /// The origin of its plane, metres of the scene; its partner's lies behind it.
    pub at: DVec3,
    /// Turns its own axes into the scene's; of length 1.
    pub turn: DQuat,
    /// Corners of a convex polygon, metres of the scene to the right and up, as who looks at its front sees them.
    pub polygon: Vec<DVec2>,
    /// The number of its partner, which has to lead back to it; it may be its own.
    pub to: usize,
    /// Whether its back leads to the back of its partner. Else there is nothing to who comes from behind: it passes.
    pub two_sided: bool,
}

impl Portal {
    /// The corners of a rectangle about a portal's origin.
    pub fn rectangle(size: DVec2) -> Vec<DVec2> {
        let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
        corners.map(|(a, b)| size * DVec2::new(a, b)).to_vec()
    }
}

/// A portal with what is worked out of it.
#[derive(Clone, Debug)]
pub struct PlacedPortal {
    /// As it was given, its turn made exactly one of length 1 and its corners counter-clockwise as seen from the front.
    pub portal: Portal,
    /// Out of its front, of length 1 in the scene.
    pub normal: DVec3,
    /// To the right of who looks at its front, of length 1.
    pub right: DVec3,
    /// Upwards in its plane, of length 1.
    pub up: DVec3,
    /// Its corners in metres of the scene, counter-clockwise as seen from the front.
    pub corners: Vec<DVec3>,
    /// The boxes that it stands in.
    pub stack: Stack,
    /// K of those.
    pub squeeze: DMat3,
    /// G: takes places of the scene to where they are as its partner shows them.
    pub map: DAffine3,
    /// O: turns felt directions on the way through.
    pub turn: DQuat,
    /// q: how many times larger who passes is afterwards.
    pub scale: f64,
    /// For each edge its direction inwards in the plane, of length 1, and what a place of the polygon has at least along it.
    pub edges: Vec<DVec3>,
}

impl PlacedPortal {
    /// A portal whose partner is not looked at yet.
    pub(crate) fn new(mut portal: Portal, stack: Stack, squeeze: DMat3) -> Self {
        portal.turn = portal.turn.normalize();
        if area(&portal.polygon) < 0.0 {
            portal.polygon.reverse();
        }
        let turn = DMat3::from_quat(portal.turn);
        let (normal, up, right) = (turn.x_axis, turn.y_axis, -turn.z_axis);
        let on_plane = |it: &DVec2| portal.at + right * it.x + up * it.y;
        let corners = portal.polygon.iter().map(on_plane).collect();
        Self {
            normal,
            right,
            up,
            corners,
            stack,
            squeeze,
            map: DAffine3::IDENTITY,
            turn: DQuat::IDENTITY,
            scale: 1.0,
            edges: edges(&portal.polygon),
            portal,
        }
    }

    /// Felt normal, up and normal x up, each of length 1: K^T n has no product with felt tangents A t.
    fn felt_axes(&self) -> DMat3 {
        let normal = (self.squeeze.transpose() * self.normal).normalize();
        let up = (self.squeeze.inverse() * self.up).normalize();
        DMat3::from_cols(normal, up, normal.cross(up))
    }

    /// Twice the felt area.
    fn felt_area(&self) -> f64 {
        let felt = self.squeeze.inverse();
        let corner = |i: usize| felt * (self.corners[i % self.corners.len()] - self.portal.at);
        let sum: DVec3 = (0..self.corners.len())
            .map(|i| corner(i).cross(corner(i + 1)))
            .sum();
        sum.length()
    }

    /// O, q and G of who goes in here and comes out there.
    pub(crate) fn map_to(&self, partner: &Self) -> (DQuat, f64, DAffine3) {
        let about_up = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, -1.0));
        let turn = partner.felt_axes() * about_up * self.felt_axes().transpose();
        let scale = (partner.felt_area() / self.felt_area()).sqrt();
        let linear = partner.squeeze * turn * self.squeeze.inverse() * scale;
        let translation = partner.portal.at - linear * self.portal.at;
        let map = DAffine3::from_mat3_translation(linear, translation);
        (DQuat::from_mat3(&turn).normalize(), scale, map)
    }

    /// How far off the plane a place is, metres of the scene; above nought before its front.
    pub fn before(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.portal.at)
    }

    /// A place in the plane's own coordinates: to the right and up.
    pub fn local(&self, point: DVec3) -> DVec2 {
        let away = point - self.portal.at;
        DVec2::new(self.right.dot(away), self.up.dot(away))
    }

    /// Whether a place of the plane lies in the polygon.
    pub fn is_in(&self, local: DVec2) -> bool {
        self.edges
            .iter()
            .all(|edge| edge.truncate().dot(local) >= edge.z)
    }

    /// Whether one can go in from before its front, or from behind it.
    pub fn is_open(&self, front: bool) -> bool {
        front || self.portal.two_sided
    }

    /// On which side of the plane somebody is who goes at velocity `v`. On the plane itself who has just come out is on the side
    /// that it came out to, and any other on the side from which it goes on through.
    pub fn side(&self, number: usize, point: DVec3, v: DVec3, passage: Passage) -> bool {
        let before = self.before(point);
        if before.abs() > slack(point) {
            before > 0.0
        } else if passage.is_out_of(number) {
            passage.front
        } else {
            self.normal.dot(v) < 0.0
        }
    }

    /// When a straight path meets it, times from 0, and whether before its front.
    pub(crate) fn meets(
        &self,
        number: usize,
        point: DVec3,
        v: DVec3,
        passage: Passage,
    ) -> Option<(f64, bool)> {
        let front = self.side(number, point, v, passage);
        let across = self.normal.dot(v) * if front { -1.0 } else { 1.0 };
        if across <= 0.0 || !self.is_open(front) {
            return None;
        }
        let off = self.before(point) * if front { 1.0 } else { -1.0 };
        let time = off.max(0.0) / across;
        self.is_in(self.local(point + v * time))
            .then_some((time, front))
    }

    /// A place of its plane as seen from its partner, without rounding across either plane.
    pub(crate) fn passed(&self, partner: &Self, point: DVec3) -> DVec3 {
        let on_plane = point - self.normal * self.before(point);
        let there = self.map.transform_point3(on_plane);
        there - partner.normal * partner.before(there)
    }

    /// Whether a place lies on its plane to rounding.
    pub(crate) fn is_on(&self, point: DVec3) -> bool {
        self.before(point).abs() <= slack(point)
    }

    /// For how long, at velocity `v`, one is so near to its plane that a solid there may lie on either side.
    pub(crate) fn hidden(&self, point: DVec3, v: DVec3) -> f64 {
        2.0 * slack(point) / self.normal.dot(v).abs().max(1e-200)
    }

    /// Whether who passes is turned.
    pub fn is_turned(&self) -> bool {
        self.turn.to_axis_angle().1.abs().min(TAU) > 1e-9
    }

    /// The felt direction before it of light that is of direction `w` behind it.
    pub fn back(&self, w: DVec3) -> DVec3 {
        self.turn.inverse() * w
    }
}

/// Who a portal's boxes are told by: none of them treats travellers differently.
pub const WHO: Traveller = Traveller::Body;

fn slack(point: DVec3) -> f64 {
    ON_PLANE * (1.0 + point.abs().max_element())
}

/// Twice the area of a polygon, above nought where its corners run counter-clockwise.
pub fn area(polygon: &[DVec2]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum()
}

fn edges(polygon: &[DVec2]) -> Vec<DVec3> {
    let next = polygon.iter().cycle().skip(1);
    let inward = |(a, b): (&DVec2, &DVec2)| {
        let n = (*b - *a).perp().normalize_or_zero();
        n.extend(n.dot(*a))
    };
    polygon.iter().zip(next).map(inward).collect()
}
