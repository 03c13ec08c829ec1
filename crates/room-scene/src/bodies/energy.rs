//! Nothing is gained by blows: bodies that may have met in a part of a step have no more energy after it than before.
//!
//! Rapier pushes apart what reaches into each other, and bodies that a portal brings together may. What a group has gained so is
//! taken from its speeds, from all by the same share. By its own metres and kilograms a body has e J for each kilogram
//! (`Body::energy`); of who is s times as large mass is s^3 and speed s times as large, so that a group has the sum of m s^5 e.

use std::collections::BTreeSet;

use glam::DVec3;

use super::{Bodies, Body, Owner};

/// Of a body before a part of a step: its share of a group's energy, J, and how many portals it had passed.
pub type Had = (f64, u32);

impl Bodies {
    /// What all have now.
    pub(super) fn have(&self, g: DVec3) -> Vec<Had> {
        let of = |it: &Body| (it.weight() * it.energy(g), it.place.passage.count);
        self.all.iter().map(of).collect()
    }

    /// Takes from all groups what they have gained since, but from those to which somebody gave it, and where a portal was passed.
    pub(super) fn spend(&mut self, had: &[Had], meetings: &BTreeSet<(usize, usize)>, g: DVec3) {
        for group in groups(self.all.len(), meetings) {
            let is_given = |it: &usize| {
                let body = &self.all[*it];
                let is_moved = body.owner == Owner::Walker || body.held || body.load.is_some();
                is_moved || body.place.passage.count != had[*it].1
            };
            if group.iter().any(is_given) {
                continue;
            }
            let sum = |of: &dyn Fn(usize) -> f64| group.iter().map(|it| of(*it)).sum::<f64>();
            let has = sum(&|it| self.all[it].weight() * self.all[it].energy(g));
            let gained = has - sum(&|it| had[it].0);
            let moves = sum(&|it| self.all[it].weight() * self.all[it].velocity.length_squared());
            if gained > 0.0 && moves > 0.0 {
                let share = (1.0 - 2.0 * gained / moves).max(0.0).sqrt();
                for it in &group {
                    self.all[*it].velocity *= share;
                }
            }
        }
    }
}

impl Body {
    /// What its energy by its own size is to be multiplied by, kilograms.
    fn weight(&self) -> f64 {
        self.made.mass_kg * self.place.scale.powi(5)
    }
}

/// Which are together, by pairs that are; each in one group.
fn groups(count: usize, pairs: &BTreeSet<(usize, usize)>) -> Vec<Vec<usize>> {
    let mut first: Vec<usize> = (0..count).collect();
    for (a, b) in pairs {
        let (a, b) = (first[*a], first[*b]);
        if a != b {
            let (least, other) = (a.min(b), a.max(b));
            first
                .iter_mut()
                .filter(|it| **it == other)
                .for_each(|it| *it = least);
        }
    }
    let mut groups = vec![Vec::new(); count];
    for (number, first) in first.into_iter().enumerate() {
        groups[first].push(number);
    }
    groups.retain(|it| !it.is_empty());
    groups
}
