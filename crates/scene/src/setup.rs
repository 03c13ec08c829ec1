//! What makes a world the one it is, and between that and what its save says of it.

use std::str::FromStr;
use std::time::{SystemTime, UNIX_EPOCH};

use antipode_geometry::Geometry;
use antipode_storage::{StorageError, WorldMeta};
use antipode_streaming::StreamingError;
use antipode_terrain::{Biome, Generator};
use thiserror::Error;

use crate::tuning::VIEW_DISTANCE_CHUNKS;

/// Why a world could not be opened.
#[derive(Debug, Error)]
pub enum SceneError {
    /// Its save could not be read.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// Its chunk workers could not be started.
    #[error(transparent)]
    Streaming(#[from] StreamingError),
    /// Its save names a geometry this program does not know.
    #[error(
        "The world \"{name}\" is in a space this version does not know (\"{geometry}\"). A newer version of the game may open it."
    )]
    UnknownGeometry {
        /// The world's name.
        name: String,
        /// What the save says.
        geometry: String,
    },
    /// Its save names a generator of land this program does not know.
    #[error(
        "The land of the world \"{name}\" is made in a way this version does not know ({generator}). A newer version of the game may open it."
    )]
    UnknownGenerator {
        /// The world's name.
        name: String,
        /// What the save says.
        generator: u16,
    },
    /// Its save names a radius that no world can have.
    #[error(
        "The world \"{name}\" says that its space has a radius of {radius_m} m, and no world can have that. Its file was left as it is."
    )]
    ImpossibleRadius {
        /// The world's name.
        name: String,
        /// What the save says.
        radius_m: f64,
    },
}

/// What building costs in a world.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Nothing; one begins with every tool.
    #[default]
    Creative,
    /// What was dug: building spends it, and tools are made of it.
    Gathering,
}

impl Mode {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Creative, Self::Gathering];

    /// Its lower-case English word, as scripts and the probe have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Creative => "creative",
            Self::Gathering => "gathering",
        }
    }
}

impl FromStr for Mode {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let mode = Self::ALL.into_iter().find(|mode| mode.name() == word);
        mode.ok_or_else(|| "a mode is creative or gathering".to_owned())
    }
}

/// What makes a world the one it is.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldSetup {
    /// Its name.
    pub name: String,
    /// Seed of its terrain.
    pub seed: u64,
    /// Its geometry.
    pub geometry: Geometry,
    /// Radius of curvature in metres; ignored where space is flat.
    pub radius_m: f64,
    /// What makes its land.
    pub generator: Generator,
    /// What building costs.
    pub mode: Mode,
    /// How far chunks are loaded, in chunks.
    pub view_distance: u32,
}

impl WorldSetup {
    /// The same, with a view distance that can be had.
    pub(crate) fn within_range(self) -> Self {
        let (least, most, _) = VIEW_DISTANCE_CHUNKS;
        Self {
            view_distance: self.view_distance.clamp(least, most),
            ..self
        }
    }

    /// The setup a save describes, with the given view distance where the save has none of its own.
    ///
    /// # Errors
    /// When the save names a geometry or a generator this version does not know, or a radius that no world can have.
    pub fn from_meta(meta: &WorldMeta, view_distance: u32) -> Result<Self, SceneError> {
        let geometry: Geometry =
            meta.geometry
                .parse()
                .map_err(|_| SceneError::UnknownGeometry {
                    name: meta.name.clone(),
                    geometry: meta.geometry.clone(),
                })?;
        let saved_m = geometry.radii().saved_m.as_ref();
        if saved_m.is_some_and(|range| !range.contains(&meta.radius_m)) {
            return Err(SceneError::ImpossibleRadius {
                name: meta.name.clone(),
                radius_m: meta.radius_m,
            });
        }
        let generator =
            Generator::of_number(meta.generator).ok_or_else(|| SceneError::UnknownGenerator {
                name: meta.name.clone(),
                generator: meta.generator,
            })?;
        Ok(Self {
            name: meta.name.clone(),
            seed: meta.seed,
            geometry,
            radius_m: meta.radius_m,
            generator,
            mode: if meta.gathering {
                Mode::Gathering
            } else {
                Mode::Creative
            },
            view_distance,
        })
    }

    /// The record of a world made now.
    pub fn to_meta(&self) -> WorldMeta {
        let now = unix_now_s();
        WorldMeta {
            name: self.name.clone(),
            seed: self.seed,
            geometry: self.geometry.to_string(),
            radius_m: self.radius_m,
            biome: if self.generator.has_climates() {
                String::new()
            } else {
                Biome::from_seed(self.seed).name().to_owned()
            },
            created_unix_s: now,
            last_played_unix_s: now,
            played_s: 0.0,
            cheated: false,
            generator: self.generator.number(),
            gathering: self.mode == Mode::Gathering,
        }
    }
}

fn unix_now_s() -> u64 {
    SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |since| since.as_secs())
}
