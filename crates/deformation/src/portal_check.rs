//! What makes portals sound: their shapes, their partners, and what they may not touch.

use glam::{DMat3, DVec2, DVec3};

use crate::aberration::{Sides, Ways};
use crate::error::SpaceError;
use crate::portal::{MAX_CORNERS, MAX_PORTALS, PlacedPortal, Portal, WHO, area};
use crate::space::Space;
use crate::stack::Stack;

/// What a portal keeps off sides of boxes and other portals at least, metres.
const APART_M: f64 = 1e-3;
/// Corners that differ by less than this share of the size are the same.
const SIMILAR: f64 = 1e-5;
/// The least and greatest ratio of sizes.
const SCALES: (f64, f64) = (1.0 / 32.0, 32.0);
const LONGEST_M: f64 = 1e6;
/// The shortest edge, metres.
const SHORTEST_M: f64 = 1e-3;

/// Places portals in a space that has its boxes.
pub fn place_portals(space: &Space, portals: Vec<Portal>) -> Result<Vec<PlacedPortal>, SpaceError> {
    if portals.len() > MAX_PORTALS {
        return Err(SpaceError::TooManyPortals {
            found: portals.len(),
            most: MAX_PORTALS,
        });
    }
    portals.iter().try_for_each(check)?;
    check_partners(&portals)?;
    let mut placed: Vec<_> = portals.into_iter().map(|it| stand(space, it)).collect();
    placed.iter().try_for_each(|it| check_boxes(space, it))?;
    check_apart(&placed)?;
    for number in 0..placed.len() {
        let (here, partner) = (&placed[number], &placed[placed[number].portal.to]);
        let (turn, scale, map) = here.map_to(partner);
        check_similar(here, partner, scale)?;
        let one = &mut placed[number];
        (one.turn, one.scale, one.map) = (turn, scale, map);
    }
    Ok(placed)
}

fn check(portal: &Portal) -> Result<(), SpaceError> {
    let refuse = |what| {
        Err(SpaceError::PortalShape {
            name: portal.name.clone(),
            what,
        })
    };
    let corners = &portal.polygon;
    let is_near = |it: f64| it.is_finite() && it.abs() <= LONGEST_M;
    let is_point = |it: &DVec2| is_near(it.x) && is_near(it.y);
    if !portal.at.to_array().into_iter().all(is_near) || !corners.iter().all(is_point) {
        return refuse("has a place that is no number or out of range");
    }
    let length = portal.turn.length();
    if !(length.is_finite() && (length - 1.0).abs() < 1e-3) {
        return refuse("has a turn that is none");
    }
    if corners.len() < 3 {
        return refuse("has fewer than three corners");
    }
    if corners.len() > MAX_CORNERS {
        return refuse("has more than sixteen corners");
    }
    let corner = |i: usize| corners[i % corners.len()];
    let edge = |i: usize| corner(i + 1) - corner(i);
    let sign = area(corners).signum();
    let mut turned = 0.0;
    for i in 0..corners.len() {
        let (a, b) = (edge(i), edge(i + 1));
        if a.length() < SHORTEST_M {
            return refuse("has an edge shorter than a millimetre");
        }
        if a.perp_dot(b) * sign <= 1e-9 * a.length() * b.length() {
            return refuse("is not convex, or has a corner that is none");
        }
        turned += a.angle_to(b).abs();
    }
    // A star turns more than once.
    if turned > 1.5 * std::f64::consts::TAU {
        return refuse("crosses itself");
    }
    Ok(())
}

fn check_partners(portals: &[Portal]) -> Result<(), SpaceError> {
    if let Some(portal) = portals.iter().find(|it| it.to >= portals.len()) {
        return Err(SpaceError::NoPartner {
            name: portal.name.clone(),
        });
    }
    for (number, portal) in portals.iter().enumerate() {
        let partner = &portals[portal.to];
        if partner.to != number {
            return Err(SpaceError::OneWay {
                name: portal.name.clone(),
                partner: partner.name.clone(),
            });
        }
        if partner.two_sided != portal.two_sided {
            return Err(SpaceError::OtherSides {
                name: portal.name.clone(),
                partner: partner.name.clone(),
            });
        }
    }
    Ok(())
}

fn stand(space: &Space, portal: Portal) -> PlacedPortal {
    let plain = PlacedPortal::new(portal.clone(), Stack::default(), DMat3::IDENTITY);
    let middle = plain.corners.iter().sum::<DVec3>() / plain.corners.len() as f64;
    let stack = space.stack_at(middle);
    let squeeze = space.squeeze(&stack, plain.normal, &WHO);
    PlacedPortal::new(portal, stack, squeeze)
}

