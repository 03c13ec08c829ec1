//! The fixed scene: one seed, one pose, made by the game itself, in every space.

use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{ChunkCoord, Geometry, HyperbolicMap, Strategy, picture};
use antipode_render::Gpu;
use antipode_scene::frame::{ChunkChange, Frame, Land};
use antipode_scene::tuning::FOV_Y_RAD;
use antipode_scene::{Scene, WorldSetup};
use antipode_terrain::{ChunkMesh, Vertex};
use glam::Vec3;

use crate::LabError;
use crate::speed::stage::Stage;
use crate::terrain::{radius_m, settle};

/// Seed of the scene.
pub const SEED: u64 = 7;
/// View distance in chunks.
pub const VIEW_DISTANCE: u32 = 6;
/// Heading and elevation of the pose, radians; the place is where a new player of that seed stands.
pub const POSE_RAD: (f64, f64) = (0.4, -0.08);
/// Longest wait for the land.
const PATIENCE: Duration = Duration::from_mins(3);

/// The scene in that space as a frame of the given aspect, with all its meshes.
///
/// # Errors
/// When the world cannot be opened or its land is not made in time.
pub fn fixed(geometry: Geometry, aspect: f64) -> Result<Frame, LabError> {
    made(geometry, aspect, VIEW_DISTANCE)
}

/// The same with land to that distance, in chunks.
///
/// # Errors
/// As [`fixed`].
pub fn made(geometry: Geometry, aspect: f64, view_distance: u32) -> Result<Frame, LabError> {
    let setup = WorldSetup {
        name: "fixed scene".to_owned(),
        seed: SEED,
        geometry,
        radius_m: radius_m(geometry),
        generator: antipode_scene::Generator::OneBiome,
        mode: antipode_scene::Mode::default(),
        view_distance,
    };
    let mut scene = Scene::open(setup, None).map_err(|e| LabError::Scene(e.to_string()))?;
    scene.aim(POSE_RAD.0, POSE_RAD.1);
    settle(&mut scene, PATIENCE)?;
    Ok(scene.frame(FOV_Y_RAD, aspect, geometry as u64 + 1))
}

/// One way to look at the land.
#[derive(Clone, Debug)]
pub struct Look {
    /// Its name in tables.
    pub name: &'static str,
    /// The space it is seen in.
    pub space: Arc<dyn Strategy>,
    /// The dial.
    pub dial: f64,
}

impl Look {
    fn new(name: &'static str, space: (Geometry, HyperbolicMap, bool), dial: f64) -> Self {
        let (geometry, map, bend) = space;
        let space = picture(geometry, radius_m(geometry), map, bend);
        Self { name, space, dial }
    }

    /// Flat land as it is.
    pub fn flat(name: &'static str) -> Self {
        Self::new(
            name,
            (Geometry::Euclidean, HyperbolicMap::Raised, false),
            0.0,
        )
    }

    /// Flat land bent.
    pub fn bent(name: &'static str, dial: f64) -> Self {
        Self::new(
            name,
            (Geometry::Euclidean, HyperbolicMap::Raised, true),
            dial,
        )
    }

    /// Through a map of hyperbolic space.
    pub fn hyperbolic(name: &'static str, map: HyperbolicMap, dial: f64) -> Self {
        Self::new(name, (Geometry::Hyperbolic, map, false), dial)
    }

    /// On the sphere.
    pub fn spherical(name: &'static str) -> Self {
        Self::new(
            name,
            (Geometry::Spherical, HyperbolicMap::Raised, false),
            0.0,
        )
    }

    /// The frame looked at in this way.
    pub fn at(&self, frame: &Frame) -> Frame {
        let mut own = frame.clone();
        own.view.strategy = Arc::clone(&self.space);
        own.view.eye.dial = self.dial;
        own
    }
}

