//! All that lives, moves or lies about in a world: entities whose components say what they are. All but the player
//! have an [`ActorId`]; beside it figures are several components, and each other kind is one.

use std::any::TypeId;
use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{ChartPoint, Strategy};
use antipode_physics::{Character, CharacterTuning, VehiclePhysics};
use antipode_storage::RecordKind;
use antipode_terrain::Field;
use glam::DVec3;
use hecs::{Component, DynamicBundle, Entity};

use crate::car::Cars;
use crate::fixture::Fixture;
use crate::npc::Npcs;
use crate::persist::fixture_kind;
use crate::player::{self, Body, Health, Look, Position};
use crate::spawn::{FIRST_YAW_RAD, spawn_point};
use crate::tuning::FULL_HEALTH;

/// The number of an actor, one among those of its kind and never given twice while a world is open: by it pictures and
/// saves find it again. It is kept in saves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ActorId(pub u32);

/// Those that are numbered together.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Of(TypeId),
    /// What was put down, by the kind of record that it is kept as.
    Fixture(RecordKind),
}

/// All actors of a world.
pub(crate) struct Actors {
    pub ecs: hecs::World,
    pub player: Entity,
    pub tuning: CharacterTuning,
    /// What cars have in common.
    pub cars: Cars,
    /// Of each kind the number that the next one gets.
    next: HashMap<Kind, u32>,
    /// What other figures have in common.
    pub npcs: Npcs,
}

impl Actors {
    /// A player who has just come, alone.
    pub fn new(field: &Field, space: &Arc<dyn Strategy>) -> Self {
        let look = Look {
            yaw: FIRST_YAW_RAD,
            pitch: 0.0,
        };
        let mut actors = Self::with_player(player::components(spawn_point(field), look));
        actors.cars.physics = VehiclePhysics::default().in_space(space);
        actors
    }

    /// A player of these components, alone.
    pub fn with_player(components: impl DynamicBundle) -> Self {
        let mut ecs = hecs::World::new();
        let player = ecs.spawn(components);
        Self {
            ecs,
            player,
            tuning: CharacterTuning::default(),
            cars: Cars::default(),
            next: HashMap::new(),
            npcs: Npcs::default(),
        }
    }

    /// Where the player's feet are.
    pub fn feet(&self) -> ChartPoint {
        let position = self.ecs.get::<&Position>(self.player);
        position.map_or(ChartPoint::a(DVec3::ZERO), |position| position.0)
    }

    /// Where the player's feet are, and the way he looks.
    pub fn player_stance(&self) -> (Position, Look) {
        let mut found = self.ecs.query_one::<(&Position, &Look)>(self.player);
        found.get().map_or_else(
            |_| (Position(ChartPoint::a(DVec3::ZERO)), Look::LEVEL),
            |(position, look)| (*position, *look),
        )
    }

    /// The player's body.
    pub fn player_body(&self) -> Character {
        let body = self.ecs.get::<&Body>(self.player);
        body.map_or_else(|_| Character::at(DVec3::ZERO), |body| body.0.clone())
    }

    /// Has the player look that way, radians, keeping short of the vertical.
    pub fn set_look(&mut self, yaw: f64, pitch: f64) {
        if let Ok(mut look) = self.ecs.get::<&mut Look>(self.player) {
            *look = Look::LEVEL;
            look.turn(yaw, pitch);
        }
    }

    /// The player's health.
    pub fn health(&self) -> f64 {
        let health = self.ecs.get::<&Health>(self.player);
        health.map_or(FULL_HEALTH, |health| health.0)
    }

    /// Sets the player's health, kept within 0 and full.
    pub fn set_health(&mut self, health: f64) {
        if let Ok(mut own) = self.ecs.get::<&mut Health>(self.player) {
            own.0 = health.clamp(0.0, FULL_HEALTH);
        }
    }

    /// Lets one more of a kind in.
    pub fn enter<T: Component>(&mut self, kind: T) -> ActorId {
        let id = self.give_number::<T>();
        self.ecs.spawn((id, kind));
        id
    }

    /// Lets in one more that was put down.
    pub fn enter_fixture(&mut self, it: Fixture) -> ActorId {
        let id = self.give(Kind::Fixture(fixture_kind(it.item)));
        self.ecs.spawn((id, it));
        id
    }

    /// Gives a number to one more of a kind.
    pub fn give_number<T: Component>(&mut self) -> ActorId {
        self.give(Kind::Of(TypeId::of::<T>()))
    }

    fn give(&mut self, kind: Kind) -> ActorId {
        let next = self.next.entry(kind).or_default();
        let id = ActorId(*next);
        *next = next.wrapping_add(1);
        id
    }

