//! What can be heard in the world: events of each step, and what surrounds the player. Plain data; nothing here
//! makes a sound, and nothing of it is saved.

use antipode_frame::hand::STROKE_S;
use antipode_geometry::{ChartPoint, Eye};
use antipode_items::Item;
use antipode_physics::Character;
use antipode_terrain::Cover;
use glam::DVec3;

use crate::actors::Actors;
use crate::day;
use crate::ground::Ground;
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::situation::Situation;

/// Something that makes a sound once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SoundEvent {
    /// A foot came down.
    Step {
        /// On what.
        cover: Cover,
        /// How fast the walker goes, m/s.
        speed_m_s: f64,
    },
    /// A fall or a jump ended.
    Landed {
        /// On what.
        cover: Cover,
        /// How fast the fall was, m/s.
        speed_m_s: f64,
    },
    /// The pickaxe bit. A tool that is held down does so again every [`STROKE_S`].
    Dug {
        /// Into what.
        cover: Cover,
    },
    /// Ground was built up; as often as digging.
    Built,
    /// Another slot of the hotbar was taken in hand.
    SlotChanged,
    /// The gun was fired.
    Shot,
    /// The gun's trigger was pulled for nothing.
    Clicked,
    /// A bullet struck someone.
    Struck,
    /// The player was hurt.
    Hurt,
    /// One of these was put down on the ground.
    PutDown(Item),
    /// One of these was taken up from where it was put down.
    TakenUp(Item),
    /// Something that lay about was picked up.
    PickedUp,
    /// A car's door.
    CarDoor,
    /// The car that the player drives ran into something.
    Crashed {
        /// By how much its speed was changed, m/s.
        speed_m_s: f64,
    },
    /// A bullet hit a car.
    CarHit,
    /// The horn of the player's car.
    Horn,
}

/// What a player hears all the time depends on this.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surroundings {
    /// Share of day, 0 at night to 1; a world without a sky has no night.
    pub day: f64,
    /// Height of the feet above the lowest ground of this world, metres; below zero in deep pits.
    pub height_m: f64,
    /// Highest ground above the lowest, metres.
    pub relief_m: f64,
    /// Speed through the air, m/s.
    pub speed_m_s: f64,
    /// The car that the player drives, if any.
    pub drive: Option<Drive>,
}

/// What is heard of the car that the player drives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive {
    /// What the pedals ask for, -1 to 1.
    pub throttle: f64,
    /// Speed ahead, m/s; backwards negative.
    pub speed_m_s: f64,
    /// How fast its tyres slide over the ground, m/s; nothing in the air.
    pub slide_m_s: f64,
}

/// Slower falls, in m/s, are steps: walking down a slope leaves the ground all the time.
const LANDING_FROM_M_S: f64 = 2.5;
/// Steps of who goes faster throw up dust, m/s.
const KICKS_UP_FROM_M_S: f64 = 5.0;
/// Share of the speed at which braked tyres slide.
const BRAKED_SHARE: f64 = 0.35;
/// The most events that are kept for a host that never asks, such as a script.
const MOST_EVENTS: usize = 64;

/// The events since they were last taken, and what is needed to tell the next.
#[derive(Debug, Default)]
pub(crate) struct Sounds {
    events: Vec<SoundEvent>,
    /// Simulated time until a tool that is held down sounds again, in seconds.
    stroke_left_s: f64,
}

impl Sounds {
    pub(crate) fn push(&mut self, event: SoundEvent) {
        if self.events.len() < MOST_EVENTS {
            self.events.push(event);
        }
    }

    /// What has happened since it was last taken, in order.
    pub(crate) fn take(&mut self) -> Vec<SoundEvent> {
        std::mem::take(&mut self.events)
    }

    /// Whether a tool in use sounds in this step of `dt_s` seconds.
    pub(crate) fn stroke_is_due(&mut self, used: bool, dt_s: f64) -> bool {
        self.stroke_left_s = (self.stroke_left_s - dt_s).max(0.0);
        if !used || self.stroke_left_s > 0.0 {
            return false;
        }
        self.stroke_left_s = STROKE_S;
        true
    }
}

/// What surrounds the player, whose picture is taken by that eye.
pub(crate) fn surroundings(now: Situation<'_>, eye: &Eye) -> Surroundings {
    let world = now.world;
    let (low_m, high_m) = world.ground.height_range_m();
    let sky = day::sky(world.time_of_day_s, &*world.strategy, eye);
    Surroundings {
        day: 1.0 - f64::from(sky.stars),
        height_m: now.feet().pos.y - low_m,
        relief_m: high_m - low_m,
        speed_m_s: now.actors.player_body().velocity.length(),
        drive: drive_heard(now.actors),
    }
}

fn drive_heard(actors: &Actors) -> Option<Drive> {
    let throttle = actors.cars.driving.as_ref()?.throttle;
    let car = actors.driven_car()?;
    let down = car.wheels.iter().any(|wheel| wheel.contact);
    let aside_m_s = car.velocity.dot(car.turn * DVec3::Z).abs();
    let braked_m_s = if car.brakes {
        BRAKED_SHARE * car.speed_m_s.abs()
    } else {
        0.0
    };
    Some(Drive {
        throttle,
        speed_m_s: car.speed_m_s,
        slide_m_s: if down { aside_m_s.max(braked_m_s) } else { 0.0 },
    })
}

/// Tells what the player's own body did in a step; `foot_down`: whether a foot came down.
pub(crate) fn hear_body(
    ground: &Ground,
    feet: ChartPoint,
    body: &Character,
    foot_down: bool,
    outbox: &mut Outbox,
) {
    let (impact_m_s, velocity) = (body.impact_m_s, body.velocity.with_y(0.0));
    if impact_m_s >= LANDING_FROM_M_S {
        let speed_m_s = impact_m_s;
        let landed = Effect::Landed {
            at: feet,
            speed_m_s,
        };
        outbox.effects.push(landed);
        outbox.sounds.push(SoundEvent::Landed {
            cover: ground.cover(feet),
            speed_m_s: impact_m_s,
        });
    } else if foot_down {
        if velocity.length() >= KICKS_UP_FROM_M_S {
            outbox.effects.push(Effect::Stepped { at: feet, velocity });
        }
        outbox.sounds.push(SoundEvent::Step {
            cover: ground.cover(feet),
            speed_m_s: velocity.length(),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_that_is_held_sounds_again_and_again_and_at_once_after_a_rest() {
        let mut sounds = Sounds::default();
        let dt_s = 1.0 / 60.0;
        let due = (0..60).filter(|_| sounds.stroke_is_due(true, dt_s)).count();
        assert_eq!(due, 4);
        for _ in 0..30 {
            assert!(!sounds.stroke_is_due(false, dt_s));
        }
        assert!(sounds.stroke_is_due(true, dt_s));
    }

    #[test]
    fn who_never_listens_costs_no_memory() {
        let mut sounds = Sounds::default();
        for _ in 0..10_000 {
            sounds.push(SoundEvent::Built);
        }
        assert_eq!(sounds.events.len(), MOST_EVENTS);
    }
}
