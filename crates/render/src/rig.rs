//! A model's skeleton: from how a body is held to where its joints are, what it reaches to, and where its hand is.

use antipode_frame::{Clip, Posture};
use antipode_models::{GAME_FROM_FILE, Mask, Model, Pose, Skeleton, Skin};
use glam::{Mat4, Quat, Vec3};

use crate::error::RenderError;

mod reach;

pub use reach::Reach;

/// Joints of a skin at most; `JOINTS` of figure.wgsl.
pub const JOINTS: usize = 21;

/// A joint's rows: a place with a fourth coordinate of one comes out by its products with them.
pub type JointRows = [[f32; 4]; 3];

/// How much of the hold each part of the body takes; what hangs from a part takes the same unless it is named itself.
/// The trunk keeps most of the gait, and the left arm swings.
const HOLD_SHARES: [(&str, f32); 4] = [
    ("spine", 0.6),
    ("head", 0.0),
    ("shoulder.L", 0.3),
    ("shoulder.R", 1.0),
];
/// The chest turns no farther from the legs than this, radians.
const MOST_TWIST_RAD: f32 = 1.1;
/// Shares of a look up or down that the head, the chest and an arm that holds something take.
const HEAD_LOOKS: f32 = 0.6;
const CHEST_LOOKS: f32 = 0.2;
const ARM_LOOKS: f32 = 0.7;
/// By how much the arm is raised before a stroke, how far it comes down from there, and how far a shot throws it up,
/// radians.
const RAISED_RAD: f32 = 1.1;
const STROKE_RAD: f32 = 1.5;
const KICK_RAD: f32 = 0.3;

/// A skeleton with what is asked of it.
#[derive(Clone, Debug)]
pub struct Rig {
    skeleton: Skeleton,
    skin: Skin,
    /// For each of [`Clip::ALL`].
    clips: Vec<antipode_models::Clip>,
    hold_mask: Mask,
    hit_mask: Mask,
    /// Joints by their use.
    hips: usize,
    spine: usize,
    chest: usize,
    head: usize,
    arm: usize,
    hand: usize,
    /// For each joint of the skin, the box of what hangs from it in its own axes.
    boxes: Vec<[Vec3; 2]>,
}

/// A body in a posture, in the game's axes and from the figure's origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Posed {
    /// For each joint of the skin, from the bind pose to where it is.
    pub joints: Vec<JointRows>,
    /// Lowest and highest corner of a box that holds the whole body, metres.
    pub limits: [Vec3; 2],
    /// The right hand.
    pub hand: HandPose,
}

/// A hand in the axes of its figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandPose {
    /// How it is turned.
    pub turn: Quat,
    /// Where what it holds has its origin, metres.
    pub place: Vec3,
}

impl Rig {
    /// Takes a model's skeleton.
    ///
    /// # Errors
    /// When a joint or clip is missing, or there are too many joints.
    pub fn new(model: &Model) -> Result<Self, RenderError> {
        let missing = |what: &str| RenderError::Model(format!("the skeleton has no {what}"));
        let skeleton = &model.skeleton;
        let joint = |name: &str| skeleton.find(name).ok_or_else(|| missing(name));
        let clip = |clip: Clip| model.clip(clip.name()).cloned();
        let clips = Clip::ALL
            .into_iter()
            .map(|it| clip(it).ok_or_else(|| missing(it.name())))
            .collect::<Result<_, _>>()?;
        let skin = model.skins.first().ok_or_else(|| missing("skin"))?;
        if skin.joints.len() > JOINTS {
            return Err(RenderError::Model(format!("over {JOINTS} joints")));
        }
        Ok(Self {
            hold_mask: hold_mask(skeleton),
            hit_mask: Mask::below(skeleton, joint("spine")?),
            hips: joint("hips")?,
            spine: joint("spine")?,
            chest: joint("chest")?,
            head: joint("head")?,
            arm: joint("upper_arm.R")?,
            hand: joint("hold.R")?,
            boxes: boxes(model, skin),
            skeleton: skeleton.clone(),
            skin: skin.clone(),
            clips,
        })
    }

    /// Where a body in that posture is.
    pub fn pose(&self, posture: &Posture) -> Posed {
        let pose = self.mixed(posture);
        let matrices = pose.model_matrices(&self.skeleton);
        let turn = Mat4::from_quat(GAME_FROM_FILE);
        let game = |m: Mat4| turn * m * turn.transpose();
        let rows = |m: &Mat4| {
            let m = game(*m).transpose();
            [m.x_axis, m.y_axis, m.z_axis].map(|row| row.to_array())
        };
        let (_, turn, place) = game(matrices[self.hand]).to_scale_rotation_translation();
        Posed {
            joints: self.skin.matrices(&matrices).iter().map(rows).collect(),
            limits: self.limits(&matrices),
            hand: HandPose { turn, place },
        }
    }