    /// The number that the next of a kind gets.
    pub fn next<T: Component>(&self) -> ActorId {
        let next = self.next.get(&Kind::Of(TypeId::of::<T>()));
        ActorId(next.copied().unwrap_or_default())
    }

    /// Says which number that is.
    pub fn number_next<T: Component>(&mut self, number: u32) {
        self.next.insert(Kind::Of(TypeId::of::<T>()), number);
    }

    /// Says which number the next has that was put down and is kept as such a record.
    pub fn number_next_fixture(&mut self, kind: RecordKind, number: u32) {
        self.next.insert(Kind::Fixture(kind), number);
    }

    /// All of a kind, in the order in which they came.
    pub fn all<T: Component + Clone>(&self) -> Vec<(ActorId, T)> {
        self.map(|id, it: &T| (id, it.clone()))
    }

    /// What all of a kind are, in the order in which they came.
    pub fn each<T: Component + Clone>(&self) -> Vec<T> {
        self.map(|_, it: &T| it.clone())
    }

    /// What is made of each of a kind, in the order in which they came.
    pub fn map<T: Component, R>(&self, make: impl Fn(ActorId, &T) -> R) -> Vec<R> {
        let mut query = self.ecs.query::<(&ActorId, &T)>();
        let mut all: Vec<_> = query.iter().collect();
        all.sort_unstable_by_key(|(id, _)| **id);
        all.into_iter().map(|(id, it)| make(*id, it)).collect()
    }

    /// What is made of one of a kind, if it is there.
    pub fn map_one<T: Component, R>(&self, id: ActorId, make: impl Fn(&T) -> R) -> Option<R> {
        let mut query = self.ecs.query::<(&ActorId, &T)>();
        let found = query.iter().find(|(it, _)| **it == id);
        found.map(|(_, it)| make(it))
    }

    /// How many of a kind there are.
    pub fn count<T: Component>(&self) -> usize {
        self.ecs.query::<&T>().iter().count()
    }

    /// Removes one; whether it was there.
    pub fn remove<T: Component>(&mut self, id: ActorId) -> bool {
        let found = self
            .ecs
            .query::<(Entity, &ActorId)>()
            .with::<&T>()
            .iter()
            .find(|(_, it)| **it == id)
            .map(|(entity, _)| entity);
        found.is_some_and(|entity| self.ecs.despawn(entity).is_ok())
    }
}

/// One of a kind, to be changed.
pub(crate) fn one_mut<T: Component>(ecs: &mut hecs::World, id: ActorId) -> Option<&mut T> {
    let all = ecs.query_mut::<(&ActorId, &mut T)>();
    let found = all.into_iter().find(|(it, _)| **it == id);
    found.map(|(_, it)| it)
}

/// All of a kind, to be changed in the order in which they came.
pub(crate) fn all_mut<T: Component>(ecs: &mut hecs::World) -> Vec<(ActorId, &mut T)> {
    let all = ecs.query_mut::<(&ActorId, &mut T)>().into_iter();
    let mut all: Vec<_> = all.map(|(id, it)| (*id, it)).collect();
    all.sort_unstable_by_key(|(id, _)| *id);
    all
}

/// Goes through all of a kind, in the order in which they came, and removes those that are not to stay.
pub(crate) fn retain<T: Component>(ecs: &mut hecs::World, mut stays: impl FnMut(&mut T) -> bool) {
    let all = ecs.query_mut::<(Entity, &ActorId, &mut T)>().into_iter();
    let mut all: Vec<_> = all.map(|(entity, id, it)| (*id, entity, it)).collect();
    all.sort_unstable_by_key(|(id, ..)| *id);
    let gone = all
        .into_iter()
        .filter_map(|(_, entity, it)| (!stays(it)).then_some(entity));
    for entity in gone.collect::<Vec<_>>() {
        // It was there a moment ago.
        let _ = ecs.despawn(entity);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn those_of_a_kind_keep_their_order_and_no_number_is_given_twice() {
        let mut actors = Actors::with_player(());
        let ids: Vec<_> = ["a", "b", "c", "d"].map(|name| actors.enter(name)).into();
        assert_eq!(
            actors.enter(7u8),
            ActorId(0),
            "each kind has its own numbers"
        );
        assert!(actors.remove::<&str>(ids[1]) && !actors.remove::<&str>(ids[1]));
        let names = |actors: &Actors| actors.each::<&str>();
        assert_eq!(names(&actors), ["a", "c", "d"]);
        retain(&mut actors.ecs, |name: &mut &str| *name != "d");
        assert_eq!(actors.enter("e"), ActorId(4));
        assert_eq!(names(&actors), ["a", "c", "e"]);
        assert_eq!((actors.count::<&str>(), actors.count::<u8>()), (3, 1));
    }
}
