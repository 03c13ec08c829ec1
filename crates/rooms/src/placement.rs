//! How boxes may lie to one another: apart, one in the other, or partly in one another where their axes are parallel.
//!
//! Stretches of boxes whose axes are parallel are diagonal in one frame, so their product does not depend on the order in
//! which a ray leaves them. Boxes that are turned to each other have to be nested, or that order would be seen.

use glam::{DMat3, DQuat, DVec3};

use crate::bounds::MOST_DEEP;

/// Boxes that come nearer than this only touch, metres.
pub const TOUCH_M: f64 = 1e-6;
/// How much the cosine between parallel axes may lack of 1.
const PARALLEL: f64 = 1e-9;

/// A box: where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Its middle, metres.
    pub centre: DVec3,
    /// From its own axes to the room's.
    pub rotation: DQuat,
    /// Half its lengths along its own axes, metres.
    pub half: DVec3,
}

/// How two boxes lie to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// They have no inside in common; they may touch.
    Apart,
    /// The first lies in the second.
    Within,
    /// The second lies in the first.
    Around,
    /// They lie partly in one another.
    Across {
        /// Whether their axes are parallel.
        parallel: bool,
    },
}

/// Boxes that lie to one another as they may not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Misplaced {
    /// These two, by their place in the list, lie partly in one another and are turned.
    Turned(usize, usize),
    /// This one and eight before it lie all in one another.
    TooDeep(usize),
}

/// How two boxes lie to each other. Equal ones are `Within`.
pub fn relation(a: &Place, b: &Place) -> Relation {
    let [axes_a, axes_b] = [a, b].map(|it| DMat3::from_quat(it.rotation));
    let between = b.centre - a.centre;
    // The cosines between the axes of the two: entry (i, j) is that of a's axis i and b's axis j.
    let cosines = axes_a.transpose() * axes_b;
    if are_apart(a, b, &cosines, axes_a.transpose() * between) {
        return Relation::Apart;
    }
    if lies_in(
        a.half,
        b.half,
        &cosines.transpose(),
        axes_b.transpose() * -between,
    ) {
        return Relation::Within;
    }
    if lies_in(b.half, a.half, &cosines, axes_a.transpose() * between) {
        return Relation::Around;
    }
    let is_aligned = |axis: DVec3| axis.abs().max_element() >= 1.0 - PARALLEL;
    let parallel = [cosines.x_axis, cosines.y_axis, cosines.z_axis]
        .into_iter()
        .all(is_aligned);
    Relation::Across { parallel }
}

/// Whether some plane is between two boxes: S. Gottschalk, M. C. Lin and D. Manocha, *OBBTree* (1996), section 5. If
/// there is one, there is one across an axis of either or a product of an axis of each; `between` is in a's axes.
fn are_apart(a: &Place, b: &Place, cosines: &DMat3, between: DVec3) -> bool {
    let of_b = [cosines.x_axis, cosines.y_axis, cosines.z_axis];
    let separates = |axis: DVec3| {
        let reach = a.half.dot(axis.abs())
            + (0..3)
                .map(|j| b.half[j] * of_b[j].dot(axis).abs())
                .sum::<f64>();
        between.dot(axis).abs() >= reach - TOUCH_M
    };
    let crossed = DVec3::AXES
        .into_iter()
        .flat_map(|i| of_b.map(|j| i.cross(j)));
    DVec3::AXES.into_iter().chain(of_b).any(separates)
        // Products of parallel axes are nothing, and tell nothing.
        || crossed.filter_map(DVec3::try_normalize).filter(|it| it.is_finite()).any(separates)
}

/// Whether a box of half sizes `inner` lies in one of `outer`: `axes` are its axes and `centre` its middle in those of
/// the outer. Its farthest corner along the outer's axis i is at |centre_i| + sum over j of inner_j |axes_ij|.
fn lies_in(inner: DVec3, outer: DVec3, axes: &DMat3, centre: DVec3) -> bool {
    let reach =
        axes.x_axis.abs() * inner.x + axes.y_axis.abs() * inner.y + axes.z_axis.abs() * inner.z;
    (centre.abs() + reach).cmple(outer + TOUCH_M).all()
}

