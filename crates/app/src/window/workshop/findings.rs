//! What may be wrong with the room that is built in, looked for on a thread of its own while one builds.

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_room_scene::tuning::SHAPE;
use antipode_ui::workshop::MessageRow;
use antipode_workshop::{Checker, Finding};

use super::rows::said;

/// What was found so far.
#[derive(Debug)]
pub struct Findings {
    checker: Option<Checker>,
    /// The revision that it was told to look at.
    asked: Option<u64>,
    found: Vec<Finding>,
    /// Whether that is all that there is to find in it.
    is_all: bool,
}

impl Findings {
    /// Nothing yet.
    pub fn begin() -> Self {
        let checker = Checker::start(SHAPE);
        let checker = checker.inspect_err(|why| tracing::warn!("rooms are not checked: {why}"));
        Self {
            checker: checker.ok(),
            asked: None,
            found: Vec::new(),
            is_all: false,
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
        self.found.iter().map(row).collect()
    }

    /// How many there are.
    #[cfg(test)]
    pub fn count(&self) -> usize {
        self.found.len()
    }

    /// The one of that number.
    pub fn get(&self, number: usize) -> Option<&Finding> {
        self.found.get(number)
    }
}
