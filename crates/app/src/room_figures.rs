//! Figures in pictures of rooms: the astronaut as a mesh that rays meet, bent anew for each picture, and what is in a hand.

use std::sync::Arc;

use antipode_rays::{Loaded, Material, Mesh, Mover, RayScene};
use antipode_render::{
    BentMesh, BentSurface, Gpu, HAND_FOCAL, HandPose, Held, before_eye, in_hand_of,
};
use antipode_room_scene::{Moment, tuning};
use antipode_scene::Item;
use antipode_scene::frame::{ModelId, Posture};
use glam::{Affine3A, Vec3};

use crate::failure::Failure;

/// Light of what glows with full strength, in noon light; as the renderer of worlds has it.
const GLOW: f32 = 3.2 * tuning::DAYLIGHT;

/// How much smaller what is held before the eye is drawn, and nearer to it by as much: it looks the same there, and no wall is
/// so near to an eye that it would cut it.
const NEARER: f32 = 0.15;

/// A model of the game among the meshes that may move.
#[derive(Clone, Copy, Debug)]
struct Numbers {
    /// Its number among these meshes, and that of its first material.
    mesh: usize,
    materials: usize,
}

/// A model that was read.
#[derive(Debug)]
struct Figure {
    bent: Arc<BentMesh>,
    mesh: Arc<Mesh>,
    materials: Vec<Material>,
}

impl Figure {
    fn read(model: ModelId) -> Result<Self, Failure> {
        let bent = BentMesh::new(model)?;
        let (triangles, materials) = looks(&bent.surfaces());
        let corners = bent.corners(&Posture::default());
        let mesh = Mesh {
            positions: corners.places,
            triangles: bent.triangles().to_vec(),
            normals: corners.normals,
            uvs: Vec::new(),
            colours: bent.surfaces().iter().map(|it| it.colour).collect(),
            materials: triangles,
        };
        Ok(Self {
            bent: Arc::new(bent),
            mesh: Arc::new(mesh),
            materials,
        })
    }

    /// Adds it to the meshes of a scene that may move.
    fn add_to(&self, scene: &mut RayScene) -> Numbers {
        let numbers = Numbers {
            mesh: scene.movables.len(),
            materials: scene.materials.len(),
        };
        scene.movables.push(self.mesh.clone());
        scene.materials.extend(self.materials.iter().copied());
        numbers
    }
}

/// What figures in all rooms are drawn of.
#[derive(Debug)]
pub struct FigureModels {
    astronaut: Figure,
    /// What can be held, and its flash.
    things: Vec<(ModelId, Figure)>,
}

impl FigureModels {
    /// Reads them.
    ///
    /// # Errors
    /// When a model of the game cannot be read; a test reads them all.
    pub fn read() -> Result<Self, Failure> {
        let things = [Item::Gun.into(), ModelId::Flash];
        let things = things.map(|model| Ok((model, Figure::read(model)?)));
        Ok(Self {
            astronaut: Figure::read(ModelId::Astronaut)?,
            things: things.into_iter().collect::<Result<_, Failure>>()?,
        })
    }
}

/// What is drawn of who walks, and of what they hold.
#[derive(Debug)]
pub struct RoomFigures {
    astronaut: Arc<BentMesh>,
    numbers: Numbers,
    /// What can be held, and its flash.
    things: Vec<(ModelId, Numbers)>,
    /// How it was held when it was bent last, and where its hand was.
    posture: Option<(Posture, Option<HandPose>)>,
}

impl RoomFigures {
    /// Adds to a scene what figures need.
    pub fn add_to(scene: &mut RayScene, models: &FigureModels) -> Self {
        let numbers = models.astronaut.add_to(scene);
        let things = models.things.iter();
        let things = things.map(|(model, figure)| (*model, figure.add_to(scene)));
        Self {
            astronaut: models.astronaut.bent.clone(),
            numbers,
            things: things.collect(),
            posture: None,
        }
    }

