//! What the lists of the workshop say after edits, of which they make anew only what has changed.

use antipode_ui::workshop::{FieldValue, WorkshopWish};

use super::workshop::{ask, building, put, scene};
use super::*;
use crate::window::workshop::Told;

fn choose(name: &str, adds: bool) -> WorkshopWish {
    WorkshopWish::Choose {
        name: name.to_owned(),
        adds,
    }
}

fn widen(metres: f64) -> WorkshopWish {
    WorkshopWish::Set {
        key: "size".to_owned(),
        value: FieldValue::Number(0, metres),
        done: true,
    }
}

#[test]
fn lists_that_follow_edits_say_what_lists_made_anew_say() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let wishes = [
        put("box"),
        put("box"),
        WorkshopWish::Nudge([1, 0, 0]),
        widen(2.0),
        WorkshopWish::Undo,
        WorkshopWish::Undo,
        widen(3.0),
        put("house"),
        WorkshopWish::Hide("house".to_owned(), true),
        WorkshopWish::Lock("house".to_owned(), true),
        put("box"),
        WorkshopWish::ChooseAll(true),
        WorkshopWish::Nudge([0, 0, 1]),
        choose("box", false),
        choose("box 2", true),
        widen(1.5),
        WorkshopWish::Nudge([0, 1, 0]),
        WorkshopWish::Undo,
        put("light"),
        choose("floor", true),
    ];
    let mut told = Told::default();
    for wish in wishes {
        let what = format!("{wish:?}");
        told.note(&wish);
        game.follow_workshop(vec![wish]);
        let scene = scene(&game);
        told.renew(&game.menus.texts, scene);
        let mut anew = Told::default();
        anew.renew(&game.menus.texts, scene);
        assert_eq!(told.objects, anew.objects, "{what}");
        assert_eq!(told.fields, anew.fields, "{what}");
        assert_eq!(told.history, anew.history, "{what}");
        assert_eq!(told.chosen, anew.chosen, "{what}");
    }
    let rows = &told.objects;
    let carried = rows.iter().filter(|it| it.depth > 0);
    assert!(carried.clone().count() > 3);
    assert!(
        carried.clone().all(|it| it.hidden && it.locked),
        "with the house"
    );
    assert!(rows.iter().any(|it| !it.hidden && !it.locked));
}

#[test]
fn of_things_that_are_chosen_together_the_inspector_shows_what_they_share() {
    let dir = tempfile::tempdir().unwrap();
    let mut game = building(&dir);
    let up = WorkshopWish::Nudge([0, 4, 0]);
    ask(
        &mut game,
        [put("box"), put("box"), up, put("box"), widen(2.0)],
    );
    ask(&mut game, [choose("box", false), choose("box 2", true)]);
    let shown = |game: &Game, key: &str| {
        let mut told = Told::default();
        told.renew(&game.menus.texts, scene(game));
        let row = told.fields.into_iter().find(|it| it.key == key).unwrap();
        match row.kind {
            antipode_ui::workshop::FieldKind::Numbers(all, _) => {
                all.iter().map(|it| it.value).collect::<Vec<_>>()
            }
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(shown(&game, "size"), [Some(1.0); 3]);
    assert!(shown(&game, "at")[1].is_none(), "one is higher");
    ask(&mut game, [choose("box 3", true)]);
    assert_eq!(shown(&game, "size"), [None, Some(1.0), Some(1.0)]);
}
