//! The senses of a mind: what it sees along geodesics, what it hears, and who is near.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Eye, Map, Strategy};
use antipode_physics::CharacterTuning;
use glam::DVec3;
use hecs::Entity;

use super::bearing::{apart_m, way};
use super::doors::Sight;
use super::hidden::OtherPicture;
use super::tuning::{FEELS_M, GLANCE_HALF_RAD};
use crate::aimed::ViewParams;
use crate::bot::BotView;
use crate::car::CarView;
use crate::fixture::Fixture;
use crate::lens::own_view;
use crate::player::Look;
use crate::world::World;

/// A line of sight is not tested over the last of it: who stands against a wall is seen before it, in metres.
const LAST_M: f64 = 0.3;

/// Something that happened and may be noticed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Event {
    /// The player fired there.
    Shot(ChartPoint),
    /// Someone was hit there.
    Hit {
        /// Who.
        victim: Entity,
        /// Where.
        at: ChartPoint,
        /// Whether the player did it.
        by_player: bool,
    },
    /// Something frightening is there, as far as it frightens, in metres.
    Scare(ChartPoint, f64),
    /// The ground of the chunk about there was changed.
    Ground(ChartPoint),
}

/// The player as others may find it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quarry {
    /// The eye in the player's head, looking at the world as its own picture has it.
    pub head: Eye,
    /// Where the feet are.
    pub feet: ChartPoint,
    /// Velocity in metres of the space along the axes of the feet's chart, m/s.
    pub velocity: DVec3,
}

/// The world around a mind, as it was when the step began.
pub(crate) struct Around<'a> {
    pub world: &'a World,
    pub tuning: &'a CharacterTuning,
    /// The player, where there is one to be met: neither dead nor a spectator.
    pub quarry: Option<Quarry>,
    /// The picture that the player aims by, where it is not the world's own.
    pub picture: Option<&'a OtherPicture>,
    /// All figures that live, the one that looks among them.
    pub living: &'a [BotView],
    /// Cars that come, and the level way that each takes, m/s.
    pub cars: &'a [(CarView, DVec3)],
    pub lamps: &'a [Fixture],
    pub events: &'a [Event],
}

impl Around<'_> {
    /// The world's own.
    pub fn strategy(&self) -> &dyn Strategy {
        &*self.world.strategy
    }

    /// Whether the player is in sight of someone whose feet are at a point: just when the player could see that one too,
    /// in the world's own picture. Tested from head to head, and from head to belt.
    pub fn sees_player(&self, quarry: &Quarry, point: ChartPoint) -> bool {
        self.shows(self.strategy(), &quarry.head, point)
    }

    /// Whether the player's picture hides someone whose feet are at a point.
    pub fn hides(&self, point: ChartPoint) -> bool {
        self.picture
            .is_some_and(|it| !self.shows(&*it.strategy, &it.head, point))
    }

    fn shows(&self, strategy: &dyn Strategy, head: &Eye, point: ChartPoint) -> bool {
        [self.tuning.eye_height_m(), 0.5 * self.tuning.height_m]
            .into_iter()
            .any(|rise_m| {
                let spot = point.moved(DVec3::Y * rise_m);
                sees(strategy, self.world, head, spot)
            })
    }

    /// Whether someone whose feet are at a point sees another place.
    pub fn sees_place(&self, point: ChartPoint, place: ChartPoint) -> bool {
        let height_m = self.tuning.eye_height_m();
        let eye = Eye {
            point: point.moved(DVec3::Y * height_m),
            dial: own_dial(self.strategy()),
            lift_m: height_m,
            ..Eye::default()
        };
        sees(self.strategy(), self.world, &eye, place)
    }

    /// Whether a place, or the door by which it is nearer, is where someone looks at a glance, or close enough to be felt.
    pub fn is_before(&self, point: ChartPoint, look: &Look, place: ChartPoint) -> bool {
        let detour = self.detour(point, place);
        let place = detour.map_or(place, |detour| detour.beyond);
        let there = way(self.strategy(), point, place);
        there.level_m < FEELS_M || there.heading.dot(look.heading()) > GLANCE_HALF_RAD.cos()
    }

    /// How far apart two places are, in metres of the space.
    pub fn apart_m(&self, a: ChartPoint, b: ChartPoint) -> f64 {
        apart_m(self.strategy(), a, b)
    }
}

/// The world's own picture, by which others see: no choice of the player's has a part in it.
pub(crate) fn world_view_params(world: &World) -> ViewParams {
    ViewParams {
        strategy: Arc::clone(&world.strategy),
        dial: own_dial(&*world.strategy),
        straight_shots: false,
        dips: false,
        reduced_motion: false,
        own: true,
    }
}

/// The dial at which a world's own picture is taken: that of every new world, wherever the player sets it.
fn own_dial(strategy: &dyn Map) -> f64 {
    own_view(strategy).dial().map_or(0.0, |dial| dial.default)
}

/// Whether a place is in sight of an eye of a picture of the world, past no ground: straight, or through a door.
pub(crate) fn sees(strategy: &dyn Strategy, world: &World, eye: &Eye, place: ChartPoint) -> bool {
    Sight::of(strategy, world).is_clear(eye, place, LAST_M)
}

/// Whether it is in sight where it is, through no door.
pub(super) fn sees_straight(
    strategy: &dyn Strategy,
    world: &World,
    eye: &Eye,
    place: ChartPoint,
) -> bool {
    Sight::of(strategy, world).is_clear_straight(eye, place, LAST_M)
}
