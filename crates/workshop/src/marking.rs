//! Selecting, hiding and locking objects, and copying what is selected.

use antipode_rooms::Object;
use antipode_rooms::room::Names;

use crate::clip::Clip;
use crate::document::Document;
use crate::marks::Marks;
use crate::place::Groups;

/// What is selected, hidden and locked in a room, to be asked of all its objects: to ask of each by itself takes a time that
/// grows with the square of their number.
pub struct Marked<'a> {
    marks: &'a Marks,
    selected: Names<'a>,
    groups: Groups<'a>,
}

impl Marked<'_> {
    /// Whether an object of the room is selected.
    pub fn is_selected(&self, object: &Object) -> bool {
        self.selected.contains(object.name.as_str())
    }

    /// Whether it is hidden, itself or by a group.
    pub fn is_hidden(&self, object: &Object) -> bool {
        self.marks.hides(object, &self.groups)
    }

    /// Whether it is locked, itself or by a group.
    pub fn is_locked(&self, object: &Object) -> bool {
        self.marks.locks(object, &self.groups)
    }
}

impl Document {
    /// The names of what is selected, in the order in which that was done; the last is the one that the inspector begins with.
    pub fn selection(&self) -> &[String] {
        &self.marks().selected
    }

    /// Selects these objects and no others; those that are not there are left out.
    pub fn select(&mut self, names: impl IntoIterator<Item = String>) {
        // Each once: what was taken is there no more.
        let mut left: Names<'_> = self.room().names().collect();
        let names = names.into_iter();
        let selected = names.filter(|it| left.remove(it.as_str())).collect();
        self.marks_mut().selected = selected;
    }

    /// All marks, to be asked of many objects.
    pub fn marked(&self) -> Marked<'_> {
        Marked {
            marks: self.marks(),
            selected: self.selection().iter().map(String::as_str).collect(),
            groups: Groups::of(self.room()),
        }
    }

    /// Selects an object besides those that are; one that is selected is no more.
    pub fn toggle(&mut self, name: &str) {
        let mut names = self.selection().to_vec();
        let had = names.len();
        names.retain(|it| it != name);
        if names.len() == had {
            names.push(name.to_owned());
        }
        self.select(names);
    }

    /// Whether an object is selected.
    pub fn is_selected(&self, name: &str) -> bool {
        self.selection().iter().any(|it| it == name)
    }

    /// Hides an object, or shows it again; a group with all that it carries. Hiding is no step, and the room stays as it is.
    pub fn hide(&mut self, name: &str, hidden: bool) {
        let name = name.to_owned();
        let set = &mut self.marks_mut().hidden;
        let _ = if hidden {
            set.insert(name)
        } else {
            set.remove(&name)
        };
        self.keep_marks();
    }

    /// Whether an object is hidden, itself or by a group.
    pub fn is_hidden(&self, name: &str) -> bool {
        self.marks().is_hidden(self.room(), name)
    }

    /// Whether an object is hidden itself.
    pub fn hides(&self, name: &str) -> bool {
        self.marks().hidden.contains(name)
    }

    /// Locks an object, or lets it go; a group with all that it carries. What is locked is not changed by edits.
    pub fn lock(&mut self, name: &str, locked: bool) {
        let name = name.to_owned();
        let set = &mut self.marks_mut().locked;
        let _ = if locked {
            set.insert(name)
        } else {
            set.remove(&name)
        };
        self.keep_marks();
    }

    /// Whether an object is locked, itself or by a group.
    pub fn is_locked(&self, name: &str) -> bool {
        self.marks().is_locked(self.room(), name)
    }

    /// Whether an object is locked itself.
    pub fn locks(&self, name: &str) -> bool {
        self.marks().locked.contains(name)
    }

    /// Copies what is selected, with all that groups carry. It is kept as [`Document::clipboard`], too.
    pub fn copy(&mut self) -> Clip {
        let clip = Clip::of(self.room(), self.selection());
        if !clip.is_empty() {
            self.clipboard = clip.clone();
        }
        clip
    }

    /// What was copied last.
    pub fn clipboard(&self) -> &Clip {
        &self.clipboard
    }
}
