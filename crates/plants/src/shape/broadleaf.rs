//! Plans of the trees and bushes whose crowns are round heaps of leaves.

use std::f32::consts::TAU;

use glam::Vec3;

use super::crown::{Clump, Crown};
use super::mesh::{Colour, Dice, rgb};
use super::plan::Build;
use super::tree::{Bark, Tree};
use super::trunk::Limb;

/// A ring of lumps about the middle line, in parts of the crown's radius and the height.
pub(super) struct Ring {
    /// How many.
    pub count: usize,
    /// Where their middles are, upward.
    pub height: f32,
    /// Where their middles are, sideways.
    pub reach: f32,
    /// Half their width.
    pub wide: f32,
    /// Half their height.
    pub high: f32,
    /// Which hull they belong to from farther off.
    pub group: u8,
}

impl Ring {
    /// A ring of so many lumps at a height and a distance from the middle line, and half their width and height.
    pub(super) fn of(count: usize, [height, reach]: [f32; 2], [wide, high]: [f32; 2]) -> Self {
        Self {
            count,
            height,
            reach,
            wide,
            high,
            group: 0,
        }
    }

    /// The same ring in another hull.
    pub(super) fn hull(mut self, group: u8) -> Self {
        self.group = group;
        self
    }
}

/// Lumps in rings, each a little off its place, stretched to the lengths of a plant.
pub(super) fn crown(build: Build, rings: &[Ring], palette: [Colour; 3], seed: u64) -> Crown {
    let mut dice = Dice::new(seed);
    let mut clumps = Vec::new();
    for ring in rings {
        let turn = dice.between(0.0, TAU);
        for i in 0..ring.count {
            let angle = turn + (i as f32 + dice.between(-0.22, 0.22)) / ring.count as f32 * TAU;
            let reach = ring.reach * dice.between(0.85, 1.1);
            let size = dice.between(0.85, 1.15);
            let height = ring.height + ring.high * dice.between(-0.35, 0.35);
            clumps.push(Clump {
                centre: Vec3::new(angle.cos() * reach, height, angle.sin() * reach),
                radii: Vec3::new(ring.wide, ring.high, ring.wide) * size,
                group: ring.group,
                taper: 0.0,
            });
        }
    }
    let mut crown = Crown {
        clumps,
        palette,
        uneven: 0.1,
        hanging: false,
    };
    crown.fit(build.height, build.radius);
    crown
}

/// Branches from a trunk to the lumps that are the farthest out, the thickest first.
pub(super) fn branches(
    build: Build,
    trunk: &Limb,
    crown: &Crown,
    count: usize,
    from: [f32; 2],
    stout: f32,
) -> Vec<Limb> {
    let mut ends: Vec<&Clump> = crown
        .clumps
        .iter()
        .filter(|clump| clump.taper == 0.0)
        .collect();
    ends.sort_by(|a, b| {
        b.centre
            .x
            .hypot(b.centre.z)
            .total_cmp(&a.centre.x.hypot(a.centre.z))
    });
    let step = (ends.len() / count.max(1)).clamp(1, 2);
    let chosen = ends.into_iter().step_by(step).take(count).enumerate();
    let limbs = chosen.map(|(i, clump)| {
        let part = i as f32 / count.max(2) as f32;
        let start = trunk.at_height(build.height * (from[0] + (from[1] - from[0]) * part));
        Limb::branch(
            start,
            clump.centre,
            build.trunk * stout * (1.0 - 0.3 * part),
            0.1,
        )
    });
    limbs.collect()
}

/// An oak: a broad round crown on a short strong trunk.
pub(super) fn oak(build: Build) -> Tree {
    let rings = match build.by_age(0, 1, 2) {
        0 => vec![
            Ring::of(3, [0.5, 0.4], [0.58, 0.18]),
            Ring::of(1, [0.78, 0.12], [0.55, 0.2]),
        ],
        1 => vec![
            Ring::of(5, [0.51, 0.56], [0.46, 0.155]),
            Ring::of(4, [0.7, 0.42], [0.46, 0.16]),
            Ring::of(1, [0.84, 0.05], [0.46, 0.16]),
        ],
        _ => vec![
            Ring::of(6, [0.47, 0.64], [0.4, 0.13]),
            Ring::of(4, [0.65, 0.5], [0.44, 0.145]),
            Ring::of(2, [0.8, 0.24], [0.44, 0.145]),
        ],
    };
    let palette = [rgb(40, 72, 30), rgb(76, 118, 44), rgb(128, 162, 66)];
    let crown = crown(build, &rings, palette, build.by_age(11, 12, 13));
    let bend = Vec3::new(0.05, 0.0, -0.04) * build.height * build.by_age(0.3, 0.6, 1.0);
    let trunk = Limb::trunk(
        Vec3::new(0.0, build.height * 0.72, 0.0),
        bend,
        build.trunk,
        build.by_age(1.25, 1.5, 1.7),
    );
    let branches = branches(
        build,
        &trunk,
        &crown,
        build.by_age(2, 4, 5),
        [0.26, 0.4],
        0.5,
    );
    Tree {
        trunk: Some(trunk),
        branches,
        bold: 0,
        bark: Bark::plain(rgb(92, 70, 50), rgb(116, 90, 64)),
        crown,
        hulls: vec![[9, 4]],
        deep: 1.04,
        turned: None,
        far: (3, vec![[0.84, 0.97], [1.1, 0.45]]),
        seed: 5,
    }
}

