//! What waits for the disk while a room is built in, without holding the game up: files that edits name, and older versions.

use antipode_rooms::Object;
use antipode_ui::workshop::WorkshopWish;

use super::workshop::{ask, building, made, press, put, scene};
use super::*;
use crate::window::phase::Request;

fn folder(game: &Game) -> PathBuf {
    let file = game.play.phase.visit().unwrap().file().unwrap();
    file.parent().unwrap().to_path_buf()
}

fn add_picture(game: &Game) {
    let textures = folder(game).join("textures");
    fs::create_dir_all(&textures).unwrap();
    let picture = image::RgbImage::new(4, 4);
    picture.save(textures.join("brick.png")).unwrap();
}

fn there_is(game: &Game, name: &str) -> Option<Object> {
    scene(game).room().find(name).map(|(_, it)| it.clone())
}

fn rests(game: &Game) -> bool {
    game.play.phase.visit().unwrap().reading.rests()
}

const PAPER: &str = "change box texture=textures/brick.png,1";

#[test]
fn a_file_that_a_command_names_is_read_while_the_game_goes_on_and_what_follows_waits() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box")]);
    add_picture(&game);
    let before = made(&game);
    game.overlays.console.view.open();
    game.enter(PAPER);
    game.enter("change box at=0,5,0");
    assert_eq!(made(&game), before, "neither is done before it is read");
    tick_until(&mut game, rests);
    let it = there_is(&game, "box").unwrap();
    assert_eq!(it.surface.texture.unwrap().file, "textures/brick.png");
    assert_eq!((it.at.y, made(&game)), (5.0, before + 2));
    game.enter("change box texture=textures/none.png,1");
    tick_until(&mut game, rests);
    assert!(words(&mut game).contains("none.png"));
    assert_eq!(made(&game), before + 2);
}

#[test]
fn an_older_version_is_read_while_the_game_goes_on() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let first = folder(&game).join("workshop/versions/951868799.ron");
    fs::create_dir_all(first.parent().unwrap()).unwrap();
    fs::copy(folder(&game).join("room.ron"), first).unwrap();
    ask(&mut game, [put("box")]);
    game.overlays.console.view.open();
    game.enter("room versions");
    tick_until(&mut game, rests);
    let said = words(&mut game);
    assert!(said.contains("2000-02-29"), "{said}");
    let count = antipode_workshop::versions(&folder(&game)).len();
    game.enter(&format!("room older {count}"));
    assert!(there_is(&game, "box").is_some());
    tick_until(&mut game, rests);
    assert!(there_is(&game, "box").is_none());
    game.enter("room older 99");
    tick_until(&mut game, rests);
    assert!(words(&mut game).contains("no older version 99"));
}

/// What was read before a restart is not known after it.
#[test]
fn a_step_back_to_a_picture_that_nobody_has_read_waits_for_it() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    ask(&mut game, [put("box")]);
    add_picture(&game);
    game.enter(PAPER);
    tick_until(&mut game, rests);
    ask(&mut game, [WorkshopWish::Delete]);
    let name = scene(&game).room().name.clone();
    let kept = folder(&game);
    game.finish();
    drop(game);
    // Its journal is let go of by a thread.
    let began = Instant::now();
    while antipode_workshop::is_in_use(&kept) && began.elapsed() < Duration::from_mins(2) {
        std::thread::yield_now();
    }
    let request = Request::RoomNamed(name);
    let mut game = Game::new(worlds(&dir.path().join("saves")), None, Some(request));
    tick_until(&mut game, |game| game.play.phase.visit().is_some());
    game.play.room_drawn(&mut game.menus, false);
    press(&mut game, "F5");
    ask(&mut game, [WorkshopWish::Undo]);
    assert!(there_is(&game, "box").is_none());
    tick_until(&mut game, rests);
    let it = there_is(&game, "box").unwrap();
    assert_eq!(it.surface.texture.unwrap().file, "textures/brick.png");
}
