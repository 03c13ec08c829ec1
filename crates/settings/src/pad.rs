//! The buttons of a gamepad, by their places on it: what is printed on them differs from maker to maker.

/// A button of a gamepad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PadButton {
    /// The lowest of the four under the right thumb: A, or a cross.
    South,
    /// The right one: B, or a circle.
    East,
    /// The left one: X, or a square.
    West,
    /// The highest: Y, or a triangle.
    North,
    /// The upper one under the left forefinger.
    LeftBumper,
    /// The upper one under the right forefinger.
    RightBumper,
    /// The lower one under the left forefinger.
    LeftTrigger,
    /// The lower one under the right forefinger.
    RightTrigger,
    /// The small one left of the middle: back, share or minus.
    Select,
    /// The small one right of the middle: start, options or plus.
    Start,
    /// The left stick, pressed down.
    LeftStick,
    /// The right stick, pressed down.
    RightStick,
    /// Up on the cross under the left thumb.
    Up,
    /// Down on it.
    Down,
    /// Left on it.
    Left,
    /// Right on it.
    Right,
}

impl PadButton {
    /// All of them.
    pub const ALL: [Self; 16] = [
        Self::South,
        Self::East,
        Self::West,
        Self::North,
        Self::LeftBumper,
        Self::RightBumper,
        Self::LeftTrigger,
        Self::RightTrigger,
        Self::Select,
        Self::Start,
        Self::LeftStick,
        Self::RightStick,
        Self::Up,
        Self::Down,
        Self::Left,
        Self::Right,
    ];

    /// Its name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::South => "pad-south",
            Self::East => "pad-east",
            Self::West => "pad-west",
            Self::North => "pad-north",
            Self::LeftBumper => "pad-left-bumper",
            Self::RightBumper => "pad-right-bumper",
            Self::LeftTrigger => "pad-left-trigger",
            Self::RightTrigger => "pad-right-trigger",
            Self::Select => "pad-select",
            Self::Start => "pad-start",
            Self::LeftStick => "pad-left-stick",
            Self::RightStick => "pad-right-stick",
            Self::Up => "pad-up",
            Self::Down => "pad-down",
            Self::Left => "pad-left",
            Self::Right => "pad-right",
        }
    }
}
