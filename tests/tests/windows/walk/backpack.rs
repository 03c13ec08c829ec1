//! The backpack, by the mouse; what came of it is asked of the save.

use std::path::Path;

use antipode_tests::program::{field, run};
use antipode_tests::window::Window;
use image::RgbImage;

use super::{IN_A_WORLD, leave_world, mean, open, ready, saves, shows_world};

/// Middle of a slot of the backpack in a window of 800 by 600, in pixels: three lines above the hotbar's.
fn slot(index: u32) -> (u32, u32) {
    let (column, line) = (index % 10, (index / 10 + 3) % 4);
    let apart = if line == 3 { 8 } else { 0 };
    (130 + 60 * column, 176 + 60 * line + apart)
}

/// Whether the panel of the backpack is up.
fn shows_backpack(picture: &RgbImage) -> bool {
    mean(picture, (140, 190), (720, 40))
        .iter()
        .all(|c| *c < 70.0)
}

/// How many lamps lie in each slot that has some, and how many about, in the save.
fn lamps(saves: &Path) -> (Vec<(u64, u64)>, u64) {
    let saved = run(saves, "load Walk\nprobe");
    let probe = saved.probe(0);
    let of = |list: &str| {
        let all = field(probe, list).as_array().unwrap().clone();
        all.into_iter().filter(|one| one["item"] == "lamp")
    };
    let count = |one: &serde_json::Value| one["count"].as_u64().unwrap();
    let slots = of("inventory").map(|one| (one["slot"].as_u64().unwrap(), count(&one)));
    (slots.collect(), of("drops").map(|one| count(&one)).sum())
}

#[test]
fn things_are_dragged_split_merged_and_thrown_in_the_backpack_and_are_all_there_again() {
    let Some((display, place)) = ready("") else {
        return;
    };
    let saves = saves(&place);
    let mut game = open(&display, &place, &IN_A_WORLD);
    game.shows("the world");
    game.key("e");
    game.shows("the backpack");
    game.wait_until("the backpack", shows_backpack);
    // A slow machine may still be at the last click: two in one frame are one.
    let done = |game: &mut Window, what: &str| game.wait_for(&format!("in the backpack: {what}"));
    let click = |game: &mut Window, index| {
        let (x, y) = slot(index);
        game.click(x, y);
        done(game, &format!("Click({index})"));
    };
    let halve = |game: &mut Window, index| {
        let (x, y) = slot(index);
        game.click_right(x, y);
        done(game, &format!("ClickOther({index})"));
    };
    // Ten lamps into the backpack; half of them two slots on; most of that half back again.
    game.drag(slot(5), slot(10));
    done(&mut game, "EndDrag(10)");
    halve(&mut game, 10);
    click(&mut game, 12);
    halve(&mut game, 12);
    click(&mut game, 10);
    // The last two are thrown away.
    game.drag(slot(12), (40, 300));
    done(&mut game, "LetGo");
    game.key("e");
    game.shows("the world");
    game.wait_until("the world again", shows_world);
    leave_world(&mut game);
    drop(game);
    assert_eq!(lamps(&saves), (vec![(10, 8)], 2));

    let mut game = open(&display, &place, &["--load", "Walk"]);
    game.shows("the world");
    game.hold_key_for("w", "picked up 2 lamp");
    game.key("e");
    game.shows("the backpack");
    game.drag(slot(10), slot(6));
    done(&mut game, "EndDrag(6)");
    game.key("Escape");
    game.shows("the world");
    leave_world(&mut game);
    drop(game);
    assert_eq!(lamps(&saves), (vec![(6, 10)], 0), "picked up and kept");
}
