//! Whether the picture can change by itself.

use super::game::Game;
use super::phase::Phase;
use super::veil::Veil;

impl Game {
    /// Whether nothing moves until somebody does something: a paused world whose land is all there, or a menu that
    /// no world flies by behind, and no work is under way that has something to show when it ends.
    pub fn is_still(&self) -> bool {
        let rests = match &self.phase {
            Phase::Paused(session) => {
                let lifts = matches!(self.veil, Veil::Drawn | Veil::Lifting(_));
                session.scene.pending() == 0 && !self.saving && !self.wants_picture && !lifts
            }
            Phase::Menu => !self.wants_backdrop(),
            _ => false,
        };
        rests && self.menus.list.is_idle() && self.shots.is_idle()
    }

    /// Whether what is drawn is an open world.
    pub fn shows_world(&self) -> bool {
        matches!(self.phase, Phase::Playing(_) | Phase::Paused(_))
    }
}
