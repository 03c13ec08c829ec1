//! Solids that are round, with the normals of what they stand for.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::builder::Builder;

pub(super) fn cylinder(out: &mut Builder, radius: f64, height: f64, around: u32) {
    let half = height / 2.0;
    let outward = |part: u32| {
        let angle = TAU * f64::from(part % around) / f64::from(around);
        DVec3::new(angle.cos(), 0.0, -angle.sin())
    };
    for part in 0..around {
        let [a, b] = [part, part + 1];
        let corners = [(a, -half), (b, -half), (b, half), (a, half)].map(|(part, y)| {
            let along = TAU * radius * f64::from(part) / f64::from(around);
            let normal = outward(part);
            out.corner(
                normal * radius + DVec3::Y * y,
                normal,
                DVec2::new(along, half - y),
            )
        });
        out.triangle([corners[0], corners[1], corners[2]]);
        out.triangle([corners[0], corners[2], corners[3]]);
    }
    for up in [1.0, -1.0] {
        let rim: Vec<_> = (0..around)
            .map(|it| outward(it) * radius + DVec3::Y * half * up)
            .collect();
        let rim: Vec<_> = if up > 0.0 {
            rim
        } else {
            rim.into_iter().rev().collect()
        };
        out.face(&rim);
    }
}

/// A ball by longitudes and latitudes.
pub(super) fn ball(out: &mut Builder, radius: f64, around: u32) {
    let rows = around.div_ceil(2).max(2);
    let corner = |out: &mut Builder, part: u32, row: u32| {
        let angle = TAU * f64::from(part % around) / f64::from(around);
        // From the lower pole up; at the poles exactly, so that they are one point.
        let (sine, cosine) = if row == 0 || row == rows {
            (0.0, if row == 0 { 1.0 } else { -1.0 })
        } else {
            (std::f64::consts::PI * f64::from(row) / f64::from(rows)).sin_cos()
        };
        let normal = DVec3::new(sine * angle.cos(), -cosine, -sine * angle.sin());
        let down = radius * std::f64::consts::PI * (1.0 - f64::from(row) / f64::from(rows));
        out.corner(
            normal * radius,
            normal,
            DVec2::new(TAU * radius * f64::from(part) / f64::from(around), down),
        )
    };
    for row in 0..rows {
        for part in 0..around {
            let [a, b, c, d] = [
                (part, row),
                (part + 1, row),
                (part + 1, row + 1),
                (part, row + 1),
            ]
            .map(|(part, row)| corner(out, part, row));
            if row > 0 {
                out.triangle([a, b, c]);
            }
            if row + 1 < rows {
                out.triangle([a, c, d]);
            }
        }
    }
}
