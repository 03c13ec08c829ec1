//! Shapes that are made already: of what looks alike one is made, and none again after something else of its room has changed.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::mem::{Discriminant, discriminant, take};
use std::sync::Arc;

use super::{Roundness, Shape, shape};
use crate::room::What;

/// What a shape is made of: its kind, and the bits of its numbers.
type Key = (Discriminant<What>, [u64; 5]);

/// Shapes by what they are made of.
#[derive(Debug, Clone, Default)]
pub struct Shapes {
    known: HashMap<Key, Arc<Shape>>,
    /// Those that this round has asked for.
    used: HashMap<Key, Arc<Shape>>,
    made: usize,
}

impl Shapes {
    /// The shape of something that is no model and no aberration; none of what cannot be touched.
    pub fn of(&mut self, what: &What, roundness: Roundness) -> Option<Arc<Shape>> {
        let key = key(what)?;
        let place = match self.used.entry(key) {
            Entry::Occupied(it) => return Some(it.get().clone()),
            Entry::Vacant(place) => place,
        };
        let made = if let Some(shape) = self.known.remove(&key) {
            shape
        } else {
            self.made += 1;
            Arc::new(shape(what, roundness)?)
        };
        Some(place.insert(made).clone())
    }

    /// Ends a round over all of a room: what it has not asked for is forgotten.
    pub fn end_round(&mut self) {
        self.known = take(&mut self.used);
    }

    /// How many were made so far.
    pub fn made(&self) -> usize {
        self.made
    }
}

/// None of what has no shape that can be shared.
fn key(what: &What) -> Option<Key> {
    let numbers = match what {
        What::Box { size } | What::Pyramid { size } | What::Ramp { size } => {
            [size.x, size.y, size.z, 0.0, 0.0]
        }
        What::Stairs { size, steps } => [size.x, size.y, size.z, f64::from(*steps), 0.0],
        What::Arch { size, opening } => [size.x, size.y, size.z, opening.x, opening.y],
        What::Cylinder { radius, height } => [*radius, *height, 0.0, 0.0, 0.0],
        What::Ball { radius } => [*radius, 0.0, 0.0, 0.0, 0.0],
        What::Sign { size, .. } => [size.x, size.y, 0.0, 0.0, 0.0],
        What::Aberration(_)
        | What::Model { .. }
        | What::Light { .. }
        | What::Portal(_)
        | What::Group => return None,
    };
    Some((discriminant(what), numbers.map(f64::to_bits)))
}
