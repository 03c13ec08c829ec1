//! The workshop: the document behind a room editor.
//!
//! A [`Document`] is a room that is being changed. Whatever changes it is an [`Edit`], and there is no other way: the window's
//! handles and lists, and the words of scripts and of the console ([`words`]). What an edit makes of a room is in [`make()`];
//! its way back is the exact difference of both rooms ([`Delta`]), so that undo leaves every bit as it was. A document that is
//! kept in a folder has a journal beside `room.ron`, from which all of that comes back after a restart, however it came about.
//!
//! There is no window, no picture and no GPU here.

mod checks;
mod clip;
mod copies;
pub mod delta;
mod document;
mod drag;
mod edit;
mod error;
mod history;
mod journal;
mod keeping;
mod make;
mod marking;
mod marks;
mod place;
mod plan;
mod room_fields;
mod said;
mod telling;
mod versions;
pub mod words;

pub use checks::{Checker, FINDINGS, Finding, Findings, find as find_in};
pub use clip::Clip;
pub use copies::closure;
pub use delta::Delta;
pub use document::Document;
pub use edit::{Array, Edit, Field, Placed};
pub use error::WorkshopError;
pub use history::{History, LEAST_STEPS, Step};
pub use journal::{FOLDER, Opened, Pace, is_in_use};
pub use keeping::Trouble;
pub use make::{MOST_COPIES, make};
pub use marking::Marked;
pub use marks::Marks;
pub use place::turn_of;
pub use plan::Plan;
pub use room_fields::fields_of;
pub use said::{Arg, Said};
pub use telling::STEPS;
pub use versions::{Version, read_version, versions};
