//! Answers to the game's questions: what is loaded, what is still to come, and what is not saved.

use antipode_geometry::ChunkCoord;

use super::Streamer;

impl Streamer {
    /// Chunks to be loaded, and one more while an edit is under way.
    pub fn pending(&self) -> usize {
        self.scheduler.coming() + usize::from(self.is_editing())
    }

    /// Is everything of this chunk there? Chunks in range without a surface always are.
    pub fn is_resident(&self, coord: ChunkCoord) -> bool {
        self.scheduler.is_resident(coord)
    }

    /// Is nothing more to come of this chunk? As [`is_resident`](Self::is_resident), and true too
    /// for one that could not be made and was given up.
    pub fn is_ready(&self, coord: ChunkCoord) -> bool {
        self.scheduler.is_ready(coord)
    }

    /// May bodies move in this chunk? It is solid, has no surface or was given up, whatever the view has made of it.
    pub fn is_firm(&self, coord: ChunkCoord) -> bool {
        self.scheduler.is_firm(coord)
    }

    /// Is this chunk within the view last wished for?
    pub fn is_wanted(&self, coord: ChunkCoord) -> bool {
        self.scheduler.is_wanted(coord)
    }

    /// Is this chunk within the view, or the chunk beyond it that is kept so that walking to and fro loads nothing?
    pub fn keeps_in_view(&self, coord: ChunkCoord) -> bool {
        self.scheduler.keeps_in_view(coord)
    }

    /// Number of chunks with a mesh that are there.
    pub fn resident_count(&self) -> usize {
        self.scheduler.resident_count()
    }

    /// Number of chunks of the world that the player has changed.
    pub fn edited_count(&self) -> usize {
        self.scheduler.edited_count()
    }

    /// Number of saves asked for and not ended.
    pub fn saves_in_flight(&self) -> usize {
        let whole = usize::from(self.saves.whole.is_some());
        usize::from(self.saves.in_flight) + whole + self.saves.asked.len()
    }

    /// Are there edits that no save asked for so far holds? So it is from a stroke to the next save, and after a
    /// save that failed.
    pub fn needs_save(&self) -> bool {
        self.saves.stale || self.saves.last_failure.is_some()
    }
}
