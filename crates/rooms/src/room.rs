//! What a room is: plain data, in metres and, for turns, in degrees. `docs/rooms.md` has the file that it is read from.
//!
//! Axes: y is up. A turn is (yaw, pitch, roll); it takes an object's own +x axis, its front, to where
//! `aim YAW PITCH` looks: (cos yaw cos pitch, sin pitch, sin yaw cos pitch), and rolls it about that.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use foldhash::fast::FixedState;
use glam::{DVec2, DVec3};
use serde::{Deserialize, Deserializer};

use crate::aberration::Aberration;
use crate::colour::Colour;
use crate::portal::Portal;

/// The version of the file that is written; older ones are read, newer ones refused.
pub const VERSION: u32 = 1;

/// Where objects are among all others, by their names.
pub type Places<'r> = HashMap<&'r str, usize, FixedState>;

/// Names of objects.
pub type Names<'r> = HashSet<&'r str, FixedState>;

/// A room.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Room {
    /// The version of the file that it was read from; [`VERSION`] in memory.
    pub version: u32,
    /// What it is called, 1 to 40 characters.
    pub name: String,
    /// What is strange in it, in one sentence; signs without a text show it.
    #[serde(default)]
    pub sentence: String,
    /// What falls is drawn this way, metres per second squared.
    #[serde(default = "default_gravity")]
    pub gravity: DVec3,
    /// What is seen where nothing stands.
    #[serde(default)]
    pub sky: Sky,
    /// A light from one direction; none indoors.
    #[serde(default)]
    pub sun: Option<Sun>,
    /// What hides what is far.
    #[serde(default)]
    pub fog: Option<Fog>,
    /// Where one begins.
    #[serde(default)]
    pub spawn: Spawn,
    /// What stands in it, at most 2,000; each has a name of its own.
    ///
    /// Copies of a room share them: an editor keeps a thousand rooms that differ in a few things each.
    #[serde(default, deserialize_with = "shared")]
    pub objects: Vec<Arc<Object>>,
}

/// What is seen where nothing stands, and the light that comes from everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Sky {
    /// Its colour.
    pub colour: Colour,
    /// How bright the light from everywhere is; the noon sun is 1.
    pub light: f64,
}

impl Default for Sky {
    fn default() -> Self {
        Self {
            colour: Colour([0x8f, 0xb7, 0xe6]),
            light: 0.35,
        }
    }
}

/// A light from one felt direction, the same behind every aberration.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Sun {
    /// Where it stands: (yaw, pitch), degrees.
    pub aim: DVec2,
    /// Its colour.
    pub colour: Colour,
    /// How bright it is; at noon 1.
    pub power: f64,
}

impl Default for Sun {
    fn default() -> Self {
        Self {
            aim: DVec2::new(-60.0, 50.0),
            colour: Colour([0xff, 0xf4, 0xe0]),
            power: 1.0,
        }
    }
}

/// What hides what is far, by felt length.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fog {
    /// Its colour.
    pub colour: Colour,
    /// Where nothing is seen any more, felt metres, 1 to 100,000.
    pub reach: f64,
}

/// Where one begins.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Spawn {
    /// Where one's feet are.
    pub at: DVec3,
    /// Where one looks: (yaw, pitch), degrees.
    pub look: DVec2,
}

impl Default for Spawn {
    fn default() -> Self {
        Self {
            at: DVec3::ZERO,
            look: DVec2::new(-90.0, 0.0),
        }
    }
}

/// Something that stands in a room.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// Its name, its own among all objects: letters, digits, `-`, `_`, `.`, and blanks between them.
    pub name: String,
    /// Where its middle is; a model's origin. In a group, from the group.
    #[serde(default)]
    pub at: DVec3,
    /// (yaw, pitch, roll), degrees.
    #[serde(default)]
    pub turn: DVec3,
    /// What it is.
    pub what: What,
    /// How it looks; a model looks as its file says.
    #[serde(default)]
    pub surface: Surface,
    /// How heavy it is, kilograms. What has a mass is loose: it falls, rolls, and is pushed, carried and thrown. Without one it
    /// stands where it is.
    #[serde(default, deserialize_with = "said")]
    pub mass: Option<f64>,
    /// The group that carries it.
    #[serde(default)]
    pub group: Option<String>,
}

