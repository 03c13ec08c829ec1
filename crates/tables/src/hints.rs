//! The rows of `assets/tables/hints.ron`.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::reader::{Assets, Fault, Row, need};
use crate::source::{Names, Source};

/// What the fields are, the head of the table says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Hint {
    id: String,
    what: String,
    #[serde(default)]
    needs: Needs,
    done: Done,
    #[serde(default)]
    read_s: Option<f64>,
    #[serde(default)]
    keys: BTreeMap<String, Vec<String>>,
    #[serde(default)]
    mouse: Option<String>,
    #[serde(default)]
    pad: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
enum Needs {
    #[default]
    Nothing,
    Dial,
    OtherPicture,
    Closed,
    Squares,
    Gathering,
    Dark,
}

#[derive(Debug, Deserialize)]
enum Done {
    Turned(f64),
    Walked(f64),
    LookedUp(f64),
    Rounded(usize),
    Dug(f64),
    Built(f64),
    Asked,
    Read,
}

impl Hint {
    fn actions(&self) -> impl Iterator<Item = &String> {
        self.keys.values().flatten()
    }
}

impl Row for Hint {
    const FILE: &'static str = "assets/tables/hints.ron";

    fn id(&self) -> &str {
        &self.id
    }

    fn check(&self, _: Assets<'_>) -> Result<(), Fault> {
        let is_while = self.read_s.is_none_or(|time_s| time_s > 0.0);
        need("read_s", is_while, "is to be more than 0")?;
        match self.done {
            Done::Turned(most)
            | Done::Walked(most)
            | Done::LookedUp(most)
            | Done::Dug(most)
            | Done::Built(most) => need("done", most > 0.0, "is to be more than 0"),
            Done::Rounded(most) => need("done", most > 2, "is to be more than 2"),
            Done::Asked => {
                let is_asked = self.actions().next().is_some();
                need(
                    "done",
                    is_asked,
                    "is Asked, and keys names nothing to ask for",
                )
            }
            Done::Read => {
                let is_read = self.read_s.is_some();
                need(
                    "done",
                    is_read,
                    "is Read, and read_s does not say for how long",
                )
            }
        }
    }
}

impl Source for Hint {
    const NAMES: Option<Names> = Some(Names {
        name: "Lesson",
        about: "Something to do for the first time.",
        derives: "PartialOrd, Ord",
        is_written: false,
        list: ("ALL", "Every lesson, in the order in which they are given."),
        other: "",
    });

    fn what(&self) -> &str {
        &self.what
    }

    fn expression(&self, told: &dyn Fn(&Fault) -> String) -> String {
        let action = |id: &String| {
            let wrong = format!("names {id:?}, and there is no such action");
            let field = "keys";
            format!("action({id:?}, {:?}), ", told(&Fault { field, wrong }))
        };
        let keys = self.keys.iter().map(|(argument, ids)| {
            let actions: String = ids.iter().map(action).collect();
            format!("({argument:?}, &[{actions}]), ")
        });
        let keys: String = keys.collect();
        format!(
            "Row {{ id: {:?}, needs: Needs::{:?}, done: Done::{:?}, read_s: {:?}, keys: &[{keys}], mouse: {:?}, pad: {:?} }}",
            self.id, self.needs, self.done, self.read_s, self.mouse, self.pad
        )
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use crate::reader::read;
    use crate::reader::testing::refuses;

    const TWO: &str = r#"[
  (id: "look", what: "Looking.", done: Turned(0.7), mouse: "key-Mouse", pad: "hints-stick"),
  (
    id: "home",
    what: "Walking home.",
    needs: Closed,
    done: Asked,
    read_s: 15,
    keys: {"key": ["forward"]},
  ),
]"#;

    #[test]
    fn an_unsound_hint_is_told_by_file_line_and_field() {
        refuses::<Hint>(
            TWO,
            &[
                ("0.7", "0", "2: done of \"look\" is to be more than 0"),
                ("0.7", "NaN", "2: done of \"look\" is to be a number"),
                (
                    "\"home\"",
                    "\"look\"",
                    "4: id of \"look\" is the id of an earlier row, too",
                ),
                ("Closed", "Sphere", "6: needs of \"home\": Unexpected "),
                (
                    "\"forward\"",
                    "",
                    "7: done of \"home\" is Asked, and keys names nothing",
                ),
                (
                    "done: Asked",
                    "done: Someday",
                    "7: done of \"home\": Unexpected ",
                ),
                (
                    "Asked,\n    read_s: 15",
                    "Read",
                    "7: done of \"home\" is Read, and read_s does not say",
                ),
                (
                    "read_s: 15",
                    "read_s: -15",
                    "8: read_s of \"home\" is to be more than 0",
                ),
                (
                    "read_s: 15",
                    "shown_s: 15",
                    "8: \"home\": Unexpected field named `shown_s`",
                ),
                ("[\"forward\"]", "[7]", "9: keys of \"home\": "),
            ],
        );
    }

    #[test]
    fn the_compiler_is_told_what_to_say_of_an_action_that_does_not_exist() {
        let table = read::<Hint>(TWO, Assets(&|_| true)).unwrap();
        let code = crate::source::of(&table);
        let said = r#"assets/tables/hints.ron:9: keys of \"home\" names \"forward\", and there is no such action"#;
        assert!(
            code.contains(&format!("action(\"forward\", \"{said}\")")),
            "{code}"
        );
    }
}
