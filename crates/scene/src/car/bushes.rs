//! Bushes that cars go through: nobody bumps into one, but it slows a car a little, rustles, and loses leaves.
//!
//! The speed `v` falls with the way in bushes as `dv/dx = -v ln 2 / h`, so that it halves in every `h` metres and no bush ever
//! stops a car; in time that is `dv/dt = -v^2 ln 2 / h`.

use std::f64::consts::LN_2;

use antipode_geometry::{ChartPoint, LevelMap};
use antipode_physics::VehicleMotion;
use antipode_plants::Species;
use antipode_terrain::Cover;
use glam::{DVec2, DVec3};

use super::tuning::{BUSHES_HALVE_M, RUSTLES_EVERY_S, RUSTLES_FROM_M_S};
use super::{Car, Cars};
use crate::actors::{Actors, all_mut};
use crate::felling::{Standing, standing_near};
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::sound::SoundEvent;
use crate::tuning::STEP_S;
use crate::world::World;

/// Half of a car's length and width, metres.
const HALF_M: (f64, f64) = (1.85, 0.8);
/// Its roof over its ground, metres: what stands higher is not met.
const ROOF_M: f64 = 1.4;
/// No bush that touches a car has its root farther from the car's middle, metres.
const REACH_M: f64 = 4.0;
/// As deep in a bush as this share of its radius a car is wholly slowed by it.
const DEEP: f64 = 0.6;

/// A bush that a car is in.
struct Brush {
    /// Its middle, in the car's chart.
    middle: ChartPoint,
    /// How much of it slows the car, 0 to 1.
    share: f64,
}

/// Lets the bushes that moving cars are in act on them, and tells what is seen and heard of it.
pub(super) fn go_through(world: &World, actors: &mut Actors, outbox: &mut Outbox) {
    let driven = actors.cars.driven();
    let Cars { physics, .. } = &mut actors.cars;
    let ticks = |at_s: f64| (at_s / RUSTLES_EVERY_S).floor();
    let rustles = ticks(world.simulated_s) != ticks(world.simulated_s - STEP_S);
    for (id, car) in all_mut::<Car>(&mut actors.ecs) {
        let motion = car.vehicle.motion();
        let speed_m_s = motion.velocity.length();
        if car.vehicle.is_asleep() || speed_m_s < RUSTLES_FROM_M_S {
            continue;
        }
        let met = met_by(world, &motion);
        if met.is_empty() {
            continue;
        }
        let share = met.iter().map(|it| it.share).sum::<f64>().min(1.0);
        let lost = share * speed_m_s * LN_2 / BUSHES_HALVE_M * STEP_S;
        let tuning = physics.tuning();
        let level = LevelMap::at(&*world.strategy, motion.point());
        let at = motion.place + level.in_chart(motion.turn * tuning.mass_centre);
        let impulse = motion.velocity * (-lost * tuning.mass_kg);
        physics.push(&mut car.vehicle, at, impulse);
        if rustles {
            let velocity = motion.velocity;
            let leaves = met.iter().map(|it| it.middle);
            leaves.for_each(|at| outbox.effects.push(Effect::Rustled { at, velocity }));
            if driven == Some(id) {
                let cover = Cover::Grass;
                outbox.sounds.push(SoundEvent::Step { cover, speed_m_s });
            }
        }
    }
}

/// The bushes that a car is in.
fn met_by(world: &World, motion: &VehicleMotion) -> Vec<Brush> {
    let near = standing_near(world, motion.point(), REACH_M).into_iter();
    let level = LevelMap::at(&*world.strategy, motion.point());
    let bushes = near.filter(|(it, _)| it.species == Species::Bush);
    let bushes = bushes.filter(|(it, _)| !world.felled.has(it.coord, it.thing.slot));
    bushes
        .filter_map(|(it, root)| in_bush(motion, level, &it, root))
        .collect()
}

fn in_bush(
    motion: &VehicleMotion,
    level: LevelMap,
    it: &Standing,
    root: ChartPoint,
) -> Option<Brush> {
    let (radius_m, height_m) = it.crown_m();
    let from = motion.turn.inverse() * level.in_space(root.pos - motion.place);
    let beside = DVec2::new(from.x.abs() - HALF_M.0, from.z.abs() - HALF_M.1);
    let share = (radius_m - beside.max(DVec2::ZERO).length()) / (DEEP * radius_m);
    let is_met = share > 0.0 && (-height_m..ROOF_M).contains(&from.y);
    is_met.then(|| Brush {
        middle: root.moved(DVec3::Y * (0.5 * height_m)),
        share: share.min(1.0),
    })
}
