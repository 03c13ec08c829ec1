//! Gamepads as gilrs tells of them; it knows the layouts of some thousand models.

use std::collections::VecDeque;

use antipode_settings::PadButton;
use gilrs::{Button, EventType, GamepadId, Gilrs, GilrsBuilder};

use super::{Axis, PadEvent, PadSource};

/// The gamepads of this machine.
pub(super) struct GilrsSource {
    gilrs: Gilrs,
    /// Those that were there from the start.
    first: VecDeque<PadEvent>,
}

impl GilrsSource {
    /// Looks for gamepads.
    ///
    /// # Errors
    /// When the system does not let one, in words.
    pub(super) fn open() -> Result<Self, String> {
        let gilrs = GilrsBuilder::new().with_force_feedback(false).build();
        let gilrs = gilrs.map_err(|error| error.to_string())?;
        let first = gilrs
            .gamepads()
            .map(|(_, pad)| PadEvent::Connected {
                name: pad.name().to_owned(),
            })
            .collect();
        Ok(Self { gilrs, first })
    }

    fn name(&self, id: GamepadId) -> String {
        self.gilrs.gamepad(id).name().to_owned()
    }
}

impl PadSource for GilrsSource {
    fn next(&mut self) -> Option<PadEvent> {
        if let Some(event) = self.first.pop_front() {
            return Some(event);
        }
        while let Some(event) = self.gilrs.next_event() {
            let told = match event.event {
                EventType::Connected => Some(PadEvent::Connected {
                    name: self.name(event.id),
                }),
                EventType::Disconnected => Some(PadEvent::Disconnected {
                    name: self.name(event.id),
                }),
                EventType::ButtonPressed(pressed, _) => button(pressed, true),
                EventType::ButtonReleased(released, _) => button(released, false),
                EventType::AxisChanged(moved, value, _) => stick(moved, value),
                _ => None,
            };
            if told.is_some() {
                return told;
            }
        }
        None
    }
}

fn button(button: Button, pressed: bool) -> Option<PadEvent> {
    let button = match button {
        Button::South => PadButton::South,
        Button::East => PadButton::East,
        Button::West => PadButton::West,
        Button::North => PadButton::North,
        Button::LeftTrigger => PadButton::LeftBumper,
        Button::RightTrigger => PadButton::RightBumper,
        Button::LeftTrigger2 => PadButton::LeftTrigger,
        Button::RightTrigger2 => PadButton::RightTrigger,
        Button::Select => PadButton::Select,
        Button::Start => PadButton::Start,
        Button::LeftThumb => PadButton::LeftStick,
        Button::RightThumb => PadButton::RightStick,
        Button::DPadUp => PadButton::Up,
        Button::DPadDown => PadButton::Down,
        Button::DPadLeft => PadButton::Left,
        Button::DPadRight => PadButton::Right,
        _ => return None,
    };
    Some(PadEvent::Button { button, pressed })
}

fn stick(axis: gilrs::Axis, value: f32) -> Option<PadEvent> {
    let axis = match axis {
        gilrs::Axis::LeftStickX => Axis::LeftX,
        gilrs::Axis::LeftStickY => Axis::LeftY,
        gilrs::Axis::RightStickX => Axis::RightX,
        gilrs::Axis::RightStickY => Axis::RightY,
        _ => return None,
    };
    Some(PadEvent::Stick { axis, value })
}
