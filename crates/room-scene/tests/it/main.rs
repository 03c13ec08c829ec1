//! Tests of rooms that run.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod bodies;
mod bodies_soak;
mod difference;
mod edits;
mod eyes;
mod figure;
mod handled;
mod hands;
mod large;
mod parallel;
mod picture;
mod portals;
mod raster;
mod soak;
mod sounds;
mod walking;
mod workshop;

use antipode_room_scene::{RoomScene, Steer};
use antipode_rooms::{Assets, Loaded, Room, shipped};

/// A room of the game.
fn room(id: &str) -> RoomScene {
    let loaded = shipped::find(id).unwrap().loaded().unwrap();
    RoomScene::open(loaded)
}

/// A room as it is when one makes one.
fn empty() -> RoomScene {
    let loaded = Loaded {
        room: Room::new("Mine"),
        assets: Assets::default(),
        files: Vec::new(),
        bytes: 0,
    };
    RoomScene::open(loaded)
}

/// Forward, and nothing else.
const AHEAD: Steer = Steer {
    forward: 1.0,
    strafe: 0.0,
    sprint: false,
    jump: false,
    look_yaw_rad: 0.0,
    look_pitch_rad: 0.0,
    shoot: false,
    place: false,
    throw: false,
    grasp: false,
};
