//! The land that caves are laid out below.

use std::ops::Deref;

use glam::DVec3;

use crate::field::Field;
use crate::tracts::{Met, Tract};

/// A field, and in worlds in tiles the tile in whose patch places are told.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lay<'a> {
    field: &'a Field,
    tract: Option<&'a Tract>,
}

impl<'a> Lay<'a> {
    /// Places are those of the space of the noise.
    pub(super) fn of_world(field: &'a Field) -> Self {
        Self { field, tract: None }
    }

    /// Places are those of a tile's patch there.
    pub(super) fn of_tile(field: &'a Field, tract: &'a Tract) -> Self {
        Self {
            field,
            tract: Some(tract),
        }
    }

    /// [`Field::land_height`] over a place on the ground.
    pub(super) fn land_height(&self, ground: DVec3) -> f64 {
        match (self.tract, self.field.tracts()) {
            (Some(tract), Some(tracts)) => {
                let space = &**self.field.strategy();
                let spot = tracts.spot_in(space, tract, tract.taken(ground), &mut Met::default());
                self.field.land_height_over(&spot)
            }
            _ => self.field.land_height(ground),
        }
    }
}

impl Deref for Lay<'_> {
    type Target = Field;

    fn deref(&self) -> &Field {
        self.field
    }
}