/// Whether boxes lie to one another as they may, at most 8 deep.
///
/// # Errors
/// The first that do not.
pub fn check_places(places: &[Place]) -> Result<(), Misplaced> {
    let mut meets = vec![vec![false; places.len()]; places.len()];
    for (second, b) in places.iter().enumerate() {
        for (first, a) in places[..second].iter().enumerate() {
            match relation(a, b) {
                Relation::Apart => {}
                Relation::Across { parallel: false } => {
                    return Err(Misplaced::Turned(first, second));
                }
                _ => meets[second][first] = true,
            }
        }
    }
    let is_too_deep = |index: &usize| {
        let before: Vec<usize> = (0..*index).filter(|it| meets[*index][*it]).collect();
        is_deeper(&before, &meets, MOST_DEEP)
    };
    match (0..places.len()).find(is_too_deep) {
        Some(index) => Err(Misplaced::TooDeep(index)),
        None => Ok(()),
    }
}

/// Whether there are `deep` among `candidates` that all lie in one another. Each is looked at as the last of its set, so
/// that every set is met once; boxes of three dimensions keep the number of sets polynomial.
fn is_deeper(candidates: &[usize], meets: &[Vec<bool>], deep: usize) -> bool {
    if candidates.len() < deep || deep == 0 {
        return deep == 0;
    }
    candidates.iter().enumerate().rev().any(|(at, last)| {
        let before = candidates[..at].iter().copied();
        let left: Vec<usize> = before.filter(|it| meets[*last][*it]).collect();
        is_deeper(&left, meets, deep - 1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn at(x: f64, half: f64) -> Place {
        Place {
            centre: DVec3::new(x, 0.0, 0.0),
            rotation: DQuat::IDENTITY,
            half: DVec3::splat(half),
        }
    }

    fn turned(place: Place, degrees: f64) -> Place {
        Place {
            rotation: DQuat::from_rotation_y(degrees.to_radians()),
            ..place
        }
    }

    #[test]
    fn boxes_are_apart_touch_nest_or_cross() {
        assert_eq!(relation(&at(0.0, 1.0), &at(3.0, 1.0)), Relation::Apart);
        assert_eq!(
            relation(&at(0.0, 1.0), &at(2.0, 1.0)),
            Relation::Apart,
            "faces that touch"
        );
        assert_eq!(
            relation(&at(0.0, 1.0), &at(1.9, 1.0)),
            Relation::Across { parallel: true }
        );
        assert_eq!(relation(&at(0.5, 0.5), &at(0.0, 1.0)), Relation::Within);
        assert_eq!(relation(&at(0.0, 1.0), &at(0.5, 0.5)), Relation::Around);
        // The corners of a cube turned by 45 degrees reach sqrt 2.
        assert_eq!(
            relation(&turned(at(0.0, 1.0), 45.0), &at(2.3, 1.0)),
            Relation::Across { parallel: false }
        );
        assert_eq!(
            relation(&turned(at(0.0, 1.0), 45.0), &at(2.5, 1.0)),
            Relation::Apart
        );
        assert_eq!(
            relation(&turned(at(0.0, 0.7), 45.0), &at(0.0, 1.0)),
            Relation::Within
        );
        assert_eq!(
            relation(&turned(at(0.0, 0.72), 45.0), &at(0.0, 1.0)),
            Relation::Across { parallel: false }
        );
        // A quarter turn puts axes on axes.
        assert_eq!(
            relation(&turned(at(1.0, 1.0), 90.0), &at(0.0, 1.0)),
            Relation::Across { parallel: true }
        );
    }

    #[test]
    fn edges_across_edges_are_told_apart() {
        // Two bars that pass each other, one over the other, both turned: only a product of edges parts them.
        let bar = |y: f64, rotation: DQuat| Place {
            centre: DVec3::Y * y,
            rotation,
            half: DVec3::new(5.0, 0.1, 0.1),
        };
        let first = DQuat::from_rotation_x(45_f64.to_radians());
        let second = DQuat::from_rotation_y(90_f64.to_radians()) * first;
        let reach = 2.0 * 0.1 * 2_f64.sqrt();
        assert_eq!(
            relation(&bar(0.0, first), &bar(reach + 0.01, second)),
            Relation::Apart
        );
        assert_ne!(
            relation(&bar(0.0, first), &bar(reach - 0.01, second)),
            Relation::Apart
        );
    }

    #[test]
    fn eight_deep_is_allowed_and_nine_is_not() {
        let nested: Vec<_> = (1..=9).map(|it| at(0.0, f64::from(it))).collect();
        assert_eq!(check_places(&nested[..8]), Ok(()));
        assert_eq!(check_places(&nested), Err(Misplaced::TooDeep(8)));
        let chain: Vec<_> = (0..200).map(|it| at(f64::from(it), 3.99)).collect();
        assert_eq!(
            check_places(&chain),
            Ok(()),
            "each meets the seven on either side"
        );
        let wider: Vec<_> = (0..200).map(|it| at(f64::from(it), 4.01)).collect();
        assert_eq!(check_places(&wider), Err(Misplaced::TooDeep(8)));
        let across = [at(0.0, 1.0), turned(at(1.0, 1.0), 30.0)];
        assert_eq!(check_places(&across), Err(Misplaced::Turned(0, 1)));
    }

    #[test]
    fn as_many_slabs_as_there_may_be_are_checked_soon() {
        // Slabs across three axes, up to three, three and two in one another: the most sets that boxes can make.
        let slabs: Vec<Place> = (0..255)
            .map(|it| {
                let (axis, step) = ((it % 3) as usize, f64::from(it / 3));
                let mut half = DVec3::splat(500.0);
                half[axis] = [1.4, 1.4, 0.9][axis];
                let mut centre = DVec3::ZERO;
                centre[axis] = step;
                Place {
                    centre,
                    rotation: DQuat::IDENTITY,
                    half,
                }
            })
            .collect();
        assert_eq!(check_places(&slabs), Ok(()));
    }

    fn place() -> impl Strategy<Value = Place> {
        let vector = || prop::array::uniform3(-2.0..2.0_f64).prop_map(DVec3::from);
        let half = prop::array::uniform3(0.1..2.0_f64).prop_map(DVec3::from);
        (vector(), vector(), half).prop_map(|(centre, turn, half)| Place {
            centre,
            rotation: DQuat::from_scaled_axis(turn),
            half,
        })
    }

    proptest! {
        #[test]
        fn points_know_how_boxes_lie(a in place(), b in place(), points in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 200)) {
            let holds = |it: &Place, point: DVec3| {
                (it.rotation.inverse() * (point - it.centre)).abs().cmple(it.half - 1e-9).all()
            };
            let of = |it: &Place, point: [f64; 3]| it.centre + it.rotation * (DVec3::from(point) * it.half);
            let relation = relation(&a, &b);
            for point in points {
                let shared = holds(&b, of(&a, point)) && holds(&a, of(&a, point));
                prop_assert!(!(shared && relation == Relation::Apart), "they have a point in common");
                if relation == Relation::Within {
                    let wider = Place { half: b.half + 1e-5, ..b };
                    prop_assert!(holds(&wider, of(&a, point)));
                }
            }
            let other = super::relation(&b, &a);
            let mirrored = match relation {
                Relation::Within => Relation::Around,
                Relation::Around => Relation::Within,
                same => same,
            };
            prop_assert_eq!(other, mirrored);
        }
    }
}
