//! A room that is built in is kept by itself: soon after it has changed, off the main thread, and when it is left.

use antipode_room_scene::RoomScene;
use antipode_rooms::{Room, RoomError, RoomsDir};

use crate::window::background::{Progress, Task};

/// So long after the last change it is written, seconds.
const QUIET_S: f64 = 1.0;

/// What of the room is on disk.
#[derive(Debug)]
pub struct Keeping {
    /// The revision that is kept, or being written.
    kept: u64,
    /// The revision of the last moment, and for how long it has been that.
    seen: u64,
    rests_s: f64,
    writing: Option<Task<Result<(), RoomError>>>,
}

impl Keeping {
    /// Of a room that is kept as it is.
    pub fn of(scene: &RoomScene) -> Self {
        let revision = scene.document().revision();
        Self {
            kept: revision,
            seen: revision,
            rests_s: 0.0,
            writing: None,
        }
    }

    /// Lets time pass. Begins to write a room that has changed and rests, and returns why one could not be written.
    pub fn pass(
        &mut self,
        scene: &RoomScene,
        (dir, slug): (&RoomsDir, &str),
        passed_s: f64,
    ) -> Option<RoomError> {
        let revision = scene.document().revision();
        if revision == self.seen {
            self.rests_s += passed_s;
        } else {
            (self.seen, self.rests_s) = (revision, 0.0);
        }
        let trouble = self.poll();
        let rests = self.rests_s >= QUIET_S && !scene.document().is_dragging();
        if rests && self.writing.is_none() && self.kept != revision {
            self.write(scene.room(), revision, dir, slug);
        }
        trouble
    }

    fn poll(&mut self) -> Option<RoomError> {
        match self.writing.as_ref()?.poll() {
            Progress::Running => None,
            Progress::Done(Ok(())) | Progress::Died => {
                self.writing = None;
                None
            }
            Progress::Done(Err(why)) => {
                self.writing = None;
                Some(why)
            }
        }
    }

    fn write(&mut self, room: &Room, revision: u64, dir: &RoomsDir, slug: &str) {
        self.kept = revision;
        let (room, dir, slug) = (room.clone(), dir.clone(), slug.to_owned());
        self.writing = Some(Task::start("keep", move || dir.save(&slug, &room)));
    }

    /// The room is left: what is not written yet is written, and nobody waits for it.
    pub fn at_last(&mut self, scene: &RoomScene, dir: &RoomsDir, slug: &str) {
        let revision = scene.document().revision();
        if self.kept == revision {
            return;
        }
        let before = self.writing.take();
        self.kept = revision;
        let (room, dir, slug) = (scene.room().clone(), dir.clone(), slug.to_owned());
        Task::start("keep", move || {
            if let Some(before) = before {
                before.finish();
            }
            if let Err(why) = dir.save(&slug, &room) {
                tracing::error!("the room could not be kept: {why}");
            }
        });
    }
}
