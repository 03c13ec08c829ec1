//! What the panes of the workshop show, and what the player asks for there: plain data.

use antipode_language::Texts;
use egui::Color32;

use super::array::ArrayForm;
use super::chooser::{ChooserModel, ChooserWish};
use super::lesson::LessonChoice;

/// Everything that the workshop shows in one frame.
pub struct WorkshopModel<'a> {
    /// The words of the player's language.
    pub texts: &'a Texts,
    /// What the room is called.
    pub room: &'a str,
    /// What stands in it, each behind the group that carries it.
    pub objects: &'a [ObjectRow],
    /// What is told of what is chosen: its name, or how many things.
    pub chosen: &'a str,
    /// What can be changed of it.
    pub fields: &'a [FieldRow],
    /// What can be put in.
    pub parts: &'a [PartRow],
    /// What is wrong with the room.
    pub messages: &'a [MessageRow],
    /// What was done, the first step first.
    pub history: &'a [HistoryRow],
    /// Older versions of the room, the newest first; none where they have not been asked for.
    pub older: Option<&'a [OlderRow]>,
    /// How many of these steps hold; those behind them were taken back.
    pub done: usize,
    /// What the bar shows.
    pub bar: BarModel,
    /// Lines over the view.
    pub lines: &'a [ViewLine],
    /// What stands at the lower end of the view.
    pub status: &'a str,
    /// What is to be done next in the lesson, if one is taken.
    pub lesson: Option<&'a LessonModel>,
    /// What is possible.
    pub examples: &'a [ExampleRow],
    /// From what a file is chosen, while one is.
    pub chooser: Option<&'a ChooserModel>,
}

/// A step of the lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct LessonModel {
    /// Which, from 1.
    pub number: usize,
    /// How many there are.
    pub of: usize,
    /// What is to be done, in a sentence.
    pub text: String,
    /// What it is done with.
    pub target: LessonTarget,
}

/// What a step of the lesson is done with.
#[derive(Clone, Debug, PartialEq)]
pub enum LessonTarget {
    /// That part.
    Part(String),
    /// That thing, in the list.
    Object(String),
    /// That field of the inspector.
    Field(String),
    /// That button of the bar.
    Do(&'static str),
    /// The view.
    View,
}

/// An example of what is possible.
#[derive(Clone, Debug, PartialEq)]
pub struct ExampleRow {
    /// What intents call it.
    pub id: String,
    /// What it is called.
    pub label: String,
    /// What is strange in it, in a sentence.
    pub about: String,
    /// Its picture.
    pub picture: Option<egui::TextureId>,
}

/// Something that stands in the room.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjectRow {
    /// Its name.
    pub name: String,
    /// What it is, in words.
    pub kind: String,
    /// In how many groups it is.
    pub depth: usize,
    /// Whether it carries others.
    pub is_group: bool,
    /// Whether it is chosen.
    pub selected: bool,
    /// Whether it is left out of the picture.
    pub hidden: bool,
    /// Whether it cannot be chosen in the view, nor changed.
    pub locked: bool,
}

/// What a number counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Metres.
    Metres,
    /// Degrees.
    Degrees,
    /// Times.
    Times,
    /// Nothing that has a name.
    Plain,
}

/// A number of a field, and what is known of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// It; none where those that are chosen differ.
    pub value: Option<f64>,
    /// Least and greatest.
    pub range: (f64, f64),
}

/// What kind of field it is.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldKind {
    /// One number or several.
    Numbers(Vec<Amount>, Unit),
    /// How many times as long space feels: on a logarithmic slider from 1/32 to 32.
    Stretch(Option<f64>),
    /// A colour; none where they differ.
    Colour(Option<[u8; 3]>),
    /// A text; none where they differ.
    Text(Option<String>),
    /// One of several words, each with what it is called; and which.
    Choice(Vec<(String, String)>, Option<usize>),
    /// On or off.
    Switch(Option<bool>),
    /// Nothing that can be changed: what something does, in words; and whether it is a warning.
    Words(String, bool),
}

