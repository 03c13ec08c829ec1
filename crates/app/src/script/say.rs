//! Prints a script's answers: one JSON object a line on standard output.

use antipode_room_scene::RoomProbe;
use antipode_rooms::RoomSummary;
use antipode_scene::Probe;
use antipode_storage::WorldSummary;
use antipode_workshop::Version;
use serde::Serialize;

use crate::dates::stamp;
use crate::drawn::Drawn;
use crate::failure::Failure;
use crate::output;

/// A probe with what only the program around the scene knows.
#[derive(Serialize)]
struct FullProbe<'a> {
    #[serde(flatten)]
    scene: &'a Probe,
    memory_mb: Option<f64>,
    fps: Option<f64>,
    adapter: &'a str,
    picture: Option<&'a Drawn>,
    /// Time of the world that was left out because the machine was too slow; a script leaves none out.
    dropped_s: f64,
}

/// The same of a room.
#[derive(Serialize)]
struct FullRoomProbe<'a> {
    #[serde(flatten)]
    scene: &'a RoomProbe,
    memory_mb: Option<f64>,
    adapter: &'a str,
}

/// One room in a list.
#[derive(Serialize)]
struct ListedRoom<'a> {
    name: &'a str,
    slug: &'a str,
    shipped: bool,
    objects: usize,
    problem: Option<&'a str>,
}

/// One saved world in a list.
#[derive(Serialize)]
struct Listed<'a> {
    name: &'a str,
    slug: &'a str,
    geometry: Option<&'a str>,
    seed: Option<u64>,
    size_bytes: u64,
    problem: Option<&'a str>,
}

/// Prints a probe.
pub fn probe(
    scene: &Probe,
    fps: Option<f64>,
    adapter: &str,
    picture: Option<&Drawn>,
) -> Result<(), Failure> {
    output::line(&probe_text(scene, fps, adapter, picture, 0.0)?)
}

/// A probe as one line of JSON. `dropped_s`: time of the world that was left out so far, in seconds.
pub fn probe_text(
    scene: &Probe,
    fps: Option<f64>,
    adapter: &str,
    picture: Option<&Drawn>,
    dropped_s: f64,
) -> Result<String, Failure> {
    json(&FullProbe {
        scene,
        memory_mb: antipode_timing::resident_mb(),
        fps,
        adapter,
        picture,
        dropped_s,
    })
}

/// The probe of a room as a line of JSON.
pub fn room_probe_text(scene: &RoomProbe, adapter: &str) -> Result<String, Failure> {
    json(&FullRoomProbe {
        scene,
        memory_mb: antipode_timing::resident_mb(),
        adapter,
    })
}

/// Prints the rooms as one JSON array.
pub fn rooms(rooms: &[RoomSummary]) -> Result<(), Failure> {
    let listed: Vec<_> = rooms
        .iter()
        .map(|room| ListedRoom {
            name: &room.name,
            slug: &room.slug,
            shipped: room.shipped,
            objects: room.objects,
            problem: room.problem.as_deref(),
        })
        .collect();
    line(&listed)
}

/// An older version of a room.
#[derive(Serialize)]
struct ListedVersion {
    number: usize,
    when: String,
}

/// Prints older versions of a room as one JSON array, the newest first.
pub fn versions(versions: &[Version]) -> Result<(), Failure> {
    let listed: Vec<_> = (1..)
        .zip(versions)
        .map(|(number, it)| ListedVersion {
            number,
            when: stamp(it.when_s),
        })
        .collect();
    line(&listed)
}

/// Prints the saved worlds as one JSON array.
pub fn list(worlds: &[WorldSummary]) -> Result<(), Failure> {
    let listed: Vec<_> = worlds
        .iter()
        .map(|w| Listed {
            name: w.name(),
            slug: &w.slug,
            geometry: w.meta.as_ref().map(|meta| meta.geometry.as_str()),
            seed: w.meta.as_ref().map(|meta| meta.seed),
            size_bytes: w.size_bytes,
            problem: w.problem.as_deref(),
        })
        .collect();
    line(&listed)
}

/// Prints any value as one line of JSON.
pub fn line(value: &impl Serialize) -> Result<(), Failure> {
    output::line(&json(value)?)
}

fn json(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(value)
        .map_err(|e| Failure::Runtime(format!("A line could not be written: {e}")))
}
