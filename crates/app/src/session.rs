//! Makes, loads, lists and deletes worlds on disk, and holds the one that is open. The window and scripts both use it.

use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::io::Cursor;
use std::path::PathBuf;
use std::sync::Arc;

use antipode_geometry::{Geometry, HyperbolicMap, strategy};
use antipode_rooms::{RoomsDir, rooms_dir};
use antipode_scene::frame::Quality;
use antipode_scene::tuning::VIEW_DISTANCE_CHUNKS;
use antipode_scene::{Between, Generator, Mode, NpcMode, Scene, WorldSetup};
use antipode_storage::{SavesDir, StorageError, WorldStore, WorldSummary, saves_dir};
use antipode_streaming::StreamingError;
use image::{ImageFormat, RgbaImage};

use crate::common::Common;
use crate::failure::Failure;

/// What a new world is asked to be.
#[derive(Clone, Debug, PartialEq)]
pub struct NewWorld {
    /// Its space.
    pub geometry: Geometry,
    /// Its name; without one a script's world is not kept.
    pub name: Option<String>,
    /// Its seed; random when left out.
    pub seed: Option<u64>,
    /// Radius of a spherical or hyperbolic world in metres.
    pub radius_m: Option<f64>,
    /// What makes its land; the newest when left out.
    pub generator: Option<Generator>,
    /// What building costs.
    pub mode: Mode,
    /// Where it begins.
    pub start: Beginning,
}

/// Where a new world begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// At its middle, as scripts rely on.
    Middle,
    /// On high ground, with a car and somebody in the first picture: for players.
    View,
}

/// An open world.
#[derive(Debug)]
pub struct Session {
    /// The world.
    pub scene: Scene,
    /// Its pictures between two steps.
    pub between: Between,
    /// Its directory's name; empty for a world that is not kept.
    pub slug: String,
    /// A picture of it for the menu, written when it is closed.
    pub picture: Option<RgbaImage>,
    store: Option<Arc<WorldStore>>,
}

/// A world that could not be closed because its last changes could not be saved. Nothing of it is lost yet.
#[derive(Debug)]
pub struct Unclosed {
    /// The world, still open.
    pub session: Box<Session>,
    /// Why.
    pub error: StreamingError,
}

impl Session {
    /// Keeps a picture for the menu, to be written when the world is closed. Returns the work that writes it at
    /// once, so that a world that is never closed has one too.
    pub fn keep_picture(&mut self, picture: RgbaImage) -> impl FnOnce() + Send + use<> {
        let store = self.store.clone();
        let copy = picture.clone();
        self.picture = Some(picture);
        move || {
            if let Some(store) = store {
                write_picture(&store, &copy);
            }
        }
    }

    /// Commits everything and lets the world go, so that it can be opened again.
    ///
    /// # Errors
    /// When the last commit failed; the world comes back, open as it was.
    pub fn close(self) -> Result<(), Unclosed> {
        if let (Some(store), Some(picture)) = (&self.store, &self.picture) {
            write_picture(store, picture);
        }
        self.scene.close().map_err(|failure| Unclosed {
            session: Box::new(Self {
                scene: *failure.scene,
                between: self.between,
                slug: self.slug,
                picture: self.picture,
                store: self.store,
            }),
            error: failure.error,
        })
    }
}

/// A world without a picture is a whole world; the log is enough.
fn write_picture(store: &WorldStore, picture: &RgbaImage) {
    let mut png = Cursor::new(Vec::new());
    let written = match picture.write_to(&mut png, ImageFormat::Png) {
        Ok(()) => store
            .write_thumbnail(png.get_ref())
            .err()
            .map(|why| why.to_string()),
        Err(why) => Some(why.to_string()),
    };
    if let Some(why) = written {
        tracing::info!("the menu's picture could not be written: {why}");
    }
}

/// The places where worlds and rooms are kept, and the view distance and quality that new sessions get.
#[derive(Clone, Debug)]
pub struct Worlds {
    saves: SavesDir,
    rooms: RoomsDir,
    view_distance: Option<u32>,
    quality: Quality,
    /// The map that new hyperbolic worlds begin with.
    map: HyperbolicMap,
}

