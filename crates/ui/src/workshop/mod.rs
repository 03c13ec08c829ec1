//! The workshop, in which rooms are built: its panes, which show a model and return wishes as all of the interface does.
//!
//! The panes are tiles that can be moved and sized, and come back as they were left. The view is the only one through which the
//! picture of the room is seen: the game draws it where [`WorkshopPanes::view_rect`] says.

mod array;
mod bar;
mod chooser;
mod colour;
mod examples;
mod field;
mod inspector;
mod keys;
mod layout;
mod lesson;
mod list;
mod model;
mod notes;
mod older;
mod panes;
mod parts;
mod view;

pub use array::ArrayForm;
pub use chooser::{ChooserEntry, ChooserModel, ChooserWish};
pub(crate) use keys::told_keys;
pub use keys::{SHORTCUTS, Shortcut};
pub use lesson::LessonChoice;
pub use model::{
    Amount, BarModel, ExampleRow, FieldKind, FieldRow, FieldValue, HistoryRow, LessonModel,
    LessonTarget, MessageRow, ObjectRow, OlderRow, PartRow, ToolChoice, Unit, ViewEvent, ViewLine,
    ViewSide, WorkshopModel, WorkshopWish,
};
pub use panes::WorkshopPanes;
