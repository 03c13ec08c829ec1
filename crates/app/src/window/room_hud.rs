//! Fills the model of the heads-up display from an open room.

use antipode_language::{Texts, Value};
use antipode_rays::View;
use antipode_room_scene::{Pick, RoomScene};
use antipode_rooms::What;
use antipode_settings::Profiles;
use antipode_ui::{HudModel, RoomModel, first_input_label};

use super::visit::Visit;
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
    let sentence = match visit.file() {
        // Who has made a room is told where it is changed.
        Some(file) if words.sentence.is_empty() => {
            texts.say_with("room-file", &[("file", file.display().to_string().into())])
        }
        _ => words.sentence.clone(),
    };
    let mut state = state(texts, scene);
    if is_new {
        state.push(keys(texts, profiles));
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
fn keys(texts: &Texts, profiles: &Profiles) -> String {
    let values = [
        ("look", Action::OtherMap),
        ("camera", Action::Camera),
        ("gun", Action::Use),
        ("lamp", Action::SecondUse),
        ("ball", Action::Drop),
        ("anew", Action::FlipCar),
        ("again", Action::Talk),
    ]
    .map(|(name, action)| (name, first_input_label(texts, profiles, action).into()));
    texts.say_with("room-keys", &values)
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

/// How large one is, where that is not one's own size.
fn state(texts: &Texts, scene: &RoomScene) -> Vec<String> {
    let [least, most] = scene.scales();
    // Who is narrower only has not another size.
    let scale = if most < 1.0 { most } else { least };
    if (most >= 1.0 && least <= 1.0) || !differ(scale, 1.0) {
        return Vec::new();
    }
    let (key, times) = if scale < 1.0 {
        ("room-smaller", 1.0 / scale)
    } else {
        ("room-larger", scale)
    };
    vec![texts.say_with(key, &[("times", Value::decimals(times, 1))])]
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
}