/// What something is. Sizes are whole lengths along its own x, y and z axis.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum What {
    /// A block.
    Box {
        /// Lengths along its axes.
        size: DVec3,
    },
    /// A pyramid with its tip up.
    Pyramid {
        /// Lengths along its axes.
        size: DVec3,
    },
    /// A wedge that rises to its front.
    Ramp {
        /// Lengths along its axes.
        size: DVec3,
    },
    /// An upright cylinder.
    Cylinder {
        /// Half its width.
        radius: f64,
        /// Its height.
        height: f64,
    },
    /// A ball.
    Ball {
        /// Half its width.
        radius: f64,
    },
    /// Stairs that rise to their front.
    Stairs {
        /// Lengths along their axes.
        size: DVec3,
        /// How many steps.
        steps: u32,
    },
    /// A block with a gate through it from back to front, round at its top.
    Arch {
        /// Lengths along its axes.
        size: DVec3,
        /// Width and height of the gate; the height is at least half the width.
        opening: DVec2,
    },
    /// A model from a file.
    Model {
        /// The file, under `models/`.
        file: String,
        /// What its metres are multiplied by.
        #[serde(default = "one")]
        scale: f64,
    },
    /// A lamp: light from one point.
    Light {
        /// Its colour.
        #[serde(default = "white")]
        colour: Colour,
        /// How bright it is at one felt metre; the noon sun is 1.
        power: f64,
    },
    /// A box that makes space longer or shorter in it.
    Aberration(Aberration),
    /// An opening that leads to another one.
    Portal(Portal),
    /// A board to read, on its front.
    Sign {
        /// What it says; without it, the room's sentence.
        #[serde(default)]
        text: Option<String>,
        /// Width and height of the board.
        #[serde(default = "board")]
        size: DVec2,
    },
    /// What carries others, which name it as their group.
    Group,
}

/// How something looks.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Surface {
    /// Its colour; it multiplies the texture.
    pub colour: Colour,
    /// Squares of a second colour.
    pub checker: Option<Checker>,
    /// A picture.
    pub texture: Option<Texture>,
    /// Light of its own, 0 or more; the noon sun is 1.
    pub glow: f64,
    /// What light does on it.
    pub finish: Finish,
}

impl Default for Surface {
    fn default() -> Self {
        Self {
            colour: Colour([0xb8, 0xb8, 0xb0]),
            checker: None,
            texture: None,
            glow: 0.0,
            finish: Finish::Matt,
        }
    }
}

/// Squares of a second colour.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checker {
    /// The second colour.
    pub colour: Colour,
    /// The side of a square, metres of the scene.
    #[serde(default = "one")]
    pub size: f64,
}

/// A picture on a surface, repeated.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Texture {
    /// The file, under `textures/`.
    pub file: String,
    /// How wide and high one picture is, metres of the scene.
    #[serde(default = "one")]
    pub size: f64,
}

/// What light does on a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Finish {
    /// It is scattered.
    #[default]
    Matt,
    /// It is mirrored.
    Mirror,
    /// It passes, and a part is mirrored.
    Glass,
}

/// What falls is drawn down as on Earth.
pub fn default_gravity() -> DVec3 {
    DVec3::new(0.0, -9.81, 0.0)
}

/// Width and height of a board that says nothing of them.
pub fn board() -> DVec2 {
    DVec2::new(2.4, 0.8)
}

/// A number that is written as one, without `Some(...)`.
fn said<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    f64::deserialize(from).map(Some)
}

/// Objects, each to be shared by rooms.
fn shared<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<Arc<Object>>, D::Error> {
    let all = Vec::<Object>::deserialize(from)?;
    Ok(all.into_iter().map(Arc::new).collect())
}

