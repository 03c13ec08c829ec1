//! The player's actions in one simulation step, after key bindings have been applied.
//!
//! The simulation is a pure function of the saved world, the seed and the sequence of these.

use crate::aimed::Aim;
use crate::camera::LookTurn;

/// One step's wishes. Held actions are levels; the rest are events that happened since the last step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Actions {
    /// Forward minus backward, -1 to 1.
    pub forward: f64,
    /// Right minus left, -1 to 1.
    pub strafe: f64,
    /// Sprint held; drives harder.
    pub sprint: bool,
    /// Jump held; rises in flight, brakes in a car.
    pub jump: bool,
    /// Sink held; only flight uses it.
    pub sink: bool,
    /// Turn to the right in radians.
    pub look_yaw: f64,
    /// Turn upwards in radians.
    pub look_pitch: f64,
    /// Primary use held: mine.
    pub primary: bool,
    /// Secondary use held: build.
    pub secondary: bool,
    /// Notches of the dial of the picture's curvature, up positive.
    pub dial: f64,
    /// Slots to move along the hotbar, right positive.
    pub slot_step: i32,
    /// Slot chosen directly, 0 to 9.
    pub slot: Option<u8>,
    /// Change of the brush radius, in steps of a metre.
    pub brush_step: i32,
    /// Shapes of the brush to go on by, or back.
    pub shape_step: i32,
    /// Kinds of ground to be built to go on by, or back.
    pub kind_step: i32,
    /// Build of what is under the crosshair.
    pub take_kind: bool,
    /// Undo the last stroke of the brush.
    pub undo: bool,
    /// Change to the space's other picture: the other hyperbolic map, or a flat world bent or not.
    pub turn_map: bool,
    /// Switch between first and third person.
    pub toggle_camera: bool,
    /// Switch the flashlight, or the lights of the car that is driven.
    pub toggle_light: bool,
    /// Get into the car that is near and in view.
    pub enter_car: bool,
    /// Get out of the car.
    pub leave_car: bool,
    /// Set the car on its wheels.
    pub flip_car: bool,
    /// Sound the car's horn.
    pub horn: bool,
    /// Talk to the person ahead.
    pub talk: bool,
    /// Throw away one of what is in hand.
    pub drop_one: bool,
    /// Throw away all of what is in hand.
    pub drop_all: bool,
    /// Take up what is loose, or let go of it; only rooms use it.
    pub grasp: bool,
    /// The lens that they were aimed by; without one they go by the simulation's own, which glides.
    pub aimed: Option<Aim>,
}

impl Actions {
    /// How far they turn the view.
    pub(crate) fn look_turn(&self) -> LookTurn {
        LookTurn {
            right_rad: self.look_yaw,
            up_rad: self.look_pitch,
        }
    }

    /// These, or none where they cannot be done.
    pub(crate) fn unless(&self, hindered: bool) -> Self {
        if hindered { Self::default() } else { *self }
    }
}
