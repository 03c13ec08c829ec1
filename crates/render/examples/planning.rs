//! What planning a frame costs the main thread, in worlds of the greatest view distance.
//!
//! `cargo run --release -p antipode-render --example planning`

use std::time::{Duration, Instant};

use antipode_frame::{ChunkChange, Frame, Quality};
use antipode_geometry::{Eye, Geometry, HyperbolicMap, picture};
use antipode_render::{ChunkLand, LandBook, Planner};
use antipode_scene::tuning::FOV_Y_RAD;
use antipode_scene::{Scene, WorldSetup};
use glam::DVec3;

const HEIGHT_PX: u32 = 720;
const VIEW_DISTANCE: u32 = 16;
/// Frames of a walk, which turns once about itself.
const FRAMES: u32 = 200;
const ROUNDS: usize = 5;
const STEP_M: f64 = 0.1;

/// A world and all that is resident there.
fn world(
    geometry: Geometry,
    radius_m: f64,
) -> Result<(Frame, Vec<ChunkLand>), Box<dyn std::error::Error>> {
    let setup = WorldSetup {
        name: String::new(),
        seed: 7,
        geometry,
        radius_m,
        view_distance: VIEW_DISTANCE,
    };
    let mut scene = Scene::open(setup, None)?;
    scene.set_picture_height_px(HEIGHT_PX);
    if !scene.settle(Duration::from_mins(3)) {
        return Err("its land was not made in time".into());
    }
    let frame = scene.frame(FOV_Y_RAD, 16.0 / 9.0, 1);
    let mut land: Vec<_> = frame
        .chunk_changes
        .iter()
        .filter_map(|change| match change {
            ChunkChange::Put(coord, mesh) if !mesh.is_empty() => Some(ChunkLand::of(*coord, mesh)),
            _ => None,
        })
        .collect();
    land.sort_by_key(|land| land.coord);
    Ok((frame, land))
}

fn eye_at(start: &Eye, step: u32) -> Eye {
    let walked = DVec3::new(0.8, 0.1, 0.6) * STEP_M * f64::from(step);
    Eye {
        point: start.point.moved(walked),
        yaw: start.yaw + std::f64::consts::TAU * f64::from(step) / f64::from(FRAMES),
        ..*start
    }
}

fn measure(name: &str, frame: &mut Frame, land: &[ChunkLand]) {
    let start = frame.eye;
    let mut least = vec![f64::INFINITY; FRAMES as usize];
    let mut drawn = 0;
    let mut planner = Planner::default();
    let arranging = Instant::now();
    let book = LandBook::new(land.to_vec());
    let arranged_us = arranging.elapsed().as_secs_f64() * 1e6;
    for _ in 0..ROUNDS {
        drawn = 0;
        for step in 0..FRAMES {
            frame.eye = eye_at(&start, step);
            let began = Instant::now();
            let planned = planner.plan(frame, HEIGHT_PX, &book);
            let took_us = began.elapsed().as_secs_f64() * 1e6;
            drawn += planned.chunks.len();
            let least = &mut least[step as usize];
            *least = least.min(took_us);
        }
    }
    frame.eye = start;
    least.sort_by(f64::total_cmp);
    let (median, p99) = (
        least[FRAMES as usize / 2],
        least[FRAMES as usize * 99 / 100],
    );
    let ns = 1e3 * median / land.len() as f64;
    let drawn = drawn / FRAMES as usize;
    println!(
        "{name:32} {:5} chunks, {drawn:4} drawn: p50 {median:6.0} us, p99 {p99:6.0} us, {ns:5.0} ns a chunk; arranged in {arranged_us:4.0} us",
        land.len()
    );
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (geometry, radius_m) in [
        (Geometry::Euclidean, 0.0),
        (Geometry::Hyperbolic, 20.0),
        (Geometry::Spherical, 256.0),
    ] {
        let (mut frame, land) = world(geometry, radius_m)?;
        for quality in Quality::ALL {
            frame.quality = quality;
            measure(&format!("{geometry}, {quality}"), &mut frame, &land);
        }
        frame.quality = Quality::Balanced;
        let other = match geometry {
            Geometry::Hyperbolic => picture(geometry, radius_m, HyperbolicMap::Horizon, false),
            Geometry::Euclidean => picture(geometry, radius_m, HyperbolicMap::Raised, true),
            Geometry::Spherical => continue,
        };
        frame.strategy = other;
        frame.eye.dial = 1.0;
        measure(&format!("{geometry}, horizon map"), &mut frame, &land);
    }
    Ok(())
}
