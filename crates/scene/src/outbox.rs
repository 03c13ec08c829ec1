//! What a step has to tell to whoever shows or plays it: taken out by the host, asked for by no rule.

use crate::actors::ActorId;
use crate::notice::{Hint, Notice};
use crate::particles::Effects;
use crate::sound::Sounds;
use antipode_geometry::ChunkCoord;

/// Events since somebody last took them.
#[derive(Debug, Default)]
pub(crate) struct Outbox {
    /// What has gone wrong.
    pub notices: Vec<Notice>,
    /// Short answers to what the player did.
    pub hints: Vec<Hint>,
    /// What could be heard.
    pub sounds: Sounds,
    /// The flag that the player wants to name.
    pub names_flag: Option<ActorId>,
    /// What threw up ground in the last step.
    pub effects: Effects,
    /// The chunks whose ground has been changed since the last step.
    pub ground_changed: Vec<ChunkCoord>,
    /// Whether the player fired in the last step.
    pub fired: bool,
}