fn one() -> f64 {
    1.0
}

fn white() -> Colour {
    Colour::WHITE
}

impl Object {
    /// Something with no turn, in no group, that looks as what nothing is said of.
    pub fn new(name: &str, at: DVec3, what: What) -> Self {
        Self {
            name: name.to_owned(),
            at,
            turn: DVec3::ZERO,
            what,
            surface: Surface::default(),
            mass: None,
            group: None,
        }
    }
}

impl What {
    /// The word for it in commands, lists and sentences.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Box { .. } => "box",
            Self::Pyramid { .. } => "pyramid",
            Self::Ramp { .. } => "ramp",
            Self::Cylinder { .. } => "cylinder",
            Self::Ball { .. } => "ball",
            Self::Stairs { .. } => "stairs",
            Self::Arch { .. } => "arch",
            Self::Model { .. } => "model",
            Self::Light { .. } => "light",
            Self::Aberration(_) => "aberration",
            Self::Portal(_) => "portal",
            Self::Sign { .. } => "sign",
            Self::Group => "group",
        }
    }
}

impl Room {
    /// A room to begin with: a floor 200 by 200 m at y = 0, daylight, and a spawn at its middle that looks along -z.
    pub fn new(name: &str) -> Self {
        let mut floor = Object::new(
            "floor",
            DVec3::new(0.0, -0.5, 0.0),
            What::Box {
                size: DVec3::new(200.0, 1.0, 200.0),
            },
        );
        floor.surface.colour = Colour([0x9a, 0xa0, 0x94]);
        floor.surface.checker = Some(Checker {
            colour: Colour([0x84, 0x8a, 0x7e]),
            size: 2.0,
        });
        Self {
            version: VERSION,
            name: name.trim().to_owned(),
            sentence: String::new(),
            gravity: default_gravity(),
            sky: Sky::default(),
            sun: Some(Sun::default()),
            fog: None,
            spawn: Spawn::default(),
            objects: vec![Arc::new(floor)],
        }
    }

    /// Puts an object in, behind all others.
    pub fn push(&mut self, object: Object) {
        self.objects.push(Arc::new(object));
    }

    /// An object to be changed; other rooms that share it keep it as it is.
    pub fn object_mut(&mut self, index: usize) -> &mut Object {
        Arc::make_mut(&mut self.objects[index])
    }

    /// The object of that name, and its place among all.
    pub fn find(&self, name: &str) -> Option<(usize, &Object)> {
        self.objects
            .iter()
            .map(Arc::as_ref)
            .enumerate()
            .find(|(_, object)| object.name == name)
    }

    /// The names of all objects, in their order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.objects.iter().map(|it| it.name.as_str())
    }

    /// The places of all objects among themselves by their names, for who looks for many.
    pub fn places(&self) -> Places<'_> {
        let all = self.objects.iter().enumerate();
        all.map(|(index, it)| (it.name.as_str(), index)).collect()
    }

    /// What is loose, each with its place among all objects and its mass, kilograms.
    pub fn loose(&self) -> impl Iterator<Item = (usize, &Object, f64)> {
        let all = self.objects.iter().enumerate();
        all.filter_map(|(index, object)| object.mass.map(|mass| (index, object.as_ref(), mass)))
    }

    /// The portals, each with its place among all objects.
    pub fn portals(&self) -> impl Iterator<Item = (usize, &Portal)> {
        self.objects
            .iter()
            .enumerate()
            .filter_map(|(index, object)| match &object.what {
                What::Portal(portal) => Some((index, portal)),
                _ => None,
            })
    }

    /// The aberrations, each with its place among all objects.
    pub fn aberrations(&self) -> impl Iterator<Item = (usize, &Aberration)> {
        self.objects
            .iter()
            .enumerate()
            .filter_map(|(index, object)| match &object.what {
                What::Aberration(aberration) => Some((index, aberration)),
                _ => None,
            })
    }
}
