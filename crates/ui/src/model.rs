//! The models that the menus show and the intents that they return: plain data, no behaviour.

use antipode_language::Texts;
use antipode_settings::{Config, Profiles, Value};

use crate::about::AboutModel;
use crate::worlds::{WorldFiles, WorldsIntent};

/// The space a new world is made in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GeometryChoice {
    /// Flat land, seen in a space of constant negative curvature.
    #[default]
    Hyperbolic,
    /// Constant negative curvature: land in squares, five about a corner.
    HyperbolicWorld,
    /// No curvature.
    Euclidean,
    /// Constant positive curvature: a finite world of two hemispheres.
    Spherical,
}

impl GeometryChoice {
    /// Every choice, in the order in which the cards stand.
    pub const ALL: [Self; 4] = [
        Self::Hyperbolic,
        Self::HyperbolicWorld,
        Self::Euclidean,
        Self::Spherical,
    ];

    /// The name on the card.
    pub fn label(self, texts: &Texts) -> String {
        texts.say(&format!("geometry-{}", self.id()))
    }

    /// The lower-case word that the command line, scripts and saves use.
    pub fn id(self) -> &'static str {
        match self {
            Self::Hyperbolic => "hyperbolic",
            Self::HyperbolicWorld => "hyperbolic-world",
            Self::Euclidean => "euclidean",
            Self::Spherical => "spherical",
        }
    }

    /// One sentence for somebody who has never heard the word.
    pub fn description(self, texts: &Texts) -> String {
        texts.say(&format!("geometry-{}-about", self.id()))
    }
}

/// How a new world is played.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ModeChoice {
    /// Everything is there from the start, and building costs nothing.
    #[default]
    Creative,
    /// What is dug is kept, and things are built and made of it.
    Gathering,
}

impl ModeChoice {
    /// Every choice, in the order in which the cards stand.
    pub const ALL: [Self; 2] = [Self::Creative, Self::Gathering];

    /// The name on the card.
    pub fn label(self, texts: &Texts) -> String {
        texts.say(&format!("mode-{}", self.id()))
    }

    /// The lower-case word that the command line, scripts and saves use.
    pub fn id(self) -> &'static str {
        match self {
            Self::Creative => "creative",
            Self::Gathering => "gathering",
        }
    }

    /// One sentence for somebody who has never heard the word.
    pub fn description(self, texts: &Texts) -> String {
        texts.say(&format!("mode-{}-about", self.id()))
    }
}

/// One world in the Load and Delete lists, or one room in theirs, already put into words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldRow {
    /// The directory name, which intents carry back.
    pub slug: String,
    /// The player's name for it, as it can be shown ([`crate::legible_name`]).
    pub name: String,
    /// The same as it is written, to be changed.
    pub full_name: String,
    /// What is strange in it, of a room, in one sentence.
    pub sentence: String,
    /// Whether it comes with the game, and can be copied only.
    pub shipped: bool,
    /// Its space, e.g. "Spherical"; of a world.
    pub geometry: String,
    /// How one plays in it, e.g. "Gathering"; nothing where everything is there from the start.
    pub mode: String,
    /// Time played, e.g. "12 min".
    pub played: String,
    /// Date of last play.
    pub last_played: String,
    /// Size on disk, e.g. "1.2 MB".
    pub size: String,
    /// Whether a command that cheats was ever used in it.
    pub cheated: bool,
    /// Why it cannot be loaded, as a sentence; `None` when it is well.
    pub problem: Option<String>,
    /// Whether this is the world being played.
    pub running: bool,
    /// Its picture, if it has one and it has been read; the game keeps it alive.
    pub picture: Option<egui::TextureId>,
    /// Its directory.
    pub path: String,
    /// How many chunks were changed by hand, `None` until it is known; of a room, how many objects it has.
    pub edits: Option<usize>,
    /// The file that an export is proposed to go to.
    pub export_to: String,
}

/// What stands behind the menus while no world is open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Backdrop {
    /// Whether a world is drawn there that nobody plays; else our own picture is painted.
    pub live: bool,
    /// How far it is faded to dark, 0 to 1.
    pub shade: f32,
}

