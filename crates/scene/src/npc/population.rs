//! Figures come out of sight around the player and go when they are far and out of sight.

use antipode_geometry::{ChartPoint, ChunkCoord};
use glam::DVec3;

use super::bearing::{ahead, apart_m, toward};
use super::dice::Dice;
use super::tuning::{
    APPEARS_M, GOES_M, HOSTILE_EVERY_S, MOST_HOSTILE, MOST_LIVING, PEACE_S, UNSEEN_RAD,
};
use crate::scene::Scene;
use crate::tuning::BODIES_WITHIN_CHUNKS;

/// Steps between two looks at who is there.
const EVERY_STEPS: u64 = 60;
/// Places that are tried each time.
const TRIES: u32 = 4;
/// Gap left below the feet of who comes, in metres.
const CLEARANCE_M: f64 = 0.15;
/// How much nearer than the border of where bodies move someone comes, in metres.
const LOADED_SLACK_M: f64 = 12.0;

impl Scene {
    /// Every second those who are far and not seen go, and one more comes if there are too few.
    pub(super) fn come_and_go(&mut self, steps: u64) {
        if !steps.is_multiple_of(EVERY_STEPS) {
            return;
        }
        let others = self.others();
        let feet = self.feet();
        let leaves = |point: ChartPoint| {
            apart_m(&*self.world.strategy, feet, point) > GOES_M && !self.may_see(point)
        };
        let (gone, left): (Vec<_>, Vec<_>) = others
            .into_iter()
            .partition(|other| other.native && leaves(other.point));
        for other in gone {
            // It was there a moment ago.
            let _ = self.actors.ecs.despawn(other.entity);
            self.kept.changed = true;
        }
        let closed = self.world.strategy.rim_m().is_some();
        let most = if closed { MOST_LIVING.1 } else { MOST_LIVING.0 };
        if left.len() >= most {
            return;
        }
        let hostile = left.iter().filter(|other| other.fights).count();
        let peaceful = if self.world.simulated_s < PEACE_S {
            most / 2
        } else {
            // The hostile ones' places are kept for them.
            most - MOST_HOSTILE
        };
        if left.len() - hostile < peaceful {
            self.let_one_come(feet, false);
        } else if hostile < MOST_HOSTILE
            && self.world.simulated_s >= self.player.peace_until_s
            && self.let_one_come(feet, true)
        {
            self.player.peace_until_s = self.world.simulated_s + HOSTILE_EVERY_S;
        }
    }

    /// Those who fight are gone when the player stands up again, however they came, and others wait.
    pub(crate) fn send_hostile_away(&mut self) {
        let others = self.others();
        for other in others.iter().filter(|other| other.fights) {
            // It was there a moment ago.
            let _ = self.actors.ecs.despawn(other.entity);
            self.kept.changed = true;
        }
        let rest_s = self.world.simulated_s + HOSTILE_EVERY_S;
        self.player.peace_until_s = self.player.peace_until_s.max(rest_s);
    }

    /// Tells whether one came.
    fn let_one_come(&mut self, feet: ChartPoint, hostile: bool) -> bool {
        let seeds = [
            self.world.setup.seed,
            self.world.simulated_s.to_bits(),
            0x9e3d,
        ];
        let mut dice = Dice::new(&seeds);
        let loaded_m = f64::from(BODIES_WITHIN_CHUNKS) * 32.0 - LOADED_SLACK_M;
        let far_m = APPEARS_M.1.min(loaded_m.max(LOADED_SLACK_M));
        let near_m = APPEARS_M.0 * far_m / APPEARS_M.1;
        for _ in 0..TRIES {
            let heading = toward(dice.heading());
            let away_m = dice.between((near_m, far_m));
            let mut point = ahead(&*self.world.strategy, feet, heading, away_m);
            point.pos.y = self.world.ground.untouched_height(point) + CLEARANCE_M;
            let there = self.world.lets_move(ChunkCoord::containing(point));
            if there && !self.may_see(point) {
                let id = self.spawn_bot(point, dice.heading(), hostile);
                self.restore_mind(id, 0.0, true);
                return true;
            }
        }
        false
    }

    /// Whether a place may be in the picture, whatever is before it.
    fn may_see(&self, point: ChartPoint) -> bool {
        let optics = self.aiming();
        let eye = self.camera_through(&optics).eye;
        let view = optics
            .strategy
            .view_point(&eye, point.moved(DVec3::Y))
            .truncate()
            .normalize_or_zero();
        -view.z > UNSEEN_RAD.cos()
    }
}
