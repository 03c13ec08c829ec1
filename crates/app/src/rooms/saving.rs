//! How the open room is saved when somebody asks for it: in place, or under another name as another room. What waits for the disk is
//! apart from what changes the open room, so that a window has it done on a thread.

use std::sync::Arc;

use antipode_rooms::{Room, RoomError, RoomSummary, RoomsDir};
use antipode_workshop::{Document, is_in_use};

use super::OpenRoom;
use super::kept::in_use;

/// What saves a room; it waits for the disk, and may be done on any thread.
pub type Saving = Box<dyn FnOnce() -> Result<Saved, RoomError> + Send>;

/// How a room was saved.
#[derive(Debug)]
pub enum Saved {
    /// In its own file.
    InPlace,
    /// As another room.
    As(Box<Copied>),
}

/// Another room that was made of one.
#[derive(Debug)]
pub struct Copied {
    /// Its folder.
    slug: String,
    /// As it was then.
    room: Room,
    /// Its journal, if the room before had one.
    document: Option<Document>,
}

impl OpenRoom {
    /// Keeps it as it is now; under another name as another room, which it is after [`Self::take_saved`].
    ///
    /// # Errors
    /// When it comes with the game or has no name and is given none. The work: when the name is taken, the room is in use elsewhere,
    /// or the disk refuses.
    pub fn saving(&mut self, dir: &RoomsDir, name: Option<&str>) -> Result<Saving, RoomError> {
        let dir = dir.clone();
        if let Some(name) = name {
            return Ok(self.saving_as(dir, name));
        }
        match self.kept.clone() {
            Some(kept) if kept.shipped => Err(RoomError::Shipped(kept.name)),
            // By way of the journal, which goes on from there.
            Some(_) if self.scene.document().dir().is_some() => {
                let written = self.scene.document_mut().saving()?;
                Ok(Box::new(move || written().map(|()| Saved::InPlace)))
            }
            Some(kept) => {
                let room = self.scene.document().room_shared();
                Ok(Box::new(move || {
                    if is_in_use(&dir.path().join(&kept.slug)) {
                        return Err(in_use(Some(&kept)));
                    }
                    dir.save(&kept.slug, &room).map(|()| Saved::InPlace)
                }))
            }
            None => Err(RoomError::Command(
                "This room has no name, so it is not kept; say room save name=...".to_owned(),
            )),
        }
    }

    /// The same, and waits for it.
    ///
    /// # Errors
    /// As [`Self::saving`], and its work.
    pub fn save(&mut self, dir: &RoomsDir, name: Option<&str>) -> Result<(), RoomError> {
        let saved = self.saving(dir, name)?()?;
        self.take_saved(saved).map(drop)
    }

    fn saving_as(&self, dir: RoomsDir, name: &str) -> Saving {
        let mut room = Arc::unwrap_or_clone(self.scene.document().room_shared());
        name.trim().clone_into(&mut room.name);
        // Its files come along.
        let own = self.kept.clone().filter(|kept| !kept.shipped);
        let has_journal = self.scene.document().dir().is_some();
        Box::new(move || {
            let slug = match own {
                Some(kept) => copied(&dir, &kept, &room)?,
                None => dir.make(&room)?,
            };
            // The journal of the first stays with that.
            let opened = has_journal.then(|| Document::open(&dir.path().join(&slug)));
            let document = opened.transpose()?.map(|it| it.document);
            Ok(Saved::As(Box::new(Copied {
                slug,
                room,
                document,
            })))
        })
    }

    /// It is the room as which it was saved. Returns the document that it had before where it has another now, whose end waits for
    /// the disk.
    ///
    /// # Errors
    /// If it cannot be called so.
    pub fn take_saved(&mut self, saved: Saved) -> Result<Option<Document>, RoomError> {
        let Saved::As(copied) = saved else {
            return Ok(None);
        };
        let Copied {
            slug,
            room,
            document,
        } = *copied;
        let before = document.map(|document| self.scene.take_document(document));
        if before.is_none() {
            self.scene.rename(&room.name)?;
        }
        self.kept = Some(RoomSummary {
            slug,
            name: room.name,
            sentence: room.sentence,
            objects: room.objects.len(),
            shipped: false,
            says: self.kept.take().and_then(|kept| kept.says),
            problem: None,
        });
        Ok(before)
    }
}

/// Makes a copy of a room with its files, under the name that the changed room has.
fn copied(dir: &RoomsDir, kept: &RoomSummary, room: &Room) -> Result<String, RoomError> {
    let slug = dir.double(kept)?;
    let copy = RoomSummary {
        slug: slug.clone(),
        ..kept.clone()
    };
    let made = dir
        .rename(&copy, &room.name)
        .and_then(|()| dir.save(&slug, room));
    if let Err(error) = made {
        dir.delete(&copy)?;
        return Err(error);
    }
    Ok(slug)
}
