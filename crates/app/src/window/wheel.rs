//! The wheel, one notch a click. On X11 a wheel that is reported as buttons 4 and 5 arrives as a line when
//! the button goes down and as another when it comes up; raw button events tell which lines are the second.

use winit::event::{ElementState, MouseScrollDelta};

/// Pixels of a touchpad's motion that count as one notch of a wheel.
const PIXELS_PER_NOTCH: f64 = 40.0;
/// X11's buttons for the wheel: up, down, left, right.
const WHEEL_BUTTONS: std::ops::RangeInclusive<u32> = 4..=7;

/// The wheel of one window.
#[derive(Debug, Default)]
pub struct Wheel {
    /// Whether the next line comes from a button's release and repeats the one of its press.
    repeats: bool,
}

impl Wheel {
    /// A raw button event of any device; it comes before the wheel's line that it causes. The system may tell
    /// it twice, for the device and for the pointer it moves, so it is the last one that counts.
    pub fn raw_button(&mut self, button: u32, state: ElementState) {
        if WHEEL_BUTTONS.contains(&button) {
            self.repeats = state == ElementState::Released;
        }
    }

    /// The notches a wheel event means, away from the player positive.
    pub fn notches(&mut self, delta: MouseScrollDelta) -> f64 {
        match delta {
            MouseScrollDelta::LineDelta(..) if std::mem::take(&mut self.repeats) => 0.0,
            MouseScrollDelta::LineDelta(_, lines) => f64::from(lines),
            MouseScrollDelta::PixelDelta(pixels) => pixels.y / PIXELS_PER_NOTCH,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: MouseScrollDelta = MouseScrollDelta::LineDelta(0.0, 1.0);

    #[test]
    fn a_wheel_told_as_a_button_counts_once_a_click() {
        let mut wheel = Wheel::default();
        let mut turned = 0.0;
        for _ in 0..3 {
            wheel.raw_button(4, ElementState::Pressed);
            turned += wheel.notches(UP);
            wheel.raw_button(4, ElementState::Released);
            turned += wheel.notches(UP);
        }
        assert_eq!(turned, 3.0);
    }

    #[test]
    fn a_button_told_for_two_devices_still_counts_once_a_click() {
        let mut wheel = Wheel::default();
        let mut turned = 0.0;
        for _ in 0..3 {
            for state in [ElementState::Pressed, ElementState::Released] {
                wheel.raw_button(5, state);
                wheel.raw_button(5, state);
                turned += wheel.notches(UP);
            }
        }
        assert_eq!(turned, 3.0);
    }

    #[test]
    fn a_wheel_told_as_an_axis_counts_every_line() {
        let mut wheel = Wheel::default();
        wheel.raw_button(1, ElementState::Released);
        assert_eq!(wheel.notches(UP) + wheel.notches(UP), 2.0);
        let pixels = winit::dpi::PhysicalPosition::new(0.0, 20.0);
        assert_eq!(wheel.notches(MouseScrollDelta::PixelDelta(pixels)), 0.5);
    }
}
