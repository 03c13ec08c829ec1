//! Draws what the player holds in first person: drawn before the eye in its own axes, where every space is flat.

use std::f32::consts::FRAC_PI_2;

use antipode_frame::{Frame, Hand, ModelId};
use antipode_geometry::{ChartPoint, LevelMap};
use glam::{Quat, Vec3};

use crate::lamps::{BEAMS, LAMPS, lights_near};
use crate::rig::HandPose;
use crate::uniforms::{FigureInstance, WHOLE, dark_bits, level_row};

/// The gun's muzzle from its grip, metres.
pub const MUZZLE_M: Vec3 = Vec3::new(0.275, 0.085, 0.0);

/// What is in the hand is seen at this focal length, whatever the field of view is, as figure.wgsl has it.
pub const HAND_FOCAL: f32 = 1.96;

/// Lights within this of the eye are carried beside what is held, metres.
const CARRIED_M: f64 = 0.8;
/// Out of the picture, what is held is lower by this, metres, and turned down by this, radians.
const LOWERED_M: f32 = 0.35;
const LOWERED_RAD: f32 = 0.9;
/// How far a shot throws what is held back, metres, and up, radians.
const KICK_BACK_M: f32 = 0.055;
const KICK_UP_RAD: f32 = 0.16;
/// A tool is raised by this before its stroke, strikes down by this from there, radians, and reaches ahead by this,
/// metres.
const RAISED_RAD: f32 = 0.45;
const STROKE_RAD: f32 = 1.25;
const REACH_M: f32 = 0.16;

/// Where a thing is held, from its origin in its own axes, metres.
pub fn grip_m(model: ModelId) -> Vec3 {
    match model {
        ModelId::Item(item) => item.held().grip_m.into(),
        _ => Vec3::ZERO,
    }
}

/// The lights that reach the hand, but those that are carried beside it: so near, they would bleach it.
fn lights_beyond(frame: &Frame, carried_m: f64) -> [u32; 3] {
    let eye = frame.view.eye.point;
    let is_carried = |at: ChartPoint| at.chart == eye.chart && at.pos.distance(eye.pos) < carried_m;
    let mut mask = lights_near(frame, eye.chart, eye.pos, eye.pos);
    for (i, lamp) in frame.content.lights.lamps.iter().take(LAMPS).enumerate() {
        mask[i / 32] &= !(u32::from(is_carried(lamp.point)) << (i % 32));
    }
    for (i, beam) in frame.content.lights.beams.iter().take(BEAMS).enumerate() {
        mask[2] &= !(u32::from(is_carried(beam.point)) << i);
    }
    mask
}

/// Something in a hand: what it is, and how it is turned and where its origin is, metres, in the axes of whoever holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// What is drawn.
    pub model: ModelId,
    /// How it is turned.
    pub turn: Quat,
    /// Where its origin is.
    pub place: Vec3,
}

/// What is drawn of the hand, in the eye's axes: x to the right, y up, z back.
pub fn before_eye(hand: &Hand) -> Vec<Held> {
    let ModelId::Item(item) = hand.model else {
        return Vec::new();
    };
    let held = item.held();
    let (place, turn) = (Vec3::from(held.place_m), Vec3::from(held.turn_rad));
    let swing = hand.swing.max(0.0);
    let swings = f32::from(u8::from(hand.swing >= 0.0));
    let up_rad = KICK_UP_RAD * hand.kick + swings * (RAISED_RAD - STROKE_RAD * swing)
        - LOWERED_RAD * hand.lowered;
    let ahead_m = REACH_M * swing - KICK_BACK_M * hand.kick;
    let [right_m, up_m] = hand.bob_m;
    let place = place + Vec3::new(right_m, up_m - LOWERED_M * hand.lowered, ahead_m);
    // In the game's axes: x ahead, y up, z to the right.
    let held = Quat::from_rotation_z(up_rad)
        * Quat::from_rotation_x(turn.z)
        * Quat::from_rotation_y(turn.x)
        * Quat::from_rotation_z(turn.y);
    // From there to the eye's: x to the right, y up, z back.
    let turn = Quat::from_rotation_y(FRAC_PI_2) * held;
    let origin = Vec3::new(place.x, place.y, -place.z) - turn * grip_m(hand.model);
    with_flash(hand.model, turn, origin, hand.flashes)
}

/// What a figure holds, in the figure's axes; `hand` is where its hand is.
pub fn in_hand_of(hand: HandPose, model: ModelId, flashes: bool) -> Vec<Held> {
    let origin = hand.place - hand.turn * grip_m(model);
    with_flash(model, hand.turn, origin, flashes)
}

fn with_flash(model: ModelId, turn: Quat, place: Vec3, flashes: bool) -> Vec<Held> {
    let mut held = vec![Held { model, turn, place }];
    if flashes {
        held.push(Held {
            model: ModelId::Flash,
            turn,
            place: place + turn * MUZZLE_M,
        });
    }
    held
}

/// What is drawn of the hand: the model, and its instance in the eye's axes.
pub fn instances(frame: &Frame, hand: &Hand) -> Vec<(ModelId, FigureInstance)> {
    let lights = lights_beyond(frame, CARRIED_M);
    let instance = |held: Held| FigureInstance {
        offset: held.place.into(),
        flags: dark_bits(1.0 - frame.view.covered),
        turn: held.turn.to_array(),
        frame: [[0.0; 4]; 4],
        lights,
        cut: WHOLE,
        level: level_row(LevelMap::SAME),
    };
    let all = before_eye(hand).into_iter();
    all.map(|held| (held.model, instance(held))).collect()
}
