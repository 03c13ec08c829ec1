//! The buttons of a gamepad, by their places on it: what is printed on them differs from maker to maker.

use crate::choice::words;

words! {
    /// A button of a gamepad, by its name in the file.
    PadButton {
        /// The lowest of the four under the right thumb: A, or a cross.
        South = "pad-south",
        /// The right one: B, or a circle.
        East = "pad-east",
        /// The left one: X, or a square.
        West = "pad-west",
        /// The highest: Y, or a triangle.
        North = "pad-north",
        /// The upper one under the left forefinger.
        LeftBumper = "pad-left-bumper",
        /// The upper one under the right forefinger.
        RightBumper = "pad-right-bumper",
        /// The lower one under the left forefinger.
        LeftTrigger = "pad-left-trigger",
        /// The lower one under the right forefinger.
        RightTrigger = "pad-right-trigger",
        /// The small one left of the middle: back, share or minus.
        Select = "pad-select",
        /// The small one right of the middle: start, options or plus.
        Start = "pad-start",
        /// The left stick, pressed down.
        LeftStick = "pad-left-stick",
        /// The right stick, pressed down.
        RightStick = "pad-right-stick",
        /// Up on the cross under the left thumb.
        Up = "pad-up",
        /// Down on it.
        Down = "pad-down",
        /// Left on it.
        Left = "pad-left",
        /// Right on it.
        Right = "pad-right",
    }
}
