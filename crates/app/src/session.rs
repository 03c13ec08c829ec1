//! Worlds on disk and the one that is open: making, loading, listing and deleting, for window and script alike.

use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::path::PathBuf;
use std::sync::Arc;

use antipode_geometry::{DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M, Geometry};
use antipode_scene::tuning::VIEW_DISTANCE_CHUNKS;
use antipode_scene::{Scene, WorldSetup};
use antipode_storage::{SavesDir, WorldSummary, saves_dir};

use crate::cli::Common;
use crate::failure::Failure;

/// Radius of a spherical world in metres, smallest and largest.
pub const SPHERE_RADIUS_M: std::ops::RangeInclusive<f64> = 16.0..=64.0;

/// What a new world is asked to be.
#[derive(Clone, Debug, PartialEq)]
pub struct NewWorld {
    /// Its space.
    pub geometry: Geometry,
    /// Its name; without one a script's world is not kept.
    pub name: Option<String>,
    /// Its seed; random when left out.
    pub seed: Option<u64>,
    /// Radius of a spherical world in metres.
    pub radius_m: Option<f64>,
}

/// An open world.
#[derive(Debug)]
pub struct Session {
    /// The world.
    pub scene: Scene,
    /// Its directory's name; empty for a world that is not kept.
    pub slug: String,
}

/// The place where worlds are kept, and the view distance that new sessions get.
#[derive(Clone, Debug)]
pub struct Worlds {
    saves: SavesDir,
    view_distance: Option<u32>,
}

impl Worlds {
    /// The place the command line, the environment or the platform names.
    pub fn new(common: &Common) -> Self {
        let path: PathBuf = saves_dir(common.saves_dir.as_deref());
        Self {
            saves: SavesDir::new(path),
            view_distance: common.view_distance,
        }
    }

    /// The directory of worlds.
    pub fn saves(&self) -> &SavesDir {
        &self.saves
    }

    /// Every world, newest first.
    ///
    /// # Errors
    /// When the directory cannot be read.
    pub fn list(&self) -> Result<Vec<WorldSummary>, Failure> {
        Ok(self.saves.list()?)
    }

    /// Makes a world and opens it. One without a name is not kept.
    ///
    /// # Errors
    /// When the name or radius will not do, or the disk refuses.
    pub fn create(&self, wanted: &NewWorld) -> Result<Session, Failure> {
        let setup = self.setup(wanted)?;
        let Some(_) = wanted.name else {
            return Ok(Session {
                scene: Scene::open(setup, None)?,
                slug: String::new(),
            });
        };
        let (slug, store) = self.saves.create(&setup.to_meta())?;
        Ok(Session {
            scene: Scene::open(setup, Some(Arc::new(store)))?,
            slug,
        })
    }

    /// Opens a saved world by name or slug.
    ///
    /// # Errors
    /// When there is none, it is open elsewhere, or it is damaged.
    pub fn load(&self, name: &str) -> Result<Session, Failure> {
        let summary = self.saves.find(name)?;
        let store = self.saves.open(&summary.slug)?;
        let saved_distance = store.state()?.map(|state| state.view_distance);
        let distance = self
            .view_distance
            .or(saved_distance)
            .unwrap_or(VIEW_DISTANCE_CHUNKS.2);
        let setup = WorldSetup::from_meta(&store.meta(), distance)?;
        Ok(Session {
            scene: Scene::open(setup, Some(Arc::new(store)))?,
            slug: summary.slug,
        })
    }

    /// A name nobody has taken yet.
    pub fn free_name(&self) -> String {
        (1..100_000)
            .map(|n| format!("World {n}"))
            .find(|name| self.saves.check_name(name).is_ok())
            .unwrap_or_else(|| "World".to_owned())
    }

    fn setup(&self, wanted: &NewWorld) -> Result<WorldSetup, Failure> {
        let radius_m = match (wanted.geometry, wanted.radius_m) {
            (Geometry::Spherical, Some(radius)) if SPHERE_RADIUS_M.contains(&radius) => radius,
            (Geometry::Spherical, Some(radius)) => {
                return Err(Failure::Usage(format!(
                    "A radius of {radius} m will not do: a spherical world has 16 to 64 m"
                )));
            }
            (Geometry::Spherical, None) => DEFAULT_SPHERE_RADIUS_M,
            (_, Some(_)) => {
                return Err(Failure::Usage(
                    "Only a spherical world has a radius to choose".to_owned(),
                ));
            }
            (Geometry::Hyperbolic, None) => DEFAULT_HYPERBOLIC_RADIUS_M,
            (Geometry::Euclidean, None) => f64::INFINITY,
        };
        Ok(WorldSetup {
            name: wanted.name.clone().unwrap_or_else(|| "Unnamed".to_owned()),
            seed: wanted.seed.unwrap_or_else(random_seed),
            geometry: wanted.geometry,
            radius_m,
            view_distance: self.view_distance.unwrap_or(VIEW_DISTANCE_CHUNKS.2),
        })
    }
}

/// A seed nobody chose, from the standard library's own source of randomness; small enough to type again.
pub fn random_seed() -> u64 {
    RandomState::new().build_hasher().finish() % 1_000_000_000
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        reason = "tests fail by panicking"
    )]

    use super::*;
    use crate::cli::Cli;
    use clap::Parser;

    fn worlds(dir: &std::path::Path) -> Worlds {
        let cli = Cli::try_parse_from([
            "antipode",
            "--saves-dir",
            dir.to_str().unwrap(),
            "--view-distance",
            "1",
        ]);
        Worlds::new(&cli.unwrap().common)
    }

    fn wanted(geometry: Geometry, name: Option<&str>, radius_m: Option<f64>) -> NewWorld {
        NewWorld {
            geometry,
            name: name.map(str::to_owned),
            seed: Some(3),
            radius_m,
        }
    }

    #[test]
    fn a_radius_out_of_range_or_out_of_place_is_refused_in_words() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        for (geometry, radius) in [
            (Geometry::Spherical, 15.9),
            (Geometry::Spherical, f64::NAN),
            (Geometry::Euclidean, 32.0),
        ] {
            let refused = worlds.create(&wanted(geometry, Some("x"), Some(radius)));
            assert!(
                matches!(refused, Err(Failure::Usage(_))),
                "{geometry:?} {radius}"
            );
        }
        assert!(worlds.list().unwrap().is_empty());
    }

    #[test]
    fn a_world_without_a_name_leaves_nothing_on_disk() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        let session = worlds
            .create(&wanted(Geometry::Euclidean, None, None))
            .unwrap();
        session.scene.close().unwrap();
        assert!(worlds.list().unwrap().is_empty());
    }

    #[test]
    fn free_names_avoid_what_is_there() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        assert_eq!(worlds.free_name(), "World 1");
        let made = worlds
            .create(&wanted(Geometry::Hyperbolic, Some("world 1"), None))
            .unwrap();
        made.scene.close().unwrap();
        assert_eq!(worlds.free_name(), "World 2");
    }
}
