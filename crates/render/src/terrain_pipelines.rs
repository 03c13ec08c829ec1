//! The ways of drawing land, and their numbers.

use wgpu::{RenderPipeline, ShaderModule, VertexBufferLayout};

use crate::pipelines::{Maker, SOLID};
use crate::plan::{ChunkChoice, DepthMethod, Port};
use crate::renderer::Preset;
use crate::shadow::ShadowQuality;

/// Leaves closer to the eye than this may give way, metres; plants.wgsl.
const GIVES_WAY_M: f64 = 1.6;

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

/// The ways of drawing land: all of them for what any shadow may reach and any lamp light, and for the rest those that most of a
/// picture is drawn by: in software, which pays for branches that it does not take, all of [`Few`], and with a card what grows. Each takes a software adapter a
/// tenth of a second and some megabytes, so there are no more.
#[derive(Debug)]
pub struct TerrainPipelines {
    all: Set,
    /// By reach, lit and unlit.
    few: [[Few; 2]; REACHES],
}

/// Some of the ways, with less than all shadows or without lamps.
#[derive(Debug, Default)]
struct Few {
    plain: Option<RenderPipeline>,
    rim: Option<RenderPipeline>,
    plant: Option<RenderPipeline>,
    /// What grows far off, where nothing of what it is made of is seen: with a card. Software never shows that.
    far_plant: Option<RenderPipeline>,
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
    /// What grows on land, ported by vertex.
    plant: RenderPipeline,
    /// The same close to the eye, where leaves give way; software has none.
    close_plant: Option<RenderPipeline>,
    /// The same, each fragment with its own depth.
    deep_plant: RenderPipeline,
}

/// Ways of [`Few`], which come first, and the reaches that they come in.
const FEW: usize = 4;
const REACHES: usize = 3;

