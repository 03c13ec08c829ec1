//! The table of actions: everything that a key, a button or the wheel can do.

use crate::choice::words;

/// Something the player can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Action {
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
    /// Larger brush.
    BrushLarger,
    /// Smaller brush.
    BrushSmaller,
    /// The next shape of the brush; held, the wheel goes through them.
    BrushShape,
    /// The next kind of ground to build; held, the wheel goes through them.
    GroundKind,
    /// Build of the kind of ground under the crosshair.
    TakeKind,
    /// Undo the last stroke of the brush.
    UndoStroke,
    /// The flashlight on or off; in a car, its lights.
    Flashlight,
    /// Get into a car.
    EnterCar,
    /// Get out of it.
    LeaveCar,
    /// Set a car on its wheels.
    FlipCar,
    /// Sound its horn.
    Horn,
    /// Talk to the person ahead.
    Talk,
    /// Throw away one of what is in hand.
    Drop,
    /// Open and close the backpack.
    Backpack,
    /// Take a slot of the hotbar in hand, 0 to 9.
    Slot(u8),
    /// The slot to the left.
    PreviousSlot,
    /// The slot to the right.
    NextSlot,
    /// Held, the wheel moves along the hotbar in every world.
    WheelSlots,
    /// The picture's dial up.
    DialUp,
    /// The picture's dial down.
    DialDown,
    /// The space's other picture.
    OtherMap,
    /// The large map, or none.
    LargeMap,
    /// First or third person.
    Camera,
    /// Hide the display.
    HideDisplay,
    /// The shapes by which things are hit.
    HitShapes,
    /// What drawing a frame takes, on the display.
    FrameFigures,
    /// A picture of the screen, kept as a file.
    Screenshot,
    /// The photo mode.
    PhotoMode,
    /// Builds in a room, or walks in it again.
    Workshop,
    /// The console.
    Console,
    /// Go on to the next hint for newcomers.
    SkipHint,
    /// Fill the screen, or not.
    Fullscreen,
    /// The menu.
    Menu,
}

words! {
    /// The heading an action stands under, by the key of its text.
    ActionGroup {
        /// Getting about.
        Moving = "actions-group-moving",
        /// What is in hand.
        Tools = "actions-group-tools",
        /// The picture of the world.
        View = "actions-group-view",
        /// The game around it.
        Game = "actions-group-game",
    }
}

/// One action of the table.
#[derive(Clone, Copy, Debug)]
pub struct ActionInfo {
    /// The action.
    pub action: Action,
    /// Its name in the file.
    pub id: &'static str,
    /// The heading it stands under.
    pub group: ActionGroup,
    /// What does it before anybody changes that.
    pub(crate) defaults: &'static [&'static str],
}

impl ActionInfo {
    /// Key of the text that names it.
    pub fn label_key(&self) -> String {
        format!("action-{}", self.id)
    }
}

impl Action {
    /// Its line in the table.
    pub fn info(self) -> &'static ActionInfo {
        // Every action has a line; a test goes through them.
        ACTIONS
            .iter()
            .find(|info| info.action == self)
            .unwrap_or(&ACTIONS[0])
    }

    /// The action of that name.
    pub fn named(id: &str) -> Option<Self> {
        ACTIONS
            .iter()
            .find(|info| info.id == id)
            .map(|info| info.action)
    }

    /// Whether both may hang on one input without disturbing each other: the wheel turns the dial where the picture
    /// has one, and moves along the hotbar elsewhere.
    pub fn shares_with(self, other: Self) -> bool {
        let is_dial = |action| matches!(action, Self::DialUp | Self::DialDown);
        let is_slot = |action| matches!(action, Self::PreviousSlot | Self::NextSlot);
        is_dial(self) && is_slot(other) || is_slot(self) && is_dial(other)
    }
}

/// Every action, in the order in which they are shown.
pub const fn actions() -> &'static [ActionInfo] {
    &ACTIONS
}

const fn line(
    action: Action,
    id: &'static str,
    group: ActionGroup,
    defaults: &'static [&'static str],
) -> ActionInfo {
    ActionInfo {
        action,
        id,
        group,
        defaults,
    }
}

