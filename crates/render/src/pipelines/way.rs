//! The ways in which something meets what is drawn already: depth, blending, sides.

use wgpu::{BlendComponent, BlendFactor, BlendOperation, BlendState, CompareFunction};

/// How something meets what is drawn already.
#[derive(Clone, Copy)]
pub(crate) struct Way {
    pub(super) compare: CompareFunction,
    pub(super) writes_depth: bool,
    pub(super) blend: Option<BlendState>,
    pub(super) culled: bool,
    /// Whether joints bend it.
    pub(super) bends: bool,
    /// Whether it shows light that was drawn before.
    pub(super) opens: bool,
}

/// What hides what lies behind it.
pub(crate) const SOLID: Way = Way {
    compare: CompareFunction::Greater,
    writes_depth: true,
    blend: None,
    culled: true,
    bends: false,
    opens: false,
};

/// The opening of a door.
pub(super) const OPEN: Way = Way {
    culled: false,
    opens: true,
    ..SOLID
};

/// The same of what joints bend.
pub(crate) const BENT: Way = Way {
    bends: true,
    ..SOLID
};

/// Colours come multiplied by their opacity.
pub(crate) const GLASS: Way = Way {
    compare: CompareFunction::GreaterEqual,
    writes_depth: false,
    blend: Some(BlendState::PREMULTIPLIED_ALPHA_BLENDING),
    culled: true,
    bends: false,
    opens: false,
};

/// Added where nothing nearer stands, as far as clouds let it through: `sky.wgsl` puts that into the alpha, which is 1
/// elsewhere.
pub(super) const SHINE: Way = Way {
    compare: CompareFunction::GreaterEqual,
    writes_depth: false,
    blend: Some(BlendState {
        color: BlendComponent {
            src_factor: BlendFactor::DstAlpha,
            dst_factor: BlendFactor::One,
            operation: BlendOperation::Add,
        },
        alpha: BlendComponent {
            src_factor: BlendFactor::Zero,
            dst_factor: BlendFactor::One,
            operation: BlendOperation::Add,
        },
    }),
    culled: false,
    bends: false,
    opens: false,
};

/// Laid over what is infinitely far.
pub(crate) const VEIL: Way = Way {
    culled: false,
    ..GLASS
};
