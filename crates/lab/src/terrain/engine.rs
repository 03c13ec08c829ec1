//! The worlds that the terrain suites measure in, and the few calls of the engine that several of them make.

use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{
    ChartId, ChunkCoord, DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M, Geometry, Strategy,
    strategy,
};
use antipode_scene::{Scene, WorldSetup};
use antipode_storage::WorldStore;
use antipode_terrain::{Field, Generator};
use glam::IVec3;

use crate::LabError;

/// Seed of every world here: volcanic, of four octaves, the costliest land.
pub const SEED: u64 = 20;

/// A space by its name in tables.
pub fn name(geometry: Geometry) -> &'static str {
    match geometry {
        Geometry::Euclidean => "Euclidean",
        Geometry::Hyperbolic => "hyperbolic",
        Geometry::Spherical => "spherical",
        Geometry::HyperbolicWorld => "hyperbolic world",
    }
}

/// The radius of a new world of that space, metres.
pub fn radius_m(geometry: Geometry) -> f64 {
    match geometry {
        Geometry::Spherical => DEFAULT_SPHERE_RADIUS_M,
        _ => DEFAULT_HYPERBOLIC_RADIUS_M,
    }
}

/// The space of a new world.
pub fn space(geometry: Geometry) -> Arc<dyn Strategy> {
    strategy(geometry, radius_m(geometry))
}

/// The ground of a new world.
pub fn field(geometry: Geometry) -> Field {
    Field::made_by(Generator::default(), SEED, space(geometry))
}

/// The ground, and the chunk at the middle of the world: its surface runs through it.
pub fn surface_chunk(geometry: Geometry) -> (Field, ChunkCoord) {
    let coord = ChunkCoord::new(ChartId::FIRST, IVec3::ZERO);
    (field(geometry), coord)
}

/// A world as the game opens it.
///
/// # Errors
/// When it cannot be opened.
pub fn open(
    geometry: Geometry,
    view_distance: u32,
    store: Option<Arc<WorldStore>>,
) -> Result<Scene, LabError> {
    Scene::open(setup(geometry, view_distance), store).map_err(|e| LabError::Scene(e.to_string()))
}

/// Waits until all land of a world is made.
///
/// # Errors
/// When it is not made in time.
pub fn settle(scene: &mut Scene, patience: Duration) -> Result<(), LabError> {
    if scene.settle(patience) {
        return Ok(());
    }
    let why = format!("its land was not made within {} s", patience.as_secs());
    Err(LabError::Scene(why))
}

/// What such a world is.
pub fn setup(geometry: Geometry, view_distance: u32) -> WorldSetup {
    WorldSetup {
        name: "Laboratory".to_owned(),
        seed: SEED,
        geometry,
        radius_m: radius_m(geometry),
        generator: Generator::default(),
        mode: antipode_scene::Mode::default(),
        view_distance,
    }
}
