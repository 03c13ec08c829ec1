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
    /// Looking up to the land overhead, in a closed world.
    Overhead,
    /// Talking.
    Talk,
    /// Getting into a car.
    Car,
    /// Digging.
    Dig,
    /// Building.
    Build,
    /// Turning the picture's dial.
    Curve,
    /// Changing to the space's other picture.
    Map,
    /// Seeing oneself from behind.
    Camera,
    /// Switching the flashlight.
    Light,
    /// Opening the backpack.
    Backpack,
    /// The photo mode.
    Photo,
    /// Walking over the equator and straight on until one is home, in a closed world.
    Home,
    /// The menu.
    Menu,
}

impl Lesson {
    /// All, in the order in which they are told.
    pub const ALL: [Self; 16] = [
        Self::Look,
        Self::Walk,
        Self::Jump,
        Self::Overhead,
        Self::Talk,
        Self::Car,
        Self::Dig,
        Self::Build,
        Self::Curve,
        Self::Map,
        Self::Camera,
        Self::Light,
        Self::Backpack,
        Self::Photo,
        Self::Home,
        Self::Menu,
    ];

    /// Its name in the file.
    pub fn id(self) -> &'static str {
        match self {
            Self::Look => "look",
            Self::Walk => "walk",
            Self::Jump => "jump",
            Self::Overhead => "overhead",
            Self::Talk => "talk",
            Self::Car => "car",
            Self::Dig => "dig",
            Self::Build => "build",
            Self::Curve => "curve",
            Self::Map => "map",
            Self::Camera => "camera",
            Self::Light => "light",
            Self::Backpack => "backpack",
            Self::Photo => "photo",
            Self::Home => "home",
            Self::Menu => "menu",
        }
    }

    /// The lesson of that name.
    pub fn named(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|lesson| lesson.id() == id)
    }
}
