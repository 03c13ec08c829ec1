//! What solid surrounds who is near a portal: of the near side nothing that lies behind the opening, and of the far side what does.
//!
//! Behind the opening means behind its plane and within the prism over the polygon. So a portal on a wall is a hole in it, whose
//! edges are met. G is affine and felt lengths agree on both sides, so what is beyond is carried here by its inverse.

use glam::DVec3;

use crate::place::Place;
use crate::portal::PlacedPortal;
use crate::scene::SceneQuery;
use crate::space::Space;

/// What lies within this of a portal's plane, or of the sides of its prism, counts as in it, metres.
const IN_PLANE_M: f64 = 1e-6;

/// A portal near by, and from which side it is gone into.
struct Opening<'a> {
    portal: &'a PlacedPortal,
    /// 1 from before its front, -1 from behind.
    sign: f64,
}

/// Shows the triangles between two corners as somebody at a place meets them, and whether they are solid from both sides.
pub fn show_cut(
    space: &Space,
    scene: &dyn SceneQuery,
    place: &Place,
    (low, high): (DVec3, DVec3),
    show: &mut dyn FnMut([DVec3; 3], bool),
) {
    let openings = openings(space, place, low, high);
    if openings.is_empty() {
        scene.near(low, high, &mut |corners| show(corners, false));
        space.walls_near(low, high, &mut |corners| show(corners, true));
        return;
    }
    let mut keep = |corners: [DVec3; 3], two_sided: bool| {
        let whole = vec![corners.to_vec()];
        let pieces = openings.iter().fold(whole, |pieces, opening| {
            pieces.iter().flat_map(|it| opening.without(it)).collect()
        });
        for piece in &pieces {
            fan(piece, two_sided, show);
        }
    };
    scene.near(low, high, &mut |corners| keep(corners, false));
    space.walls_near(low, high, &mut |corners| keep(corners, true));
    for opening in &openings {
        opening.show_beyond(space, scene, (low, high), show);
    }
}

/// What of a convex polygon lies at 0 and above by a height that is linear in the place; nothing where less than a triangle does.
pub fn half(polygon: &[DVec3], height: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    split(polygon, height).0
}

fn openings<'a>(space: &'a Space, place: &Place, low: DVec3, high: DVec3) -> Vec<Opening<'a>> {
    let near = |portal: &PlacedPortal| {
        let (from, to) = bounds(portal.corners.iter().copied());
        from.cmple(high).all() && to.cmpge(low).all()
    };
    space
        .portals()
        .iter()
        .enumerate()
        .filter(|(_, portal)| near(portal))
        .map(|(number, portal)| {
            let front = portal.side(number, place.point, -portal.normal, place.passage);
            (portal, front)
        })
        .filter(|(portal, front)| portal.is_open(*front))
        .map(|(portal, front)| Opening {
            portal,
            sign: if front { 1.0 } else { -1.0 },
        })
        .collect()
}

impl Opening<'_> {
    /// How far before the opening's plane a place is, seen from where it is gone into.
    fn before(&self, point: DVec3) -> f64 {
        self.sign * self.portal.before(point)
    }

    /// How far within an edge of the polygon a place is.
    fn within(&self, edge: &DVec3, point: DVec3) -> f64 {
        edge.truncate().dot(self.portal.local(point)) - edge.z
    }

    /// What of a convex polygon does not lie behind the opening.
    fn without(&self, polygon: &[DVec3]) -> Vec<Vec<DVec3>> {
        let (before, mut behind) = split(polygon, |it| self.before(it) - IN_PLANE_M);
        let mut kept = vec![before];
        for edge in &self.portal.edges {
            let (inside, outside) = split(&behind, |it| self.within(edge, it) - IN_PLANE_M);
            kept.push(outside);
            behind = inside;
        }
        kept.retain(|it| it.len() > 2);
        kept
    }

    /// What of a convex polygon of the far side, carried to this one, is seen through the opening.
    fn only(&self, polygon: &[DVec3]) -> Vec<DVec3> {
        let (mut behind, _) = split(polygon, |it| -self.before(it) - IN_PLANE_M);
        for edge in &self.portal.edges {
            (behind, _) = split(&behind, |it| self.within(edge, it) + IN_PLANE_M);
        }
        behind
    }

    fn show_beyond(
        &self,
        space: &Space,
        scene: &dyn SceneQuery,
        (low, high): (DVec3, DVec3),
        show: &mut dyn FnMut([DVec3; 3], bool),
    ) {
        let (map, back) = (self.portal.map, self.portal.map.inverse());
        let corner = |i: i32| {
            let of = |bit: i32, axis: usize| if i & bit == 0 { low[axis] } else { high[axis] };
            map.transform_point3(DVec3::new(of(1, 0), of(2, 1), of(4, 2)))
        };
        let (from, to) = bounds((0..8).map(corner));
        let mut look = |corners: [DVec3; 3], two_sided: bool| {
            let here = corners.map(|it| back.transform_point3(it));
            fan(&self.only(&here), two_sided, show);
        };
        scene.near(from, to, &mut |corners| look(corners, false));
        space.walls_near(from, to, &mut |corners| look(corners, true));
    }
}

fn bounds(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points.fold(none, |(low, high), it| (low.min(it), high.max(it)))
}

fn fan(polygon: &[DVec3], two_sided: bool, show: &mut dyn FnMut([DVec3; 3], bool)) {
    for pair in polygon.windows(2).skip(1) {
        show([polygon[0], pair[0], pair[1]], two_sided);
    }
}

/// Parts a convex polygon by a plane: what is at 0 and above, and what is below (I. Sutherland and G. Hodgman, 1974).
fn split(polygon: &[DVec3], height: impl Fn(DVec3) -> f64) -> (Vec<DVec3>, Vec<DVec3>) {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let (from, to) = (height(*a), height(b));
        if from >= 0.0 {
            above.push(*a);
        } else {
            below.push(*a);
        }
        if (from >= 0.0) != (to >= 0.0) {
            let cut = a.lerp(b, from / (from - to));
            above.push(cut);
            below.push(cut);
        }
    }
    let whole = |it: Vec<DVec3>| if it.len() > 2 { it } else { Vec::new() };
    (whole(above), whole(below))
}
