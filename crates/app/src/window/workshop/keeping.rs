//! A room that is built in is kept by itself: every edit goes to its journal at once, and soon after the last of them the room
//! becomes its file, too. Nothing here waits for the disk.

use antipode_room_scene::RoomScene;
use antipode_rooms::RoomError;
use antipode_workshop::Trouble;

/// So long after the last change it becomes the file, seconds.
const QUIET_S: f64 = 1.0;

/// What of the room is on disk.
#[derive(Debug, Default)]
pub struct Keeping {
    /// The revision that was asked to become the file last.
    asked: u64,
    /// The revision of the last moment, and for how long it has been that.
    seen: u64,
    rests_s: f64,
    /// What was told last.
    told: Option<NotKept>,
}

/// Why a room is not kept as it should be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotKept {
    /// Something in it lies as it may in no file. What that is stands among the messages, too.
    Unsound(String),
    /// The disk refuses.
    Failed(String),
}

impl Keeping {
    /// Of a room that is kept as it is.
    pub fn of(scene: &RoomScene) -> Self {
        let revision = scene.document().revision();
        Self {
            asked: revision,
            seen: revision,
            ..Self::default()
        }
    }

    /// Lets time pass. Returns why the room is not kept as it should be, once for each reason.
    pub fn pass(&mut self, scene: &mut RoomScene, passed_s: f64) -> Option<NotKept> {
        let document = scene.document_mut();
        document.poll();
        let revision = document.revision();
        if revision == self.seen {
            self.rests_s += passed_s;
        } else {
            (self.seen, self.rests_s) = (revision, 0.0);
        }
        if self.rests_s >= QUIET_S && self.asked != revision && !document.is_dragging() {
            self.save(scene);
        }
        let why = scene.document().trouble().map(|trouble| match trouble {
            Trouble::NotSaved(why @ RoomError::Unsound(_)) => NotKept::Unsound(why.to_string()),
            Trouble::NotSaved(why) => NotKept::Failed(why.to_string()),
            Trouble::NotWritten(why) => NotKept::Failed(why.to_string()),
        });
        if why == self.told {
            return None;
        }
        self.told.clone_from(&why);
        why
    }

    /// What was told last is told again: it could not be said yet.
    pub fn tell_again(&mut self) {
        self.told = None;
    }

    /// Whether nothing has changed for so long that there is nothing more to keep.
    pub fn rests(&self) -> bool {
        self.rests_s > 2.0 * QUIET_S && self.asked == self.seen
    }

    /// The room as it is now becomes its file.
    pub fn save(&mut self, scene: &mut RoomScene) {
        let document = scene.document_mut();
        self.asked = document.revision();
        if let Err(why) = document.save() {
            tracing::info!("the room is not saved: {why}");
        }
    }
}
