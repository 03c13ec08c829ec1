//! Fills the model of the heads-up display from an open room.

use antipode_language::{Texts, Value};
use antipode_rays::View;
use antipode_room_scene::{Pick, RoomScene, Sizes};
use antipode_rooms::What;
use antipode_settings::Profiles;
use antipode_ui::{HudModel, RoomModel, first_input_label};

use super::visit::Visit;
use super::workshop::Lesson;
use crate::bindings::Action;
use crate::wording;

/// What differs less is not told, as a share.
const NOTICED: f64 = 0.02;

/// Light that is bent by less is told to be straight, degrees.
const BENT_DEG: f64 = 0.5;

/// What the display shows of a room.
pub fn model(texts: &Texts, profiles: &Profiles, visit: &Visit, fps: f32) -> HudModel {
    let words = wording::open_room(texts, &visit.room);
    let scene = visit.scene();
    let is_new = visit.is_new();
    let told = |text: &String| Some(text.clone()).filter(|text| is_new && !text.is_empty());
    let sentence = if words.sentence.is_empty() && visit.file().is_some() {
        texts.say("room-own")
    } else {
        words.sentence.clone()
    };
    let mut state = if visit.room.look == View::Plain {
        Vec::new()
    } else {
        let is_outside = scene.eye().place.stack.is_empty();
        state(texts, scene.sizes(), is_outside)
    };
    if is_new {
        state.push(keys(texts, profiles, visit.file().is_some()));
    }
    if let Some(key) = visit.lesson.as_ref().and_then(Lesson::walking_words) {
        state.push(texts.say(key));
    }
    HudModel {
        fps,
        geometry: words.name.clone(),
        show_crosshair: true,
        room: Some(RoomModel {
            title: told(&words.name),
            sentence: told(&sentence),
            ahead: ahead(texts, scene).filter(|_| visit.room.look == View::Exact),
            look: look(texts, visit),
            halves: (visit.room.look == View::Split)
                .then(|| ["room-half-thesis", "room-half-exact"].map(|key| texts.say(key))),
            state,
        }),
        ..HudModel::default()
    }
}

/// What the keys do that are for rooms in another way than for worlds.
fn keys(texts: &Texts, profiles: &Profiles, is_own: bool) -> String {
    let values = [
        ("look", Action::OtherMap),
        ("camera", Action::Camera),
        ("gun", Action::Use),
        ("lamp", Action::SecondUse),
        ("lift", Action::Backpack),
        ("ball", Action::Drop),
        ("anew", Action::FlipCar),
        ("again", Action::Talk),
        ("edges", Action::HitShapes),
    ]
    .map(|(name, action)| (name, first_input_label(texts, profiles, action).into()));
    let said = texts.say_with("room-keys", &values);
    if !is_own {
        return said;
    }
    let key = first_input_label(texts, profiles, Action::Workshop);
    let own = texts.say_with("room-keys-own", &[("build", key.into())]);
    format!("{said} · {own}")
}

/// By which rule the picture is made, if not by the game's own, and what the middle of it shows by either.
fn look(texts: &Texts, visit: &Visit) -> Option<String> {
    let key = match visit.room.look {
        View::Exact => return None,
        View::Split => "room-look-split",
        View::Thesis => "room-look-thesis",
        View::Plain => return Some(texts.say("room-look-plain")),
    };
    let it = visit.difference();
    if it.exact.felt.is_none() && it.thesis.felt.is_none() {
        return Some(texts.say(key));
    }
    let far = |length: Option<f64>| match length {
        Some(length) => {
            let metres = Value::decimals(length, usize::from(length < 10.0));
            texts.say_with("room-ahead", &[("felt", metres)])
        }
        None => texts.say("room-sky"),
    };
    let values = [
        ("exact", far(it.exact.felt).into()),
        ("thesis", far(it.thesis.felt).into()),
        ("bent", Value::decimals(it.thesis.turned_deg, 0)),
    ];
    let differs = if it.thesis.turned_deg >= BENT_DEG {
        texts.say_with("room-differs-bent", &values)
    } else {
        texts.say_with("room-differs", &values[..2])
    };
    Some(format!("{}\n{differs}", texts.say(key)))
}

