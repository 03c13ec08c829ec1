//! In which directions a lamp is seen: straight, through one face of a box, through parallel faces, or through one portal.
//!
//! In the axes of a box let u = K w be the velocity where the box is not. A path that stays t_k felt metres in the k-th
//! of a row of media between parallel faces, whose stretches are s_k, goes L - p = sum of u t_k / s_k, axis by axis. With D_k
//! the parts of (L - p)_i between the faces across axis i, t_k = D_k s_ki / u_i, so that
//! u_j / u_i = (L - p)_j / sum of D_k s_ki / s_kj. For one face at f this is w_j proportional to (L - p)_j / (1 + (a - 1) s_i / s_j)
//! with a = (L - p)_i / (f - p)_i.
//!
//! Behind a portal of map G a lamp shows where G^-1 takes it. Its picture is q^-1 times as large and as far, so that it seems as
//! wide as it is: its light falls off by the length in its own metres, q times those before the portal.

use glam::{DMat3, DVec3};

use crate::aberration::Sides;
use crate::place::Place;
use crate::portal::PlacedPortal;
use crate::scene::SceneQuery;
use crate::space::{Placed, Space, Traveller};
use crate::trace::{End, trace};

/// A way from a place to a lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LampPath {
    /// Felt direction in which it sets out, of length 1.
    pub w: DVec3,
    /// Felt length, metres of the lamp's size: what its light falls off by.
    pub length: f64,
    /// How large, to the lamp's metres, the metres at its beginning are: 1 but before a portal.
    pub scale: f64,
}

impl LampPath {
    /// Whether nothing stands on it and it does lead to the lamp: it may meet other boxes, behind which it is dark.
    pub fn is_clear(
        &self,
        space: &Space,
        from: &Place,
        lamp: &Place,
        scene: &dyn SceneQuery,
    ) -> bool {
        let start = Place {
            scale: self.scale,
            ..*from
        };
        let path = trace(space, &start, self.w, self.length, scene, &Traveller::Body);
        let slack = 1e-6 * (1.0 + self.length);
        path.end == End::Spent && (path.place.point - lamp.point).length() < slack
    }
}

/// A row of media behind each other: up to three, with the faces between them.
struct Row<'s> {
    /// The box whose faces they are.
    placed: &'s Placed,
    /// Stretches in the box's axes, of each medium.
    media: [DVec3; 3],
    /// How many there are.
    count: usize,
    /// Where the faces lie: -1 for that which is come to first, 1 for the other.
    faces: [f64; 2],
}

/// All ways from a place to a lamp that pass no face, one face, both of a pair of parallel faces, or one portal; whether they are
/// clear has to be asked. Neither place has a turn or a scale.
pub fn lamp_paths(space: &Space, from: &Place, lamp: &Place) -> Vec<LampPath> {
    let portals = space.portals().iter();
    let mut found: Vec<_> = portals
        .filter_map(|portal| through_portal(space, portal, from, lamp))
        .collect();
    let extra = |a: &Place, b: &Place| -> Option<usize> {
        let mut more = a.stack.iter().filter(|number| !b.stack.contains(*number));
        let only = more.next()?;
        let is_one = more.next().is_none() && a.stack.len() == b.stack.len() + 1;
        is_one.then_some(only)
    };
    if from.stack == lamp.stack {
        found.extend(straight(space, from, lamp));
        let others = space.entrances(&from.stack).iter().map(|n| usize::from(*n));
        for number in others.filter(|number| !from.stack.contains(*number)) {
            let placed = &space.placed()[number];
            let s = stretch_of(placed, lamp.point - from.point);
            let media = [DVec3::ONE, s, DVec3::ONE];
            let row = Row {
                placed,
                media,
                count: 3,
                faces: [-1.0, 1.0],
            };
            add(space, from, lamp, &row, from, &mut found);
        }
    } else if let Some(number) = extra(lamp, from) {
        let placed = &space.placed()[number];
        let s = stretch_of(placed, lamp.point - from.point);
        let row = Row {
            placed,
            media: [DVec3::ONE, s, s],
            count: 2,
            faces: [-1.0, 1.0],
        };
        add(space, from, lamp, &row, from, &mut found);
    } else if let Some(number) = extra(from, lamp) {
        let placed = &space.placed()[number];
        let s = stretch_of(placed, lamp.point - from.point);
        let row = Row {
            placed,
            media: [s, DVec3::ONE, DVec3::ONE],
            count: 2,
            faces: [1.0, -1.0],
        };
        add(space, from, lamp, &row, lamp, &mut found);
    }
    found
}

