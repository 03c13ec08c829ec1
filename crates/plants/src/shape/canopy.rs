//! Plans of the trees with flat, layered or hanging crowns.

use std::f32::consts::TAU;

use glam::Vec3;

use super::broadleaf::{Ring, branches, crown};
use super::crown::{Clump, Crown};
use super::mesh::{Dice, rgb};
use super::plan::Build;
use super::tree::{Bark, Tree};
use super::trunk::Limb;

/// An acacia: flat umbrellas on a forked trunk.
pub(super) fn acacia(build: Build) -> Tree {
    let rings = match build.by_age(0, 1, 2) {
        0 => vec![
            Ring::of(2, [0.8, 0.4], [0.55, 0.09]),
            Ring::of(1, [0.92, 0.1], [0.5, 0.08]),
        ],
        1 => vec![
            Ring::of(5, [0.82, 0.6], [0.42, 0.07]),
            Ring::of(3, [0.91, 0.25], [0.4, 0.075]),
        ],
        _ => vec![
            Ring::of(4, [0.74, 0.68], [0.36, 0.055]).hull(1),
            Ring::of(5, [0.87, 0.42], [0.36, 0.06]),
            Ring::of(2, [0.95, 0.14], [0.3, 0.05]),
        ],
    };
    let palette = [rgb(74, 84, 36), rgb(118, 126, 50), rgb(158, 158, 70)];
    let crown = crown(build, &rings, palette, build.by_age(31, 32, 33));
    let fork = build.height * build.by_age(0.5, 0.36, 0.3);
    let mut trunk = Limb::trunk(
        Vec3::new(0.06 * fork, fork, 0.0),
        Vec3::X * 0.08 * fork,
        build.trunk * 1.05,
        1.35,
    );
    if let Some(last) = trunk
        .rings
        .len()
        .checked_sub(2)
        .and_then(|last| trunk.rings.get_mut(last))
    {
        last.1 = build.trunk * 0.9;
    }
    let branches = branches(
        build,
        &trunk,
        &crown,
        build.by_age(3, 4, 6),
        [fork / build.height * 0.86, fork / build.height * 0.97],
        0.66,
    );
    Tree {
        trunk: Some(trunk),
        branches,
        bold: 4,
        bark: Bark::plain(rgb(104, 80, 58), rgb(128, 98, 70)),
        crown,
        hulls: build.by_age(vec![[10, 2]], vec![[10, 2]], vec![[8, 2], [7, 2]]),
        deep: 1.3,
        turned: None,
        far: (3, vec![[0.92, 0.98], [1.1, 0.78]]),
        seed: 7,
    }
}

/// A willow: a dome from which curtains hang down to the ground.
pub(super) fn willow(build: Build) -> Tree {
    let dome = vec![
        Ring::of(
            build.by_age(3, 5, 5),
            [0.72, 0.46],
            [build.by_age(0.5, 0.46, 0.46), 0.16],
        ),
        Ring::of(build.by_age(1, 1, 1), [0.85, 0.1], [0.5, 0.15]),
    ];
    let palette = [rgb(56, 86, 36), rgb(98, 134, 56), rgb(150, 176, 84)];
    let mut crown = crown(build, &dome, palette, build.by_age(41, 42, 43));
    add_curtains(build, &mut crown);
    crown.fit(build.height, build.radius);
    crown.hanging = true;
    let bend = Vec3::new(-0.05, 0.0, 0.03) * build.height;
    let trunk = Limb::trunk(
        Vec3::new(0.0, build.height * 0.75, 0.0),
        bend,
        build.trunk,
        build.by_age(1.3, 1.5, 1.7),
    );
    let branches = branches(
        build,
        &trunk,
        &crown,
        build.by_age(2, 3, 2),
        [0.3, 0.45],
        0.5,
    );
    Tree {
        trunk: Some(trunk),
        branches,
        bold: 0,
        bark: Bark::plain(rgb(86, 72, 54), rgb(108, 92, 68)),
        crown,
        hulls: vec![[9, 4]],
        deep: 1.04,
        turned: Some((
            9,
            vec![
                [0.0, 1.0],
                [0.6, 0.9],
                [0.97, 0.62],
                [0.96, 0.16],
                [0.96, 0.16],
                [0.0, 0.46],
            ],
        )),
        far: (3, vec![[0.86, 0.95], [1.1, 0.14]]),
        seed: 8,
    }
}

