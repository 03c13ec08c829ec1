//! The shadow maps of land: what each one covers, and which is drawn anew next.
//!
//! Under a sky there are cascades: squares round the eye, each some times as wide as the one before. They do not
//! follow the view, so that turning changes nothing and what lies behind the eye throws its shadow too. In a closed
//! world there is a map of what is round the eye, and six faces of all directions.

use std::f64::consts::SQRT_2;

use antipode_frame::Frame;
use antipode_geometry::{ChartPoint, Strategy};
use glam::{DMat4, DVec2};

use crate::culling::Ball;

use super::caster::Caster;
use super::light::{Crop, DEPTH_SLACK_M, FACES, Light};

/// Cascades under a sky; `SHADOW_CASCADES` of shadow.wgsl.
pub const CASCADES: usize = 3;
/// Half the side of what the finest map holds, metres; and of what the only one of a closed world does.
const NEAR_M: f64 = 12.0;
const ALONE_M: f64 = 32.0;
/// The farthest cascade is at least so wide on each side of the eye, and at most, metres.
const FAR_M: [f64; 2] = [64.0, 1024.0];
/// The same of an ideal point's light, in radii: the sun is where the eye sees it, and farther off land is lit from elsewhere.
const IDEAL_RAD: f64 = 0.75;
/// Half the side of a face, as a tangent: a little past the next face, for the texels around a point.
const FACE_HALF: f64 = 1.02;
/// Blocks across a map in which its middle moves, so that walking draws it anew now and then only, and always on the
/// same grid of texels.
const BLOCKS: f64 = 16.0;
/// A map round the eye is wide enough down to this part of its half side.
const USED_HALF: f64 = 0.35;
/// How many frames a map of changed land may wait, times its level.
const PATIENCE_FRAMES: f64 = 4.0;

/// What a map is a picture of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shot {
    /// The light it was taken by.
    pub light: Light,
    /// What of it.
    pub crop: Crop,
    /// Heights that its depth holds.
    pub heights: [f64; 2],
}

impl Shot {
    /// The heights between which what a ball holds lies, if any of it may fall on it.
    pub fn ball_heights(&self, strategy: &dyn Strategy, ball: &Ball) -> Option<[f64; 2]> {
        self.light.ball_heights(strategy, &self.crop, ball)
    }

    /// The matrix from the light's base to clip coordinates.
    pub fn clip(&self) -> DMat4 {
        self.light.clip(&self.crop, self.heights)
    }

    /// 1, or -1 where it is mirrored: the two axes of a star's even faces are a left-handed pair as it looks along them.
    pub fn hand(&self) -> f32 {
        match self.light {
            Light::Star { .. } if self.crop.face.is_multiple_of(2) => -1.0,
            Light::Star { .. } | Light::Far { .. } => 1.0,
        }
    }

    /// The height up to which its depth reaches.
    pub fn highest(&self) -> f64 {
        self.heights[1] + DEPTH_SLACK_M
    }
}

/// A map of the land.
#[derive(Debug)]
pub struct Level {
    /// The layer of the texture that it lies in.
    pub layer: u32,
    /// What is on it; nothing before it was first drawn.
    pub shot: Option<Shot>,
    /// Frames since land on it changed, if it did.
    pub changed: Option<u32>,
    /// Whether a part of it was drawn later than the rest: it shows the same as one that was drawn at once, but for
    /// rounding.
    pub is_mended: bool,
}

/// How many maps of land there are by a light. In a closed world a processor has no time for its faces.
pub fn count(light: &Light, with_faces: bool) -> usize {
    match light {
        Light::Far { .. } => CASCADES,
        Light::Star { .. } if with_faces => 1 + FACES,
        Light::Star { .. } => 1,
    }
}

/// Half the side of what the finest of so many maps holds, metres.
fn near_m(maps: usize) -> f64 {
    if maps == 1 { ALONE_M } else { NEAR_M }
}

/// The next power of the root of two: sizes change seldom, and by steps.
fn stepped(size: f64) -> f64 {
    SQRT_2.powf((size.log2() * 2.0).ceil())
}

/// One of the maps of land.
#[derive(Clone, Copy, Debug)]
pub struct MapNumber {
    /// Its number; 0 is the finest.
    pub level: usize,
    /// How many there are.
    pub of: usize,
}

