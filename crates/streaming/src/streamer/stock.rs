//! What a gathering world's player has gathered, for the game to ask and to spend otherwise than by strokes.

use antipode_storage::EarthRecord;
use antipode_terrain::Stock;

use super::Streamer;
use crate::gathered::Gathered;

impl Streamer {
    /// From now on strokes of presses gather what they dig, and spend what they build; begins with what is kept of a world.
    pub fn gather(&mut self, kept: Option<&EarthRecord>) {
        self.gathered = Gathered::of(kept);
    }

    /// What there is to build with; none where nothing is gathered.
    pub fn stock(&self) -> Option<&Stock> {
        self.gathered.stock.as_ref()
    }

    /// Takes ground out of what was gathered, if there is as much of each kind; less than zero is given. Says whether it
    /// was done.
    pub fn spend(&mut self, price: &Stock) -> bool {
        let is_done = self.gathered.spend(price);
        self.saves.stale |= is_done;
        is_done
    }
}