/// Adds lumps that hang from a willow's dome.
fn add_curtains(build: Build, crown: &mut Crown) {
    let mut dice = Dice::new(44);
    let count = build.by_age(6, 11, 9);
    for i in 0..count {
        let angle = (i as f32 + dice.between(-0.25, 0.25)) / count as f32 * TAU;
        let out = dice.between(0.68, 0.86);
        let half = dice.between(0.26, build.by_age(0.34, 0.35, 0.28));
        let wide = build.by_age(0.3, 0.24, 0.28) * dice.between(0.9, 1.2);
        crown.clumps.push(Clump {
            centre: Vec3::new(
                angle.cos() * out,
                0.75 - half * dice.between(0.9, 1.05),
                angle.sin() * out,
            ),
            radii: Vec3::new(wide, half, wide),
            group: 0,
            taper: 0.45,
        });
    }
    let scale = Vec3::new(build.radius, build.height, build.radius);
    for clump in crown.clumps.iter_mut().filter(|clump| clump.taper > 0.0) {
        clump.centre *= scale;
        clump.radii *= scale;
    }
}

/// A kapok: a very tall smooth trunk with buttresses and a layered flat crown at the top.
pub(super) fn kapok(build: Build) -> Tree {
    let rings = match build.by_age(0, 1, 2) {
        0 => vec![
            Ring::of(3, [0.78, 0.42], [0.5, 0.06]).hull(1),
            Ring::of(2, [0.91, 0.2], [0.5, 0.07]),
        ],
        1 => vec![
            Ring::of(4, [0.73, 0.52], [0.5, 0.042]).hull(1),
            Ring::of(5, [0.84, 0.52], [0.48, 0.05]),
            Ring::of(2, [0.93, 0.2], [0.48, 0.05]),
        ],
        _ => vec![
            Ring::of(3, [0.64, 0.56], [0.46, 0.034]).hull(2),
            Ring::of(4, [0.76, 0.54], [0.46, 0.04]).hull(1),
            Ring::of(5, [0.87, 0.46], [0.42, 0.044]),
            Ring::of(1, [0.94, 0.05], [0.46, 0.044]),
        ],
    };
    let palette = [rgb(26, 68, 34), rgb(56, 114, 50), rgb(104, 156, 68)];
    let crown = crown(build, &rings, palette, build.by_age(51, 52, 53));
    let bend = Vec3::new(0.012, 0.0, 0.008) * build.height;
    let flare = build.by_age(1.3, 1.75, 2.0);
    let mut trunk = Limb::trunk(
        Vec3::new(0.0, build.height * 0.9, 0.0),
        bend,
        build.trunk,
        flare,
    );
    trunk.ridges = build.by_age(0.15, 0.4, 0.5);
    let branches = branches(
        build,
        &trunk,
        &crown,
        build.by_age(2, 5, 7),
        [0.55, 0.78],
        0.42,
    );
    Tree {
        trunk: Some(trunk),
        branches,
        bold: 0,
        bark: Bark::plain(rgb(122, 110, 90), rgb(150, 138, 114)),
        crown,
        hulls: build.by_age(
            vec![[9, 2], [9, 2]],
            vec![[9, 2], [9, 2]],
            vec![[6, 2], [6, 2], [6, 2]],
        ),
        deep: 1.15,
        turned: None,
        far: (3, vec![[0.64, 0.98], [1.06, build.by_age(0.74, 0.72, 0.7)]]),
        seed: 9,
    }
}