/// Every way to look at flat and hyperbolic land; the first is flat.
pub fn looks() -> Vec<Look> {
    let (raised, horizon) = (HyperbolicMap::Raised, HyperbolicMap::Horizon);
    vec![
        Look::flat("flat"),
        Look::hyperbolic("raised, offset 0.5 m", raised, 0.5),
        Look::hyperbolic("raised, offset 10 m", raised, 10.0),
        Look::hyperbolic("raised, offset 20 m", raised, 20.0),
        Look::hyperbolic("horizon, dial 10", horizon, 10.0),
        Look::bent("flat, bent by 1", 1.0),
        Look::bent("flat, bent by -1", -1.0),
    ]
}

/// The sphere and the flat space that its charts' land is drawn in for comparison; the first is flat.
pub fn sphere_looks() -> Vec<Look> {
    vec![Look::flat("flat"), Look::spherical("sphere")]
}

/// Which land is taken first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The nearest.
    NearestFirst,
    /// The farthest.
    FarthestFirst,
}

/// Leaves only the meshes that every look draws whole, all of them together: one that a look hides, trims or divides,
/// or that hides one taken before, is left out. Returns how many are left.
///
/// # Errors
/// When the adapter fails.
pub fn keep_common(
    gpu: &Gpu,
    frame: &mut Frame,
    looks: &[Look],
    height: u32,
    order: Order,
) -> Result<usize, LabError> {
    let frames: Vec<Frame> = looks.iter().map(|look| look.at(frame)).collect();
    keep_whole(gpu, frame, &frames, height, order)
}

/// The same for frames of any kind, which differ in how the land of `frame` is looked at.
///
/// # Errors
/// When the adapter fails.
pub fn keep_whole(
    gpu: &Gpu,
    frame: &mut Frame,
    frames: &[Frame],
    height: u32,
    order: Order,
) -> Result<usize, LabError> {
    // Choices are made in pixels of height; nothing is said of width.
    let mut stage = Stage::new(gpu, (16, height))?;
    let with = |frame: &Frame, land: &Arc<Land>| {
        frame.clone().with_content(|it| it.land = Arc::clone(land))
    };
    let all = std::mem::take(&mut frame.content_mut().land);
    let mut empty = Vec::new();
    for own in frames {
        empty.push(stage.draw(&with(own, &frame.content.land))?.stats.triangles);
    }
    let away = |coord: ChunkCoord| coord.centre().distance(frame.view.eye.point.pos);
    let mut meshes: Vec<_> = all.meshes().collect();
    meshes.sort_by(|(a, _), (b, _)| away(*a).total_cmp(&away(*b)));
    if order == Order::FarthestFirst {
        meshes.reverse();
    }
    let mut kept = 0;
    for (coord, mesh) in meshes {
        let elsewhere = coord.chart != frame.view.eye.point.chart;
        if mesh.is_empty() || elsewhere || frames.iter().any(|own| trims(own, coord, mesh)) {
            continue;
        }
        let due = kept + mesh.indices.len() / 3;
        let mut whole = true;
        frame.change_land([ChunkChange::Put(coord, Arc::clone(mesh))]);
        for (own, empty) in frames.iter().zip(&empty) {
            whole = whole
                && stage.draw(&with(own, &frame.content.land))?.stats.triangles == due + empty;
        }
        if whole {
            kept = due;
        } else {
            frame.change_land([ChunkChange::Remove(coord)]);
        }
    }
    Ok(frame.content.land.meshes().count())
}

/// Whether the frame's space trims a chunk at the edge of its chart.
fn trims(frame: &Frame, coord: ChunkCoord, mesh: &ChunkMesh) -> bool {
    let places = || mesh.vertices.iter().map(Vertex::position);
    let corner = |local: Option<Vec3>| coord.origin() + local.unwrap_or_default().as_dvec3();
    let (min, max) = (
        corner(places().reduce(Vec3::min)),
        corner(places().reduce(Vec3::max)),
    );
    frame
        .view
        .strategy
        .trims(&frame.view.eye, coord.chart, min, max)
}
