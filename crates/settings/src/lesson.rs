//! What newcomers are taught, thing by thing, so that the file can keep what they have done already.

/// Something to do for the first time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Lesson {
    /// Looking round.
    Look,
    /// Walking.
    Walk,
    /// Jumping.
    Jump,
    /// Digging.
    Dig,
    /// Building.
    Build,
    /// Turning the picture's dial.
    Curve,
    /// Opening the backpack.
    Backpack,
    /// The menu.
    Menu,
}

impl Lesson {
    /// All, in the order in which they are told.
    pub const ALL: [Self; 8] = [
        Self::Look,
        Self::Walk,
        Self::Jump,
        Self::Dig,
        Self::Build,
        Self::Curve,
        Self::Backpack,
        Self::Menu,
    ];

    /// Its name in the file.
    pub fn id(self) -> &'static str {
        match self {
            Self::Look => "look",
            Self::Walk => "walk",
            Self::Jump => "jump",
            Self::Dig => "dig",
            Self::Build => "build",
            Self::Curve => "curve",
            Self::Backpack => "backpack",
            Self::Menu => "menu",
        }
    }

    /// The lesson of that name.
    pub fn named(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|lesson| lesson.id() == id)
    }
}
