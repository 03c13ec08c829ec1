//! What the lists of the workshop show: what stands in the room, and what was done to it.

use antipode_language::{Texts, Value};
use antipode_room_scene::RoomScene;
use antipode_rooms::{Room, What};
use antipode_ui::workshop::{HistoryRow, ObjectRow};
use antipode_workshop::{Arg, Said};

/// What stands in the room, each behind the group that carries it.
pub fn objects(texts: &Texts, scene: &RoomScene) -> Vec<ObjectRow> {
    let room = scene.room();
    let mut rows = Vec::with_capacity(room.objects.len());
    add_children(texts, scene, None, 0, &mut rows);
    rows
}

fn add_children(
    texts: &Texts,
    scene: &RoomScene,
    group: Option<&str>,
    depth: usize,
    rows: &mut Vec<ObjectRow>,
) {
    let (room, document) = (scene.room(), scene.document());
    if depth > antipode_rooms::bounds::MOST_DEEP {
        return;
    }
    for object in room
        .objects
        .iter()
        .filter(|it| it.group.as_deref() == group)
    {
        let is_group = object.what == What::Group;
        rows.push(ObjectRow {
            name: object.name.clone(),
            kind: kind(texts, &object.what),
            depth,
            is_group,
            selected: document.is_selected(&object.name),
            hidden: document.is_hidden(&object.name),
            locked: document.is_locked(&object.name),
        });
        if is_group {
            add_children(texts, scene, Some(&object.name), depth + 1, rows);
        }
    }
}

/// What something is, in words.
pub fn kind(texts: &Texts, what: &What) -> String {
    texts.say(&format!("workshop-kind-{}", what.kind()))
}

/// What was done, in words.
pub fn history(texts: &Texts, scene: &RoomScene) -> Vec<HistoryRow> {
    let steps = scene.document().history().steps().iter();
    let told = steps.map(|step| HistoryRow {
        text: said(texts, "step", &step.said),
    });
    told.collect()
}

/// What is said of a step or a finding, in the player's language.
pub fn said(texts: &Texts, of: &str, said: &Said) -> String {
    let values: Vec<(&str, Value<'_>)> = said
        .args
        .iter()
        .map(|(name, arg)| {
            let value = match arg {
                Arg::Number(number) if number.fract() == 0.0 => Value::from(*number as usize),
                Arg::Number(number) => Value::decimals(*number, 1),
                Arg::Text(text) => Value::from(text),
            };
            (name.as_str(), value)
        })
        .collect();
    match of {
        "step" => texts.say_with(&format!("workshop-step-{}", said.id), &values),
        _ => texts.say_with(&format!("workshop-finding-{}", said.id), &values),
    }
}

/// A name that nothing in the room has, made of a word.
pub fn free_name(room: &Room, word: &str) -> String {
    let is_free = |name: &String| room.find(name).is_none();
    let first = word.to_owned();
    if is_free(&first) {
        return first;
    }
    let mut names = (2..10_000).map(|number| format!("{word} {number}"));
    names.find(is_free).unwrap_or(first)
}
