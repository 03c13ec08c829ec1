//! What one meets in a room: triangles of everything that stands in it, in metres of the scene.
//!
//! Walls of aberrations are no matter of this list: the space has them.

use antipode_deformation::{Triangle, Triangles};

use crate::folder::Assets;
use crate::mesh::{Roundness, Shapes, SolidMesh, standing_meshes};
use crate::room::Room;

/// The meshes of all that stands in a room but the walls of its aberrations.
pub fn standing(room: &Room, assets: &Assets) -> Vec<SolidMesh> {
    standing_again(room, assets, &mut Shapes::default())
}

/// The same of a room that has changed, with the shapes that were made for what stood there before.
pub fn standing_again(room: &Room, assets: &Assets, shapes: &mut Shapes) -> Vec<SolidMesh> {
    standing_meshes(room, assets, Roundness::default(), shapes)
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