    /// The pose of all clips together, and what is turned besides.
    fn mixed(&self, posture: &Posture) -> Pose {
        let at = |clip: Clip| {
            let own = &self.clips[clip as usize];
            let moment = posture.moment(clip);
            let time_s = match clip {
                Clip::Walk | Clip::Run => moment * own.seconds,
                Clip::Land => 0.0,
                _ => moment,
            };
            own.pose(&self.skeleton, time_s)
        };
        let shown = |clip: &Clip| posture.share(*clip) > 0.0;
        let poses: Vec<(Pose, f32)> = Clip::WHOLE
            .into_iter()
            .filter(shown)
            .map(|clip| (at(clip), posture.share(clip)))
            .collect();
        let weighed: Vec<(&Pose, f32)> = poses.iter().map(|(pose, share)| (pose, *share)).collect();
        let mut pose = Pose::mix(&weighed).unwrap_or_else(|| at(Clip::Idle));
        for (clip, mask) in [(Clip::Hold, &self.hold_mask), (Clip::Hit, &self.hit_mask)] {
            if shown(&clip) {
                pose.layer(&at(clip), mask, posture.share(clip));
            }
        }
        self.turn(&mut pose, posture);
        pose
    }

    /// Turns the legs to where they go and the rest back to where the figure faces, looks up or down, and uses the arm.
    fn turn(&self, pose: &mut Pose, posture: &Posture) {
        let lies = posture.share(Clip::Die).min(1.0);
        let upright = 1.0 - lies;
        let twist = posture.twist_rad * upright;
        let back = twist.clamp(-MOST_TWIST_RAD, MOST_TWIST_RAD);
        // About the body's right, so that what is ahead comes up.
        let up = |angle: f32| Quat::from_axis_angle(Vec3::NEG_X, angle);
        let locals = &mut pose.locals;
        let hips = Quat::from_rotation_y(-twist) * locals[self.hips].rotation;
        locals[self.hips].rotation = hips;
        let untwist = hips.inverse() * Quat::from_rotation_y(back) * hips;
        locals[self.spine].rotation = untwist * locals[self.spine].rotation;
        let rest = Quat::from_rotation_y(twist - back);
        let look = posture.pitch_rad * upright;
        locals[self.head].rotation = rest * up(HEAD_LOOKS * look) * locals[self.head].rotation;
        locals[self.chest].rotation = up(CHEST_LOOKS * look) * locals[self.chest].rotation;
        let mut raise = KICK_RAD * posture.kick;
        if posture.swing >= 0.0 {
            raise += RAISED_RAD - STROKE_RAD * posture.swing;
        }
        raise += ARM_LOOKS * look;
        let holds = posture.share(Clip::Hold) * upright;
        locals[self.arm].rotation = up(raise * holds) * locals[self.arm].rotation;
    }

    /// Each vertex is a mean of where its joints carry it, so it is within the box of their boxes.
    fn limits(&self, matrices: &[Mat4]) -> [Vec3; 2] {
        let mut limits = [Vec3::MAX, Vec3::MIN];
        for (&joint, [low, high]) in self.skin.joints.iter().zip(&self.boxes) {
            for corner in 0..8 {
                let pick = |axis: usize| {
                    if corner >> axis & 1 == 1 {
                        high[axis]
                    } else {
                        low[axis]
                    }
                };
                let place = Vec3::from_array([0, 1, 2].map(pick));
                let at = GAME_FROM_FILE * matrices[joint].transform_point3(place);
                limits = [limits[0].min(at), limits[1].max(at)];
            }
        }
        limits
    }
}

/// How much of the hold each joint takes: as much as the nearest above it that is named.
fn hold_mask(skeleton: &Skeleton) -> Mask {
    let mut shares: Vec<f32> = Vec::with_capacity(skeleton.joints.len());
    for joint in &skeleton.joints {
        let named = HOLD_SHARES.iter().find(|(name, _)| *name == joint.name);
        let above = joint.parent.and_then(|parent| shares.get(parent).copied());
        shares.push(named.map_or(above.unwrap_or(0.0), |(_, share)| *share));
    }
    Mask { shares }
}

fn boxes(model: &Model, skin: &Skin) -> Vec<[Vec3; 2]> {
    let mut boxes = vec![[Vec3::MAX, Vec3::MIN]; skin.joints.len()];
    let vertices = model
        .parts
        .iter()
        .flat_map(|part| &model.meshes[part.mesh].primitives)
        .flat_map(|primitive| &primitive.vertices);
    for vertex in vertices {
        for (&joint, weight) in vertex.joints.iter().zip(vertex.weights) {
            let joint = usize::from(joint);
            if weight > 0.0 {
                let at = skin.inverse_bind[joint].transform_point3(vertex.position);
                let [low, high] = &mut boxes[joint];
                (*low, *high) = (low.min(at), high.max(at));
            }
        }
    }
    // A joint that carries nothing is a point.
    boxes
        .into_iter()
        .map(|[low, high]| {
            if low.x > high.x {
                [Vec3::ZERO; 2]
            } else {
                [low, high]
            }
        })
        .collect()
}

#[cfg(test)]
mod tests;