    /// Puts who walks and what else moves into the next picture; nothing is done while all stays as it is.
    ///
    /// # Errors
    /// When the figure is no longer that of the scene, or squeezed to nothing.
    pub fn show(&mut self, gpu: &Gpu, loaded: &mut Loaded, moment: &Moment) -> Result<(), Failure> {
        let figure = &moment.figure;
        let known = self.posture.filter(|(known, _)| *known == figure.posture);
        let hand = if let Some((_, hand)) = known {
            hand
        } else {
            let corners = self.astronaut.corners(&figure.posture);
            let (places, normals) = (&corners.places, &corners.normals);
            loaded.pose(&gpu.queue, self.numbers.mesh, places, normals)?;
            let hand = self.astronaut.hand(&figure.posture);
            self.posture = Some((figure.posture, hand));
            hand
        };
        Ok(loaded.show(&gpu.queue, &self.movers(moment, hand))?)
    }

    /// All that moves; `hand` is where that of the figure is.
    fn movers(&self, moment: &Moment, hand: Option<HandPose>) -> Vec<Mover> {
        let figure = &moment.figure;
        let who = Mover {
            mesh: self.numbers.mesh,
            pose: figure.pose,
            object: figure.object,
            materials: self.numbers.materials,
            unseen_by_eye: figure.unseen_by_eye,
            held: false,
            cut: None,
        };
        let mut movers = moment.things.clone();
        movers.push(who);
        if let (Some(hand), Some(model)) = (hand, figure.held) {
            let held = in_hand_of(hand, model, figure.flashes);
            movers.extend(held.iter().filter_map(|it| self.mover(it, &who)));
        }
        if let Some(in_hand) = &moment.hand {
            let pose = in_hand.pose * before_the_eye(moment.eye.fov_y_rad as f32);
            let eye = Mover {
                pose,
                unseen_by_eye: false,
                held: true,
                cut: None,
                ..who
            };
            let held = before_eye(&in_hand.hand);
            movers.extend(held.iter().filter_map(|it| self.mover(it, &eye)));
        }
        movers
    }

    /// Something that is held, in the axes of whoever holds it.
    fn mover(&self, held: &Held, by: &Mover) -> Option<Mover> {
        let (_, numbers) = self.things.iter().find(|(model, _)| *model == held.model)?;
        Some(Mover {
            mesh: numbers.mesh,
            materials: numbers.materials,
            pose: by.pose * Affine3A::from_rotation_translation(held.turn, held.place),
            ..*by
        })
    }
}

/// From the axes of the eye to where what is held there is drawn. It is seen at the focal length that it has in worlds, whatever
/// the field of view is: a place (x, y, -z) is drawn at (x, y) F / z, and at f r x / z for the picture's own focal length f, where
/// r = F / f widens what is held.
fn before_the_eye(fov_y_rad: f32) -> Affine3A {
    let wider = HAND_FOCAL * (0.5 * fov_y_rad).tan();
    Affine3A::from_scale(NEARER * Vec3::new(wider, wider, 1.0))
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
        let models = FigureModels::read().unwrap();
        let figures = RoomFigures::add_to(&mut scene, &models);
        let mesh = &scene.movables[figures.numbers.mesh];
        assert_eq!(mesh.triangles.len(), mesh.materials.len());
        let most = *mesh.materials.iter().max().unwrap() as usize;
        let own = figures.numbers.materials;
        let own = &scene.materials[own..=own + most];
        assert!(own.len() < 16, "{}", own.len());
        assert!(
            own.iter().any(|it| it.glow.max_element() > 0.5),
            "its lights"
        );
        assert!(own.iter().any(|it| it.gloss > 0.5), "its visor");
    }

    /// A point of the gun is seen where it is in worlds, whatever the field of view is.
    #[test]
    fn what_is_held_is_seen_at_one_focal_length() {
        for degrees in [50.0_f32, 75.0, 110.0] {
            let fov_y_rad = degrees.to_radians();
            let muzzle = Vec3::new(0.22, -0.16, -0.7);
            let drawn = before_the_eye(fov_y_rad).transform_point3(muzzle);
            let seen = drawn.truncate() / (-drawn.z * (0.5 * fov_y_rad).tan());
            let in_worlds = HAND_FOCAL * muzzle.truncate() / 0.7;
            assert!(seen.distance(in_worlds) < 1e-5, "{seen} {in_worlds}");
            assert!(drawn.z > -0.15, "nearer than any wall: {drawn}");
        }
    }
}
