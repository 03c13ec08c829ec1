//! The words that figures say at the moment, and their places in the picture.

use antipode_geometry::Strategy;
use glam::{DVec2, DVec3};

use super::bearing::apart_m;
use super::talk::Line;
use super::wounds::pictured_at;
use crate::bot;
use crate::moment::Seen;
use crate::situation::Situation;

/// How long words stay, in seconds.
const STAY_S: f64 = 8.0;
/// From farther off they are not heard, in metres.
const HEARD_M: f64 = 15.0;
/// How high over the crown they stand, in metres: over a bar of health, too.
const OVER_M: f64 = 0.35;

/// Words that were said.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Said {
    pub speaker: u32,
    /// Whether it is the first that this one says.
    pub greets: bool,
    pub line: Line,
    /// When, in the world's own time.
    pub at_s: f64,
}

/// Words in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speech {
    /// Whether it begins with a greeting.
    pub greets: bool,
    /// What is said.
    pub line: Line,
    /// Over the speaker's head, from the picture's middle to the right and up, in halves of its height; none while he
    /// is behind the player.
    pub at: Option<DVec2>,
}

/// Who is speaking: the words, and the speaker as others see him.
fn spoken(now: Situation<'_>) -> Option<(Said, bot::BotView)> {
    let said = now.actors.npcs.said?;
    if now.world.simulated_s - said.at_s > STAY_S {
        return None;
    }
    let mut bots = bot::views(now.actors).into_iter();
    let speaker = bots.find(|view| view.bot.id == said.speaker)?;
    // A figure that is shot at stops talking.
    let is_heard = speaker.health > 0.0
        && !speaker.fights
        && apart_m(&*now.world.strategy, now.feet(), speaker.point) < HEARD_M;
    is_heard.then_some((said, speaker))
}

/// Whether anybody is heard.
pub(crate) fn is_speaking(now: Situation<'_>) -> bool {
    spoken(now).is_some()
}

/// What is being said, in a picture that was taken so, of that vertical field of view in radians.
pub(crate) fn speech(
    now: Situation<'_>,
    pictured: &dyn Strategy,
    seen: &Seen,
    fov_y_rad: f64,
) -> Option<Speech> {
    spoken(now).map(|(said, speaker)| {
        let over = seen
            .place(speaker.bot.id, speaker.point)
            .moved(DVec3::Y * (now.actors.tuning.height_m + OVER_M));
        Speech {
            greets: said.greets,
            line: said.line,
            at: pictured_at(pictured, &seen.eye, over, fov_y_rad),
        }
    })
}
