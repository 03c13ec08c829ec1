//! What a picture is made of, in plain types. Colours are linear light; metres are the scene's unless they are called felt.

use std::sync::Arc;

use antipode_deformation::{Place, Space};
use glam::{Affine3A, DVec3, Vec3, Vec4};

use crate::mesh::Mesh;

/// Lamps that shine at most.
pub const MAX_LAMPS: usize = 8;
/// The number of a material for walls of aberrations that have been given none.
pub const WALL_DEFAULT: usize = 0;

/// All of a room.
#[derive(Clone, Debug, Default)]
pub struct RayScene {
    /// Meshes of what stays where it is, by number.
    pub meshes: Vec<Arc<Mesh>>,
    /// Meshes that may be elsewhere and have another shape in each picture, by a number of their own.
    pub movables: Vec<Arc<Mesh>>,
    /// Whether movers may be cut; where there are portals they may always be.
    pub cuts: bool,
    /// Materials, by number; there must be one at least.
    pub materials: Vec<Material>,
    /// Pictures on surfaces, by number.
    pub textures: Vec<Arc<TextureImage>>,
    /// Meshes where they stand, as long as the scene is loaded.
    pub instances: Vec<Instance>,
    /// Aberrations and portals.
    pub aberrations: Space,
    /// Number of the material of each aberration's walls; [`WALL_DEFAULT`] for those that are missing.
    pub wall_materials: Vec<usize>,
    /// Whether each aberration is outlined; those that are missing are not.
    pub outlined: Vec<bool>,
    /// How outlines look.
    pub outline: Outline,
    /// Lamps; the first [`MAX_LAMPS`] shine.
    pub lamps: Vec<Lamp>,
    /// The sun, if it shines.
    pub sun: Option<Sun>,
    /// Sky and the light that is everywhere.
    pub sky: Sky,
    /// Felt metres at which fog is complete.
    pub fog_m: f32,
}

/// A mesh that stands somewhere.
#[derive(Clone, Copy, Debug)]
pub struct Instance {
    /// Number of its mesh.
    pub mesh: usize,
    /// From the mesh's coordinates to the scene's. Must have an inverse.
    pub pose: Affine3A,
    /// What it is called where it is seen.
    pub object: u32,
    /// Added to the numbers of the mesh's materials.
    pub materials: usize,
}

/// A mesh that may move, where it is in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mover {
    /// Number of its mesh among those that may move.
    pub mesh: usize,
    /// From the mesh's coordinates to the scene's: any that has an inverse, as that of who is squeezed by an aberration.
    pub pose: Affine3A,
    /// What it is called where it is seen.
    pub object: u32,
    /// Added to the numbers of the mesh's materials.
    pub materials: usize,
    /// Whether the eye looks through it: it is seen in mirrors only, and throws a shadow.
    pub unseen_by_eye: bool,
    /// Whether only the eye sees it, as what who looks holds before it: it throws no shadow but on itself, and what the eye
    /// looks through throws none on it.
    pub held: bool,
    /// Only what is before this plane is there: (n, -d) for n.x >= d in the scene, as of who stands astride a portal.
    pub cut: Option<Vec4>,
}

/// How a surface looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Share of light that it throws back.
    pub colour: Vec3,
    /// What is on it.
    pub pattern: Pattern,
    /// Light of its own.
    pub glow: Vec3,
    /// Share of light that it mirrors, 0 to 1.
    pub mirror: f32,
    /// Index of refraction of glass, from 1; `None` for what is opaque.
    pub glass: Option<f32>,
    /// Strength of highlights, 0 to 1.
    pub gloss: f32,
}

/// What is on a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Pattern {
    /// Nothing.
    #[default]
    Plain,
    /// Squares of the material's colour and another one.
    Checker {
        /// The other colour.
        other: Vec3,
        /// Edge of a square, metres of the mesh as it stands; felt metres on walls of aberrations.
        edge_m: f32,
    },
    /// A picture, by number, that the colour is multiplied by.
    Texture {
        /// Which.
        number: usize,
        /// How often it is repeated for one of uv.
        repeats: f32,
    },
}

