//! Bounds how far a body reaches in any posture, before it is posed.

use antipode_models::{Channel, Skeleton};
use glam::Vec3;

use super::Rig;

/// The farthest that anything gets from a figure's origin, metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reach {
    /// Of the body.
    pub body_m: f32,
    /// Of its hand.
    pub hand_m: f32,
}

/// A joint's place as a bound: what is x from the joint is at most `offset_m + scale * x` from the model's origin.
#[derive(Clone, Copy, Debug)]
struct Chain {
    offset_m: f32,
    scale: f32,
}

impl Rig {
    /// A joint takes x to t + R S x, and R keeps lengths, so that |t + R S x| <= |t| + |S| |x|, whatever is turned.
    /// Mixtures of clips have the means of their t and S, which are no longer than the longest.
    pub fn reach(&self) -> Reach {
        let chains = self.chains(&self.skeleton);
        let joints = self.skin.joints.iter().zip(&self.boxes);
        let body = joints.map(|(&joint, [low, high])| {
            let Chain { offset_m, scale } = chains[joint];
            offset_m + scale * low.abs().max(high.abs()).length()
        });
        Reach {
            body_m: body.fold(0.0, f32::max),
            hand_m: chains[self.hand].offset_m,
        }
    }

    fn chains(&self, skeleton: &Skeleton) -> Vec<Chain> {
        let rest = skeleton.joints.iter().map(|joint| Chain {
            offset_m: joint.rest.translation.length(),
            scale: joint.rest.scale.abs().max_element(),
        });
        let mut chains: Vec<Chain> = rest.collect();
        for channel in self.clips.iter().flat_map(|clip| &clip.channels) {
            let own = &mut chains[channel.joint()];
            match channel {
                Channel::Translation(_, curve) => {
                    let lengths = curve.hull().into_iter().map(Vec3::length);
                    own.offset_m = lengths.fold(own.offset_m, f32::max);
                }
                Channel::Scale(_, curve) => {
                    let sizes = curve.hull().into_iter().map(|by| by.abs().max_element());
                    own.scale = sizes.fold(own.scale, f32::max);
                }
                Channel::Rotation(..) => {}
            }
        }
        // Parents come before children.
        for (number, joint) in skeleton.joints.iter().enumerate() {
            if let Some(above) = joint.parent.map(|parent| chains[parent]) {
                let own = &mut chains[number];
                own.offset_m = above.offset_m + above.scale * own.offset_m;
                own.scale *= above.scale;
            }
        }
        chains
    }
}
