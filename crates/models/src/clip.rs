//! Clips: how nodes move over time.

use glam::{Quat, Vec3};
use gltf::json;
use gltf::json::animation::{Animation, Interpolation as JsonInterpolation, Property};

use crate::accessor::{Source, valid};
use crate::curve::{Curve, Interpolation};
use crate::error::Error;
use crate::pose::Pose;
use crate::primitive::FARTHEST_M;
use crate::skeleton::{Nodes, Skeleton};

/// No model has more keys than this in all its clips.
const MOST_KEYS: usize = 1 << 20;
/// No clip is longer than this, seconds.
const LONGEST_S: f32 = 3600.0;

/// One movement of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// Its name in the file.
    pub name: String,
    /// When its last key is, seconds.
    pub seconds: f32,
    /// Whether it goes round: its end is its beginning. From the file's extras; false where they do not say.
    pub loops: bool,
    /// Speed ahead in m/s at which feet that touch the ground stand still. From the extras; 0 without.
    pub ground_speed_m_s: f32,
    /// What moves.
    pub channels: Vec<Channel>,
}

/// What moves one property of one node.
#[derive(Clone, Debug, PartialEq)]
pub enum Channel {
    /// A node's place, metres.
    Translation(usize, Curve<Vec3>),
    /// A node's turn.
    Rotation(usize, Curve<Quat>),
    /// A node's size.
    Scale(usize, Curve<Vec3>),
}

impl Channel {
    /// The node that moves.
    pub fn joint(&self) -> usize {
        match self {
            Self::Translation(joint, _) | Self::Rotation(joint, _) | Self::Scale(joint, _) => {
                *joint
            }
        }
    }
}

impl Clip {
    /// The time within the clip that `time_s` seconds since its start fall on: round and round, or held at the ends.
    pub fn moment(&self, time_s: f32) -> f32 {
        if !time_s.is_finite() || self.seconds <= 0.0 {
            0.0
        } else if self.loops {
            time_s.rem_euclid(self.seconds)
        } else {
            time_s.clamp(0.0, self.seconds)
        }
    }

    /// The whole pose `time_s` seconds after the start; nodes the clip does not move rest.
    pub fn pose(&self, skeleton: &Skeleton, time_s: f32) -> Pose {
        let mut pose = Pose::rest(skeleton);
        self.apply(&mut pose, time_s);
        pose
    }

    /// Overwrites in `pose` what the clip moves.
    pub fn apply(&self, pose: &mut Pose, time_s: f32) {
        let moment = self.moment(time_s);
        for channel in &self.channels {
            let Some(local) = pose.locals.get_mut(channel.joint()) else {
                continue;
            };
            match channel {
                Channel::Translation(_, curve) => {
                    local.translation = curve.at(moment).unwrap_or(local.translation);
                }
                Channel::Rotation(_, curve) => {
                    local.rotation = curve.at(moment).unwrap_or(local.rotation);
                }
                Channel::Scale(_, curve) => local.scale = curve.at(moment).unwrap_or(local.scale),
            }
        }
    }
}

