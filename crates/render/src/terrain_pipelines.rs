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

/// The ways of drawing land: all of them for what any shadow may reach and, where the adapter pays for branches that it
/// does not take, those that most of a picture is drawn by for the rest. Each takes a software adapter a tenth of a
/// second and some megabytes, so there are no more.
#[derive(Debug)]
pub struct TerrainPipelines {
    all: Set,
    land: Few,
    nothing: Few,
}

/// Some of the ways, with less than all shadows.
#[derive(Debug, Default)]
struct Few {
    plain: Option<RenderPipeline>,
    rim: Option<RenderPipeline>,
}

/// The ways of drawing land.
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

/// All ways, and those of [`Few`], which come first.
const WAYS: u8 = 8;
const FEW: u8 = 2;

impl TerrainPipelines {
    pub(crate) fn made_by(
        maker: &Maker<'_>,
        module: &ShaderModule,
        buffers: &[VertexBufferLayout<'_>],
    ) -> Self {
        let few = |reach, with_rim: bool| {
            let maker = maker.reached(reach);
            let terrain = |fragment| maker.make(module, ["vertex", fragment], buffers, SOLID);
            Few {
                plain: Some(terrain("fragment")),
                rim: with_rim.then(|| terrain("fragment_rim")),
            }
        };
        let is_low = maker.shadows == ShadowQuality::Low;
        Self {
            all: Set::made_by(maker, module, buffers),
            // Only closed worlds have much land that no map shows, and an equator at hand.
            land: if is_low {
                few(ShadowReach::Land, maker.is_closed())
            } else {
                Few::default()
            },
            nothing: if is_low && maker.is_closed() {
                few(ShadowReach::Nothing, true)
            } else {
                Few::default()
            },
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
        if way < FEW {
            WAYS * reach as u8 + way
        } else {
            way
        }
    }

    /// The pipeline of a number; that for all shadows where there is none of its own.
    pub fn numbered(&self, number: u8) -> &RenderPipeline {
        let few = match number / WAYS {
            1 => Some(&self.land),
            2 => Some(&self.nothing),
            _ => None,
        };
        let (all, way) = (&self.all, number % WAYS);
        let own = few.and_then(|few| match way {
            0 => few.plain.as_ref(),
            _ => few.rim.as_ref(),
        });
        own.unwrap_or(match way {
            0 => &all.plain,
            1 => &all.rim,
            2 => &all.deep,
            3 => &all.deep_rim,
            4 => &all.framed,
            5 => &all.blending,
            6 => &all.deep_blending,
            _ => &all.framed_blending,
        })
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
