//! What moves in pictures of rooms: the astronaut as a mesh that rays meet, bent anew for each picture, and things that one
//! has shot, thrown and put down, which are balls.

use std::f32::consts::{PI, TAU};
use std::sync::Arc;

use antipode_rays::{Loaded, Material, Mesh, Mover, Pattern, RayScene};
use antipode_render::{BentMesh, BentSurface, Gpu};
use antipode_room_scene::{Moment, ThingKind, tuning};
use antipode_scene::frame::{ModelId, Posture};
use glam::Vec3;

use crate::failure::Failure;

/// Light of what glows with full strength, in noon light; as the renderer of worlds has it.
const GLOW: f32 = 3.2 * tuning::DAYLIGHT;

/// Most things that are drawn; rays take a few more movers.
const MOST_THINGS: usize = 500;

/// What is drawn of who walks and of things.
#[derive(Debug)]
pub struct RoomFigures {
    astronaut: BentMesh,
    /// Its number among the meshes that may move, and that of its first material.
    mesh: usize,
    materials: usize,
    /// The number of the ball among the meshes that may move, and of the first of the things' materials.
    ball: usize,
    things: usize,
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
        let ball = scene.movables.len();
        scene.movables.push(Arc::new(self::ball()));
        let things = scene.materials.len();
        scene.materials.extend(self::things());
        Ok(Self {
            astronaut,
            mesh,
            materials,
            ball,
            things,
            posture: None,
        })
    }

    /// Puts who walks and what flies and lies about into the next picture; nothing is done while they stay as they are.
    ///
    /// # Errors
    /// When the figure is no longer that of the scene, or squeezed to nothing.
    pub fn show(&mut self, gpu: &Gpu, loaded: &mut Loaded, moment: &Moment) -> Result<(), Failure> {
        let figure = &moment.figure;
        if self.posture != Some(figure.posture) {
            let corners = self.astronaut.corners(&figure.posture);
            loaded.pose(&gpu.queue, self.mesh, &corners.places, &corners.normals)?;
            self.posture = Some(figure.posture);
        }
        let who = Mover {
            mesh: self.mesh,
            pose: figure.pose,
            object: figure.object,
            materials: self.materials,
            unseen_by_eye: figure.unseen_by_eye,
        };
        let things = moment.things.iter().map(|thing| Mover {
            mesh: self.ball,
            pose: thing.pose,
            object: thing.object,
            materials: self.things + kind_number(thing.kind),
            // A bullet begins in front of the eye.
            unseen_by_eye: false,
        });
        let movers: Vec<_> = things.take(MOST_THINGS).chain([who]).collect();
        Ok(loaded.show(&gpu.queue, &movers)?)
    }
}

fn kind_number(kind: ThingKind) -> usize {
    match kind {
        ThingKind::Bullet => 0,
        ThingKind::Mark => 1,
        ThingKind::Ball => 2,
        ThingKind::Lamp => 3,
    }
}

/// How things look, in the order of their numbers.
fn things() -> [Material; 4] {
    let of = |colour: Vec3| Material {
        colour,
        ..Material::default()
    };
    [
        Material {
            glow: Vec3::new(1.0, 0.8, 0.3) * GLOW,
            ..of(Vec3::new(0.8, 0.6, 0.2))
        },
        of(Vec3::splat(0.02)),
        Material {
            pattern: Pattern::Checker {
                other: Vec3::splat(0.85),
                edge_m: 0.7,
            },
            ..of(Vec3::new(0.75, 0.06, 0.04))
        },
        Material {
            glow: Vec3::new(1.0, 0.9, 0.7) * GLOW,
            ..of(Vec3::splat(0.9))
        },
    ]
}

/// A ball of radius 1.
fn ball() -> Mesh {
    const ROUND: u32 = 16;
    const RINGS: u32 = 10;
    let at = |ring: u32, step: u32| {
        let (down, turn) = (
            PI * ring as f32 / RINGS as f32,
            TAU * step as f32 / ROUND as f32,
        );
        Vec3::new(down.sin() * turn.cos(), down.cos(), down.sin() * turn.sin())
    };
    let positions: Vec<_> = (0..=RINGS)
        .flat_map(|ring| (0..ROUND).map(move |step| at(ring, step)))
        .collect();
    let mut triangles = Vec::new();
    for (ring, step) in (0..RINGS).flat_map(|ring| (0..ROUND).map(move |step| (ring, step))) {
        let corner = |down: u32, on: u32| (ring + down) * ROUND + (step + on) % ROUND;
        if ring > 0 {
            triangles.push([corner(0, 0), corner(0, 1), corner(1, 0)]);
        }
        if ring + 1 < RINGS {
            triangles.push([corner(0, 1), corner(1, 1), corner(1, 0)]);
        }
    }
    Mesh {
        normals: positions.clone(),
        positions,
        triangles,
        ..Mesh::default()
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
        assert_eq!(figures.materials + most + 1, figures.things);
        assert_eq!(figures.things + things().len(), scene.materials.len());
        let own = &scene.materials[figures.materials..figures.things];
        assert!(own.len() < 16, "{}", own.len());
        assert!(
            own.iter().any(|it| it.glow.max_element() > 0.5),
            "its lights"
        );
        assert!(own.iter().any(|it| it.gloss > 0.5), "its visor");
    }
}
