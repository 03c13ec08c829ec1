//! One set of bindings: which inputs do what, and where two actions hang on one input.

use thiserror::Error;

use crate::action::{Action, actions};
use crate::input::Input;

/// Most inputs that one action has.
pub const MAX_INPUTS: usize = 4;
/// The key that leads out of everything, and so cannot do anything else.
const WAY_OUT: Input = Input::Key("Escape");

/// A set of bindings with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    name: String,
    /// The inputs of each action, in the order of the table of actions.
    inputs: Vec<(Action, Vec<Input>)>,
}

/// Two or more actions that one input would do at once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflict {
    /// The input.
    pub input: Input,
    /// What it would do, in the order of the table.
    pub actions: Vec<Action>,
}

/// Why an action cannot have or lose an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum BindError {
    /// Escape always opens the menu and cancels.
    #[error("Escape always leads out of a screen, so it cannot do anything else")]
    WayOut,
    /// The action has as many as it can have.
    #[error("an action has at most {MAX_INPUTS} inputs; take one away first")]
    Full,
    /// Without an input for the menu nobody could change this again.
    #[error("Escape must stay a key of the menu, or you could not get back here")]
    MenuKeepsWayOut,
}

impl BindError {
    /// Key of its text.
    pub fn text_key(self) -> &'static str {
        match self {
            Self::WayOut => "bind-error-way-out",
            Self::Full => "bind-error-full",
            Self::MenuKeepsWayOut => "bind-error-menu",
        }
    }
}

impl Profile {
    /// The default bindings under a name.
    pub(crate) fn new(name: String) -> Self {
        let inputs = actions()
            .iter()
            .map(|info| (info.action, defaults(info.action)))
            .collect();
        Self { name, inputs }
    }

    /// The same bindings under another name.
    pub(crate) fn called(&self, name: String) -> Self {
        Self {
            name,
            inputs: self.inputs.clone(),
        }
    }

    pub(crate) fn rename(&mut self, name: String) {
        self.name = name;
    }

    /// Its name; that of the first profile is empty until somebody gives it one.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What does an action.
    pub fn inputs(&self, action: Action) -> &[Input] {
        self.inputs
            .iter()
            .find(|(bound, _)| *bound == action)
            .map_or(&[], |(_, inputs)| inputs)
    }

    /// What an input does, in the order of the table.
    pub fn actions(&self, input: Input) -> impl Iterator<Item = Action> {
        self.inputs
            .iter()
            .filter(move |(_, inputs)| inputs.contains(&input))
            .map(|(action, _)| *action)
    }

    /// Lets an input do an action, besides what does it already.
    ///
    /// # Errors
    /// [`BindError`] when the action is full or the input is Escape; nothing is changed then.
    pub fn bind(&mut self, action: Action, input: Input) -> Result<(), BindError> {
        let inputs = self.inputs_mut(action);
        if inputs.contains(&input) {
            return Ok(());
        }
        if input == WAY_OUT {
            return Err(BindError::WayOut);
        }
        if inputs.len() >= MAX_INPUTS {
            return Err(BindError::Full);
        }
        inputs.push(input);
        Ok(())
    }

    /// Puts an input in the place of another, or beside the others where that one is not there.
    ///
    /// # Errors
    /// As [`Profile::bind`] and [`Profile::unbind`].
    pub fn rebind(&mut self, action: Action, old: Input, new: Input) -> Result<(), BindError> {
        if self.inputs(action).contains(&new) {
            return if old == new {
                Ok(())
            } else {
                self.unbind(action, old)
            };
        }
        let Some(place) = self.inputs(action).iter().position(|input| *input == old) else {
            return self.bind(action, new);
        };
        if new == WAY_OUT {
            return Err(BindError::WayOut);
        }
        if old == WAY_OUT {
            return Err(BindError::MenuKeepsWayOut);
        }
        self.inputs_mut(action)[place] = new;
        Ok(())
    }

    /// Lets an input do an action no longer.
    ///
    /// # Errors
    /// [`BindError::MenuKeepsWayOut`] for Escape.
    pub fn unbind(&mut self, action: Action, input: Input) -> Result<(), BindError> {
        if action == Action::Menu && input == WAY_OUT {
            return Err(BindError::MenuKeepsWayOut);
        }
        self.inputs_mut(action).retain(|bound| *bound != input);
        Ok(())
    }

    /// Gives an action its default inputs again.
    pub fn reset(&mut self, action: Action) {
        *self.inputs_mut(action) = defaults(action);
    }

    /// Gives every action its default inputs again.
    pub fn reset_all(&mut self) {
        for (action, inputs) in &mut self.inputs {
            *inputs = defaults(*action);
        }
    }

    /// Whether an action has its default inputs.
    pub fn is_default(&self, action: Action) -> bool {
        self.inputs(action) == defaults(action)
    }

