//! What may throw a shadow: boxes of charts.

use antipode_geometry::ChartId;
use glam::DVec3;

use crate::plan::ChunkLand;

/// A box of the chart that may throw a shadow.
#[derive(Clone, Copy, Debug)]
pub struct Caster {
    /// Its chart.
    pub chart: ChartId,
    /// Lowest corner, metres.
    pub min: DVec3,
    /// Highest corner, metres.
    pub max: DVec3,
}

impl Caster {
    /// What lies between two corners of a chart, metres.
    pub fn new(chart: ChartId, min: DVec3, max: DVec3) -> Self {
        Self { chart, min, max }
    }

    /// Its middle, metres.
    pub fn middle(&self) -> DVec3 {
        0.5 * (self.min + self.max)
    }

    /// How far it reaches from there along each axis, metres.
    pub fn reach(&self) -> DVec3 {
        0.5 * (self.max - self.min)
    }

    /// All of a chunk's land, and what stands on it.
    pub fn of(land: &ChunkLand) -> Self {
        Self {
            chart: land.coord.chart,
            min: land.whole[0],
            max: land.whole[1],
        }
    }
}
