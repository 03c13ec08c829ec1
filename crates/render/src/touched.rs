//! Land that came, changed or went, as shadow maps are to know of it.

use antipode_geometry::ChunkCoord;
use antipode_terrain::{ChunkMesh, PARTS_PER_M, Vertex};
use glam::{DVec3, UVec3};

use crate::shadow::Caster;

/// A box of land that is not what it was.
#[derive(Clone, Copy, Debug)]
pub struct Touched {
    /// Where.
    pub of: Caster,
    /// Whether somebody has dug or built there: the player looks at it, and it changes again soon.
    pub is_edited: bool,
}

impl Touched {
    /// What tells a chunk's mesh from the one before it, of the same level; nothing where they throw the same shadow.
    pub fn between(coord: ChunkCoord, old: &ChunkMesh, new: &ChunkMesh) -> Option<Self> {
        let [low, high] = changed(old, new)?.map(|place| place.as_dvec3() / f64::from(PARTS_PER_M));
        // A triangle whose other corner has changed reaches no farther than its cell.
        let cell_m = DVec3::splat(f64::from(new.level.step_m()));
        Some(Self {
            of: Caster {
                chart: coord.chart,
                min: coord.origin() + low - cell_m,
                max: coord.origin() + high + cell_m,
            },
            is_edited: true,
        })
    }
}

/// The lowest and the highest corner of the places of vertices that only one of two meshes has.
fn changed(old: &ChunkMesh, new: &ChunkMesh) -> Option<[UVec3; 2]> {
    let sorted = |mesh: &ChunkMesh| {
        let mut places: Vec<_> = mesh.vertices.iter().map(Vertex::place).collect();
        places.sort_unstable();
        places
    };
    let (old, new) = (sorted(old), sorted(new));
    let (mut old, mut new) = (&old[..], &new[..]);
    let mut ends: Option<[UVec3; 2]> = None;
    loop {
        let place = match (old.split_first(), new.split_first()) {
            (Some((a, olds)), Some((b, news))) if a == b => {
                (old, new) = (olds, news);
                continue;
            }
            (Some((a, olds)), Some((b, _))) if a < b => {
                old = olds;
                a
            }
            (_, Some((b, news))) => {
                new = news;
                b
            }
            (Some((a, olds)), None) => {
                old = olds;
                a
            }
            (None, None) => return ends,
        };
        let place = UVec3::from(*place);
        let [low, high] = ends.unwrap_or([place; 2]);
        ends = Some([low.min(place), high.max(place)]);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::ChartId;
    use glam::{IVec3, Vec3};

    use super::*;

    fn mesh(places: &[Vec3]) -> ChunkMesh {
        let vertex = |place: &Vec3| Vertex::new(*place, Vec3::Y, [0; 3]);
        ChunkMesh {
            vertices: places.iter().map(vertex).collect(),
            ..ChunkMesh::default()
        }
    }

    #[test]
    fn what_an_edit_has_changed_is_a_cell_around_the_vertices_that_are_new_or_gone() {
        let coord = ChunkCoord::new(ChartId::SECOND, IVec3::new(1, 0, -1));
        let [kept, gone, new] = [
            Vec3::new(2.0, 3.0, 4.0),
            Vec3::new(10.0, 5.5, 6.0),
            Vec3::new(10.0, 5.0, 7.0),
        ];
        let between = |old: &[Vec3], new: &[Vec3]| Touched::between(coord, &mesh(old), &mesh(new));
        let found = between(&[kept, gone], &[new, kept]).unwrap();
        let origin = DVec3::new(32.0, 0.0, -32.0);
        assert_eq!(found.of.min, origin + DVec3::new(9.0, 4.0, 5.0));
        assert_eq!(found.of.max, origin + DVec3::new(11.0, 6.5, 8.0));
        assert!(found.is_edited && found.of.chart == ChartId::SECOND);
        assert!(between(&[kept, gone], &[gone, kept]).is_none());
        let all = between(&[], &[new]).unwrap();
        assert_eq!(all.of.middle(), origin + new.as_dvec3());
    }
}
