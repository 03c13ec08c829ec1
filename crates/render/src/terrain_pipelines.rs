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

/// Ways of [`Few`], which come first, and the reaches that they come in.
const FEW: u8 = 2;
const REACHES: u8 = 3;

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
        let is_round = maker.map.daylight.is_round;
        Self {
            all: Set::made_by(maker, module, buffers),
            land: if is_low {
                few(ShadowReach::Land, is_round)
            } else {
                Few::default()
            },
            nothing: if is_low && is_round {
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
        // What comes in several reaches has its numbers side by side, before all others.
        if way < FEW {
            REACHES * way + reach as u8
        } else {
            REACHES * FEW + way - FEW
        }
    }

    /// The pipeline of a number; that for all shadows where there is none of its own.
    pub fn numbered(&self, number: u8) -> &RenderPipeline {
        let all = &self.all;
        let (own, whole) = match number {
            0 => (None, &all.plain),
            1 => (self.land.plain.as_ref(), &all.plain),
            2 => (self.nothing.plain.as_ref(), &all.plain),
            3 => (None, &all.rim),
            4 => (self.land.rim.as_ref(), &all.rim),
            5 => (self.nothing.rim.as_ref(), &all.rim),
            6 => (None, &all.deep),
            7 => (None, &all.deep_rim),
            8 => (None, &all.framed),
            9 => (None, &all.blending),
            10 => (None, &all.deep_blending),
            _ => (None, &all.framed_blending),
        };
        own.unwrap_or(whole)
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