fn check_boxes(space: &Space, portal: &PlacedPortal) -> Result<(), SpaceError> {
    let name = || portal.portal.name.clone();
    let around = Ball::about(&portal.corners);
    for (number, placed) in space.placed().iter().enumerate() {
        let aberration = || placed.aberration.name.clone();
        let of_box = Ball {
            middle: placed.aberration.centre,
            radius: placed.aberration.half.length(),
        };
        if around.is_apart_from(&of_box) {
            continue;
        }
        let locals: Vec<_> = portal.corners.iter().map(|it| placed.local(*it)).collect();
        let half = placed.aberration.half;
        let is_inside = locals.iter().all(|it| it.abs().cmple(half - APART_M).all());
        let box_corners: Vec<_> = (0..8)
            .map(|i| {
                let sign = |bit: i32| if i & bit == 0 { -1.0 } else { 1.0 };
                half * DVec3::new(sign(1), sign(2), sign(4))
            })
            .collect();
        let normal = placed.axes.transpose() * portal.normal;
        let axes = DVec3::AXES.to_vec();
        if !is_inside
            && !are_apart(
                &locals,
                &box_corners,
                &[vec![normal], axes.clone()].concat(),
                &axes,
            )
        {
            return Err(SpaceError::OverSide {
                name: name(),
                aberration: aberration(),
            });
        }
        let it = &placed.aberration;
        let is_odd = it.ways != Ways::Both || matches!(it.sides, Sides::Legacy(_));
        if portal.stack.contains(number) && is_odd {
            return Err(SpaceError::InOddBox {
                name: name(),
                aberration: aberration(),
            });
        }
    }
    Ok(())
}

/// A ball of the scene, metres.
struct Ball {
    middle: DVec3,
    radius: f64,
}

impl Ball {
    fn about(corners: &[DVec3]) -> Self {
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let far = corners.iter().map(|it| it.distance(middle));
        Self {
            middle,
            radius: far.fold(0.0, f64::max),
        }
    }

    /// Whether all that lies in both is farther apart than what must be: most of a large room is.
    fn is_apart_from(&self, other: &Self) -> bool {
        self.middle.distance(other.middle) > self.radius + other.radius + APART_M
    }
}

fn check_apart(portals: &[PlacedPortal]) -> Result<(), SpaceError> {
    let balls: Vec<_> = portals.iter().map(|it| Ball::about(&it.corners)).collect();
    for (second, b) in portals.iter().enumerate() {
        for (first, a) in portals[..second].iter().enumerate() {
            if balls[first].is_apart_from(&balls[second]) {
                continue;
            }
            let directions = |it: &PlacedPortal| -> Vec<DVec3> {
                let inward = |e: &DVec3| it.right * e.x + it.up * e.y;
                it.edges.iter().map(inward).chain([it.normal]).collect()
            };
            let along = |it: &PlacedPortal| -> Vec<DVec3> {
                let n = it.normal;
                directions(it).iter().map(|e| e.cross(n)).collect()
            };
            let axes = [directions(a), directions(b)].concat();
            let crossed: Vec<_> = along(a)
                .iter()
                .flat_map(|e| along(b).into_iter().map(move |f| e.cross(f)))
                .collect();
            if !are_apart(&a.corners, &b.corners, &[axes, crossed].concat(), &[]) {
                return Err(SpaceError::PortalsOverlap {
                    first: a.portal.name.clone(),
                    second: b.portal.name.clone(),
                });
            }
        }
    }
    Ok(())
}

/// Whether a direction parts two convex sets of corners (S. Gottschalk's test): one of `axes`, or one across an edge of the
/// first and one of `edges` of the second.
fn are_apart(one: &[DVec3], other: &[DVec3], axes: &[DVec3], edges: &[DVec3]) -> bool {
    let own = one.iter().zip(one.iter().cycle().skip(1));
    let crossed = own.flat_map(|(a, b)| edges.iter().map(move |e| (*b - *a).cross(*e)));
    axes.iter().copied().chain(crossed).any(|direction| {
        let Some(axis) = direction.try_normalize() else {
            return false;
        };
        let reach = |corners: &[DVec3]| {
            let along = corners.iter().map(|it| it.dot(axis));
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), it| {
                (low.min(it), high.max(it))
            })
        };
        let ((a, b), (c, d)) = (reach(one), reach(other));
        (c - b).max(a - d) >= APART_M
    })
}

fn check_similar(
    here: &PlacedPortal,
    partner: &PlacedPortal,
    scale: f64,
) -> Result<(), SpaceError> {
    let (_, _, map) = here.map_to(partner);
    let size = partner
        .corners
        .iter()
        .map(|it| it.distance(partner.portal.at))
        .fold(0.0, f64::max);
    let is_met = |corner: &DVec3| {
        let there = map.transform_point3(*corner);
        let near = |it: &DVec3| it.distance(there) <= SIMILAR * size;
        partner.corners.iter().any(near)
    };
    let names = (here.portal.name.clone(), partner.portal.name.clone());
    if here.corners.len() != partner.corners.len() || !here.corners.iter().all(is_met) {
        let (name, partner) = names;
        return Err(SpaceError::NotSimilar { name, partner });
    }
    if !(SCALES.0..=SCALES.1).contains(&scale) {
        let (name, partner) = names;
        return Err(SpaceError::OtherSize { name, partner });
    }
    Ok(())
}
