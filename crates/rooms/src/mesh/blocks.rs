//! Solids with flat faces, each about the origin of its own axes.

use glam::{DVec2, DVec3};

use super::builder::Builder;

/// A block from one corner to the opposite one.
pub(super) fn block(out: &mut Builder, least: DVec3, most: DVec3) {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let (a, b) = (least, most);
    out.face(&[
        at(b.x, a.y, b.z),
        at(b.x, a.y, a.z),
        at(b.x, b.y, a.z),
        at(b.x, b.y, b.z),
    ]);
    out.face(&[
        at(a.x, a.y, a.z),
        at(a.x, a.y, b.z),
        at(a.x, b.y, b.z),
        at(a.x, b.y, a.z),
    ]);
    out.face(&[
        at(a.x, b.y, b.z),
        at(b.x, b.y, b.z),
        at(b.x, b.y, a.z),
        at(a.x, b.y, a.z),
    ]);
    out.face(&[
        at(a.x, a.y, a.z),
        at(b.x, a.y, a.z),
        at(b.x, a.y, b.z),
        at(a.x, a.y, b.z),
    ]);
    out.face(&[
        at(a.x, a.y, b.z),
        at(b.x, a.y, b.z),
        at(b.x, b.y, b.z),
        at(a.x, b.y, b.z),
    ]);
    out.face(&[
        at(b.x, a.y, a.z),
        at(a.x, a.y, a.z),
        at(a.x, b.y, a.z),
        at(b.x, b.y, a.z),
    ]);
}

pub(super) fn pyramid(out: &mut Builder, size: DVec3) {
    let h = size / 2.0;
    let tip = DVec3::Y * h.y;
    let base = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]
        .map(|(x, z)| DVec3::new(x * h.x, -h.y, z * h.z));
    for side in 0..4 {
        out.face(&[base[side], base[(side + 1) % 4], tip]);
    }
    out.face(&[base[3], base[2], base[1], base[0]]);
}

/// A solid between two outlines in the planes z = least and z = most; `outline` is anticlockwise seen from +z, and convex.
fn prism(out: &mut Builder, outline: &[DVec2], least: f64, most: f64) {
    let at = |it: &DVec2, z: f64| DVec3::new(it.x, it.y, z);
    let front: Vec<_> = outline.iter().map(|it| at(it, most)).collect();
    let back: Vec<_> = outline.iter().rev().map(|it| at(it, least)).collect();
    out.face(&front);
    out.face(&back);
    for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        out.face(&[at(a, most), at(a, least), at(b, least), at(b, most)]);
    }
}

pub(super) fn ramp(out: &mut Builder, size: DVec3) {
    let h = size / 2.0;
    prism(
        out,
        &[
            DVec2::new(-h.x, -h.y),
            DVec2::new(h.x, -h.y),
            DVec2::new(h.x, h.y),
        ],
        -h.z,
        h.z,
    );
}

pub(super) fn stairs(out: &mut Builder, size: DVec3, steps: u32) {
    let h = size / 2.0;
    let (deep, high) = (size.x / f64::from(steps), size.y / f64::from(steps));
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    for step in 0..steps {
        let x = [step, step + 1].map(|it| -h.x + deep * f64::from(it));
        let y = [step, step + 1].map(|it| -h.y + high * f64::from(it));
        out.face(&[
            at(x[0], y[1], h.z),
            at(x[1], y[1], h.z),
            at(x[1], y[1], -h.z),
            at(x[0], y[1], -h.z),
        ]);
        out.face(&[
            at(x[0], y[0], -h.z),
            at(x[0], y[0], h.z),
            at(x[0], y[1], h.z),
            at(x[0], y[1], -h.z),
        ]);
        out.face(&[
            at(x[0], -h.y, h.z),
            at(x[1], -h.y, h.z),
            at(x[1], y[1], h.z),
            at(x[0], y[1], h.z),
        ]);
        out.face(&[
            at(x[1], -h.y, -h.z),
            at(x[0], -h.y, -h.z),
            at(x[0], y[1], -h.z),
            at(x[1], y[1], -h.z),
        ]);
    }
    out.face(&[
        at(h.x, -h.y, h.z),
        at(h.x, -h.y, -h.z),
        at(h.x, h.y, -h.z),
        at(h.x, h.y, h.z),
    ]);
    out.face(&[
        at(-h.x, -h.y, -h.z),
        at(h.x, -h.y, -h.z),
        at(h.x, -h.y, h.z),
        at(-h.x, -h.y, h.z),
    ]);
}

/// A block with a gate along x: upright to half its width below its height, and half a circle of `parts` above.
pub(super) fn arch(out: &mut Builder, size: DVec3, opening: DVec2, parts: u32) {
    let (h, half) = (size / 2.0, opening.x / 2.0);
    let spring = -h.y + opening.y - half;
    let at = |x: f64, (y, z): (f64, f64)| DVec3::new(x, y, z);
    // The gate's edge from the left, z < 0, over its top to the right, as (y, z).
    let mut edge = vec![(-h.y, -half)];
    edge.extend((0..=parts).map(|it| {
        let angle = std::f64::consts::PI * f64::from(it) / f64::from(parts);
        (spring + half * angle.sin(), -half * angle.cos())
    }));
    edge.push((-h.y, half));
    for pair in edge.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        out.face(&[at(h.x, a), at(h.x, b), at(-h.x, b), at(-h.x, a)]);
        // What is over the gate: from the edge up to the top. Its upright parts are as wide as nothing.
        let top = |it: (f64, f64)| (h.y, it.1);
        out.face(&[at(h.x, b), at(h.x, a), at(h.x, top(a)), at(h.x, top(b))]);
        out.face(&[at(-h.x, a), at(-h.x, b), at(-h.x, top(b)), at(-h.x, top(a))]);
    }
    for (least, most) in [(-h.z, -half), (half, h.z)] {
        out.face(&[
            at(h.x, (-h.y, most)),
            at(h.x, (-h.y, least)),
            at(h.x, (h.y, least)),
            at(h.x, (h.y, most)),
        ]);
        out.face(&[
            at(-h.x, (-h.y, least)),
            at(-h.x, (-h.y, most)),
            at(-h.x, (h.y, most)),
            at(-h.x, (h.y, least)),
        ]);
        out.face(&[
            at(-h.x, (-h.y, least)),
            at(h.x, (-h.y, least)),
            at(h.x, (-h.y, most)),
            at(-h.x, (-h.y, most)),
        ]);
    }
    out.face(&[
        at(-h.x, (h.y, h.z)),
        at(h.x, (h.y, h.z)),
        at(h.x, (h.y, -h.z)),
        at(-h.x, (h.y, -h.z)),
    ]);
    out.face(&[
        at(-h.x, (-h.y, h.z)),
        at(h.x, (-h.y, h.z)),
        at(h.x, (h.y, h.z)),
        at(-h.x, (h.y, h.z)),
    ]);
    out.face(&[
        at(h.x, (-h.y, -h.z)),
        at(-h.x, (-h.y, -h.z)),
        at(-h.x, (h.y, -h.z)),
        at(h.x, (h.y, -h.z)),
    ]);
}
