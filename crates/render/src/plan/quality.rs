//! The three points on the frontier between speed and accuracy that a player can choose.

use antipode_frame::Quality;

/// What a quality lets pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Whether land behind the skyline of nearer land is left out, and blocks of near land out of the picture.
    pub hides: bool,
    /// Land that rises over the skyline by less than this is left out, pixels.
    pub small_px: f64,
    /// Edges and frames may stray from their true picture by this, pixels.
    pub shape_px: f64,
    /// How often an edge may be halved to keep to that.
    pub halvings: u32,
    /// Depth inside a triangle may be wrong by this, metres of sight, before each fragment finds its own.
    pub depth_m: f64,
}

impl Tolerance {
    /// What each quality lets pass. `docs/accuracy.md` has the measurements behind the numbers.
    ///
    /// `Exact` trusts no bound: it draws what is hidden too, so that the others can be checked against it.
    pub fn of(quality: Quality) -> Self {
        match quality {
            Quality::Fast => Self {
                hides: true,
                small_px: 1.0,
                shape_px: 2.0,
                halvings: 0,
                depth_m: f64::INFINITY,
            },
            Quality::Balanced => Self {
                hides: true,
                small_px: 0.5,
                shape_px: 0.5,
                halvings: 5,
                depth_m: 0.1,
            },
            Quality::Exact => Self {
                hides: false,
                small_px: 0.0,
                shape_px: 0.125,
                halvings: 6,
                depth_m: 0.001,
            },
        }
    }
}