impl Source<'_> {
    /// All clips.
    pub fn clips(self, nodes: &Nodes) -> Result<Vec<Clip>, Error> {
        let mut budget = MOST_KEYS;
        self.root
            .animations
            .iter()
            .enumerate()
            .map(|(i, clip)| self.clip(i, clip, nodes, &mut budget))
            .collect()
    }

    fn clip(
        self,
        i: usize,
        json: &Animation,
        nodes: &Nodes,
        budget: &mut usize,
    ) -> Result<Clip, Error> {
        let name = json.name.clone().unwrap_or_else(|| format!("clip {i}"));
        let mut clip = Clip {
            name,
            seconds: 0.0,
            loops: false,
            ground_speed_m_s: 0.0,
            channels: Vec::new(),
        };
        read_extras(json, &mut clip);
        for channel in &json.channels {
            let sampler = json
                .samplers
                .get(channel.sampler.value())
                .ok_or(Error::OutOfRange("samplers"))?;
            let node = nodes
                .joint_of
                .get(channel.target.node.value())
                .ok_or(Error::OutOfRange("nodes"))?;
            let times = self.times(sampler, &clip.name)?;
            clip.seconds = times.last().copied().unwrap_or(0.0).max(clip.seconds);
            *budget = budget
                .checked_sub(times.len())
                .ok_or(Error::TooMany("keys"))?;
            let interpolation = match valid(sampler.interpolation, "clips")? {
                JsonInterpolation::Linear => Interpolation::Linear,
                JsonInterpolation::Step => Interpolation::Step,
                JsonInterpolation::CubicSpline => Interpolation::CubicSpline,
            };
            let path = valid(channel.target.path, "clips")?;
            // A node outside the scene is not shown, whatever it does.
            let Some(joint) = *node else { continue };
            let vector = || self.vectors(sampler.output, times.clone(), interpolation);
            clip.channels.push(match path {
                Property::Translation => Channel::Translation(joint, vector()?),
                Property::Scale => Channel::Scale(joint, vector()?),
                Property::Rotation => {
                    Channel::Rotation(joint, self.turns(sampler.output, times, interpolation)?)
                }
                Property::MorphTargetWeights => return Err(Error::MorphTargets(clip.name)),
            });
        }
        Ok(clip)
    }

    fn times(self, sampler: &json::animation::Sampler, name: &str) -> Result<Vec<f32>, Error> {
        let times: Vec<f32> = self
            .floats::<1>(sampler.input, "key times")?
            .into_iter()
            .map(|[t]| t)
            .collect();
        let grow = times.windows(2).all(|pair| pair[0] < pair[1]);
        let first = times.first().is_some_and(|t| *t >= 0.0);
        if !grow || !first || times.last().is_some_and(|t| *t > LONGEST_S) {
            return Err(Error::KeyTimes(name.to_owned()));
        }
        Ok(times)
    }

    fn vectors(
        self,
        output: json::Index<json::Accessor>,
        times: Vec<f32>,
        interpolation: Interpolation,
    ) -> Result<Curve<Vec3>, Error> {
        let values: Vec<Vec3> = self
            .floats::<3>(output, "keys")?
            .into_iter()
            .map(Vec3::from)
            .collect();
        if values.iter().any(|v| v.abs().max_element() > FARTHEST_M) {
            return Err(Error::Absurd("keys"));
        }
        curve(times, values, interpolation)
    }

    fn turns(
        self,
        output: json::Index<json::Accessor>,
        times: Vec<f32>,
        interpolation: Interpolation,
    ) -> Result<Curve<Quat>, Error> {
        let mut values: Vec<Quat> = self
            .floats::<4>(output, "keys")?
            .into_iter()
            .map(Quat::from_array)
            .collect();
        let spline = interpolation == Interpolation::CubicSpline;
        for (k, value) in values.iter_mut().enumerate() {
            let size = value.length();
            if spline && k % 3 != 1 {
                if size > FARTHEST_M {
                    return Err(Error::Absurd("keys"));
                }
            } else if !(0.5..2.0).contains(&size) {
                return Err(Error::Absurd("keys"));
            } else {
                *value = value.normalize();
            }
        }
        curve(times, values, interpolation)
    }
}

/// Whether a clip goes round, and the speed over the ground that it is made for: nothing of glTF itself has room for
/// these.
fn read_extras(json: &Animation, clip: &mut Clip) {
    let extras: Option<json::Value> = json
        .extras
        .as_ref()
        .and_then(|text| json::deserialize::from_str(text.get()).ok());
    let Some(extras) = extras else { return };
    clip.loops = extras
        .get("loop")
        .and_then(json::Value::as_bool)
        .unwrap_or(false);
    let speed = extras
        .get("ground_speed_m_s")
        .and_then(json::Value::as_f64)
        .unwrap_or(0.0);
    clip.ground_speed_m_s = speed.clamp(-1000.0, 1000.0) as f32;
}

fn curve<T>(
    times: Vec<f32>,
    values: Vec<T>,
    interpolation: Interpolation,
) -> Result<Curve<T>, Error> {
    let each = if interpolation == Interpolation::CubicSpline {
        3
    } else {
        1
    };
    if values.len() == each * times.len() {
        Ok(Curve {
            times,
            values,
            interpolation,
        })
    } else {
        Err(Error::Format("keys"))
    }
}