impl Worlds {
    /// The place the command line, the environment or the platform names.
    pub fn new(common: &Common) -> Self {
        let path: PathBuf = saves_dir(common.saves_dir.as_deref());
        Self {
            rooms: RoomsDir::new(rooms_dir(common.saves_dir.as_deref())),
            saves: SavesDir::new(path),
            view_distance: common.view_distance,
            quality: common.quality.unwrap_or_default(),
            map: HyperbolicMap::default(),
        }
    }

    /// Sets the quality that worlds are opened with from now on.
    pub fn set_quality(&mut self, quality: Quality) {
        self.quality = quality;
    }

    /// The quality that worlds are opened with.
    pub fn quality(&self) -> Quality {
        self.quality
    }

    /// Sets how far land is loaded in worlds that are opened from now on, in chunks.
    pub fn set_view_distance(&mut self, chunks: u32) {
        self.view_distance = Some(chunks);
    }

    /// Sets the map that new hyperbolic worlds begin with from now on.
    pub fn set_map(&mut self, map: HyperbolicMap) {
        self.map = map;
    }

    /// The directory of worlds.
    pub fn saves(&self) -> &SavesDir {
        &self.saves
    }

    /// The directory of rooms, which goes with that of worlds.
    pub fn rooms(&self) -> RoomsDir {
        self.rooms.clone()
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
        let mut session = if wanted.name.is_some() {
            let (slug, store) = self.saves.create(&setup.to_meta())?;
            self.open(setup, Some(Arc::new(store)), slug)?
        } else {
            self.open(setup, None, String::new())?
        };
        // Other spaces have no map to choose.
        let _ = session.scene.set_map(self.map);
        if wanted.start == Beginning::View {
            session.scene.begin_with_a_view();
        }
        session.scene.give_first_car();
        Ok(session)
    }

    /// Opens a saved world by name or slug.
    ///
    /// # Errors
    /// When there is none, it is open elsewhere, or it is damaged.
    pub fn load(&self, name: &str) -> Result<Session, Failure> {
        let summary = self.saves.find(name)?;
        let store = self.saves.open(&summary.slug)?;
        // A damaged player must not lock the whole world; the scene goes on without and says so.
        let saved_distance = match store.state() {
            Err(StorageError::Damaged { .. }) => None,
            state => state?.map(|state| state.view_distance),
        };
        let distance = self
            .view_distance
            .or(saved_distance)
            .unwrap_or(VIEW_DISTANCE_CHUNKS.2);
        let setup = WorldSetup::from_meta(&store.meta(), distance)?;
        let mut session = self.open(setup, Some(Arc::new(store)), summary.slug)?;
        session.scene.give_first_car();
        Ok(session)
    }

    /// A name nobody has taken yet.
    pub fn free_name(&self) -> String {
        (1..100_000)
            .map(|n| format!("World {n}"))
            .find(|name| self.saves.check_name(name).is_ok())
            .unwrap_or_else(|| "World".to_owned())
    }

    fn open(
        &self,
        setup: WorldSetup,
        store: Option<Arc<WorldStore>>,
        slug: String,
    ) -> Result<Session, Failure> {
        let mut scene = Scene::open(setup, store.clone())?;
        scene.set_quality(self.quality);
        scene.set_npcs(NpcMode::On);
        Ok(Session {
            between: Between::default(),
            scene,
            slug,
            picture: None,
            store,
        })
    }

    fn setup(&self, wanted: &NewWorld) -> Result<WorldSetup, Failure> {
        let radius_m = radius_m(wanted.geometry, wanted.radius_m)?;
        Ok(WorldSetup {
            // As the saves keep it, without blanks around it.
            name: wanted
                .name
                .as_deref()
                .map_or("Unnamed", str::trim)
                .to_owned(),
            seed: wanted.seed.unwrap_or_else(random_seed),
            geometry: wanted.geometry,
            radius_m,
            generator: wanted.generator.unwrap_or_default(),
            mode: wanted.mode,
            view_distance: self.view_distance.unwrap_or(VIEW_DISTANCE_CHUNKS.2),
        })
    }
}