impl TerrainPipelines {
    pub(crate) fn made_by(
        maker: &Maker<'_>,
        module: &ShaderModule,
        buffers: &[VertexBufferLayout<'_>],
    ) -> Self {
        let is_low = maker.shadows == ShadowQuality::Low;
        let is_round = maker.map.daylight.is_round;
        let terrain = |maker: &Maker<'_>, [vertex, fragment]: [&str; 2]| {
            maker.make(module, [vertex, fragment], buffers, SOLID)
        };
        let plant = |maker: &Maker<'_>| terrain(maker, ["vertex_plant", "fragment_plant"]);
        let plants = |maker: &Maker<'_>| Few {
            plant: Some(plant(maker)),
            ..Few::default()
        };
        let few = |maker: &Maker<'_>| Few {
            plain: Some(terrain(maker, ["vertex", "fragment"])),
            rim: is_round.then(|| terrain(maker, ["vertex", "fragment_rim"])),
            ..plants(maker)
        };
        let reached = |reach| {
            let is_told_apart = match reach {
                // With a card what grows is asked about as if figures threw nothing on it.
                ShadowReach::All => !is_low || maker.preset == Preset::Software,
                ShadowReach::Land => is_low,
                ShadowReach::Nothing => is_low && is_round,
            };
            if !is_told_apart {
                return <[Few; 2]>::default();
            }
            let maker = maker.reached(reach);
            let lit = if reach == ShadowReach::All {
                Few::default()
            } else {
                few(&maker)
            };
            let unlit = maker.unlit();
            let unlit = match maker.preset {
                // A card's driver takes a second for what draws land.
                Preset::Card => Few {
                    far_plant: Some(plant(&unlit.far())),
                    ..plants(&unlit)
                },
                // The light of a closed world costs so much that lamps matter less.
                Preset::Software if is_round => Few::default(),
                Preset::Software => few(&unlit),
            };
            [lit, unlit]
        };
        Self {
            all: Set::made_by(maker, module, buffers),
            few: [ShadowReach::All, ShadowReach::Land, ShadowReach::Nothing].map(reached),
        }
    }

    /// The number of the pipeline of a choice, where `blends` says that only some of the pixels are drawn and `lights` which
    /// lamps and beams may light it. What mostly hides the rest has lower numbers.
    pub fn number(choice: &ChunkChoice, blends: bool, reach: ShadowReach, lights: [u32; 3]) -> u8 {
        let deep = choice.depth == DepthMethod::Fragment;
        let way = match (&choice.port, deep, choice.trimmed, blends) {
            (Port::Vertex, false, false, false) => 2,
            (Port::Vertex, false, true, false) => 3,
            (Port::Vertex, true, false, false) => 4,
            (Port::Vertex, true, true, false) => 5,
            (Port::Frame(_), .., false) => 6,
            (Port::Vertex, false, _, true) => 7,
            (Port::Vertex, true, _, true) => 8,
            (Port::Frame(_), .., true) => 9,
        };
        Self::number_of(way, reach, lights)
    }

    /// The same of what grows on the land of a choice. Only what may be close to the eye has leaves that give way, as a shader
    /// that may discard a fragment is run for those, too, that are hidden. `is_far` says that it is
    /// all so far off that what it is made of is not seen.
    pub fn number_of_plants(
        choice: &ChunkChoice,
        preset: Preset,
        is_far: bool,
        reach: ShadowReach,
        lights: [u32; 3],
    ) -> u8 {
        let by_pixel = preset == Preset::Card;
        let way = match choice.depth {
            DepthMethod::Fragment => 10,
            DepthMethod::Vertex if by_pixel && choice.distance_m < GIVES_WAY_M => 11,
            DepthMethod::Vertex if by_pixel && is_far => 1,
            DepthMethod::Vertex => 0,
        };
        Self::number_of(way, reach, lights)
    }

    fn number_of(way: usize, reach: ShadowReach, lights: [u32; 3]) -> u8 {
        // What comes in several reaches, lit and unlit, has its numbers side by side, before all others.
        let number = if way < FEW {
            2 * (REACHES * way + reach as usize) + usize::from(lights == [0; 3])
        } else {
            2 * REACHES * FEW + way - FEW
        };
        number as u8
    }

    /// The pipeline of a number; that for all shadows and lamps where there is none of its own.
    pub fn numbered(&self, number: u8) -> &RenderPipeline {
        let all = &self.all;
        let number = usize::from(number);
        let (way, reach, dark) = (number / 2 / REACHES, number / 2 % REACHES, number % 2);
        let own = |of: fn(&Few) -> Option<&RenderPipeline>| {
            let [lit, unlit] = &self.few[reach];
            let unlit = of(unlit).filter(|_| dark == 1);
            unlit.or_else(|| of(lit))
        };
        match (way, number - number.min(2 * REACHES * FEW)) {
            (0, _) => own(|few| few.plant.as_ref()).unwrap_or(&all.plant),
            (1, _) => own(|few| few.far_plant.as_ref())
                .or_else(|| own(|few| few.plant.as_ref()))
                .unwrap_or(&all.plant),
            (2, _) => own(|few| few.plain.as_ref()).unwrap_or(&all.plain),
            (3, _) => own(|few| few.rim.as_ref()).unwrap_or(&all.rim),
            (_, 0) => &all.deep,
            (_, 1) => &all.deep_rim,
            (_, 2) => &all.framed,
            (_, 3) => &all.blending,
            (_, 4) => &all.deep_blending,
            (_, 5) => &all.framed_blending,
            (_, 6) => &all.deep_plant,
            _ => all.close_plant.as_ref().unwrap_or(&all.plant),
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
        let has_close = maker.preset == Preset::Card;
        Self {
            plain: terrain("vertex", "fragment"),
            rim: terrain("vertex", "fragment_rim"),
            deep: terrain("vertex", "fragment_deep"),
            deep_rim: terrain("vertex", "fragment_deep_rim"),
            framed: terrain("vertex_framed", "fragment"),
            blending: terrain("vertex", "fragment_blending"),
            deep_blending: terrain("vertex", "fragment_deep_blending"),
            framed_blending: terrain("vertex_framed", "fragment_blending"),
            plant: terrain("vertex_plant", "fragment_plant"),
            close_plant: has_close.then(|| terrain("vertex_plant", "fragment_close_plant")),
            deep_plant: terrain("vertex_plant", "fragment_deep_plant"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DARK: [u32; 3] = [0; 3];
    const LIT: [u32; 3] = [0, 1, 0];

    fn of_plants(distance_m: f64, preset: Preset, is_far: bool, lights: [u32; 3]) -> u8 {
        let choice = ChunkChoice {
            distance_m,
            ..ChunkChoice::LOOSE
        };
        TerrainPipelines::number_of_plants(&choice, preset, is_far, ShadowReach::All, lights)
    }

    #[test]
    fn what_is_drawn_differently_has_numbers_of_its_own() {
        let land =
            |lights| TerrainPipelines::number(&ChunkChoice::LOOSE, false, ShadowReach::All, lights);
        let card = |distance_m, is_far, lights| of_plants(distance_m, Preset::Card, is_far, lights);
        let mut numbers = vec![land(DARK), land(LIT)];
        for lights in [DARK, LIT] {
            numbers.push(card(90.0, false, lights));
            numbers.push(card(300.0, true, lights));
        }
        numbers.push(card(1.0, false, DARK));
        numbers.sort_unstable();
        let all = numbers.len();
        numbers.dedup();
        assert_eq!(numbers.len(), all);
    }

    #[test]
    fn in_software_far_plants_are_drawn_as_all_others() {
        let software = |distance_m, is_far| of_plants(distance_m, Preset::Software, is_far, DARK);
        assert_eq!(software(300.0, true), software(1.0, false));
    }
}
