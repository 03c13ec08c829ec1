//! Remembers what a world's save holds while the world is played.

use antipode_storage::{RecordChanges, SlotRecord};

use crate::notice::Notice;
use crate::persist::All;

/// Whether and since when the world is kept.
#[derive(Debug, Default)]
pub(crate) struct Keeping {
    pub stored: bool,
    pub saved_at_s: f64,
    pub save_problem: Option<Notice>,
    pub created_unix_s: u64,
    /// Whether a command that cheats was ever used in this world.
    pub cheated: bool,
    /// Whether anything but the terrain may differ from what was last given to be saved.
    pub changed: bool,
    /// Things in the player's slots that this version does not know, as a newer one would: they go back as they came.
    pub unknown_slots: Vec<SlotRecord>,
    /// What the scene has of the save, or has last given to be saved. What else the save holds is not the scene's.
    pub handed: All,
}

impl Keeping {
    /// What of these is to be saved, since it has changed, and what is gone.
    pub fn hand_over(&mut self, now: All) -> RecordChanges {
        let before = std::mem::take(&mut self.handed);
        let changed = now
            .iter()
            .filter(|(key, record)| before.get(key) != Some(record))
            .map(|(key, record)| (*key, Some(record.clone())));
        let gone = before.keys().filter(|key| !now.contains_key(key));
        let changes = changed.chain(gone.map(|key| (*key, None))).collect();
        self.handed = now;
        changes
    }
}
