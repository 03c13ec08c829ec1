//! What one meets in a room: triangles of everything that stands in it, in metres of the scene.
//!
//! Walls of aberrations are no matter of this list: the space has them.

use antipode_deformation::{Triangle, Triangles};

use crate::folder::Assets;
use crate::mesh::{Roundness, SolidMesh, meshes};
use crate::room::{Room, What};

/// The meshes of all that stands in a room but the walls of its aberrations.
pub fn standing(room: &Room, assets: &Assets) -> Vec<SolidMesh> {
    let mut all = meshes(room, assets, Roundness::default());
    all.retain(|mesh| !matches!(room.objects[mesh.object].what, What::Aberration(_)));
    all
}

/// Their triangles, each with the place of its object among all.
pub fn triangles(meshes: &[SolidMesh]) -> Triangles {
    let of = |mesh: &SolidMesh| {
        let (pose, shape, object) = (mesh.pose, mesh.shape.clone(), mesh.object as u32);
        let corner = move |it: u32| pose.transform_point3(shape.positions[it as usize]);
        let triangles = mesh.shape.triangles.clone();
        triangles.into_iter().map(move |it| Triangle {
            corners: it.map(&corner),
            object,
        })
    };
    Triangles::new(meshes.iter().flat_map(of).collect())
}
