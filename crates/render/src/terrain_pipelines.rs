//! The ways of drawing land, and their numbers.

use wgpu::{RenderPipeline, ShaderModule, VertexBufferLayout};

use crate::pipelines::{Maker, SOLID};
use crate::plan::{ChunkChoice, DepthMethod, Port};
use crate::shadow::ShadowQuality;

/// What may throw a shadow of the key light on some land.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ShadowReach {
    /// Land and figures.
    #[default]
    All,
    /// Land only.
    Land,
    /// Nothing: no map shows it.
    Nothing,
}

impl ShadowReach {
    const ALL: [Self; 3] = [Self::All, Self::Land, Self::Nothing];
}

/// The ways of drawing land: a set for each reach of shadows where the adapter pays for branches that it does not
/// take, else one for all.
#[derive(Debug)]
pub struct TerrainPipelines {
    sets: Vec<Set>,
}

/// The ways of drawing land with one reach of shadows.
#[derive(Debug)]
struct Set {
    /// Ported by vertex.
    plain: RenderPipeline,
    /// The same, trimmed at the edge of its chart.
    rim: RenderPipeline,
    /// Each fragment with its own depth.
    deep: RenderPipeline,
    /// The same, trimmed.
    deep_rim: RenderPipeline,
    /// Ported as a whole.
    framed: RenderPipeline,
    /// Some of the pixels of a mesh ported by vertex, trimmed.
    blending: RenderPipeline,
    /// The same, each fragment with its own depth.
    deep_blending: RenderPipeline,
    /// Some of the pixels of a mesh ported as a whole.
    framed_blending: RenderPipeline,
}

/// Ways of a set.
const WAYS: u8 = 8;

impl TerrainPipelines {
    pub(crate) fn made_by(
        maker: &Maker<'_>,
        module: &ShaderModule,
        buffers: &[VertexBufferLayout<'_>],
    ) -> Self {
        let sets = if maker.shadows == ShadowQuality::Low {
            &ShadowReach::ALL[..]
        } else {
            &ShadowReach::ALL[..1]
        };
        let set = |reach: &ShadowReach| Set::made_by(&maker.reached(*reach), module, buffers);
        Self {
            sets: sets.iter().map(set).collect(),
        }
    }

    /// The number of the pipeline of a choice, where `blends` says that only some of the pixels are drawn. What is
    /// mostly nearer has lower numbers.
    pub fn number(choice: &ChunkChoice, blends: bool, reach: ShadowReach) -> u8 {
        let deep = choice.depth == DepthMethod::Fragment;
        let way = match (&choice.port, deep, choice.trimmed, blends) {
            (Port::Vertex, false, false, false) => 0,
            (Port::Vertex, false, true, false) => 1,
            (Port::Vertex, true, false, false) => 2,
            (Port::Vertex, true, true, false) => 3,
            (Port::Frame(_), .., false) => 4,
            (Port::Vertex, false, _, true) => 5,
            (Port::Vertex, true, _, true) => 6,
            (Port::Frame(_), .., true) => 7,
        };
        WAYS * reach as u8 + way
    }

    /// The pipeline of a number; that for all shadows where there is none of its own.
    pub fn numbered(&self, number: u8) -> &RenderPipeline {
        let set = self.sets.get(usize::from(number / WAYS));
        let set = set.unwrap_or(&self.sets[0]);
        match number % WAYS {
            0 => &set.plain,
            1 => &set.rim,
            2 => &set.deep,
            3 => &set.deep_rim,
            4 => &set.framed,
            5 => &set.blending,
            6 => &set.deep_blending,
            _ => &set.framed_blending,
        }
    }
}

impl Set {
    fn made_by(
        maker: &Maker<'_>,
        module: &ShaderModule,
        buffers: &[VertexBufferLayout<'_>],
    ) -> Self {
        let terrain = |vertex, fragment| maker.make(module, [vertex, fragment], buffers, SOLID);
        Self {
            plain: terrain("vertex", "fragment"),
            rim: terrain("vertex", "fragment_rim"),
            deep: terrain("vertex", "fragment_deep"),
            deep_rim: terrain("vertex", "fragment_deep_rim"),
            framed: terrain("vertex_framed", "fragment"),
            blending: terrain("vertex", "fragment_blending"),
            deep_blending: terrain("vertex", "fragment_deep_blending"),
            framed_blending: terrain("vertex_framed", "fragment_blending"),
        }
    }
}
