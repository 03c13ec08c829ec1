//! What one meets in a room: triangles of everything that stands in it, in metres of the scene.
//!
//! Walls of aberrations are no matter of this list: the space has them.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_deformation::{Form, Solids, Standing};
use glam::DAffine3;

use crate::folder::Assets;
use crate::mesh::{Roundness, Shape, Shapes, SolidMesh, standing_meshes};
use crate::pose::poses;
use crate::room::Room;

/// The meshes of all that stands in a room but the walls of its aberrations.
pub fn standing(room: &Room, assets: &Assets) -> Vec<SolidMesh> {
    standing_again((room, &poses(room)), assets, &mut Shapes::default())
}

/// The same of a room that has changed, whose objects have these poses, with the shapes that were made for what stood there before.
pub fn standing_again(
    room: (&Room, &[DAffine3]),
    assets: &Assets,
    shapes: &mut Shapes,
) -> Vec<SolidMesh> {
    standing_meshes(room, assets, Roundness::default(), shapes)
}

/// What is met of them, each with the place of its object among all.
pub fn solids(meshes: &[SolidMesh]) -> Solids {
    let mut known: HashMap<*const Shape, Arc<Form>> = HashMap::new();
    let mut form = |shape: &Arc<Shape>| {
        let made = || Arc::new(Form::new(shape.positions.clone(), shape.triangles.clone()));
        known.entry(Arc::as_ptr(shape)).or_insert_with(made).clone()
    };
    let stands = meshes.iter().map(|it| Standing {
        form: form(&it.shape),
        pose: it.pose,
        object: it.object as u32,
    });
    Solids::new(stands.collect())
}
