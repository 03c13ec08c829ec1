//! Figures in pictures of rooms: the astronaut as a mesh that rays meet, bent anew for each picture.

use std::sync::Arc;

use antipode_rays::{Loaded, Material, Mesh, Mover, RayScene};
use antipode_render::{BentMesh, BentSurface, Gpu};
use antipode_room_scene::{RoomFigure, RoomScene, tuning};
use antipode_scene::frame::{ModelId, Posture};
use glam::Vec3;

use crate::failure::Failure;

/// Light of what glows with full strength, in noon light; as the renderer of worlds has it.
const GLOW: f32 = 3.2 * tuning::DAYLIGHT;

/// What is drawn of who walks.
#[derive(Debug)]
pub struct RoomFigures {
    astronaut: BentMesh,
    /// Its number among the meshes that may move, and that of its first material.
    mesh: usize,
    materials: usize,
    /// How it was held when it was bent last.
    posture: Option<Posture>,
}

impl RoomFigures {
    /// Adds to a scene what figures need.
    ///
    /// # Errors
    /// When a model of the game cannot be read; a test reads them all.
    pub fn add_to(scene: &mut RayScene) -> Result<Self, Failure> {
        let astronaut = BentMesh::new(ModelId::Astronaut)?;
        let materials = scene.materials.len();
        let mesh = scene.movables.len();
        let (triangles, looks) = looks(&astronaut.surfaces());
        let corners = astronaut.corners(&Posture::default());
        scene.movables.push(Arc::new(Mesh {
            positions: corners.places,
            triangles: astronaut.triangles().to_vec(),
            normals: corners.normals,
            uvs: Vec::new(),
            colours: astronaut.surfaces().iter().map(|it| it.colour).collect(),
            materials: triangles,
        }));
        scene.materials.extend(looks);
        Ok(Self {
            astronaut,
            mesh,
            materials,
            posture: None,
        })
    }

    /// Puts who walks, and what they have thrown and put down, into the next picture, at a share of the way of the last step.
    /// Nothing is done while they stay as they are.
    ///
    /// # Errors
    /// When the figure is no longer that of the scene, or squeezed to nothing.
    pub fn show(
        &mut self,
        gpu: &Gpu,
        loaded: &mut Loaded,
        (room, share): (&RoomScene, f64),
    ) -> Result<(), Failure> {
        let RoomFigure {
            posture,
            pose,
            object,
            unseen_by_eye,
        } = room.figure_between(share);
        if self.posture != Some(posture) {
            let corners = self.astronaut.corners(&posture);
            loaded.pose(&gpu.queue, self.mesh, &corners.places, &corners.normals)?;
            self.posture = Some(posture);
        }
        let mut movers = room.movers_between(share);
        movers.push(Mover {
            mesh: self.mesh,
            pose,
            object,
            materials: self.materials,
            unseen_by_eye,
        });
        Ok(loaded.show(&gpu.queue, &movers)?)
    }
}

/// The material of each triangle, and the materials: what glows has one for each of its colours.
fn looks(surfaces: &[BentSurface]) -> (Vec<u32>, Vec<Material>) {
    let mut known: Vec<Material> = Vec::new();
    let numbers = surfaces.iter().map(|surface| {
        let wanted = Material {
            colour: Vec3::ONE,
            glow: surface.colour * (surface.glow * GLOW),
            gloss: surface.gloss,
            ..Material::default()
        };
        let found = known.iter().position(|it| *it == wanted);
        found.unwrap_or_else(|| {
            known.push(wanted);
            known.len() - 1
        }) as u32
    });
    let numbers = numbers.collect();
    (numbers, known)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn the_astronaut_has_a_material_for_each_look() {
        let mut scene = RayScene {
            materials: vec![Material::default()],
            ..RayScene::default()
        };
        let figures = RoomFigures::add_to(&mut scene).unwrap();
        let mesh = &scene.movables[figures.mesh];
        assert_eq!(mesh.triangles.len(), mesh.materials.len());
        let most = *mesh.materials.iter().max().unwrap() as usize;
        assert_eq!(figures.materials + most + 1, scene.materials.len());
        let own = &scene.materials[figures.materials..];
        assert!(own.len() < 16, "{}", own.len());
        assert!(
            own.iter().any(|it| it.glow.max_element() > 0.5),
            "its lights"
        );
        assert!(own.iter().any(|it| it.gloss > 0.5), "its visor");
    }
}
