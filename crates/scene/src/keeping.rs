//! What is known of a world's save while it is played.

use crate::notice::Notice;
use crate::persist::Unknown;

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
    pub unknown: Unknown,
}
