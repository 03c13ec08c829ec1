//! Worlds on disk.
#![cfg(unix)]

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene};
use antipode_storage::{Batch, WorldState, WorldStore};
use tempfile::TempDir;

use super::{LIMIT, setup};

/// A kept world that can be moved away so that its commits fail, and back.
pub struct Kept {
    pub dir: TempDir,
}

impl Kept {
    pub fn new() -> (Self, Scene) {
        let kept = Self {
            dir: tempfile::tempdir().unwrap(),
        };
        let setup = setup(Geometry::Euclidean);
        let store = WorldStore::create(&kept.here(), &setup.to_meta()).unwrap();
        let mut scene = Scene::open(setup, Some(Arc::new(store))).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        (kept, scene)
    }

    pub fn here(&self) -> PathBuf {
        self.dir.path().join("world")
    }

    pub fn take_away(&self) {
        fs::rename(self.here(), self.dir.path().join("away")).unwrap();
    }

    pub fn bring_back(&self) {
        fs::rename(self.dir.path().join("away"), self.here()).unwrap();
    }

    pub fn open(&self) -> Scene {
        let store = WorldStore::open(&self.here()).unwrap();
        let mut scene = Scene::open(setup(Geometry::Euclidean), Some(Arc::new(store))).unwrap();
        assert!(scene.wait_for_step(LIMIT));
        scene
    }

    /// Changes the state of a closed world.
    pub fn alter(&self, alter: impl FnOnce(&mut WorldState)) -> WorldState {
        let store = WorldStore::open(&self.here()).unwrap();
        let mut state = store.state().unwrap().unwrap();
        alter(&mut state);
        let batch = Batch {
            records: (&state).into(),
            ..Batch::default()
        };
        store.commit(&batch).unwrap();
        state
    }
}

/// What a player does who builds.
pub fn build() -> Actions {
    Actions {
        secondary: true,
        ..Actions::default()
    }
}