/// What is to be on a map of so many texels.
pub fn wanted(map: MapNumber, frame: &Frame, light: &Light, texels: u32) -> Crop {
    let MapNumber { level, of: maps } = map;
    match light {
        Light::Far { .. } => {
            let mut far_m = stepped(f64::from(frame.view.fog_distance_m).clamp(FAR_M[0], FAR_M[1]));
            if light.is_ideal() {
                far_m = far_m
                    .min(IDEAL_RAD * frame.view.strategy.radius_m())
                    .max(2.0 * NEAR_M);
            }
            let part = level as f64 / (CASCADES - 1) as f64;
            let half = NEAR_M * (far_m / NEAR_M).powf(part);
            let half = on_plane(frame, light, half);
            around(frame, light, half, 2.0 * half / BLOCKS)
        }
        Light::Star { .. } if level > 0 => Crop {
            face: level - 1,
            centre: DVec2::ZERO,
            half: FACE_HALF,
        },
        Light::Star { .. } => near_crop(frame, light, near_m(maps), texels / BLOCKS as u32, texels),
    }
}

/// Half the side of a map that holds so many metres of what is round the eye. Where the light is an ideal point, a metre on its
/// plane is as long as the place is high over it.
fn on_plane(frame: &Frame, light: &Light, metres: f64) -> f64 {
    if !light.is_ideal() {
        return metres;
    }
    let base = light.base(&*frame.view.strategy, frame.view.eye.point);
    stepped(light.length_on_plane(base, metres))
}

/// What lies within so many metres of the eye, its middle on a grid of `block` texels.
pub fn near_crop(frame: &Frame, light: &Light, metres: f64, block: u32, texels: u32) -> Crop {
    let base = light.base(&*frame.view.strategy, frame.view.eye.point);
    let half = match light {
        Light::Far { .. } => on_plane(frame, light, metres),
        Light::Star { .. } => stepped(light.length_on_plane(base, metres)),
    };
    around(
        frame,
        light,
        half,
        2.0 * half * f64::from(block) / f64::from(texels),
    )
}

fn around(frame: &Frame, light: &Light, half: f64, grid: f64) -> Crop {
    let eye: ChartPoint = frame.view.eye.point;
    let (face, at) = light.seen(light.base(&*frame.view.strategy, eye));
    Crop {
        face,
        centre: (at / grid).round() * grid,
        half,
    }
}

/// How far a light may turn before a map is drawn anew, radians: until the shadow of what stands high over its ground
/// is off by a texel.
fn turn_allowed(light: &Light, crop: &Crop, texels: u32) -> f64 {
    let texel = 2.0 * crop.half / f64::from(texels);
    match light {
        Light::Far { .. } => texel / (8.0 + 0.25 * crop.half),
        // A star is at least four times as far from what throws a shadow as that is from its shadow.
        Light::Star { .. } => 4.0 * texel,
    }
}

impl Level {
    /// How badly it is to be drawn anew: over 1 is due.
    pub fn staleness(
        &self,
        map: MapNumber,
        frame: &Frame,
        light: &Light,
        wanted: &Crop,
        texels: u32,
    ) -> f64 {
        let Some(shot) = &self.shot else {
            return f64::INFINITY;
        };
        let turned = shot.light.turn_to(light, &frame.view) / turn_allowed(light, wanted, texels);
        let changed = self.changed.map_or(0.0, |frames| {
            1.01 + f64::from(frames) / (PATIENCE_FRAMES * (map.level + 1) as f64)
        });
        turned.max(changed).max(moved(map.of, frame, shot, wanted))
    }

    /// Whether it is just what a frame wants, for pictures that do not depend on what came before.
    pub fn is_exact(&self, light: &Light, wanted: &Crop) -> bool {
        self.changed.is_none()
            && !self.is_mended
            && self
                .shot
                .is_some_and(|shot| shot.light == *light && shot.crop == *wanted)
    }

    /// Takes note of land that came or went.
    pub fn note(&mut self, frame: &Frame, of: &Caster) {
        if let Some(shot) = &self.shot
            && self.changed.is_none()
            && shot
                .light
                .heights(&*frame.view.strategy, &shot.crop, of)
                .is_some()
        {
            self.changed = Some(0);
        }
    }
}

/// How far the eye has moved from the middle, in blocks; or past any, where the size is another.
fn moved(maps: usize, frame: &Frame, shot: &Shot, wanted: &Crop) -> f64 {
    let crop = &shot.crop;
    if matches!(shot.light, Light::Star { .. }) {
        if wanted.half == FACE_HALF {
            return 0.0;
        }
        let base = shot.light.base(&*frame.view.strategy, frame.view.eye.point);
        let needed = shot.light.length_on_plane(base, near_m(maps));
        if !(USED_HALF * crop.half..=1.05 * crop.half).contains(&needed) {
            return f64::INFINITY;
        }
    } else if crop.half != wanted.half {
        return f64::INFINITY;
    }
    let base = shot.light.base(&*frame.view.strategy, frame.view.eye.point);
    let at = shot.light.on_plane(crop.face, base) - crop.centre;
    at.abs().max_element() / (2.0 * crop.half / BLOCKS)
}