static ACTIONS: [ActionInfo; 51] = {
    use ActionGroup::{Game, Moving, Tools, View};
    [
        line(Action::Forward, "forward", Moving, &["KeyW"]),
        line(Action::Backward, "backward", Moving, &["KeyS"]),
        line(Action::Left, "left", Moving, &["KeyA"]),
        line(Action::Right, "right", Moving, &["KeyD"]),
        line(
            Action::Sprint,
            "sprint",
            Moving,
            &["ShiftLeft", "pad-left-stick"],
        ),
        line(Action::Jump, "jump", Moving, &["Space", "pad-south"]),
        line(Action::Sink, "sink", Moving, &["ControlLeft", "pad-east"]),
        line(Action::EnterCar, "enter-car", Moving, &["KeyC"]),
        line(Action::LeaveCar, "leave-car", Moving, &["KeyL"]),
        line(Action::FlipCar, "flip-car", Moving, &["KeyF"]),
        line(Action::Horn, "horn", Moving, &["KeyG"]),
        line(Action::Use, "use", Tools, &["Mouse1", "pad-right-trigger"]),
        line(
            Action::SecondUse,
            "second-use",
            Tools,
            &["Mouse2", "pad-left-trigger"],
        ),
        line(
            Action::BrushLarger,
            "brush-larger",
            Tools,
            &["ArrowUp", "pad-up"],
        ),
        line(
            Action::BrushSmaller,
            "brush-smaller",
            Tools,
            &["ArrowDown", "pad-down"],
        ),
        line(Action::BrushShape, "brush-shape", Tools, &["KeyB"]),
        line(Action::GroundKind, "ground-kind", Tools, &["KeyV"]),
        line(Action::TakeKind, "take-kind", Tools, &["Mouse3"]),
        line(Action::UndoStroke, "undo-stroke", Tools, &["KeyZ"]),
        line(Action::Flashlight, "flashlight", Tools, &["KeyY"]),
        line(Action::Talk, "talk", Tools, &["KeyT"]),
        line(Action::Drop, "drop", Tools, &["KeyQ"]),
        line(
            Action::Backpack,
            "backpack",
            Tools,
            &["KeyE", "pad-right-stick"],
        ),
        line(Action::Slot(0), "slot-1", Tools, &["Digit1"]),
        line(Action::Slot(1), "slot-2", Tools, &["Digit2"]),
        line(Action::Slot(2), "slot-3", Tools, &["Digit3"]),
        line(Action::Slot(3), "slot-4", Tools, &["Digit4"]),
        line(Action::Slot(4), "slot-5", Tools, &["Digit5"]),
        line(Action::Slot(5), "slot-6", Tools, &["Digit6"]),
        line(Action::Slot(6), "slot-7", Tools, &["Digit7"]),
        line(Action::Slot(7), "slot-8", Tools, &["Digit8"]),
        line(Action::Slot(8), "slot-9", Tools, &["Digit9"]),
        line(Action::Slot(9), "slot-10", Tools, &["Digit0"]),
        line(
            Action::PreviousSlot,
            "previous-slot",
            Tools,
            &["WheelUp", "pad-left-bumper"],
        ),
        line(
            Action::NextSlot,
            "next-slot",
            Tools,
            &["WheelDown", "pad-right-bumper"],
        ),
        line(Action::WheelSlots, "wheel-slots", Tools, &["AltLeft"]),
        line(Action::DialUp, "dial-up", View, &["WheelUp", "pad-right"]),
        line(
            Action::DialDown,
            "dial-down",
            View,
            &["WheelDown", "pad-left"],
        ),
        line(Action::OtherMap, "other-map", View, &["KeyH", "pad-west"]),
        line(Action::LargeMap, "large-map", View, &["KeyM"]),
        line(Action::Camera, "camera", View, &["Tab", "pad-north"]),
        line(
            Action::HideDisplay,
            "hide-display",
            View,
            &["F1", "pad-select"],
        ),
        line(Action::HitShapes, "hit-shapes", View, &["F3"]),
        line(Action::FrameFigures, "frame-figures", View, &["F4"]),
        line(Action::PhotoMode, "photo-mode", View, &["KeyP"]),
        line(Action::Screenshot, "screenshot", View, &["F12"]),
        line(Action::Workshop, "workshop", Game, &["F5"]),
        line(Action::Console, "console", Game, &["Backquote"]),
        line(Action::SkipHint, "skip-hint", Game, &["KeyN"]),
        line(Action::Fullscreen, "fullscreen", Game, &["F11"]),
        line(Action::Menu, "menu", Game, &["Escape", "pad-start"]),
    ]
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Input;

    #[test]
    fn every_action_has_a_name_of_its_own_and_a_known_input() {
        for (place, info) in ACTIONS.iter().enumerate() {
            let rest = &ACTIONS[place + 1..];
            assert!(
                rest.iter()
                    .all(|other| other.id != info.id && other.action != info.action)
            );
            assert_eq!(Action::named(info.id), Some(info.action));
            assert_eq!(info.action.info().id, info.id);
            assert!(!info.defaults.is_empty(), "{} does nothing", info.id);
            assert!(
                info.defaults
                    .iter()
                    .all(|name| Input::named(name).is_some())
            );
        }
        assert_eq!(Action::named("fly-to-the-moon"), None);
    }
}
