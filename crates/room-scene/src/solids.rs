//! What one meets in a room, as it is known to whoever looks at rooms.

use antipode_rooms::Room;
use antipode_rooms::mesh::SolidMesh;
pub use antipode_rooms::solids::{standing, triangles};

/// Parts what stands from what is loose.
pub fn parted(room: &Room, meshes: Vec<SolidMesh>) -> (Vec<SolidMesh>, Vec<SolidMesh>) {
    let stands = |mesh: &SolidMesh| room.objects[mesh.object].mass.is_none();
    meshes.into_iter().partition(stands)
}
