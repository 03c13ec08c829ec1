//! Trunks and branches: tubes along bent lines.

use glam::Vec3;

use super::Material;
use super::mesh::{Colour, Mesh, smooth};

/// How far below the root a trunk reaches, metres: the ground may be uneven or coarse.
pub(super) const DEPTH: f32 = 1.2;

/// A tube along a line of rings, which ends in a point at the last.
#[derive(Clone)]
pub(super) struct Limb {
    /// Middles and radii, metres, from the root outwards.
    pub rings: Vec<(Vec3, f32)>,
    /// How far ridges stand out at the foot, as a part of the radius.
    pub ridges: f32,
}

impl Limb {
    /// A trunk from below the root to a top, bent by a metres' vector halfway, with a flare at the root.
    pub(super) fn trunk(top: Vec3, bend: Vec3, radius: f32, flare: f32) -> Self {
        let steps = (top.y / 1.5).ceil().max(3.0) as usize;
        let at = |t: f32| top * t + bend * (t * std::f32::consts::PI).sin();
        let flared = |height: f32, most: f32| at((height / top.y).min(most));
        let mut rings = vec![
            (Vec3::new(0.0, -DEPTH, 0.0), radius * flare * 1.15),
            (Vec3::ZERO, radius * flare),
            (flared(radius * 0.9, 0.1), radius * (0.5 + 0.5 * flare)),
            (flared(radius * 2.6, 0.2), radius * (0.92 + 0.12 * flare)),
        ];
        for step in 1..=steps {
            let t = step as f32 / (steps as f32 + 1.0);
            // Not within the flare.
            if at(t).y > rings[3].0.y + 0.1 * radius {
                rings.push((at(t), radius * (1.12 - 0.72 * t)));
            }
        }
        rings.push((top, 0.0));
        Self { rings, ridges: 0.0 }
    }

    /// A branch from one place to another, that first goes along and then bends up by a part of its length.
    pub(super) fn branch(from: Vec3, to: Vec3, radius: f32, bend: f32) -> Self {
        let sag = Vec3::new(0.0, -(to - from).length() * bend, 0.0);
        let at = |t: f32| from.lerp(to, t) + sag * (t * std::f32::consts::PI).sin();
        let steps = ((to - from).length() / 1.5).ceil().clamp(3.0, 6.0) as usize;
        let mut rings: Vec<_> = (0..steps)
            .map(|step| step as f32 / steps as f32)
            .map(|t| (at(t), radius * (1.0 - 0.72 * t)))
            .collect();
        rings.push((to, 0.0));
        Self { rings, ridges: 0.0 }
    }

    /// The place on the line at a height, if the line goes up.
    pub(super) fn at_height(&self, height: f32) -> Vec3 {
        for pair in self.rings.windows(2) {
            let (low, high) = (pair[0].0, pair[1].0);
            if high.y >= height && high.y > low.y {
                return low.lerp(high, ((height - low.y) / (high.y - low.y)).clamp(0.0, 1.0));
            }
        }
        self.rings.last().map_or(Vec3::ZERO, |ring| ring.0)
    }

    /// The same line with other radii, as a tube of few sides looks thinner.
    pub(super) fn stouter(mut self, sides: usize) -> Self {
        let factor = if sides < 4 { 1.24 } else { 1.1 };
        self.rings.iter_mut().for_each(|ring| ring.1 *= factor);
        self
    }

    /// The same line, but with its end elsewhere.
    pub(super) fn ending(mut self, end: Vec3) -> Self {
        if let Some(last) = self.rings.last_mut() {
            last.0 = end;
        }
        self
    }

    /// The same line with fewer rings: the first, the last and so many evenly between.
    pub(super) fn coarse(&self, between: usize) -> Self {
        let last = self.rings.len() - 1;
        let kept = (0..between).map(|i| (i + 1) * last / (between + 1));
        let mut rings = vec![self.rings[0]];
        rings.extend(kept.map(|i| self.rings[i]));
        rings.push(self.rings[last]);
        // A flare would widen the trunk all the way up to the next ring.
        if rings[0].0.y < 0.0 {
            rings[0].1 = rings[0].1.min(self.rings[4.min(last - 1)].1 * 1.3);
        }
        Self {
            rings,
            ridges: self.ridges,
        }
    }
}

/// Adds a limb: its colour and sway are told by the place.
pub(super) fn add_limb(
    mesh: &mut Mesh,
    limb: &Limb,
    sides: usize,
    colour: &dyn Fn(Vec3) -> Colour,
    sway: &dyn Fn(Vec3) -> f32,
) {
    let last = limb.rings.len() - 1;
    let mut across = Vec3::X;
    let mut rings: Vec<Vec<u16>> = Vec::new();
    for i in 0..last {
        let (place, radius) = limb.rings[i];
        let behind = limb.rings[i.saturating_sub(1)].0;
        let ahead = (limb.rings[i + 1].0 - behind)
            .try_normalize()
            .unwrap_or(Vec3::Y);
        across = (across - ahead * across.dot(ahead))
            .try_normalize()
            .unwrap_or_else(|| ahead.any_orthonormal_vector());
        let along = across.cross(ahead);
        let slope = (limb.rings[i].1 - limb.rings[i + 1].1)
            / (limb.rings[i + 1].0 - place).length().max(0.01);
        let ring = (0..sides).map(|side| {
            let angle = side as f32 / sides as f32 * std::f32::consts::TAU;
            let outward = across * angle.cos() + along * angle.sin();
            let ridge = if side % 2 == 0 { 1.0 } else { -0.35 };
            let reach =
                radius * (1.0 + limb.ridges * ridge * smooth(last as f32 * 0.7, 1.0, i as f32));
            let there = place + outward * reach;
            mesh.corner(
                there,
                outward + ahead * slope.min(1.0),
                colour(there),
                Material::Wood,
                sway(there),
            )
        });
        rings.push(ring.collect());
    }
    let (tip, _) = limb.rings[last];
    let ahead = tip - limb.rings[last - 1].0;
    let tip = mesh.corner(tip, ahead, colour(tip), Material::Wood, sway(tip));
    for pair in rings.windows(2) {
        mesh.band(&pair[0], &pair[1], true);
    }
    if let Some(ring) = rings.last() {
        mesh.close_above(ring, tip);
    }
}