/// Everything the menus show in one frame.
pub struct MenuModel<'a> {
    /// The words of the player's language.
    pub texts: &'a Texts,
    /// Whether what is behind the menu is a room, of which nothing is saved.
    pub in_room: bool,
    /// Whether that is a room of the player's own.
    pub own_room: OwnRoom,
    /// Name of the world or room behind the menu: it stays visible, dimmed. `None`
    /// (also while one is being loaded) puts our own backdrop there.
    pub running_world: Option<&'a str>,
    /// What stands behind the menus in its place.
    pub backdrop: Backdrop,
    /// All worlds, newest first.
    pub worlds: &'a [WorldRow],
    /// All rooms, the player's own first.
    pub rooms: &'a [WorldRow],
    /// The settings and key bindings that hold.
    pub config: &'a Config,
    /// Whether a new world may bear this name; the error is a sentence.
    pub check_name: &'a dyn Fn(&str) -> Result<(), String>,
    /// How fast one walks, metres a second.
    pub walk_m_s: f64,
    /// Whether the world of that directory may bear this name from now on; the error is a sentence.
    pub check_rename: &'a dyn Fn(&str, &str) -> Result<(), String>,
    /// The same of rooms.
    pub check_room_rename: &'a dyn Fn(&str, &str) -> Result<(), String>,
    /// What is known of worlds in files.
    pub world_files: &'a WorldFiles,
    /// The same of rooms.
    pub room_files: &'a WorldFiles,
    /// Something to know about the graphics device, e.g. that it is software.
    pub adapter_notice: Option<&'a str>,
    /// Why nothing can be heard, if so.
    pub sound_notice: Option<&'a str>,
    /// The game's version.
    pub version: &'a str,
    /// What the about screen tells.
    pub about: &'a AboutModel,
}

/// Whether a room of the player's own is behind the menu, and what is done in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OwnRoom {
    /// There is none.
    #[default]
    No,
    /// It is walked in.
    Walked,
    /// It is built in.
    Built,
}

/// Which screen is up.
#[derive(Clone, Debug, PartialEq)]
pub enum Screen {
    /// None: the player is in the world.
    Hidden,
    /// The main menu; with a world running, the pause menu.
    Main,
    /// The form for a new world.
    NewGame,
    /// The list of worlds to load.
    Load,
    /// The list of worlds to delete.
    Delete,
    /// The list of rooms.
    Rooms,
    /// The list of rooms of one's own, to build in them.
    Workshop,
    /// The settings.
    Settings,
    /// The key bindings.
    Controls,
    /// What the game is, draws with and is made of.
    About,
    /// Work in progress that the player waits for.
    Busy {
        /// What is being done, e.g. "Loading Foo".
        title: String,
        /// 0 to 1; `None` when it cannot be known.
        progress: Option<f32>,
        /// The present step in words; may be empty.
        detail: String,
    },
    /// Something to read and dismiss, e.g. an error.
    Message {
        /// What happened, in a few words.
        title: String,
        /// The rest, in sentences.
        text: String,
    },
    /// The world behind the menu could not be saved before leaving it: try again, stay, or lose what is unsaved.
    Unsaved {
        /// Why, in sentences.
        text: String,
    },
}

/// What the player asked for; the game carries it out.
#[derive(Clone, Debug, PartialEq)]
pub enum Intent {
    /// Go back into the world; the menu is closed already.
    Resume,
    /// Save and stay in the menu.
    Save,
    /// Save, close the world or leave the room, come back to the main menu.
    SaveAndQuitToMenu,
    /// Begins anew in the room behind the menu.
    BeginAnew,
    /// Make a world and enter it.
    NewGame {
        /// Checked by [`MenuModel::check_name`], without surrounding blanks.
        name: String,
        /// Its space.
        geometry: GeometryChoice,
        /// How it is played.
        mode: ModeChoice,
        /// `None` for a random one.
        seed: Option<u64>,
        /// 16 to 256 m, in spherical worlds only.
        radius_m: Option<f64>,
    },
    /// Enter a saved world.
    Load {
        /// [`WorldRow::slug`].
        slug: String,
    },
    /// Remove a world for good; the player has confirmed it.
    Delete {
        /// [`WorldRow::slug`].
        slug: String,
    },
    /// Something else about saved worlds.
    Worlds(WorldsIntent),
    /// Make a room and enter it.
    NewRoom,
    /// Make a room and build in it.
    BuildNewRoom,
    /// Build in the room behind the menu.
    BuildHere,
    /// Build in a room of one's own.
    BuildIn {
        /// [`WorldRow::slug`].
        slug: String,
    },
    /// Enter a room.
    EnterRoom {
        /// [`WorldRow::slug`].
        slug: String,
    },
    /// Remove a room for good; the player has confirmed it.
    DeleteRoom {
        /// [`WorldRow::slug`].
        slug: String,
    },
    /// Something else about rooms.
    Rooms(WorldsIntent),
    /// Give a setting a value that it takes; it is given also if it has it already.
    Set {
        /// The setting's id.
        id: &'static str,
        /// The value.
        value: Value,
    },
    /// Give a setting its default, by its id.
    ResetSetting(&'static str),
    /// Put these key bindings in use.
    Bind(Box<Profiles>),
    /// Leave the game.
    Quit,
    /// A message was read, or the player stays in an unsaved world; it is closed already.
    DismissMessage,
    /// Try once more to save and then go where the player was going.
    TrySavingAgain,
    /// Go where the player was going, without what could not be saved.
    LeaveUnsaved,
}

/// How a toast is coloured and how long it stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToastKind {
    /// Something done, 4 s.
    Info,
    /// How something stands now, 4 s; takes the place of the one before, which no longer holds.
    State,
    /// Something went wrong, 8 s.
    Problem,
}
