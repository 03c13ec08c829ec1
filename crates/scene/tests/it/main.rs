//! What must hold of a world and its rules, step by step.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::unwrap_used,
    reason = "tests fail by panicking"
)]

mod biomes;
mod bodies;
mod car;
mod car_bushes;
mod car_equator;
mod car_fallen;
mod car_view;
mod common;
mod cone;
mod contact;
mod corner_stones;
mod crumbs;
mod doors;
mod doors_driven;
mod doors_dug;
mod doors_followed;
mod doors_met;
mod doors_placed;
mod doors_seen;
mod drops;
mod earthworks;
mod felling;
mod flags;
mod gathering;
mod gun;
mod hidden;
mod hit_shapes;
mod hours;
mod hyperbolic_world;
mod logs;
mod npc;
mod npc_peace;
mod npc_things;
mod planting;
mod purity;
mod restoring;
mod round;
mod saving;
mod sounds;
mod straight;
mod survey;
mod tiled;
mod view;
mod way_home;
mod ways;