/// A picture that lies on surfaces.
#[derive(Clone, Debug)]
pub struct TextureImage {
    /// sRGB values.
    pub image: Arc<image::RgbaImage>,
}

/// Light that goes all ways from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Where it is.
    pub place: Place,
    /// Its light at no distance.
    pub colour: Vec3,
    /// Felt metres at which it has faded away.
    pub reach_m: f32,
    /// What is nearer than this throws no shadow, metres: the lamp itself may be a thing that is seen.
    pub radius_m: f32,
}

/// Light that comes from one felt direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Felt direction towards it, of length 1.
    pub direction: DVec3,
    /// Its light.
    pub colour: Vec3,
}

/// The sky, and light from all about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Felt direction upwards, of length 1.
    pub zenith: DVec3,
    /// Light overhead.
    pub top: Vec3,
    /// Light at the horizon.
    pub horizon: Vec3,
    /// What is seen below the horizon.
    pub ground: Vec3,
    /// Light from above on surfaces.
    pub ambient_sky: Vec3,
    /// Light from below on surfaces.
    pub ambient_ground: Vec3,
}

/// How outlines of aberrations look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Their light.
    pub colour: Vec3,
    /// How opaque they are, 0 to 1.
    pub strength: f32,
}

/// Whoever looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Where the eye is.
    pub place: Place,
    /// Felt direction into the picture; it, right and up are of length 1 and at right angles.
    pub front: DVec3,
    /// Felt direction to the right of the picture.
    pub right: DVec3,
    /// Felt direction to the top of the picture.
    pub up: DVec3,
    /// Angle between the top and the bottom of the picture, rad.
    pub fov_y_rad: f64,
    /// Half the height of the picture where all is seen along parallel lines, metres of the scene; none where the lines meet in the
    /// eye. Such an eye is in no aberration.
    pub parallel_m: Option<f64>,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            colour: Vec3::splat(0.7),
            pattern: Pattern::Plain,
            glow: Vec3::ZERO,
            mirror: 0.0,
            glass: None,
            gloss: 0.0,
        }
    }
}

impl Default for Sky {
    fn default() -> Self {
        Self {
            zenith: DVec3::Y,
            top: Vec3::new(0.16, 0.32, 0.62),
            horizon: Vec3::new(0.55, 0.66, 0.78),
            ground: Vec3::new(0.20, 0.19, 0.18),
            ambient_sky: Vec3::new(0.26, 0.30, 0.36),
            ambient_ground: Vec3::new(0.13, 0.12, 0.11),
        }
    }
}

impl Default for Outline {
    fn default() -> Self {
        Self {
            colour: Vec3::new(1.0, 0.72, 0.12),
            strength: 0.9,
        }
    }
}

impl Eye {
    /// An eye at a place of the scene that looks in felt direction `front`, its up as near to `up` as can be.
    pub fn looking(place: Place, front: DVec3, up: DVec3, fov_y_rad: f64) -> Self {
        let front = front.normalize_or(DVec3::NEG_Z);
        let right = front
            .cross(up)
            .try_normalize()
            .unwrap_or_else(|| front.any_orthonormal_vector());
        Self {
            place,
            front,
            right,
            up: right.cross(front),
            fov_y_rad,
            parallel_m: None,
        }
    }

    /// Where the light of a place of the picture, from -1 at the left and the bottom to 1, comes in.
    pub fn start(&self, x: f64, y: f64, aspect: f64) -> Place {
        let Some(half) = self.parallel_m else {
            return self.place;
        };
        let mut place = self.place;
        place.point += self.right * (x * half * aspect) + self.up * (y * half);
        place
    }

    /// The felt direction of a place of the picture, from -1 at the left and the bottom to 1; of length 1.
    pub fn direction(&self, x: f64, y: f64, aspect: f64) -> DVec3 {
        if self.parallel_m.is_some() {
            return self.front;
        }
        let half = (0.5 * self.fov_y_rad).tan();
        (self.front + self.right * (x * half * aspect) + self.up * (y * half)).normalize()
    }
}
