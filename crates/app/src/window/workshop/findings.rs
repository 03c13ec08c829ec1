//! What may be wrong with the room that is built in, looked for on a thread of its own while one builds.

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_room_scene::tuning::SHAPE;
use antipode_ui::workshop::MessageRow;
use antipode_workshop::{Checker, Finding};

use super::rows::said;
use crate::rooms::RoomNote;

/// What was found so far.
#[derive(Debug)]
pub struct Findings {
    checker: Option<Checker>,
    /// The revision that it was told to look at.
    asked: Option<u64>,
    found: Vec<Finding>,
    /// Whether that is all that there is to find in it.
    is_all: bool,
    /// What there is to tell of how the room was found; above all others, until it is read.
    notes: Vec<RoomNote>,
}

impl Findings {
    /// Nothing yet but what there is to tell of how the room was found.
    pub fn begin(notes: Vec<RoomNote>) -> Self {
        let checker = Checker::start(SHAPE);
        let checker = checker.inspect_err(|why| tracing::warn!("rooms are not checked: {why}"));
        Self {
            checker: checker.ok(),
            asked: None,
            found: Vec::new(),
            is_all: false,
            notes,
        }
    }

    /// Has a room that has changed looked at, and takes over what was found.
    pub fn pass(&mut self, scene: &RoomScene) {
        let Some(checker) = &self.checker else { return };
        let document = scene.document();
        let revision = document.revision();
        if self.asked != Some(revision) && !document.is_dragging() {
            self.asked = Some(revision);
            self.is_all = false;
            checker.look(revision, document.room_shared(), scene.assets().clone());
        }
        if let Some(news) = checker.poll() {
            self.found = news.findings;
            self.is_all = news.is_all;
        }
    }

    /// Whether nothing more is to be found in the room as it is.
    pub fn rest(&self) -> bool {
        self.is_all || self.checker.is_none()
    }

    /// In words.
    pub fn rows(&self, texts: &Texts) -> Vec<MessageRow> {
        let row = |it: &Finding| MessageRow {
            text: said(texts, "finding", &it.said),
            is_grave: it.is_grave,
        };
        let notes = self.notes.iter().map(|it| note(texts, it));
        notes.chain(self.found.iter().map(row)).collect()
    }

    /// The first of those for which something does not work as it stands, in words.
    pub fn gravest(&self, texts: &Texts) -> Option<String> {
        let grave = self.found.iter().find(|it| it.is_grave)?;
        Some(said(texts, "finding", &grave.said))
    }

    /// How many there are.
    #[cfg(test)]
    pub fn count(&self) -> usize {
        self.found.len()
    }

    /// The finding of that row. What there is to tell of the room itself is read then, and gone.
    pub fn take(&mut self, number: usize) -> Option<Finding> {
        if number < self.notes.len() {
            self.notes.remove(number);
            return None;
        }
        self.found.get(number - self.notes.len()).cloned()
    }

    /// What was not read.
    pub fn unread(&mut self) -> Vec<RoomNote> {
        std::mem::take(&mut self.notes)
    }
}

/// What there is to tell of how a room was found, in words.
pub fn note(texts: &Texts, note: &RoomNote) -> MessageRow {
    let (text, is_grave) = match note {
        RoomNote::Ahead => (texts.say("workshop-note-ahead"), false),
        RoomNote::Changed => (texts.say("workshop-note-changed"), false),
        RoomNote::Aside(path) => {
            let file = path.display().to_string().into();
            (
                texts.say_with("workshop-note-aside", &[("file", file)]),
                true,
            )
        }
        RoomNote::InUse => (texts.say("workshop-in-use"), true),
        RoomNote::NoJournal(why) => {
            let why = why.trim_end_matches('.').into();
            (
                texts.say_with("workshop-no-journal", &[("reason", why)]),
                true,
            )
        }
    };
    MessageRow { text, is_grave }
}
