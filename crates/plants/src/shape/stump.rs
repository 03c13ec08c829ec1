//! What a felled tree leaves: bark that flares at the root, and a pale cut; of a toadstool all is flesh.

use glam::Vec3;

use super::mesh::{Colour, Mesh, add_turned, rgb};
use super::plan::Build;
use super::trunk::DEPTH;
use super::{Material, Shape, Size};

/// What one is of.
pub(super) struct Stuff {
    bark: Colour,
    cut: Colour,
    heart: Colour,
}

/// A tree's. In the shade of its own wood bark that is as dark as that of trunks is black.
pub(super) const WOOD: Stuff = Stuff {
    bark: rgb(112, 90, 70),
    cut: rgb(198, 164, 118),
    heart: rgb(164, 122, 80),
};
/// A toadstool's.
pub(super) const FLESH: Stuff = Stuff {
    bark: rgb(212, 196, 170),
    cut: rgb(236, 224, 200),
    heart: rgb(214, 190, 176),
};

/// A stump of a build, in a size, of some stuff.
pub(super) fn grow(build: Build, size: Size, stuff: &Stuff) -> Shape {
    let (high, foot, cut) = (build.height, build.radius, 0.68 * build.radius);
    let paint = |place: Vec3, normal: Vec3| {
        let from_middle = place.x.hypot(place.z) / cut;
        let is_cut = normal.y > 0.5 && place.y > 0.9 * high;
        let colour = if !is_cut {
            stuff.bark * (0.8 + 0.2 * (place.y / high).clamp(0.0, 1.0))
        } else if from_middle < 0.3 {
            stuff.heart
        } else {
            stuff.cut
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