/// How far off what is under the crosshair is; nothing over what is written on a sign.
fn ahead(texts: &Texts, scene: &RoomScene) -> Option<String> {
    let pick = scene.pick();
    let name = pick.object.as_ref()?;
    let mut objects = scene.room().objects.iter();
    let is_sign = objects.any(|it| it.name == *name && matches!(it.what, What::Sign { .. }));
    (!is_sign).then(|| lengths(texts, &pick))?
}

/// How far off it feels, and how far that is in the scene where it differs.
fn lengths(texts: &Texts, pick: &Pick) -> Option<String> {
    let (felt, scene) = (pick.felt?, pick.scene?);
    let metres = |length: f64| Value::decimals(length, usize::from(length < 10.0));
    let values = [("felt", metres(felt)), ("scene", metres(scene))];
    let key = if differ(felt, scene) {
        "room-ahead-bent"
    } else {
        "room-ahead"
    };
    Some(texts.say_with(key, &values))
}

fn differ(a: f64, b: f64) -> bool {
    (a - b).abs() > NOTICED * a.max(b)
}

/// How large one is, where that is not one's own size. Who is narrower along one direction only has not another size.
fn state(texts: &Texts, sizes: Sizes, is_outside: bool) -> Vec<String> {
    let told = |what: &str, scale: f64| {
        let (key, times) = if scale < 1.0 {
            ("room-smaller", 1.0 / scale)
        } else {
            ("room-larger", scale)
        };
        let times = Value::decimals(times, 1);
        let key = [key, what].concat();
        differ(scale, 1.0).then(|| texts.say_with(&key, &[("times", times)]))
    };
    let Sizes {
        up,
        level: [least, most],
    } = sizes;
    let level = if most < 1.0 { most } else { least.max(1.0) };
    if differ(up, level) {
        let both = [told("-level", level), told("-up", up)];
        return both.into_iter().flatten().collect();
    }
    // Who is in no aberration has been made larger or smaller by portals.
    let what = if is_outside { "-began" } else { "" };
    told(what, level).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picked(felt: f64, scene: f64) -> Option<String> {
        let pick = Pick {
            object: Some("wall".to_owned()),
            felt: Some(felt),
            scene: Some(scene),
            events: Vec::new(),
        };
        lengths(&Texts::default(), &pick)
    }

    #[test]
    fn a_length_that_is_felt_otherwise_is_told_both_ways() {
        let told = |felt, scene| picked(felt, scene).unwrap_or_default();
        assert_eq!(told(4.04, 4.0), "4.0 m");
        let bent = told(395.0, 79.0);
        assert!(bent.contains("395") && bent.contains("79"), "{bent}");
    }

    #[test]
    fn of_the_sky_nothing_is_told() {
        let pick = Pick {
            object: None,
            felt: None,
            scene: None,
            events: Vec::new(),
        };
        assert_eq!(lengths(&Texts::default(), &pick), None);
    }

    #[test]
    fn one_is_told_how_large_one_is_along_the_floor_and_in_height() {
        let told = |up, level| state(&Texts::default(), Sizes { up, level }, false).join("; ");
        assert_eq!(told(1.0, [1.0, 1.0]), "");
        assert_eq!(told(1.0, [0.1, 1.0]), "", "flat, but of one's own size");
        let alike = told(0.5, [0.5, 0.5]);
        assert!(alike.contains("2.0 times smaller") && !alike.contains("floor"));
        let twice = told(1.0, [2.0, 2.0]);
        assert!(twice.contains("Along the floor you are 2.0 times larger"));
        assert!(!twice.contains("height"), "{twice}");
        let both = told(0.5, [1.0 / 3.0, 1.0 / 3.0]);
        assert!(both.contains("floor you are 3.0") && both.contains("height you are 2.0"));
    }

    #[test]
    fn who_has_grown_by_portals_and_is_outside_is_not_told_of_an_outside() {
        let (up, level) = (8.0, [8.0, 8.0]);
        let told = state(&Texts::default(), Sizes { up, level }, true).join("; ");
        assert_eq!(told, "You are 8.0 times larger than at the start");
    }
}
