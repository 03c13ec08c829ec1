//! What the lists of the workshop show: what stands in the room, and what was done to it.

use std::collections::HashMap;
use std::sync::Arc;

use antipode_language::{Texts, Value};
use antipode_room_scene::RoomScene;
use antipode_rooms::{Object, Room, What};
use antipode_ui::workshop::{HistoryRow, ObjectRow};
use antipode_workshop::{Arg, Marked, Said, Step};

/// What stands in the room, each behind the group that carries it.
pub fn objects(texts: &Texts, scene: &RoomScene) -> Vec<ObjectRow> {
    let room = scene.room();
    let mut listing = Listing {
        texts,
        marked: scene.document().marked(),
        carried: HashMap::new(),
        kinds: HashMap::new(),
        rows: Vec::with_capacity(room.objects.len()),
    };
    for object in &room.objects {
        let group = object.group.as_deref();
        listing.carried.entry(group).or_default().push(object);
    }
    listing.add(None, 0);
    listing.rows
}

/// A list of objects on its way.
struct Listing<'a> {
    texts: &'a Texts,
    marked: Marked<'a>,
    /// What each group carries.
    carried: HashMap<Option<&'a str>, Vec<&'a Object>>,
    /// The words for each kind, which take longer to put together than all else of a row.
    kinds: HashMap<&'static str, String>,
    rows: Vec<ObjectRow>,
}

impl<'a> Listing<'a> {
    fn add(&mut self, group: Option<&'a str>, depth: usize) {
        if depth > antipode_rooms::bounds::MOST_DEEP {
            return;
        }
        for object in self.carried.remove(&group).unwrap_or_default() {
            let is_group = object.what == What::Group;
            let words = self.kinds.entry(object.what.kind());
            let words = words.or_insert_with(|| kind(self.texts, &object.what));
            self.rows.push(ObjectRow {
                name: object.name.clone(),
                kind: words.clone(),
                depth,
                is_group,
                selected: self.marked.is_selected(object),
                hidden: self.marked.is_hidden(object),
                locked: self.marked.is_locked(object),
            });
            if is_group {
                self.add(Some(&object.name), depth + 1);
            }
        }
    }
}

/// What something is, in words.
pub fn kind(texts: &Texts, what: &What) -> String {
    texts.say(&format!("workshop-kind-{}", what.kind()))
}

/// What was done, in words.
pub fn steps(texts: &Texts, steps: &[Arc<Step>]) -> Vec<HistoryRow> {
    let told = steps.iter().map(|step| HistoryRow {
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
