//! Whether a picture is drawn by a raster or by rays alone.

use antipode_deformation::{Space, Traveller};
use glam::DVec3;

use crate::options::View;
use crate::packed::Rule;
use crate::scene::Eye;

/// The eye is so near to a face that a raster would cut the face away, felt metres.
const NEAR_FACE_M: f64 = 2e-3;

/// How a picture is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Every pixel by rays.
    Rays,
    /// By a raster in coordinates of the scene.
    Plain,
    /// By a raster that sees through doors; what is behind other faces by rays.
    Doors,
}

impl Way {
    /// The rule that light goes by in it.
    pub fn rule(self) -> Rule {
        match self {
            Self::Plain => Rule::Plain,
            Self::Rays | Self::Doors => Rule::Exact,
        }
    }
}

/// What of a picture the choice depends on.
#[derive(Clone, Copy, Debug)]
pub struct Sight<'a> {
    /// By which rule one looks.
    pub view: View,
    /// Whether outlines of aberrations are drawn: only rays know them.
    pub outlines: bool,
    /// All aberrations.
    pub space: &'a Space,
    /// Which of them are tunnels that a raster sees through; see [`super::tidy`].
    pub tidy: &'a [bool],
    /// Whoever looks.
    pub eye: &'a Eye,
}

/// How a picture is made best.
pub fn way(sight: &Sight<'_>) -> Way {
    match sight.view {
        _ if sight.outlines || sight.eye.parallel_m.is_some() => Way::Rays,
        View::Plain if sight.space.portals().is_empty() => Way::Plain,
        View::Exact if !(is_in_bend(sight) || is_at_face(sight) || is_at_portal(sight)) => {
            Way::Doors
        }
        _ => Way::Rays,
    }
}

/// Whether the eye is in an aberration that a raster does not see out of.
fn is_in_bend(sight: &Sight<'_>) -> bool {
    let stack = &sight.eye.place.stack;
    stack.iter().any(|number| !sight.tidy[number])
}

/// Whether a face of an aberration is right before the eye.
fn is_at_face(sight: &Sight<'_>) -> bool {
    let Sight { space, eye, .. } = sight;
    let stack = &eye.place.stack;
    let k = space.squeeze(stack, eye.front, &Traveller::Body);
    let own = stack.innermost();
    let faces = space.entrances(stack).iter().map(|it| usize::from(*it));
    faces.chain(own).any(|number| {
        let placed = &space.placed()[number];
        let local = placed.local(eye.place.point);
        let away = local.abs() - placed.aberration.half;
        // Felt metres to the plane of a face of normal n: its metres by the length of K^T n.
        let felt = DVec3::from_array(std::array::from_fn(|axis| {
            let scale = (k.transpose() * placed.axes.col(axis)).length();
            away[axis] / scale.max(1e-12)
        }));
        felt.max_element().abs() < NEAR_FACE_M * eye.place.scale
    })
}

/// Whether a portal is right before the eye, or the eye beside it in its plane.
fn is_at_portal(sight: &Sight<'_>) -> bool {
    let Sight { space, eye, .. } = sight;
    let point = eye.place.point;
    let k = space.squeeze(&eye.place.stack, eye.front, &Traveller::Body);
    space.portals().iter().any(|portal| {
        let felt_m = portal.before(point).abs() / (k.transpose() * portal.normal).length();
        let farthest = |from: DVec3| {
            let reach = portal.corners.iter().map(|corner| corner.distance(from));
            reach.fold(0.0, f64::max)
        };
        let is_near = farthest(point) < 3.0 * farthest(portal.portal.at);
        is_near && felt_m < NEAR_FACE_M * eye.place.scale
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_deformation::{Aberration, Place, Portal, Sides};
    use glam::{DQuat, DVec2};

    use super::*;
    use crate::raster::tidy;

    /// A tunnel along z about the origin, 2 by 2 by 8 m, and a soft box 20 m to the right of it.
    fn space() -> Space {
        let half = DVec3::new(1.0, 1.0, 4.0);
        let tunnel = Aberration::tunnel(DVec3::ZERO, DQuat::IDENTITY, half, 2, 40.0);
        let soft = Aberration {
            centre: 20.0 * DVec3::X,
            sides: Sides::Soft,
            ..tunnel.clone()
        };
        Space::new(vec![tunnel, soft]).unwrap()
    }

    fn chosen(view: View, outlines: bool, from: DVec3) -> Way {
        let space = space();
        let eye = Eye::looking(Place::at(&space, from), DVec3::NEG_Z, DVec3::Y, 1.0);
        way(&Sight {
            view,
            outlines,
            space: &space,
            tidy: &tidy(&space),
            eye: &eye,
        })
    }

    #[test]
    fn a_raster_draws_what_it_can() {
        let (before, within, soft) = (9.0 * DVec3::Z, DVec3::Z, 20.0 * DVec3::X);
        assert_eq!(chosen(View::Exact, false, before), Way::Doors);
        assert_eq!(chosen(View::Exact, false, within), Way::Doors);
        assert_eq!(chosen(View::Plain, false, soft), Way::Plain);
    }

    #[test]
    fn rays_draw_the_rest() {
        let (before, soft) = (9.0 * DVec3::Z, 20.0 * DVec3::X);
        assert_eq!(chosen(View::Exact, false, soft), Way::Rays);
        assert_eq!(chosen(View::Exact, true, before), Way::Rays);
        assert_eq!(chosen(View::Plain, true, before), Way::Rays);
        assert_eq!(chosen(View::Thesis, false, before), Way::Rays);
        assert_eq!(chosen(View::Split, false, before), Way::Rays);
    }

    #[test]
    fn who_stands_in_a_door_sees_by_rays() {
        assert_eq!(chosen(View::Exact, false, 4.001 * DVec3::Z), Way::Rays);
        assert_eq!(chosen(View::Exact, false, 4.01 * DVec3::Z), Way::Doors);
        // Inside, a millimetre feels like five.
        assert_eq!(chosen(View::Exact, false, 3.9999 * DVec3::Z), Way::Rays);
        assert_eq!(chosen(View::Exact, false, 3.999 * DVec3::Z), Way::Doors);
        // The plane of a door beside the door is nothing.
        let beside = DVec3::new(3.0, 0.0, 4.0);
        assert_eq!(chosen(View::Exact, false, beside), Way::Doors);
    }

    #[test]
    fn portals_are_seen_through_but_not_from_within() {
        let portal = |x: f64, to: usize| Portal {
            name: format!("to {to}"),
            at: x * DVec3::X,
            turn: DQuat::IDENTITY,
            polygon: Portal::rectangle(DVec2::ONE),
            to,
            two_sided: false,
        };
        let space = Space::with_portals(Vec::new(), vec![portal(0.0, 1), portal(9.0, 0)]).unwrap();
        let by = |view, from: DVec3| {
            let eye = Eye::looking(Place::at(&space, from), DVec3::NEG_X, DVec3::Y, 1.0);
            way(&Sight {
                view,
                outlines: false,
                space: &space,
                tidy: &[],
                eye: &eye,
            })
        };
        assert_eq!(by(View::Exact, 3.0 * DVec3::X), Way::Doors);
        assert_eq!(by(View::Exact, 0.001 * DVec3::X), Way::Rays);
        assert_eq!(by(View::Plain, 3.0 * DVec3::X), Way::Rays);
    }
}
