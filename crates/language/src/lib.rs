//! The words of the game: [Fluent](https://projectfluent.org) messages in five languages.
//!
//! [`Texts`] are the messages of one language, embedded from `assets/locales/<id>/*.ftl`. What a language
//! lacks is said in English, and what English lacks is said as its bare key, so that no gap ends the game.
//!
//! Keys are written out where they are used, so that a test can find those that do not exist and those that
//! nobody needs. A key made at run time is a literal prefix that ends in a hyphen, and one value after it:
//! `texts.say(&format!("setting-{id}"))`; all keys with that prefix then count as used.

mod language;
mod locales;
mod texts;
mod value;

pub use language::Language;
pub use texts::Texts;
pub use value::Value;
