//! The figure of who walks: how it is held, and where and how large it is in the scene.

use antipode_deformation::{Place, Traveller};
use antipode_frame::Posture;
use antipode_frame::motion::Doing;
use glam::{Affine3A, DAffine3, DMat3, DVec2, DVec3};

use crate::camera::Camera;
use crate::scene::RoomScene;
use crate::tuning::{RADIUS_M, STEP_S};
use crate::walk::Look;

/// The figure of who walks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoomFigure {
    /// How it is held.
    pub posture: Posture,
    /// From its own axes (x ahead, y up, z to the right; metres from between its feet) to the scene. It keeps its felt size, so
    /// that it is squeezed by the aberrations that it is in.
    pub pose: Affine3A,
    /// What it is called where it is seen: the number after those of the room's objects.
    pub object: u32,
    /// Whether the eye is in its head, or too near to see it as a whole.
    pub unseen_by_eye: bool,
}

impl RoomScene {
    /// The figure of who has the middle there and looks so, as that camera sees it.
    pub(crate) fn figure_of(&self, middle: &Place, look: &Look, camera: &Camera) -> RoomFigure {
        let (ahead, right) = look.level(self.up());
        let turn = DMat3::from_cols(ahead, self.up(), right);
        let feet = self.above(middle, -RADIUS_M).point;
        RoomFigure {
            posture: self.motion.posture(),
            pose: self.felt_pose(middle, feet, turn),
            object: self.figure_number(),
            unseen_by_eye: !camera.sees_who_walks(),
        }
    }

    /// What the figure of who walks is called where it is seen.
    pub(crate) fn figure_number(&self) -> u32 {
        self.room().objects.len() as u32
    }

    /// From the felt axes of what is at a place to the scene, its origin at a point there. `felt` takes its own axes to felt
    /// ones.
    pub fn felt_pose(&self, place: &Place, origin: DVec3, felt: DMat3) -> Affine3A {
        let heading = self.walker.body.velocity;
        let k = self.space.squeeze(&place.stack, heading, &Traveller::Body);
        let pose = DAffine3 {
            matrix3: k * felt,
            translation: origin,
        };
        pose.as_affine3a()
    }

    /// Lets a step pass for how the figure is held; `falls_m_s` is how fast it fell before.
    pub(crate) fn hold_figure(&mut self, falls_m_s: f64) {
        let up = self.up();
        let (ahead, right) = self.look.level(up);
        let velocity = self.walker.body.velocity;
        let grounded = self.walker.grounded;
        let doing = Doing {
            way: DVec2::new(velocity.dot(ahead), velocity.dot(right)),
            rise_m_s: velocity.dot(up),
            grounded,
            impact_m_s: if grounded { falls_m_s.max(0.0) } else { 0.0 },
            pitch_rad: self.look.pitch_rad,
            ..Doing::default()
        };
        self.motion.pass(&doing, STEP_S);
    }
}