/// A field of what is chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldRow {
    /// What intents call it.
    pub key: String,
    /// What it is called.
    pub label: String,
    /// What it does, in a sentence; empty where the word says it.
    pub about: String,
    /// What kind it is, and its value.
    pub kind: FieldKind,
    /// Whether it is as it is when nothing is said of it, or has no such value.
    pub is_default: bool,
}

/// A new value of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldValue {
    /// The number of that place.
    Number(usize, f64),
    /// A colour.
    Colour([u8; 3]),
    /// A text, or the word of a choice.
    Text(String),
    /// On or off.
    Switch(bool),
    /// What was typed and is no number.
    Misread(String),
}

/// Something that can be put in.
#[derive(Clone, Debug, PartialEq)]
pub struct PartRow {
    /// What intents call it.
    pub id: String,
    /// What it is called.
    pub label: String,
    /// What it is for, in a sentence.
    pub about: String,
    /// Its picture; one that has none is shown by its word alone.
    pub picture: Option<egui::TextureId>,
}

/// Something that is wrong with the room.
#[derive(Clone, Debug, PartialEq)]
pub struct MessageRow {
    /// In a sentence.
    pub text: String,
    /// Whether the room cannot be played so.
    pub is_grave: bool,
}

/// A step that was done.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryRow {
    /// What it did.
    pub text: String,
}

/// An older version of the room.
#[derive(Clone, Debug, PartialEq)]
pub struct OlderRow {
    /// What intents call it.
    pub when_s: u64,
    /// When it was written, in words.
    pub text: String,
}

/// What the handles do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ToolChoice {
    /// They move.
    #[default]
    Move,
    /// They turn.
    Turn,
    /// They make larger and smaller.
    Scale,
}

impl ToolChoice {
    /// All, in their order.
    pub const ALL: [Self; 3] = [Self::Move, Self::Turn, Self::Scale];

    /// Its word.
    pub fn id(self) -> &'static str {
        match self {
            Self::Move => "move",
            Self::Turn => "turn",
            Self::Scale => "scale",
        }
    }
}

/// A side to look from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewSide {
    /// From above.
    Top,
    /// From the front.
    Front,
    /// From the side.
    Side,
    /// As who begins there.
    Start,
}

impl ViewSide {
    /// All, in their order.
    pub const ALL: [Self; 4] = [Self::Top, Self::Front, Self::Side, Self::Start];

    /// Its word.
    pub fn id(self) -> &'static str {
        match self {
            Self::Top => "top",
            Self::Front => "front",
            Self::Side => "side",
            Self::Start => "start",
        }
    }
}

/// What the bar shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BarModel {
    /// The handles.
    pub tool: ToolChoice,
    /// Whether they go by the thing's own axes.
    pub own_axes: bool,
    /// Whether steps are held.
    pub snaps: bool,
    /// The grid, metres.
    pub grid_m: f64,
    /// Whether what is moved lies on what is seen under the pointer.
    pub on_surfaces: bool,
    /// Whether there is something to take back, and to do again.
    pub can_undo: bool,
    /// See [`Self::can_undo`].
    pub can_redo: bool,
    /// Whether something is chosen.
    pub has_chosen: bool,
    /// Whether something was copied.
    pub has_copied: bool,
    /// Whether keys fly the camera without a button held.
    pub flies: bool,
    /// Whether pictures begin with a raster.
    pub raster: bool,
    /// Whether all is seen along lines that are parallel.
    pub parallel: bool,
    /// Whether the walls that aberrations have are left out.
    pub hides_walls: bool,
}

/// A line over the view.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewLine {
    /// Its corners, from -1 at the left and the bottom to 1.
    pub points: Vec<[f32; 2]>,
    /// Its colour.
    pub colour: Color32,
    /// How wide it is, points.
    pub width: f32,
    /// What stands at its end.
    pub label: Option<String>,
    /// Whether its end has a knob.
    pub knob: bool,
}

