//! Kinds of ground: what was built is there after closing, and those of a later game are kept and told once.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, ChunkCoord};
use antipode_terrain::{Kind, Stroke};
use glam::{DVec3, Vec3};

use super::saving::open;
use super::{Game, Memory, stroke};
use crate::api::Until;
use crate::edit_backend::key_of;

fn kind(game: &Game, at: DVec3) -> Kind {
    let coord = ChunkCoord::containing(ChartPoint::a(at));
    game.samples(coord)
        .kind(&game.field, coord, at - coord.origin(), Vec3::Y)
}

#[test]
fn what_was_built_of_is_there_after_closing_and_a_kind_of_a_later_game_stays() {
    let memory = Arc::new(Memory::default());
    let mut game = open(&memory);
    let at = (game.ground(0.0, 0.0) + DVec3::Y * 2.0).round();
    let snow = Stroke {
        kind: Some(Kind::Snow),
        ..stroke(at, -12.0)
    };
    game.streamer.edit(snow);
    game.wait(Until::Edits);
    assert_eq!(kind(&game, at), Kind::Snow);
    game.streamer.close().unwrap();

    let again = open(&memory);
    assert_eq!(kind(&again, at), Kind::Snow);
    assert_eq!(again.problems, Vec::<String>::new());
    drop(again);

    for kinds in memory.kinds.lock().unwrap().values_mut() {
        for byte in kinds.iter_mut().filter(|byte| **byte != 0) {
            *byte = 99;
        }
    }
    let mut later = open(&memory);
    assert_eq!(kind(&later, at), Kind::PLAIN);
    assert_eq!(later.problems.len(), 1, "{:?}", later.problems);
    assert!(later.problems[0].contains("later version"));
    // Something is dug beside it, and all is saved anew.
    later.edit(at + DVec3::X * 7.0, 4.0);
    later.wait(Until::Edits);
    later.streamer.close().unwrap();
    let key = key_of(ChunkCoord::containing(ChartPoint::a(at)));
    assert!(memory.kinds.lock().unwrap()[&key].contains(&99));
}
