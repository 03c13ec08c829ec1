//! What the lists of the workshop say, worked out when the room or what is chosen has changed: a room has up to 2,000 things,
//! and a history 1,000 steps.

use std::sync::Arc;

use antipode_language::{Language, Texts};
use antipode_room_scene::RoomScene;
use antipode_rooms::Room;
use antipode_ui::workshop::{FieldRow, HistoryRow, ObjectRow, PartRow, ViewEvent, WorkshopWish};
use antipode_workshop::{Marks, Step};

use super::{chosen, fields, parts, rows};

/// The rows of all lists.
#[derive(Debug, Default)]
pub struct Told {
    /// Of which revision they are, and in which language; none where something was done since.
    of: Option<(u64, Language)>,
    /// In which language the parts and the steps are, and the last of these.
    lasting: Option<(Language, Option<Arc<Step>>)>,
    /// Of which room, with which marks and in which language the list of objects is.
    listed: Option<(Arc<Room>, Marks, Language)>,
    /// What stands in the room.
    pub objects: Vec<ObjectRow>,
    /// What can be changed of what is chosen.
    pub fields: Vec<FieldRow>,
    /// What can be put in.
    pub parts: Vec<PartRow>,
    /// What was done.
    pub history: Vec<HistoryRow>,
    /// What is chosen, in words.
    pub chosen: String,
}

impl Told {
    /// Something is done that may change what is chosen, hidden or locked.
    pub fn note(&mut self, wish: &WorkshopWish) {
        let only_looks = matches!(
            wish,
            WorkshopWish::View(
                ViewEvent::Hover(_)
                    | ViewEvent::Leave
                    | ViewEvent::Look(_)
                    | ViewEvent::Orbit(_)
                    | ViewEvent::Pan(_)
                    | ViewEvent::Zoom(_)
                    | ViewEvent::Fly(..)
            )
        );
        if !only_looks {
            self.of = None;
        }
    }

    /// Something is done elsewhere.
    pub fn forget(&mut self) {
        self.of = None;
    }

    /// Says anew what has changed. Returns whether anything has.
    pub fn renew(&mut self, texts: &Texts, scene: &RoomScene) -> bool {
        let now = (scene.document().revision(), texts.language());
        if self.of == Some(now) {
            return false;
        }
        self.of = Some(now);
        let document = scene.document();
        let listed = (document.room(), document.marks(), now.1);
        if !(self.listed.as_ref()).is_some_and(|it| reads_the_same((&it.0, &it.1, it.2), listed)) {
            self.objects = rows::objects(texts, scene);
            self.listed = Some((document.room_shared(), document.marks().clone(), now.1));
        }
        let chosen = chosen::indices(scene);
        self.fields = fields::rows(texts, scene, &chosen);
        self.chosen = chosen_words(texts, scene, &chosen);
        let steps = scene.document().history().steps();
        match &self.lasting {
            Some((language, last)) if *language == now.1 => {
                let last = last.as_ref();
                let same = |it: &Arc<Step>| last.is_some_and(|last| Arc::ptr_eq(it, last));
                // Steps are taken off at either end, and put to the last.
                let kept = steps.iter().rposition(same).map_or(0, |place| place + 1);
                let gone = self.history.len().saturating_sub(kept);
                self.history.drain(..gone);
                self.history.extend(rows::steps(texts, &steps[kept..]));
            }
            _ => {
                self.parts = parts::rows(texts);
                self.history = rows::steps(texts, steps);
            }
        }
        self.lasting = Some((now.1, steps.last().cloned()));
        true
    }
}

/// What the list of objects is made of.
type Listed<'a> = (&'a Room, &'a Marks, Language);

/// Whether the list of objects is the same for both.
fn reads_the_same(one: Listed<'_>, other: Listed<'_>) -> bool {
    (one.1, one.2) == (other.1, other.2) && said(one.0).eq(said(other.0))
}

fn said(room: &Room) -> impl Iterator<Item = (&str, Option<&str>, &str)> {
    let all = room.objects.iter();
    all.map(|it| (it.name.as_str(), it.group.as_deref(), it.what.kind()))
}

/// What is told of what is chosen.
fn chosen_words(texts: &Texts, scene: &RoomScene, chosen: &[usize]) -> String {
    match *chosen {
        [] => texts.say("workshop-room-itself"),
        [index] => {
            let object = &scene.room().objects[index];
            let values = [
                ("name", object.name.as_str().into()),
                ("kind", rows::kind(texts, &object.what).into()),
            ];
            texts.say_with("workshop-one", &values)
        }
        ref several => texts.say_with("workshop-several", &[("count", several.len().into())]),
    }
}
