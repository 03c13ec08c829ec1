//! What newcomers are taught, thing by thing, as `assets/tables/hints.ron` says, so that the file can keep what they have done
//! already.

use crate::action::{Action, actions};

antipode_tables::hints!();

/// What the table says of a lesson.
struct Row {
    id: &'static str,
    needs: Needs,
    done: Done,
    read_s: Option<f64>,
    keys: &'static [(&'static str, &'static [Action])],
    mouse: Option<&'static str>,
    pad: Option<&'static str>,
}

/// What a world needs that something is taught in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// It is taught in every world.
    Nothing,
    /// A dial of the picture.
    Dial,
    /// Another picture of the space.
    OtherPicture,
    /// A way round that leads home.
    Closed,
    /// Squares, five of which meet at every corner.
    Squares,
    /// That what is built is gathered first.
    Gathering,
    /// That it is dark where the player is.
    Dark,
}

/// What ends a lesson.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Done {
    /// The view was turned by so much in all, radians.
    Turned(f64),
    /// So long a walk in all, seconds.
    Walked(f64),
    /// A view so far above the level, radians.
    LookedUp(f64),
    /// A way through so many squares, back into the first of them.
    Rounded(usize),
    /// So much digging in all, seconds.
    Dug(f64),
    /// So much building in all, seconds.
    Built(f64),
    /// One of its actions was used.
    Asked,
    /// Nothing but time.
    Read,
}

impl Lesson {
    fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// Its word.
    pub fn id(self) -> &'static str {
        self.row().id
    }

    /// What a word means, if anything.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|lesson| lesson.id() == id)
    }

    /// What a world needs that it is taught there.
    pub fn needs(self) -> Needs {
        self.row().needs
    }

    /// What ends it.
    pub fn done(self) -> Done {
        self.row().done
    }

    /// For how long it is shown at most to somebody who does not do what it says, seconds.
    pub fn read_s(self) -> Option<f64> {
        self.row().read_s
    }

    /// The actions whose inputs it names, by the arguments of its words.
    pub fn keys(self) -> &'static [(&'static str, &'static [Action])] {
        self.row().keys
    }

    /// The key of the words of what it names of a mouse or, in place of that, of a gamepad.
    pub fn device(self, by_pad: bool) -> Option<&'static str> {
        let row = self.row();
        if by_pad { row.pad } else { row.mouse }
    }

    /// Whether it ends when an action is used.
    pub fn is_asked_by(self, action: Action) -> bool {
        let mut named = self.keys().iter().flat_map(|(_, actions)| *actions);
        self.done() == Done::Asked && named.any(|named| *named == action)
    }
}

/// The action of that name, found while the table is compiled.
#[expect(clippy::panic, reason = "this ends the build, never the game")]
const fn action(id: &str, wrong: &str) -> Action {
    let (actions, mut place) = (actions(), 0);
    while place < actions.len() {
        if is_same(actions[place].id.as_bytes(), id.as_bytes()) {
            return actions[place].action;
        }
        place += 1;
    }
    panic!("{}", wrong)
}

/// Whether two texts are the same, which `==` cannot say while code is compiled.
const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut place = 0;
    while place < a.len() && place < b.len() && a[place] == b[place] {
        place += 1;
    }
    place == a.len() && place == b.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lessons_have_words_of_their_own_and_name_the_actions_of_the_table() {
        for lesson in Lesson::ALL {
            assert_eq!(Lesson::from_id(lesson.id()), Some(lesson));
        }
        assert_eq!(Lesson::from_id("fly"), None);
        assert_eq!(action("enter-car", ""), Action::EnterCar);
        let ends_with = |action| {
            Lesson::ALL
                .into_iter()
                .filter(move |it| it.is_asked_by(action))
        };
        assert!(ends_with(Action::DialDown).eq([Lesson::Curve]));
        // It is used, but for long enough.
        assert_eq!(ends_with(Action::Use).count(), 0);
    }
}
