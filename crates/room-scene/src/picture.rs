//! What pictures of a room are drawn of.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_rays::{Instance, Material, Mesh, Pattern, RayScene};
use antipode_rooms::mesh::{Look, Shape, SolidMesh};
use antipode_rooms::{Colour, What};
use glam::{Affine3A, DAffine3, Vec2, Vec3};
use image::RgbaImage;

use crate::figure::{ball, materials};
use crate::light::{fog_m, sky, sun};
use crate::looks::{Pictures, of_model, of_surface};
use crate::scene::RoomScene;
use crate::tuning::SIGN_BRIGHTNESS;

/// How far what is written on a board lies before it, metres: boards are 4 cm thick.
const BEFORE_BOARD_M: f32 = 0.022;

/// A board that something is to be written on.
#[derive(Clone, Debug, PartialEq)]
pub struct SignBoard {
    /// What it says.
    pub text: String,
    /// Its colour.
    pub colour: Colour,
    /// Width over height.
    pub aspect: f64,
}

impl RoomScene {
    /// What pictures are drawn of; `write` makes the picture of what stands on a board.
    ///
    /// # Errors
    /// Those of `write`.
    pub fn ray_scene<E, P: Into<Arc<RgbaImage>>>(
        &self,
        mut write: impl FnMut(&SignBoard) -> Result<P, E>,
    ) -> Result<RayScene, E> {
        let room = self.room();
        let mut pictures = Pictures::default();
        let mut scene = RayScene {
            movables: vec![Arc::new(ball())],
            materials: [Material::default()]
                .into_iter()
                .chain(materials())
                .collect(),
            aberrations: self.space.clone(),
            lamps: self.own_lamps(),
            sun: sun(room),
            sky: sky(room),
            fog_m: fog_m(room),
            // Astride the doors of aberrations.
            cuts: !self.boxes.is_empty() && !self.loose_meshes.is_empty(),
            ..RayScene::default()
        };
        for solid in &self.loose_meshes {
            scene.movables.push(Arc::new(mesh_of(&solid.shape)));
            scene.materials.push(self.material_of(solid, &mut pictures));
        }
        for index in &self.boxes {
            let what = &room.objects[*index].what;
            let is_outlined = matches!(what, What::Aberration(it) if it.outline);
            scene.outlined.push(is_outlined);
            scene.wall_materials.push(scene.materials.len());
            let surface = &room.objects[*index].surface;
            let material = of_surface(surface, &self.assets, &mut pictures);
            scene.materials.push(material);
        }
        self.add_solids(&mut scene, &mut pictures);
        self.add_writing(&mut scene, &mut pictures, &mut write)?;
        scene.textures = pictures.all;
        Ok(scene)
    }

    fn add_solids(&self, scene: &mut RayScene, pictures: &mut Pictures) {
        let mut known: HashMap<*const Shape, usize> = HashMap::new();
        scene.instances.reserve(self.meshes.len());
        scene.materials.reserve(self.meshes.len());
        for solid in &self.meshes {
            let mesh = *known.entry(Arc::as_ptr(&solid.shape)).or_insert_with(|| {
                scene.meshes.push(Arc::new(mesh_of(&solid.shape)));
                scene.meshes.len() - 1
            });
            let material = self.material_of(solid, pictures);
            scene.instances.push(Instance {
                mesh,
                pose: pose_of(&solid.pose),
                object: solid.object as u32,
                materials: scene.materials.len(),
            });
            scene.materials.push(material);
        }
    }

    fn material_of(&self, solid: &SolidMesh, pictures: &mut Pictures) -> Material {
        match &solid.look {
            Look::Surface(surface) => of_surface(surface, &self.assets, pictures),
            Look::Model { file, material } => of_model(file, *material, &self.assets, pictures),
        }
    }

    fn add_writing<E, P: Into<Arc<RgbaImage>>>(
        &self,
        scene: &mut RayScene,
        pictures: &mut Pictures,
        write: &mut dyn FnMut(&SignBoard) -> Result<P, E>,
    ) -> Result<(), E> {
        let room = self.room();
        for (index, (object, pose)) in room.objects.iter().zip(self.poses()).enumerate() {
            let What::Sign { text, size } = &object.what else {
                continue;
            };
            let board = SignBoard {
                text: text.as_ref().unwrap_or(&room.sentence).clone(),
                colour: object.surface.colour,
                aspect: size.x / size.y,
            };
            let number = pictures.add(write(&board)?);
            let repeats = 1.0;
            let look = of_surface(&object.surface, &self.assets, &mut Pictures::default());
            scene.meshes.push(Arc::new(face(size.as_vec2())));
            scene.instances.push(Instance {
                mesh: scene.meshes.len() - 1,
                pose: pose_of(pose),
                object: index as u32,
                materials: scene.materials.len(),
            });
            scene.materials.push(Material {
                colour: Vec3::splat(SIGN_BRIGHTNESS),
                pattern: Pattern::Texture { number, repeats },
                glow: look.glow,
                ..Material::default()
            });
        }
        Ok(())
    }
}

fn pose_of(pose: &DAffine3) -> Affine3A {
    pose.as_affine3a()
}

fn mesh_of(shape: &Shape) -> Mesh {
    Mesh {
        positions: shape.positions.iter().map(|it| it.as_vec3()).collect(),
        triangles: shape.triangles.clone(),
        normals: shape.normals.iter().map(|it| it.as_vec3()).collect(),
        uvs: shape.uvs.iter().map(|it| it.as_vec2()).collect(),
        colours: Vec::new(),
        materials: Vec::new(),
    }
}

/// The front of a board, +x, with a picture on it that is upright for who looks at it: their right is -z.
fn face(size: Vec2) -> Mesh {
    let half = size / 2.0;
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Mesh {
        positions: corners
            .iter()
            .map(|(right, up)| Vec3::new(BEFORE_BOARD_M, up * half.y, -right * half.x))
            .collect(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        normals: Vec::new(),
        uvs: corners
            .iter()
            .map(|(right, up)| Vec2::new(0.5 + 0.5 * right, 0.5 - 0.5 * up))
            .collect(),
        colours: Vec::new(),
        materials: Vec::new(),
    }
}
