//! What one asks of a picture: how much is made of it, and by which rule one looks.

/// How much is made of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Mirrors and panes that light passes in a row, up to 4; with 0 mirrors show only the sky and panes are opaque.
    pub bounces: u32,
    /// Samples a pixel, 1 to 4.
    pub samples: u32,
    /// By which rule one looks.
    pub view: View,
    /// Of which aberrations the outlines are drawn.
    pub outlines: Outlines,
    /// Whether a raster finds what is seen first where it can, which is sooner; the picture is the same.
    pub raster: bool,
    /// Whether shaders that are compiled already are taken where they draw the same, though others are sooner.
    pub as_compiled: bool,
}

/// Of which aberrations the outlines are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outlines {
    /// Of none.
    Hidden,
    /// Of those that have one.
    #[default]
    Chosen,
    /// Of all.
    All,
}

impl Outlines {
    /// What comes next where a key goes round them.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::Chosen => Self::All,
            Self::All => Self::Hidden,
            Self::Hidden => Self::Chosen,
        }
    }
}

/// By which rule a picture shows aberrations. Who walks goes by the exact one always.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// As light goes.
    #[default]
    Exact,
    /// By the rule of J. L. Redondo Tello's thesis for all of them, with its faults.
    Thesis,
    /// The left half by the thesis's rule, the right half exact, and a line between.
    Split,
    /// In coordinates of the scene: aberrations are not felt, and only their walls are seen.
    Plain,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            bounces: 0,
            samples: 1,
            view: View::Exact,
            outlines: Outlines::default(),
            raster: false,
            as_compiled: false,
        }
    }
}
