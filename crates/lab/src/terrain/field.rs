//! The field: nanoseconds a sample beside noise libraries, and how quickly and how often a chunk without a surface is
//! told from its bounds.

use antipode_geometry::{ChartId, ChunkCoord, Geometry};
use antipode_terrain::{Content, Field, Generator, SAMPLES};
use glam::IVec3;

use super::clock::{Rival, race};
use super::engine::{SEED, field, name, space, surface_chunk};
use super::row::{Bar, Judged, Row, table};
use super::versus::{Least, versus};
use crate::{Effort, SPACES, Section};

/// Samples of a chunk's block.
const BLOCK: usize = SAMPLES * SAMPLES * SAMPLES;
/// Most nanoseconds a sample.
const SAMPLE_NS: f64 = 30.0;
/// Most microseconds to decide what a chunk can hold.
const CONTENT_US: f64 = 10.0;
/// Least share of the chunks without a surface that the bounds tell, percent.
const TOLD: f64 = 90.0;
/// Times that a library must take of ours, on flat land and on the sphere, by the beginning of its name. On the
/// sphere no two samples lie along an axis of the noise, and each place has to be found first.
const LEAST: [Least<'_>; 2] = [("noise 0.9", &[5.0, 3.0]), ("fastnoise-lite", &[5.0, 2.0])];

/// The section of the field's figures.
pub fn field_section(effort: Effort) -> Section {
    let [flat, sphere] = [Geometry::Euclidean, Geometry::Spherical].map(|geometry| {
        let (_, coord) = surface_chunk(geometry);
        let octaves = Field::made_by(Generator::OneBiome, SEED, space(geometry));
        (octaves, coord)
    });
    let mut rivals = vec![
        Rival::new("ours, Euclidean", BLOCK, || flat.0.samples(flat.1)),
        Rival::new("ours, spherical", BLOCK, || sphere.0.samples(sphere.1)),
    ];
    #[cfg(feature = "rivals")]
    rivals.extend(super::rivals::noises());
    let ns = race(&mut rivals, effort);
    let [varied, closed] = [Geometry::Euclidean, Geometry::Spherical].map(surface_chunk);
    let mut worlds = [
        Rival::new("", BLOCK, || varied.0.samples(varied.1)),
        Rival::new("", BLOCK, || closed.0.samples(closed.1)),
    ];
    let worlds_ns = race(&mut worlds, effort);
    let bar = |case: &str, ns: f64| {
        Row::new("field sample", case, ns, "ns").bar(Bar::AtMost(SAMPLE_NS), Judged::InFull)
    };
    let mut rows = vec![
        bar("Euclidean surface chunk", worlds_ns[0]),
        bar("spherical surface chunk", worlds_ns[1]),
        bar("the same of four octaves", ns[0]),
        bar("the same of four octaves, spherical", ns[1]),
    ];
    for geometry in SPACES {
        rows.extend(content_rows(geometry, effort));
    }
    Section::new(
        "terrain-field",
        "The field",
        METHOD,
        [
            table("Samples and decisions", &rows, effort),
            versus("Fractal noise, a sample", &rivals, &ns, 2, &LEAST),
        ],
    )
}

/// Chunks around the middle of the world, high above the ground to deep below it.
fn around(geometry: Geometry, effort: Effort) -> Vec<ChunkCoord> {
    let (wide, high) = if effort.quick { (1, 3) } else { (3, 4) };
    let mut found = Vec::new();
    for x in -wide..=wide {
        for y in -high..=high {
            for z in -wide..=wide {
                let coord = ChunkCoord::new(ChartId::FIRST, IVec3::new(x, y, z));
                if antipode_streaming::is_in_world(&*space(geometry), coord) {
                    found.push(coord);
                }
            }
        }
    }
    found
}

fn content_rows(geometry: Geometry, effort: Effort) -> [Row; 2] {
    let field = field(geometry);
    let chunks = around(geometry, effort);
    let decide = || {
        let told = chunks.iter().map(|&coord| field.content(coord));
        told.filter(|content| *content == Content::Surface).count()
    };
    let ns = race(&mut [Rival::new("", chunks.len(), decide)], effort);
    let bare: Vec<ChunkCoord> = chunks
        .iter()
        .copied()
        .filter(|&coord| !has_surface(&field, coord))
        .collect();
    let told = bare
        .iter()
        .filter(|&&coord| field.content(coord) != Content::Surface)
        .count();
    let share = (!bare.is_empty()).then(|| 100.0 * told as f64 / bare.len() as f64);
    let case = format!("{}, {} chunks", name(geometry), chunks.len());
    [
        Row::new("content of a chunk decided", &case, ns[0] * 1e-3, "us")
            .bar(Bar::AtMost(CONTENT_US), Judged::InFull),
        Row::new("chunks without a surface that are told", &case, share, "%")
            .bar(Bar::AtLeast(TOLD), Judged::InFull)
            .note(format!("{told} of {}", bare.len())),
    ]
}

/// Whether the block of a chunk has both ground and air.
fn has_surface(field: &Field, coord: ChunkCoord) -> bool {
    let samples = field.samples(coord);
    let solid = samples
        .values()
        .iter()
        .filter(|value| **value < 0.0)
        .count();
    solid > 0 && solid < samples.values().len()
}

const METHOD: [&str; 3] = [
    "A block of 35 by 35 by 35 samples whose surface runs through it: of a new world, with climates and caves, and beside the rivals of a volcanic one of generator 1, which is four octaves of noise. Every rival fills a block of that size with four octaves of its own noise; all take turns, and the least of each is shown, which is the run that nothing else on the machine struck.",
    "The libraries are called as their documentation says: point by point where they know nothing else, a whole block at once where they do (simdnoise, which has no gradient noise of Perlin's kind and is shown with its simplex noise, in the widest instructions that the machine has). Ours also shapes the noise to heights, holds it to a band and finds where the space puts each sample.",
    "A chunk has no surface where all samples of its block are ground or all are air, found by sampling. Those that the bounds tell cost nothing more.",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_chunk_with_a_surface_is_called_bare() {
        for geometry in SPACES {
            let field = field(geometry);
            for coord in around(geometry, Effort { quick: true }) {
                let surface = has_surface(&field, coord);
                assert!(
                    !surface || field.content(coord) == Content::Surface,
                    "{geometry:?} {coord:?}"
                );
            }
        }
    }
}
