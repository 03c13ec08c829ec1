//! Older versions of the room that is built in: looked for and read on a thread, and taken in place of the room as a step.

use std::path::PathBuf;

use antipode_room_scene::RoomScene;
use antipode_rooms::folder::assets;
use antipode_rooms::{Assets, Room};
use antipode_ui::workshop::OlderRow;
use antipode_workshop::{Version, WorkshopError, read_version, versions};

use crate::dates::moment;
use crate::rooms::older_plan;
use crate::window::background::{Progress, Task};

type Read = Result<(Version, Room, Assets), WorkshopError>;

/// The list, and what is being read.
#[derive(Debug, Default)]
pub struct OlderList {
    rows: Option<Vec<OlderRow>>,
    looking: Option<Task<Vec<OlderRow>>>,
    reading: Option<Task<Read>>,
}

impl OlderList {
    /// The list, the newest first, while it is shown.
    pub fn rows(&self) -> Option<&[OlderRow]> {
        self.rows.as_deref()
    }

    /// Shows the list of the room in a folder, or hides it.
    pub fn show(&mut self, folder: PathBuf, shows: bool) {
        if !shows {
            *self = Self::default();
            return;
        }
        self.rows = Some(Vec::new());
        self.looking = Some(Task::start("versions", move || {
            let all = versions(&folder).into_iter();
            let row = |it: Version| OlderRow {
                when_s: it.when_s,
                text: moment(it.when_s),
            };
            all.map(row).collect()
        }));
    }

    /// Begins to read the one of that time.
    pub fn read(&mut self, folder: PathBuf, when_s: u64) {
        self.reading = Some(Task::start("version", move || {
            let version = Version { when_s };
            let room = read_version(&folder, version)?;
            let files = assets(&folder, &room)?;
            Ok((version, room, files))
        }));
    }

    /// Whether nothing is looked for or read.
    pub fn rests(&self) -> bool {
        self.looking.is_none() && self.reading.is_none()
    }

    /// Takes over what was found or read. Returns why that could not be done.
    pub fn pass(&mut self, scene: &mut RoomScene) -> Option<String> {
        if let Some(Progress::Done(rows)) = self.looking.as_ref().map(Task::poll) {
            self.rows = Some(rows);
            self.looking = None;
        }
        let read = match self.reading.as_ref()?.poll() {
            Progress::Running => return None,
            Progress::Done(read) => Some(read),
            Progress::Died => None,
        };
        self.reading = None;
        let made = read?.and_then(|(version, room, files)| {
            scene.document_mut().end_drag();
            let plan = older_plan(scene.document(), room, version)?;
            scene
                .make(plan, |_: &Room| Ok(files))
                .map_err(WorkshopError::Room)
        });
        made.err().map(|why| why.to_string())
    }
}
