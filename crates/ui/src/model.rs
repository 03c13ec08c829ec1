//! What the menus are shown and what they give back: plain data, no behaviour.

/// The space a new world is made in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GeometryChoice {
    /// Constant negative curvature.
    #[default]
    Hyperbolic,
    /// No curvature.
    Euclidean,
    /// Constant positive curvature: a finite world of two hemispheres.
    Spherical,
}

impl GeometryChoice {
    /// Every choice, in the order in which the cards stand.
    pub const ALL: [Self; 3] = [Self::Hyperbolic, Self::Euclidean, Self::Spherical];

    /// The name on the card.
    pub fn label(self) -> &'static str {
        match self {
            Self::Hyperbolic => "Hyperbolic",
            Self::Euclidean => "Euclidean",
            Self::Spherical => "Spherical",
        }
    }

    /// The lower-case word that the command line, scripts and saves use.
    pub fn id(self) -> &'static str {
        match self {
            Self::Hyperbolic => "hyperbolic",
            Self::Euclidean => "euclidean",
            Self::Spherical => "spherical",
        }
    }

    /// One sentence for somebody who has never heard the word.
    pub fn description(self) -> &'static str {
        match self {
            Self::Hyperbolic => "Space fans out: the land drops away and everything far is small.",
            Self::Euclidean => "Flat space, endless and familiar.",
            Self::Spherical => "A small closed world: the land climbs and meets overhead.",
        }
    }
}

/// One world in the Load and Delete lists, already put into words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldRow {
    /// The directory name, which intents carry back.
    pub slug: String,
    /// The player's name for it.
    pub name: String,
    /// Its space, e.g. "Spherical".
    pub geometry: String,
    /// Time played, e.g. "12 min".
    pub played: String,
    /// Date of last play.
    pub last_played: String,
    /// Size on disk, e.g. "1.2 MB".
    pub size: String,
    /// Why it cannot be loaded, as a sentence; `None` when it is well.
    pub problem: Option<String>,
    /// Whether this is the world being played.
    pub running: bool,
}

/// One line of the Controls screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// What happens, e.g. "Jump".
    pub action: String,
    /// The keys in words, e.g. "Space".
    pub keys: String,
    /// The heading it stands under; groups keep the order of their first line.
    pub group: String,
}

/// Everything the menus show in one frame.
pub struct MenuModel<'a> {
    /// Name of the world behind the menu: it stays visible, dimmed. `None`
    /// (also while one is being loaded) puts our own backdrop there.
    pub running_world: Option<&'a str>,
    /// All worlds, newest first.
    pub worlds: &'a [WorldRow],
    /// All key bindings.
    pub bindings: &'a [Binding],
    /// Whether a new world may bear this name; the error is a sentence.
    pub check_name: &'a dyn Fn(&str) -> Result<(), String>,
    /// Something to know about the graphics device, e.g. that it is software.
    pub adapter_notice: Option<&'a str>,
    /// The game's version.
    pub version: &'a str,
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
    /// The key bindings.
    Controls,
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
    /// Save, close the world, come back to the main menu.
    SaveAndQuitToMenu,
    /// Make a world and enter it.
    NewGame {
        /// Checked by [`MenuModel::check_name`], without surrounding blanks.
        name: String,
        /// Its space.
        geometry: GeometryChoice,
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
