//! What of the scene is shown as figures: everyone, what they hold, and things that lie, stand or fly.

use antipode_geometry::Eye;
use glam::{DQuat, DVec3};
use hecs::Entity;

use crate::frame::{Figure, ModelId};
use crate::npc::mind::Mind;
use crate::player::{Appearance, Look, Position};
use crate::scene::Scene;
use crate::tuning::FIGURE_SEEN_FROM_M;

impl Scene {
    /// Everyone but who looks: in first person one does not see oneself, nor from inside one's own suit.
    pub(crate) fn figures_seen_by(&self, eye: &Eye, sees_player: bool) -> Vec<Figure> {
        let eye = eye.point;
        let inside_own = eye.hemisphere == self.feet().hemisphere
            && eye.pos.distance(self.head().point.pos) < FIGURE_SEEN_FROM_M;
        let mut seen = Vec::new();
        for (entity, position, look, appearance, mind) in
            &mut self
                .ecs
                .query::<(Entity, &Position, &Look, &Appearance, Option<&Mind>)>()
        {
            if entity == self.player && (!sees_player || inside_own) {
                continue;
            }
            let mut figure = Figure {
                posture: appearance.motion.posture(),
                held: appearance.held,
                ..Figure::standing(appearance.model, position.0, look.yaw)
            };
            if entity == self.player {
                self.use_in_hand(&mut figure);
                self.seat_figure(&mut figure);
            }
            if let Some(mind) = mind {
                mind.show_shot(&mut figure);
                figure.hostile = figure.held.is_some();
            }
            seen.push(figure);
        }
        self.show_things(&mut seen);
        self.show_cars(&mut seen);
        seen
    }

    /// Lamps, bullets, and what lies about.
    fn show_things(&self, seen: &mut Vec<Figure>) {
        let lamps = self.lamps.iter();
        seen.extend(lamps.map(|lamp| Figure::standing(ModelId::Lamp, lamp.point, 0.0)));
        seen.extend(self.projectiles().iter().map(|bullet| {
            let way = bullet.velocity.normalize_or(DVec3::X);
            Figure {
                turn: DQuat::from_rotation_arc(DVec3::X, way),
                ..Figure::standing(ModelId::Bullet, bullet.point, 0.0)
            }
        }));
        seen.extend(self.drops.iter().map(|drop| self.show_drop(drop)));
    }
}
