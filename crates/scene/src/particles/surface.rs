//! What the ground at a place is made of and looks like, for what is thrown up from it.

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_terrain::{Kind, Vertex};

use crate::world::World;

/// Steps of the sky in the fourth byte of a vertex's colour, from this bit on: 6 and more is all of it.
const SKY_SHIFT: u32 = 5;
const ALL_SKY: f32 = 6.0;

/// Ground at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    pub kind: Kind,
    /// Its colour as it is seen, in linear light.
    pub colour: [f32; 3],
    /// How much of the sky is left there, 0 to 1.
    pub sky: f32,
}

/// The ground at a place, if it is loaded to be touched. Its colour is that of the land's mesh near by, as pictures show it.
pub(crate) fn surface_at(world: &World, point: ChartPoint) -> Option<Surface> {
    let coord = ChunkCoord::containing(point);
    if !world.ground.is_touchable(coord) {
        return None;
    }
    let kind = world.ground.kind(point);
    let local = (point.pos - coord.origin()).as_vec3();
    let away = |it: &Vertex| it.position().distance_squared(local);
    let mesh = world.ground.land().mesh(coord);
    let vertices = mesh.into_iter().flat_map(|mesh| &mesh.vertices);
    let nearest = vertices.min_by(|a, b| away(a).total_cmp(&away(b)));
    let [r, g, b, own] = kind.tint();
    Some(match nearest {
        Some(vertex) => Surface {
            kind,
            colour: [0, 1, 2].map(|i| linear(vertex.colour[i])),
            sky: (f32::from(vertex.colour[3] >> SKY_SHIFT) / ALL_SKY).min(1.0),
        },
        None => Surface {
            kind,
            colour: [r, g, b].map(|it| it * own.max(0.5)),
            sky: 1.0,
        },
    })
}

/// Linear light of an sRGB byte.
fn linear(byte: u8) -> f32 {
    let c = f32::from(byte) / 255.0;
    if c <= 0.040_45 {
        c / 12.92
    } else {
        ((c + 0.055) / 1.055).powf(2.4)
    }
}