/// A birch: a slender pale trunk and a light oval crown high up.
pub(super) fn birch(build: Build) -> Tree {
    let rings = match build.by_age(0, 1, 2) {
        0 => vec![
            Ring::of(2, [0.55, 0.3], [0.7, 0.16]),
            Ring::of(2, [0.74, 0.2], [0.64, 0.16]),
            Ring::of(1, [0.89, 0.0], [0.44, 0.12]),
        ],
        1 => vec![
            Ring::of(3, [0.49, 0.36], [0.6, 0.11]),
            Ring::of(4, [0.63, 0.44], [0.56, 0.11]),
            Ring::of(3, [0.77, 0.3], [0.52, 0.11]),
            Ring::of(1, [0.9, 0.0], [0.42, 0.1]),
        ],
        _ => vec![
            Ring::of(4, [0.44, 0.48], [0.52, 0.1]),
            Ring::of(4, [0.6, 0.5], [0.54, 0.11]),
            Ring::of(3, [0.75, 0.34], [0.54, 0.11]),
            Ring::of(1, [0.89, 0.0], [0.46, 0.11]),
        ],
    };
    let palette = [rgb(78, 108, 40), rgb(122, 152, 58), rgb(172, 190, 88)];
    let crown = crown(build, &rings, palette, build.by_age(21, 22, 23));
    let mut trunk = Limb::trunk(
        Vec3::new(0.0, build.height * 0.86, 0.0),
        Vec3::X * build.height * 0.025,
        build.trunk,
        1.3,
    );
    let bands = bands(&mut trunk, build);
    let branches = branches(
        build,
        &trunk,
        &crown,
        build.by_age(1, 2, 2),
        [0.36, 0.6],
        0.42,
    );
    Tree {
        trunk: Some(trunk),
        branches,
        bold: 0,
        bark: Bark {
            colours: [rgb(200, 194, 180), rgb(226, 222, 208)],
            bands: (rgb(58, 52, 48), bands),
        },
        crown,
        hulls: vec![[7, 5]],
        deep: 1.04,
        turned: None,
        far: (3, vec![[0.8, 0.98], [1.1, 0.42]]),
        seed: 6,
    }
}

/// Adds rings to a birch's trunk for dark bands between pale bark, and returns their heights.
fn bands(trunk: &mut Limb, build: Build) -> Vec<f32> {
    let count = build.by_age(2, 4, 4);
    let bands: Vec<f32> = (0..count)
        .map(|i| build.height * (0.06 + 0.09 * i as f32 + 0.01 * (i % 2) as f32))
        .collect();
    for &band in &bands {
        for height in [band - 0.09, band, band + 0.09] {
            let centre = trunk.at_height(height);
            let at = trunk
                .rings
                .iter()
                .position(|ring| ring.0.y > height)
                .unwrap_or(trunk.rings.len() - 1);
            let (low, high) = (trunk.rings[at - 1], trunk.rings[at]);
            let part = (height - low.0.y) / (high.0.y - low.0.y).max(0.01);
            trunk
                .rings
                .insert(at, (centre, low.1 + (high.1 - low.1) * part));
        }
    }
    bands
}

/// A low round bush, without a trunk.
pub(super) fn bush(build: Build) -> Tree {
    let rings = match build.by_age(0, 1, 2) {
        0 => vec![
            Ring::of(2, [0.3, 0.35], [0.6, 0.45]),
            Ring::of(1, [0.55, 0.1], [0.6, 0.45]),
        ],
        1 => vec![
            Ring::of(5, [0.22, 0.56], [0.44, 0.4]),
            Ring::of(3, [0.56, 0.26], [0.44, 0.38]),
        ],
        _ => vec![
            Ring::of(7, [0.2, 0.62], [0.36, 0.34]),
            Ring::of(4, [0.48, 0.36], [0.38, 0.34]),
            Ring::of(2, [0.68, 0.1], [0.34, 0.3]),
        ],
    };
    let palette = [rgb(42, 74, 34), rgb(80, 116, 48), rgb(132, 158, 70)];
    let mut crown = crown(build, &rings, palette, build.by_age(61, 62, 63));
    crown.uneven = 0.13;
    Tree {
        trunk: None,
        branches: Vec::new(),
        bold: 0,
        bark: Bark::plain(rgb(86, 68, 50), rgb(86, 68, 50)),
        crown,
        hulls: vec![[9, 4]],
        deep: 1.04,
        turned: None,
        far: (4, vec![[0.0, 1.0], [0.86, 0.66], [1.02, -0.12]]),
        seed: 10,
    }
}