fn through_portal(
    space: &Space,
    portal: &PlacedPortal,
    from: &Place,
    lamp: &Place,
) -> Option<LampPath> {
    let partner = &space.portals()[portal.portal.to];
    if portal.stack != from.stack || partner.stack != lamp.stack {
        return None;
    }
    let image = portal.map.inverse().transform_point3(lamp.point);
    let (here, there) = (portal.before(from.point), portal.before(image));
    let meets = from.point.lerp(image, here / (here - there));
    if here * there >= 0.0 || !portal.is_open(here > 0.0) || !portal.is_in(portal.local(meets)) {
        return None;
    }
    let felt = portal.squeeze.inverse() * (image - from.point);
    Some(LampPath {
        w: felt.try_normalize()?,
        length: felt.length() * portal.scale,
        scale: portal.scale.recip(),
    })
}

fn straight(space: &Space, from: &Place, lamp: &Place) -> Option<LampPath> {
    let away = lamp.point - from.point;
    let k = space.squeeze(&from.stack, away, &Traveller::Body);
    let felt = k.inverse() * away;
    let length = felt.length();
    let w = felt.try_normalize()?;
    Some(LampPath {
        w,
        length,
        scale: 1.0,
    })
}

/// The stretch of a box for who goes that way.
fn stretch_of(placed: &Placed, way: DVec3) -> DVec3 {
    if placed.is_felt(way) {
        placed.aberration.stretch
    } else {
        DVec3::ONE
    }
}

/// The ways through the faces across each axis that lie within them. `around` is a place outside of the box.
fn add(
    space: &Space,
    from: &Place,
    lamp: &Place,
    row: &Row<'_>,
    around: &Place,
    found: &mut Vec<LampPath>,
) {
    if matches!(row.placed.aberration.sides, Sides::Legacy(_)) {
        return;
    }
    let (p, l) = (row.placed.local(from.point), row.placed.local(lamp.point));
    let ambient = space.squeeze(&around.stack, lamp.point - from.point, &Traveller::Body);
    let out_of_axes = ambient.inverse() * row.placed.axes;
    for axis in 0..3 {
        if !row.placed.aberration.is_wall(axis)
            && let Some(path) = through(row, axis, (p, l), out_of_axes)
        {
            found.push(path);
        }
    }
}

fn through(row: &Row<'_>, i: usize, (p, l): (DVec3, DVec3), out: DMat3) -> Option<LampPath> {
    let (away, h) = (l - p, row.placed.aberration.half);
    let sign = away[i].signum();
    let mut cuts = [l[i]; 4];
    cuts[0] = p[i];
    for (cut, face) in cuts[1..row.count].iter_mut().zip(row.faces) {
        *cut = face * sign * h[i];
    }
    let parts: [f64; 3] = std::array::from_fn(|k| cuts[k + 1] - cuts[k]);
    if parts.iter().any(|part| part * sign < 0.0) || away[i] == 0.0 {
        return None;
    }
    let weight = |k: usize, j: usize| parts[k] * row.media[k][i] / row.media[k][j];
    let u = DVec3::from_array([0, 1, 2].map(|j| {
        let sum = weight(0, j) + weight(1, j) + weight(2, j);
        away[j] / sum
    }));
    let mut at = p;
    for k in 0..row.count - 1 {
        at += u * DVec3::from_array([0, 1, 2].map(|j| weight(k, j)));
        let is_in_face = (0..3).all(|j| j == i || at[j].abs() <= h[j]);
        if !is_in_face {
            return None;
        }
    }
    let time: f64 = (0..3).map(|k| parts[k] * row.media[k][i]).sum();
    let felt = out * (u * time);
    let length = felt.length();
    Some(LampPath {
        w: felt.try_normalize()?,
        length,
        scale: 1.0,
    })
}
