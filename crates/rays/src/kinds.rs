//! What shaders are told before they are compiled, so that what is not there takes no time.

use antipode_deformation::{Sides, Space, Stack, Ways};

use crate::crowd::is_crowd;
use crate::packed::Rule;

/// What there is in a space, as the constants of shaders/rays have it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kinds {
    /// Whether there are boxes of *snell*.
    snell: bool,
    /// Whether there are boxes of *legacy*.
    legacy: bool,
    portals: bool,
    /// Whether movers may be cut.
    cuts: bool,
    /// Whether nothing is felt to be stretched.
    flat: bool,
    /// Whether it matters which faces light passes.
    pub(crate) faces: bool,
    /// Whether boxes can be entered from within others.
    nests: bool,
    /// Whether some boxes are felt one way only.
    headings: bool,
    /// Whether so many boxes can be entered from one place that there is a tree of them.
    crowds: bool,
    /// Whether outlines of boxes are drawn.
    outlines: bool,
}

impl Kinds {
    /// All that there may be.
    pub const ALL: Self = Self {
        snell: true,
        legacy: true,
        portals: true,
        cuts: true,
        flat: false,
        faces: true,
        nests: true,
        headings: true,
        crowds: true,
        outlines: true,
    };
    /// How many there are.
    pub const COUNT: usize = 1 << Self::ALL.constants().len();

    /// Of a space by a rule.
    pub fn of(space: &Space, rule: Rule) -> Self {
        let portals = !space.portals().is_empty();
        let flat = !portals && (rule == Rule::Plain || space.placed().is_empty());
        let mut kinds = Self {
            portals,
            cuts: portals,
            flat,
            faces: !flat,
            crowds: is_crowd(space.entrances(&Stack::default())),
            ..Self::default()
        };
        for placed in space.placed() {
            let it = rule.of(placed).aberration;
            kinds.faces |= (0..3).any(|axis| it.is_wall(axis));
            kinds.nests |= !placed.neighbours.is_empty();
            kinds.crowds |= is_crowd(&placed.neighbours);
            kinds.headings |= it.ways != Ways::Both;
            kinds.snell |= it.sides == Sides::Snell;
            kinds.legacy |= matches!(it.sides, Sides::Legacy(_));
        }
        kinds
    }

    /// The same where movers may be cut.
    pub fn with_cuts(self, are_cut: bool) -> Self {
        Self {
            cuts: self.cuts || are_cut,
            ..self
        }
    }

    /// The same where outlines are drawn, which are seen in faces.
    pub fn with_outlines(self, are_drawn: bool) -> Self {
        Self {
            faces: self.faces || are_drawn,
            outlines: are_drawn,
            ..self
        }
    }

    /// A number below [`Self::COUNT`].
    pub fn number(self) -> usize {
        let bits = self.constants().into_iter().enumerate();
        bits.map(|(bit, (_, it))| usize::from(it) << bit).sum()
    }

    /// The shaders' constants.
    pub const fn constants(self) -> [(&'static str, bool); 10] {
        [
            ("HAS_SNELL", self.snell),
            ("HAS_LEGACY", self.legacy),
            ("HAS_PORTALS", self.portals),
            ("HAS_CUTS", self.cuts),
            ("IS_FLAT", self.flat),
            ("HAS_FACES", self.faces),
            ("HAS_NESTS", self.nests),
            ("HAS_HEADINGS", self.headings),
            ("HAS_CROWDS", self.crowds),
            ("HAS_OUTLINES", self.outlines),
        ]
    }
}
