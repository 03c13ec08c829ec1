//! The ways of drawing figures.

use wgpu::RenderPipeline;

use crate::figure_buffers::{skin_layout, vertex_layout};
use crate::pipelines::{BENT, GLASS, Maker, SOLID, instances};
use crate::renderer::Preset;
use crate::shaders::FIGURE;
use crate::uniforms::FigureInstance;

/// The ways of drawing figures.
#[derive(Debug)]
pub struct FigurePipelines {
    /// Ported by vertex.
    pub plain: RenderPipeline,
    /// Ported as a whole.
    pub framed: RenderPipeline,
    /// Bent by a skeleton, and ported by vertex.
    pub bent: RenderPipeline,
    /// Bent by a skeleton, and ported as a whole.
    pub bent_framed: RenderPipeline,
    /// What light goes through, ported by vertex.
    pub clear: RenderPipeline,
    /// The same, ported as a whole.
    pub clear_framed: RenderPipeline,
    /// In the player's hand.
    pub hand: RenderPipeline,
    /// The same where no lamp or beam shines, if that has a pipeline of its own.
    pub unlit_hand: Option<RenderPipeline>,
    /// In the player's hand, of what light goes through.
    pub hand_clear: RenderPipeline,
    /// Into a shadow map.
    pub caster: RenderPipeline,
    /// Bent by a skeleton, into a shadow map.
    pub bent_caster: RenderPipeline,
}

impl FigurePipelines {
    pub(crate) fn made_by(maker: &Maker<'_>) -> Self {
        let module = maker.compile(FIGURE);
        let instances = instances::<FigureInstance>(&FigureInstance::ATTRIBUTES);
        let buffers = [vertex_layout(), instances, skin_layout()];
        let plain =
            |vertex, fragment, way| maker.make(&module, [vertex, fragment], &buffers[..2], way);
        // It is before the eye, and not in the world that is cut.
        let whole = maker.uncut();
        let hand = |maker: &Maker<'_>, fragment, way| {
            maker.make(&module, ["vertex_hand", fragment], &buffers[..2], way)
        };
        let bent = |vertex| maker.make(&module, [vertex, "fragment"], &buffers, BENT);
        Self {
            plain: plain("vertex", "fragment", SOLID),
            framed: plain("vertex_framed", "fragment", SOLID),
            bent: bent("vertex_bent"),
            bent_framed: bent("vertex_bent_framed"),
            clear: plain("vertex", "fragment_clear", GLASS),
            clear_framed: plain("vertex_framed", "fragment_clear", GLASS),
            hand: hand(&whole, "fragment", SOLID),
            unlit_hand: (maker.preset == Preset::Software)
                .then(|| hand(&whole.unlit(), "fragment", SOLID)),
            hand_clear: hand(&whole, "fragment_clear", GLASS),
            caster: maker.figure_caster(&module, "vertex_caster", &buffers[..2]),
            bent_caster: maker.figure_caster(&module, "vertex_caster_bent", &buffers),
        }
    }
}
