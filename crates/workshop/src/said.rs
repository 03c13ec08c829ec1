//! What is told of a step or a finding: the id of a message and what is put into it, so that it can be said in any language.

use serde::{Deserialize, Serialize};

/// A sentence that is not in any language yet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Said {
    /// The id of its message, as `move`; [`crate::STEPS`] has those of steps, [`crate::FINDINGS`] those of findings.
    pub id: String,
    /// What is put into it, each under its name.
    pub args: Vec<(String, Arg)>,
}

/// Something that is put into a message.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Arg {
    /// A number, by which plural forms are chosen.
    Number(f64),
    /// A text, as it is: names of objects, words of commands.
    Text(String),
}

impl Said {
    /// A message with nothing in it.
    pub fn new(id: &str) -> Self {
        Self {
            id: id.to_owned(),
            args: Vec::new(),
        }
    }

    /// The same with a text in it.
    #[must_use]
    pub fn with(mut self, name: &str, text: impl Into<String>) -> Self {
        self.args.push((name.to_owned(), Arg::Text(text.into())));
        self
    }

    /// The same with a number in it.
    #[must_use]
    pub fn with_number(mut self, name: &str, number: f64) -> Self {
        self.args.push((name.to_owned(), Arg::Number(number)));
        self
    }

    /// Of objects: the name of the first as `name`, and how many there are as `count`.
    pub(crate) fn of(id: &str, names: &[String]) -> Self {
        Self::new(id)
            .with("name", names.first().cloned().unwrap_or_default())
            .with_number("count", names.len() as f64)
    }
}
