//! Fighters whom the picture hides: others see along the world's own geodesics, the player by a picture that may bend them
//! otherwise. A mark on the display points to one who is hidden so, and he holds his fire until it has been there a while.

use std::sync::Arc;

use antipode_geometry::{Eye, Strategy};

use super::bearing::way;
use super::figure::Npc;
use super::mind::Mind;
use super::senses::Around;
use super::tuning::{MARKED_S, SHOOTS_M};
use crate::player::{Health, Position};
use crate::situation::Situation;

/// A figure that was in sight so long ago still counts as in sight, in seconds: everyone looks every tenth of one.
pub(super) const IN_SIGHT_S: f64 = 0.2;

/// The picture that the player aims by, where it is not the world's own.
#[derive(Clone, Debug)]
pub(crate) struct OtherPicture {
    pub strategy: Arc<dyn Strategy>,
    pub head: Eye,
}

impl Npc<'_> {
    /// Looks whether the picture hides one who could shoot.
    pub(super) fn hide(&mut self, around: &Around<'_>) {
        let fights = self.mind.state.shoots();
        let sees = self
            .mind
            .known
            .is_some_and(|known| known.ago_s < IN_SIGHT_S);
        let hidden = around.quarry.as_ref().is_some_and(|quarry| {
            fights
                && sees
                && around.apart_m(self.position.0, quarry.feet) < SHOOTS_M
                && around.hides(self.position.0)
        });
        self.mind.hidden_s = hidden.then(|| self.mind.hidden_s.unwrap_or(0.0));
    }

    /// Whether the player has not been shown yet where one is who cannot be seen.
    pub(super) fn holds_fire(&self) -> bool {
        self.mind.hidden_s.is_some_and(|since_s| since_s < MARKED_S)
    }
}

/// The picture that the player aims by, unless it is the world's own.
pub(super) fn other_picture(now: Situation<'_>) -> Option<OtherPicture> {
    let params = now.aiming();
    (!params.own).then(|| OtherPicture {
        head: now.head_through(&params),
        strategy: params.strategy,
    })
}

/// Headings of the player's chart, radians, to those who could shoot at the player and are not to be seen in the
/// picture.
pub(crate) fn hidden_foes(now: Situation<'_>) -> Vec<f64> {
    let feet = now.feet();
    let mut query = now.actors.ecs.query::<(&Mind, &Position, &Health)>();
    let hidden = query
        .iter()
        .filter(|(mind, _, health)| mind.hidden_s.is_some() && health.0 > 0.0);
    hidden
        .map(|(_, position, _)| {
            let heading = way(&*now.world.strategy, feet, position.0).heading;
            heading.z.atan2(heading.x)
        })
        .collect()
}
