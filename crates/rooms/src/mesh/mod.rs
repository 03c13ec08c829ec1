//! Triangles of what stands in a room: its solids, the walls of its aberrations, its signs and its models.
//!
//! Everything is in its object's own axes, with the pose that takes it into the room; equal solids share one [`Shape`].

mod blocks;
mod builder;
mod round;
mod shapes;
mod walls;

use std::sync::Arc;

use glam::{DAffine3, DVec2, DVec3};

use crate::folder::Assets;
use crate::pose::poses;
use crate::room::{Room, Surface, What};
use builder::Builder;

pub use shapes::Shapes;
pub use walls::{WALL_INSIDE_M, WALL_OUTSIDE_M};

/// How thick the board of a sign is, metres.
const BOARD_M: f64 = 0.04;

/// Triangles in their object's own axes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shape {
    /// Corners, metres.
    pub positions: Vec<DVec3>,
    /// Unit vectors away from the inside, one a corner.
    pub normals: Vec<DVec3>,
    /// One a corner. On solids, metres along the surface; on models, places in their texture.
    pub uvs: Vec<DVec2>,
    /// Corners of each triangle, anticlockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// How something looks.
#[derive(Debug, Clone, PartialEq)]
pub enum Look {
    /// As its object says.
    Surface(Surface),
    /// As the material of this number of the model in this file says.
    Model {
        /// The file.
        file: String,
        /// Index into the materials of its model.
        material: usize,
    },
}

/// A shape at its place in a room.
#[derive(Debug, Clone, PartialEq)]
pub struct SolidMesh {
    /// The place of its object among all.
    pub object: usize,
    /// From its own axes to the room's.
    pub pose: DAffine3,
    /// Its triangles.
    pub shape: Arc<Shape>,
    /// How it looks.
    pub look: Look,
}

/// How round what is round is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Roundness {
    /// Parts of a full turn, 3 or more.
    pub around: u32,
}

impl Default for Roundness {
    fn default() -> Self {
        Self { around: 48 }
    }
}

/// The triangles of all that stands in a room, in the order of its objects. Models that `assets` does not have are left
/// out.
pub fn meshes(room: &Room, assets: &Assets, roundness: Roundness) -> Vec<SolidMesh> {
    let walls = |what: &What| shape(what, roundness).map(Arc::new);
    let shapes = &mut Shapes::default();
    listed((room, &poses(room)), assets, |what| match what {
        What::Aberration(_) => walls(what),
        _ => shapes.of(what, roundness),
    })
}

/// The same without the walls of aberrations, of a room whose objects have these poses, with the shapes that are made already.
pub fn standing_meshes(
    room: (&Room, &[DAffine3]),
    assets: &Assets,
    roundness: Roundness,
    shapes: &mut Shapes,
) -> Vec<SolidMesh> {
    let all = listed(room, assets, |what| shapes.of(what, roundness));
    shapes.end_round();
    all
}

fn listed(
    (room, poses): (&Room, &[DAffine3]),
    assets: &Assets,
    mut shape_of: impl FnMut(&What) -> Option<Arc<Shape>>,
) -> Vec<SolidMesh> {
    let mut out = Vec::with_capacity(room.objects.len());
    for (object, (it, pose)) in room.objects.iter().zip(poses).enumerate() {
        if let What::Model { file, scale } = &it.what {
            let Some(model) = assets.models.get(file) else {
                continue;
            };
            let pose = *pose * DAffine3::from_scale(DVec3::splat(*scale));
            out.extend(model.parts.iter().map(|part| SolidMesh {
                object,
                pose,
                shape: Arc::clone(&part.shape),
                look: Look::Model {
                    file: file.clone(),
                    material: part.material,
                },
            }));
            continue;
        }
        out.extend(shape_of(&it.what).map(|shape| SolidMesh {
            object,
            pose: *pose,
            shape,
            look: Look::Surface(it.surface.clone()),
        }));
    }
    out
}

/// The triangles of something that is no model; nothing for what cannot be touched.
pub fn shape(what: &What, roundness: Roundness) -> Option<Shape> {
    let around = roundness.around.max(3);
    let half = match what {
        What::Box { size }
        | What::Pyramid { size }
        | What::Ramp { size }
        | What::Stairs { size, .. }
        | What::Arch { size, .. } => *size / 2.0,
        _ => DVec3::ZERO,
    };
    let mut builder = Builder {
        half,
        ..Builder::default()
    };
    match what {
        What::Box { size } => blocks::block(&mut builder, -*size / 2.0, *size / 2.0),
        What::Pyramid { size } => blocks::pyramid(&mut builder, *size),
        What::Ramp { size } => blocks::ramp(&mut builder, *size),
        What::Stairs { size, steps } => blocks::stairs(&mut builder, *size, *steps),
        What::Arch { size, opening } => blocks::arch(&mut builder, *size, *opening, around / 2),
        What::Cylinder { radius, height } => {
            round::cylinder(&mut builder, *radius, *height, around);
        }
        What::Ball { radius } => round::ball(&mut builder, *radius, around),
        What::Sign { size, .. } => {
            let half = DVec3::new(BOARD_M, size.y, size.x) / 2.0;
            blocks::block(&mut builder, -half, half);
        }
        What::Aberration(it) => walls::walls(&mut builder, it),
        What::Model { .. } | What::Light { .. } | What::Portal(_) | What::Group => {}
    }
    (!builder.shape.triangles.is_empty()).then_some(builder.shape)
}

impl Shape {
    /// What the surface holds, cubic metres: a sixth of the sum of a . (b x c) over its triangles, by Gauss's theorem.
    /// Of a closed surface whose triangles all face outward it is what a ruler would find.
    pub fn volume_m3(&self) -> f64 {
        let of = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|it| self.positions[it as usize]);
            a.dot(b.cross(c)) / 6.0
        };
        self.triangles.iter().map(of).sum()
    }
}