/// The radius in metres of a new world for which one was asked for, or none.
///
/// # Errors
/// When there is nothing to choose, or no world can have it.
pub fn radius_m(geometry: Geometry, wanted_m: Option<f64>) -> Result<f64, Failure> {
    let radii = geometry.radii();
    // Squares are whole chunks wide: what is saved is the radius that the world has.
    let had_m = |radius_m: f64| match geometry {
        Geometry::HyperbolicWorld => strategy(geometry, radius_m).radius_m(),
        _ => radius_m,
    };
    let Some(wanted_m) = wanted_m else {
        return Ok(had_m(radii.default_m));
    };
    let refused = match &radii.chosen_m {
        Some(range) if range.contains(&wanted_m) => return Ok(had_m(wanted_m)),
        Some(range) => format!(
            "A radius of {wanted_m} m will not do: a {geometry} world has {} to {} m",
            range.start(),
            range.end()
        ),
        None => "Only a spherical world and a hyperbolic-world have a radius to choose".to_owned(),
    };
    Err(Failure::Usage(refused))
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
            generator: None,
            mode: Mode::default(),
            start: Beginning::Middle,
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
        session.close().unwrap();
        assert!(worlds.list().unwrap().is_empty());
    }

    #[test]
    fn a_world_is_called_as_the_saves_call_it() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        let made = worlds
            .create(&wanted(Geometry::Euclidean, Some("  Foo "), None))
            .unwrap();
        assert_eq!(made.scene.setup().name, "Foo");
        made.close().unwrap();
        assert_eq!(worlds.list().unwrap()[0].name(), "Foo");
    }

    #[test]
    fn a_world_that_cannot_be_saved_stays_open_and_its_picture_is_kept_with_it() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        let mut session = worlds
            .create(&wanted(Geometry::Euclidean, Some("x"), None))
            .unwrap();
        session.picture = Some(RgbaImage::new(4, 4));
        let (here, aside) = (dir.path().join("x"), dir.path().join("aside"));
        std::fs::rename(&here, &aside).unwrap();
        let unclosed = session.close().unwrap_err();
        assert!(!unclosed.error.to_string().is_empty());
        std::fs::rename(&aside, &here).unwrap();
        unclosed.session.close().unwrap();
        assert!(worlds.list().unwrap()[0].thumbnail.is_some());
        worlds.load("x").unwrap().close().unwrap();
    }

    #[test]
    fn a_world_remembers_where_it_began_and_a_script_begins_at_the_middle() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        for (name, start) in [("view", Beginning::View), ("middle", Beginning::Middle)] {
            let wanted = NewWorld {
                start,
                ..wanted(Geometry::Spherical, Some(name), Some(100.0))
            };
            let made = worlds.create(&wanted).unwrap();
            assert_eq!(made.scene.cars().len(), 1, "{name}");
            let viewed = start == Beginning::View;
            assert_eq!(made.scene.bots().len(), usize::from(viewed), "{name}");
            let feet = made.scene.feet().pos;
            assert_eq!(feet.x.hypot(feet.z) > 1.0, viewed, "{name}");
            made.close().unwrap();
            for _ in 0..2 {
                let again = worlds.load(name).unwrap();
                assert_eq!(again.scene.cars().len(), 1, "{name}");
                let state = again.store.as_ref().unwrap().state().unwrap().unwrap();
                let kept = state.start.map(|place| place.pos);
                assert_eq!(kept, viewed.then(|| feet.to_array()), "{name}");
                again.close().unwrap();
            }
        }
    }

    #[test]
    fn free_names_avoid_what_is_there() {
        let dir = tempfile::tempdir().unwrap();
        let worlds = worlds(dir.path());
        assert_eq!(worlds.free_name(), "World 1");
        let made = worlds
            .create(&wanted(Geometry::Hyperbolic, Some("world 1"), None))
            .unwrap();
        made.close().unwrap();
        assert_eq!(worlds.free_name(), "World 2");
    }
}
