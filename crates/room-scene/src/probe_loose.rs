//! The state of what is loose in a room.

use antipode_deformation::Place;
use glam::{DQuat, DVec3};

use crate::bodies::Owner;
use crate::scene::RoomScene;

/// Something loose.
#[derive(Clone, Debug, PartialEq)]
pub struct LooseState {
    /// The name of its object; `ball` of one that was thrown.
    pub name: String,
    /// Where its centre of mass is.
    pub place: Place,
    /// The same, metres of the scene.
    pub point: DVec3,
    /// How it is turned, as it feels, in the axes of the scene.
    pub turn: DQuat,
    /// Felt velocity, metres of its own size per second.
    pub velocity: DVec3,
    /// Angular velocity, radians per second.
    pub spin: DVec3,
    /// From its centre of mass to its farthest corner, metres of its own size.
    pub reach_m: f64,
    /// Its mass at its own size, kilograms.
    pub own_kg: f64,
    /// Its energy of motion, turning and height for each of these, by its own metres, J.
    pub energy_j_kg: f64,
    /// Whether it lies still.
    pub rests: bool,
    /// Whether it stands astride a portal, or a door of an aberration.
    pub astride: bool,
}

impl RoomScene {
    /// Strikes something loose so that its felt velocity, metres of its own size per second, changes by so much. Whether there is
    /// something of that name.
    pub fn strike(&mut self, name: &str, by: DVec3) -> bool {
        let Some((object, _)) = self.room().find(name) else {
            return false;
        };
        if let Some(body) = self.bodies.of(Owner::Object(object)) {
            body.strike(body.place.point, by);
            return true;
        }
        false
    }

    /// All that is loose: objects of the room in their order, then balls that were thrown.
    pub fn loose_states(&self) -> Vec<LooseState> {
        let state = |it: &crate::bodies::Body| LooseState {
            name: self.name_of(it.owner),
            place: it.place,
            point: it.place.point,
            turn: it.turn,
            velocity: it.velocity,
            spin: it.spin,
            reach_m: it.reach_m,
            own_kg: it.mass_kg() / it.place.scale.powi(3),
            energy_j_kg: it.energy(self.room().gravity),
            rests: it.rests,
            astride: it.is_astride(&self.space),
        };
        self.bodies.loose().map(state).collect()
    }
}
