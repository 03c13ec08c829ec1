//! What the terrain tests share: spaces, fields, and a world of edits held in memory.
use std::collections::HashMap;
use std::sync::Arc;

use antipode_geometry::{ChartId, ChunkCoord, Geometry, Strategy, strategy};
use antipode_terrain::{ChunkEdits, Field, Generator, Level, Samples, Stroke, apply_edits};
use glam::IVec3;

/// Radius of the tests' spherical world, metres.
pub const SPHERE_RADIUS_M: f64 = 32.0;

pub fn flat() -> Arc<dyn Strategy> {
    strategy(Geometry::Euclidean, 20.0)
}

pub fn sphere() -> Arc<dyn Strategy> {
    strategy(Geometry::Spherical, SPHERE_RADIUS_M)
}

pub fn chunk(chart: ChartId, x: i32, y: i32, z: i32) -> ChunkCoord {
    ChunkCoord {
        chart,
        index: IVec3::new(x, y, z),
    }
}

/// Numbers in 0..1 from a linear congruential generator (Knuth's MMIX constants).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// A world's ground with edits, rough as that of one biome is.
pub struct World {
    pub field: Field,
    pub edits: HashMap<ChunkCoord, Arc<ChunkEdits>>,
    untouched: HashMap<ChunkCoord, Samples>,
}

impl World {
    pub fn new(seed: u64, strategy: Arc<dyn Strategy>) -> Self {
        Self::made_by(Generator::OneBiome, seed, strategy)
    }

    pub fn made_by(generator: Generator, seed: u64, strategy: Arc<dyn Strategy>) -> Self {
        Self {
            field: Field::made_by(generator, seed, strategy),
            edits: HashMap::new(),
            untouched: HashMap::new(),
        }
    }

    pub fn apply(&mut self, stroke: &Stroke) {
        let strategy = Arc::clone(self.field.strategy());
        for coord in stroke.touched(&*strategy) {
            let edits = self.edits.entry(coord).or_default();
            stroke.apply(coord, Arc::make_mut(edits), &*strategy);
        }
    }

    pub fn samples(&mut self, coord: ChunkCoord) -> Samples {
        let untouched = self
            .untouched
            .entry(coord)
            .or_insert_with(|| self.field.samples(coord));
        let mut samples = untouched.clone();
        apply_edits(&mut samples, coord, |owner| self.edits.get(&owner).cloned());
        samples
    }

    pub fn samples_at(&self, coord: ChunkCoord, level: Level) -> Samples {
        let mut samples = self.field.samples_at(coord, level);
        apply_edits(&mut samples, coord, |owner| self.edits.get(&owner).cloned());
        samples
    }
}
