//! Balls that are thrown: loose bodies that the room's file knows nothing of.

use antipode_deformation::{Flyer, Space};
use glam::{DQuat, DVec3};

use super::make::ball;
use super::{Bodies, Body, Owner};
use crate::things::{Thing, ThingKind};

impl Bodies {
    /// A ball leaves the hand; of more than `most` the oldest goes.
    pub fn throw(&mut self, space: &Space, id: u64, mut from: Flyer, most: usize) {
        let over = (self.thrown().count() + 1).saturating_sub(most.max(1));
        let gone: Vec<_> = self.thrown().take(over).map(|it| it.owner).collect();
        self.take_out(|it| gone.contains(&it.owner));
        from.straighten();
        let (made, surface) = ball();
        let mut body = Body::new(
            Owner::Thrown(id),
            made,
            surface,
            (from.place.point, DQuat::IDENTITY),
        );
        body.hang(DVec3::ZERO, space);
        body.velocity = from.velocity;
        body.leaves = true;
        body.stand(from.place, space);
        self.put(body);
    }

    /// What was thrown, the oldest first.
    pub fn thrown(&self) -> impl Iterator<Item = &Body> {
        let is_thrown = |it: &&Body| matches!(it.owner, Owner::Thrown(_));
        self.all.iter().filter(is_thrown)
    }

    /// The same at a share of the way of the last step.
    pub fn thrown_between(&self, space: &Space, share: f64) -> impl Iterator<Item = Thing> {
        self.thrown().filter_map(move |body| {
            let Owner::Thrown(id) = body.owner else {
                return None;
            };
            let (place, turn) = body.between(space, share);
            Some(Thing {
                turn,
                ..Thing::new(id, ThingKind::Ball, place)
            })
        })
    }
}

#[cfg(test)]
mod tests;
