//! Which key does what. The controls screen and the hints are generated from this table.

use winit::keyboard::KeyCode;

use crate::names::key_label;

/// Something the player can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// Walk forward.
    Forward,
    /// Walk backward.
    Backward,
    /// Step to the left.
    Left,
    /// Step to the right.
    Right,
    /// Go faster.
    Sprint,
    /// Jump; rise in flight.
    Jump,
    /// Sink in flight.
    Sink,
    /// Use what is in hand.
    Use,
    /// Its second use.
    SecondUse,
    /// Take a slot of the hotbar in hand.
    Slot(u8),
    /// Larger brush.
    BrushLarger,
    /// Smaller brush.
    BrushSmaller,
    /// First or third person.
    Camera,
    /// The space's other picture.
    OtherMap,
    /// The menu.
    Menu,
    /// Hide the display.
    HideDisplay,
    /// What drawing a frame takes, on the display.
    FrameFigures,
    /// Held, the wheel moves along the hotbar in every space.
    WheelSlots,
}

/// A key or button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// A key, by its place on the keyboard.
    Key(KeyCode),
    /// Left button.
    MouseLeft,
    /// Right button.
    MouseRight,
}

/// One line of the controls screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// What is done.
    pub action: String,
    /// Which keys do it.
    pub keys: String,
    /// The heading it stands under.
    pub group: &'static str,
}

/// The table of bindings.
#[derive(Clone, Debug)]
pub struct Bindings {
    table: Vec<(Input, Command)>,
}

const SLOT_KEYS: [KeyCode; 10] = [
    KeyCode::Digit1,
    KeyCode::Digit2,
    KeyCode::Digit3,
    KeyCode::Digit4,
    KeyCode::Digit5,
    KeyCode::Digit6,
    KeyCode::Digit7,
    KeyCode::Digit8,
    KeyCode::Digit9,
    KeyCode::Digit0,
];

impl Default for Bindings {
    fn default() -> Self {
        let keys = [
            (KeyCode::KeyW, Command::Forward),
            (KeyCode::KeyS, Command::Backward),
            (KeyCode::KeyA, Command::Left),
            (KeyCode::KeyD, Command::Right),
            (KeyCode::ShiftLeft, Command::Sprint),
            (KeyCode::Space, Command::Jump),
            (KeyCode::ControlLeft, Command::Sink),
            (KeyCode::ArrowUp, Command::BrushLarger),
            (KeyCode::ArrowDown, Command::BrushSmaller),
            (KeyCode::Tab, Command::Camera),
            (KeyCode::KeyH, Command::OtherMap),
            (KeyCode::Escape, Command::Menu),
            (KeyCode::F1, Command::HideDisplay),
            (KeyCode::F4, Command::FrameFigures),
            (KeyCode::AltLeft, Command::WheelSlots),
        ];
        let mut table: Vec<_> = keys
            .into_iter()
            .map(|(key, command)| (Input::Key(key), command))
            .collect();
        table.push((Input::MouseLeft, Command::Use));
        table.push((Input::MouseRight, Command::SecondUse));
        table.extend(
            (0..)
                .zip(SLOT_KEYS)
                .map(|(slot, key)| (Input::Key(key), Command::Slot(slot))),
        );
        Self { table }
    }
}

impl Bindings {
    /// What an input does, if anything.
    pub fn command(&self, input: Input) -> Option<Command> {
        self.table
            .iter()
            .find(|(bound, _)| *bound == input)
            .map(|(_, command)| *command)
    }

    /// The name of the key that does something.
    pub fn label(&self, command: Command) -> String {
        let found = self.table.iter().find(|(_, bound)| *bound == command);
        found.map_or_else(|| "not bound".to_owned(), |(input, _)| input_label(*input))
    }

    /// The controls screen, line by line.
    pub fn lines(&self) -> Vec<Line> {
        let line = |action: &str, keys: String, group| Line {
            action: action.to_owned(),
            keys,
            group,
        };
        let of = |command| self.label(command);
        vec![
            line("Walk forward", of(Command::Forward), "Moving"),
            line("Walk backward", of(Command::Backward), "Moving"),
            line("Step left", of(Command::Left), "Moving"),
            line("Step right", of(Command::Right), "Moving"),
            line("Sprint", of(Command::Sprint), "Moving"),
            line("Jump (rise when flying)", of(Command::Jump), "Moving"),
            line("Sink when flying", of(Command::Sink), "Moving"),
            line("Look", "Mouse".to_owned(), "Moving"),
            line("Mine with a pickaxe", of(Command::Use), "Tools"),
            line("Build with a pickaxe", of(Command::SecondUse), "Tools"),
            line(
                "Take a slot in hand",
                format!("{} to 9, {}", of(Command::Slot(0)), of(Command::Slot(9))),
                "Tools",
            ),
            line("Larger brush", of(Command::BrushLarger), "Tools"),
            line("Smaller brush", of(Command::BrushSmaller), "Tools"),
            line(
                "Curvature (hyperbolic or bent)",
                "Wheel".to_owned(),
                "World",
            ),
            line(
                "Other map (hyperbolic), bend (flat)",
                of(Command::OtherMap),
                "World",
            ),
            line("Next slot (other worlds)", "Wheel".to_owned(), "World"),
            line(
                "Next slot (everywhere)",
                format!("{} + wheel", of(Command::WheelSlots)),
                "World",
            ),
            line("First or third person", of(Command::Camera), "World"),
            line("Hide the display", of(Command::HideDisplay), "World"),
            line("Frame figures", of(Command::FrameFigures), "World"),
            line("Menu and pause", of(Command::Menu), "World"),
        ]
    }
}

fn input_label(input: Input) -> String {
    match input {
        Input::Key(code) => key_label(code),
        Input::MouseLeft => "Left button".to_owned(),
        Input::MouseRight => "Right button".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_input_is_bound_twice() {
        let table = Bindings::default().table;
        for (i, (input, _)) in table.iter().enumerate() {
            assert!(
                table[i + 1..].iter().all(|(other, _)| other != input),
                "{input:?} is bound twice"
            );
        }
    }

    #[test]
    fn every_slot_has_a_key_the_ninth_included() {
        let bindings = Bindings::default();
        for slot in 0..10 {
            assert_ne!(
                bindings.label(Command::Slot(slot)),
                "not bound",
                "slot {slot}"
            );
        }
    }

    #[test]
    fn the_controls_screen_names_every_bound_command_by_its_key() {
        let bindings = Bindings::default();
        let screen: String = bindings.lines().into_iter().map(|l| l.keys + " ").collect();
        for (_, command) in &bindings.table {
            if !matches!(command, Command::Slot(1..=8)) {
                assert!(
                    screen.contains(&bindings.label(*command)),
                    "{command:?} is missing"
                );
            }
        }
    }
}
