//! What is in the player's hand in a world: how it is used, and when it is seen.

use antipode_frame::hand::{FLASH_COLOUR, FLASH_RANGE_M, HandMotion, bob_at};
use antipode_geometry::ChartPoint;
use antipode_items::Item;

use crate::camera::CameraMode;
use crate::frame::{Figure, Hand, LampLight, ModelId};
use crate::player::Appearance;
use crate::situation::Situation;
use crate::tuning::STEP_S;

/// A hand goes on by the step that has just been taken, in which a shot was fired or not; without a bob where the player wants
/// it `still`.
pub(crate) fn step(hand: &mut HandMotion, now: Situation<'_>, fired: bool, still: bool) {
    if fired {
        hand.fire();
    }
    let (player, body) = (now.player, now.actors.player_body());
    let bob = if still || !body.grounded {
        0.0
    } else {
        bob_at(body.velocity.x.hypot(body.velocity.z))
    };
    let held = player.inventory.held();
    let digs = held.and_then(Item::brush_strength_per_s).is_some();
    let used = digs && player.primary_before != player.secondary_before;
    hand.pass(held, used, bob, STEP_S);
}

/// Puts what the player holds and does with it into the own figure's hand.
pub(crate) fn use_in(hand: &HandMotion, held: Option<Item>, figure: &mut Figure) {
    let in_hand = held.filter(|item| item.fits_in_hand());
    figure.held = in_hand.map(ModelId::from);
    hand.move_arm(&mut figure.posture);
    figure.flashes = hand.flashes();
}

/// The light of a shot that has just been fired.
pub(crate) fn shot_light(hand: &HandMotion, muzzle: impl Fn() -> ChartPoint) -> Option<LampLight> {
    hand.flashes().then(|| LampLight {
        point: muzzle(),
        colour: FLASH_COLOUR,
        range_m: FLASH_RANGE_M,
    })
}

/// What the player sees in the own hand.
pub(crate) fn seen(now: Situation<'_>, hand: &HandMotion, still: bool) -> Option<Hand> {
    let player = now.player;
    let held = player.inventory.held()?;
    let from_head = player.gaze.camera == CameraMode::First;
    if !from_head || player.is_dead() || player.flying || now.actors.cars.is_driving() {
        return None;
    }
    let appearance = now.actors.ecs.get::<&Appearance>(now.actors.player);
    let cycles = appearance.map_or(0.0, |appearance| appearance.motion.cycles());
    Some(hand.seen(held, cycles, still))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tuning::{FLASH_S, SHOT_EVERY_S};

    /// Somebody with a door in hand would be seen standing in it.
    #[test]
    fn what_is_larger_than_a_hand_is_not_seen_in_one() {
        let point = ChartPoint::a(glam::DVec3::ZERO);
        for item in Item::ALL {
            let mut figure = Figure::standing(ModelId::Astronaut, point, 0.0);
            use_in(&HandMotion::default(), Some(item), &mut figure);
            assert_eq!(figure.held.is_none(), item == Item::Door, "{item:?}");
        }
    }

    /// The next shot's flash is a new one.
    #[test]
    fn a_flash_is_over_before_the_next_shot() {
        const { assert!(FLASH_S < SHOT_EVERY_S) };
    }
}