    /// Where one input would do several things at once.
    pub fn conflicts(&self) -> Vec<Conflict> {
        let mut conflicts: Vec<Conflict> = Vec::new();
        for input in self.inputs.iter().flat_map(|(_, inputs)| inputs) {
            if conflicts.iter().any(|known| known.input == *input) {
                continue;
            }
            let actions: Vec<Action> = self.actions(*input).collect();
            let disturbed = |action: &Action| {
                let others = actions.iter().filter(|other| *other != action);
                others.into_iter().any(|other| !action.shares_with(*other))
            };
            let actions: Vec<Action> = actions.iter().filter(|a| disturbed(a)).copied().collect();
            if !actions.is_empty() {
                conflicts.push(Conflict {
                    input: *input,
                    actions,
                });
            }
        }
        conflicts
    }

    /// Gives an action just these inputs, as a file tells: doubles and those beyond the most are left out, and the
    /// way out stays where it belongs.
    pub(crate) fn put(&mut self, action: Action, inputs: &[Input]) {
        let mut kept = Vec::new();
        if action == Action::Menu {
            kept.push(WAY_OUT);
        }
        for input in inputs {
            if *input != WAY_OUT && !kept.contains(input) && kept.len() < MAX_INPUTS {
                kept.push(*input);
            }
        }
        *self.inputs_mut(action) = kept;
    }

    fn inputs_mut(&mut self, action: Action) -> &mut Vec<Input> {
        let place = self.inputs.iter().position(|(bound, _)| *bound == action);
        let place = place.unwrap_or_else(|| {
            self.inputs.push((action, Vec::new()));
            self.inputs.len() - 1
        });
        &mut self.inputs[place].1
    }
}

fn defaults(action: Action) -> Vec<Input> {
    let names = action.info().defaults.iter();
    names.filter_map(|name| Input::named(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::MouseButton;

    const KEY_J: Input = Input::Key("KeyJ");
    const KEY_W: Input = Input::Key("KeyW");
    const BACK: Input = Input::Mouse(MouseButton::Back);

    fn profile() -> Profile {
        Profile::new(String::new())
    }

    #[test]
    fn the_default_bindings_are_at_peace() {
        assert_eq!(profile().conflicts(), []);
    }

    #[test]
    fn one_input_for_two_actions_is_told_and_both_are_named() {
        let mut own = profile();
        assert_eq!(own.bind(Action::Camera, KEY_W), Ok(()));
        let conflict = Conflict {
            input: KEY_W,
            actions: vec![Action::Forward, Action::Camera],
        };
        assert_eq!(own.conflicts(), [conflict]);
        own.reset(Action::Camera);
        assert_eq!(own.conflicts(), []);
    }

    #[test]
    fn the_wheel_may_turn_the_dial_and_the_hotbar_but_not_jump_as_well() {
        let mut own = profile();
        assert_eq!(own.bind(Action::Jump, Input::WheelUp), Ok(()));
        let conflict = Conflict {
            input: Input::WheelUp,
            actions: vec![Action::Jump, Action::PreviousSlot, Action::DialUp],
        };
        assert_eq!(own.conflicts(), [conflict]);
    }

    #[test]
    fn an_action_has_several_inputs_and_loses_them_one_by_one() {
        let mut own = profile();
        assert_eq!(own.bind(Action::Left, KEY_J), Ok(()));
        assert_eq!(own.bind(Action::Left, KEY_J), Ok(()));
        assert_eq!(own.rebind(Action::Left, KEY_J, BACK), Ok(()));
        assert_eq!(own.inputs(Action::Left), [Input::Key("KeyA"), BACK]);
        assert!(own.actions(BACK).eq([Action::Left]));
        assert_eq!(own.unbind(Action::Left, Input::Key("KeyA")), Ok(()));
        assert_eq!(own.inputs(Action::Left), [BACK]);
        assert_eq!(own.unbind(Action::Left, BACK), Ok(()));
        assert!(own.inputs(Action::Left).is_empty() && !own.is_default(Action::Left));
        for key in ["KeyI", "KeyJ", "KeyK", "KeyL"] {
            assert_eq!(own.bind(Action::Left, Input::Key(key)), Ok(()));
        }
        assert_eq!(own.bind(Action::Left, BACK), Err(BindError::Full));
        own.reset_all();
        assert_eq!(own, profile());
    }

    #[test]
    fn nobody_can_lock_the_menu_away() {
        let mut own = profile();
        let escape = Input::Key("Escape");
        assert_eq!(own.bind(Action::Jump, escape), Err(BindError::WayOut));
        let space = Input::Key("Space");
        let swapped = own.rebind(Action::Jump, space, escape);
        assert_eq!(swapped, Err(BindError::WayOut));
        let kept = Err(BindError::MenuKeepsWayOut);
        assert_eq!(own.unbind(Action::Menu, escape), kept);
        assert_eq!(own.rebind(Action::Menu, escape, KEY_J), kept);
        assert_eq!(own.bind(Action::Menu, KEY_J), Ok(()));
        own.put(Action::Menu, &[]);
        assert_eq!(own.inputs(Action::Menu), [escape]);
        own.put(Action::Jump, &[escape, KEY_J, KEY_J]);
        assert_eq!(own.inputs(Action::Jump), [KEY_J]);
    }
}