/// What is done in the view. Places are from -1 at its left and its bottom to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewEvent {
    /// The pointer is there.
    Hover([f64; 2]),
    /// The pointer is elsewhere.
    Leave,
    /// The first button went down there.
    Grab([f64; 2]),
    /// The pointer has come there with the first button down. `free`: steps are not held.
    Pull {
        /// Where.
        at: [f64; 2],
        /// Whether steps are not held just now.
        free: bool,
    },
    /// The first button came up there. `adds`: to what is chosen.
    Let {
        /// Where.
        at: [f64; 2],
        /// Whether what is met is added to what is chosen, or taken from it.
        adds: bool,
        /// Whether the pointer has not moved since it went down.
        is_click: bool,
    },
    /// The view is turned where it is, by points to the right and down.
    Look([f64; 2]),
    /// It goes about what is looked at.
    Orbit([f64; 2]),
    /// It is moved along the picture.
    Pan([f64; 2]),
    /// The wheel, notches towards what is looked at.
    Zoom(f64),
    /// It flies ahead, to the right and up, each from -1 to 1, for so many seconds.
    Fly([f64; 3], f64, bool),
}

/// What the player asks for in the workshop.
#[derive(Clone, Debug, PartialEq)]
pub enum WorkshopWish {
    /// Something in the view.
    View(ViewEvent),
    /// That thing is chosen; `adds`: besides others, or no more.
    Choose {
        /// Its name.
        name: String,
        /// Whether others stay chosen.
        adds: bool,
    },
    /// All from the one chosen last to that one are chosen.
    ChooseTo(String),
    /// All is chosen, or nothing.
    ChooseAll(bool),
    /// That thing is left out of the picture, or not.
    Hide(String, bool),
    /// That thing is locked, or not.
    Lock(String, bool),
    /// It gets another name.
    Rename(String, String),
    /// A group carries it, or none.
    Carry(String, Option<String>),
    /// A field gets a value; `done`: the gesture is over, and is one step.
    Set {
        /// The field.
        key: String,
        /// Its value.
        value: FieldValue,
        /// Whether the hand has let go.
        done: bool,
    },
    /// A field is as it is when nothing is said of it.
    Reset(String),
    /// A part is put in before the camera.
    Put(String),
    /// The step before is taken back.
    Undo,
    /// It is done again.
    Redo,
    /// So many steps hold.
    GoTo(usize),
    /// What handles do.
    Tool(ToolChoice),
    /// Handles go by the thing's own axes, or by the room's.
    OwnAxes(bool),
    /// Steps are held, or not.
    Snaps(bool),
    /// The grid, metres.
    Grid(f64),
    /// What is moved lies on surfaces, or not.
    OnSurfaces(bool),
    /// Pictures begin with a raster, or not.
    Raster(bool),
    /// Keys fly the camera, or not.
    Flies(bool),
    /// One looks from that side, along parallel lines but from the start.
    Face(ViewSide),
    /// All is seen along parallel lines, or as an eye sees it.
    Parallel(bool),
    /// The walls that aberrations have are left out, or not.
    HideWalls(bool),
    /// One looks at what is chosen.
    Focus,
    /// What is chosen is copied.
    Copy,
    /// It is copied and taken away.
    Cut,
    /// What was copied is put in.
    Paste,
    /// What is chosen is doubled.
    Duplicate,
    /// The form comes up that says how what is chosen is repeated.
    AskArray,
    /// What is chosen is repeated in a row.
    Array(ArrayForm),
    /// What is chosen is carried by a new group.
    Group,
    /// Groups that are chosen are taken away, and what they carried stays.
    Ungroup,
    /// What is chosen is taken away.
    Delete,
    /// What is chosen is moved by steps to the right, up and towards who looks.
    Nudge([i8; 3]),
    /// Older versions of the room are looked for, or not shown any more.
    ShowOlder(bool),
    /// The older version of that time is taken in place of the room.
    OpenOlder(u64),
    /// What a message is about is chosen and looked at.
    ShowMessage(usize),
    /// The room is played from here.
    Play,
    /// What was built is saved at once.
    Keep,
    /// It is saved, and the menu comes up.
    Leave,
    /// A model or a picture is to be chosen from the disk.
    ChooseFile,
    /// Something while a file is chosen.
    Chooser(ChooserWish),
    /// A lesson is taken from its beginning.
    BeginLesson(LessonChoice),
    /// This step of the lesson is left out.
    SkipStep,
    /// The lesson is over.
    EndLesson,
}
