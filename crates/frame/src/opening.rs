//! A door in a picture: where it stands, and the view that is seen through it.

use antipode_geometry::doorway::{BELOW_FOOT_M, HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{Doorway, Leaf};
use glam::{DMat3, DVec3, DVec4};

use crate::View;

/// Land that is seen through a leaf begins so far before the other one, metres: where the ground there lies higher than its sill,
/// that ground is seen and no hole under it.
const BEGINS_BEFORE_M: f64 = 0.4;
/// Figures begin so far behind it, metres: what rounding leaves of who stands before it is no speck in the opening.
const FIGURES_BEGIN_M: f64 = 0.003;

/// A leaf of a pair of doors, and what is seen through it.
#[derive(Clone, Debug)]
pub struct Opening {
    /// The leaf that is looked through.
    pub leaf: Leaf,
    /// How high the ground of the other side is along its lower edge, from the left of who looks along the leaf's front to the right,
    /// metres over the foot. Below that nothing is seen through it.
    pub sill_m: [f64; Opening::SILLS],
    /// The view of the other side, by the isometry of the space; cut off at the other leaf.
    pub view: View,
    /// What the same leaf shows where that view sees it once more.
    pub again: Option<Box<View>>,
}

impl Opening {
    /// Places along the lower edge where its height is told, evenly from post to post.
    pub const SILLS: usize = 11;

    /// What a picture's view shows through each leaf of a pair.
    pub fn all(view: &View, doors: &Doorway) -> [Self; 2] {
        [0, 1].map(|leaf| {
            let once = Self::of(view, doors, leaf);
            let again = Self::of(&once.view, doors, leaf).view;
            Self {
                again: Some(Box::new(again)),
                ..once
            }
        })
    }

    fn of(view: &View, doors: &Doorway, leaf: usize) -> Self {
        let (near, far) = (doors.leaves[leaf], doors.leaves[1 - leaf]);
        let through = doors.eye(&*view.strategy, leaf, &view.eye);
        let here = view.strategy.carry_near(view.eye.point, near.foot);
        let is_before = here.is_none_or(|it| near.local(it.point.pos).x < 0.0);
        let mut view = View {
            eye: through,
            hand: None,
            ..view.clone()
        };
        let ahead = if is_before { 1.0 } else { -1.0 };
        view.cuts[0] = sheet(&view, &far, -ahead * BEGINS_BEFORE_M, ahead);
        view.figure_cut = sheet(&view, &far, ahead * FIGURES_BEGIN_M, ahead);
        Self {
            leaf: near,
            sill_m: [-BELOW_FOOT_M; Self::SILLS],
            view,
            again: None,
        }
    }
}

/// The covector of view coordinates that is 0 in a leaf, and positive on the side that its front looks to, or on the other.
pub fn sheet_behind(view: &View, leaf: &Leaf, is_in_front: bool) -> DVec4 {
    sheet(view, leaf, 0.0, if is_in_front { 1.0 } else { -1.0 })
}

/// The covector of view coordinates that is 0 on the sheet through the lower corners of a leaf and the middle of its upper edge, but
/// so far along its front from them, metres, and positive on one side: `ahead` is 1 for that which the front looks to, and -1 for the
/// other.
///
/// Geodesic planes are where a linear form of the model's four coordinates is 0, so three points decide it up to its
/// sign: its components are the minors of the three vectors. Where a leaf is no geodesic plane, as through a hyperbolic
/// lens, the sheet is right at the sill, where land meets it, and strays from the leaf's by centimetres.
fn sheet(view: &View, leaf: &Leaf, at_m: f64, ahead: f64) -> DVec4 {
    let at = |x: f64, y: f64, z: f64| view.point(leaf.place(DVec3::new(x, y, z)));
    let [a, b, c] = [
        at(at_m, 0.0, -HALF_WIDTH_M),
        at(at_m, 0.0, HALF_WIDTH_M),
        at(at_m, HEIGHT_M, 0.0),
    ];
    let minor = |without: usize| {
        let rest = |v: DVec4| {
            let mut kept = v.to_array().into_iter().enumerate();
            let mut next = || loop {
                match kept.next() {
                    Some((at, _)) if at == without => {}
                    Some((_, value)) => break value,
                    None => break 0.0,
                }
            };
            DVec3::new(next(), next(), next())
        };
        let sign = if without.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * DMat3::from_cols(rest(a), rest(b), rest(c)).determinant()
    };
    let covector = DVec4::new(minor(0), minor(1), minor(2), minor(3));
    let side = covector.dot(at(ahead, 0.5 * HEIGHT_M, 0.0));
    let size = covector.abs().max_element().max(f64::MIN_POSITIVE);
    covector * (side.signum() / size)
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, ChartPoint, Eye, Geometry, Projection, strategy};

    use super::*;

    #[test]
    fn what_lies_beyond_the_other_leaf_is_shown_and_what_lies_before_it_is_cut_off() {
        for geometry in Geometry::ALL {
            let radius_m = match geometry {
                Geometry::HyperbolicWorld => 60.305,
                _ => 32.0,
            };
            let space = strategy(geometry, radius_m);
            let second = if geometry == Geometry::Spherical {
                ChartId::SECOND
            } else {
                ChartId::FIRST
            };
            let leaf = |chart, pos, yaw| Leaf::at(&*space, ChartPoint::new(chart, pos), yaw);
            let doors = Doorway {
                leaves: [
                    leaf(ChartId::FIRST, DVec3::new(20.0, 8.0, 3.0), 0.3),
                    leaf(second, DVec3::new(-30.0, 11.0, 25.0), -2.0),
                ],
            };
            for (which, side) in [(0, -2.0), (0, 2.0), (1, -3.0), (1, 1.0)] {
                let eye = Eye {
                    point: doors.leaves[which].place(DVec3::new(side, 1.6, 0.4)),
                    yaw: 1.0,
                    dial: 8.0,
                    lift_m: 1.6,
                    ..Eye::default()
                };
                let projection = Projection::new(1.2, 1.5, 0.02);
                let own = View::new(eye, projection, space.clone());
                let opening = &Opening::all(&own, &doors)[which];
                assert_eq!(opening.leaf, doors.leaves[which]);
                let far = doors.leaves[1 - which];
                let at = |x: f64, y, z| {
                    let seen = opening.view.point(far.place(DVec3::new(x, y, z)));
                    opening.view.cuts[0].dot(seen)
                };
                // Who looks from one side sees what lies on the other.
                for (y, z) in [(0.2, -0.9), (1.0, 0.0), (0.2, 0.9), (1.9, 0.3)] {
                    assert!(at(-0.1 * side, y, z) > 0.0, "{geometry} {which} {side}");
                    let before_m = BEGINS_BEFORE_M * side.signum();
                    assert!(at(0.9 * before_m, y, z) > 0.0, "{geometry} {which} {side}");
                    assert!(at(1.1 * before_m, y, z) < 0.0, "{geometry} {which} {side}");
                }
            }
        }
    }
}
