//! How long the workshop keeps the main thread in a room of as many objects as there may be:
//! `cargo test --release -p antipode --lib workshop_speed -- --ignored --nocapture`.

#![allow(clippy::print_stdout, reason = "it prints times")]

use antipode_ui::workshop::{FieldValue, WorkshopWish};

use super::workshop::{building, put, scene};
use super::*;

/// What is done while one looks at 2,000 objects, 1,000 steps of history and all panes.
fn wishes() -> Vec<(&'static str, WorkshopWish)> {
    let choose = |name: &str, adds| WorkshopWish::Choose {
        name: name.to_owned(),
        adds,
    };
    let set = |key: &str, value| WorkshopWish::Set {
        key: key.to_owned(),
        value,
        done: true,
    };
    vec![
        ("choose a box", choose("box 7", false)),
        ("move it", WorkshopWish::Nudge([1, 0, 0])),
        ("size", set("size", FieldValue::Number(0, 2.0))),
        ("choose a tunnel", choose("tunnel 3", false)),
        ("move it", WorkshopWish::Nudge([1, 0, 0])),
        ("stretch", set("stretch", FieldValue::Number(0, 3.0))),
        ("new box", put("box")),
        ("choose all", WorkshopWish::ChooseAll(true)),
        ("move all", WorkshopWish::Nudge([1, 0, 0])),
        ("undo", WorkshopWish::Undo),
    ]
}

fn edit(game: &mut Game, words: &str) {
    let words: Vec<_> = words.split_whitespace().collect();
    let visit = game.play.phase.visit_mut().unwrap();
    let read = |_: &antipode_rooms::Room| panic!("no file is to be read");
    visit.room.scene.edit(&words, read).unwrap();
}

#[test]
#[ignore = "prints times"]
fn print_how_long_an_edit_of_two_thousand_objects_keeps_the_main_thread() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    edit(&mut game, "add box name=box at=0,1,-40 size=1,1,1");
    for row in 0..9 {
        edit(&mut game, &format!("array box count=200 step=2,0.{row},0"));
    }
    edit(
        &mut game,
        "add aberration name=tunnel at=0,9,40 half=1,1,2 axis=z felt=20 sides=soft",
    );
    edit(&mut game, "array tunnel count=150 step=4,0,0");
    edit(&mut game, "add portal name=door at=0,9,80 size=1,2 to=door");
    for step in 0..980 {
        edit(&mut game, &format!("change box at=0,1,-{}", 40 + step % 7));
    }
    println!(
        "{} objects, {} steps",
        scene(&game).room().objects.len(),
        scene(&game).document().history().steps().len()
    );
    let context = egui::Context::default();
    antipode_ui::apply_theme(&context);
    let pass = |game: &mut Game| {
        let size = egui::vec2(1920.0, 1080.0);
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
            ..Default::default()
        };
        let drawn = Drawn::new(&DrawStats::default(), Quality::Fast);
        let output = context.run_pass(input, |context| {
            game.interface(context, Some((drawn, None)));
        });
        context.tessellate(output.shapes, 1.0).len()
    };
    for _ in 0..4 {
        pass(&mut game);
    }
    for (what, wish) in wishes() {
        let begin = Instant::now();
        game.follow_workshop(vec![wish]);
        let done = begin.elapsed();
        game.tick(Instant::now());
        let ticked = begin.elapsed() - done;
        let view = game.room_view(1.6);
        let seen = begin.elapsed() - ticked - done;
        let copy = scene(&game).clone();
        let copied = begin.elapsed() - ticked - done - seen;
        drop((view, copy));
        let begin = Instant::now();
        pass(&mut game);
        let shown = begin.elapsed();
        let begin = Instant::now();
        pass(&mut game);
        let again = begin.elapsed();
        println!(
            "{what}: {:?} = done {done:?}, ticked {ticked:?}, view {seen:?}, copied {copied:?}, panes {shown:?}; panes again {again:?}",
            done + ticked + seen + copied + shown
        );
    }
}
