//! What a felled tree leaves: bark that flares at the root, and a pale cut.

use glam::Vec3;

use super::mesh::{Colour, Mesh, add_turned, rgb};
use super::plan::Build;
use super::trunk::DEPTH;
use super::{Material, Shape, Size};

const BARK: Colour = rgb(78, 62, 50);
const CUT: Colour = rgb(198, 164, 118);
const HEART: Colour = rgb(164, 122, 80);

/// A stump of a build, in a size.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let (high, foot, cut) = (build.height, build.radius, 0.68 * build.radius);
    let paint = |place: Vec3, normal: Vec3| {
        let from_middle = place.x.hypot(place.z) / cut;
        let is_cut = normal.y > 0.5 && place.y > 0.9 * high;
        let colour = if !is_cut {
            BARK * (0.8 + 0.2 * (place.y / high).clamp(0.0, 1.0))
        } else if from_middle < 0.3 {
            HEART
        } else {
            CUT
        };
        (colour, 0.0)
    };
    let whole = [
        [0.0, high],
        [0.55 * cut, high],
        [cut, high],
        [cut, high],
        [1.06 * cut, 0.45 * high],
        [0.9 * foot, 0.12 * high],
        [foot, 0.0],
        [foot, -DEPTH],
    ];
    let plain = [
        [0.0, high],
        [cut, high],
        [cut, high],
        [foot, 0.0],
        [foot, -DEPTH],
    ];
    // Of four sides it looks thinner.
    let few = [[0.0, high], [1.2 * cut, high], [1.2 * foot, -DEPTH]];
    let (profile, sides): (&[_], _) = match size {
        Size::Near => (&whole, 10),
        Size::Middle => (&plain, 7),
        Size::Coarse => (&few, 6),
        Size::Far => (&few, 4),
    };
    let mut mesh = Mesh::default();
    add_turned(
        &mut mesh,
        Vec3::ZERO,
        profile,
        sides,
        Material::Wood,
        &paint,
    );
    mesh.finish()
}
