//! Notices when the player comes into another biome, or into a cave below it.

use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::tuning::STEP_S;
use crate::world::World;
use antipode_geometry::ChartPoint;
use glam::DVec3;

/// One is in a biome once one has been there for so long: along a border names would come and go, seconds.
const STAY_S: f64 = 1.0;

/// What caves are called where biomes have a name.
const CAVE: &str = "cave";

/// The biome or cave that the player is in.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct InBiome {
    /// Its name, once it is known.
    is: Option<&'static str>,
    /// For how long it has been another one, seconds.
    other_s: f64,
}

impl InBiome {
    /// The name of the biome, or `cave`, once it is known.
    pub(crate) fn name(self) -> Option<&'static str> {
        self.is
    }
}

/// Tells the player of a biome or cave that he enters, but not of that in which he begins.
pub(crate) fn notice(world: &World, feet: ChartPoint, within: &mut InBiome, outbox: &mut Outbox) {
    let field = world.ground.field();
    let here = if field.is_cave(feet.moved(DVec3::Y)) {
        CAVE
    } else {
        field.biome_at(feet).name()
    };
    if within.is.is_none_or(|is| is == here) {
        *within = InBiome {
            is: Some(here),
            other_s: 0.0,
        };
        return;
    }
    within.other_s += STEP_S;
    if within.other_s >= STAY_S {
        within.is = Some(here);
        within.other_s = 0.0;
        outbox.hints.push(Hint::Entered(here));
    }
}
