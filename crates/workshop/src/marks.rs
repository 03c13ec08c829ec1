//! What an editor keeps of objects besides the room: which are selected, hidden and locked. None of it is a step.

use std::collections::{BTreeSet, HashMap};

use antipode_rooms::room::Names;
use antipode_rooms::{Object, Room};

use crate::delta::Delta;
use crate::place::Groups;

/// Which objects are selected, hidden and locked, by their names.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Marks {
    pub(crate) selected: Vec<String>,
    pub(crate) hidden: BTreeSet<String>,
    pub(crate) locked: BTreeSet<String>,
}

impl Marks {
    /// The objects that carry the mark themselves or by a group.
    fn holds(set: &BTreeSet<String>, room: &Room, name: &str) -> bool {
        if set.is_empty() {
            return false;
        }
        let object = room.find(name).map(|(_, it)| it);
        set.contains(name) || object.is_some_and(|it| Self::carries(set, it, &Groups::of(room)))
    }

    fn carries(set: &BTreeSet<String>, object: &Object, groups: &Groups<'_>) -> bool {
        let up = || groups.up(object.group.as_deref());
        !set.is_empty()
            && (set.contains(&object.name) || up().iter().any(|it| set.contains(&it.name)))
    }

    pub(crate) fn hides(&self, object: &Object, groups: &Groups<'_>) -> bool {
        Self::carries(&self.hidden, object, groups)
    }

    pub(crate) fn locks(&self, object: &Object, groups: &Groups<'_>) -> bool {
        Self::carries(&self.locked, object, groups)
    }

    pub(crate) fn is_hidden(&self, room: &Room, name: &str) -> bool {
        Self::holds(&self.hidden, room, name)
    }

    pub(crate) fn is_locked(&self, room: &Room, name: &str) -> bool {
        Self::holds(&self.locked, room, name)
    }

    /// Follows what a step has renamed and taken away; `back` if it was taken back.
    pub(crate) fn follow(&mut self, delta: &Delta, back: bool) {
        let renamed: HashMap<&str, &str> = delta
            .renamed()
            .map(|(before, after)| {
                if back {
                    (after, before)
                } else {
                    (before, after)
                }
            })
            .collect();
        if renamed.is_empty() {
            return;
        }
        let now = |it: &String| {
            renamed
                .get(it.as_str())
                .map_or_else(|| it.clone(), |to| (*to).to_owned())
        };
        self.selected = self.selected.iter().map(now).collect();
        for set in [&mut self.hidden, &mut self.locked] {
            *set = set.iter().map(now).collect();
        }
    }

    /// Forgets what is not there any more.
    pub(crate) fn forget(&mut self, room: &Room) {
        if self == &Self::default() {
            return;
        }
        let names: Names<'_> = room.names().collect();
        self.selected.retain(|it| names.contains(it.as_str()));
        // What is hidden or locked stays so if it comes back by an undo.
    }
}
